//! Fixed bodies on their prescribed paths, step by step.

use crate::body::{Body, State};
use crate::math::rotation_vector;
use crate::motion::Motion;
use crate::mover::Twist;

/// All prescribed motions of a world.
#[derive(Clone, Debug, Default)]
pub struct Paths {
    motions: Vec<Motion>,
    starts: Vec<State>,
}

impl Paths {
    /// Of bodies as they stand at the start.
    #[must_use]
    pub fn new(motions: Vec<Motion>, bodies: &[Body]) -> Self {
        Self {
            starts: motions.iter().map(|m| bodies[m.body()].state).collect(),
            motions,
        }
    }

    /// Nothing moves by prescription.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.motions.is_empty()
    }

    /// For the step from `time` on, bodies get the velocity that a contact is to follow at the end of it. A scheme whose
    /// displacements are those of the velocity at the end (`lead` 1) follows the mean velocity of the step, the others
    /// follow the velocity of the instant.
    pub fn depart(&self, bodies: &mut [Body], time: f64, h: f64, lead: f64) {
        for (motion, start) in self.motions.iter().zip(&self.starts) {
            let body = &mut bodies[motion.body()];
            if lead < 1.0 {
                (body.state.velocity, body.angular_velocity) = motion.velocity(start, time + h);
                continue;
            }
            let (position, orientation) = motion.pose(start, time + h);
            body.state.velocity = (position - body.state.position) / h;
            let turn = orientation * body.state.orientation.conjugate();
            body.angular_velocity = rotation_vector(turn) / h;
        }
    }

    /// At the end of a step bodies are where they are to be, with the velocity of that instant.
    pub fn arrive(&self, bodies: &mut [Body], time: f64) {
        for (motion, start) in self.motions.iter().zip(&self.starts) {
            let body = &mut bodies[motion.body()];
            (body.state.position, body.state.orientation) = motion.pose(start, time);
            (body.state.velocity, body.angular_velocity) = motion.velocity(start, time);
            body.refresh();
        }
    }

    /// Their accelerations at a time, among those of all bodies.
    pub fn accelerate(&self, accelerations: &mut [Twist], time: f64) {
        for (motion, start) in self.motions.iter().zip(&self.starts) {
            let (velocity, angular_velocity) = motion.acceleration(start, time);
            accelerations[motion.body()] = Twist {
                velocity,
                angular_velocity,
            };
        }
    }

    /// Once a step, at its time.
    pub fn observe(&mut self, time: f64) {
        for motion in &mut self.motions {
            motion.observe(time);
        }
    }
}
