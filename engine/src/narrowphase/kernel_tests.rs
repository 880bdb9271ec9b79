//! Closed forms for the kernels: touching, gap, overlap, deep overlap, turned and parallel.

use super::testing::*;
use super::*;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, FRAC_PI_4, PI};

const MARGIN: f64 = 0.05;
const CUBE: Shape = Shape::Box { half: DVec3::ONE };
const BALL: Shape = Shape::Sphere { radius: 0.5 };
const PILL: Shape = Shape::Capsule {
    radius: 0.2,
    half_height: 0.5,
};
const ROD: Shape = Shape::Rod { half_length: 0.5 };

/// All points have this normal; returns the depths in ascending order.
fn depths(points: &[ContactPoint], normal: DVec3) -> Vec<f64> {
    for p in points {
        assert!(p.normal.distance(normal) < 1e-12, "{p:?}");
    }
    let mut depths: Vec<f64> = points.iter().map(|p| p.depth).collect();
    depths.sort_by(f64::total_cmp);
    depths
}

fn assert_depths(points: &[ContactPoint], normal: DVec3, expected: &[f64]) {
    let found = depths(points, normal);
    assert_eq!(found.len(), expected.len(), "{points:?}");
    assert!(
        found
            .iter()
            .zip(expected)
            .all(|(d, e)| (d - e).abs() < 1e-12),
        "{points:?} {expected:?}"
    );
}

fn lying(position: DVec3, heading: f64) -> Pose {
    let quarter = turned(DVec3::ZERO, DVec3::Y, FRAC_PI_2);
    Pose {
        position,
        ..turned(DVec3::ZERO, DVec3::Z, heading).compose(&quarter)
    }
}

#[test]
fn ball_on_ball() {
    for (gap, count) in [(0.0, 1), (0.04, 1), (0.06, 0), (-0.1, 1), (-0.9, 1)] {
        let points = contacts(
            &BALL,
            &at(0.0, 0.0, 1.0 + gap),
            &BALL,
            &Pose::IDENTITY,
            MARGIN,
        );
        assert_depths(&points, DVec3::Z, &vec![-gap; count]);
    }
    let concentric = contacts(&BALL, &Pose::IDENTITY, &BALL, &Pose::IDENTITY, MARGIN);
    assert_eq!(concentric[0].depth, 1.0);
}

#[test]
fn ball_on_box_over_face_edge_and_corner() {
    let to_edge = DVec3::new(FRAC_1_SQRT_2, 0.0, FRAC_1_SQRT_2);
    let to_corner = DVec3::ONE.normalize();
    for gap in [0.0, 0.04, -0.1, -0.4] {
        let reach = 0.5 + gap;
        let face = contacts(
            &BALL,
            &at(0.3, 0.2, 1.0 + reach),
            &CUBE,
            &Pose::IDENTITY,
            MARGIN,
        );
        assert_depths(&face, DVec3::Z, &[-gap]);
        assert!(
            face[0]
                .position
                .distance(DVec3::new(0.3, 0.2, 1.0 + 0.5 * gap))
                < 1e-12
        );
        let pose = Pose {
            position: DVec3::new(1.0, 0.2, 1.0) + reach * to_edge,
            ..Pose::IDENTITY
        };
        assert_depths(
            &contacts(&BALL, &pose, &CUBE, &Pose::IDENTITY, MARGIN),
            to_edge,
            &[-gap],
        );
        let pose = Pose {
            position: DVec3::ONE + reach * to_corner,
            ..Pose::IDENTITY
        };
        assert_depths(
            &contacts(&BALL, &pose, &CUBE, &Pose::IDENTITY, MARGIN),
            to_corner,
            &[-gap],
        );
    }
}

