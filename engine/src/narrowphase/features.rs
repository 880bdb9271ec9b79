//! What a convex shape shows in a direction: a point, a segment, or a convex polygon.
//!
//! A feature always contains the shape's support point in that direction, and everything else in it lies on the
//! surface, so that a generous choice (a face seen at an angle) does no harm: points too far away are dropped later.

use super::Posed;
use crate::shape::{Hull, Pose, Shape};
use glam::DVec3;

/// Points of the polygon that stands for a circular face.
const RING: usize = 8;
/// Tilt (sine) below which a circular face counts as level: its lowest point has no direction worth following.
const LEVEL: f64 = 1e-6;
/// Vertices this near to the farthest, as a share of the hull's size, belong to the supporting feature.
const SUPPORT_TOLERANCE: f64 = 1e-9;

/// Writes the feature that faces a unit direction (world) to `out`: 1, 2, or more points in the order of a polygon.
/// `heights` is working memory.
pub(crate) fn facing(a: &Posed, direction: DVec3, heights: &mut Vec<f64>, out: &mut Vec<DVec3>) {
    out.clear();
    let local = a.pose.inverse_direction(direction);
    match a.shape {
        Shape::Capsule {
            radius,
            half_height,
        } => capsule(*radius, *half_height, local, out),
        Shape::Box { half } => return box_face(*half, local, &a.pose, out),
        Shape::Cylinder {
            radius,
            half_height,
        } => cylinder(*radius, *half_height, local, &a.pose, out),
        Shape::Cone { radius, height } => cone(*radius, *height, local, &a.pose, out),
        Shape::Rod { half_length } => segment(*half_length, local, out),
        Shape::Hull(hull) => hull_face(hull, local, heights, out),
        Shape::Triangle(corners) => out.extend(corners),
        Shape::Sphere { .. } | Shape::Ellipsoid { .. } => out.push(a.shape.support(local)),
        Shape::HalfSpace | Shape::Mesh(_) => {}
    }
    for p in out.iter_mut() {
        *p = a.pose.point(*p);
    }
}

/// The line of contact, or the end that points there when the capsule is steeper than 45 degrees.
fn capsule(radius: f64, half_height: f64, d: DVec3, out: &mut Vec<DVec3>) {
    if d.z.abs() < std::f64::consts::FRAC_1_SQRT_2 {
        segment(half_height, d, out);
    } else {
        out.push(DVec3::new(0.0, 0.0, half_height.copysign(d.z)));
    }
    out.iter_mut().for_each(|p| *p += radius * d);
}

/// Both ends; the nearer one alone when the direction runs along the segment.
fn segment(half_length: f64, d: DVec3, out: &mut Vec<DVec3>) {
    let end = DVec3::new(0.0, 0.0, half_length.copysign(d.z));
    out.push(end);
    if 1.0 - d.z.abs() > LEVEL {
        out.push(-end);
    }
}

/// The face most aligned with the local direction, in world coordinates.
fn box_face(half: DVec3, d: DVec3, pose: &Pose, out: &mut Vec<DVec3>) {
    let axis = d.abs().max_position();
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let reach = |k: usize| pose.rotation.col(k) * half[k];
    let middle = pose.position + reach(axis) * 1.0_f64.copysign(d[axis]);
    let (u, v) = (reach(i), reach(j));
    let (first, second) = (middle + v, middle - v);
    out.extend([first + u, first - u, second - u, second + u]);
}

/// The cap within 45 degrees of the axis, else the line on the side.
fn cylinder(radius: f64, half_height: f64, d: DVec3, pose: &Pose, out: &mut Vec<DVec3>) {
    let radial = DVec3::new(d.x, d.y, 0.0);
    let end = DVec3::new(0.0, 0.0, half_height.copysign(d.z));
    if d.z * d.z >= radial.length_squared() {
        ring(radius, end, radial, pose, out);
    } else {
        let side = radius * radial.normalize_or_zero();
        out.extend([side + end, side - end]);
    }
}

