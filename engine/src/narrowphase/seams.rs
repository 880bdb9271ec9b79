//! Seams: shapes that lie flush pass each other.
//!
//! Solids that touch have one plane between them, that of the contact. Where a second plane, turned against the first,
//! keeps them apart as well, they meet in an edge at most: a box that slides from one table onto another of the same
//! height has the second table's top between them and, in front of it, the second table's side. Resting bodies sink in
//! by up to [`SLOP`], so that the side would be hit by a strip of that height; and a ball that rolls over would be held
//! up by the edge before it is there. Such pairs have no contact.
//!
//! The second plane is that of a flat face of either shape, and they are apart along it to within [`FLUSH`]. What falls
//! onto an edge, stands against a wall or hits a face over more than that has no such plane. At the edge itself only face
//! lies flush with face: a ridge that stands on a rim has planes enough between them, and stays. Crossing ridges, whose
//! second plane would belong to no face, are not looked at, nor are exact meshes, which know their inner edges.

use super::{ContactPoint, Posed};
use crate::position::SLOP;
use crate::shape::{Face, Pose, Shape};
use glam::DVec3;

/// Overlap or gap up to which faces are level: what resting bodies are left with, and as much again for those that are
/// still being pushed apart to it [m].
const FLUSH: f64 = 2.0 * SLOP;
/// Planes turned against each other by less than this (cosine; 0.01 rad) belong to faces that lie on each other.
const TURNED: f64 = 1.0 - 5e-5;
/// The same while the shapes are more than `FLUSH` apart along the contact (cosine; 1e-3 rad): rounded shapes come to an
/// edge at ever smaller angles.
const TURNED_APART: f64 = 1.0 - 5e-7;

/// Drops the points from `start` on when the shapes pass each other.
pub(crate) fn drop_passing(a: &Posed, b: &Posed, points: &mut Vec<ContactPoint>, start: usize) {
    let new = points[start..].iter();
    let Some(deepest) = new.reduce(|p, q| if q.depth > p.depth { q } else { p }) else {
        return;
    };
    let (normal, apart) = (deepest.normal, deepest.depth < -FLUSH);
    if lies_flush(a, b, normal, apart) || lies_flush(b, a, -normal, apart) {
        points.truncate(start);
    }
}

/// Whether a shape lies flush on a face of the solid that is turned against `outward`: while apart in an edge or point,
/// else with a face.
fn lies_flush(shape: &Posed, solid: &Posed, outward: DVec3, apart: bool) -> bool {
    if !has_faces(solid.shape) {
        return false;
    }
    let limit = if apart { TURNED_APART } else { TURNED };
    let outward = solid.pose.inverse_direction(outward);
    let center = shape.pose.point(shape.shape.center());
    let center = solid.pose.inverse_point(center);
    // Seen from the solid most of its faces are not beside the shape.
    let beside = |face: &Face| {
        face.height(center) > -FLUSH && face.normal.dot(outward) < limit && {
            let face = placed(face, &solid.pose);
            (apart || faces_it(shape, face.normal)) && touches(shape, &face)
        }
    };
    match solid.shape {
        Shape::Box { half } => {
            let outside = (center.abs() - *half).cmpgt(DVec3::splat(-FLUSH));
            (0..3).any(|k| outside.test(k) && beside(&side(*half, k, center[k])))
        }
        other => any_face(other, beside),
    }
}

/// Whether a shape has a face that lies on one with this normal (world).
fn faces_it(shape: &Posed, normal: DVec3) -> bool {
    let against = -shape.pose.inverse_direction(normal);
    any_face(shape.shape, |face| face.normal.dot(against) >= TURNED)
}

/// Whether a shape whose centre is outside of a face's plane touches it.
fn touches(shape: &Posed, face: &Face) -> bool {
    face.height(shape.support(-face.normal)).abs() <= FLUSH
}

fn placed(face: &Face, pose: &Pose) -> Face {
    let normal = pose.direction(face.normal);
    Face::plane(normal, face.offset + normal.dot(pose.position))
}

fn has_faces(shape: &Shape) -> bool {
    use Shape::{Box, Cone, Cylinder, Hull};
    matches!(shape, Box { .. } | Hull(_) | Cylinder { .. } | Cone { .. })
}

