//! A convex shape against a fixed surface of triangles, taken exactly.
//!
//! Triangle by triangle, with two rules that make the triangles act as one surface. A contact on an edge or corner
//! stands only where the surface around it stays below the contact plane; else the triangle's own normal is taken, so
//! that inner edges of flat and concave regions do not catch. And triangles push outward only: those that have the
//! shape's centre behind them are left alone, unless no triangle has it in front, i.e. the centre is inside the solid.
//!
//! Depth is measured over the triangle that the shape passes through: a tip that slants under a neighbouring triangle
//! counts as deep as it is at the common edge.

use super::{
    capsule, closest, gjk, overlay, polish, reduce, sat, ContactPoint, Posed, Scratch, Sink,
};
use crate::shape::{Pose, Shape, TriangleFeature, TriangleMesh};
use glam::DVec3;

/// Contact points of one shape with one mesh at most.
const LIMIT: usize = 32;
/// Corners this near to the highest, as a share of the triangle's size, belong to the touched feature.
const SUPPORT_TOLERANCE: f64 = 1e-6;
/// Points of neighbouring triangles nearer than this share of the shape's size are one.
const RESOLUTION: f64 = 1e-6;
/// Triangles within this cosine of the way out push together when the centre is inside the solid.
const SAME_WAY: f64 = 0.99;

/// A mesh at its place.
#[derive(Clone, Copy)]
pub(crate) struct PosedMesh<'a> {
    pub mesh: &'a TriangleMesh,
    pub pose: Pose,
}

impl PosedMesh<'_> {
    fn corners(&self, triangle: u32) -> [DVec3; 3] {
        self.mesh.corners(triangle).map(|c| self.pose.point(c))
    }

    fn normal(&self, triangle: u32) -> DVec3 {
        self.pose.direction(self.mesh.normal(triangle))
    }

    /// Whether the surface around the part of a triangle that is farthest along a normal stays below the plane there,
    /// and the normal does not point into the solid.
    fn allows(&self, triangle: u32, normal: DVec3) -> bool {
        normal.dot(self.normal(triangle)) >= -SUPPORT_TOLERANCE
            && self.mesh.is_supporting(
                triangle,
                touched(&self.corners(triangle), normal),
                self.pose.inverse_direction(normal),
            )
    }

    /// Height of a point above the triangle's plane.
    fn height(&self, triangle: u32, p: DVec3) -> f64 {
        self.normal(triangle).dot(p - self.corners(triangle)[0])
    }
}

/// A triangle's contact: the points `first..end` of the list, with the normal and depth of the deepest.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Way {
    triangle: u32,
    first: usize,
    end: usize,
    normal: DVec3,
    depth: f64,
}

/// All triangles near a convex shape.
pub(crate) fn collide(a: &Posed, b: &PosedMesh, scratch: &mut Scratch, sink: &mut Sink) {
    let mut near = std::mem::take(&mut scratch.triangles);
    let mut ways = std::mem::take(&mut scratch.ways);
    near.clear();
    ways.clear();
    nearby(a, b, sink.margin, &mut near);
    let start = sink.out.len();
    let center = a.pose.point(a.shape.center());
    for &t in near.iter().filter(|&&t| b.height(t, center) > 0.0) {
        let first = sink.out.len();
        touch(a, b, t, scratch, sink);
        ways.extend(Way::of(t, first, sink.out));
    }
    drop_resolved(a, b, &ways, start, scratch, sink);
    if sink.out.len() == start {
        from_inside(a, b, &near, scratch, sink);
    }
    scratch.triangles = near;
    scratch.ways = ways;
    reduce_points(a, sink.out, start, &mut scratch.kept);
}

impl Way {
    fn of(triangle: u32, first: usize, points: &[ContactPoint]) -> Option<Self> {
        let new = points.get(first..)?;
        let deepest = new
            .iter()
            .reduce(|p, q| if q.depth > p.depth { q } else { p })?;
        Some(Self {
            triangle,
            first,
            end: points.len(),
            normal: deepest.normal,
            depth: deepest.depth,
        })
    }
}

