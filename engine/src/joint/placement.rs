//! Where the two ends of a joint are and how they move.

use glam::{DMat3, DQuat, DVec3};

use super::row::{End, Row};
use crate::body::Body;

/// The place of a joint on one body.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mount {
    pub(super) body: usize,
    /// From the centre of mass [m], body axes.
    anchor: DVec3,
    /// Joint frame -> body axes, as quaternion and as matrix.
    frame: DQuat,
    axes: DMat3,
}

impl Mount {
    pub(super) fn new(body: usize, anchor: DVec3, frame: DQuat) -> Self {
        let frame = frame.normalize();
        Self {
            body,
            anchor,
            frame,
            axes: DMat3::from_quat(frame),
        }
    }

    /// Centre of mass -> anchor [m], world axes.
    pub(super) fn arm(&self, bodies: &[Body]) -> DVec3 {
        bodies[self.body].rotation * self.anchor
    }
}

/// Both ends in the world. Pairs are (A, B).
#[derive(Clone, Copy, Debug)]
pub(super) struct Placement<'a> {
    pub(super) bodies: (usize, usize),
    /// Centre of mass -> anchor [m].
    pub(super) arms: (DVec3, DVec3),
    /// Columns x, y, z of the joint frame on A.
    pub(super) axes: DMat3,
    /// d: anchor of A -> anchor of B [m].
    pub(super) gap: DVec3,
    mounts: &'a [Mount; 2],
    placed: (&'a Body, &'a Body),
}

impl<'a> Placement<'a> {
    pub(super) fn new(mounts: &'a [Mount; 2], bodies: &'a [Body]) -> Self {
        let [a, b] = mounts;
        let (body_a, body_b) = (&bodies[a.body], &bodies[b.body]);
        let arms = (body_a.rotation * a.anchor, body_b.rotation * b.anchor);
        Self {
            bodies: (a.body, b.body),
            arms,
            axes: body_a.rotation * a.axes,
            gap: (body_b.state.position - body_a.state.position) + (arms.1 - arms.0),
            mounts,
            placed: (body_a, body_b),
        }
    }

    /// Columns x, y, z of the joint frame on B.
    pub(super) fn axes_of_b(&self) -> DMat3 {
        self.placed.1.rotation * self.mounts[1].axes
    }

    /// Frame of B -> frame of A.
    pub(super) fn turn(&self) -> DQuat {
        let frame_a = self.placed.0.state.orientation * self.mounts[0].frame;
        let frame_b = self.placed.1.state.orientation * self.mounts[1].frame;
        frame_a.conjugate() * frame_b
    }

    /// A row that turns the bodies against each other: `angular` is its Jacobian of B, that of A the opposite.
    pub(super) fn turning(&self, angular: DVec3, value: f64, bias: f64) -> Row {
        let end = |body, angular| End {
            body,
            linear: DVec3::ZERO,
            angular,
        };
        Row {
            ends: [end(self.bodies.0, -angular), end(self.bodies.1, angular)],
            value,
            bias,
        }
    }

    /// A row that pulls the anchors apart along `e`; the force on A acts at the point `arm` from its centre of mass.
    #[inline(always)]
    pub(super) fn pulling(&self, e: DVec3, arm: DVec3, value: f64, bias: f64) -> Row {
        let a = End {
            body: self.bodies.0,
            linear: -e,
            angular: -arm.cross(e),
        };
        let b = End {
            body: self.bodies.1,
            linear: e,
            angular: self.arms.1.cross(e),
        };
        Row {
            ends: [a, b],
            value,
            bias,
        }
    }
}

/// How the ends move.
#[derive(Clone, Copy, Debug)]
pub(super) struct Motion {
    /// Angular velocities of A and B [rad/s].
    pub(super) spins: (DVec3, DVec3),
    /// d' [m/s]
    pub(super) gap_rate: DVec3,
    /// d'' without accelerations: omega_B x (omega_B x r_B) - omega_A x (omega_A x r_A) [m/s^2].
    pub(super) gap_bias: DVec3,
}

impl Motion {
    /// They stand still.
    pub(super) const NONE: Self = Self {
        spins: (DVec3::ZERO, DVec3::ZERO),
        gap_rate: DVec3::ZERO,
        gap_bias: DVec3::ZERO,
    };

    pub(super) fn new(at: &Placement, bodies: &[Body]) -> Self {
        let (a, b) = (&bodies[at.bodies.0], &bodies[at.bodies.1]);
        let spins = (a.angular_velocity, b.angular_velocity);
        let swing = (spins.0.cross(at.arms.0), spins.1.cross(at.arms.1));
        Self {
            spins,
            gap_rate: b.state.velocity - a.state.velocity + swing.1 - swing.0,
            gap_bias: spins.1.cross(swing.1) - spins.0.cross(swing.0),
        }
    }
}
