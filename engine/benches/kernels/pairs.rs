//! Pairs of shapes in 64 poses around contact, answered by the narrow phase.

use std::hint::black_box;
use std::sync::Arc;

use _engine::narrowphase::{collide, Scratch};
use _engine::shape::{Hull, Pose, Shape};
use glam::DVec3;

use super::{Kernel, Random};

const POSES: usize = 64;
/// Points nearer than this are wanted [m].
const MARGIN: f64 = 0.01;

pub const ALL: &[Kernel] = &[
    ("sphere-sphere", || pair(ball(), ball())),
    ("sphere-box", || pair(ball(), cube())),
    ("sphere-hull", || pair(ball(), pebble())),
    ("capsule-capsule", || pair(capsule(), capsule())),
    ("capsule-box", || pair(capsule(), cube())),
    ("box-halfspace", || pair(cube(), Shape::HalfSpace)),
    ("box-box, anyhow", || pair(cube(), cube())),
    ("box-box, laid flat", || flat(cube(), cube())),
    ("hull-hull", || pair(pebble(), pebble())),
    ("hull-box", || pair(pebble(), cube())),
    ("cylinder-cylinder", || pair(can(), can())),
    ("cylinder-box, laid flat", || flat(can(), cube())),
    ("cone-hull", || pair(cone(), pebble())),
    ("ellipsoid-ellipsoid", || pair(egg(), egg())),
    ("ellipsoid-box", || pair(egg(), cube())),
];

fn ball() -> Shape {
    Shape::Sphere { radius: 0.1 }
}

fn cube() -> Shape {
    let half = DVec3::splat(0.1);
    Shape::Box { half }
}

fn capsule() -> Shape {
    Shape::Capsule {
        radius: 0.07,
        half_height: 0.1,
    }
}

fn can() -> Shape {
    Shape::Cylinder {
        radius: 0.1,
        half_height: 0.1,
    }
}

fn cone() -> Shape {
    Shape::Cone {
        radius: 0.12,
        height: 0.25,
    }
}

fn egg() -> Shape {
    let radii = DVec3::new(0.12, 0.1, 0.08);
    Shape::Ellipsoid { radii }
}

/// A prism of seven sides, 16 faces' worth of work: 14 corners, 9 faces, 21 edges.
fn pebble() -> Shape {
    let corner = |k: u32, z: f64| {
        let (s, c) = libm::sincos(f64::from(k) * std::f64::consts::TAU / 7.0);
        DVec3::new(0.12 * c, 0.1 * s, z)
    };
    let rings = [-0.08, 0.08].map(|z| (0..7).map(move |k| corner(k, z)));
    let corners = rings.into_iter().flatten().collect();
    let side = |k: u32| vec![k, (k + 1) % 7, 7 + (k + 1) % 7, 7 + k];
    let mut faces: Vec<Vec<u32>> = (0..7).map(side).collect();
    faces.push((0..7).rev().collect());
    faces.push((7..14).collect());
    Shape::Hull(Arc::new(Hull::new(corners, &faces).expect("a prism")))
}

/// B at the origin, A turned anyhow, at a distance where about half of the pairs touch.
fn pair(a: Shape, b: Shape) -> Box<dyn FnMut()> {
    let mut random = Random(1);
    let poses = (0..POSES).map(|_| {
        let place = random.point().normalize_or(DVec3::Z) * 0.2;
        Pose::new(place.with_z(place.z.abs()), random.rotation())
    });
    run(a, b, poses.collect())
}

/// A on top of B, moved sideways by up to half its width.
fn flat(a: Shape, b: Shape) -> Box<dyn FnMut()> {
    let mut random = Random(2);
    let poses = (0..POSES).map(|_| Pose {
        position: (random.point() * 0.05).with_z(0.2 - 1e-4),
        ..Pose::IDENTITY
    });
    run(a, b, poses.collect())
}

fn run(a: Shape, b: Shape, poses: Vec<Pose>) -> Box<dyn FnMut()> {
    let (mut scratch, mut out) = (Scratch::default(), Vec::new());
    Box::new(move || {
        for pose in &poses {
            out.clear();
            let at_origin = &Pose::IDENTITY;
            collide(&a, pose, &b, at_origin, MARGIN, &mut scratch, &mut out);
            black_box(&out);
        }
    })
}