#[test]
fn ball_with_its_centre_inside_goes_out_through_the_nearest_face() {
    let cylinder = Shape::Cylinder {
        radius: 1.0,
        half_height: 1.0,
    };
    let cone = Shape::Cone {
        radius: 1.0,
        height: 2.0,
    };
    let slant = DVec3::new(2.0, 0.0, 1.0).normalize();
    let apex = DVec3::new(0.0, 0.0, 1.5);
    let inside = |other: &Shape, p: DVec3| {
        contacts(
            &BALL,
            &Pose {
                position: p,
                ..Pose::IDENTITY
            },
            other,
            &Pose::IDENTITY,
            MARGIN,
        )
    };
    assert_depths(&inside(&CUBE, DVec3::new(0.2, 0.9, 0.1)), DVec3::Y, &[0.6]);
    assert_depths(
        &inside(&cylinder, DVec3::new(0.9, 0.0, 0.1)),
        DVec3::X,
        &[0.6],
    );
    assert_depths(
        &inside(&cylinder, DVec3::new(0.1, 0.0, -0.9)),
        DVec3::NEG_Z,
        &[0.6],
    );
    assert_depths(
        &inside(&cone, DVec3::new(0.3, 0.0, -0.45)),
        DVec3::NEG_Z,
        &[0.55],
    );
    let p = DVec3::new(0.45, 0.0, 0.4);
    assert_depths(&inside(&cone, p), slant, &[0.5 - slant.dot(p - apex)]);
    assert_depths(
        &inside(&prism(6, 1.0, 0.5), DVec3::new(0.1, 0.1, 0.4)),
        DVec3::Z,
        &[0.6],
    );
}

#[test]
fn ball_beside_cylinder_and_cone() {
    let cylinder = Shape::Cylinder {
        radius: 1.0,
        half_height: 1.0,
    };
    let rim = DVec3::new(0.6, 0.0, 0.8);
    let on_rim = Pose {
        position: DVec3::new(1.0, 0.0, 1.0) + 0.52 * rim,
        ..Pose::IDENTITY
    };
    assert_depths(
        &contacts(&BALL, &on_rim, &cylinder, &Pose::IDENTITY, MARGIN),
        rim,
        &[-0.02],
    );
    assert_depths(
        &contacts(
            &BALL,
            &at(0.0, 1.5, 0.3),
            &cylinder,
            &Pose::IDENTITY,
            MARGIN,
        ),
        DVec3::Y,
        &[0.0],
    );
    assert_depths(
        &contacts(
            &BALL,
            &at(0.2, 0.1, 1.45),
            &cylinder,
            &Pose::IDENTITY,
            MARGIN,
        ),
        DVec3::Z,
        &[0.05],
    );
    let cone = Shape::Cone {
        radius: 1.0,
        height: 2.0,
    };
    let slant = DVec3::new(2.0, 0.0, 1.0).normalize();
    let middle = DVec3::new(0.5, 0.0, 0.5);
    let on_side = Pose {
        position: middle + 0.48 * slant,
        ..Pose::IDENTITY
    };
    assert_depths(
        &contacts(&BALL, &on_side, &cone, &Pose::IDENTITY, MARGIN),
        slant,
        &[0.02],
    );
    assert_depths(
        &contacts(&BALL, &at(0.0, 0.0, 1.99), &cone, &Pose::IDENTITY, MARGIN),
        DVec3::Z,
        &[0.01],
    );
    assert_depths(
        &contacts(&BALL, &at(0.4, 0.0, -1.01), &cone, &Pose::IDENTITY, MARGIN),
        DVec3::NEG_Z,
        &[-0.01],
    );
}

#[test]
fn box_on_box_touches_with_the_corners_of_the_shared_face() {
    for gap in [0.0, 0.04, -0.1, -0.6] {
        let points = contacts(
            &CUBE,
            &at(0.5, 0.25, 2.0 + gap),
            &CUBE,
            &Pose::IDENTITY,
            MARGIN,
        );
        assert_depths(&points, DVec3::Z, &[-gap; 4]);
        for (x, y) in [(-0.5, -0.75), (1.0, -0.75), (1.0, 1.0), (-0.5, 1.0)] {
            let corner = DVec3::new(x, y, 1.0 + 0.5 * gap);
            assert!(
                points.iter().any(|p| p.position.distance(corner) < 1e-12),
                "{points:?}"
            );
        }
    }
    assert!(contacts(&CUBE, &at(0.0, 0.0, 2.06), &CUBE, &Pose::IDENTITY, MARGIN).is_empty());
}

#[test]
fn turned_boxes_share_an_octagon() {
    let pose = turned(DVec3::new(0.0, 0.0, 1.99), DVec3::Z, FRAC_PI_4);
    let points = contacts(&CUBE, &pose, &CUBE, &Pose::IDENTITY, MARGIN);
    assert_depths(&points, DVec3::Z, &[0.01; 8]);
}

