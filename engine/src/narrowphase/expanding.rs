//! The least overlap of two convex shapes, sought in all directions (expanding polytope, van den Bergen 2001).
//!
//! All differences b - a make a convex set D. Along n it reaches as far as the shapes overlap,
//!
//! ```text
//! h(n) = max over B of n . b - min over A of n . a,
//! ```
//!
//! and the least h is how deep the origin lies in D. A polytope inside D knows a lower bound: along no direction through
//! one of its faces is h less than that face is away from the origin. So the nearest face is looked at first: D's farthest
//! point along its normal either lies on the face, and h is known there, or becomes a corner of the polytope. Once no
//! face is nearer than the least h yet, nothing is left to find.
//!
//! On curved surfaces that would take faces without end. From a face that tells its h to a fiftieth somebody climbs to the
//! best direction around, and faces near directions where that has been done are passed over.

use super::polish::Polished;
use glam::DVec3;

/// Faces that are looked at.
const ROUNDS: usize = 200;
/// Climbs at most.
const CLIMBS: usize = 16;
/// A face tells where to climb from when it is off by this share of its h,
const ROUGH: f64 = 0.02;
/// and is passed over near directions explored when it is off by this,
const PASSED: f64 = 2e-4;
/// in either case by this share of the smaller shape.
const FINE: f64 = 1e-6;
/// Directions this near (cosine; 8 degrees) lead to the same maximum.
const SAME: f64 = 0.99;
/// A climb that ends within this of where it began (cosine; 18 degrees) has looked around there.
const AROUND: f64 = 0.95;
/// Corners and faces are told apart by this share of the smaller shape.
const ROUNDING: f64 = 1e-9;

/// A triangle of the polytope.
#[derive(Clone, Copy, Debug)]
struct Facet {
    corners: [u32; 3],
    /// Unit, outward.
    normal: DVec3,
    /// Of its plane from the origin; negative when the origin is outside [m].
    distance: f64,
    /// Not yet looked at.
    open: bool,
}

/// A polytope inside D.
#[derive(Default, Debug)]
pub(crate) struct Polytope {
    corners: Vec<DVec3>,
    facets: Vec<Facet>,
    horizon: Vec<[u32; 2]>,
    explored: Vec<DVec3>,
}

impl Polytope {
    /// The best of the directions to which `climb` leads, one of which is known. `farthest` is D's farthest point along a
    /// direction; `scale` is the size of the smaller shape [m], `skin` what both shapes are thicker than those whose
    /// differences D is [m].
    pub fn least_overlap(
        &mut self,
        mut best: Polished,
        (scale, skin): (f64, f64),
        farthest: impl Fn(DVec3) -> DVec3,
        mut climb: impl FnMut(DVec3) -> Polished,
    ) -> Polished {
        let rounding = ROUNDING * scale;
        self.explored.clear();
        if best.is_peak {
            self.explored.push(best.normal);
        }
        let mut climbs = 0;
        if !self.begin(best.normal, &farthest) {
            return best;
        }
        for _ in 0..ROUNDS {
            let Some((k, facet)) = self.nearest() else {
                break;
            };
            let least = -best.separation - skin - rounding;
            if facet.distance >= least {
                break;
            }
            let corner = farthest(facet.normal);
            let h = facet.normal.dot(corner);
            let slack = h - facet.distance;
            let explored = self.is_explored(facet.normal) && h >= least;
            let share = if explored { PASSED } else { ROUGH };
            let mut told = slack <= share * h.abs() + FINE * scale;
            if told && !explored && climbs < CLIMBS {
                climbs += 1;
                let found = climb(facet.normal);
                best = best.better(found);
                let around = found.is_peak && found.normal.dot(facet.normal) > AROUND;
                told = around || slack <= rounding;
                if told {
                    self.explored.extend([facet.normal, found.normal]);
                }
            }
            if told {
                self.facets[k].open = false;
            } else {
                self.grow(corner, rounding);
            }
        }
        best
    }

    fn is_explored(&self, normal: DVec3) -> bool {
        self.explored.iter().any(|n| n.dot(normal) > SAME)
    }

    /// The open face that is nearest to the origin.
    fn nearest(&self) -> Option<(usize, Facet)> {
        let open = self.facets.iter().copied().enumerate().filter(|f| f.1.open);
        open.reduce(|p, q| if q.1.distance < p.1.distance { q } else { p })
    }

    /// A tetrahedron: the ends of D along a direction, and what is farther on either side of their line, and of the
    /// triangle that this makes. False when D is flat.
    fn begin(&mut self, along: DVec3, farthest: &impl Fn(DVec3) -> DVec3) -> bool {
        let farther = |n: DVec3, from: DVec3| {
            let (p, q) = (farthest(n), farthest(-n));
            if n.dot(p - from) >= n.dot(from - q) {
                p
            } else {
                q
            }
        };
        let (a, b) = (farthest(along), farthest(-along));
        let Some(axis) = (a - b).try_normalize() else {
            return false;
        };
        let c = farther(axis.any_orthonormal_vector(), a);
        let Some(normal) = (b - a).cross(c - a).try_normalize() else {
            return false;
        };
        let d = farther(normal, a);
        self.corners.clear();
        self.corners.extend([a, b, c, d]);
        self.facets.clear();
        let up = normal.dot(d - a) > 0.0;
        for [i, j, k] in [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]] {
            self.put(if up { [i, k, j] } else { [i, j, k] });
        }
        true
    }

    /// Takes in a point: the faces that see it make way for a fan around it.
    fn grow(&mut self, point: DVec3, rounding: f64) {
        let apex = u32::try_from(self.corners.len()).unwrap_or(0);
        self.corners.push(point);
        self.horizon.clear();
        let mut k = 0;
        while k < self.facets.len() {
            let facet = self.facets[k];
            let height = facet.normal.dot(point) - facet.distance;
            if height > 1e-3 * rounding {
                let [p, q, r] = facet.corners;
                for edge in [[p, q], [q, r], [r, p]] {
                    self.leave(edge);
                }
                self.facets.swap_remove(k);
            } else {
                k += 1;
            }
        }
        for k in 0..self.horizon.len() {
            let [i, j] = self.horizon[k];
            self.put([i, j, apex]);
        }
    }

    /// An edge of a face that goes: inner when its other face goes, too.
    fn leave(&mut self, [i, j]: [u32; 2]) {
        match self.horizon.iter().position(|edge| *edge == [j, i]) {
            Some(inner) => {
                self.horizon.swap_remove(inner);
            }
            None => self.horizon.push([i, j]),
        }
    }

    /// A face with its corners counter-clockwise seen from outside; one without a plane is none to look at.
    fn put(&mut self, corners: [u32; 3]) {
        let [a, b, c] = corners.map(|i| self.corners[i as usize]);
        let normal = (b - a).cross(c - a).normalize_or_zero();
        self.facets.push(Facet {
            corners,
            normal,
            distance: normal.dot(a),
            open: normal != DVec3::ZERO,
        });
    }
}
