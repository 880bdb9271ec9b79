//! Bodies and joints for tests: random but repeatable.

use glam::{DMat3, DQuat, DVec3};

use super::model::{JointModel, Kind};
use crate::body::{Body, MassProperties, State};
use crate::math::rotation_from_vector;

/// Numbers that look random and are the same every time (Lehmer, Park and Miller 1988: 16807 modulo 2^31 - 1).
pub(crate) struct Numbers(pub(crate) u64);

impl Numbers {
    /// In -1 .. 1.
    #[allow(clippy::cast_precision_loss)]
    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0 * 16_807 % 2_147_483_647;
        2.0 * self.0 as f64 / 2_147_483_647.0 - 1.0
    }

    pub(crate) fn vector(&mut self) -> DVec3 {
        DVec3::new(self.next(), self.next(), self.next())
    }

    /// A rotation by up to `size` about each axis.
    pub(crate) fn rotation(&mut self, size: f64) -> DQuat {
        rotation_from_vector(size * self.vector())
    }
}

/// A body of mass 1 kg and inertia diag(1, 2, 3) kg m^2 that moves like this.
pub(super) fn body(position: DVec3, orientation: DQuat, velocity: DVec3, omega: DVec3) -> Body {
    let mass = MassProperties::new(1.0, DMat3::from_diagonal(DVec3::new(1.0, 2.0, 3.0)));
    let state = State {
        position,
        orientation,
        velocity,
        angular_momentum: DVec3::ZERO,
    };
    let mut body = Body::new(mass, state);
    body.set_angular_velocity(omega);
    body
}

/// A resting body.
pub(super) fn at(position: DVec3, orientation: DQuat) -> Body {
    body(position, orientation, DVec3::ZERO, DVec3::ZERO)
}

/// The fixed body at the origin.
pub(super) fn world() -> Body {
    let state = State {
        position: DVec3::ZERO,
        orientation: DQuat::IDENTITY,
        velocity: DVec3::ZERO,
        angular_momentum: DVec3::ZERO,
    };
    Body::new(MassProperties::fixed(), state)
}

/// A joint of `bodies` a and b whose frames are both at `anchor` with the axes `frame` in the world now.
pub(super) fn join(
    kind: Kind,
    ends: [usize; 2],
    anchor: DVec3,
    frame: DQuat,
    bodies: &[Body],
) -> JointModel {
    let state = |k: usize| &bodies[ends[k]].state;
    let local = |k: usize| state(k).orientation.conjugate() * (anchor - state(k).position);
    let turned = |k: usize| state(k).orientation.conjugate() * frame;
    JointModel {
        kind,
        bodies: ends,
        anchors: [local(0), local(1)],
        frames: [turned(0), turned(1)],
        damping: 0.0,
        break_force: f64::INFINITY,
        break_torque: f64::INFINITY,
    }
}

/// All kinds that join two bodies.
pub(super) const KINDS: [Kind; 11] = [
    Kind::Distance { length: 0.7 },
    Kind::Ball,
    Kind::Hinge,
    Kind::Slider,
    Kind::Fixed,
    Kind::Cone {
        max_angle: 0.5,
        restitution: 0.3,
    },
    Kind::Universal,
    Kind::Cylindrical,
    Kind::Planar,
    Kind::Screw { pitch: -0.31 },
    Kind::Stops,
];