#[test]
fn box_edge_across_box_edge() {
    let lower = turned(DVec3::ZERO, DVec3::X, FRAC_PI_4);
    let upper = turned(
        DVec3::new(0.2, -0.3, 2.0 * 2f64.sqrt() - 0.01),
        DVec3::Y,
        FRAC_PI_4,
    );
    let points = contacts(&CUBE, &upper, &CUBE, &lower, 0.001);
    assert_depths(&points, DVec3::Z, &[0.01]);
    assert!(
        points[0]
            .position
            .distance(DVec3::new(0.2, 0.0, 2f64.sqrt() - 0.005))
            < 1e-12
    );
    let hull = contacts(
        &prism(4, 2f64.sqrt(), 1.0),
        &lying(DVec3::new(0.0, 0.0, 2f64.sqrt() + 0.99), 0.3),
        &CUBE,
        &Pose::IDENTITY,
        0.001,
    );
    assert_depths(&hull, DVec3::Z, &[0.01; 2]);
}

#[test]
fn boxes_beside_each_other_do_not_touch() {
    assert!(contacts(&CUBE, &at(2.04, 2.04, 0.0), &CUBE, &Pose::IDENTITY, MARGIN).is_empty());
}

#[test]
fn hulls_touch_like_the_boxes_they_are() {
    let mut random = Random(51);
    // A prism of 4 sides is a box turned by 45 degrees about z.
    let (hull, solid) = (
        prism(4, 0.5 * 2f64.sqrt(), 0.3),
        Shape::Box {
            half: DVec3::new(0.5, 0.5, 0.3),
        },
    );
    let eighth = turned(DVec3::ZERO, DVec3::Z, FRAC_PI_4);
    for _ in 0..300 {
        let (pose_a, pose_b) = (random.pose(0.5), random.pose(0.5));
        let boxes = contacts(&solid, &pose_a, &solid, &pose_b, MARGIN);
        let mixed = contacts(&hull, &pose_a.compose(&eighth), &solid, &pose_b, MARGIN);
        let hulls = contacts(
            &hull,
            &pose_a.compose(&eighth),
            &hull,
            &pose_b.compose(&eighth),
            MARGIN,
        );
        assert_eq!(
            (boxes.is_empty(), boxes.is_empty()),
            (mixed.is_empty(), hulls.is_empty())
        );
        if !boxes.is_empty() {
            let depth = deepest(&boxes).depth;
            assert!(
                (deepest(&mixed).depth - depth).abs() < 1e-9
                    && (deepest(&hulls).depth - depth).abs() < 1e-9
            );
        }
    }
}

#[test]
fn capsules_parallel_crossed_and_end_to_end() {
    let parallel = contacts(&PILL, &at(0.39, 0.0, 0.3), &PILL, &Pose::IDENTITY, MARGIN);
    assert_depths(&parallel, DVec3::X, &[0.01; 2]);
    let heights: Vec<f64> = parallel.iter().map(|p| p.position.z).collect();
    assert!((heights[0] - heights[1]).abs() - 0.7 < 1e-12);
    let crossed = contacts(
        &PILL,
        &lying(DVec3::new(0.1, 0.42, 0.2), 0.0),
        &PILL,
        &Pose::IDENTITY,
        MARGIN,
    );
    assert_depths(&crossed, DVec3::Y, &[-0.02]);
    assert!(crossed[0].position.distance(DVec3::new(0.0, 0.21, 0.2)) < 1e-12);
    let in_line = contacts(&PILL, &at(0.0, 0.0, 1.4), &PILL, &Pose::IDENTITY, MARGIN);
    assert_depths(&in_line, DVec3::Z, &[0.0]);
    let thin = contacts(
        &ROD,
        &lying(DVec3::new(0.0, 0.01, 0.0), 0.0),
        &PILL,
        &Pose::IDENTITY,
        MARGIN,
    );
    assert_depths(&thin, DVec3::Y, &[0.19]);
}

