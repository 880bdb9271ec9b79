//! Factors that follow a course in time, and the window in which they count.

mod integral;
mod jet;
mod moment;
mod program;
#[cfg(test)]
mod tests;

use std::f64::consts::TAU;
use std::sync::Arc;

pub use integral::Integral;
pub use moment::Moment;
pub use program::Program;

use crate::curve::Curve;

/// A factor as a function of the time t [s] since its start. Rates are those to the right of t; a jump has rate 0.
#[derive(Clone, Debug, PartialEq)]
pub enum Profile {
    /// 1
    Constant,
    /// sin(2 pi f t + phase)
    Sine {
        /// [Hz]
        frequency: f64,
        /// [rad]
        phase: f64,
    },
    /// From 0 to 1 along a straight line, then 1.
    Ramp {
        /// Time of the rise [s].
        over: f64,
    },
    /// 0 before, 1 from then on.
    Step {
        /// [s]
        at: f64,
    },
    /// Straight lines between samples, constant outside.
    Table(Curve),
    /// A formula.
    Expression(Program),
}

impl Profile {
    /// The factor at `t`.
    #[must_use]
    pub fn value(&self, t: f64) -> f64 {
        self.derivatives(t)[0]
    }

    /// The factor at `t` and its rate of change [1/s].
    #[must_use]
    pub fn value_and_rate(&self, t: f64) -> (f64, f64) {
        let [value, rate, _] = self.derivatives(t);
        (value, rate)
    }

    /// The factor at `t`, its rate of change [1/s] and the rate of that [1/s^2].
    #[must_use]
    pub fn derivatives(&self, t: f64) -> [f64; 3] {
        match self {
            Self::Constant => [1.0, 0.0, 0.0],
            Self::Sine { frequency, phase } => {
                let w = TAU * frequency;
                let (sin, cos) = libm::sincos(w * t + phase);
                [sin, w * cos, -w * w * sin]
            }
            Self::Ramp { .. } if t < 0.0 => [0.0; 3],
            Self::Ramp { over } if t < *over => [t / over, 1.0 / over, 0.0],
            Self::Ramp { .. } => [1.0, 0.0, 0.0],
            Self::Step { at } => [f64::from(u8::from(t >= *at)), 0.0, 0.0],
            Self::Table(curve) => {
                let (value, slope) = curve.value_and_slope(t);
                [value, slope, 0.0]
            }
            Self::Expression(program) => program.derivatives(t),
        }
    }

    /// Integral from 0 to `t` >= 0 [s] where it is known in closed form; `None` for expressions.
    fn closed_integral(&self, t: f64) -> Option<f64> {
        match self {
            Self::Constant => Some(t),
            Self::Sine { frequency, phase } => {
                // (cos p - cos(p + x)) / w = 2 sin(x/2) sin(p + x/2) / w with x = w t: no difference of near equals.
                let half = 0.5 * TAU * frequency * t;
                let mean = if half == 0.0 {
                    1.0
                } else {
                    libm::sin(half) / half
                };
                Some(t * mean * libm::sin(phase + half))
            }
            Self::Ramp { over } if t < *over => Some(0.5 * t * t / over),
            Self::Ramp { over } => Some(t - 0.5 * over),
            Self::Step { at } => Some((t - at.max(0.0)).max(0.0)),
            Self::Table(curve) => Some(curve.integral(t)),
            Self::Expression(_) => None,
        }
    }
}

/// A profile that starts at `from` and counts until `until`.
#[derive(Clone, Debug, PartialEq)]
pub struct Schedule {
    /// Shared between all that follow it; `None` is the constant 1.
    pub profile: Option<Arc<Profile>>,
    /// [s]
    pub from: f64,
    /// [s], may be infinite; no longer part of the window.
    pub until: f64,
}

impl Default for Schedule {
    /// 1 at all times from 0 on.
    fn default() -> Self {
        Self {
            profile: None,
            from: 0.0,
            until: f64::INFINITY,
        }
    }
}

impl Schedule {
    /// The factor at a moment of a step: where the window begins or ends inside the step, the share of the step that it
    /// covers times the profile at the nearest instant in it. A constant force from any instant until any other so gives
    /// its exact impulse in every integrator; seen as on or off at the nodes of a step it would be off by up to a step.
    #[must_use]
    pub fn factor(&self, moment: Moment) -> f64 {
        let share = |from: f64| moment.share(from, self.until);
        match self.profile.as_deref() {
            None | Some(Profile::Constant) => share(self.from),
            Some(Profile::Step { at }) => share(self.from + at.max(0.0)),
            Some(profile) => match share(self.from) {
                0.0 => 0.0,
                part => part * profile.value(moment.time.clamp(self.from, self.until) - self.from),
            },
        }
    }

    /// The factor, its rate of change [1/s] and the rate of that [1/s^2], all 0 outside [from, until).
    #[must_use]
    pub fn derivatives(&self, t: f64) -> [f64; 3] {
        if t < self.from || t >= self.until {
            return [0.0; 3];
        }
        self.profile
            .as_ref()
            .map_or([1.0, 0.0, 0.0], |p| p.derivatives(t - self.from))
    }
}
