//! From a roughly known contact direction to the exact one.
//!
//! Along a unit normal n from B to A the shapes are apart by
//!
//! ```text
//! s(n) = min over A of n . a - max over B of n . b
//! ```
//!
//! The contact normal is where s has its (local) maximum: the distance of separate shapes, minus the least penetration of
//! overlapping ones. Where faces or straight lines meet, the maximum is a kink at a face's normal or at the common
//! perpendicular of two lines: those few directions are tried outright. Where curved surfaces meet it is smooth, and is
//! climbed like this: move A by t n until it is apart from B, and let GJK find the direction n' between the nearest
//! points. As n' maximises s(m) + t n . m, and n . n' <= 1,
//!
//! ```text
//! s(n') >= s(n) + t (1 - n . n') >= s(n),
//! ```
//!
//! every round climbs, and the fixed point is a maximum of s (a proximal-point iteration, Rockafellar 1976). With
//! penetration p, curvature radius R of the difference of both bodies and a gap d after moving, the error shrinks by
//! (p + d) / (R + d) per round.

use super::ascent::{Cores, Ridge};
use super::{gjk, Posed};
use crate::shape::{Hull, Shape};
use glam::DVec3;

/// A better face or crossing of lines within this angle (cosine of 15 degrees) is what was meant.
const NEARBY: f64 = 0.966;
/// Of hulls with more faces only those within that angle are tried.
const MANY_FACES: usize = 64;
/// A climb this near (cosine) to a ridge is meant to be on it.
const LEVEL: f64 = 1e-3;
/// Ridges this near (cosine) to the best direction are tried.
const BESIDE: f64 = 0.05;
const ROUNDS: usize = 40;
/// Gap after moving A, as a share of the smaller shape: small for speed, large against rounding.
const GAP: f64 = 0.004;
/// Growth of s, as a share of the smaller shape, at which the climb is over.
const CONVERGED: f64 = 1e-13;
/// Share of the shapes' size by which a kink may lose against the climb: rounding.
const ROUNDING: f64 = 1e-11;

/// Share of the larger shape by which supports may miss each other at a peak: how far curved ones move in a trial.
const PEAK: f64 = 2e-12;

/// Candidates under way.
#[derive(Default, Debug)]
pub(crate) struct Buffers {
    normals: Vec<DVec3>,
    ridges_a: Vec<Ridge>,
    ridges_b: Vec<Ridge>,
}

/// The best direction near the given one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Polished {
    /// Unit, from B to A.
    pub normal: DVec3,
    /// s(normal) [m].
    pub separation: f64,
    /// Where A and B are nearest, or deepest in each other, where that is known.
    pub witness: Option<DVec3>,
    /// s was seen to fall on all sides.
    pub is_peak: bool,
}

/// s(n).
pub(crate) fn separation(a: &Posed, b: &Posed, normal: DVec3) -> f64 {
    normal.dot(a.support(-normal) - b.support(normal))
}

/// The maximum of s near `normal`, or one that is higher at a face or at two crossing lines. None when `normal` is no
/// direction.
pub(crate) fn polish(
    a: &Posed,
    b: &Posed,
    normal: DVec3,
    buffers: &mut Buffers,
) -> Option<Polished> {
    let best = ascend(a, b, normal.try_normalize()?, buffers);
    if best.is_peak {
        return Some(best);
    }
    let scale = a.shape.bounding_radius().min(b.shape.bounding_radius());
    Some(best.unless(climb(a, b, best.normal, scale, buffers), scale))
}

/// The same for a unit direction, as far as kinks and Newton's method lead.
pub(crate) fn ascend(a: &Posed, b: &Posed, given: DVec3, buffers: &mut Buffers) -> Polished {
    let (radius_a, radius_b) = (a.shape.bounding_radius(), b.shape.bounding_radius());
    candidates(a, b, given, buffers);
    let kink = best_of(a, b, &buffers.normals);
    let (core_a, core_b) = (Core::of(a.shape), Core::of(b.shape));
    let cores = Cores {
        a: core_a.posed(a),
        b: core_b.posed(b),
        skin: core_a.skin + core_b.skin,
        lift: core_b.skin - core_a.skin,
    };
    let given = Polished::at(a, b, given);
    let best = ascended(&cores, given, kink, radius_a.min(radius_b), buffers);
    let is_peak = cores.is_peak(best.normal, PEAK * radius_a.max(radius_b));
    Polished { is_peak, ..best }
}

