//! Lights that are infinitely far away, each with a map of what is nearest to it.

use glam::Vec3;

use super::raster::{spans, Corner};
use super::{Finish, Picture, Placed};

/// A shadow starts this many texels in front of what casts it: less, and surfaces shade themselves.
const CLEARANCE: f32 = 1.2;

/// Texels along a side of a block.
const BLOCK: usize = 16;

/// A light from one direction.
pub struct Light {
    /// Unit vector towards it.
    pub direction: Vec3,
    /// Linear RGB that a white surface facing it sends back.
    pub strength: Vec3,
    /// Texels along a side of its map; 0 for a light without shadows.
    pub texels: usize,
    /// Width of the rim of a shadow [texels].
    pub softness: usize,
    /// Strength of its reflection in a surface; 0 for a part of the sky, which is taken once for 2 x 2 pixels.
    pub gloss: f32,
}

/// How near to the light the nearest solid is, over a square across its direction.
pub(super) struct Map {
    axes: [Vec3; 3],
    corner: [f32; 2],
    texels: usize,
    per_metre: f32,
    softness: usize,
    near: Vec<f32>,
    /// The nearest of each block of texels: most points have nothing near their way to the light.
    blocks: Vec<f32>,
}

impl Light {
    /// What stands in this light, within the picture's stage.
    #[allow(clippy::cast_precision_loss)]
    pub(super) fn map(&self, picture: &Picture, placed: &[Placed]) -> Option<Map> {
        if self.texels == 0 {
            return None;
        }
        let across = self.direction.any_orthonormal_vector();
        let axes = [across, self.direction.cross(across), self.direction];
        let (middle, radius) = picture.stage;
        let middle = (middle - picture.camera.eye).as_vec3();
        #[allow(clippy::cast_possible_truncation)]
        let radius = radius as f32;
        let mut map = Map {
            axes,
            corner: [axes[0].dot(middle) - radius, axes[1].dot(middle) - radius],
            texels: self.texels,
            per_metre: self.texels as f32 / (2.0 * radius),
            softness: self.softness,
            near: vec![f32::NEG_INFINITY; self.texels * self.texels],
            blocks: Vec::new(),
        };
        for (thing, place) in picture.things.iter().zip(placed) {
            if thing.finish != Finish::Sign {
                map.draw(
                    &place.vertices,
                    &picture.meshes[thing.mesh].triangles,
                    thing.closed,
                );
            }
        }
        map.blocks = map.nearest_of_blocks();
        Some(map)
    }
}

impl Map {
    fn corner(&self, point: Vec3) -> Corner {
        Corner {
            x: (self.axes[0].dot(point) - self.corner[0]) * self.per_metre,
            y: (self.axes[1].dot(point) - self.corner[1]) * self.per_metre,
            near: self.axes[2].dot(point),
        }
    }

    fn draw(&mut self, vertices: &[Vec3], triangles: &[[u32; 3]], closed: bool) {
        let corners: Vec<Corner> = vertices.iter().map(|&v| self.corner(v)).collect();
        let (texels, near) = (self.texels, &mut self.near);
        for triangle in triangles {
            let [a, b, c] = triangle.map(|k| corners[k as usize]);
            if closed && (b.x - a.x) * (c.y - a.y) < (b.y - a.y) * (c.x - a.x) {
                continue; // seen from behind
            }
            spans(
                &[a, b, c],
                &(0..texels),
                texels,
                |row, columns, mut depth, per_column| {
                    let start = row * texels;
                    for old in &mut near[start + columns.start..start + columns.end] {
                        *old = old.max(depth);
                        depth += per_column;
                    }
                },
            );
        }
    }

    fn nearest_of_blocks(&self) -> Vec<f32> {
        let side = self.texels.div_ceil(BLOCK);
        let mut blocks = vec![f32::NEG_INFINITY; side * side];
        for (row, line) in self.near.chunks_exact(self.texels).enumerate() {
            for (number, part) in line.chunks(BLOCK).enumerate() {
                let nearest = part.iter().copied().fold(f32::NEG_INFINITY, f32::max);
                let block = &mut blocks[row / BLOCK * side + number];
                *block = block.max(nearest);
            }
        }
        blocks
    }

    /// Whether nothing in the square of texels from (column, row) is nearer to the light than `near`.
    fn open(&self, column: usize, row: usize, near: f32) -> bool {
        let side = self.texels.div_ceil(BLOCK);
        (row / BLOCK..=(row + self.softness) / BLOCK).all(|y| {
            let line = y * side + column / BLOCK..=y * side + (column + self.softness) / BLOCK;
            self.blocks[line].iter().all(|&block| block <= near)
        })
    }

    /// The share of the light that reaches a point with this unit normal: 1 outside of the map.
    ///
    /// Percentage-closer filtering over a square of `softness` texels (Reeves, Salesin, Cook 1987, section 3).
    #[allow(
        clippy::cast_precision_loss,
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss
    )]
    pub(super) fn share(&self, point: Vec3, normal: Vec3) -> f32 {
        let clearance = (CLEARANCE + 0.5 * self.softness as f32) / self.per_metre;
        let at = self.corner(point + normal * clearance);
        let wide = self.softness;
        let (x, y) = (at.x - wide as f32 / 2.0, at.y - wide as f32 / 2.0);
        let end = (self.texels - wide - 1) as f32;
        if !(x >= 0.0 && y >= 0.0 && x < end && y < end) {
            return 1.0;
        }
        let (column, row) = (x as usize, y as usize);
        if self.open(column, row, at.near) {
            return 1.0;
        }
        let weight = |k: usize, part: f32| match k {
            0 => 1.0 - part,
            k if k == wide => part,
            _ => 1.0,
        };
        let (right, down) = (x.fract(), y.fract());
        let mut lit = 0.0;
        for k in 0..=wide {
            let start = (row + k) * self.texels + column;
            let line = &self.near[start..=start + wide];
            let mut sum = 0.0;
            for (j, &near) in line.iter().enumerate() {
                if near <= at.near {
                    sum += weight(j, right);
                }
            }
            lit += sum * weight(k, down);
        }
        lit / (wide * wide) as f32
    }
}
