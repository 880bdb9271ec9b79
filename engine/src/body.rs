//! A rigid body: what it is (mass properties) and where it is (state), both about the centre of mass.

use glam::{DMat3, DQuat, DVec3};
use serde::{Deserialize, Serialize};

use crate::math::symmetric_eigen;
use crate::shape::Pose;

/// Moments this near to each other, as a part of the greatest, are equal.
const EQUAL: f64 = 1e-12;

/// How the principal moments of inertia compare.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Symmetry {
    /// All are equal.
    Sphere,
    /// But for that about this principal axis.
    Axis(usize),
    /// No two are equal.
    None,
}

impl Symmetry {
    fn of(moments: DVec3) -> Self {
        let near =
            |a: usize, b: usize| (moments[a] - moments[b]).abs() <= EQUAL * moments.max_element();
        match (0..3).find(|&k| near((k + 1) % 3, (k + 2) % 3)) {
            Some(k) if near(k, (k + 1) % 3) => Self::Sphere,
            Some(k) => Self::Axis(k),
            None => Self::None,
        }
    }
}

/// Mass and principal moments of inertia. Fixed bodies have inverse mass and inverse moments zero.
#[derive(Clone, Debug)]
pub struct MassProperties {
    /// Mass [kg]; 0 for fixed bodies, which never enter a sum of momenta or energies.
    pub mass: f64,
    /// 1 / mass [1/kg], 0 for fixed bodies.
    pub inverse_mass: f64,
    /// Principal moments of inertia [kg m^2].
    pub moments: DVec3,
    /// Their inverses; 0 where the moment is 0 (a thin rod about its own axis cannot be spun up).
    pub inverse_moments: DVec3,
    /// Principal frame -> body frame.
    pub axes: DQuat,
    /// Of the moments.
    pub symmetry: Symmetry,
}

impl MassProperties {
    /// Of a body that nothing moves.
    #[must_use]
    pub fn fixed() -> Self {
        Self {
            mass: 0.0,
            inverse_mass: 0.0,
            moments: DVec3::ZERO,
            inverse_moments: DVec3::ZERO,
            axes: DQuat::IDENTITY,
            symmetry: Symmetry::Sphere,
        }
    }

    /// From the inertia tensor [kg m^2] about the centre of mass, in body axes.
    #[must_use]
    pub fn new(mass: f64, inertia: DMat3) -> Self {
        let (moments, axes) = symmetric_eigen(inertia);
        let negligible = 1e-12 * moments.max_element();
        let invert = |i: f64| if i > negligible { 1.0 / i } else { 0.0 };
        Self {
            mass,
            inverse_mass: 1.0 / mass,
            moments,
            inverse_moments: DVec3::new(invert(moments.x), invert(moments.y), invert(moments.z)),
            axes: DQuat::from_mat3(&axes).normalize(),
            symmetry: Symmetry::of(moments),
        }
    }
}

impl MassProperties {
    /// Inverse inertia tensor in world axes: the sum of e e^T / I over the principal axes e. Where two moments I are
    /// equal that is 1/I + e e^T (1/I_k - 1/I).
    fn inverse_inertia(&self, orientation: DQuat) -> DMat3 {
        let inverse = self.inverse_moments;
        match self.symmetry {
            Symmetry::Sphere => DMat3::from_diagonal(inverse),
            Symmetry::Axis(k) => {
                let across = inverse[(k + 1) % 3];
                let axis = (orientation * self.axes) * DVec3::AXES[k];
                let more = axis * (inverse[k] - across);
                symmetric(
                    more * axis + DVec3::splat(across),
                    (more.x * axis.y, more.x * axis.z, more.y * axis.z),
                )
            }
            Symmetry::None => {
                let principal = if self.axes == DQuat::IDENTITY {
                    DMat3::from_quat(orientation)
                } else {
                    DMat3::from_quat((orientation * self.axes).normalize())
                };
                symmetric_product(&principal, inverse)
            }
        }
    }
}

/// R diag(d) R^T, symmetric to the last bit.
fn symmetric_product(r: &DMat3, d: DVec3) -> DMat3 {
    let rows = r.transpose();
    let (a, b, c) = (rows.x_axis, rows.y_axis, rows.z_axis);
    let (da, db) = (a * d, b * d);
    let diagonal = DVec3::new(da.dot(a), db.dot(b), (c * d).dot(c));
    symmetric(diagonal, (da.dot(b), da.dot(c), db.dot(c)))
}

/// From its diagonal, and xy, xz, yz.
fn symmetric(diagonal: DVec3, (xy, xz, yz): (f64, f64, f64)) -> DMat3 {
    DMat3::from_cols(
        DVec3::new(diagonal.x, xy, xz),
        DVec3::new(xy, diagonal.y, yz),
        DVec3::new(xz, yz, diagonal.z),
    )
}

/// What moves: the state that integrators advance and checkpoints keep.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// Of the centre of mass [m].
    pub position: DVec3,
    /// Body axes -> world axes.
    pub orientation: DQuat,
    /// Of the centre of mass [m/s].
    pub velocity: DVec3,
    /// About the centre of mass, world axes [kg m^2/s].
    pub angular_momentum: DVec3,
}

