//! Edges of a polytope that may separate it from another one better than a face does.
//!
//! Along a normal m of an edge's arc, between the normals f and g of its two faces, another polytope is not farther away
//! than m . (v - p) for any vertex v of it and any point p of the edge. With the heights x and y of v over the faces and
//! c = f . g, the largest value on the arc is
//!
//! ```text
//! the distance of v from the edge    where the edge is what v sees: x > c y and y > c x
//! max(x, y)                          elsewhere
//! ```
//!
//! An edge can be passed over when that is less than a separation that is known. Where a face lies on a face, or a
//! corner, no edge is left, of two hulls that touch with edges these and some neighbours.

use super::polytope::Polytope;
use crate::shape::{Edge, Pose};
use glam::DVec3;

/// An edge with the arc of normals (at most 90 to 180 degrees, between two faces) in which it supports the polytope.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Arc {
    /// One end of the edge.
    pub start: DVec3,
    /// Along the edge, on the side of normals[1] x normals[0] [m].
    pub along: DVec3,
    /// Ends of the arc.
    pub normals: [DVec3; 2],
}

impl Arc {
    fn of(edge: &Edge, polytope: &Polytope) -> Self {
        let [start, end] = polytope.ends(edge);
        let [from, to] = edge.faces.map(|k| polytope.faces[k as usize].normal);
        let along = end - start;
        let turned = to.cross(from).dot(along) < 0.0;
        Self {
            start,
            along: if turned { -along } else { along },
            normals: [from, to],
        }
    }

    fn placed(self, pose: &Pose) -> Self {
        Self {
            start: pose.point(self.start),
            along: pose.direction(self.along),
            normals: self.normals.map(|n| pose.direction(n)),
        }
    }
}

/// Edges that may matter, and memory for finding them.
#[derive(Default, Debug)]
pub(crate) struct Protruding {
    pub arcs: Vec<Arc>,
    /// Of the vertex over the faces.
    heights: Vec<f64>,
}

impl Protruding {
    /// Collects the edges along which something with this vertex (in the polytope's frame) may be separated by more
    /// than `limit`, as seen in the frame in which the polytope has the pose `place`. False when there are none.
    pub fn collect(
        &mut self,
        polytope: &Polytope,
        vertex: DVec3,
        limit: f64,
        place: &Pose,
    ) -> bool {
        self.heights.clear();
        let heights = polytope.faces.iter().map(|face| face.height(vertex));
        self.heights.extend(heights);
        self.arcs.clear();
        for edge in polytope.edges {
            if self.protrudes(edge, polytope, limit) {
                self.arcs.push(Arc::of(edge, polytope).placed(place));
            }
        }
        !self.arcs.is_empty()
    }

    fn protrudes(&self, edge: &Edge, polytope: &Polytope, limit: f64) -> bool {
        let [f, g] = edge.faces.map(|k| k as usize);
        let (x, y) = (self.heights[f], self.heights[g]);
        let seen = || {
            let c = polytope.faces[f].normal.dot(polytope.faces[g].normal);
            x > c * y && y > c * x
        };
        // What is below both faces does not see the edge.
        let higher = x.max(y);
        higher > limit || (higher > 0.0 && seen())
    }
}