/// The best of a direction, the smooth maximum near it, those on ridges near, and a kink; of equals the one that is exact
/// in more ways.
fn ascended(
    cores: &Cores,
    given: Polished,
    kink: Option<Polished>,
    scale: f64,
    buffers: &Buffers,
) -> Polished {
    let smooth = cores.smooth(given.normal);
    let mut best = smooth.map_or(given, |found| found.better(given));
    let from = kink.map_or(best, |kink| best.better(kink)).normal;
    let ridges = buffers.ridges_a.iter().chain(&buffers.ridges_b);
    let near = ridges.filter(|r| (r.axis.dot(from) - r.height).abs() < BESIDE);
    let along = near.filter_map(|ridge| cores.along(ridge, from));
    if let Some(ridge) = along.reduce(Polished::better) {
        best = ridge.unless(best, scale);
    }
    kink.map_or(best, |kink| kink.unless(best, scale))
}

impl Polished {
    fn at(a: &Posed, b: &Posed, normal: DVec3) -> Self {
        Self {
            normal,
            separation: separation(a, b, normal),
            witness: None,
            is_peak: false,
        }
    }

    /// The one that separates better, this one when equal.
    pub fn better(self, other: Self) -> Self {
        if other.separation > self.separation {
            other
        } else {
            self
        }
    }

    /// This exact direction, with the other's witness if that is the same contact, unless the other separates better by
    /// more than rounding.
    fn unless(self, other: Self, scale: f64) -> Self {
        let gain = other.separation - self.separation;
        if gain > ROUNDING * scale {
            other
        } else if gain > -ROUNDING * scale {
            Self {
                witness: other.witness.or(self.witness),
                ..self
            }
        } else {
            self
        }
    }
}

fn best_of(a: &Posed, b: &Posed, normals: &[DVec3]) -> Option<Polished> {
    normals
        .iter()
        .map(|n| Polished::at(a, b, *n))
        .reduce(Polished::better)
}

/// Where A and B meet along the best direction, when that was found without looking.
pub(crate) fn meeting(a: &Posed, b: &Posed, best: &Polished, buffers: &Buffers) -> Option<DVec3> {
    let scale = a.shape.bounding_radius().min(b.shape.bounding_radius());
    climb(a, b, best.normal, scale, buffers).witness
}

/// Spheres and capsules are climbed by their cores, to which s differs by a constant: that is faster and exact.
fn climb(a: &Posed, b: &Posed, start: DVec3, scale: f64, buffers: &Buffers) -> Polished {
    let (core_a, core_b) = (Core::of(a.shape), Core::of(b.shape));
    let (radius_a, radius_b) = (core_a.skin, core_b.skin);
    let (core_a, core_b) = (core_a.posed(a), core_b.posed(b));
    let skin = radius_a + radius_b;
    let mut best = Polished::at(a, b, start);
    let mut step = DVec3::ZERO;
    for _ in 0..ROUNDS {
        let shift = (GAP * scale - best.separation - skin).max(0.0) * best.normal;
        let Some(found) = gjk::nearest(&core_a, &core_b, shift, best.normal) else {
            break;
        };
        let Some(normal) = (found.p - found.q).try_normalize() else {
            break;
        };
        let next = Polished::at(a, b, levelled(a, b, normal, buffers)).better(best);
        let next = extrapolated(a, b, next, best, step);
        let growth = next.separation - best.separation;
        step = next.normal - best.normal;
        let middle = found.p - shift + found.q + (radius_b - radius_a) * normal;
        best = Polished {
            witness: Some(0.5 * middle),
            ..next
        };
        if growth < CONVERGED * scale {
            break;
        }
    }
    best
}

/// Steps of a linearly converging sequence shrink by a ratio q = |step| / |last step|; the rest of the way is
/// q / (1 - q) steps more (Aitken 1926). Taken where it separates better.
fn extrapolated(
    a: &Posed,
    b: &Posed,
    next: Polished,
    best: Polished,
    last_step: DVec3,
) -> Polished {
    let step = next.normal - best.normal;
    let q = step.length() / last_step.length();
    if q.is_nan() || q > 0.95 {
        return next;
    }
    match (next.normal + q / (1.0 - q) * step).try_normalize() {
        Some(normal) => Polished::at(a, b, normal).better(next),
        None => next,
    }
}

/// Turned to a ridge that is near, where that separates better: across a ridge the maximum is a kink, though it may be
/// smooth along it (cylinders side by side).
fn levelled(a: &Posed, b: &Posed, normal: DVec3, buffers: &Buffers) -> DVec3 {
    let ridges = buffers.ridges_a.iter().chain(&buffers.ridges_b);
    let near = ridges.filter(|r| (r.axis.dot(normal) - r.height).abs() < LEVEL);
    let level = near.filter_map(|ridge| Some(ridge.at(ridge.across(normal)?)));
    let better = |best: DVec3, next: DVec3| {
        if separation(a, b, next) > separation(a, b, best) {
            next
        } else {
            best
        }
    };
    level.fold(normal, better)
}

