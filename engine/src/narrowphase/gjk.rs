//! Nearest points of two separate convex shapes (Gilbert, Johnson and Keerthi 1988).
//!
//! The distance of A and B is that of the origin from the set of all differences a - b. Supports of this set build a
//! simplex around its point nearest to the origin; every round adds the support towards the origin and drops the
//! corners that are no longer needed (Ericson 2005, sections 5.1.5, 5.1.6 and 9.5).

use super::Posed;
use glam::DVec3;

const ROUNDS: usize = 60;
/// Relative gap between upper and lower bound of the distance at which the search is over.
const CONVERGED: f64 = 1e-12;
/// Share of the distance up to which it is told at least.
const SHARE: f64 = 0.1;
/// A simplex whose volume is below this share of its size cubed is flat.
const FLAT: f64 = 1e-13;

/// Nearest points, p on A and q on B.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Nearest {
    pub p: DVec3,
    pub q: DVec3,
}

/// A corner of the simplex: w = p - q.
#[derive(Clone, Copy, Default)]
struct Corner {
    w: DVec3,
    p: DVec3,
    q: DVec3,
}

/// Corners with the weights of the point nearest to the origin.
#[derive(Clone, Copy, Default)]
struct Simplex {
    corners: [Corner; 4],
    weights: [f64; 4],
    count: usize,
}

/// What the search for the nearest points found.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Gap {
    /// The shapes are at least as far apart as was asked.
    Beyond,
    /// They are apart.
    Open(Nearest),
    /// They overlap or touch.
    Closed,
}

/// Nearest points of A, moved by `shift`, and B, searched from a direction that roughly points from B to A; None when
/// they overlap or touch. `p` is returned on the moved A.
pub(crate) fn nearest(a: &Posed, b: &Posed, shift: DVec3, guess: DVec3) -> Option<Nearest> {
    match gap(a, b, shift, guess, f64::INFINITY, 0.0) {
        Gap::Open(nearest) => Some(nearest),
        _ => None,
    }
}

/// The same, ended as soon as a plane shows that the shapes are at least `limit` [m] apart, or that they are as far apart
/// as the points found, but for a tenth of it and for `fine` [m].
pub(crate) fn gap(a: &Posed, b: &Posed, shift: DVec3, guess: DVec3, limit: f64, fine: f64) -> Gap {
    let corner = |direction: DVec3| {
        let (p, q) = (a.support(-direction) + shift, b.support(direction));
        Corner { w: p - q, p, q }
    };
    let mut simplex = Simplex::of(&[(corner(guess), 1.0)]);
    let mut v = simplex.corners[0].w;
    let mut apart = false;
    for _ in 0..ROUNDS {
        let next = corner(v);
        // Times |v|, the gap along v, which the distance is not below.
        let shown = v.dot(next.w);
        if shown > 0.0 && shown * shown >= limit * limit * v.length_squared() {
            return Gap::Beyond;
        }
        let enough = CONVERGED.max((fine / v.length()).min(SHARE));
        let improvement = v.length_squared() - shown;
        if improvement.is_nan() || improvement <= enough * v.length_squared() {
            break;
        }
        apart |= shown > 0.0;
        let Some(grown) = simplex.with(next).reduced(apart) else {
            return Gap::Closed;
        };
        let nearer = grown.point();
        if nearer.length_squared() >= v.length_squared() {
            break;
        }
        simplex = grown;
        v = nearer;
    }
    if v.length_squared() > 0.0 {
        Gap::Open(simplex.nearest())
    } else {
        Gap::Closed
    }
}

impl Simplex {
    fn of(weighted: &[(Corner, f64)]) -> Self {
        let mut simplex = Self::default();
        for (corner, weight) in weighted.iter().filter(|(_, weight)| *weight > 0.0).take(4) {
            simplex.corners[simplex.count] = *corner;
            simplex.weights[simplex.count] = *weight;
            simplex.count += 1;
        }
        simplex
    }

    fn with(mut self, corner: Corner) -> Self {
        if self.count < 4 {
            self.corners[self.count] = corner;
            self.count += 1;
        }
        self
    }

    fn point(&self) -> DVec3 {
        self.sum(|c| c.w)
    }

    fn nearer(self, other: Self) -> Self {
        if other.point().length_squared() < self.point().length_squared() {
            other
        } else {
            self
        }
    }

    fn nearest(&self) -> Nearest {
        Nearest {
            p: self.sum(|c| c.p),
            q: self.sum(|c| c.q),
        }
    }

    fn sum(&self, part: impl Fn(&Corner) -> DVec3) -> DVec3 {
        let weighted = self.corners.iter().zip(self.weights).take(self.count);
        weighted.map(|(c, weight)| weight * part(c)).sum()
    }

    /// The corners that carry the point nearest to the origin; None when the origin is inside, which cannot be when the
    /// shapes are known to be apart.
    fn reduced(&self, apart: bool) -> Option<Self> {
        match self.corners[..self.count] {
            [a, b] => Some(of_segment(a, b)),
            [a, b, c] => Some(of_triangle(a, b, c)),
            [a, b, c, d] => of_tetrahedron([a, b, c, d], apart),
            _ => Some(*self),
        }
    }
}