impl State {
    /// This pose with the momenta of a body.
    #[must_use]
    pub(crate) fn with(&self, body: &Body) -> Self {
        Self {
            position: self.position,
            orientation: self.orientation,
            ..body.state
        }
    }
}

/// A body with everything that follows from its state and is asked for many times in a step.
#[derive(Clone, Debug)]
pub struct Body {
    /// What moves.
    pub state: State,
    /// What it is.
    pub mass: MassProperties,
    /// Rotation matrix of the orientation.
    pub rotation: DMat3,
    /// Inverse inertia tensor in world axes.
    pub inverse_inertia: DMat3,
    /// omega = I_world^-1 L, world axes [rad/s].
    pub angular_velocity: DVec3,
    /// Greatest distance of the body's geometry from its centre of mass [m].
    pub reach: f64,
    /// Velocity of its surface against the body, body axes [m/s]: a conveyor.
    pub surface_velocity: DVec3,
}

impl Body {
    /// Put a body of these mass properties into this state.
    #[must_use]
    pub fn new(mass: MassProperties, state: State) -> Self {
        let mut body = Self {
            state,
            mass,
            rotation: DMat3::IDENTITY,
            inverse_inertia: DMat3::ZERO,
            angular_velocity: DVec3::ZERO,
            reach: 0.0,
            surface_velocity: DVec3::ZERO,
        };
        body.refresh();
        body
    }

    /// Fixed bodies take no part in the motion.
    #[must_use]
    pub fn is_fixed(&self) -> bool {
        self.mass.inverse_mass == 0.0
    }

    /// Normalise the orientation and recompute what follows from the state.
    pub fn refresh(&mut self) {
        self.state.orientation = self.state.orientation.normalize();
        self.derive();
    }

    /// To a pose, but leave its inertia to the next `derive`.
    pub(crate) fn put(&mut self, position: DVec3, orientation: DQuat) {
        self.state.position = position;
        self.state.orientation = orientation;
        self.rotation = DMat3::from_quat(orientation);
    }

    /// What follows from the state: I_world^-1 = R I_body^-1 R^T, omega = I_world^-1 L.
    pub fn derive(&mut self) {
        self.rotation = DMat3::from_quat(self.state.orientation);
        self.inverse_inertia = self.mass.inverse_inertia(self.state.orientation);
        self.respin();
    }

    /// omega = I_world^-1 L.
    pub fn respin(&mut self) {
        // A fixed body that follows a prescribed path is told its angular velocity.
        if !self.is_fixed() {
            self.angular_velocity = self.inverse_inertia * self.state.angular_momentum;
        }
    }

    /// Give the body this angular velocity [rad/s], world axes: L = I_world omega.
    pub fn set_angular_velocity(&mut self, omega: DVec3) {
        let principal = DMat3::from_quat((self.state.orientation * self.mass.axes).normalize());
        self.state.angular_momentum =
            principal * (self.mass.moments * (principal.transpose() * omega));
        self.refresh();
    }

    /// Impulse `p` [N s] at the arm `r` from the centre of mass: dv = p/m, dL = r x p.
    pub fn apply_impulse(&mut self, p: DVec3, r: DVec3) {
        self.apply_wrench(p, r.cross(p));
    }

    /// Impulse `p` [N s] and angular impulse `turn` [N m s] about the centre of mass.
    pub fn apply_wrench(&mut self, p: DVec3, turn: DVec3) {
        if self.is_fixed() {
            return;
        }
        self.state.velocity += p * self.mass.inverse_mass;
        self.state.angular_momentum += turn;
        self.angular_velocity += self.inverse_inertia * turn;
    }

    /// Velocity of the material point at the arm `r` from the centre of mass: v + omega x r.
    #[must_use]
    pub fn velocity_at(&self, r: DVec3) -> DVec3 {
        self.state.velocity + self.angular_velocity.cross(r)
    }

    /// Move by a displacement [m] and a rotation vector [rad], taking the angular momentum along, so that the kinetic
    /// energy stays as it is.
    pub fn displace(&mut self, shift: DVec3, turn: DVec3) {
        let rotation = crate::math::rotation_from_vector(turn);
        self.state.position += shift;
        self.state.orientation = rotation * self.state.orientation;
        self.state.angular_momentum = rotation * self.state.angular_momentum;
        self.refresh();
    }

    /// The pose of the body's axes at its centre of mass.
    #[must_use]
    pub fn pose(&self) -> Pose {
        Pose {
            position: self.state.position,
            rotation: self.rotation,
        }
    }

    /// Translational and rotational kinetic energy [J]: m v^2 / 2, omega . L / 2.
    #[must_use]
    pub fn kinetic_energy(&self) -> (f64, f64) {
        (
            0.5 * self.mass.mass * self.state.velocity.length_squared(),
            0.5 * self.angular_velocity.dot(self.state.angular_momentum),
        )
    }
}
