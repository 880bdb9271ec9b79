//! Two features laid over one another along a normal.
//!
//! Both are written in a frame (u, v, n): lateral coordinates x, y and a height h along the contact normal. Where they
//! cover each other laterally, the gap is height on A minus height on B, exact for points, segments and planar
//! polygons.

use super::Sink;
use glam::{DMat3, DVec3};

/// Lateral distances below this share of the features' size are rounding.
const ROUNDING: f64 = 1e-11;
/// Of two faces that lie on one another, a corner that stands out by less than this share of the other's edge is not
/// cut off: edges that are flush but for some nanometres cross anywhere along them, in another place every step.
const FLUSH: f64 = 1e-7;
/// Slope up to which a face counts as lying: what stands out by FLUSH is then off by a thousandth of that in height.
const LEVEL: f64 = 1e-3;
/// Corners of a clipped polygon that stand out by less than this share of its size are no corners.
const STRAIGHT: f64 = 1e-3;
/// Segments within this angle (sine) are parallel and touch along a line.
const PARALLEL: f64 = 2e-3;
/// A polygon whose projection keeps less than this share of its area is seen edge-on.
const EDGE_ON: f64 = 1e-6;

/// A plane as a height over the lateral coordinates, or a line along a segment.
struct Surface {
    origin: DVec3,
    slope_x: f64,
    slope_y: f64,
}

impl Surface {
    fn height(&self, p: DVec3) -> f64 {
        self.origin.z + self.slope_x * (p.x - self.origin.x) + self.slope_y * (p.y - self.origin.y)
    }

    fn is_level(&self) -> bool {
        self.slope_x * self.slope_x + self.slope_y * self.slope_y <= LEVEL * LEVEL
    }

    /// Height over a polygon's plane: N . (p - o) = 0 solved for z, with Newell's normal N.
    fn of_polygon(points: &[DVec3]) -> Self {
        let n = newell(points);
        Self {
            origin: points[0],
            slope_x: -n.x / n.z,
            slope_y: -n.y / n.z,
        }
    }

    /// Height along a segment, constant across it.
    fn of_segment(p: DVec3, q: DVec3) -> Self {
        let d = q - p;
        let rise = d.z / (d.x * d.x + d.y * d.y);
        Self {
            origin: p,
            slope_x: d.x * rise,
            slope_y: d.y * rise,
        }
    }
}

/// Pushes the corners of the region where feature `a` (above, along the normal) covers feature `b`. The features come
/// in world coordinates and are overwritten.
pub(crate) fn overlay(
    a: &mut Vec<DVec3>,
    b: &mut Vec<DVec3>,
    normal: DVec3,
    buffer: &mut Vec<DVec3>,
    sink: &mut Sink,
) {
    let (u, v) = normal.any_orthonormal_pair();
    let to_world = DMat3::from_cols(u, v, normal);
    let to_local = to_world.transpose();
    a.iter_mut()
        .chain(b.iter_mut())
        .for_each(|p| *p = to_local * *p);
    simplify(a, -1.0);
    simplify(b, 1.0);
    let mut emit = |x: f64, y: f64, above: f64, below: f64| {
        sink.push(
            to_world * DVec3::new(x, y, 0.5 * (above + below)),
            normal,
            below - above,
        );
    };
    match (a.len(), b.len()) {
        (0, _) | (_, 0) => {}
        (1, 1..=2) | (2, 1) => point_over(a, b, &mut emit),
        (1, _) => point_over_polygon(a[0], b, |p, h| emit(p.x, p.y, p.z, h)),
        (_, 1) => point_over_polygon(b[0], a, |p, h| emit(p.x, p.y, h, p.z)),
        (2, 2) => segments(a, b, &mut emit),
        (2, _) => segment_over_polygon(a, b, |p, h| emit(p.x, p.y, p.z, h)),
        (_, 2) => segment_over_polygon(b, a, |p, h| emit(p.x, p.y, h, p.z)),
        _ => polygons(a, b, buffer, &mut emit),
    }
}

