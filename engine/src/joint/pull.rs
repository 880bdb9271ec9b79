//! Smooth forces along coordinates: springs, dampers and servos of drives, and the damping of ball joints.

use glam::DVec3;

use super::joints::{Joint, Joints};
use super::model::{DriveModel, Motor};
use super::row::Row;
use crate::body::Body;
use crate::force::{Powers, Wrench};

/// Force along a coordinate [N or N m], by where its energy goes.
#[derive(Clone, Copy, Debug, Default)]
struct Pull {
    spring: f64,
    damping: f64,
    servo: f64,
}

impl Pull {
    fn total(self) -> f64 {
        self.spring + self.damping + self.servo
    }
}

impl DriveModel {
    /// It makes forces of this kind.
    fn pulls(&self) -> bool {
        let servo = matches!(self.motor, Some(Motor::Servo { .. }));
        self.stiffness != 0.0 || self.damping != 0.0 || servo
    }

    /// With q the coordinate and q' its rate: spring -k (q - rest), damping -c q', servo k_s (target - q) + c_s (target' - q')
    /// cut off at its greatest force.
    fn pull(&self, q: f64, rate: f64, time: f64) -> Pull {
        let servo = match self.motor {
            Some(Motor::Servo {
                target,
                stiffness,
                damping,
                max,
            }) => {
                let (factor, slope) = self.factor(time);
                let wanted = stiffness * (target * factor - q) + damping * (target * slope - rate);
                wanted.clamp(-max, max)
            }
            Some(Motor::Speed { .. }) | None => 0.0,
        };
        Pull {
            spring: -self.stiffness * (q - self.rest),
            damping: -self.damping * rate,
            servo,
        }
    }
}

impl Joints {
    /// Row and pull of every drive that pulls, or of those of one joint.
    fn pulls<'a>(
        &'a self,
        only: Option<usize>,
        bodies: &'a [Body],
        time: f64,
    ) -> impl Iterator<Item = (Row, Pull)> + 'a {
        let chosen = move |drive: &&DriveModel| {
            drive.pulls() && only.is_none_or(|j| j == drive.joint) && !self.is_broken(drive.joint)
        };
        self.drives.iter().filter(chosen).map(move |drive| {
            let row = self.coordinate_row(drive.joint, drive.coordinate, bodies);
            (row, drive.pull(row.value, row.rate(bodies), time))
        })
    }

    /// Every joint whose rotation is damped, or that one if it is.
    fn damped(&self, only: Option<usize>) -> impl Iterator<Item = &Joint> {
        let chosen = move |(j, joint): &(usize, &Joint)| {
            joint.model.damping != 0.0 && only.is_none_or(|k| k == *j) && !self.is_broken(*j)
        };
        self.joints
            .iter()
            .enumerate()
            .filter(chosen)
            .map(|(_, joint)| joint)
    }

    /// Add the forces of springs, dampers and servos to `wrenches` (one for each body, fixed ones get nothing).
    ///
    /// Returns their power into the moving bodies. What springs give is in `spring_energy`; what a body in prescribed motion
    /// is pushed back with counts as work of forces, since somebody moves it.
    pub fn add_forces(&self, bodies: &[Body], time: f64, wrenches: &mut [Wrench]) -> Powers {
        let mut powers = Powers::default();
        for (row, pull) in self.pulls(None, bodies, time) {
            let rate = row.rate(bodies);
            powers.damping += pull.damping * rate;
            powers.motors += pull.servo * rate;
            powers.forces += push(&row, pull.total(), bodies, wrenches);
        }
        for joint in self.damped(None) {
            let [a, b] = joint.model.bodies;
            let slip = bodies[b].angular_velocity - bodies[a].angular_velocity;
            let torque = joint.model.damping * slip;
            powers.damping -= torque.dot(slip);
            powers.forces += twist(a, torque, bodies, wrenches);
            powers.forces += twist(b, -torque, bodies, wrenches);
        }
        powers
    }

    /// Energy in the springs of coordinates [J]: k (q - rest)^2 / 2.
    #[must_use]
    pub fn spring_energy(&self, bodies: &[Body]) -> f64 {
        let held = |drive: &&DriveModel| drive.stiffness != 0.0 && !self.is_broken(drive.joint);
        let energy = |drive: &DriveModel| {
            let stretch =
                self.placed_coordinate(drive.joint, drive.coordinate, bodies) - drive.rest;
            0.5 * drive.stiffness * stretch * stretch
        };
        self.drives.iter().filter(held).map(energy).sum()
    }

    /// Some force of `add_forces` changes with the velocities.
    #[must_use]
    pub fn depends_on_velocity(&self) -> bool {
        let damps = |drive: &DriveModel| {
            let servo = matches!(drive.motor, Some(Motor::Servo { damping, .. }) if damping != 0.0);
            servo || drive.damping != 0.0
        };
        self.drives.iter().any(damps) || self.damped(None).next().is_some()
    }

    /// Force [N] and torque [N m] about its anchor on body A that springs, dampers and servos of joint `j` pass on: what
    /// `reaction` of its rows leaves out.
    #[must_use]
    pub fn pull_on(&self, j: usize, bodies: &[Body], time: f64) -> (DVec3, DVec3) {
        let mut load = (DVec3::ZERO, DVec3::ZERO);
        for (row, pull) in self.pulls(Some(j), bodies, time) {
            let pushes = row.ends.map(|end| (end, pull.total()));
            let (force, torque) = self.reaction(j, pushes.into_iter(), bodies);
            load.0 += force;
            load.1 += torque;
        }
        for joint in self.damped(Some(j)) {
            let [a, b] = joint.model.bodies;
            let slip = bodies[b].angular_velocity - bodies[a].angular_velocity;
            load.1 += joint.model.damping * slip;
        }
        load
    }
}

/// Force `f` along `row` on its moving bodies; returns the power that bodies in prescribed motion pass on.
fn push(row: &Row, f: f64, bodies: &[Body], wrenches: &mut [Wrench]) -> f64 {
    let mut passed = 0.0;
    for end in &row.ends {
        if bodies[end.body].is_fixed() {
            passed -= f * end.rate(bodies);
        } else {
            wrenches[end.body].force += f * end.linear;
            wrenches[end.body].torque += f * end.angular;
        }
    }
    passed
}

/// The same of a torque on one body.
fn twist(k: usize, torque: DVec3, bodies: &[Body], wrenches: &mut [Wrench]) -> f64 {
    if bodies[k].is_fixed() {
        return -torque.dot(bodies[k].angular_velocity);
    }
    wrenches[k].torque += torque;
    0.0
}