/// Whether a flat face of a shape, in its frame, is of a kind.
fn any_face(shape: &Shape, mut is: impl FnMut(&Face) -> bool) -> bool {
    match shape {
        Shape::Hull(hull) => hull.faces().iter().any(is),
        Shape::Box { half } => {
            (0..3).any(|k| is(&side(*half, k, 1.0)) || is(&side(*half, k, -1.0)))
        }
        Shape::Cylinder { half_height, .. } => {
            is(&Face::plane(DVec3::Z, *half_height)) || is(&Face::plane(-DVec3::Z, *half_height))
        }
        Shape::Cone { height, .. } => is(&Face::plane(-DVec3::Z, 0.25 * height)),
        _ => false,
    }
}

/// The face of a box across an axis, on the side of this sign.
fn side(half: DVec3, axis: usize, sign: f64) -> Face {
    let mut normal = DVec3::ZERO;
    normal[axis] = 1.0_f64.copysign(sign);
    Face::plane(normal, half[axis])
}

#[cfg(test)]
mod tests {
    use super::super::testing::{at, contacts, deepest, prism, turned, Random};
    use super::super::{manifold, Scratch};
    use super::*;

    const TABLE: Shape = Shape::Box {
        half: DVec3::new(1.0, 1.0, 0.5),
    };
    const SLED: Shape = Shape::Box {
        half: DVec3::new(0.3, 0.2, 0.1),
    };
    /// The second table begins at x = 0, its top is at z = 0.
    const SECOND: (f64, f64, f64) = (1.0, 0.0, -0.5);

    fn against_second(a: &Shape, pose: &Pose) -> Vec<ContactPoint> {
        let (x, y, z) = SECOND;
        contacts(a, pose, &TABLE, &at(x, y, z), 0.01)
    }

    fn upward(points: &[ContactPoint]) -> bool {
        points.iter().all(|p| p.normal.z > 1.0 - 1e-9)
    }

    #[test]
    fn what_slides_over_a_seam_meets_the_top_alone() {
        for heading in [0.0, 0.5, std::f64::consts::FRAC_PI_4] {
            let (s, c) = libm::sincos(heading);
            let front = 0.3 * c + 0.2 * s;
            for sunk in [-1.9e-8, -1e-10, 0.0, 1e-10, 1e-8, 1.9e-8] {
                for ahead in [-1e-3, -1e-9, -1e-12, 0.0, 1e-12, 1e-9, 1e-6, 1e-3] {
                    let place = DVec3::new(ahead - front, 0.1, 0.1 - sunk);
                    let points = against_second(&SLED, &turned(place, DVec3::Z, heading));
                    assert!(upward(&points), "{heading} {sunk} {ahead} {points:?}");
                    assert!(ahead.abs() < 1e-6 || points.is_empty() == (ahead < 0.0));
                }
            }
        }
    }

    #[test]
    fn a_ball_meets_the_edge_when_it_is_there_and_not_before() {
        let ball = Shape::Sphere { radius: 0.1 };
        let met = |x: f64, z: f64| against_second(&ball, &at(x, 0.0, z));
        for sunk in [-1e-8, 0.0, 1e-10, 1e-8] {
            assert!(met(-1e-3, 0.1 - sunk).is_empty());
            let over = met(1e-3, 0.1 - sunk);
            assert!(upward(&over) && (deepest(&over).depth - sunk).abs() < 1e-15);
        }
        // 0.1 mm lower or higher the edge is in the way, or may come to be: the gap is that of a point and a ball.
        for height in [0.0999, 0.1001] {
            let gap = (1e-3f64 * 1e-3 + height * height).sqrt() - 0.1;
            assert!((deepest(&met(-1e-3, height)).depth + gap).abs() < 1e-15);
        }
        // Lying on the edge, as when it rolls off a table.
        let tilt = 1e-3;
        let (s, c) = libm::sincos(tilt);
        assert!((deepest(&met(-0.1 * s, 0.1 * c)).normal.z - c).abs() < 1e-12);
    }

