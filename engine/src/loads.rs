//! What acts on bodies in a step before anything moves: forces, and what contacts and drives came to.

use glam::DVec3;

use crate::articulation::Articulation;
use crate::body::Body;
use crate::contact::Contact;
use crate::force::{Forces, Wrench};
use crate::integrator::{accelerations_at, free_accelerations, Scratch};
use crate::joint::{Ahead, End, Joints, Row};
use crate::mover::Twist;
use crate::paths::Paths;
use crate::profile::Moment;
use crate::team::fill;

/// Wrenches and accelerations of all bodies.
#[derive(Clone, Debug, Default)]
pub struct Loads {
    /// Of all forces, without joints, contacts and drives.
    pub wrenches: Vec<Wrench>,
    /// Accelerations without joints and contacts.
    pub free: Vec<Twist>,
    /// Accelerations without contacts.
    pub accelerations: Vec<Twist>,
    /// Forces of the bilateral rows without contacts [N or N m].
    pub tensions: Vec<f64>,
    /// Of contacts and drives, constant over the step.
    pub held: Vec<Wrench>,
    /// Of each drive [N or N m].
    pub drive_forces: Vec<f64>,
    /// Impulses of the bilateral rows in the step.
    pub reactions: Vec<f64>,
    /// Rates of the bilateral rows that come from fixed bodies on a path, at the start of the step.
    fixed_rates: Vec<f64>,
    /// Working memory of the integrator.
    pub scratch: Scratch,
}

impl Loads {
    /// For so many bodies.
    #[must_use]
    pub fn new(bodies: usize) -> Self {
        Self {
            held: vec![Wrench::default(); bodies],
            ..Self::default()
        }
    }

    /// Forces at the start of a step, the accelerations that they give, and the rows of the joints for it.
    pub fn evaluate(
        &mut self,
        bodies: &[Body],
        (forces, joints, articulation): (&Forces, &Joints, &mut Articulation),
        ahead: Ahead,
    ) {
        let time = ahead.time;
        let moment = Moment::within(time, (time, ahead.timestep));
        self.clear();
        forces.evaluate(bodies, moment, &mut self.wrenches);
        joints.add_forces(bodies, time, &mut self.wrenches);
        free_accelerations(bodies, &self.wrenches, &mut self.free);
        if !articulation.is_empty() {
            articulation.load(joints, bodies, ahead);
        }
        let (free, wrenches, jointed) = (&self.free, &self.wrenches, &*articulation);
        let count = (bodies.len(), Twist::default());
        fill(&mut self.accelerations, count, &|k| {
            let mut a = free[k];
            // A free body's contacts are solved with the angular momentum it will have and the inertia it has now.
            if jointed.home(k).is_none() {
                a.angular_velocity = bodies[k].inverse_inertia * wrenches[k].torque;
            }
            a
        });
        self.free.clone_from(&self.accelerations);
        articulation.hold(|row| -row.bias, &mut self.accelerations);
        let bilateral = articulation.rows().len();
        self.tensions.clear();
        self.tensions
            .extend_from_slice(&articulation.impulses()[..bilateral]);
    }

    /// Power of the forces that `evaluate` found, into bodies as they move now [W].
    #[must_use]
    pub fn power(&self, bodies: &[Body]) -> f64 {
        let moving = bodies.iter().zip(&self.wrenches);
        let of = |(b, w): (&Body, &Wrench)| {
            w.force.dot(b.state.velocity) + w.torque.dot(b.angular_velocity)
        };
        moving.filter(|(b, _)| !b.is_fixed()).map(of).sum()
    }

    fn clear(&mut self) {
        self.wrenches.clear();
        self.wrenches.resize(self.held.len(), Wrench::default());
    }

    /// Impulses of contacts and drives become forces over the step. Drives that hold their coordinate still do not: they
    /// are rows of the joints now.
    pub fn hold(
        &mut self,
        contacts: &[Contact],
        (joints, articulation): (&Joints, &Articulation),
        h: f64,
    ) {
        self.held.fill(Wrench::default());
        for c in contacts.iter().filter(|c| c.impulse != DVec3::ZERO) {
            let (force, torque) = (c.to_world(c.impulse) / h, c.turn() / h);
            for (body, f, arm, t) in [
                (c.bodies.0, force, c.arms.0, torque),
                (c.bodies.1, -force, c.arms.1, -torque),
            ] {
                self.held[body].force += f;
                self.held[body].torque += arm.cross(f) + t;
            }
        }
        self.drive_forces.clear();
        let impulses = articulation.drive_impulses();
        for (k, (drive, impulse)) in articulation.drives().iter().zip(impulses).enumerate() {
            let force = if joints.is_locked(k) {
                0.0
            } else {
                impulse / h
            };
            self.drive_forces.push(force);
            drive.row.add_to(force, &mut self.held);
        }
    }

    /// Before bodies move: what fixed bodies on a path do to the rows of joints.
    pub fn note_fixed(&mut self, articulation: &Articulation, bodies: &[Body]) {
        let rows = 0..articulation.rows().len();
        self.fixed_rates.clear();
        self.fixed_rates
            .extend(rows.map(|r| rate_of_fixed(articulation.ends(r), bodies)));
    }

    /// After they moved: the work that fixed bodies on a path did through joints, impulses times mean rates [J].
    #[must_use]
    pub fn work_of_paths(&self, articulation: &Articulation, bodies: &[Body]) -> f64 {
        let rates = self.fixed_rates.iter().enumerate();
        let end = |r: usize| rate_of_fixed(articulation.ends(r), bodies);
        let means = rates.map(|(r, start)| 0.5 * (start + end(r)));
        self.reactions
            .iter()
            .zip(means)
            .map(|(x, mean)| -x * mean)
            .sum()
    }

    /// Forces of the bilateral rows at this instant: those with which J a + bias = 0 under all that acts. They are left
    /// in the articulation.
    pub fn solve_reactions(
        &mut self,
        bodies: &[Body],
        (forces, joints, articulation): (&Forces, &Joints, &mut Articulation),
        (paths, time): (&Paths, f64),
    ) {
        self.wrenches.clone_from(&self.held);
        forces.evaluate(bodies, Moment::at(time), &mut self.wrenches);
        joints.add_forces(bodies, time, &mut self.wrenches);
        accelerations_at(bodies, &self.wrenches, (paths, time), &mut self.free);
        articulation.load_bilateral(joints, bodies);
        articulation.hold(|row| -row.bias, &mut self.free);
    }
}

/// Work that fixed bodies on a prescribed path do through a row, by its impulse [J].
#[must_use]
pub fn work_of_fixed(row: &Row, impulse: f64, bodies: &[Body]) -> f64 {
    -impulse * rate_of_fixed(row.ends.into_iter(), bodies)
}

/// The part of a row's rate that comes from fixed bodies on a path.
fn rate_of_fixed(ends: impl Iterator<Item = End>, bodies: &[Body]) -> f64 {
    let fixed = ends.filter(|end| bodies[end.body].is_fixed());
    fixed.map(|end| end.rate(bodies)).sum()
}
