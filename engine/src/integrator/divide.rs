//! Steps in halves, where the joints ask for it.
//!
//! The end of a whip turns by more than a radian in a step that suits the rest of it. Then no impulses along the joints
//! as they stand at the start of the step close them at its end (the equation of SHAKE has no solution near by), or they
//! close them somewhere else. Such a step is taken back and made in two halves, and these again if need be. Steps
//! that can be made whole are not touched.
//!
//! A rope under great tension swings faster than a step can follow, and gains energy, long before its joints cannot be
//! closed. Its step is made in equal parts in which it swings by little (`articulation/swing.rs`).

use super::dynamics::Dynamics;
use super::Integrator;
use crate::body::{Body, State};
use crate::force::Powers;

/// Halvings of a step at most: 256 parts.
const HALVINGS: usize = 8;
/// What turns by less than this in a step is not why joints cannot be closed, and halves would not help [rad].
const SLOW: f64 = 0.05;

/// A mechanism under tension swings by at most this angle in a part of a step [rad]. From 2 on all but the Runge-Kutta
/// schemes of fourth order lose hold of it.
const SWING: f64 = 1.4;
/// Parts at most, before any is halved.
const PARTS: u32 = 16;

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
            let parts = d.parts(bodies);
            self.in_parts(bodies, d, parts, HALVINGS);
        }
    }

    /// Equal parts of the step, each divided further where need be.
    fn in_parts(self, bodies: &mut [Body], d: &mut Dynamics, parts: u32, halvings: usize) {
        let (start, h) = d.span;
        let length = h / f64::from(parts);
        for part in 0..parts {
            d.span = (start + f64::from(part) * length, length);
            self.divide(bodies, d, halvings);
        }
        d.span = (start, h);
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
            self.in_parts(bodies, d, 2, halvings - 1);
        }
        d.scratch.marks.push(mark);
    }
}

impl Dynamics<'_> {
    /// So many that no part lets a mechanism swing further than `SWING`.
    fn parts(&mut self, bodies: &[Body]) -> u32 {
        let mut stiffness = std::mem::take(&mut self.scratch.stiffness);
        let rows = self.articulation.rows();
        self.joints
            .stiffness(rows, self.tensions, bodies, &mut stiffness);
        let slow = SWING / self.span.1;
        let swiftest = self
            .articulation
            .swiftest_swing(bodies, &stiffness, slow * slow);
        self.scratch.stiffness = stiffness;
        (1..PARTS)
            .find(|&parts| swiftest.sqrt() <= slow * f64::from(parts))
            .unwrap_or(PARTS)
    }

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
