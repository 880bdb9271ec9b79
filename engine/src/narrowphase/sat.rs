//! Separating axes of two polytopes.
//!
//! The overlap of two polytopes is least along a face normal of one of them or along the common perpendicular of two
//! edges. Of all pairs of edges only those matter whose arcs of supporting normals cross on the Gauss map, i.e. which
//! make a face of the Minkowski difference (Gregorius, The Separating Axis Test between Convex Polyhedra, GDC 2013).

use super::polytope::{Arc, Polytope};
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
    allowed: impl Fn(DVec3) -> bool,
) -> Option<Axis> {
    let mut search = Search {
        best: None,
        to_beat: f64::NEG_INFINITY,
        margin,
        allowed,
    };
    for plane in &a.planes {
        let separation = -b.reach(-plane.normal) - plane.offset;
        search.consider(Axis {
            normal: -plane.normal,
            separation,
        })?;
    }
    for plane in &b.planes {
        let separation = -a.reach(-plane.normal) - plane.offset;
        search.consider(Axis {
            normal: plane.normal,
            separation,
        })?;
    }
    search.to_beat += PREFER_FACES * (a.size + b.size);
    for arc_a in &a.arcs {
        for arc_b in b
            .arcs
            .iter()
            .filter(|arc_b| cross_on_gauss_map(arc_a, arc_b))
        {
            if let Some(axis) = across(arc_a, arc_b) {
                search.consider(axis)?;
            }
        }
    }
    search.best
}

/// The best axis so far.
struct Search<F> {
    best: Option<Axis>,
    to_beat: f64,
    margin: f64,
    allowed: F,
}

impl<F: Fn(DVec3) -> bool> Search<F> {
    /// None ends the search: the polytopes are apart.
    fn consider(&mut self, axis: Axis) -> Option<()> {
        if axis.separation >= self.margin {
            return None;
        }
        if axis.separation > self.to_beat && (self.allowed)(axis.normal) {
            self.to_beat = axis.separation;
            self.best = Some(axis);
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

/// Distance of two edges along their common perpendicular, which supports both.
fn across(a: &Arc, b: &Arc) -> Option<Axis> {
    let cross = a.along.cross(b.along);
    let length_squared = cross.length_squared();
    if length_squared < PARALLEL {
        return None;
    }
    let cross = cross / length_squared.sqrt();
    let out_of_a = if cross.dot(a.normals[0] + a.normals[1]) < 0.0 {
        -cross
    } else {
        cross
    };
    Some(Axis {
        normal: -out_of_a,
        separation: out_of_a.dot(b.ends[0] - a.ends[0]),
    })
}
