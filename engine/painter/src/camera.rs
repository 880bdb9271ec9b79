//! Where the picture is taken from: a pinhole with square pixels.

use glam::{DVec3, Vec3};

use super::raster::{Corner, Face};

/// A pinhole camera.
pub struct Camera {
    /// Where it stands, in the world.
    pub eye: DVec3,
    /// Unit vectors to the right of the picture, up in it, and into it.
    pub axes: [Vec3; 3],
    /// Focal length over half the height of the picture: 1 / tan(half the angle of view).
    pub focus: f32,
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// What is nearer than this is not drawn.
    pub near: f32,
}

impl Camera {
    /// Focal length in pixels.
    #[allow(clippy::cast_precision_loss)]
    fn focal(&self) -> f32 {
        self.focus * self.height as f32 / 2.0
    }

    /// The direction through a point of the picture, in pixels from its upper left corner; its part along the
    /// camera's axis is 1.
    #[allow(clippy::cast_precision_loss)]
    pub(super) fn ray(&self, x: f32, y: f32) -> Vec3 {
        let [right, up, forward] = self.axes;
        let (across, down) = (x - self.width as f32 / 2.0, y - self.height as f32 / 2.0);
        forward + (right * across - up * down) / self.focal()
    }

    /// Along the camera's axes, of a point seen from the eye.
    fn seen(&self, point: Vec3) -> Vec3 {
        let [right, up, forward] = self.axes;
        Vec3::new(right.dot(point), up.dot(point), forward.dot(point))
    }

    /// Where a point (along the camera's axes, in front of it) falls, in samples.
    #[allow(clippy::cast_precision_loss)]
    fn corner(&self, seen: Vec3, samples: usize) -> Corner {
        let scale = self.focal() / seen.z;
        Corner {
            x: (self.width as f32 / 2.0 + scale * seen.x) * samples as f32,
            y: (self.height as f32 / 2.0 - scale * seen.y) * samples as f32,
            near: 1.0 / seen.z,
        }
    }

    /// Appends the triangles of a thing (number, whether closed) that are in the picture.
    #[allow(clippy::cast_possible_truncation)] // memory ends before u32 does
    pub(super) fn project(
        &self,
        (thing, closed): (usize, bool),
        vertices: &[Vec3],
        triangles: &[[u32; 3]],
        samples: usize,
        faces: &mut Vec<Face>,
    ) {
        let seen: Vec<Vec3> = vertices.iter().map(|&v| self.seen(v)).collect();
        let size = (self.width * samples, self.height * samples);
        for (number, triangle) in triangles.iter().enumerate() {
            let corners = triangle.map(|k| seen[k as usize]);
            let away = corners[0].dot((corners[1] - corners[0]).cross(corners[2] - corners[0]));
            if closed && away <= 0.0 {
                continue; // a mirrored frame: (right, up, forward) is left-handed
            }
            for part in self.in_front(corners) {
                let face = Face {
                    corners: part.map(|p| self.corner(p, samples)),
                    thing: thing as u32,
                    triangle: number as u32,
                };
                if face.within(size) {
                    faces.push(face);
                }
            }
        }
    }

    /// The part of a triangle beyond the near plane, as triangles.
    fn in_front(&self, corners: [Vec3; 3]) -> impl Iterator<Item = [Vec3; 3]> {
        let mut kept = [Vec3::ZERO; 4];
        let mut count = 0;
        for k in 0..3 {
            let (a, b) = (corners[k], corners[(k + 1) % 3]);
            if a.z >= self.near {
                kept[count] = a;
                count += 1;
            }
            if (a.z >= self.near) != (b.z >= self.near) {
                kept[count] = a + (b - a) * ((self.near - a.z) / (b.z - a.z));
                count += 1;
            }
        }
        (2..count).map(move |k| [kept[0], kept[k - 1], kept[k]])
    }
}
