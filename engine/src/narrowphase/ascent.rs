//! To the best direction by Newton's method, where it is smooth or lies on a ridge.
//!
//! Along a unit normal n the shapes are s(n) = n . w apart, w = p - q, with A's support p and B's q in this direction
//! (`polish`). Supports are farthest points, so that turning n by u changes s by u . w only, and
//!
//! ```text
//! ds = u . w,   d2s = -u . (s + K) u,   K u = -dw,
//! ```
//!
//! with K the sum of both surfaces' radii of curvature. Two steps from a hundredth of a radian are exact.
//!
//! Where a shape has a straight line, all of it is farthest in directions at right angles: s has a ridge there. These
//! directions make a circle about an axis k, k . n = c: an edge's own direction with c = 0, or the axis of a cylinder or a
//! cone. Along it s is smooth again, and Newton's method has one unknown.

use super::polish::Polished;
use super::Posed;
use glam::{DVec2, DVec3};

const ROUNDS: usize = 8;
/// Turns below this are the last ones: the next would be its square.
const LAST: f64 = 1e-8;
/// Turns above this lead elsewhere.
const FAR: f64 = 0.5;
/// Turns (radians) by which a peak is tried.
const TRIAL: f64 = 1e-6;

/// Directions n with axis . n = height.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ridge {
    /// Unit.
    pub axis: DVec3,
    pub height: f64,
}

impl Ridge {
    /// The part of a direction on the ridge that is across its axis; None along the axis.
    pub fn across(&self, n: DVec3) -> Option<DVec3> {
        let across = (n - n.dot(self.axis) * self.axis).try_normalize()?;
        Some((1.0 - self.height * self.height).sqrt() * across)
    }

    pub fn at(&self, across: DVec3) -> DVec3 {
        self.height * self.axis + across
    }

    /// The two directions on both ridges, n = x k + y l +- z k x l: x + y (k . l) = c, x (k . l) + y = d.
    pub fn crossings(&self, other: &Self) -> Option<[DVec3; 2]> {
        let cos = self.axis.dot(other.axis);
        let cross = self.axis.cross(other.axis);
        let sin2 = cross.length_squared();
        let (x, y) = (
            self.height - other.height * cos,
            other.height - self.height * cos,
        );
        let level = (x * self.axis + y * other.axis) / sin2;
        let rest = 1.0 - level.length_squared();
        let up = (rest / sin2).sqrt() * cross;
        (sin2 > 1e-20 && rest > 0.0).then(|| [level + up, level - up])
    }
}

/// Two shapes without their skins, and how thick these are together.
pub(crate) struct Cores<'a> {
    pub a: Posed<'a>,
    pub b: Posed<'a>,
    pub skin: f64,
    /// From B's surface to the middle of both along the normal, by how much B's skin is the thicker one [m].
    pub lift: f64,
}

