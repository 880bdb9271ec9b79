//! Contacts between two posed shapes: which points, which direction, how deep.
//!
//! Every pair is answered in the same two strides: find the direction in which the shapes are least apart or least
//! overlapped (closed form, projection onto a solid, separating axes, or by how far the shapes reach), then lay the features that face each other
//! in this direction over one another (`features`, `clip`) and measure each point's gap along it.

mod ascent;
mod box_box;
mod capsule;
mod clip;
mod closest;
mod convex;
mod expanding;
mod features;
mod gjk;
mod halfspace;
mod large_hulls;
mod polish;
mod polytope;
mod protruding;
mod reduce;
mod sat;
mod seams;
mod sphere;
mod triangle_mesh;

use crate::shape::{Pose, Shape};
use glam::DVec3;
use triangle_mesh::PosedMesh;

/// Share of the smaller shape by which a depth may be off.
const ROUNDING: f64 = 1e-9;
/// Points nearer to each other than this share of the smaller shape are one.
const RESOLUTION: f64 = 1e-6;

/// Pairs of edges from which on hulls are climbed instead of tried edge by edge.
const MANY_PAIRS: usize = 20_000;

/// One point of a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactPoint {
    /// Midway between both surfaces, world [m].
    pub position: DVec3,
    /// Unit vector from B to A, world.
    pub normal: DVec3,
    /// Positive where the shapes overlap, minus the gap where they do not [m].
    pub depth: f64,
}

/// Memory that is used again from pair to pair, so that a steady simulation allocates nothing.
#[derive(Default, Debug)]
pub struct Scratch {
    feature_a: Vec<DVec3>,
    feature_b: Vec<DVec3>,
    store_a: polytope::Store,
    store_b: polytope::Store,
    edges: sat::Edges,
    clip: Vec<DVec3>,
    heights: Vec<f64>,
    polish: polish::Buffers,
    polytope: expanding::Polytope,
    triangles: Vec<u32>,
    ways: Vec<triangle_mesh::Way>,
    kept: Vec<reduce::Kept>,
    points: Vec<ContactPoint>,
}

/// A shape at its place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Posed<'a> {
    pub shape: &'a Shape,
    pub pose: Pose,
}

impl Posed<'_> {
    /// World point farthest along a world direction.
    pub fn support(&self, direction: DVec3) -> DVec3 {
        self.pose
            .point(self.shape.support(self.pose.inverse_direction(direction)))
    }
}

/// Where kernels put their points: those nearer than the margin.
pub(crate) struct Sink<'a> {
    pub margin: f64,
    pub out: &'a mut Vec<ContactPoint>,
}

impl Sink<'_> {
    /// Keeps the point unless it is farther than the margin (or not a number).
    pub fn push(&mut self, position: DVec3, normal: DVec3, depth: f64) {
        if depth > -self.margin && position.is_finite() && normal.is_finite() && depth.is_finite() {
            self.out.push(ContactPoint {
                position,
                normal,
                depth,
            });
        }
    }
}

/// Appends the points where A and B are nearer than `margin` [m] to `out`: at most 8 for convex shapes, at most 32 for a
/// mesh.
pub fn collide(
    a: &Shape,
    pose_a: &Pose,
    b: &Shape,
    pose_b: &Pose,
    margin: f64,
    scratch: &mut Scratch,
    out: &mut Vec<ContactPoint>,
) {
    let a = Posed {
        shape: a,
        pose: *pose_a,
    };
    let b = Posed {
        shape: b,
        pose: *pose_b,
    };
    in_order(a, b, out, |a, b, out| {
        let start = out.len();
        kernel(a, b, scratch, &mut Sink { margin, out });
        seams::drop_passing(a, b, out, start);
    });
}

