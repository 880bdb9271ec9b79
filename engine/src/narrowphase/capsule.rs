//! Capsules and rods (capsules of radius 0): segments with a skin.

use super::closest::{closest, on_segment};
use super::polytope::Polytope;
use super::{reduce, sat, Posed, Scratch, Sink};
use crate::shape::Shape;
use glam::DVec3;

/// Segments within this angle (sine) touch along a line.
const PARALLEL: f64 = 0.05;
/// Shares of the size that are rounding.
const ROUNDING: f64 = 1e-10;

/// A segment and the radius around it.
#[derive(Clone, Copy)]
struct Core {
    ends: [DVec3; 2],
    radius: f64,
}

impl Core {
    fn of(a: &Posed) -> Self {
        let (half, radius) = match a.shape {
            Shape::Capsule {
                radius,
                half_height,
            } => (*half_height, *radius),
            Shape::Rod { half_length } => (*half_length, 0.0),
            _ => (0.0, 0.0),
        };
        let arm = a.pose.rotation.z_axis * half;
        Self {
            ends: [a.pose.position + arm, a.pose.position - arm],
            radius,
        }
    }

    fn along(&self) -> DVec3 {
        self.ends[1] - self.ends[0]
    }
}

/// Capsule or rod against capsule or rod: the nearest points of both segments; nearly parallel ones also touch
/// at both ends of the part that they share.
pub(crate) fn against_capsule(a: &Posed, b: &Posed, kept: &mut Vec<reduce::Kept>, sink: &mut Sink) {
    let (a, b) = (Core::of(a), Core::of(b));
    let (da, db) = (a.along(), b.along());
    let cross = da.cross(db);
    let fallback = perpendicular(cross, da, db);
    let start = sink.out.len();
    let [p, q] = nearest_of_segments(a.ends, b.ends);
    between(p, q, &a, &b, fallback, sink);
    if cross.length_squared() <= PARALLEL * PARALLEL * da.length_squared() * db.length_squared() {
        let over_b = a.ends.into_iter().filter_map(|p| Some([p, beside(p, &b)?]));
        let under_a = b.ends.into_iter().filter_map(|q| Some([beside(q, &a)?, q]));
        over_b
            .chain(under_a)
            .for_each(|[p, q]| between(p, q, &a, &b, fallback, sink));
    }
    reduce::spread(
        sink.out,
        start,
        3,
        ROUNDING * (da.length() + db.length()),
        kept,
    );
}

/// The nearest point of a segment, if it is not one of its ends seen askew.
fn beside(p: DVec3, core: &Core) -> Option<DVec3> {
    let d = core.along();
    let t = (p - core.ends[0]).dot(d) / d.length_squared();
    (t > -ROUNDING && t < 1.0 + ROUNDING).then(|| core.ends[0] + t.clamp(0.0, 1.0) * d)
}

/// Contact of balls about p and q: the surfaces lie at p - r_A n and q + r_B n.
fn between(p: DVec3, q: DVec3, a: &Core, b: &Core, fallback: DVec3, sink: &mut Sink) {
    let normal = (p - q).try_normalize().unwrap_or(fallback);
    let position = 0.5 * (p + q + (b.radius - a.radius) * normal);
    sink.push(position, normal, a.radius + b.radius - p.distance(q));
}

/// Some direction across both segments, for segments that cross in a point.
fn perpendicular(cross: DVec3, da: DVec3, db: DVec3) -> DVec3 {
    let along = if da.length_squared() > 0.0 { da } else { db };
    let across = || {
        along
            .try_normalize()
            .map_or(DVec3::Z, |d| d.any_orthonormal_vector())
    };
    cross.try_normalize().unwrap_or_else(across)
}

/// Nearest points of two segments (Ericson 2005, section 5.1.9): minimise |p1 + s d1 - p2 - t d2|^2, clamp s, then t,
/// then s again.
pub(crate) fn nearest_of_segments([p1, q1]: [DVec3; 2], [p2, q2]: [DVec3; 2]) -> [DVec3; 2] {
    let (d1, d2, r) = (q1 - p1, q2 - p2, p1 - p2);
    let (a, e, b) = (d1.length_squared(), d2.length_squared(), d1.dot(d2));
    let determinant = a * e - b * b;
    let s = if determinant > 1e-14 * a * e {
        ((b * d2.dot(r) - d1.dot(r) * e) / determinant).clamp(0.0, 1.0)
    } else {
        0.0
    };
    let on_second = on_segment(p1 + s * d1, p2, q2);
    let on_first = on_segment(on_second, p1, q1);
    [on_first, on_segment(on_first, p2, q2)]
}

/// Direction in which a capsule or rod is nearest to (or least inside) a polytope, with the nearest points while the
/// segment is outside.
pub(crate) struct Approach {
    pub normal: DVec3,
    pub points: Option<[DVec3; 2]>,
}

/// Inside: separating axes. Outside, the nearest points are an end of the segment and any point of the polytope, or a
/// point of the segment and one of an edge.
pub(crate) fn approach(
    a: &Posed,
    b: &Posed,
    scratch: &mut Scratch,
    margin: f64,
    allowed: impl Fn(DVec3) -> bool,
) -> Option<Approach> {
    let core = Core::of(a);
    let reach = margin + core.radius;
    if let Shape::Box { half } = b.shape {
        let pair = nearest_to_box(core.ends.map(|end| b.pose.inverse_point(end)), *half);
        let size = core.along().length() + 2.0 * half.length() + core.radius;
        if pair[0].distance(pair[1]) > ROUNDING * size {
            return Approach::between(pair.map(|p| b.pose.point(p)), reach);
        }
    }
    let rod = scratch.store_a.polytope(a)?;
    let polytope = scratch.store_b.polytope(b)?;
    let axis = sat::separating_axis(&rod, &polytope, reach, &mut scratch.edges, allowed)?;
    if axis.separation > ROUNDING * (rod.size + polytope.size + core.radius) {
        let pair = nearest_outside(core.ends, b, &polytope, axis.separation);
        return Approach::between(pair, reach);
    }
    Some(Approach {
        normal: axis.normal,
        points: None,
    })
}