impl Cores<'_> {
    /// Supports of A and B.
    fn supports(&self, n: DVec3) -> [DVec3; 2] {
        [self.a.support(-n), self.b.support(n)]
    }

    fn separation(&self, n: DVec3) -> f64 {
        let [p, q] = self.supports(n);
        n.dot(p - q)
    }

    /// K u.
    fn turn(&self, n: DVec3, u: DVec3) -> DVec3 {
        turn(&self.a, -n, u) + turn(&self.b, n, u)
    }

    fn found(&self, normal: DVec3, [p, q]: [DVec3; 2]) -> Polished {
        Polished {
            normal,
            separation: self.separation(normal) - self.skin,
            witness: Some(0.5 * (p + q + self.lift * normal)),
            is_peak: false,
        }
    }

    /// The smooth maximum of s near a unit direction.
    pub fn smooth(&self, start: DVec3) -> Option<Polished> {
        let mut n = start;
        for _ in 0..ROUNDS {
            let [p, q] = self.supports(n);
            let w = p - q;
            let s = n.dot(w);
            let (u, v) = n.any_orthonormal_pair();
            let (of_u, of_v) = (self.turn(n, u), self.turn(n, v));
            let (uu, uv, vv) = (u.dot(of_u) + s, u.dot(of_v), v.dot(of_v) + s);
            let determinant = uu * vv - uv * uv;
            if !(uu > 0.0 && determinant > 0.0) {
                return None;
            }
            let (x, y) = (u.dot(w), v.dot(w));
            let step = ((vv * x - uv * y) * u + (uu * y - uv * x) * v) / determinant;
            let turned = step.length();
            if turned.is_nan() || turned > FAR {
                return None;
            }
            n = (n + step).normalize();
            if turned < LAST {
                return Some(self.found(n, [p, q]));
            }
        }
        None
    }

    /// The maximum of s along a ridge near a unit direction.
    pub fn along(&self, ridge: &Ridge, start: DVec3) -> Option<Polished> {
        let mut across = ridge.across(start)?;
        let reach = across.length();
        for _ in 0..ROUNDS {
            let n = ridge.at(across);
            let tangent = ridge.axis.cross(across);
            let [p, q] = self.supports(n);
            let slope = tangent.dot(p - q);
            let bend = across.dot(p - q) + tangent.dot(self.turn(n, tangent));
            let turned = slope / bend;
            if bend.is_nan() || bend <= 0.0 || turned.abs() > FAR {
                return None;
            }
            across = reach * (across + turned * tangent).normalize();
            if turned.abs() < LAST {
                let n = ridge.at(across);
                return Some(self.found(n, self.on_both_sides(n, ridge.axis.cross(n).cross(n))));
            }
        }
        None
    }

    /// The points of both supports on a ridge that face each other, between those to either side of it.
    fn on_both_sides(&self, n: DVec3, aside: DVec3) -> [DVec3; 2] {
        let [p, q] = self.supports(n + TRIAL * aside);
        let [r, t] = self.supports(n - TRIAL * aside);
        let (there, here) = (aside.dot(p - q), aside.dot(r - t));
        let share = if here > there {
            (here / (here - there)).clamp(0.0, 1.0)
        } else {
            0.5
        };
        [r + share * (p - r), t + share * (q - t)]
    }

    /// Whether no turn from a direction makes s greater: where all round it the lateral parts of w have zero among them.
    ///
    /// For a turn u they are the farthest against u, so that going round they make a convex polygon counter-clockwise.
    pub fn is_peak(&self, n: DVec3, rounding: f64) -> bool {
        const DIAGONAL: f64 = std::f64::consts::FRAC_1_SQRT_2;
        const ROUND: [(f64, f64); 8] = [
            (1.0, 0.0),
            (DIAGONAL, DIAGONAL),
            (0.0, 1.0),
            (-DIAGONAL, DIAGONAL),
            (-1.0, 0.0),
            (-DIAGONAL, -DIAGONAL),
            (0.0, -1.0),
            (DIAGONAL, -DIAGONAL),
        ];
        let (u, v) = n.any_orthonormal_pair();
        let lateral = ROUND.map(|(x, y)| {
            let [p, q] = self.supports(n + TRIAL * (x * u + y * v));
            DVec2::new(u.dot(p - q), v.dot(p - q))
        });
        let first = lateral[0];
        let next = lateral.iter().skip(1).chain([&first]);
        let mut sides = lateral.iter().zip(next);
        sides.all(|(p, q)| p.perp_dot(*q) >= -rounding * (p.distance(*q) + rounding))
            && lateral
                .iter()
                .any(|p| p.dot(first) <= rounding * (first.length() + rounding))
    }
}

fn turn(a: &Posed, direction: DVec3, change: DVec3) -> DVec3 {
    let pose = &a.pose;
    let (d, u) = (
        pose.inverse_direction(direction),
        pose.inverse_direction(change),
    );
    pose.direction(a.shape.support_turn(d, u))
}