/// Appends the manifold for a normal (unit, from B to A, roughly right) that somebody else, FCL, found, and a point
/// near the contact: refines the normal, then lays the features that it selects over one another. For half-spaces and
/// whole meshes, which need no such help, the same as `collide`.
#[allow(clippy::too_many_arguments)] // two posed shapes, the answer about them, and where to put the result
pub fn manifold(
    a: &Shape,
    pose_a: &Pose,
    b: &Shape,
    pose_b: &Pose,
    normal: DVec3,
    witness: DVec3,
    margin: f64,
    scratch: &mut Scratch,
    out: &mut Vec<ContactPoint>,
) {
    let swapped = rank(a) > rank(b);
    let normal = if swapped { -normal } else { normal };
    let witness = witness
        - if swapped {
            pose_b.position
        } else {
            pose_a.position
        };
    let a = Posed {
        shape: a,
        pose: *pose_a,
    };
    let b = Posed {
        shape: b,
        pose: *pose_b,
    };
    in_order(a, b, out, |a, b, out| {
        let sink = &mut Sink { margin, out };
        match b.shape {
            Shape::HalfSpace | Shape::Mesh(_) => kernel(a, b, scratch, sink),
            _ => {
                let start = sink.out.len();
                refined(a, b, normal, witness, scratch, sink);
                seams::drop_passing(a, b, sink.out, start);
            }
        }
    });
}

/// Calls with the shapes in the order of their rank and in axes through the first one's origin, then mirrors and
/// shifts the new points back: both orders of the arguments give the same answer, and precision does not depend on
/// the distance from the world's origin.
fn in_order<'a>(
    a: Posed<'a>,
    b: Posed<'a>,
    out: &mut Vec<ContactPoint>,
    call: impl FnOnce(&Posed<'a>, &Posed<'a>, &mut Vec<ContactPoint>),
) {
    let start = out.len();
    let swapped = rank(a.shape) > rank(b.shape);
    let (mut first, mut second) = if swapped { (b, a) } else { (a, b) };
    let origin = first.pose.position;
    first.pose.position = DVec3::ZERO;
    second.pose.position -= origin;
    call(&first, &second, out);
    for point in out.iter_mut().skip(start) {
        point.position += origin;
        if swapped {
            point.normal = -point.normal;
        }
    }
}

/// The order in which kernels expect their shapes.
fn rank(shape: &Shape) -> u8 {
    match shape {
        Shape::Sphere { .. } => 0,
        Shape::Capsule { .. } => 1,
        Shape::Rod { .. } => 2,
        Shape::Box { .. } => 3,
        Shape::Hull(_) => 4,
        Shape::Triangle(_) => 5,
        Shape::Cylinder { .. } => 6,
        Shape::Cone { .. } => 7,
        Shape::Ellipsoid { .. } => 8,
        Shape::Mesh(_) => 9,
        Shape::HalfSpace => 10,
    }
}

fn kernel(a: &Posed, b: &Posed, scratch: &mut Scratch, sink: &mut Sink) {
    use Shape::{Box, Capsule, HalfSpace, Hull, Mesh, Rod, Sphere, Triangle};
    match (a.shape, b.shape) {
        (_, HalfSpace) => halfspace::collide(a, &b.pose, scratch, sink),
        (Mesh(_), _) => {}
        (_, Mesh(mesh)) => {
            triangle_mesh::collide(a, &PosedMesh { mesh, pose: b.pose }, scratch, sink)
        }
        (Sphere { radius }, _) => sphere::collide(*radius, &a.pose, b, sink),
        (Capsule { .. } | Rod { .. }, Capsule { .. } | Rod { .. }) => {
            capsule::against_capsule(a, b, &mut scratch.kept, sink)
        }
        (Capsule { .. } | Rod { .. }, Box { .. } | Hull(_) | Triangle(_)) => {
            capsule::against_polytope(a, b, scratch, sink)
        }
        (Box { half: half_a }, Box { half: half_b }) => {
            if let Some(normal) =
                box_box::separating_axis(*half_a, &a.pose, *half_b, &b.pose, sink.margin)
            {
                along(a, b, normal, scratch, sink);
            }
        }
        (Box { .. } | Hull(_) | Triangle(_), Box { .. } | Hull(_) | Triangle(_)) => {
            polytopes(a, b, scratch, sink)
        }
        _ => {
            let (polytope, buffers) = (&mut scratch.polytope, &mut scratch.polish);
            if let Some(best) = convex::separation(a, b, sink.margin, polytope, buffers) {
                built(a, b, &best, a.pose.position, scratch, sink);
            }
        }
    }
}