fn of_segment(a: Corner, b: Corner) -> Simplex {
    let d = b.w - a.w;
    let length = d.length_squared();
    let t = if length > 0.0 {
        (-a.w.dot(d) / length).clamp(0.0, 1.0)
    } else {
        0.0
    };
    Simplex::of(&[(a, 1.0 - t), (b, t)])
}

/// Inside where the origin lies to the left of all three edges, else on one of the edges.
///
/// Weights as areas, n . (edge x way from the edge to the origin): differences of nearby corners come first, so that
/// small triangles lose no digits (the products of Ericson's section 5.1.5 do).
fn of_triangle(a: Corner, b: Corner, c: Corner) -> Simplex {
    let normal = (b.w - a.w).cross(c.w - a.w);
    let area = |p: Corner, q: Corner| -normal.dot((q.w - p.w).cross(p.w));
    let weights = [area(b, c), area(c, a), area(a, b)];
    let sum = weights[0] + weights[1] + weights[2];
    if weights.iter().all(|weight| *weight > 0.0) && sum > 0.0 {
        return Simplex::of(&[
            (a, weights[0] / sum),
            (b, weights[1] / sum),
            (c, weights[2] / sum),
        ]);
    }
    let edges = [of_segment(a, b), of_segment(b, c), of_segment(c, a)];
    edges
        .into_iter()
        .reduce(Simplex::nearer)
        .unwrap_or_default()
}

/// Nearest of the faces that have the origin outside; of all faces when it must be outside, or when the tetrahedron is
/// flat.
fn of_tetrahedron(corners: [Corner; 4], apart: bool) -> Option<Simplex> {
    const FACES: [[usize; 4]; 4] = [[0, 1, 2, 3], [0, 3, 1, 2], [0, 2, 3, 1], [1, 3, 2, 0]];
    let outside = FACES.into_iter().filter_map(|[i, j, k, opposite]| {
        let (a, b, c) = (corners[i], corners[j], corners[k]);
        let (ab, ac, ad) = (b.w - a.w, c.w - a.w, corners[opposite].w - a.w);
        let normal = ab.cross(ac);
        let height = normal.dot(ad);
        let flat = height.abs() <= FLAT * ab.length() * ac.length() * ad.length();
        (apart || flat || -normal.dot(a.w) * height <= 0.0).then(|| of_triangle(a, b, c))
    });
    outside.reduce(Simplex::nearer)
}

#[cfg(test)]
mod tests {
    use super::super::testing::{at, shapes, Random};
    use super::*;
    use crate::shape::{Pose, Shape};

    #[test]
    fn distances_with_closed_forms() {
        let ball = Shape::Sphere { radius: 0.5 };
        let cube = Shape::Box {
            half: DVec3::splat(1.0),
        };
        let cylinder = Shape::Cylinder {
            radius: 1.0,
            half_height: 0.5,
        };
        let distance = |a: &Shape, pose: Pose, b: &Shape| {
            let (a, b) = (
                Posed { shape: a, pose },
                Posed {
                    shape: b,
                    pose: Pose::IDENTITY,
                },
            );
            nearest(&a, &b, DVec3::ZERO, DVec3::new(0.3, 0.4, 0.2))
                .map_or(0.0, |n| n.p.distance(n.q))
        };
        // The search ends at a relative gap of 1e-12 in the square.
        assert!((distance(&ball, at(3.0, 3.0, 1.0), &cube) - (8f64.sqrt() - 0.5)).abs() < 1e-11);
        assert!((distance(&ball, at(3.0, 4.0, 0.5), &cylinder) - 3.5).abs() < 1e-11);
        assert!((distance(&cube, at(3.0, 0.2, 0.1), &cube) - 1.0).abs() < 1e-12);
        assert_eq!(distance(&cube, at(0.5, 0.2, 0.1), &cube), 0.0);
    }

    /// The distance is attained at points of both shapes and no plane separates by more.
    #[test]
    fn upper_and_lower_bound_agree() {
        let mut random = Random(21);
        let all = shapes();
        for (a, b) in all.iter().flat_map(|a| all.iter().map(move |b| (a, b))) {
            for _ in 0..100 {
                let (a, b) = (
                    Posed {
                        shape: a,
                        pose: random.pose(1.5),
                    },
                    Posed {
                        shape: b,
                        pose: random.pose(1.5),
                    },
                );
                let Some(found) = nearest(&a, &b, DVec3::ZERO, random.unit()) else {
                    continue;
                };
                let v = found.p - found.q;
                if v.length() < 1e-3 {
                    continue;
                }
                let n = v.normalize();
                let separation = n.dot(a.support(-n) - b.support(n));
                // Measured 3e-8: the direction is known to about the root of the rounding error.
                assert!((separation - v.length()).abs() < 1e-7, "{a:?} {b:?}");
            }
        }
    }
}
