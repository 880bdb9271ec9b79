//! Moving bodies so that their joints hold.

use super::dynamics::{Dynamics, Scratch};
use super::rotation::{turn_by_momentum, turned, Splitting};
use crate::articulation::Articulation;
use crate::body::{Body, State};
use crate::joint::Joints;
use crate::team::each;

/// Rounds of Newton's method on the constraints at most.
const ROUNDS: usize = 60;
/// Where a round gains less, the next one takes the derivatives anew.
const RENEWED: f64 = 1e-3;
/// A round that gains less is the last.
const GAIN: f64 = 0.7;
/// Joints are held to this [m or rad]: rounding of coordinates of some metres.
const HELD: f64 = 1e-14;
/// Positions this near to where joints hold need not be restored [m or rad].
const RESTORED: f64 = 10.0 * HELD;
/// What is left of an error is too much when it is more than this part of the largest coordinate, or of a metre.
const OPEN: f64 = 1e-11;

impl Dynamics<'_> {
    /// x += v h and the rotation that goes with the angular momentum; the joint impulses J(x)^T y that act before it are
    /// those for which C(x') = (1 - beta) C(x).
    ///
    /// Solved by Newton's method with the matrix J(x') dx'/dy (`turn_by_momentum`), from the y that holds joints to
    /// second order. What is left of an error at the start (`beta` of it goes each step) is taken back by moving positions
    /// afterwards, so that it never becomes a velocity; so is all of it where Newton's method fails. With Baumgarte the
    /// velocity is made to obey J v = -(beta / h) C instead, which leaves an error of about v^2 h^2 / (2 beta L).
    pub(super) fn drift(&mut self, bodies: &mut [Body], splitting: Splitting) {
        let h = self.span.1;
        if self.articulation.is_empty() {
            each(bodies, &|b| free_drift(b, h, splitting));
            return;
        }
        let division = self.division_of_drift();
        self.in_parts(bodies, division, &|bodies, d| {
            d.drift_jointed(bodies, splitting);
        });
    }

    fn drift_jointed(&mut self, bodies: &mut [Body], splitting: Splitting) {
        let h = self.span.1;
        self.articulation.load_near(self.joints, bodies);
        self.articulation.clear_impulses();
        let mut wanted = std::mem::take(&mut self.scratch.values);
        wanted.clear();
        wanted.extend(self.articulation.rows().iter().map(|r| r.value));
        if self.baumgarte {
            self.project_loaded_velocities(bodies);
            self.note_reactions(1.0);
            each(bodies, &|b| free_drift(b, h, splitting));
            self.place_prescribed(bodies, 1.0);
        } else {
            let left = self.held_drift(bodies, splitting, &wanted);
            self.note_reactions(1.0);
            let more = self.joints.take_back(self.beta, &mut wanted);
            if left + more > RESTORED {
                self.restore_positions(bodies, &wanted);
            }
        }
        self.scratch.values = wanted;
    }

    /// Returns the largest error that is left [m or rad].
    fn held_drift(&mut self, bodies: &mut [Body], splitting: Splitting, wanted: &[f64]) -> f64 {
        let mut starts = self.depart(bodies, splitting);
        self.anticipate(bodies, &mut starts);
        let mut missing = std::mem::take(&mut self.scratch.missing);
        let (mut error, mut left) = (f64::INFINITY, f64::INFINITY);
        for round in 0..ROUNDS {
            self.arrive(bodies, &starts, splitting);
            // A round gains as much as the one before, or more: nothing is to be seen any more but rounding.
            let expected = left * (left / error);
            if round > 1 && expected <= HELD {
                left = expected;
                break;
            }
            error = left;
            left = self.joints.errors(bodies, wanted, &mut missing);
            if left <= HELD || left > GAIN * error {
                break;
            }
            if round == 0 || left > RENEWED * error {
                self.look_ahead(bodies, &starts, splitting);
            }
            self.articulation.kick_ahead(bodies, &missing);
        }
        self.closed &= left <= OPEN * size(bodies);
        if left > OPEN * size(bodies) {
            self.take_back(bodies, &starts);
            self.arrive(bodies, &starts, splitting);
        }
        for (k, body) in bodies.iter_mut().enumerate() {
            if self.articulation.home(k).is_some() {
                body.derive();
            }
        }
        self.scratch.missing = missing;
        self.scratch.states = starts;
        left
    }

    /// Bodies without joints are through; of the others the starts are kept.
    fn depart(&mut self, bodies: &mut [Body], splitting: Splitting) -> Vec<State> {
        let mut starts = std::mem::take(&mut self.scratch.states);
        starts.clear();
        starts.extend(bodies.iter().map(|b| b.state));
        for (k, body) in bodies.iter_mut().enumerate() {
            if self.articulation.home(k).is_none() {
                free_drift(body, self.span.1, splitting);
            }
        }
        starts
    }

    /// Bodies with joints drift from their starts with the momenta that they have now.
    fn arrive(&self, bodies: &mut [Body], starts: &[State], splitting: Splitting) {
        let h = self.span.1;
        for (k, body) in bodies.iter_mut().enumerate() {
            if self.articulation.home(k).is_some() {
                let start = starts[k].with(body);
                let turned = turned(&body.mass, &start, h, splitting);
                let position = start.position + body.state.velocity * h;
                body.put(position, turned.normalize());
            }
        }
    }

    /// Back to what was anticipated.
    fn take_back(&mut self, bodies: &mut [Body], starts: &[State]) {
        for (k, body) in bodies.iter_mut().enumerate() {
            if self.articulation.home(k).is_some() {
                body.state = starts[k];
            }
        }
        self.articulation.take_back();
    }

    /// Newton's matrix at the end of the drift.
    fn look_ahead(&mut self, bodies: &[Body], starts: &[State], splitting: Splitting) {
        let h = self.span.1;
        let answer = |k: usize| {
            let (mass, start) = (&bodies[k].mass, starts[k].with(&bodies[k]));
            let turn = turn_by_momentum(mass, &start, h, splitting);
            (h * mass.inverse_mass, turn.transpose())
        };
        self.articulation.look_ahead(self.joints, bodies, answer);
    }

    /// Impulses that hold joints to second order: C(x') = C + h J v + h^2/2 (dJ/dt) v.
    fn anticipate(&mut self, bodies: &mut [Body], starts: &mut [State]) {
        let half = 0.5 * self.span.1;
        let mut missing = std::mem::take(&mut self.scratch.missing);
        missing.clear();
        self.articulation.note_rates(bodies);
        let rows = self.articulation.rows().iter();
        missing.extend(rows.map(|row| -row.rate - half * row.bias));
        self.articulation.kick(bodies, &missing);
        self.place_prescribed(bodies, 1.0);
        for (start, body) in starts.iter_mut().zip(bodies) {
            *start = start.with(body);
        }
        self.articulation.mark_impulses();
        self.scratch.missing = missing;
    }

    /// Velocities obey the joints: J v = 0; with Baumgarte J v = -(beta / h) C.
    pub(super) fn project_velocities(&mut self, bodies: &mut [Body]) {
        if self.articulation.is_empty() {
            return;
        }
        self.articulation.load_places(self.joints, bodies);
        self.articulation.clear_impulses();
        self.project_loaded_velocities(bodies);
    }

    fn project_loaded_velocities(&mut self, bodies: &mut [Body]) {
        let pull = if self.baumgarte {
            self.beta / self.span.1
        } else {
            0.0
        };
        let mut missing = std::mem::take(&mut self.scratch.missing);
        missing.clear();
        self.articulation.note_rates(bodies);
        let rows = self.articulation.rows().iter();
        missing.extend(rows.map(|row| -pull * row.value - row.rate));
        self.articulation.kick(bodies, &missing);
        self.scratch.missing = missing;
    }

    /// Bodies back to where their rows have the values `wanted`.
    pub(super) fn restore_positions(&mut self, bodies: &mut [Body], wanted: &[f64]) {
        let off = self
            .joints
            .errors(bodies, wanted, &mut self.scratch.missing);
        if off <= RESTORED {
            return;
        }
        let before = self.forces.potential(bodies).total() + self.joints.spring_energy(bodies);
        let restored = self
            .articulation
            .restore(self.joints, bodies, wanted, self.scratch);
        self.closed &= restored.left <= OPEN * size(bodies);
        if restored.moved {
            let after = self.forces.potential(bodies).total() + self.joints.spring_energy(bodies);
            self.stabilization += after - before;
        }
    }
}

