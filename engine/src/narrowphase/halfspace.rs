//! Anything against a half-space: the direction is known, only the feature nearest to the plane is wanted.

use super::{features, reduce, Posed, Scratch, Sink};
use crate::shape::{Pose, Shape};

/// Points of `a` nearest to the plane; the gap of a point p is n . (p - o) with the half-space's normal n = its z axis
/// and a point o of its plane.
pub(crate) fn collide(a: &Posed, plane: &Pose, scratch: &mut Scratch, sink: &mut Sink) {
    let normal = plane.rotation.z_axis;
    let start = sink.out.len();
    nearest(a, plane, scratch);
    for p in &scratch.feature_a {
        let gap = normal.dot(*p - plane.position);
        sink.push(*p - 0.5 * gap * normal, normal, -gap);
    }
    reduce::spread(sink.out, start, 8, 0.0, &mut scratch.kept);
}

/// All vertices for a hull (a coin-shaped facet polygon may bend by more than the margin), the facing feature otherwise.
fn nearest(a: &Posed, plane: &Pose, scratch: &mut Scratch) {
    let points = &mut scratch.feature_a;
    match a.shape {
        Shape::Hull(hull) => {
            points.clear();
            points.extend(hull.vertices().iter().map(|v| a.pose.point(*v)));
        }
        Shape::HalfSpace | Shape::Mesh(_) => points.clear(),
        _ => features::facing(a, -plane.rotation.z_axis, &mut scratch.heights, points),
    }
}
