//! What is simulated: settings, bodies, geometry and the pair table, as plain values.

use glam::{DMat3, DVec3};

use crate::body::{MassProperties, State};
use crate::force::ForceModel;
use crate::integrator::Integrator;
use crate::joint::{DriveModel, JointModel};
use crate::motion::Motion;
use crate::shape::{Pose, Shape};

/// How an overlap is taken back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stabilization {
    /// By moving positions only: the kinetic energy stays as it is.
    SplitImpulse,
    /// By a velocity beta / dt times the depth, added to the constraint (Baumgarte 1972).
    Baumgarte,
}

/// The numbers of the scene's `world` and `simulation`.
#[derive(Clone, Debug)]
pub struct Settings {
    /// [s]
    pub timestep: f64,
    /// How a step is made.
    pub integrator: Integrator,
    /// Every impact ends a part of the step at its instant.
    pub located: bool,
    /// Sweeps of the solver at most.
    pub iterations: usize,
    /// Residual [m/s] below which the solver stops.
    pub tolerance: f64,
    /// How an overlap is taken back.
    pub stabilization: Stabilization,
    /// Part of the overlap that is taken back per step.
    pub baumgarte: f64,
    /// Slip [m/s] below which static friction holds.
    pub slip_speed: f64,
    /// Approach speed [m/s] below which restitution counts as 0.
    pub bounce_speed: f64,
    /// Every pair is answered by FCL.
    pub fcl_only: bool,
}

impl Settings {
    /// Steps are divided at impacts. The Euler schemes have no path inside a step but the parabola through their
    /// positions, on which every impact has its instant already; dividing their steps would only change their error.
    #[must_use]
    pub fn locates(&self) -> bool {
        self.located && self.integrator.lead() == 0.5
    }
}

/// A collision shape on a body.
#[derive(Clone, Debug)]
pub struct Geom {
    /// Index of the body.
    pub body: usize,
    /// Its shape in its own frame.
    pub shape: Shape,
    /// Origin in body axes, from the centre of mass [m].
    pub position: DVec3,
    /// Geom axes -> body axes.
    pub rotation: DMat3,
    /// Index into the pair table.
    pub material: usize,
}

impl Geom {
    /// Pose in the world when the body's centre-of-mass frame has this pose.
    #[must_use]
    pub fn pose(&self, body: &Pose) -> Pose {
        Pose {
            position: body.position + body.rotation * self.position,
            rotation: body.rotation * self.rotation,
        }
    }
}

/// The coefficients of one pair of materials.
#[derive(Clone, Copy, Debug, Default)]
pub struct Coefficients {
    /// Newton's coefficient of restitution, 0 ..= 1.
    pub restitution: f64,
    /// mu_s
    pub static_friction: f64,
    /// mu_k
    pub kinetic_friction: f64,
    /// Greatest torque against rolling per normal force [m].
    pub rolling_friction: f64,
    /// Greatest torque against spinning about the normal per normal force [m].
    pub spinning_friction: f64,
}

/// The resolved matrix of materials.
#[derive(Clone, Debug, Default)]
pub struct PairTable {
    count: usize,
    entries: Vec<Coefficients>,
}

impl PairTable {
    /// `entries` row by row, `count` rows.
    #[must_use]
    pub fn new(count: usize, entries: Vec<Coefficients>) -> Self {
        debug_assert_eq!(count * count, entries.len());
        Self { count, entries }
    }

    /// Number of materials.
    #[must_use]
    pub fn len(&self) -> usize {
        self.count
    }

    /// No materials at all.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Of the materials `a` and `b`.
    #[must_use]
    pub fn get(&self, a: usize, b: usize) -> Coefficients {
        self.entries[a * self.count + b]
    }
}

/// Everything that a world is built from.
#[derive(Clone, Debug)]
pub struct Model {
    /// World and simulation settings.
    pub settings: Settings,
    /// Mass properties, state at the start and angular velocity [rad/s] of every body; the state's angular momentum
    /// is not read.
    pub bodies: Vec<(MassProperties, State, DVec3)>,
    /// Collision shapes, grouped by nothing: each names its body.
    pub geoms: Vec<Geom>,
    /// Material pairs.
    pub pairs: PairTable,
    /// Pairs of bodies that do not touch.
    pub no_contact: Vec<(usize, usize)>,
    /// Forces on bodies.
    pub forces: ForceModel,
    /// Joints; the body behind the last one is the world.
    pub joints: Vec<JointModel>,
    /// What limits and drives joints.
    pub drives: Vec<DriveModel>,
    /// Fixed bodies that follow a path.
    pub motions: Vec<Motion>,
    /// Velocity of each body's surface against it [m/s], body axes; bodies beyond the end have none.
    pub surface_velocities: Vec<DVec3>,
}
