//! Springs and dampers between two bodies.

use glam::DVec3;

use super::law::Acts;
use super::linear::LinearSpring;
use super::sum::Sum;
use super::torsional::TorsionalSpring;
use crate::body::Body;

/// What a spring measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpringKind {
    /// The distance of two points.
    Linear,
    /// The angle of the second body about an axis of the first.
    Torsional,
}

/// A spring as declared.
#[derive(Clone, Debug)]
pub struct SpringModel {
    /// Linear or torsional.
    pub kind: SpringKind,
    /// Indices of A and B.
    pub bodies: [usize; 2],
    /// Its ends from the centres of mass, body axes [m].
    pub anchors: [DVec3; 2],
    /// Unit axis in each body's axes, the same in the world at the start; not read of linear springs.
    pub axes: [DVec3; 2],
    /// Length [m] or angle since the start [rad] without force.
    pub rest: f64,
    /// [N/m] or [N m/rad]
    pub stiffness: f64,
    /// [N s/m] or [N m s/rad]
    pub damping: f64,
    /// Tension at rest [N] or [N m].
    pub preload: f64,
    /// When it acts.
    pub acts: Acts,
    /// (extension, tension), instead of the stiffness when not empty.
    pub force_curve: Vec<(f64, f64)>,
    /// (rate of extension, tension), instead of the damping when not empty.
    pub damping_curve: Vec<(f64, f64)>,
}

/// A spring of either kind.
#[derive(Clone, Debug)]
pub(super) enum Spring {
    Linear(LinearSpring),
    Torsional(TorsionalSpring),
}

impl Spring {
    pub(super) fn new(model: SpringModel, bodies: &[Body]) -> Self {
        match model.kind {
            SpringKind::Linear => Self::Linear(LinearSpring::new(&model)),
            SpringKind::Torsional => Self::Torsional(TorsionalSpring::new(&model, bodies)),
        }
    }

    pub(super) fn add(&self, sum: &mut Sum<'_>) {
        match self {
            Self::Linear(spring) => spring.add(sum),
            Self::Torsional(spring) => spring.add(sum),
        }
    }

    /// Stored energy [J].
    pub(super) fn energy(&self, bodies: &[Body]) -> f64 {
        match self {
            Self::Linear(spring) => spring.energy(bodies),
            Self::Torsional(spring) => spring.energy(bodies),
        }
    }

    /// Length and tension, or angle and torque.
    pub(super) fn reading(&self, bodies: &[Body]) -> (f64, f64) {
        match self {
            Self::Linear(spring) => spring.reading(bodies),
            Self::Torsional(spring) => spring.reading(bodies),
        }
    }

    pub(super) fn is_damped(&self) -> bool {
        match self {
            Self::Linear(spring) => spring.law.is_damped(),
            Self::Torsional(spring) => spring.law.is_damped(),
        }
    }

    pub(super) fn observe(&mut self, bodies: &[Body]) {
        if let Self::Torsional(spring) = self {
            spring.observe(bodies);
        }
    }

    /// The angle [rad] that a torsional spring saw last.
    pub(super) fn observed(&self) -> Option<f64> {
        match self {
            Self::Linear(_) => None,
            Self::Torsional(spring) => Some(spring.observed),
        }
    }

    pub(super) fn observed_mut(&mut self) -> Option<&mut f64> {
        match self {
            Self::Linear(_) => None,
            Self::Torsional(spring) => Some(&mut spring.observed),
        }
    }
}