/// Drops the points of triangles whose overlap ends by itself when another, shallower contact is pushed apart: the
/// flank of a block into which a body sinks from above, near the edge, is no way out.
fn drop_resolved(
    a: &Posed,
    b: &PosedMesh,
    ways: &[Way],
    start: usize,
    scratch: &mut Scratch,
    sink: &mut Sink,
) {
    let mut kept = std::mem::take(&mut scratch.points);
    kept.clear();
    for way in ways {
        let resolved =
            way.depth > 0.0 && ways.iter().any(|other| resolves(a, b, other, way, scratch));
        if !resolved {
            kept.extend_from_slice(&sink.out[way.first..way.end]);
        }
    }
    sink.out.truncate(start);
    sink.out.extend_from_slice(&kept);
    scratch.points = kept;
}

/// Whether pushing the shape out of `other` takes it out of the deeper `way` too.
fn resolves(a: &Posed, b: &PosedMesh, other: &Way, way: &Way, scratch: &mut Scratch) -> bool {
    if other.depth <= 0.0 || other.depth >= way.depth || other.normal.dot(way.normal) > SAME_WAY {
        return false;
    }
    let mut pose = a.pose;
    pose.position += other.depth * other.normal;
    let allowance = RESOLUTION * a.shape.bounding_radius();
    direction(&Posed { pose, ..*a }, b, way.triangle, scratch, -allowance).is_none()
}

/// Triangles whose boxes reach into the box around a shape.
fn nearby(a: &Posed, b: &PosedMesh, margin: f64, out: &mut Vec<u32>) {
    let box_of_a = a.shape.aabb(&b.pose.relative(&a.pose));
    b.mesh.overlapping(&box_of_a.expanded(margin), out);
}

/// Keeps at most 32 of the points from `start` on.
fn reduce_points(
    a: &Posed,
    points: &mut Vec<ContactPoint>,
    start: usize,
    kept: &mut Vec<reduce::Kept>,
) {
    let resolution = RESOLUTION * a.shape.bounding_radius();
    reduce::by_normal(points, start, LIMIT, resolution, kept);
}

/// One triangle with the centre in front.
fn touch(a: &Posed, b: &PosedMesh, triangle: u32, scratch: &mut Scratch, sink: &mut Sink) {
    if let Some(normal) = direction(a, b, triangle, scratch, sink.margin) {
        along(a, b, triangle, normal, scratch, sink);
    }
}

/// The contact with one triangle along a normal, or along the triangle's own where the surface does not allow that one.
fn along(
    a: &Posed,
    b: &PosedMesh,
    triangle: u32,
    normal: DVec3,
    scratch: &mut Scratch,
    sink: &mut Sink,
) {
    let allowed = b.allows(triangle, normal);
    let normal = if allowed { normal } else { b.normal(triangle) };
    let shape = Shape::Triangle(b.corners(triangle));
    let piece = Posed {
        shape: &shape,
        pose: Pose::IDENTITY,
    };
    if !overlay(a, &piece, normal, scratch, sink) && allowed {
        nearest_supports(a, &piece, normal, sink);
    }
}

/// The direction from the triangle to the shape; None when they are farther apart than the margin. While they overlap
/// only directions count in which the surface lets the shape out: the triangle's own normal alone when no edge of it
/// is convex.
fn direction(
    a: &Posed,
    b: &PosedMesh,
    triangle: u32,
    scratch: &mut Scratch,
    margin: f64,
) -> Option<DVec3> {
    let shape = Shape::Triangle(b.corners(triangle));
    let piece = Posed {
        shape: &shape,
        pose: Pose::IDENTITY,
    };
    if !b.mesh.has_convex_edge(triangle) {
        let normal = b.normal(triangle);
        return (polish::separation(a, &piece, normal) < margin).then_some(normal);
    }
    let allowed = |normal| b.allows(triangle, normal);
    match a.shape {
        Shape::Sphere { radius } => {
            let nearest = closest::closest(piece.shape, a.pose.position)?;
            (nearest.distance < radius + margin).then_some(nearest.normal)
        }
        Shape::Capsule { .. } | Shape::Rod { .. } => {
            capsule::approach(a, &piece, scratch, margin, allowed).map(|found| found.normal)
        }
        Shape::Box { .. } | Shape::Hull(_) | Shape::Triangle(_) => {
            let solid = scratch.store_a.polytope(a)?;
            let triangle = scratch.store_b.polytope(&piece)?;
            let edges = &mut scratch.edges;
            sat::separating_axis(&solid, &triangle, margin, edges, allowed).map(|axis| axis.normal)
        }
        _ => curved(a, &piece, scratch, margin, allowed),
    }
}