/// Turns a polygon counter-clockwise; one seen edge-on becomes the edge nearest to the other side, a segment seen
/// end-on its nearer end. `toward` is +1 when the other feature lies above, -1 when below.
fn simplify(points: &mut Vec<DVec3>, toward: f64) {
    if points.len() > 2 {
        let n = newell(points);
        if n.z.abs() <= EDGE_ON * n.length() {
            keep_nearest_edge(points, toward);
        } else if n.z < 0.0 {
            points.reverse();
        }
    }
    if let [p, q] = points[..] {
        let d = q - p;
        if d.x * d.x + d.y * d.y <= EDGE_ON * EDGE_ON * d.length_squared() {
            points[0] = if (q.z - p.z) * toward > 0.0 { q } else { p };
            points.truncate(1);
        }
    }
}

fn keep_nearest_edge(points: &mut Vec<DVec3>, toward: f64) {
    let count = points.len();
    let height = |i: usize| toward * (points[i].z + points[(i + 1) % count].z);
    let best = (1..count).fold(0, |best, i| if height(i) > height(best) { i } else { best });
    let edge = [points[best], points[(best + 1) % count]];
    points.clear();
    points.extend(edge);
}

/// A point and a point or segment: the gap between the nearest heights, at the point (midway between two points).
fn point_over(a: &[DVec3], b: &[DVec3], emit: &mut impl FnMut(f64, f64, f64, f64)) {
    let above = a.iter().map(|p| p.z).fold(f64::INFINITY, f64::min);
    let below = b.iter().map(|p| p.z).fold(f64::NEG_INFINITY, f64::max);
    let p = match (a, b) {
        ([p], [q]) => (*p + *q) * 0.5,
        ([p], _) => *p,
        _ => b[0],
    };
    emit(p.x, p.y, above, below);
}

/// A point inside a polygon.
fn point_over_polygon(p: DVec3, polygon: &[DVec3], mut emit: impl FnMut(DVec3, f64)) {
    let inside = |side: Side| side.keeps(side.inside(p));
    if sides(polygon, ROUNDING).all(inside) {
        emit(p, Surface::of_polygon(polygon).height(p));
    }
}

/// Crossing segments touch in one point, parallel ones along the part that they share (2 points).
fn segments(a: &[DVec3], b: &[DVec3], emit: &mut impl FnMut(f64, f64, f64, f64)) {
    let (da, db) = (a[1] - a[0], b[1] - b[0]);
    let cross = da.x * db.y - da.y * db.x;
    let (on_a, on_b) = (
        Surface::of_segment(a[0], a[1]),
        Surface::of_segment(b[0], b[1]),
    );
    let lengths = lateral_length(da) * lateral_length(db);
    if cross.abs() > PARALLEL * lengths {
        let r = b[0] - a[0];
        let s = unit_interval((r.x * db.y - r.y * db.x) / cross);
        let t = unit_interval((r.x * da.y - r.y * da.x) / cross);
        let (p, q) = (a[0] + s * da, b[0] + t * db);
        emit(0.5 * (p.x + q.x), 0.5 * (p.y + q.y), p.z, q.z);
        return;
    }
    let along =
        |p: DVec3| ((p.x - a[0].x) * da.x + (p.y - a[0].y) * da.y) / (da.x * da.x + da.y * da.y);
    let (t0, t1) = (along(b[0]), along(b[1]));
    let first = unit_interval(t0.min(t1));
    let last = unit_interval(t0.max(t1));
    for t in [first, last]
        .into_iter()
        .take(if last - first > ROUNDING { 2 } else { 1 })
    {
        let p = a[0] + t * da;
        let q = b[0] + unit_interval((t - t0) / (t1 - t0)) * db;
        let mid = (p + q) * 0.5;
        emit(mid.x, mid.y, on_a.height(mid), on_b.height(mid));
    }
}

/// The part of a segment inside a polygon: Cyrus and Beck 1978 (Ericson 2005, section 5.3.8).
fn segment_over_polygon(segment: &[DVec3], polygon: &[DVec3], mut emit: impl FnMut(DVec3, f64)) {
    let (p, d) = (segment[0], segment[1] - segment[0]);
    let surface = Surface::of_polygon(polygon);
    let (mut first, mut last) = (0.0f64, 1.0f64);
    for side in sides(polygon, ROUNDING) {
        let (start, end) = (side.inside(p), side.inside(p + d));
        let crossing = unit_interval(start / (start - end));
        match (side.keeps(start), side.keeps(end)) {
            (true, true) => {}
            (false, false) => return,
            (false, true) => first = first.max(crossing),
            (true, false) => last = last.min(crossing),
        }
    }
    if first > last + ROUNDING {
        return;
    }
    let ends = [first, last.max(first)];
    for t in ends
        .into_iter()
        .take(if last - first > ROUNDING { 2 } else { 1 })
    {
        let point = p + t * d;
        emit(point, surface.height(point));
    }
}

