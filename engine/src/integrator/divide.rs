//! Steps in parts, where the joints ask for it.
//!
//! The end of a whip turns by more than a radian in a step that suits the rest of it. Then no impulses along the joints
//! as they stand at the start of the step close them at its end (the equation of SHAKE has no solution near by), or they
//! close them somewhere else. Such a step is taken back and made in two halves, and these again if need be. Steps
//! that can be made whole are not touched.
//!
//! Long before that, from a tenth of a radian on, links that tumble gain or lose energy, and a chain that gains it turns ever
//! faster. The symplectic schemes kick for the whole step, which leaves what they do to the energy at that of a constant
//! step, and divide the drift between the kicks, in which no energy goes in or out. Whether a part is too long is judged by
//! the momenta with which it was made: these are the same when time runs backwards, and so is the division. One by the
//! momenta of the start makes a chain lose energy steadily (reversible variable steps: Stoffer 1995, "Variable steps for
//! reversible integration methods", Computing 55). RK4 divides its whole step by the same rule: at a fifth of a radian its
//! own error still takes an eighth of the energy of such a chain in 20 s, undivided 40 %.
//!
//! A rope under great tension swings faster than a step can follow, and gains energy, though it hardly moves. Its step is
//! made in equal parts in which it swings by little (`articulation/swing.rs`): kicks and drift by the tension of what pulls
//! at it, the drift alone by that and what its own motion adds.

use glam::DVec3;

use super::dynamics::{free_accelerations, Dynamics};
use super::Integrator;
use crate::body::{Body, State};
use crate::force::Powers;

/// Halvings of a step at most: 256 parts.
const HALVINGS: usize = 8;
/// What turns by less than this in a step is not why joints cannot be closed, and halves would not help [rad].
const SLOW: f64 = 0.05;
/// A drift, or a step of RK4, turns a body about a joint by at most this angle [rad]. With twice that a chain of ten links gains or loses a
/// tenth of its energy in 30 s, with this a hundredth.
const TURN: f64 = 0.1;

/// A mechanism under tension swings by at most this angle in a part of a step [rad]. From 2 on all but the Runge-Kutta
/// schemes of fourth order lose hold of it.
const SWING: f64 = 1.4;
/// Parts at most, before any is halved.
const PARTS: u32 = 16;

/// Where a part of a step began, and what was booked until then.
#[derive(Clone, Debug, Default)]
pub(super) struct Mark {
    states: Vec<State>,
    reactions: Vec<f64>,
    work: Powers,
    stabilization: f64,
}

/// How a span is divided.
#[derive(Clone, Copy, Debug)]
pub(super) struct Division {
    /// Equal parts, before any is halved.
    pub(super) parts: u32,
    /// Of each part.
    pub(super) halvings: usize,
    /// A part that turns a body about a joint further is halved [rad].
    pub(super) turn: f64,
}

impl Integrator {
    /// Move all bodies over the span of `d`.
    pub fn advance(self, bodies: &mut [Body], d: &mut Dynamics) {
        if d.articulation.is_empty() {
            self.step(bodies, d);
        } else {
            d.swing = d.swiftest_swing(bodies, d.tensions);
            let division = self.division(bodies, d);
            d.in_parts(bodies, division, &|bodies, d| self.step(bodies, d));
        }
    }

    fn division(self, bodies: &[Body], d: &mut Dynamics) -> Division {
        let parts = d.parts(d.swing);
        if self.is_symplectic() {
            Division {
                parts: if parts == 1 {
                    1
                } else {
                    d.pulled_parts(bodies)
                },
                halvings: 0,
                turn: f64::INFINITY,
            }
        } else {
            Division {
                parts,
                halvings: HALVINGS,
                turn: if self == Self::Rk4 {
                    TURN
                } else {
                    f64::INFINITY
                },
            }
        }
    }
}

/// Moves all bodies over the span.
type Advance<'f> = &'f dyn Fn(&mut [Body], &mut Dynamics);