#[test]
fn capsule_on_box_lies_stands_and_leans_on_an_edge() {
    let lies = contacts(
        &PILL,
        &lying(DVec3::new(0.2, 0.1, 1.2), 0.3),
        &CUBE,
        &Pose::IDENTITY,
        MARGIN,
    );
    assert_depths(&lies, DVec3::Z, &[0.0; 2]);
    assert!((lies[0].position.distance(lies[1].position) - 1.0).abs() < 1e-12);
    let stands = contacts(&PILL, &at(0.2, 0.1, 1.69), &CUBE, &Pose::IDENTITY, MARGIN);
    assert_depths(&stands, DVec3::Z, &[0.01]);
    let over_edge = contacts(
        &PILL,
        &lying(DVec3::new(0.9, 0.1, 1.21), 0.0),
        &CUBE,
        &Pose::IDENTITY,
        MARGIN,
    );
    assert_depths(&over_edge, DVec3::Z, &[-0.01; 2]);
    let reach = over_edge
        .iter()
        .map(|p| p.position.x)
        .fold(f64::NEG_INFINITY, f64::max);
    assert!((reach - 1.0).abs() < 1e-12);
    let slanted = DVec3::new(FRAC_1_SQRT_2, 0.0, FRAC_1_SQRT_2);
    let lean = Pose {
        position: DVec3::new(1.0, 0.0, 1.0) + 0.19 * slanted,
        ..turned(DVec3::ZERO, DVec3::Y, 0.75 * PI)
    };
    assert_depths(
        &contacts(&PILL, &lean, &CUBE, &Pose::IDENTITY, MARGIN),
        slanted,
        &[0.01],
    );
    let deep = contacts(
        &PILL,
        &lying(DVec3::new(0.0, 0.1, 0.9), 0.3),
        &CUBE,
        &Pose::IDENTITY,
        MARGIN,
    );
    assert_depths(&deep, DVec3::Z, &[0.3; 2]);
}

#[test]
fn rod_on_box_and_on_triangle() {
    let lies = contacts(
        &ROD,
        &lying(DVec3::new(0.2, 0.1, 1.001), 0.3),
        &CUBE,
        &Pose::IDENTITY,
        MARGIN,
    );
    assert_depths(&lies, DVec3::Z, &[-0.001; 2]);
    let stands = contacts(&ROD, &at(0.2, 0.1, 1.499), &CUBE, &Pose::IDENTITY, MARGIN);
    assert_depths(&stands, DVec3::Z, &[0.001]);
    let triangle = Shape::Triangle([DVec3::ZERO, DVec3::X, DVec3::Y]);
    let across = contacts(
        &ROD,
        &lying(DVec3::new(0.2, 0.2, 0.002), 0.0),
        &triangle,
        &Pose::IDENTITY,
        MARGIN,
    );
    assert_depths(&across, DVec3::Z, &[-0.002; 2]);
}

#[test]
fn everything_on_a_plane() {
    let plane = |shape: &Shape, pose: Pose| {
        contacts(shape, &pose, &Shape::HalfSpace, &Pose::IDENTITY, MARGIN)
    };
    let can = Shape::Cylinder {
        radius: 0.2,
        half_height: 0.5,
    };
    let cone = Shape::Cone {
        radius: 0.2,
        height: 0.8,
    };
    let upside_down = |z: f64| turned(DVec3::new(0.0, 0.0, z), DVec3::X, PI);
    assert_depths(&plane(&BALL, at(1.0, 2.0, 0.49)), DVec3::Z, &[0.01]);
    assert_depths(&plane(&CUBE, at(1.0, 2.0, 1.0)), DVec3::Z, &[0.0; 4]);
    assert_depths(
        &plane(
            &CUBE,
            turned(DVec3::new(0.0, 0.0, 2f64.sqrt()), DVec3::X, FRAC_PI_4),
        ),
        DVec3::Z,
        &[0.0; 2],
    );
    assert_depths(
        &plane(&PILL, lying(DVec3::new(0.0, 0.0, 0.19), 0.5)),
        DVec3::Z,
        &[0.01; 2],
    );
    assert_depths(&plane(&PILL, at(0.0, 0.0, 0.71)), DVec3::Z, &[-0.01]);
    assert_depths(&plane(&can, at(0.0, 0.0, 0.49)), DVec3::Z, &[0.01; 8]);
    assert_depths(
        &plane(&can, lying(DVec3::new(0.0, 0.0, 0.19), 0.5)),
        DVec3::Z,
        &[0.01; 2],
    );
    assert_depths(&plane(&cone, at(0.0, 0.0, 0.2)), DVec3::Z, &[0.0; 8]);
    assert_depths(&plane(&cone, upside_down(0.59)), DVec3::Z, &[0.01]);
    assert_depths(
        &plane(&ROD, lying(DVec3::new(0.0, 0.0, 0.01), 0.5)),
        DVec3::Z,
        &[-0.01; 2],
    );
    assert_depths(&plane(&ROD, at(0.0, 0.0, 0.5)), DVec3::Z, &[0.0]);
    assert_depths(
        &plane(&prism(6, 0.5, 0.3), at(0.0, 0.0, 0.29)),
        DVec3::Z,
        &[0.01; 6],
    );
    assert_depths(
        &plane(&prism(30, 0.5, 0.3), at(0.0, 0.0, 0.29)),
        DVec3::Z,
        &[0.01; 8],
    );
    assert_depths(
        &plane(
            &Shape::Ellipsoid {
                radii: DVec3::new(0.1, 0.2, 0.3),
            },
            at(0.0, 0.0, 0.3),
        ),
        DVec3::Z,
        &[0.0],
    );
    let tilted = turned(DVec3::ZERO, DVec3::Y, FRAC_PI_4);
    let slope = contacts(
        &BALL,
        &at(0.0, 0.0, 0.5 * 2f64.sqrt()),
        &Shape::HalfSpace,
        &tilted,
        MARGIN,
    );
    assert_depths(&slope, tilted.rotation.z_axis, &[0.0]);
}