/// Intersection of two convex polygons: Sutherland and Hodgman 1974 (Ericson 2005, section 8.3.4).
fn polygons(
    a: &mut Vec<DVec3>,
    b: &[DVec3],
    buffer: &mut Vec<DVec3>,
    emit: &mut impl FnMut(f64, f64, f64, f64),
) {
    let (on_a, on_b) = (Surface::of_polygon(a), Surface::of_polygon(b));
    let level = on_a.is_level() && on_b.is_level();
    for side in sides(b, if level { FLUSH } else { ROUNDING }) {
        if !a.iter().all(|p| side.keeps(side.inside(*p))) {
            cut(a, &side, buffer);
            std::mem::swap(a, buffer);
        }
    }
    tidy(a, buffer);
    for p in buffer.iter() {
        emit(p.x, p.y, on_a.height(*p), on_b.height(*p));
    }
}

/// Leaves out corners that lie on the line between their neighbours, but for [`STRAIGHT`] of the polygon's size: faces
/// that are all but aligned cross in points that jump along their edges from step to step, and carry nothing that the
/// true corners do not.
fn tidy(from: &[DVec3], to: &mut Vec<DVec3>) {
    to.clear();
    let Some(&last) = from.last() else { return };
    let squares = from.iter().map(|p| lateral_square(*p - last));
    let small = STRAIGHT * STRAIGHT * squares.fold(0.0, f64::max);
    let mut before = last;
    for (i, &p) in from.iter().enumerate() {
        let next = from.get(i + 1).unwrap_or(&from[0]);
        let (chord, offset) = (*next - before, p - before);
        let (square, area) = (
            lateral_square(chord),
            chord.x * offset.y - chord.y * offset.x,
        );
        if area * area > small * square || square <= small {
            to.push(p);
            before = p;
        }
    }
    if to.len() < 3 {
        to.clear();
        to.extend_from_slice(from);
    }
}

/// Edges of a counter-clockwise polygon; lateral distances below this share of theirs count as none.
fn sides(polygon: &[DVec3], rounding: f64) -> impl Iterator<Item = Side> + '_ {
    let last = polygon.last().zip(polygon.first());
    let pairs = polygon.windows(2).map(|pair| (&pair[0], &pair[1]));
    pairs
        .chain(last)
        .map(move |(p, q)| Side::new(*p, *q, rounding))
}

/// The part of a polygon on the inner side of a line.
fn cut(from: &[DVec3], side: &Side, to: &mut Vec<DVec3>) {
    to.clear();
    let Some(mut before) = from.last().copied() else {
        return;
    };
    let mut height_before = side.inside(before);
    for &p in from {
        let height = side.inside(p);
        if side.keeps(height) != side.keeps(height_before) {
            let t = unit_interval(height_before / (height_before - height));
            to.push(before + t * (p - before));
        }
        if side.keeps(height) {
            to.push(p);
        }
        before = p;
        height_before = height;
    }
}

/// A polygon's edge as a line in the lateral plane; inside is to the left.
struct Side {
    corner: DVec3,
    along: DVec3,
    rounding: f64,
}

impl Side {
    fn new(corner: DVec3, next: DVec3, rounding: f64) -> Self {
        let along = next - corner;
        Self {
            corner,
            along,
            rounding: rounding * (along.x * along.x + along.y * along.y),
        }
    }

    /// Distance to the left, times the edge's length.
    fn inside(&self, p: DVec3) -> f64 {
        self.along.x * (p.y - self.corner.y) - self.along.y * (p.x - self.corner.x)
    }

    /// Whether a point at that distance counts as inside.
    fn keeps(&self, inside: f64) -> bool {
        inside >= -self.rounding
    }
}

fn newell(points: &[DVec3]) -> DVec3 {
    points
        .windows(2)
        .map(|w| (w[0] - points[0]).cross(w[1] - points[0]))
        .sum()
}

fn lateral_square(d: DVec3) -> f64 {
    d.x * d.x + d.y * d.y
}

fn lateral_length(d: DVec3) -> f64 {
    lateral_square(d).sqrt()
}

fn unit_interval(t: f64) -> f64 {
    t.clamp(0.0, 1.0)
}
