//! An empty scene under gravity, for the tests to fill.

use _engine::body::{MassProperties, State};
use _engine::force::ForceModel;
use _engine::integrator::Integrator;
use _engine::joint::{JointModel, Kind};
use _engine::model::{Coefficients, Geom, Model, PairTable, Settings, Stabilization};
use _engine::shape::Shape;
use glam::{DMat3, DQuat, DVec3};

/// [m/s^2]
pub const G: f64 = 9.81;

/// One material, no bodies; stepped by semi-implicit Euler.
pub fn empty_model(timestep: f64, restitution: f64, friction: f64) -> Model {
    let coefficients = Coefficients {
        restitution,
        static_friction: friction,
        kinetic_friction: friction,
        rolling_friction: 0.0,
        spinning_friction: 0.0,
    };
    Model {
        settings: Settings {
            timestep,
            integrator: Integrator::SemiImplicitEuler,
            located: false,
            iterations: 50,
            tolerance: 1e-6,
            stabilization: Stabilization::SplitImpulse,
            baumgarte: 0.2,
            slip_speed: 0.01,
            bounce_speed: 0.0,
            fcl_only: false,
        },
        bodies: Vec::new(),
        geoms: Vec::new(),
        pairs: PairTable::new(1, vec![coefficients]),
        no_contact: Vec::new(),
        forces: ForceModel {
            gravity: DVec3::new(0.0, 0.0, -G),
            ..ForceModel::default()
        },
        joints: Vec::new(),
        drives: Vec::new(),
        motions: Vec::new(),
        surface_velocities: Vec::new(),
    }
}

/// A body of one shape at rest; returns its index.
#[allow(dead_code)] // not every test adds bodies this way
pub fn add(model: &mut Model, shape: Shape, position: DVec3, mass: MassProperties) -> usize {
    let state = State {
        position,
        orientation: DQuat::IDENTITY,
        velocity: DVec3::ZERO,
        angular_momentum: DVec3::ZERO,
    };
    let body = model.bodies.len();
    model.geoms.push(Geom {
        body,
        shape,
        position: DVec3::ZERO,
        rotation: DMat3::IDENTITY,
        material: 0,
    });
    model.bodies.push((mass, state, DVec3::ZERO));
    body
}

/// Ball joints that tie each body, `half` of its own length behind its centre, to the end of the one before, and the
/// first to the world's origin.
#[allow(dead_code)] // not every test has joints
pub fn tie_in_a_row(model: &mut Model, half: DVec3) {
    let bodies = model.bodies.len();
    for k in 0..bodies {
        // The world is the body behind the last one.
        let (before, anchor) = match k {
            0 => (bodies, DVec3::ZERO),
            _ => (k - 1, half),
        };
        model.joints.push(JointModel {
            kind: Kind::Ball,
            bodies: [before, k],
            anchors: [anchor, -half],
            frames: [DQuat::IDENTITY; 2],
            damping: 0.0,
            break_force: f64::INFINITY,
            break_torque: f64::INFINITY,
        });
    }
}
