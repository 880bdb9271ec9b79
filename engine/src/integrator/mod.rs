//! The six integrators: how forces and joints move bodies over a step.
//!
//! Contacts, motors, limits and dry friction were solved before; their impulses come as constant forces (`held`), so
//! that every scheme moves a sliding block or a resting one as exactly as a free one.
//!
//! Smooth forces f(x, v, t) are the scheme's own business. Bilateral joints are held the way that keeps its order:
//! the symplectic schemes choose the joint impulses of a drift so that the constraints hold at its end (SHAKE,
//! Ryckaert et al. 1977) and make the velocities obey them afterwards (RATTLE, Andersen 1983); the Runge-Kutta schemes
//! solve for the joint forces in every stage and project positions and velocities at the end.

mod divide;
mod dynamics;
mod held_drift;
mod rotation;
mod runge_kutta;
mod symplectic;

pub use dynamics::{accelerations_at, free_accelerations, Dynamics, Scratch};

use crate::body::Body;

/// How a step is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integrator {
    /// x += v dt, v += a dt, both from the start of the step.
    ExplicitEuler,
    /// v += a dt, then x += v dt with the new velocity.
    SemiImplicitEuler,
    /// Stoermer's x(t + dt) = 2 x(t) - x(t - dt) + a dt^2, with v(t) = (x(t + dt) - x(t - dt)) / (2 dt).
    Verlet,
    /// x += v dt + a dt^2 / 2, v += (a + a') dt / 2.
    VelocityVerlet,
    /// v(t + dt/2) = v(t - dt/2) + a dt, x += v(t + dt/2) dt, with v(t) the mean of its neighbours.
    Leapfrog,
    /// The classical Runge-Kutta scheme of fourth order.
    Rk4,
}

impl Integrator {
    /// Weight of the velocity at the end of a step in its displacement, under a constant force:
    /// x' - x = ((1 - lead) v + lead v') dt. Positions then lie on the parabola x + v t + a t (t + (2 lead - 1) dt) / 2.
    #[must_use]
    pub fn lead(self) -> f64 {
        match self {
            Self::ExplicitEuler => 0.0,
            Self::SemiImplicitEuler => 1.0,
            _ => 0.5,
        }
    }

    /// Momenta change after bodies moved; semi-implicit Euler moves them last.
    #[must_use]
    pub fn ends_with_kick(self) -> bool {
        self != Self::SemiImplicitEuler
    }

    /// Kicks and drifts.
    fn is_symplectic(self) -> bool {
        !matches!(self, Self::ExplicitEuler | Self::Rk4)
    }

    /// One step of the scheme over the span of `d`, whether its joints can be closed at its end or not.
    ///
    /// Stoermer-Verlet, velocity Verlet and leapfrog are one and the same map written in three ways, also with forces
    /// that depend on the velocity, once all their quantities are brought to whole steps (Hairer, Lubich & Wanner 2003,
    /// "Geometric numerical integration illustrated by the Stoermer-Verlet method", section 1): a kick of half a step, a
    /// drift, a kick of half a step. They run the same code here and give the same numbers.
    fn step(self, bodies: &mut [Body], d: &mut Dynamics) {
        match self {
            Self::ExplicitEuler => runge_kutta::EULER.advance(bodies, d),
            Self::SemiImplicitEuler => symplectic::euler(bodies, d),
            Self::Verlet | Self::VelocityVerlet | Self::Leapfrog => {
                symplectic::kick_drift_kick(bodies, d);
            }
            Self::Rk4 => runge_kutta::CLASSICAL.advance(bodies, d),
        }
    }
}