impl Articulation {
    /// Bodies move along M^-1 J^T until their rows have the values `wanted`; momenta turn along, so that the kinetic
    /// energy stays.
    pub fn restore(
        &mut self,
        joints: &Joints,
        bodies: &mut [Body],
        wanted: &[f64],
        scratch: &mut Scratch,
    ) -> Restored {
        let mut error = f64::INFINITY;
        let mut restored = Restored::default();
        for _ in 0..ROUNDS {
            restored.left = joints.errors(bodies, wanted, &mut scratch.missing);
            if restored.left <= RESTORED || restored.left > 0.5 * error {
                break;
            }
            error = restored.left;
            restored.moved = true;
            self.load_places(joints, bodies);
            self.clear_impulses();
            self.displacements(&scratch.missing, &mut scratch.shifts);
            let shifted = bodies.iter_mut().zip(&scratch.shifts);
            for (body, shift) in shifted.filter(|(b, _)| !b.is_fixed()) {
                body.displace(shift.velocity, shift.angular_velocity);
            }
        }
        restored
    }
}

/// What bringing bodies back came to.
#[derive(Clone, Copy, Debug, Default)]
pub struct Restored {
    /// Something was to be done.
    pub moved: bool,
    /// Largest error of a row afterwards [m or rad].
    pub left: f64,
}

/// The largest coordinate, at least a metre [m]: rounding is a part of it.
fn size(bodies: &[Body]) -> f64 {
    let positions = bodies.iter().map(|b| b.state.position.abs().max_element());
    positions.fold(1.0, f64::max)
}

/// x += v h, and the rotation that goes with the angular momentum.
fn free_drift(body: &mut Body, h: f64, splitting: Splitting) {
    if body.is_fixed() {
        return;
    }
    body.state.position += body.state.velocity * h;
    body.state.orientation = turned(&body.mass, &body.state, h, splitting);
    body.refresh();
}