/// Box, hull and triangle against each other.
fn polytopes(a: &Posed, b: &Posed, scratch: &mut Scratch, sink: &mut Sink) {
    let (Some(first), Some(second)) = (scratch.store_a.polytope(a), scratch.store_b.polytope(b))
    else {
        return;
    };
    if first.edges.len() * second.edges.len() > MANY_PAIRS {
        if let Some(normal) = large_hulls::start(a, b, sink.margin) {
            refined(a, b, normal, a.pose.position, scratch, sink);
        }
    } else if let Some(axis) =
        sat::separating_axis(&first, &second, sink.margin, &mut scratch.edges, |_| true)
    {
        along(a, b, axis.normal, scratch, sink);
    }
}

/// The contact along the axis of least overlap of two polytopes.
fn along(a: &Posed, b: &Posed, normal: DVec3, scratch: &mut Scratch, sink: &mut Sink) {
    if !overlay(a, b, normal, scratch, sink) {
        overlapping_supports(a, b, normal, sink);
    }
}

/// The contact along the best normal near the given one.
fn refined(
    a: &Posed,
    b: &Posed,
    normal: DVec3,
    witness: DVec3,
    scratch: &mut Scratch,
    sink: &mut Sink,
) {
    if let Some(best) = polish::polish(a, b, normal, &mut scratch.polish) {
        built(a, b, &best, witness, scratch, sink);
    }
}

/// The contact along the best normal. Its deepest point states the separation along the normal: where the features miss
/// it (a round rim that stands for a polygon), it is added.
fn built(
    a: &Posed,
    b: &Posed,
    best: &polish::Polished,
    witness: DVec3,
    scratch: &mut Scratch,
    sink: &mut Sink,
) {
    if best.separation >= sink.margin {
        return;
    }
    let start = sink.out.len();
    let scale = a.shape.bounding_radius().min(b.shape.bounding_radius());
    overlay(a, b, best.normal, scratch, sink);
    if sink.out[start..]
        .iter()
        .all(|p| p.depth < -best.separation - ROUNDING * scale)
    {
        let n = best.normal;
        let middle = 0.5 * n.dot(a.support(-n) + b.support(n));
        let meeting = || polish::meeting(a, b, best, &scratch.polish);
        let witness = best.witness.or_else(meeting).unwrap_or(witness);
        sink.push(witness + (middle - n.dot(witness)) * n, n, -best.separation);
    }
    reduce::spread(sink.out, start, 8, RESOLUTION * scale, &mut scratch.kept);
}

/// Lays the features that face each other along a normal over one another: at most 8 points. False when that
/// gives no point.
fn overlay(a: &Posed, b: &Posed, normal: DVec3, scratch: &mut Scratch, sink: &mut Sink) -> bool {
    features::facing(a, -normal, &mut scratch.heights, &mut scratch.feature_a);
    features::facing(b, normal, &mut scratch.heights, &mut scratch.feature_b);
    let start = sink.out.len();
    clip::overlay(
        &mut scratch.feature_a,
        &mut scratch.feature_b,
        normal,
        &mut scratch.clip,
        sink,
    );
    reduce::spread(sink.out, start, 8, 0.0, &mut scratch.kept);
    sink.out.len() > start
}

/// Last resort where the features miss each other though the shapes overlap: one point between the two supports.
fn overlapping_supports(a: &Posed, b: &Posed, normal: DVec3, sink: &mut Sink) {
    let (p, q) = (a.support(-normal), b.support(normal));
    let gap = normal.dot(p - q);
    if gap <= 0.0 {
        sink.push((p + q) * 0.5, normal, -gap);
    }
}

#[cfg(test)]
mod kernel_tests;
#[cfg(test)]
mod manifold_tests;
#[cfg(test)]
mod mesh_tests;
#[cfg(test)]
pub(crate) mod testing;
#[cfg(test)]
mod tests;
