//! Steps in halves, where the joints ask for it.
//!
//! The end of a whip turns by more than a radian in a step that suits the rest of it. Then no impulses along the joints
//! as they stand at the start of the step close them at its end (the equation of SHAKE has no solution near by), or they
//! close them somewhere else. Such a step is taken back and made in two halves, and these again if need be. Steps
//! that can be made whole are not touched.

use super::dynamics::Dynamics;
use super::Integrator;
use crate::body::{Body, State};
use crate::force::Powers;

/// Halvings of a step at most: 256 parts.
const HALVINGS: usize = 8;
/// What turns by less than this in a step is not why joints cannot be closed, and halves would not help [rad].
const SLOW: f64 = 0.05;

/// Where a step began, and what was booked until then.
#[derive(Clone, Debug, Default)]
pub(super) struct Mark {
    states: Vec<State>,
    reactions: Vec<f64>,
    work: Powers,
    stabilization: f64,
}

impl Integrator {
    /// Move all bodies over the span of `d`.
    pub fn advance(self, bodies: &mut [Body], d: &mut Dynamics) {
        if d.articulation.is_empty() {
            self.step(bodies, d);
        } else {
            self.divide(bodies, d, HALVINGS);
        }
    }

    fn divide(self, bodies: &mut [Body], d: &mut Dynamics, halvings: usize) {
        if halvings == 0 || d.fastest_turn(bodies) <= SLOW {
            self.step(bodies, d);
            return;
        }
        let mark = d.mark(bodies);
        d.closed = true;
        self.step(bodies, d);
        if !d.closed {
            d.go_back(bodies, &mark);
            let (start, length) = d.span;
            for part in [0.0, 0.5] {
                d.span = (start + part * length, 0.5 * length);
                self.divide(bodies, d, halvings - 1);
            }
            d.span = (start, length);
        }
        d.scratch.marks.push(mark);
    }
}

impl Dynamics<'_> {
    fn mark(&mut self, bodies: &[Body]) -> Mark {
        let mut mark = self.scratch.marks.pop().unwrap_or_default();
        mark.states.clear();
        mark.states.extend(bodies.iter().map(|b| b.state));
        mark.reactions.clone_from(self.reactions);
        mark.work = self.work;
        mark.stabilization = self.stabilization;
        mark
    }

    fn go_back(&mut self, bodies: &mut [Body], mark: &Mark) {
        for (body, state) in bodies.iter_mut().zip(&mark.states) {
            body.state = *state;
            body.derive();
        }
        self.reactions.clone_from(&mark.reactions);
        self.work = mark.work;
        self.stabilization = mark.stabilization;
    }

    /// The greatest angle that a body with joints turns by in the step, as it turns now [rad].
    fn fastest_turn(&self, bodies: &[Body]) -> f64 {
        let jointed = bodies
            .iter()
            .enumerate()
            .filter(|(k, _)| self.articulation.home(*k).is_some());
        let fastest = jointed.fold(0.0_f64, |most, (_, b)| {
            most.max(b.angular_velocity.length())
        });
        fastest * self.span.1
    }
}
