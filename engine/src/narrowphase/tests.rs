//! Properties that every kernel must have, over pseudo-random poses.

use super::testing::*;
use super::*;

const MARGIN: f64 = 0.02;

/// All pairs in both orders, those of polytopes and round ends first.
fn pairs() -> Vec<(Shape, Shape)> {
    let all = shapes();
    let pairs = all
        .iter()
        .flat_map(|a| all.iter().map(move |b| (a.clone(), b.clone())));
    let (curved, rest): (Vec<_>, Vec<_>) = pairs.partition(|(a, b)| by_reach(a, b));
    [rest, curved].concat()
}

/// Whether a pair is curved with no closed form; the polygons that stand for rims keep their places in the world.
fn by_reach(a: &Shape, b: &Shape) -> bool {
    use Shape::{Cone, Cylinder, Ellipsoid, Sphere};
    let curved = |s: &Shape| matches!(s, Cylinder { .. } | Cone { .. } | Ellipsoid { .. });
    let round = |s: &Shape| matches!(s, Sphere { .. });
    (curved(a) || curved(b)) && !(round(a) || round(b))
}

fn flipped(p: &ContactPoint) -> ContactPoint {
    ContactPoint {
        normal: -p.normal,
        ..*p
    }
}

fn nearly(p: &ContactPoint, q: &ContactPoint, tolerance: f64) -> bool {
    p.position.distance(q.position) < tolerance
        && p.normal.distance(q.normal) < tolerance
        && (p.depth - q.depth).abs() < tolerance
}

/// Same points, whatever their order.
fn same_set(p: &[ContactPoint], q: &[ContactPoint], tolerance: f64) -> bool {
    p.len() == q.len() && p.iter().all(|x| q.iter().any(|y| nearly(x, y, tolerance)))
}

#[test]
fn normals_are_unit_and_depths_exceed_the_margin() {
    let mut random = Random(1);
    for (a, b) in pairs() {
        for _ in 0..200 {
            let (pose_a, pose_b) = (random.pose(0.5), random.pose(0.5));
            let points = contacts(&a, &pose_a, &b, &pose_b, MARGIN);
            assert!(points.len() <= 8);
            for p in points {
                assert!((p.normal.length() - 1.0).abs() < 1e-12, "{a:?} {b:?}");
                assert!(p.depth > -MARGIN);
            }
        }
    }
}

#[test]
fn exchanging_the_bodies_mirrors_the_answer() {
    let mut random = Random(2);
    for (a, b) in pairs() {
        for _ in 0..200 {
            let (pose_a, pose_b) = (random.pose(0.5), random.pose(0.5));
            let there = contacts(&a, &pose_a, &b, &pose_b, MARGIN);
            let back: Vec<_> = contacts(&b, &pose_b, &a, &pose_a, MARGIN)
                .iter()
                .map(flipped)
                .collect();
            // Two cylinders' polygons are laid over one another in either order, which may drop a corner on an edge.
            let rings = by_reach(&a, &b);
            assert!(
                same_set(&there, &back, 1e-9) || rings && nearly_deepest(&there, &back, 1e-3),
                "{a:?} {b:?}\n{there:?}\n{back:?}"
            );
        }
    }
}

/// The deepest point states the separation along its own normal exactly, and while the shapes overlap no other
/// direction that a dense sampling finds has less overlap.
#[test]
fn depth_is_the_least_overlap() {
    let mut random = Random(3);
    for (a, b) in pairs() {
        for _ in 0..10 {
            let (pose_a, pose_b) = (random.pose(0.45), random.pose(0.45));
            let (at_a, at_b) = (
                Posed {
                    shape: &a,
                    pose: pose_a,
                },
                Posed {
                    shape: &b,
                    pose: pose_b,
                },
            );
            let best = largest_separation(&at_a, &at_b);
            let points = contacts(&a, &pose_a, &b, &pose_b, MARGIN);
            if best < -1e-6 {
                let p = deepest(&points);
                assert!(
                    (separation(&at_a, &at_b, p.normal) + p.depth).abs() < 1e-12,
                    "{a:?} {b:?}"
                );
                assert!(best + p.depth < 1e-9, "{a:?} {b:?}: {best} {p:?}");
            }
            assert!(best < MARGIN || points.is_empty(), "{a:?} {b:?}: {best}");
        }
    }
}

#[test]
fn moving_the_whole_scene_moves_the_answer() {
    let mut random = Random(4);
    for (a, b) in pairs() {
        for _ in 0..100 {
            let (pose_a, pose_b, motion) = (random.pose(0.5), random.pose(0.5), random.pose(10.0));
            let here = contacts(&a, &pose_a, &b, &pose_b, MARGIN);
            let there = contacts(
                &a,
                &motion.compose(&pose_a),
                &b,
                &motion.compose(&pose_b),
                MARGIN,
            );
            let back = there.iter().map(|p| ContactPoint {
                position: motion.inverse_point(p.position),
                normal: motion.inverse_direction(p.normal),
                depth: p.depth,
            });
            let back: Vec<_> = back.collect();
            let rings = by_reach(&a, &b);
            assert!(
                nearly_deepest(&here, &back, if rings { 1e-3 } else { 0.0 })
                    && (rings || here.len() == back.len()),
                "{a:?} {b:?}\n{here:?}\n{back:?}"
            );
        }
    }
}

/// Of ways out of deep overlaps the search for curved shapes may find the second best, by up to a share of the depth.
fn nearly_deepest(here: &[ContactPoint], there: &[ContactPoint], share: f64) -> bool {
    here.is_empty() == there.is_empty()
        && (here.is_empty() || {
            let (p, q) = (deepest(here).depth, deepest(there).depth);
            let slack = if p > 0.1 { share * p } else { 0.0 };
            (p - q).abs() < 1e-10 + slack
        })
}

#[test]
fn nothing_panics_on_nonsense() {
    let nonsense = [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        1e308,
        1e-308,
        0.0,
    ];
    let all = shapes();
    for (a, b) in all.iter().flat_map(|a| all.iter().map(move |b| (a, b))) {
        for x in nonsense {
            let mut out = Vec::new();
            let pose = Pose {
                position: DVec3::new(x, 0.1, x),
                rotation: glam::DMat3::IDENTITY * x,
            };
            collide(
                a,
                &pose,
                b,
                &Pose::IDENTITY,
                MARGIN,
                &mut Scratch::default(),
                &mut out,
            );
            collide(
                a,
                &at(x, 0.0, 0.0),
                b,
                &Pose::IDENTITY,
                MARGIN,
                &mut Scratch::default(),
                &mut out,
            );
            collide(
                a,
                &at(0.0, 0.0, 0.1),
                b,
                &Pose::IDENTITY,
                x,
                &mut Scratch::default(),
                &mut out,
            );
            collide(
                a,
                &pose,
                &Shape::HalfSpace,
                &Pose::IDENTITY,
                MARGIN,
                &mut Scratch::default(),
                &mut out,
            );
            assert!(out
                .iter()
                .all(|p| p.position.is_finite() && p.depth.is_finite()));
        }
    }
}
