//! Exact meshes: their triangles act as one surface.

use super::testing::*;
use super::*;
use crate::shape::TriangleMesh;
use std::sync::Arc;

const MARGIN: f64 = 0.01;

/// A square of 2 n x 2 n cells of size 0.25 about the origin at the heights of a function; open at the border.
fn terrain(n: i32, height: impl Fn(f64, f64) -> f64) -> Shape {
    let count = 2 * n + 1;
    let vertices = (0..count * count).map(|k| {
        let (x, y) = (
            0.25 * f64::from(k % count - n),
            0.25 * f64::from(k / count - n),
        );
        DVec3::new(x, y, height(x, y))
    });
    let cells = (0..4 * n * n).map(|k| (k % (2 * n) + k / (2 * n) * count) as u32);
    let c = count as u32;
    let triangles = cells.flat_map(|i| [[i, i + 1, i + c + 1], [i, i + c + 1, i + c]]);
    Shape::Mesh(Arc::new(
        TriangleMesh::new(vertices.collect(), triangles.collect()).unwrap(),
    ))
}

/// A closed box of 12 triangles.
fn block(half: DVec3) -> Shape {
    let vertices = (0..8).map(|k| {
        let sign = |bit: i32| if k >> bit & 1 == 0 { -1.0 } else { 1.0 };
        half * DVec3::new(sign(0), sign(1), sign(2))
    });
    let quads = [
        [0, 4, 6, 2],
        [1, 3, 7, 5],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 2, 3, 1],
        [4, 5, 7, 6],
    ];
    let triangles = quads
        .iter()
        .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
    Shape::Mesh(Arc::new(
        TriangleMesh::new(vertices.collect(), triangles.collect()).unwrap(),
    ))
}

fn movers() -> Vec<(Shape, f64)> {
    vec![
        (Shape::Sphere { radius: 0.2 }, 0.2),
        (
            Shape::Capsule {
                radius: 0.1,
                half_height: 0.3,
            },
            0.4,
        ),
        (
            Shape::Box {
                half: DVec3::new(0.3, 0.2, 0.1),
            },
            0.1,
        ),
        (prism(6, 0.3, 0.15), 0.15),
        (
            Shape::Cylinder {
                radius: 0.2,
                half_height: 0.25,
            },
            0.25,
        ),
        (
            Shape::Cone {
                radius: 0.25,
                height: 0.4,
            },
            0.1,
        ),
        (
            Shape::Ellipsoid {
                radii: DVec3::new(0.3, 0.2, 0.15),
            },
            0.15,
        ),
        (Shape::Rod { half_length: 0.3 }, 0.3),
    ]
}

#[test]
fn flat_triangles_are_a_plane() {
    let mut random = Random(11);
    let ground = terrain(8, |_, _| 0.0);
    for (shape, _) in movers() {
        for _ in 0..300 {
            let mut pose = random.pose(0.8);
            let lowest = Posed {
                shape: &shape,
                pose,
            }
            .support(DVec3::NEG_Z)
            .z;
            let depth = 0.01 * random.next();
            pose.position.z -= lowest + depth;
            let points = contacts(&shape, &pose, &ground, &Pose::IDENTITY, MARGIN);
            let plane = contacts(&shape, &pose, &Shape::HalfSpace, &Pose::IDENTITY, MARGIN);
            assert!(points.len() <= 32);
            assert!(
                points.iter().all(|p| p.normal.distance(DVec3::Z) < 1e-9),
                "{shape:?} {points:?}"
            );
            assert!((deepest(&points).depth - depth).abs() < 1e-9, "{shape:?}");
            assert!((deepest(&plane).depth - depth).abs() < 1e-12);
        }
    }
}

#[test]
fn a_box_on_many_triangles_rests_on_its_corners() {
    let shape = Shape::Box {
        half: DVec3::new(0.3, 0.2, 0.1),
    };
    let pose = at(0.11, 0.07, 0.099);
    let points = contacts(
        &shape,
        &pose,
        &terrain(8, |_, _| 0.0),
        &Pose::IDENTITY,
        MARGIN,
    );
    for (x, y) in [(-0.3, -0.2), (0.3, -0.2), (0.3, 0.2), (-0.3, 0.2)] {
        let corner = DVec3::new(0.11 + x, 0.07 + y, -0.0005);
        assert!(
            points.iter().any(|p| p.position.distance(corner) < 1e-9),
            "{points:?}"
        );
    }
    assert!(points.len() <= 8 && points.iter().all(|p| (p.depth - 0.001).abs() < 1e-12));
}

