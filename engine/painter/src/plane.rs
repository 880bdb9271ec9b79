//! Floors and walls: endless planes that fade away from the middle of the stage, with lines at even distances.

use glam::{DVec3, Vec3};

use super::Camera;

/// A plane.
pub struct Plane {
    /// The point of it around which it is seen; lines go through it.
    pub middle: DVec3,
    /// Unit vectors: two in the plane, and its normal.
    pub axes: [Vec3; 3],
    /// Linear RGB.
    pub colour: Vec3,
    /// Linear RGB of the lines.
    pub line: Vec3,
    /// Distance between lines; 0 for none.
    pub spacing: f32,
    /// Where it has faded away.
    pub radius: f32,
}

/// Where a ray meets a plane.
pub(super) struct Hit {
    /// From the eye.
    pub(super) point: Vec3,
    /// How much of it is there, 0 to 1.
    pub(super) opacity: f32,
    /// Linear RGB.
    pub(super) colour: Vec3,
}

impl Plane {
    /// Where it is seen at a point of the picture [pixels], as depth along the camera's axis; None from behind, above
    /// the horizon and outside.
    pub(super) fn depth(&self, camera: &Camera, x: f32, y: f32) -> Option<f32> {
        let offset = self.offset(camera);
        let (height, ray) = (-self.axes[2].dot(offset), camera.ray(x, y));
        let depth = -height / self.axes[2].dot(ray);
        let in_front = height > 0.0 && depth > camera.near && depth.is_finite();
        let near = || (ray * depth - offset).length_squared() < self.radius * self.radius;
        (in_front && near()).then_some(depth)
    }

    /// What is seen of it there.
    pub(super) fn hit(&self, camera: &Camera, x: f32, y: f32, depth: f32) -> Hit {
        let offset = self.offset(camera);
        let height = -self.axes[2].dot(offset);
        let meet = |x: f32, y: f32| {
            let ray = camera.ray(x, y);
            ray * (-height / self.axes[2].dot(ray))
        };
        let point = camera.ray(x, y) * depth;
        let from_middle = point - offset;
        let away = from_middle.length() / self.radius;
        let (right, below) = (meet(x + 1.0, y) - point, meet(x, y + 1.0) - point);
        let covered = self.covered(self.axes[0], from_middle, right, below)
            + self.covered(self.axes[1], from_middle, right, below);
        Hit {
            point,
            opacity: fade((away - SOLID) / (1.0 - SOLID)),
            colour: self.colour.lerp(self.line, covered.min(1.0)),
        }
    }

    fn offset(&self, camera: &Camera) -> Vec3 {
        (self.middle - camera.eye).as_vec3()
    }

    /// The share of a pixel that the lines across an axis cover: the lines' part of the interval that the pixel
    /// spans on that axis.
    fn covered(&self, axis: Vec3, from_middle: Vec3, right: Vec3, below: Vec3) -> f32 {
        if self.spacing <= 0.0 {
            return 0.0;
        }
        let wide = (axis.dot(right).abs() + axis.dot(below).abs()) / self.spacing;
        if !wide.is_finite() || wide <= 0.0 {
            return 0.0;
        }
        let at = axis.dot(from_middle) / self.spacing;
        let half = (0.5 * wide).max(LINE); // a line is a pixel wide, or LINE of the spacing
        let sum = |x: f32| {
            let whole = (x + 0.5).floor();
            whole * 2.0 * half.min(0.5) + ((x - whole).clamp(-half, half) + half).min(1.0)
        };
        let lines = (sum(at + 0.5 * wide) - sum(at - 0.5 * wide)) / wide;
        lines.clamp(0.0, 1.0) * (1.0 - wide * 2.0).clamp(0.0, 1.0)
    }
}

/// Up to this part of its radius nothing has faded.
const SOLID: f32 = 0.35;
/// Half the width of a line over the distance between lines.
const LINE: f32 = 0.006;

/// 1 up to 0, 0 from 1 on, smooth between (smoothstep).
fn fade(x: f32) -> f32 {
    let x = x.clamp(0.0, 1.0);
    1.0 - x * x * (3.0 - 2.0 * x)
}
