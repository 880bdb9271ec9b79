//! What moves bodies within a step: forces, joints, and the impulses of contacts and drives as constant forces.

use glam::DMat3;

use crate::articulation::Articulation;
use crate::body::Body;
use crate::force::{Forces, Powers, Wrench};
use crate::joint::{Course, Joints};
use crate::mover::Twist;
use crate::paths::Paths;
use crate::profile::Moment;
use crate::team::{each_with, fill};

use super::divide::Mark;
use super::runge_kutta::Stage;

/// What is seen from inside a step is this part of it away from its ends.
const INSIDE: f64 = 1e-9;

/// Working memory of the integrators.
#[derive(Clone, Debug, Default)]
pub struct Scratch {
    pub(super) wrenches: Vec<Wrench>,
    pub(super) states: Vec<crate::body::State>,
    pub(super) stages: Vec<Stage>,
    pub(super) twists: Vec<Twist>,
    pub(super) values: Vec<f64>,
    pub(super) missing: Vec<f64>,
    pub(super) shifts: Vec<Twist>,
    pub(super) marks: Vec<Mark>,
    pub(super) stiffness: Vec<DMat3>,
}

/// Everything that an integrator asks while it moves bodies.
pub struct Dynamics<'a> {
    /// Forces of position, velocity and time.
    pub forces: &'a Forces,
    /// Joints: their springs, dampers and servos, and the geometry of their rows.
    pub joints: &'a Joints,
    /// Fixed bodies that move as prescribed.
    pub paths: &'a Paths,
    /// Start of the step [s] and its length [s].
    pub span: (f64, f64),
    /// The linear system of the joints.
    pub articulation: &'a mut Articulation,
    /// Of contacts and drives, constant over the step.
    pub held: &'a [Wrench],
    /// Part of a joint's error that is taken back in a step.
    pub beta: f64,
    /// By a velocity (Baumgarte) instead of by moving positions.
    pub baumgarte: bool,
    /// Work done in this step [J], by where it came from.
    pub work: Powers,
    /// Kinetic and potential energy that moving onto the constraints added [J].
    pub stabilization: f64,
    /// Joints were closed at the end of every drift and projection so far.
    pub closed: bool,
    /// Forces of the bilateral rows as the step begins [N or N m], but for those that contacts ask for.
    pub tensions: &'a [f64],
    /// The swiftest swing under these tensions [rad/s], as the integrator finds it.
    pub swing: f64,
    /// What acts on bodies as the step begins, but joints, contacts and drives.
    pub pulls: &'a [Wrench],
    /// Impulses of the bilateral rows in this step [N s or N m s].
    pub reactions: &'a mut Vec<f64>,
    /// Working memory.
    pub scratch: &'a mut Scratch,
}

impl Dynamics<'_> {
    /// Fill `scratch.wrenches` with all that acts but the bilateral joints, when a part `node` of the step has passed. Both
    /// ends of the step are seen from inside, so that a force that begins or ends there acts in whole steps.
    pub(super) fn evaluate(&mut self, bodies: &mut [Body], node: f64) -> Powers {
        self.place_prescribed(bodies, node);
        let time = self.time_at(node.clamp(INSIDE, 1.0 - INSIDE));
        let wrenches = &mut self.scratch.wrenches;
        wrenches.clear();
        wrenches.extend_from_slice(self.held);
        let a = self
            .forces
            .evaluate(bodies, Moment::within(time, self.span), wrenches);
        let b = self.joints.add_forces(bodies, time, wrenches);
        a + b
    }

    /// Fixed bodies on a path are where they belong after a part of the step.
    pub(super) fn place_prescribed(&self, bodies: &mut [Body], node: f64) {
        self.paths.arrive(bodies, self.time_at(node));
    }

    fn time_at(&self, node: f64) -> f64 {
        self.span.0 + node * self.span.1
    }

    /// Velocities take in the wrenches over a time.
    pub(super) fn kick(&self, bodies: &mut [Body], time: f64) {
        each_with(bodies, &self.scratch.wrenches, &|body, w| {
            body.apply_wrench(w.force * time, w.torque * time);
        });
    }

    /// Add the joint forces to `scratch.wrenches`: those with which J a + bias = 0, or what Baumgarte makes of it.
    pub(super) fn add_joint_forces(&mut self, bodies: &[Body], node: f64) {
        if self.articulation.is_empty() {
            return;
        }
        let h = self.span.1;
        self.articulation.load_bilateral(self.joints, bodies);
        let pull = if self.baumgarte { self.beta / h } else { 0.0 };
        if self.baumgarte {
            self.articulation.note_rates(bodies);
        }
        let asked = |row: &Course| -row.bias - pull * (2.0 * row.rate + pull * row.value);
        let accelerations = &mut self.scratch.twists;
        let time = self.span.0 + node * h;
        accelerations_at(
            bodies,
            &self.scratch.wrenches,
            (self.paths, time),
            accelerations,
        );
        self.articulation.hold(asked, accelerations);
        self.articulation.add_forces(&mut self.scratch.wrenches);
    }

    /// Some force depends on velocities.
    pub(super) fn depends_on_velocity(&self) -> bool {
        self.forces.depends_on_velocity() || self.joints.depends_on_velocity()
    }

    /// Book power over a time.
    pub(super) fn book(&mut self, powers: Powers, time: f64) {
        self.work = self.work + powers * time;
    }

    /// Impulses of the bilateral rows since their last `load` are part of this step's reactions.
    pub(super) fn note_reactions(&mut self, factor: f64) {
        let rows = self.articulation.rows().len();
        self.reactions.resize(rows, 0.0);
        for (sum, impulse) in self.reactions.iter_mut().zip(self.articulation.impulses()) {
            *sum += impulse * factor;
        }
    }
}

/// Accelerations without joints at a time, of bodies on a prescribed path, too: what the reactions of joints answer to.
pub fn accelerations_at(
    bodies: &[Body],
    wrenches: &[Wrench],
    (paths, time): (&Paths, f64),
    out: &mut Vec<Twist>,
) {
    free_accelerations(bodies, wrenches, out);
    paths.accelerate(out, time);
}

/// Accelerations without joints: a = F / m, alpha = I^-1 (torque - omega x L).
pub fn free_accelerations(bodies: &[Body], wrenches: &[Wrench], out: &mut Vec<Twist>) {
    fill(out, (bodies.len(), Twist::default()), &|k| {
        let (b, w) = (&bodies[k], &wrenches[k]);
        Twist {
            velocity: w.force * b.mass.inverse_mass,
            angular_velocity: b.inverse_inertia
                * (w.torque - b.angular_velocity.cross(b.state.angular_momentum)),
        }
    });
}