const CAN: Shape = Shape::Cylinder {
    radius: 0.2,
    half_height: 0.5,
};
const CONE: Shape = Shape::Cone {
    radius: 0.3,
    height: 0.8,
};
const EGG: Shape = Shape::Ellipsoid {
    radii: DVec3::new(0.3, 0.2, 0.1),
};

/// The deepest point's normal and depth.
fn assert_deepest(points: &[ContactPoint], normal: DVec3, depth: f64) {
    let found = deepest(points);
    assert!(
        found.normal.distance(normal) < 1e-7 && (found.depth - depth).abs() < 1e-12,
        "{found:?} {normal} {depth}"
    );
}

#[test]
fn cylinders_stand_lie_and_cross() {
    for gap in [0.0, 0.04, 1e-9, -1e-9, -1e-4, -0.1] {
        let stands = contacts(
            &CAN,
            &at(0.1, 0.0, 1.0 + gap),
            &CAN,
            &Pose::IDENTITY,
            MARGIN,
        );
        assert_deepest(&stands, DVec3::Z, -gap);
        assert!(stands.len() >= 4);
        let beside = contacts(
            &CAN,
            &at(0.4 + gap, 0.0, 0.3),
            &CAN,
            &Pose::IDENTITY,
            MARGIN,
        );
        assert_depths(&beside, DVec3::X, &[-gap; 2]);
        // Sides at right angles.
        let pose = lying(DVec3::new(0.1, 0.4 + gap, 0.2), 0.0);
        let crossed = contacts(&CAN, &pose, &CAN, &Pose::IDENTITY, MARGIN);
        assert_depths(&crossed, DVec3::Y, &[-gap]);
        assert!(
            crossed[0]
                .position
                .distance(DVec3::new(0.0, 0.2 + 0.5 * gap, 0.2))
                < 1e-9
        );
        // A rim stands on a rim, at right angles to it, both at 45 degrees.
        let (upper, lower) = (
            turned(DVec3::ZERO, DVec3::X, FRAC_PI_4),
            turned(DVec3::ZERO, DVec3::Y, FRAC_PI_4),
        );
        let lowest = upper.point(CAN.support(upper.inverse_direction(DVec3::NEG_Z)));
        let highest = lower.point(CAN.support(lower.inverse_direction(DVec3::Z)));
        assert!((highest.z - lowest.z - 1.4 * FRAC_1_SQRT_2).abs() < 1e-15);
        let upper = Pose {
            position: highest - lowest + gap * DVec3::Z,
            ..upper
        };
        if gap > -0.1 {
            let rims = contacts(&CAN, &upper, &CAN, &lower, MARGIN);
            assert_deepest(&rims, DVec3::Z, -gap);
        }
    }
}

