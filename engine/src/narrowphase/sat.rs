//! Separating axes of two polytopes.
//!
//! The overlap of two polytopes is least along a face normal of one of them or along the common perpendicular of two
//! edges. Of all pairs of edges only those matter whose arcs of supporting normals cross on the Gauss map, i.e. which
//! make a face of the Minkowski difference (Gregorius, The Separating Axis Test between Convex Polyhedra, GDC 2013).
//!
//! Most faces and edges need not be looked at: along a face's normal the other polytope is not farther away than any one
//! of its vertices, and so it is along the normals of an edge (see `protruding.rs`).

use super::polytope::Polytope;
use super::protruding::{Arc, Protruding};
use crate::shape::{Face, Pose};
use glam::DVec3;

/// Squared sine below which two edges are parallel; their cross product would be rounding.
const PARALLEL: f64 = 1e-10;
/// A pair of edges must win by this share of the polytopes' size over a face's normal.
const PREFER_FACES: f64 = 1e-9;

/// A direction and the separation along it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Axis {
    /// Unit, from B to A.
    pub normal: DVec3,
    /// Positive when apart [m].
    pub separation: f64,
}

/// The axis of largest separation among those whose normal is allowed; None when there is none, or when any axis,
/// allowed or not, shows a gap of at least the margin.
pub(crate) fn separating_axis(
    a: &Polytope,
    b: &Polytope,
    margin: f64,
    edges: &mut Edges,
    allowed: impl Fn(DVec3) -> bool,
) -> Option<Axis> {
    let (b_from_a, a_from_b) = (a.pose.relative(&b.pose), b.pose.relative(&a.pose));
    let mut search = Search {
        best: None,
        to_beat: f64::NEG_INFINITY,
        margin,
        allowed,
    };
    let vertex_of_b = search.faces(a, b, &b_from_a, -1.0)?;
    let vertex_of_a = search.faces(b, a, &a_from_b, 1.0)?;
    let advantage = PREFER_FACES * (a.size + b.size);
    // Half of it is left to rounding.
    let limit = search.to_beat + 0.5 * advantage;
    search.to_beat += advantage;
    if edges.of_a.collect(a, vertex_of_b, limit, &Pose::IDENTITY)
        && edges.of_b.collect(b, vertex_of_a, limit, &b_from_a)
    {
        search.edges(edges, &a.pose)?;
    }
    search.best
}

/// Edges that may matter, in A's frame.
#[derive(Default, Debug)]
pub(crate) struct Edges {
    of_a: Protruding,
    of_b: Protruding,
}

/// The best axis so far.
struct Search<F> {
    best: Option<Axis>,
    to_beat: f64,
    margin: f64,
    allowed: F,
}

impl<F: Fn(DVec3) -> bool> Search<F> {
    /// Whether the axis is the best so far; None ends the search: the polytopes are apart.
    fn consider(&mut self, separation: f64, normal: impl FnOnce() -> DVec3) -> Option<bool> {
        if separation >= self.margin {
            return None;
        }
        if separation > self.to_beat {
            let normal = normal();
            if (self.allowed)(normal) {
                self.to_beat = separation;
                self.best = Some(Axis { normal, separation });
                return Some(true);
            }
        }
        Some(false)
    }

    /// Faces of one polytope against the other's vertices, that which looks towards its middle first. Returns the
    /// vertex that is lowest over the best of them. `place` is the other's, all in the frame of the first; `sign` turns
    /// normals from B to A.
    fn faces(&mut self, of: &Polytope, other: &Polytope, place: &Pose, sign: f64) -> Option<DVec3> {
        let normal = |face: &Face| sign * of.pose.direction(face.normal);
        let facing = of.facing(place.point(other.middle));
        let (vertex, height) = other.lowest_over(facing, place);
        self.consider(height, || normal(facing))?;
        let mut lowest = place.point(other.vertices[vertex]);
        for face in of.faces {
            if face.height(lowest) > self.to_beat {
                let (vertex, height) = other.lowest_over(face, place);
                if self.consider(height, || normal(face))? {
                    lowest = place.point(other.vertices[vertex]);
                }
            }
        }
        Some(lowest)
    }

    /// Common perpendiculars of edges, in the frame that is at `frame`.
    fn edges(&mut self, edges: &Edges, frame: &Pose) -> Option<()> {
        for arc_a in &edges.of_a.arcs {
            let crossing = |arc_b: &&Arc| cross_on_gauss_map(arc_a, arc_b);
            for arc_b in edges.of_b.arcs.iter().filter(crossing) {
                if let Some((normal, separation)) = across(arc_a, arc_b) {
                    self.consider(separation, || frame.direction(normal))?;
                }
            }
        }
        Some(())
    }
}