/// For curved shapes: the nearest points while apart, else the best of the ways out that start at the triangle's normal
/// and across its edges.
fn curved(
    a: &Posed,
    piece: &Posed,
    scratch: &mut Scratch,
    margin: f64,
    allowed: impl Fn(DVec3) -> bool,
) -> Option<DVec3> {
    let scale = a.shape.bounding_radius();
    let toward = a.pose.position - piece.support(DVec3::ZERO);
    if let Some(found) = gjk::nearest(a, piece, DVec3::ZERO, toward) {
        let distance = found.p.distance(found.q);
        if distance >= margin {
            return None;
        }
        if distance > SUPPORT_TOLERANCE * scale {
            return Some((found.p - found.q) / distance);
        }
    }
    let Scratch {
        store_b, polish, ..
    } = scratch;
    let triangle = store_b.polytope(piece)?;
    let normals = triangle.faces.iter().map(|face| face.normal);
    let starts = normals.filter(|n| allowed(*n));
    let ways = starts.map(|start| match polish::polish(a, piece, start, polish) {
        Some(way) if allowed(way.normal) => (way.separation, way.normal),
        _ => (polish::separation(a, piece, start), start),
    });
    let best = ways.reduce(|best, way| if way.0 > best.0 { way } else { best });
    best.filter(|(separation, _)| *separation < margin)
        .map(|(_, normal)| normal)
}

/// Part of a triangle that is farthest along a normal.
fn touched(corners: &[DVec3; 3], normal: DVec3) -> TriangleFeature {
    let heights = corners.map(|c| normal.dot(c));
    let top = heights.into_iter().fold(f64::NEG_INFINITY, f64::max);
    let size = corners[1].distance(corners[0]) + corners[2].distance(corners[0]);
    let on_top = heights.map(|h| h >= top - SUPPORT_TOLERANCE * size);
    match on_top {
        [true, false, false] => TriangleFeature::Corner(0),
        [false, true, false] => TriangleFeature::Corner(1),
        [false, false, true] => TriangleFeature::Corner(2),
        [true, true, false] => TriangleFeature::Edge(0),
        [false, true, true] => TriangleFeature::Edge(1),
        [true, false, true] => TriangleFeature::Edge(2),
        _ => TriangleFeature::Face,
    }
}

/// Where features that touch in an edge or corner miss each other by rounding.
fn nearest_supports(a: &Posed, piece: &Posed, normal: DVec3, sink: &mut Sink) {
    let (p, q) = (a.support(-normal), piece.support(normal));
    let gap = normal.dot(p - q);
    let beside = (p - q - gap * normal).length();
    if beside <= SUPPORT_TOLERANCE * a.shape.bounding_radius() {
        sink.push((p + q) * 0.5, normal, -gap);
    }
}

/// The centre is inside: out through the triangle over it that is nearest, and all that face the same way.
fn from_inside(a: &Posed, b: &PosedMesh, near: &[u32], scratch: &mut Scratch, sink: &mut Sink) {
    let center = a.pose.point(a.shape.center());
    let depth = |t: u32| {
        let height = b.height(t, center);
        let on_plane = center - height * b.normal(t);
        let over = closest::closest(&Shape::Triangle(b.corners(t)), on_plane);
        let beside = over.map_or(f64::INFINITY, |c| c.distance);
        (beside <= RESOLUTION * a.shape.bounding_radius()).then_some(-height)
    };
    let ways = near.iter().filter_map(|&t| Some((depth(t)?, t)));
    let Some((_, out)) = ways.reduce(|best, way| if way.0 < best.0 { way } else { best }) else {
        return;
    };
    for &t in near
        .iter()
        .filter(|&&t| b.mesh.normal(t).dot(b.mesh.normal(out)) > SAME_WAY)
    {
        let shape = Shape::Triangle(b.corners(t));
        overlay(
            a,
            &Posed {
                shape: &shape,
                pose: Pose::IDENTITY,
            },
            b.normal(t),
            scratch,
            sink,
        );
    }
}