    #[test]
    fn walls_and_steps_are_hit() {
        let met = |a: &Shape, x: f64, z: f64| against_second(a, &at(x, 0.0, z));
        // A step of 1 micrometre, and a wall that stands on the floor that the sled slides on.
        for z in [0.1 - 1e-6, -0.9] {
            let points = met(&SLED, -0.3 - 1e-4, z);
            assert_eq!(points.len(), 4);
            assert!(points
                .iter()
                .all(|p| p.normal == DVec3::NEG_X && (p.depth + 1e-4).abs() < 1e-12));
        }
        // Standing at the very rim, overlapping it by 1 micrometre.
        let points = met(&SLED, -0.3 + 1e-6, 0.1);
        assert!(points.len() == 4 && upward(&points));
    }

    #[test]
    fn corners_and_edges_land() {
        let down = DVec3::new(0.3, 0.2, 0.1).normalize();
        let axis = down.cross(DVec3::NEG_Z).normalize();
        let angle = libm::acos(-down.z);
        let on_corner = turned(DVec3::ZERO, axis, angle);
        let reach = DVec3::new(0.3, 0.2, 0.1).length();
        for gap in [1e-3, 1e-9, -1e-9] {
            let place = DVec3::new(0.5, 0.0, reach + gap);
            let points = against_second(
                &SLED,
                &Pose {
                    position: place,
                    ..on_corner
                },
            );
            assert!(upward(&points) && (deepest(&points).depth + gap).abs() < 1e-12);
            // Edge across edge: both turned by 45 degrees about axes at right angles to each other.
            let quarter = std::f64::consts::FRAC_PI_4;
            let cube = Shape::Box {
                half: DVec3::splat(0.5),
            };
            let upper = turned(DVec3::new(0.1, 0.2, 2f64.sqrt() + gap), DVec3::X, quarter);
            let lower = turned(DVec3::ZERO, DVec3::Y, quarter);
            let points = contacts(&cube, &upper, &cube, &lower, 0.01);
            assert!(upward(&points) && (deepest(&points).depth + gap).abs() < 1e-12);
        }
    }

    /// A ridge along the very rim of the table, as box and as hull.
    #[test]
    fn a_ridge_stands_on_a_rim() {
        let place = DVec3::new(0.0, 0.0, 0.5 - 1e-10);
        for (ridge, axis, angle) in [
            (
                Shape::Box {
                    half: DVec3::splat(0.5 * std::f64::consts::FRAC_1_SQRT_2),
                },
                DVec3::Y,
                std::f64::consts::FRAC_PI_4,
            ),
            (prism(4, 0.5, 0.3), DVec3::X, std::f64::consts::FRAC_PI_2),
        ] {
            let points = against_second(&ridge, &turned(place, axis, angle));
            assert!(points.iter().any(|p| p.depth > 5e-11), "{points:?}");
        }
    }

    /// Prisms that stand beside and partly over each other, level to within 20 nm: through the kernel and through the
    /// manifold of a given normal they touch from above or not at all.
    #[test]
    fn level_hulls_pass_each_other() {
        let mut random = Random(77);
        let (mut over, mut beside) = (0, 0);
        for k in 0..2000 {
            let (a, b) = (prism(3 + k % 7, 0.5, 0.3), prism(3 + k % 4, 0.4, 0.2));
            let sunk = 1.9e-8 * random.next();
            let place = DVec3::new(1.1 * random.next(), 1.1 * random.next(), 0.3 - sunk);
            let upper = turned(place, DVec3::Z, 3.0 * random.next());
            let lower = turned(DVec3::new(0.0, 0.0, -0.2), DVec3::Z, 3.0 * random.next());
            let points = contacts(&a, &upper, &b, &lower, 0.3);
            assert!(upward(&points), "{k} {points:?}");
            let mut again = Vec::new();
            let (sideways, scratch) = (DVec3::new(place.x, place.y, 0.0), &mut Scratch::default());
            for normal in [DVec3::Z, sideways.normalize()] {
                let middle = 0.5 * place;
                manifold(
                    &a, &upper, &b, &lower, normal, middle, 0.3, scratch, &mut again,
                );
            }
            assert!(upward(&again), "{k} {again:?}");
            over += i32::from(!points.is_empty());
            beside += i32::from(points.is_empty());
        }
        assert!(over > 300 && beside > 300, "{over} {beside}");
    }
}