/// Arc a-b of A's normals against arc c-d of B's, the latter mirrored: c and d lie on different sides of the plane
/// through a and b, a and b on different sides of that through c and d, and both arcs in the same hemisphere.
/// b x a and d x c are replaced by the edges' directions, which are parallel to them.
fn cross_on_gauss_map(a: &Arc, b: &Arc) -> bool {
    let c_ba = -b.normals[0].dot(a.along);
    let d_ba = -b.normals[1].dot(a.along);
    if c_ba * d_ba >= 0.0 {
        return false;
    }
    // -d x -c = d x c
    let a_dc = a.normals[0].dot(b.along);
    let b_dc = a.normals[1].dot(b.along);
    a_dc * b_dc < 0.0 && c_ba * b_dc > 0.0
}

/// The common perpendicular of two edges, which supports both, from B to A, and their distance along it.
fn across(a: &Arc, b: &Arc) -> Option<(DVec3, f64)> {
    let cross = a.along.cross(b.along);
    let squares = a.along.length_squared() * b.along.length_squared();
    let length_squared = cross.length_squared();
    if length_squared <= PARALLEL * squares {
        return None;
    }
    let cross = cross / length_squared.sqrt();
    let into_a = if cross.dot(a.normals[0] + a.normals[1]) < 0.0 {
        cross
    } else {
        -cross
    };
    Some((into_a, into_a.dot(a.start - b.start)))
}

#[cfg(test)]
mod tests {
    use super::super::polytope::Store;
    use super::super::testing::{prism, shapes, Random};
    use super::super::Posed;
    use super::*;
    use crate::shape::Shape;

    /// The largest separation along all faces and all pairs of edges that cross on the Gauss map.
    fn full_search(a: &Polytope, b: &Polytope) -> f64 {
        let (b_from_a, a_from_b) = (a.pose.relative(&b.pose), b.pose.relative(&a.pose));
        let of_a = a.faces.iter().map(|f| b.lowest_over(f, &b_from_a).1);
        let of_b = b.faces.iter().map(|f| a.lowest_over(f, &a_from_b).1);
        let mut edges = Edges::default();
        edges
            .of_a
            .collect(a, DVec3::ZERO, f64::NEG_INFINITY, &Pose::IDENTITY);
        edges
            .of_b
            .collect(b, DVec3::ZERO, f64::NEG_INFINITY, &b_from_a);
        assert!(edges.of_a.arcs.len() == a.edges.len() && edges.of_b.arcs.len() == b.edges.len());
        let (arcs_a, arcs_b) = (&edges.of_a.arcs, &edges.of_b.arcs);
        let pairs = arcs_a
            .iter()
            .flat_map(|p| arcs_b.iter().map(move |q| (p, q)));
        let crossing = pairs.filter(|(p, q)| cross_on_gauss_map(p, q));
        let of_edges = crossing.filter_map(|(p, q)| across(p, q).map(|axis| axis.1));
        of_a.chain(of_b)
            .chain(of_edges)
            .fold(f64::NEG_INFINITY, f64::max)
    }

    /// Deep in each other, touching and apart, also face on face.
    #[test]
    fn passing_over_faces_and_edges_loses_nothing() {
        let mut random = Random(31);
        let mut all: Vec<Shape> = shapes().into_iter().filter(|s| !s.is_round()).collect();
        all.extend([prism(9, 0.4, 0.2), prism(4, 0.3, 0.5)]);
        let (mut store_a, mut store_b) = (Store::default(), Store::default());
        for (a, b) in all.iter().flat_map(|a| all.iter().map(move |b| (a, b))) {
            for k in 0..200 {
                let (pose_a, mut pose_b) = (random.pose(0.1), random.pose(0.9));
                if k % 4 == 0 {
                    pose_b.rotation = pose_a.rotation;
                }
                let (a, b) = (
                    Posed {
                        shape: a,
                        pose: pose_a,
                    },
                    Posed {
                        shape: b,
                        pose: pose_b,
                    },
                );
                let (Some(p), Some(q)) = (store_a.polytope(&a), store_b.polytope(&b)) else {
                    continue;
                };
                let expected = full_search(&p, &q);
                let search =
                    |margin| separating_axis(&p, &q, margin, &mut Edges::default(), |_| true);
                let found = search(10.0).unwrap();
                let slack = PREFER_FACES * (p.size + q.size);
                assert!((found.separation - expected).abs() <= slack, "{a:?} {b:?}");
                assert!(search(expected - 2.0 * slack).is_none());
            }
        }
    }
}
