//! What a spring answers to its extension and to the rate of it, be it a length or an angle.

use super::spring::SpringModel;
use crate::curve::Curve;

/// When a spring acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Acts {
    /// At any length.
    Always,
    /// As a rope: only when longer than at rest, and it never pushes.
    Tension,
    /// As a bumper: only when shorter than at rest, and it never pulls.
    Compression,
}

impl Acts {
    /// Sign of the tension that it may have.
    fn sign(self) -> Option<f64> {
        match self {
            Self::Always => None,
            Self::Tension => Some(1.0),
            Self::Compression => Some(-1.0),
        }
    }
}

/// Tension by its origin, both [N] or both [N m]; positive brings the extension back.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Tension {
    /// The derivative of the stored energy by the extension.
    pub(super) elastic: f64,
    /// All of it.
    pub(super) total: f64,
}

/// With the extension x beyond rest:
///
///   T = k x + preload + c dx/dt      (or f(x) for k x, d(dx/dt) for c dx/dt),
///
/// acting as a rope: 0 for x <= 0, else max(0, T), and its elastic part max(0, k x + preload); as a bumper the same with
/// the signs turned. The stored energy is the integral of the elastic part from x = 0: k x^2 / 2 + preload x. What a
/// bound on T takes off the elastic part is booked as damping, as it is the damper that slows the spring down.
#[derive(Clone, Debug)]
pub(super) struct Law {
    rest: f64,
    elastic: Curve,
    damping: Curve,
    acts: Acts,
}

impl Law {
    pub(super) fn new(model: &SpringModel) -> Self {
        let whole = Self::curve(&model.force_curve, model.stiffness).raised(model.preload);
        Self {
            rest: model.rest,
            elastic: match model.acts.sign() {
                Some(sign) => whole.clipped(sign),
                None => whole,
            },
            damping: Self::curve(&model.damping_curve, model.damping),
            acts: model.acts,
        }
    }

    fn curve(samples: &[(f64, f64)], slope: f64) -> Curve {
        if samples.is_empty() {
            Curve::line(0.0, slope)
        } else {
            Curve::extended(samples)
        }
    }

    /// At a length or angle and its rate of change.
    pub(super) fn tension(&self, coordinate: f64, rate: f64) -> Tension {
        let extension = coordinate - self.rest;
        if !self.reaches(extension) {
            return Tension::default();
        }
        let elastic = self.elastic.value(extension);
        let free = elastic + self.damping.value(rate);
        let total = match self.acts {
            Acts::Always => free,
            Acts::Tension => free.max(0.0),
            Acts::Compression => free.min(0.0),
        };
        Tension { elastic, total }
    }

    /// Stored energy [J].
    pub(super) fn energy(&self, coordinate: f64) -> f64 {
        let extension = coordinate - self.rest;
        if self.reaches(extension) {
            self.elastic.integral(extension)
        } else {
            0.0
        }
    }

    pub(super) fn is_damped(&self) -> bool {
        !self.damping.is_zero()
    }

    fn reaches(&self, extension: f64) -> bool {
        self.acts.sign().is_none_or(|s| s * extension > 0.0)
    }
}
