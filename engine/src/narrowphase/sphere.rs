//! Sphere against a solid: the point of the solid nearest to the centre decides.

use super::closest::closest;
use super::{Posed, Sink};
use crate::shape::Pose;

/// With signed distance D of the centre c from the solid's surface and outward normal n there: gap = D - r. The
/// surfaces meet the line c - D n at distances D (solid) and r (sphere) from c, hence midway at (D + r) / 2.
pub(crate) fn collide(radius: f64, pose: &Pose, solid: &Posed, sink: &mut Sink) {
    let center = pose.position;
    if let Some(nearest) = closest(solid.shape, solid.pose.inverse_point(center)) {
        let normal = solid.pose.direction(nearest.normal);
        let depth = radius - nearest.distance;
        sink.push(
            center - 0.5 * (nearest.distance + radius) * normal,
            normal,
            depth,
        );
    }
}