impl Dynamics<'_> {
    /// How to divide a drift.
    pub(super) fn division_of_drift(&self) -> Division {
        Division {
            parts: self.parts(self.swing),
            halvings: HALVINGS,
            turn: TURN,
        }
    }

    /// Equal parts of the span, each divided further where need be.
    pub(super) fn in_parts(&mut self, bodies: &mut [Body], division: Division, advance: Advance) {
        let (start, h) = self.span;
        let length = h / f64::from(division.parts);
        for part in 0..division.parts {
            self.span = (start + f64::from(part) * length, length);
            self.divide(bodies, division, advance);
        }
        self.span = (start, h);
    }

    fn divide(&mut self, bodies: &mut [Body], division: Division, advance: Advance) {
        if division.halvings == 0 {
            advance(bodies, self);
            return;
        }
        let turn = self.fastest_turn(bodies);
        if turn <= SLOW {
            advance(bodies, self);
            return;
        }
        let halves = Division {
            parts: 2,
            halvings: division.halvings - 1,
            ..division
        };
        if turn > 2.0 * division.turn {
            self.in_parts(bodies, halves, advance);
            return;
        }
        let mark = self.mark(bodies);
        self.closed = true;
        advance(bodies, self);
        if !self.closed || self.fastest_turn(bodies) > division.turn {
            self.go_back(bodies, &mark);
            self.in_parts(bodies, halves, advance);
        }
        self.scratch.marks.push(mark);
    }

    /// Parts for what pulls at the joints, without what the motion of their bodies adds.
    fn pulled_parts(&mut self, bodies: &[Body]) -> u32 {
        let mut pulled = std::mem::take(&mut self.scratch.twists);
        let mut forces = std::mem::take(&mut self.scratch.values);
        free_accelerations(bodies, self.pulls, &mut pulled);
        for (k, a) in pulled.iter_mut().enumerate() {
            a.angular_velocity = bodies[k].inverse_inertia * self.pulls[k].torque;
        }
        self.articulation.load_places(self.joints, bodies);
        self.articulation.hold(|_| 0.0, &mut pulled);
        let rows = self.articulation.rows().len();
        forces.clear();
        forces.extend_from_slice(&self.articulation.impulses()[..rows]);
        let swing = self.swiftest_swing(bodies, &forces);
        self.scratch.twists = pulled;
        self.scratch.values = forces;
        self.parts(swing)
    }

    /// The swiftest swing of a mechanism with these forces of its bilateral rows [rad/s], or one that asks for as many parts.
    fn swiftest_swing(&mut self, bodies: &[Body], forces: &[f64]) -> f64 {
        let mut stiffness = std::mem::take(&mut self.scratch.stiffness);
        let (joints, articulation) = (self.joints, &*self.articulation);
        let pull = |j: usize, k: usize| {
            let mut pull = DVec3::ZERO;
            for r in joints.rows_of(j) {
                let end = articulation.ends(r).find(|end| end.body == k);
                pull += end.map_or(DVec3::ZERO, |end| end.linear * forces[r]);
            }
            pull
        };
        joints.stiffness(pull, bodies, &mut stiffness);
        let slow = SWING / self.span.1;
        let parts = |square: f64| (square.sqrt() / slow).ceil();
        let square = self.articulation.swiftest_swing(bodies, &stiffness, parts);
        self.scratch.stiffness = stiffness;
        square.sqrt()
    }

    /// So many that none lets a mechanism swing further than `SWING`.
    fn parts(&self, swing: f64) -> u32 {
        let angle = swing * self.span.1;
        (1..PARTS)
            .find(|&parts| angle <= SWING * f64::from(parts))
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

    /// The greatest angle that a body turns by about a joint in the span, as it turns now [rad].
    fn fastest_turn(&self, bodies: &[Body]) -> f64 {
        self.joints.fastest_turn(bodies) * self.span.1
    }
}