#[test]
fn ellipsoids_touch_along_their_axes() {
    for gap in [0.0, 0.04, 1e-9, -1e-9, -1e-4, -0.05] {
        for (axis, reach) in [(DVec3::X, 0.3), (DVec3::Y, 0.2), (DVec3::Z, 0.1)] {
            let pose = |other: f64| Pose {
                position: axis * (reach + other + gap),
                ..Pose::IDENTITY
            };
            let egg = &Pose::IDENTITY;
            let depths = [
                contacts(&BALL, &pose(0.5), &EGG, egg, MARGIN),
                contacts(&EGG, &pose(reach), &EGG, egg, MARGIN),
                contacts(&EGG, &pose(1.0), &CUBE, egg, MARGIN),
            ];
            for points in depths {
                assert_eq!(points.len(), 1);
                assert_deepest(&points, axis, -gap);
            }
        }
    }
}

#[test]
fn a_cone_stands_on_its_base_and_on_its_tip() {
    let upside_down = |z: f64| turned(DVec3::new(0.1, 0.2, z), DVec3::X, PI);
    for gap in [0.0, 0.04, 1e-9, -1e-9, -1e-4] {
        let base = contacts(
            &CONE,
            &at(0.1, 0.2, 1.2 + gap),
            &CUBE,
            &Pose::IDENTITY,
            MARGIN,
        );
        assert_deepest(&base, DVec3::Z, -gap);
        assert_eq!(base.len(), 8);
        let tip = contacts(
            &CONE,
            &upside_down(1.6 + gap),
            &CUBE,
            &Pose::IDENTITY,
            MARGIN,
        );
        assert_depths(&tip, DVec3::Z, &[-gap]);
        assert!(
            tip[0]
                .position
                .distance(DVec3::new(0.1, 0.2, 1.0 + 0.5 * gap))
                < 1e-9
        );
    }
}

/// In one place, and one about the other.
#[test]
fn concentric_shapes_leave_along_their_shortest_way() {
    let here = Pose::IDENTITY;
    let depth = |a: &Shape, b: &Shape| deepest(&contacts(a, &here, b, &here, MARGIN)).depth;
    assert!((depth(&CAN, &CAN) - 0.4).abs() < 1e-12);
    assert!((depth(&EGG, &EGG) - 0.2).abs() < 1e-12);
    assert!((depth(&EGG, &CUBE) - 1.1).abs() < 1e-12);
    assert!((depth(&CAN, &PILL) - 0.4).abs() < 1e-12);
}

/// From millimetres to kilometres, and far from the origin.
#[test]
fn size_and_place_do_not_matter() {
    for size in [1e-3, 1.0, 1e3] {
        let can = Shape::Cylinder {
            radius: 0.2 * size,
            half_height: 0.5 * size,
        };
        let egg = Shape::Ellipsoid {
            radii: size * DVec3::new(0.3, 0.2, 0.1),
        };
        for far in [0.0, 1e3 * size] {
            for overlap in [1e-4, -1e-4] {
                let place = |z: f64| at(far, -far, size * z - size * overlap);
                let points = contacts(&egg, &place(0.6), &can, &place(overlap), 0.01 * size);
                let depth = deepest(&points).depth / size;
                assert!(
                    (depth - overlap).abs() < 1e-11,
                    "{size} {far} {depth} {overlap}"
                );
            }
        }
    }
}

/// Within the rim, beyond the polygon that stands for it.
#[test]
fn a_tip_stands_near_the_rim_of_a_cap() {
    let plate = Shape::Cylinder {
        radius: 1.0,
        half_height: 0.5,
    };
    let (s, c) = libm::sincos(FRAC_PI_4 / 2.0);
    let place = 0.97 * DVec3::new(c, s, 0.0);
    for gap in [1e-3, -1e-3] {
        let tip = turned(place + DVec3::Z * (1.1 + gap), DVec3::X, PI);
        let points = contacts(&CONE, &tip, &plate, &Pose::IDENTITY, MARGIN);
        assert_depths(&points, DVec3::Z, &[-gap]);
        assert!(
            points[0]
                .position
                .distance(place + DVec3::Z * (0.5 + 0.5 * gap))
                < 1e-6
        );
    }
}