impl Approach {
    /// From nearest points, unless they are farther apart than `reach`.
    fn between([p, q]: [DVec3; 2], reach: f64) -> Option<Self> {
        (p.distance(q) < reach).then(|| Self {
            normal: (p - q).normalize_or_zero(),
            points: Some([p, q]),
        })
    }
}

/// Nearest points of a segment and a box, in the box's frame.
///
/// A point x(s) = p + s d of the segment lies beyond the box by e(s) = x - clamp(x). The squared distance |e|^2 is convex;
/// half its slope, d . e(s), is piecewise linear and never falls, with kinks where the segment crosses the planes of the
/// faces. They bracket its zero, which interpolation between them finds.
fn nearest_to_box([start, end]: [DVec3; 2], half: DVec3) -> [DVec3; 2] {
    let d = end - start;
    let at = |s: f64| {
        let x = start + s * d;
        [x, x.max(-half).min(half)]
    };
    let slope = |s: f64| {
        let [x, on_box] = at(s);
        d.dot(x - on_box)
    };
    let (mut low, mut high) = ((0.0, slope(0.0)), (1.0, slope(1.0)));
    if low.1 >= 0.0 {
        return at(0.0);
    }
    if high.1 <= 0.0 {
        return at(1.0);
    }
    let kinks = [(half - start) / d, (-half - start) / d];
    for s in kinks.into_iter().flat_map(|k| k.to_array()) {
        if s > low.0 && s < high.0 {
            let bound = (s, slope(s));
            *(if bound.1 < 0.0 { &mut low } else { &mut high }) = bound;
        }
    }
    at(low.0 + (high.0 - low.0) * (low.1 / (low.1 - high.1)))
}

/// Nearest points of a segment and a polytope that are apart by at least `separation`: nobody is nearer than an end of
/// the segment at that distance.
fn nearest_outside(
    ends: [DVec3; 2],
    b: &Posed,
    polytope: &Polytope,
    separation: f64,
) -> [DVec3; 2] {
    let local = ends.map(|end| b.pose.inverse_point(end));
    let to_solid = local.into_iter().filter_map(|end| {
        let nearest = closest(b.shape, end)?;
        Some([end, end - nearest.distance * nearest.normal])
    });
    let distance = |pair: &[DVec3; 2]| pair[0].distance_squared(pair[1]);
    let nearer = |p, q| if distance(&q) < distance(&p) { q } else { p };
    let of_ends = to_solid.reduce(nearer).unwrap_or(local);
    let bound = separation * (1.0 + ROUNDING);
    let pair = if distance(&of_ends) <= bound * bound {
        of_ends
    } else {
        let edges = polytope.edges.iter();
        edges
            .map(|edge| nearest_of_segments(local, polytope.ends(edge)))
            .fold(of_ends, nearer)
    };
    pair.map(|p| b.pose.point(p))
}

/// Capsule or rod against box, hull or triangle.
pub(crate) fn against_polytope(a: &Posed, b: &Posed, scratch: &mut Scratch, sink: &mut Sink) {
    let Some(found) = approach(a, b, scratch, sink.margin, |_| true) else {
        return;
    };
    if !super::overlay(a, b, found.normal, scratch, sink) {
        touch(a, b, &found, sink);
    }
}

/// The nearest points alone, where the features miss each other: a corner or an edge beside the segment.
fn touch(a: &Posed, b: &Posed, found: &Approach, sink: &mut Sink) {
    match found.points {
        Some([p, q]) => {
            let radius = Core::of(a).radius;
            let surface = p - radius * found.normal;
            sink.push(0.5 * (surface + q), found.normal, radius - p.distance(q));
        }
        None => super::overlapping_supports(a, b, found.normal, sink),
    }
}

#[cfg(test)]
mod tests {
    use super::super::polytope::Store;
    use super::super::testing::Random;
    use super::*;

    /// Against the nearest points of the ends and of all edges; also segments along the axes, through and in the box.
    #[test]
    fn nearest_points_of_segment_and_box() {
        let mut random = Random(12);
        let half = DVec3::new(0.3, 0.4, 0.5);
        let shape = Shape::Box { half };
        let posed = Posed {
            shape: &shape,
            pose: crate::shape::Pose::IDENTITY,
        };
        let mut store = Store::default();
        let cube = store.polytope(&posed).unwrap();
        let mut apart = 0;
        for k in 0..20_000 {
            let start = random.pose(1.0).position;
            let along = match k % 4 {
                0 => random.next() * DVec3::AXES[k / 4 % 3],
                _ => random.pose(1.0).position,
            };
            let ends = [start, start + along];
            let [p, q] = nearest_to_box(ends, half);
            let [u, v] = nearest_outside(ends, &posed, &cube, 0.0);
            assert!(
                q.abs().cmple(half).all() && on_segment(p, ends[0], ends[1]).distance(p) < 1e-15
            );
            // Of segments through the box `nearest_outside` knows nothing.
            let outside = p.distance(q) > 0.0;
            assert!(
                !outside || (p.distance(q) - u.distance(v)).abs() < 1e-15,
                "{ends:?}"
            );
            apart += i32::from(outside);
        }
        assert!(apart > 5000);
    }
}