#[test]
fn a_block_of_triangles_is_a_box() {
    let mut random = Random(12);
    let half = DVec3::new(0.6, 0.5, 0.4);
    let (mesh, solid) = (block(half), Shape::Box { half });
    let mut compared = 0;
    // Without the rod: its tip may slant under a neighbour of the triangle through which it passes.
    for (shape, _) in movers().into_iter().take(4) {
        for _ in 0..600 {
            let pose = random.pose(0.9);
            let exact = contacts(&shape, &pose, &solid, &Pose::IDENTITY, MARGIN);
            let points = contacts(&shape, &pose, &mesh, &Pose::IDENTITY, MARGIN);
            // Deeper than this, triangles may see another way out than the solid does.
            if exact.is_empty() || deepest(&exact).depth > 0.03 {
                continue;
            }
            compared += 1;
            let (p, q) = (deepest(&exact), deepest(&points));
            assert!(
                (p.depth - q.depth).abs() < 1e-9,
                "{shape:?}\n{exact:?}\n{points:?}"
            );
            assert!(
                p.normal.distance(q.normal) < 1e-6,
                "{shape:?}\n{exact:?}\n{points:?}"
            );
        }
    }
    assert!(compared > 100, "{compared}");
}

#[test]
fn a_centre_just_inside_is_pushed_out() {
    let mesh = block(DVec3::splat(0.5));
    for (shape, reach) in movers() {
        let points = contacts(
            &shape,
            &at(0.05, 0.03, 0.48),
            &mesh,
            &Pose::IDENTITY,
            MARGIN,
        );
        let p = deepest(&points);
        assert!(p.normal.distance(DVec3::Z) < 1e-12, "{shape:?} {points:?}");
        assert!(
            (p.depth - (reach + 0.02)).abs() < 1e-12,
            "{shape:?} {points:?}"
        );
    }
}

#[test]
fn a_thin_plate_holds_from_above_and_from_below() {
    let plate = block(DVec3::new(1.0, 1.0, 0.01));
    for (z, up) in [(0.205, DVec3::Z), (-0.205, DVec3::NEG_Z)] {
        let points = contacts(
            &Shape::Sphere { radius: 0.2 },
            &at(0.1, 0.3, z),
            &plate,
            &Pose::IDENTITY,
            MARGIN,
        );
        assert_eq!(points.len(), 1);
        assert!((points[0].depth - 0.005).abs() < 1e-12 && points[0].normal == up);
    }
}

#[test]
fn valleys_hold_with_both_flanks() {
    let valley = terrain(8, |x, _| x.abs());
    let r = 0.2;
    let height = (r - 0.001) * 2f64.sqrt();
    let points = contacts(
        &Shape::Sphere { radius: r },
        &at(0.0, 0.1, height),
        &valley,
        &Pose::IDENTITY,
        MARGIN,
    );
    assert_eq!(points.len(), 2, "{points:?}");
    let slope = DVec3::new(0.5f64.sqrt(), 0.0, 0.5f64.sqrt());
    for p in points {
        assert!(
            (p.normal - DVec3::new(slope.x.copysign(p.normal.x), 0.0, slope.z)).length() < 1e-12
        );
        assert!((p.depth - 0.001).abs() < 1e-12);
    }
}

#[test]
fn nonsense_does_not_panic() {
    let mesh = block(DVec3::splat(0.5));
    for (shape, _) in movers() {
        for x in [f64::NAN, f64::INFINITY, 1e300, 0.0] {
            let pose = Pose {
                position: DVec3::new(x, 0.0, 0.3),
                rotation: glam::DMat3::IDENTITY * x,
            };
            contacts(&shape, &pose, &mesh, &Pose::IDENTITY, MARGIN);
            contacts(&shape, &at(0.0, 0.0, 0.3), &mesh, &pose, MARGIN);
        }
    }
}