/// The base when the direction is nearer to its normal than to that of the side, else the line from rim to apex.
///
/// In the half-plane (radial, z) the side's outward normal is (H, R) / sqrt(H^2 + R^2), the base's is (0, -1).
fn cone(radius: f64, height: f64, d: DVec3, pose: &Pose, out: &mut Vec<DVec3>) {
    let radial = DVec3::new(d.x, d.y, 0.0);
    let along_side =
        (height * radial.length() + radius * d.z) / (height * height + radius * radius).sqrt();
    let base = DVec3::new(0.0, 0.0, -0.25 * height);
    if -d.z >= along_side {
        ring(radius, base, radial, pose, out);
        return;
    }
    let apex = DVec3::new(0.0, 0.0, 0.75 * height);
    out.push(apex);
    if radial.length_squared() > LEVEL * LEVEL {
        out.push(base + radius * radial.normalize_or_zero());
    }
}

/// Polygon inscribed in a circle of the local xy plane.
///
/// Its corners keep their places in the world while the shape spins about its axis, so that contacts can be
/// recognised from step to step; only the corner nearest to the lowest point of a tilted circle moves onto it,
/// so that the deepest point is exact.
fn ring(radius: f64, center: DVec3, lowest: DVec3, pose: &Pose, out: &mut Vec<DVec3>) {
    let (u, v) = ring_axes(pose);
    let diagonal = std::f64::consts::FRAC_1_SQRT_2;
    let start = out.len();
    for (x, y) in [
        (1.0, 0.0),
        (diagonal, diagonal),
        (0.0, 1.0),
        (-diagonal, diagonal),
    ] {
        out.push(center + radius * (x * u + y * v));
    }
    for k in 0..RING / 2 {
        out.push(2.0 * center - out[start + k]);
    }
    if lowest.length_squared() > LEVEL * LEVEL {
        let lowest = lowest.normalize_or_zero();
        let height = |p: &DVec3| lowest.dot(*p);
        if let Some(nearest) = out[start..]
            .iter_mut()
            .max_by(|p, q| height(p).total_cmp(&height(q)))
        {
            *nearest = center + radius * lowest;
        }
    }
}

/// Two unit vectors of the local xy plane that stay put in the world when the frame turns about z: the projection of
/// the world's x axis (y axis when z lies along x) and its perpendicular.
fn ring_axes(pose: &Pose) -> (DVec3, DVec3) {
    let x = pose.inverse_direction(DVec3::X);
    let reference = if x.z.abs() < 0.9 {
        x
    } else {
        pose.inverse_direction(DVec3::Y)
    };
    let u = DVec3::new(reference.x, reference.y, 0.0)
        .try_normalize()
        .unwrap_or(DVec3::X);
    (u, DVec3::Z.cross(u))
}

/// Of the faces that contain all supporting vertices (one, an edge's two, or a face's) the most aligned one.
fn hull_face(hull: &Hull, d: DVec3, heights: &mut Vec<f64>, out: &mut Vec<DVec3>) {
    heights.clear();
    heights.extend(hull.vertices().iter().map(|v| v.dot(d)));
    let top = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let support = top - SUPPORT_TOLERANCE * hull.bounding_radius();
    let mut best = (0, 0.0, None);
    for face in hull.faces() {
        let aligned = face.normal.dot(d);
        if aligned <= 0.0 {
            continue;
        }
        let corners = hull.corners(face).iter();
        let shared = corners.filter(|&&i| heights[i as usize] >= support).count();
        if shared > 0 && (shared, aligned) > (best.0, best.1) {
            best = (shared, aligned, Some(face));
        }
    }
    match best.2 {
        Some(face) => {
            let corners = hull.corners(face).iter();
            out.extend(corners.map(|&i| hull.vertices()[i as usize]));
        }
        None => out.push(hull.support(d)),
    }
}
