//! Bodies in general position, and what every force must satisfy there.

use glam::{DMat3, DVec3};

use super::{Acts, ForceModel, Forces, Potential, Powers, SpringKind, SpringModel, Wrench};
use crate::body::{Body, MassProperties, State};
use crate::math::rotation_from_vector;
use crate::profile::Moment;

/// Numbers between -1 and 1 that look random and are the same every time (a linear congruence of Knuth, MMIX).
pub(super) struct Numbers(u64);

impl Numbers {
    pub(super) fn new(seed: u64) -> Self {
        Self(seed)
    }

    #[allow(clippy::cast_precision_loss)]
    fn number(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    pub(super) fn vector(&mut self) -> DVec3 {
        DVec3::new(self.number(), self.number(), self.number())
    }
}

/// A moving body of general mass, pose and velocity.
pub(super) fn moving(numbers: &mut Numbers) -> Body {
    let inertia = DMat3::from_diagonal(DVec3::new(0.4, 0.7, 0.9));
    let state = State {
        position: 2.0 * numbers.vector(),
        orientation: rotation_from_vector(2.0 * numbers.vector()),
        velocity: numbers.vector(),
        angular_momentum: numbers.vector(),
    };
    Body::new(MassProperties::new(1.7, inertia), state)
}

/// The world's body: fixed at the origin.
pub(super) fn world() -> Body {
    let state = State {
        position: DVec3::ZERO,
        orientation: glam::DQuat::IDENTITY,
        velocity: DVec3::ZERO,
        angular_momentum: DVec3::ZERO,
    };
    Body::new(MassProperties::fixed(), state)
}

/// A body of 2 kg without spin at `position`.
pub(super) fn at(position: DVec3) -> Body {
    let mut body = moving(&mut Numbers::new(1));
    body.mass = MassProperties::new(2.0, DMat3::IDENTITY);
    body.state = State {
        position,
        ..world().state
    };
    body.refresh();
    body
}

/// Three moving bodies in general position, then the world.
pub(super) fn company(seed: u64) -> Vec<Body> {
    let mut numbers = Numbers::new(seed);
    let mut bodies: Vec<Body> = (0..3).map(|_| moving(&mut numbers)).collect();
    bodies.push(world());
    bodies
}

/// A linear spring between two bodies that does nothing yet.
pub(super) fn linear(bodies: [usize; 2], anchors: [DVec3; 2]) -> SpringModel {
    SpringModel {
        kind: SpringKind::Linear,
        bodies,
        anchors,
        axes: [DVec3::ZERO; 2],
        rest: 0.0,
        stiffness: 0.0,
        damping: 0.0,
        preload: 0.0,
        acts: Acts::Always,
        force_curve: Vec::new(),
        damping_curve: Vec::new(),
    }
}

/// A torsional spring about the world axis `axis` that does nothing yet.
pub(super) fn torsional(bodies: &[Body], pair: [usize; 2], axis: DVec3) -> SpringModel {
    SpringModel {
        kind: SpringKind::Torsional,
        axes: pair.map(|k| bodies[k].rotation.transpose() * axis.normalize()),
        ..linear(pair, [DVec3::ZERO; 2])
    }
}

pub(super) fn of_springs(springs: Vec<SpringModel>, bodies: &[Body]) -> Forces {
    let model = ForceModel {
        springs,
        ..ForceModel::default()
    };
    Forces::new(model, bodies)
}

pub(super) fn evaluate(forces: &Forces, bodies: &[Body], time: f64) -> (Vec<Wrench>, Powers) {
    let mut wrenches = vec![Wrench::default(); bodies.len()];
    let powers = forces.evaluate(bodies, Moment::at(time), &mut wrenches);
    (wrenches, powers)
}

fn sum(p: Potential) -> f64 {
    p.gravitational + p.gravitation + p.spring
}

/// Greatest difference between the wrenches of potentials and minus the gradient of the energy by central differences,
/// over all moving bodies and directions.
pub(super) fn gradient_error(forces: &Forces, bodies: &[Body]) -> f64 {
    let h = 1e-5;
    let (wrenches, _) = evaluate(forces, bodies, 0.0);
    let energy = |k: usize, shift: DVec3, turn: DVec3| {
        let mut moved = bodies.to_vec();
        moved[k].displace(shift, turn);
        sum(forces.potential(&moved))
    };
    let mut worst = 0.0_f64;
    for k in (0..bodies.len()).filter(|&k| !bodies[k].is_fixed()) {
        for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
            let (step, none) = (axis * h, DVec3::ZERO);
            let slope = (energy(k, step, none) - energy(k, -step, none)) / (2.0 * h);
            let turn_slope = (energy(k, none, step) - energy(k, none, -step)) / (2.0 * h);
            worst = worst.max((wrenches[k].force.dot(axis) + slope).abs());
            worst = worst.max((wrenches[k].torque.dot(axis) + turn_slope).abs());
        }
    }
    worst
}

/// Total force, and total torque about the origin.
pub(super) fn total(bodies: &[Body], wrenches: &[Wrench]) -> (DVec3, DVec3) {
    let pairs = bodies.iter().zip(wrenches);
    pairs.fold((DVec3::ZERO, DVec3::ZERO), |(force, torque), (b, w)| {
        let moment = b.state.position.cross(w.force) + w.torque;
        (force + w.force, torque + moment)
    })
}

/// |d(kinetic + potential)/dt - sum of powers|, with dK/dt = F . v + M . omega and the potential by central differences
/// along the motion.
pub(super) fn balance_error(forces: &Forces, bodies: &[Body], time: f64) -> f64 {
    let h = 1e-5;
    let (wrenches, powers) = evaluate(forces, bodies, time);
    let moved = |t: f64| {
        let mut moved = bodies.to_vec();
        for (m, b) in moved.iter_mut().zip(bodies) {
            m.displace(b.state.velocity * t, b.angular_velocity * t);
        }
        sum(forces.potential(&moved))
    };
    let kinetic: f64 = bodies
        .iter()
        .zip(&wrenches)
        .map(|(b, w)| w.force.dot(b.state.velocity) + w.torque.dot(b.angular_velocity))
        .sum();
    let stored = (moved(h) - moved(-h)) / (2.0 * h);
    (kinetic + stored - powers.forces - powers.damping - powers.motors).abs()
}
