//! Springs and dampers between two points.

use glam::DVec3;

use super::law::{Law, Tension};
use super::spring::SpringModel;
use super::sum::Sum;
use crate::body::Body;

/// With the ends p_A and p_B, l = |p_B - p_A|, n = (p_B - p_A) / l and dl/dt = n . (v_pB - v_pA), the spring pulls A with
/// T(l, dl/dt) n and B with -T n.
///
/// Where the ends coincide n does not exist, and the spring is without force: the choice that keeps its symmetry.
#[derive(Clone, Debug)]
pub(super) struct LinearSpring {
    bodies: [usize; 2],
    anchors: [DVec3; 2],
    pub(super) law: Law,
}

/// Where a spring is and how it moves.
struct Line {
    /// From the centres of mass to the ends, world axes [m].
    arms: [DVec3; 2],
    length: f64,
    /// n, zero where the ends coincide.
    direction: DVec3,
    /// dl/dt [m/s]
    rate: f64,
}

impl LinearSpring {
    pub(super) fn new(model: &SpringModel) -> Self {
        Self {
            bodies: model.bodies,
            anchors: model.anchors,
            law: Law::new(model),
        }
    }

    pub(super) fn add(&self, sum: &mut Sum<'_>) {
        let line = self.line(sum.bodies);
        let tension = self.tension(&line);
        let force = line.direction * tension.total;
        sum.powers.damping -= (tension.total - tension.elastic) * line.rate;
        sum.interact(self.bodies[0], force, line.arms[0].cross(force));
        sum.interact(self.bodies[1], -force, -line.arms[1].cross(force));
    }

    pub(super) fn energy(&self, bodies: &[Body]) -> f64 {
        self.law.energy(self.line(bodies).length)
    }

    /// Length [m] and tension [N].
    pub(super) fn reading(&self, bodies: &[Body]) -> (f64, f64) {
        let line = self.line(bodies);
        (line.length, self.tension(&line).total)
    }

    fn tension(&self, line: &Line) -> Tension {
        self.law.tension(line.length, line.rate)
    }

    fn line(&self, bodies: &[Body]) -> Line {
        let (a, b) = (&bodies[self.bodies[0]], &bodies[self.bodies[1]]);
        let arms = [a.rotation * self.anchors[0], b.rotation * self.anchors[1]];
        let apart = b.state.position + arms[1] - a.state.position - arms[0];
        let length = apart.length();
        let direction = if length > 0.0 {
            apart / length
        } else {
            DVec3::ZERO
        };
        let rate = direction.dot(b.velocity_at(arms[1]) - a.velocity_at(arms[0]));
        Line {
            arms,
            length,
            direction,
            rate,
        }
    }
}
