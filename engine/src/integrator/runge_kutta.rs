//! Explicit Runge-Kutta schemes: explicit Euler and the classical one of fourth order.
//!
//! State (x, q, v, L), rates (v, omega q / 2, F/m, torque). A stage's orientation is used normalised for everything but
//! dq/dt = omega q / 2 itself, which is linear in q: the scheme then keeps its order on the unit sphere, and the
//! quaternion is normalised at the end of the step.
//!
//! Joint forces y follow in every stage from J a + bias = 0 with a = M^-1 (f + J^T y), bias = (dJ/dt) v. Baumgarte's
//! stabilisation (1972, eq. 10) asks for J a + bias = -2 (beta/h) J v - (beta/h)^2 C instead.

use glam::{DQuat, DVec3};

use super::dynamics::Dynamics;
use crate::body::{Body, State};
use crate::force::{Powers, Wrench};

/// A scheme whose stage k starts from the rates of stage k - 1 alone.
pub(super) struct Scheme {
    /// Where each stage lies in the step.
    nodes: &'static [f64],
    /// Shares of the stages' rates in the step.
    weights: &'static [f64],
}

/// x += v dt, v += a dt.
pub(super) const EULER: Scheme = Scheme {
    nodes: &[0.0],
    weights: &[1.0],
};
/// Kutta 1901.
pub(super) const CLASSICAL: Scheme = Scheme {
    nodes: &[0.0, 0.5, 0.5, 1.0],
    weights: &[1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0],
};

/// Rates of change of a body's state.
#[derive(Clone, Copy, Debug, Default)]
pub struct Rates {
    velocity: DVec3,
    turning: [f64; 4],
    acceleration: DVec3,
    torque: DVec3,
}

/// Start, rates of the last stage and the weighted sum of all so far.
#[derive(Clone, Copy, Debug)]
pub struct Stage {
    start: State,
    /// Orientation of the stage, not normalised.
    orientation: DQuat,
    rates: Rates,
    sum: Rates,
}

impl Rates {
    fn plus(&self, other: &Rates, factor: f64) -> Rates {
        let mut turning = self.turning;
        for (t, o) in turning.iter_mut().zip(other.turning) {
            *t += factor * o;
        }
        Rates {
            velocity: self.velocity + other.velocity * factor,
            turning,
            acceleration: self.acceleration + other.acceleration * factor,
            torque: self.torque + other.torque * factor,
        }
    }
}

/// The state after a time `t` at these rates; its quaternion is not normalised.
fn advanced(start: &State, rates: &Rates, t: f64) -> State {
    let q = start.orientation;
    let r = rates.turning;
    State {
        position: start.position + rates.velocity * t,
        orientation: DQuat::from_xyzw(
            q.x + r[0] * t,
            q.y + r[1] * t,
            q.z + r[2] * t,
            q.w + r[3] * t,
        ),
        velocity: start.velocity + rates.acceleration * t,
        angular_momentum: start.angular_momentum + rates.torque * t,
    }
}

impl Scheme {
    pub(super) fn advance(&self, bodies: &mut [Body], d: &mut Dynamics) {
        let h = d.span.1;
        let mut stages = std::mem::take(&mut d.scratch.stages);
        stages.clear();
        stages.extend(bodies.iter().map(|b| Stage {
            start: b.state,
            orientation: b.state.orientation,
            rates: Rates::default(),
            sum: Rates::default(),
        }));
        let wanted = held_values(bodies, d);
        let mut closing = false;
        for (&node, &weight) in self.nodes.iter().zip(self.weights) {
            follow(bodies, &mut stages, node * h);
            if closing {
                close(bodies, d, &mut stages, (node, &wanted));
            }
            let powers = stage(bodies, d, &mut stages, node);
            closing = !d.baumgarte && d.articulation.is_redundant();
            d.book(powers, weight * h);
            d.note_reactions(weight * h);
            for s in &mut stages {
                s.sum = s.sum.plus(&s.rates, weight);
            }
        }
        for (body, s) in bodies
            .iter_mut()
            .zip(&stages)
            .filter(|(b, _)| !b.is_fixed())
        {
            body.state = advanced(&s.start, &s.sum, h);
            body.refresh();
        }
        d.scratch.stages = stages;
        d.place_prescribed(bodies, 1.0);
        settle(bodies, d, wanted);
    }
}

/// Values that the joints are to have at the end of the step: those at its start, less `beta` of them.
fn held_values(bodies: &[Body], d: &mut Dynamics) -> Vec<f64> {
    let mut wanted = std::mem::take(&mut d.scratch.values);
    d.joints.values(bodies, &mut wanted);
    d.joints.take_back(d.beta, &mut wanted);
    wanted
}

/// Positions and velocities back onto the joints.
fn settle(bodies: &mut [Body], d: &mut Dynamics, wanted: Vec<f64>) {
    if !d.baumgarte && !d.articulation.is_empty() {
        d.articulation.load_bilateral(d.joints, bodies);
        d.restore_positions(bodies, &wanted);
        let before = kinetic(bodies);
        d.project_velocities(bodies);
        d.note_reactions(1.0);
        d.stabilization += kinetic(bodies) - before;
    }
    d.scratch.values = wanted;
}

fn kinetic(bodies: &[Body]) -> f64 {
    bodies
        .iter()
        .map(|b| b.kinetic_energy().0 + b.kinetic_energy().1)
        .sum()
}

/// Bodies to where the rates of the stage before lead them in a time.
fn follow(bodies: &mut [Body], stages: &mut [Stage], time: f64) {
    let moving = bodies.iter_mut().zip(stages);
    for (body, s) in moving.filter(|(b, _)| !b.is_fixed()) {
        body.state = advanced(&s.start, &s.rates, time);
        s.orientation = body.state.orientation;
        body.refresh();
    }
}

/// Bodies of a stage onto their joints. Away from there rows that are redundant on them contradict each other, and would
/// hold a mechanism that can move. Rates that are those of the nearest closed pose are as smooth, and on the joints the same:
/// the scheme keeps its order.
fn close(
    bodies: &mut [Body],
    d: &mut Dynamics,
    stages: &mut [Stage],
    (node, wanted): (f64, &[f64]),
) {
    d.place_prescribed(bodies, node);
    d.articulation.restore(d.joints, bodies, wanted, d.scratch);
    d.project_velocities(bodies);
    for (body, s) in bodies.iter().zip(stages) {
        s.orientation = body.state.orientation;
    }
}

/// Rates at a node of the step.
fn stage(bodies: &mut [Body], d: &mut Dynamics, stages: &mut [Stage], node: f64) -> Powers {
    let powers = d.evaluate(bodies, node);
    d.add_joint_forces(bodies, node);
    for (k, s) in stages
        .iter_mut()
        .enumerate()
        .filter(|(k, _)| !bodies[*k].is_fixed())
    {
        s.rates = rates(&bodies[k], s.orientation, &d.scratch.wrenches[k]);
    }
    powers
}

fn rates(body: &Body, orientation: DQuat, wrench: &Wrench) -> Rates {
    let omega = body.angular_velocity;
    let spin = DQuat::from_xyzw(omega.x, omega.y, omega.z, 0.0) * orientation;
    Rates {
        velocity: body.state.velocity,
        turning: [0.5 * spin.x, 0.5 * spin.y, 0.5 * spin.z, 0.5 * spin.w],
        acceleration: wrench.force * body.mass.inverse_mass,
        torque: wrench.torque,
    }
}
