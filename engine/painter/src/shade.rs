//! The colour of a pixel.

use glam::{Vec2, Vec3};

use super::light::{Light, Map};
use super::raster::{Buffers, Face, Seen, NOTHING};
use super::{Finish, Picture, Placed};

/// Samples along each side of a pixel, at most.
pub const MOST_SAMPLES: usize = 4;
/// Faces of one thing whose normals are nearer than this (cosine) are shaded as one in a pixel.
const SMOOTH: f32 = 0.9;
/// What is left of a sign behind a solid.
const THROUGH: f32 = 0.45;
/// Normals nearer than this (cosine) have the same sky.
const SAME_SKY: f32 = 0.995;
/// The darker tone of what is quartered.
const DARK: f32 = 0.72;
/// Sharpness of reflections (Blinn 1977).
const SHININESS: i32 = 48;

/// All that shading asks for.
pub(super) struct Shader<'a> {
    picture: &'a Picture,
    placed: &'a [Placed],
    faces: &'a [Face],
    maps: Vec<Option<Map>>,
}

/// A point of a surface: whose it is, seen from the eye, its unit normal, its colour.
struct Spot {
    surface: usize,
    point: Vec3,
    normal: Vec3,
    colour: Vec3,
}

/// The light of the sky on a surface, kept for its neighbours: it changes slowly along a smooth one.
#[derive(Clone, Copy)]
pub(super) struct Sky {
    surface: usize,
    normal: Vec3,
    light: Vec3,
}

impl<'a> Shader<'a> {
    pub(super) fn new(
        picture: &'a Picture,
        placed: &'a [Placed],
        faces: &'a [Face],
        maps: Vec<Option<Map>>,
    ) -> Self {
        Self {
            picture,
            placed,
            faces,
            maps,
        }
    }

    /// The mean of what the samples of a pixel see; each surface is shaded once. sky: what the neighbours keep.
    #[allow(clippy::cast_precision_loss)]
    pub(super) fn pixel(
        &self,
        (column, row): (usize, usize),
        buffers: &Buffers,
        sky: &mut Option<Sky>,
    ) -> Vec3 {
        let n = self.picture.samples;
        let corner = Vec2::new(column as f32, row as f32);
        if let Some(seen) = buffers.only(column * n, row * n, n) {
            return self.colour(corner + 0.5, seen, sky);
        }
        let mut known: [Option<(Seen, Vec2, f32)>; MOST_SAMPLES * MOST_SAMPLES] =
            Default::default();
        let mut count = 0;
        for k in 0..n * n {
            let (i, j) = (k % n, k / n);
            let seen = buffers.sample(column * n + i, row * n + j);
            let at = Vec2::new(i as f32 + 0.5, j as f32 + 0.5) / n as f32;
            let same = known[..count]
                .iter_mut()
                .flatten()
                .find(|(other, ..)| self.alike(*other, seen));
            if let Some((_, sum, weight)) = same {
                *sum += at;
                *weight += 1.0;
            } else {
                known[count] = Some((seen, at, 1.0));
                count += 1;
            }
        }
        let light = known[..count].iter().flatten();
        light
            .map(|&(seen, sum, weight)| self.colour(corner + sum / weight, seen, sky) * weight)
            .sum::<Vec3>()
            / (n * n) as f32
    }

    /// Whether two samples see one smooth surface.
    fn alike(&self, a: Seen, b: Seen) -> bool {
        a == b
            || (a.hidden == b.hidden
                && self.smooth(a.solid, b.solid)
                && self.smooth(a.sign, b.sign))
    }

    fn smooth(&self, a: u32, b: u32) -> bool {
        if a == b {
            return true;
        }
        if a == NOTHING || b == NOTHING {
            return false;
        }
        let (a, b) = (&self.faces[a as usize], &self.faces[b as usize]);
        a.thing == b.thing && {
            let (m, n) = (self.across(a), self.across(b));
            m.dot(n) > SMOOTH * m.length() * n.length()
        }
    }

    /// The corners of a face, seen from the eye.
    fn corners(&self, face: &Face) -> [Vec3; 3] {
        let place = &self.placed[face.thing as usize];
        self.indices(face).map(|k| place.vertices[k as usize])
    }

    fn indices(&self, face: &Face) -> [u32; 3] {
        let thing = &self.picture.things[face.thing as usize];
        self.picture.meshes[thing.mesh].triangles[face.triangle as usize]
    }

    /// Across a face, of any length.
    fn across(&self, face: &Face) -> Vec3 {
        let [a, b, c] = self.corners(face);
        (b - a).cross(c - a)
    }

    /// Linear RGB of what is seen at a point of the picture [pixels].
    fn colour(&self, at: Vec2, seen: Seen, sky: &mut Option<Sky>) -> Vec3 {
        let ray = self.picture.camera.ray(at.x, at.y);
        let behind = self.solids(at, ray, seen.solid, sky);
        if seen.sign == NOTHING {
            return behind;
        }
        let spot = self.spot(seen.sign, ray);
        let facing = spot.normal.dot(ray.normalize()).abs();
        let sign = spot.colour * (0.55 + 0.45 * facing);
        behind.lerp(sign, if seen.hidden { THROUGH } else { 1.0 })
    }