/// A shape without its skin of constant thickness.
pub(crate) struct Core {
    /// None where the shape is its own core.
    segment: Option<Shape>,
    /// Thickness [m].
    pub skin: f64,
}

impl Core {
    pub fn of(shape: &Shape) -> Self {
        let (half_length, skin) = match shape {
            Shape::Sphere { radius } => (0.0, *radius),
            Shape::Capsule {
                radius,
                half_height,
            } => (*half_height, *radius),
            _ => {
                return Self {
                    segment: None,
                    skin: 0.0,
                }
            }
        };
        Self {
            segment: Some(Shape::Rod { half_length }),
            skin,
        }
    }

    /// Where the whole shape is.
    pub fn posed<'a>(&'a self, whole: &Posed<'a>) -> Posed<'a> {
        Posed {
            shape: self.segment.as_ref().unwrap_or(whole.shape),
            ..*whole
        }
    }
}

/// Face normals of both shapes and common perpendiculars of their straight lines, as far as they lie on the side of n.
fn candidates(a: &Posed, b: &Posed, n: DVec3, buffers: &mut Buffers) {
    let Buffers {
        normals,
        ridges_a,
        ridges_b,
    } = buffers;
    normals.clear();
    face_normals(a, -n, normals);
    normals.iter_mut().for_each(|m| *m = -*m);
    face_normals(b, n, normals);
    ridges(a, -n, ridges_a);
    ridges_a.iter_mut().for_each(|r| r.height = -r.height);
    ridges(b, n, ridges_b);
    for p in ridges_a.iter() {
        for q in ridges_b.iter() {
            let crossings = p.crossings(q).into_iter().flatten();
            normals.extend(crossings.filter(|m| m.dot(n) > 0.0));
        }
    }
}

/// Appends the outward normals of flat faces on the side of a direction (world).
fn face_normals(a: &Posed, direction: DVec3, out: &mut Vec<DVec3>) {
    let d = a.pose.inverse_direction(direction);
    let least = match a.shape {
        Shape::Hull(hull) if hull.faces().len() > MANY_FACES => NEARBY,
        _ => 0.0,
    };
    let mut add = |local: DVec3| {
        if local.dot(d) > least {
            out.push(a.pose.direction(local));
        }
    };
    match a.shape {
        Shape::Box { .. } => DVec3::AXES
            .into_iter()
            .for_each(|axis| add(axis * 1f64.copysign(axis.dot(d)))),
        Shape::Cylinder { .. } => add(DVec3::Z * 1f64.copysign(d.z)),
        Shape::Cone { .. } => add(DVec3::NEG_Z),
        Shape::Hull(hull) => hull.faces().iter().for_each(|f| add(f.normal)),
        Shape::Triangle([p, q, r]) => {
            let n = (*q - *p).cross(*r - *p).normalize_or_zero();
            add(n * 1f64.copysign(n.dot(d)));
        }
        _ => {}
    }
}

/// The ridges of a shape's straight lines where it faces a direction (world).
fn ridges(a: &Posed, direction: DVec3, out: &mut Vec<Ridge>) {
    out.clear();
    let d = a.pose.inverse_direction(direction);
    let mut add = |along: DVec3, height: f64| {
        let axis = a.pose.direction(along.normalize_or_zero());
        out.push(Ridge { axis, height });
    };
    match a.shape {
        Shape::Box { .. } => DVec3::AXES.into_iter().for_each(|axis| add(axis, 0.0)),
        Shape::Cylinder { .. } | Shape::Capsule { .. } | Shape::Rod { .. } => add(DVec3::Z, 0.0),
        Shape::Cone { radius, height } => add(
            DVec3::Z,
            radius / (radius * radius + height * height).sqrt(),
        ),
        Shape::Hull(hull) => edges_near(hull, d, |edge| add(edge, 0.0)),
        Shape::Triangle([p, q, r]) => [*q - *p, *r - *q, *p - *r]
            .into_iter()
            .for_each(|edge| add(edge, 0.0)),
        _ => {}
    }
}

/// Edges that leave the supporting vertex, and in small hulls also those that leave its neighbours.
fn edges_near(hull: &Hull, d: DVec3, mut add: impl FnMut(DVec3)) {
    let vertex = |i: u32| {
        hull.vertices()
            .get(i as usize)
            .copied()
            .unwrap_or(DVec3::ZERO)
    };
    let top = hull.support(d);
    let Some(first) = hull.vertices().iter().position(|v| *v == top) else {
        return;
    };
    for &i in hull.neighbours(first) {
        add(vertex(i) - top);
        if hull.faces().len() <= MANY_FACES {
            for &j in hull.neighbours(i as usize) {
                add(vertex(j) - vertex(i));
            }
        }
    }
}
