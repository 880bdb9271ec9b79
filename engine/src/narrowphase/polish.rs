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

use super::{gjk, Posed};
use crate::shape::{Hull, Shape};
use glam::DVec3;

/// A better face or crossing of lines within this angle (cosine of 15 degrees) is what was meant.
const NEARBY: f64 = 0.966;
/// Of hulls with more faces only those within that angle are tried.
const MANY_FACES: usize = 64;
/// A line this near (cosine) to a right angle with the normal is meant to be at a right angle.
const LEVEL: f64 = 1e-3;
const ROUNDS: usize = 40;
/// Gap after moving A, as a share of the smaller shape: small for speed, large against rounding.
const GAP: f64 = 0.004;
/// Growth of s, as a share of the smaller shape, at which the climb is over.
const CONVERGED: f64 = 1e-13;
/// Share of the shapes' size by which a kink may lose against the climb: rounding.
const ROUNDING: f64 = 1e-11;

/// Candidates under way.
#[derive(Default, Debug)]
pub(crate) struct Buffers {
    normals: Vec<DVec3>,
    lines_a: Vec<DVec3>,
    lines_b: Vec<DVec3>,
}

/// The best direction near the given one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Polished {
    /// Unit, from B to A.
    pub normal: DVec3,
    /// s(normal) [m].
    pub separation: f64,
    /// Where A and B are nearest, or deepest in each other; None when no climb was possible.
    pub witness: Option<DVec3>,
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
    let given = normal.try_normalize()?;
    let scale = a.shape.bounding_radius().min(b.shape.bounding_radius());
    candidates(a, b, given, buffers);
    let Some(kink) = best_of(a, b, &buffers.normals) else {
        return Some(climb(a, b, given, scale, buffers));
    };
    let from_kink = || kink.unless(climb(a, b, kink.normal, scale, buffers), scale);
    if kink.separation >= separation(a, b, given) && kink.normal.dot(given) > NEARBY {
        return Some(from_kink());
    }
    let climbed = climb(a, b, given, scale, buffers);
    Some(if kink.separation > climbed.separation + ROUNDING * scale {
        from_kink()
    } else {
        kink.unless(climbed, scale)
    })
}

impl Polished {
    fn at(a: &Posed, b: &Posed, normal: DVec3) -> Self {
        Self {
            normal,
            separation: separation(a, b, normal),
            witness: None,
        }
    }

    /// The one that separates better, this one when equal.
    fn better(self, other: Self) -> Self {
        if other.separation > self.separation {
            other
        } else {
            self
        }
    }

    /// This exact direction with the other's witness, unless the other separates better by more than rounding.
    fn unless(self, climbed: Self, scale: f64) -> Self {
        if climbed.separation > self.separation + ROUNDING * scale {
            climbed
        } else {
            Self {
                witness: climbed.witness,
                ..self
            }
        }
    }
}

fn best_of(a: &Posed, b: &Posed, normals: &[DVec3]) -> Option<Polished> {
    normals
        .iter()
        .map(|n| Polished::at(a, b, *n))
        .reduce(Polished::better)
}

/// Spheres and capsules are climbed by their cores, to which s differs by a constant: that is faster and exact.
fn climb(a: &Posed, b: &Posed, start: DVec3, scale: f64, buffers: &Buffers) -> Polished {
    let ((shape_a, radius_a), (shape_b, radius_b)) = (core(a.shape), core(b.shape));
    let (core_a, core_b) = (
        Posed {
            shape: &shape_a,
            ..*a
        },
        Posed {
            shape: &shape_b,
            ..*b
        },
    );
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

/// Turned at right angles to a straight line that nearly lies so, where that separates better: along a line the maximum
/// is a kink, though it may be smooth across it (cylinders side by side).
fn levelled(a: &Posed, b: &Posed, normal: DVec3, buffers: &Buffers) -> DVec3 {
    let lines = buffers.lines_a.iter().chain(&buffers.lines_b);
    let near = lines.filter(|line| line.dot(normal).abs() < LEVEL);
    let level = near.filter_map(|line| (normal - line.dot(normal) * *line).try_normalize());
    let better = |best: DVec3, next: DVec3| {
        if separation(a, b, next) > separation(a, b, best) {
            next
        } else {
            best
        }
    };
    level.fold(normal, better)
}

/// The shape without its skin of constant thickness, and that thickness.
fn core(shape: &Shape) -> (Shape, f64) {
    match shape {
        Shape::Sphere { radius } => (Shape::Rod { half_length: 0.0 }, *radius),
        Shape::Capsule {
            radius,
            half_height,
        } => (
            Shape::Rod {
                half_length: *half_height,
            },
            *radius,
        ),
        _ => (shape.clone(), 0.0),
    }
}

/// Face normals of both shapes and common perpendiculars of their straight lines, as far as they lie on the side of n.
fn candidates(a: &Posed, b: &Posed, n: DVec3, buffers: &mut Buffers) {
    let Buffers {
        normals,
        lines_a,
        lines_b,
    } = buffers;
    normals.clear();
    face_normals(a, -n, normals);
    normals.iter_mut().for_each(|m| *m = -*m);
    face_normals(b, n, normals);
    lines(a, -n, lines_a);
    lines(b, n, lines_b);
    for p in lines_a.iter() {
        for q in lines_b.iter() {
            if let Some(m) = p.cross(*q).try_normalize() {
                let m = if m.dot(n) < 0.0 { -m } else { m };
                if m.dot(n) > 0.0 {
                    normals.push(m);
                }
            }
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

/// Unit directions (world) of the straight lines on the surface where it faces a direction.
fn lines(a: &Posed, direction: DVec3, out: &mut Vec<DVec3>) {
    out.clear();
    let d = a.pose.inverse_direction(direction);
    match a.shape {
        Shape::Box { .. } => out.extend(DVec3::AXES),
        Shape::Cylinder { .. } | Shape::Capsule { .. } | Shape::Rod { .. } => out.push(DVec3::Z),
        Shape::Cone { radius, height } => {
            let radial = DVec3::new(d.x, d.y, 0.0).normalize_or_zero();
            out.push(*radius * radial - DVec3::new(0.0, 0.0, *height));
        }
        Shape::Hull(hull) => edges_near(hull, d, out),
        Shape::Triangle([p, q, r]) => out.extend([*q - *p, *r - *q, *p - *r]),
        _ => {}
    }
    out.iter_mut()
        .for_each(|line| *line = a.pose.direction(line.normalize_or_zero()));
}

/// Edges that leave the supporting vertex, and in small hulls also those that leave its neighbours.
fn edges_near(hull: &Hull, d: DVec3, out: &mut Vec<DVec3>) {
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
        out.push(vertex(i) - top);
        if hull.faces().len() <= MANY_FACES {
            out.extend(
                hull.neighbours(i as usize)
                    .iter()
                    .map(|&j| vertex(j) - vertex(i)),
            );
        }
    }
}