    /// Linear RGB of solids, planes and background, the nearest in front.
    fn solids(&self, at: Vec2, ray: Vec3, face: u32, sky: &mut Option<Sky>) -> Vec3 {
        let (mut light, depth) = if face == NOTHING {
            (self.background(at.y), f32::INFINITY)
        } else {
            let spot = self.spot(face, ray);
            let depth = spot.point.dot(self.picture.camera.axes[2]);
            (self.lit(&spot, sky), depth)
        };
        let mut limit = depth;
        while let Some((number, depth)) = self.farthest_plane(at, limit) {
            limit = depth;
            let plane = &self.picture.planes[number];
            let hit = plane.hit(&self.picture.camera, at.x, at.y, depth);
            let spot = Spot {
                surface: self.placed.len() + number,
                point: hit.point,
                normal: plane.axes[2],
                colour: hit.colour,
            };
            light = light.lerp(self.lit(&spot, sky), hit.opacity);
        }
        light
    }

    /// The farthest plane that is nearer than `limit`: its number and depth.
    fn farthest_plane(&self, at: Vec2, limit: f32) -> Option<(usize, f32)> {
        let planes = self.picture.planes.iter().enumerate();
        planes
            .filter_map(|(k, plane)| Some((k, plane.depth(&self.picture.camera, at.x, at.y)?)))
            .filter(|&(_, depth)| depth < limit)
            .max_by(|(_, a), (_, b)| a.total_cmp(b))
    }

    #[allow(clippy::cast_precision_loss)]
    fn background(&self, y: f32) -> Vec3 {
        let [top, bottom] = self.picture.background;
        top.lerp(bottom, y / self.picture.camera.height as f32)
    }

    /// Where a ray from the eye meets a face, on the face's plane.
    ///
    /// Moeller and Trumbore, "Fast, Minimum Storage Ray-Triangle Intersection" (1997).
    fn spot(&self, face: u32, ray: Vec3) -> Spot {
        let face = &self.faces[face as usize];
        let thing = &self.picture.things[face.thing as usize];
        let mesh = &self.picture.meshes[thing.mesh];
        let [a, b, c] = self.corners(face);
        let (ab, ac) = (b - a, c - a);
        let p = ray.cross(ac);
        let scale = 1.0 / ab.dot(p);
        let (mut v, q) = (-a.dot(p) * scale, (-a).cross(ab));
        let (mut w, depth) = (ray.dot(q) * scale, ac.dot(q) * scale);
        if !(v.is_finite() && w.is_finite()) {
            (v, w) = (1.0 / 3.0, 1.0 / 3.0); // seen edge-on
        }
        let (v, w) = (v.clamp(0.0, 1.0), w.clamp(0.0, 1.0));
        let [i, j, k] = self.indices(face).map(|k| k as usize);
        let mixed = |of: &[Vec3]| of[i] * (1.0 - v - w) + of[j] * v + of[k] * w;
        let normal =
            (self.placed[face.thing as usize].turn * mixed(&mesh.normals)).normalize_or_zero();
        let outward = if normal.dot(ray) > 0.0 && !thing.closed {
            -normal
        } else {
            normal
        };
        let point = if depth.is_finite() { ray * depth } else { a };
        let colour = match thing.finish {
            Finish::Quartered => thing.colour * tone(mixed(&mesh.vertices)),
            Finish::Plain | Finish::Sign => thing.colour,
        };
        Spot {
            surface: face.thing as usize,
            point,
            normal: outward,
            colour,
        }
    }

    /// Linear RGB that a surface sends to the eye: every light by its cosine (Lambert), and its reflection.
    fn lit(&self, spot: &Spot, sky: &mut Option<Sky>) -> Vec3 {
        let to_eye = -spot.point.normalize_or_zero();
        let mut light = spot.colour * self.sky(spot, sky);
        for (lamp, map) in self.lamps().filter(|(lamp, _)| lamp.gloss > 0.0) {
            let share = reached(lamp, map.as_ref(), spot);
            let half = (lamp.direction + to_eye).normalize_or_zero();
            let shine = spot.normal.dot(half).max(0.0).powi(SHININESS);
            let cosine = spot.normal.dot(lamp.direction);
            light += lamp.strength * share * (spot.colour * cosine + lamp.gloss * shine);
        }
        light
    }

    /// What the lights without gloss send to a surface, taken once for a smooth surface in neighbouring pixels.
    fn sky(&self, spot: &Spot, kept: &mut Option<Sky>) -> Vec3 {
        if let Some(known) = kept {
            if known.surface == spot.surface && known.normal.dot(spot.normal) > SAME_SKY {
                return known.light;
            }
        }
        let lamps = self.lamps().filter(|(lamp, _)| lamp.gloss <= 0.0);
        let light = lamps
            .map(|(lamp, map)| {
                let cosine = spot.normal.dot(lamp.direction);
                lamp.strength * (cosine.max(0.0) * reached(lamp, map.as_ref(), spot))
            })
            .sum();
        *kept = Some(Sky {
            surface: spot.surface,
            normal: spot.normal,
            light,
        });
        light
    }

    fn lamps(&self) -> impl Iterator<Item = (&Light, &Option<Map>)> {
        self.picture.lights.iter().zip(&self.maps)
    }
}

/// The share of a light that reaches a point; none where the surface faces away.
fn reached(lamp: &Light, map: Option<&Map>, spot: &Spot) -> f32 {
    if spot.normal.dot(lamp.direction) <= 0.0 {
        return 0.0;
    }
    map.map_or(1.0, |map| map.share(spot.point, spot.normal))
}

/// Which of the two tones a point of the mesh has: quarters about z.
fn tone(point: Vec3) -> f32 {
    if point.x * point.y < 0.0 {
        DARK
    } else {
        1.0
    }
}
