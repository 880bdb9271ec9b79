//! Helpers of the unit tests: pseudo-random poses, the shapes under test, and an independent measure of separation.

use super::{collide, ContactPoint, Posed, Scratch};
use crate::shape::{Hull, Pose, Shape};
use glam::{DQuat, DVec3};
use std::sync::Arc;

/// Linear congruential generator (Knuth's MMIX constants), the same numbers everywhere.
pub struct Random(pub u64);

impl Random {
    /// Uniform in [-1, 1).
    pub fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    pub fn unit(&mut self) -> DVec3 {
        loop {
            let v = DVec3::new(self.next(), self.next(), self.next());
            if v.length_squared() > 0.01 && v.length_squared() < 1.0 {
                return v.normalize();
            }
        }
    }

    pub fn rotation(&mut self) -> DQuat {
        loop {
            let v = [self.next(), self.next(), self.next(), self.next()];
            let q = DQuat::from_array(v);
            if q.length_squared() > 0.01 && q.length_squared() < 1.0 {
                return q.normalize();
            }
        }
    }

    /// Turned anyhow, the position within `reach` on every axis.
    pub fn pose(&mut self, reach: f64) -> Pose {
        let position = DVec3::new(self.next(), self.next(), self.next()) * reach;
        Pose::new(position, self.rotation())
    }
}

/// A pose without rotation.
pub fn at(x: f64, y: f64, z: f64) -> Pose {
    Pose {
        position: DVec3::new(x, y, z),
        ..Pose::IDENTITY
    }
}

/// A pose turned about a unit axis.
pub fn turned(position: DVec3, axis: DVec3, angle: f64) -> Pose {
    let (s, c) = libm::sincos(0.5 * angle);
    Pose::new(
        position,
        DQuat::from_xyzw(s * axis.x, s * axis.y, s * axis.z, c),
    )
}

/// A regular prism along z: hull with n side faces.
pub fn prism(n: u32, radius: f64, half_height: f64) -> Shape {
    let corner = |k: u32, z: f64| {
        let (s, c) = libm::sincos(f64::from(k) * 2.0 * std::f64::consts::PI / f64::from(n));
        DVec3::new(radius * c, radius * s, z)
    };
    let vertices = (0..n)
        .map(|k| corner(k, -half_height))
        .chain((0..n).map(|k| corner(k, half_height)));
    let mut faces: Vec<Vec<u32>> = (0..n)
        .map(|k| vec![k, (k + 1) % n, n + (k + 1) % n, n + k])
        .collect();
    faces.push((0..n).rev().collect());
    faces.push((n..2 * n).collect());
    Shape::Hull(Arc::new(Hull::new(vertices.collect(), &faces).unwrap()))
}

/// One shape of every convex kind, all about half a metre large.
pub fn shapes() -> Vec<Shape> {
    vec![
        Shape::Sphere { radius: 0.5 },
        Shape::Capsule {
            radius: 0.2,
            half_height: 0.4,
        },
        Shape::Rod { half_length: 0.6 },
        Shape::Box {
            half: DVec3::new(0.3, 0.4, 0.5),
        },
        prism(5, 0.5, 0.3),
        Shape::Triangle([
            DVec3::new(-0.4, -0.3, 0.0),
            DVec3::new(0.5, -0.2, 0.0),
            DVec3::new(0.0, 0.6, 0.0),
        ]),
        Shape::Cylinder {
            radius: 0.4,
            half_height: 0.3,
        },
        Shape::Cone {
            radius: 0.4,
            height: 0.9,
        },
        Shape::Ellipsoid {
            radii: DVec3::new(0.3, 0.4, 0.6),
        },
    ]
}

/// Contacts of a pair.
pub fn contacts(
    a: &Shape,
    pose_a: &Pose,
    b: &Shape,
    pose_b: &Pose,
    margin: f64,
) -> Vec<ContactPoint> {
    let mut out = Vec::new();
    collide(
        a,
        pose_a,
        b,
        pose_b,
        margin,
        &mut Scratch::default(),
        &mut out,
    );
    out
}

/// The deepest point.
pub fn deepest(points: &[ContactPoint]) -> ContactPoint {
    points
        .iter()
        .copied()
        .reduce(|p, q| if q.depth > p.depth { q } else { p })
        .unwrap()
}

/// Separation along a unit normal from B to A: lowest point of A minus highest point of B.
pub fn separation(a: &Posed, b: &Posed, normal: DVec3) -> f64 {
    normal.dot(a.support(-normal) - b.support(normal))
}

/// Largest separation over all directions, by a dense sampling (spiral of 600 points, the best 4 refined by a pattern
/// search down to 1e-7 rad): distance of separate shapes, minus the penetration depth of overlapping ones.
pub fn largest_separation(a: &Posed, b: &Posed) -> f64 {
    let golden = std::f64::consts::PI * (3.0 - 5f64.sqrt());
    let spiral = (0..600).map(|k| {
        let z = 1.0 - (2.0 * f64::from(k) + 1.0) / 600.0;
        let (s, c) = libm::sincos(golden * f64::from(k));
        DVec3::new((1.0 - z * z).sqrt() * c, (1.0 - z * z).sqrt() * s, z)
    });
    let mut starts: Vec<(f64, DVec3)> = spiral.map(|n| (separation(a, b, n), n)).collect();
    starts.sort_by(|p, q| q.0.total_cmp(&p.0));
    starts
        .iter()
        .take(4)
        .map(|(_, n)| refined_near(a, b, *n))
        .fold(f64::NEG_INFINITY, f64::max)
}

/// Largest separation that a pattern search finds from a direction.
pub fn refined_near(a: &Posed, b: &Posed, mut normal: DVec3) -> f64 {
    let mut best = separation(a, b, normal);
    let mut step = 0.05;
    while step > 1e-7 {
        let (u, v) = normal.any_orthonormal_pair();
        let ring = (0..12).map(|k| {
            let (s, c) = libm::sincos(f64::from(k) * std::f64::consts::PI / 6.0);
            (normal + step * (c * u + s * v)).normalize()
        });
        let next = ring
            .map(|n| (separation(a, b, n), n))
            .max_by(|p, q| p.0.total_cmp(&q.0))
            .unwrap();
        if next.0 > best {
            (best, normal) = next;
        } else {
            step *= 0.5;
        }
    }
    best
}
