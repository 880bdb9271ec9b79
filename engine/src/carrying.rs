//! The contacts that carry, as the impulses that stand have it, solved together as a linear system.
//!
//! Open contacts stay open, those that stick ask for u = (target, 0, 0), those that slide for u_n = target while their
//! friction stands. With J the rows that are asked for, A = J M^-1 J^T and a little compliance C = eps diag(A) that makes
//! redundant rows harmless (four corners of a box hold more than it needs), the impulses z solve (A + C) z = r. In the
//! bodies' velocities w = M^-1 J^T z that is
//!
//! ```text
//! (M + J^T C^-1 J) w = J^T C^-1 r,        z = C^-1 (r - J w)
//! ```
//!
//! whose matrix is sparse (see `direct.rs`).

use glam::{DMat3, DVec3};

use crate::direct::{Direct, Six};
use crate::math::length;
use crate::mover::{Mover, Part};
use crate::point::Point;

/// eps, see above. What a solve leaves of an error in a motion whose eigenvalue of diag(A)^-1 A is e: eps / (eps + e). With
/// 1e-5 a plate of a gram threw off its load of a tonne (e = 1e-6); rounding errors of 1e-16 / eps are far below `DIGITS`.
const COMPLIANCE: f64 = 1e-8;
/// A bound of friction is reached when less than this part of it is left.
const RIM: f64 = 1e-9;

/// Working memory of the solve.
#[derive(Clone, Debug, Default)]
pub(crate) struct Carrying {
    /// C^-1 of the rows that are asked for, 0 of the others, and C^-1 r.
    rows: Vec<(DVec3, DVec3)>,
    /// J^T C^-1 r, then w.
    step: Vec<Six>,
}

impl Carrying {
    /// Push the contacts to where the ones that carry now all reach their targets; impulses may leave their cones.
    /// Only where the matrix' `products` are known.
    pub(crate) fn solve(
        &mut self,
        direct: &mut Direct,
        points: &mut [Point],
        movers: &mut [Mover],
        part: Part,
    ) {
        direct.begin(movers, &mut self.step);
        self.rows.clear();
        for p in points.iter() {
            let stiffness = stiffness(p, part);
            let gain = stiffness * p.missing(movers);
            direct.add_impulse(&mut self.step, p, gain);
            self.rows.push((stiffness, gain));
        }
        let stiffness = points.iter().zip(&self.rows).map(|(p, &(stiffness, _))| {
            let axes = p.frame();
            let asked = stiffness != DVec3::ZERO;
            asked.then(|| axes * DMat3::from_diagonal(stiffness) * axes.transpose())
        });
        direct.factorise(points, stiffness);
        direct.divide(&mut self.step);
        for (p, (stiffness, gain)) in points.iter_mut().zip(&self.rows) {
            let change = *gain - *stiffness * direct.relative(p, &self.step);
            p.impulse += change;
            p.push(movers, change);
        }
    }
}

/// C^-1 of the rows that are asked for, 0 of the others.
fn stiffness(p: &Point, part: Part) -> DVec3 {
    let limit = p.cone.friction * p.impulse.x;
    let asked = if p.impulse.x <= 0.0 {
        DVec3::ZERO
    } else if part == Part::All && length(p.impulse.y, p.impulse.z) < limit * (1.0 - RIM) {
        DVec3::ONE
    } else {
        DVec3::X
    };
    asked / (p.k() * COMPLIANCE + DVec3::X * p.cone.give)
}
