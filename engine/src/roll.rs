//! Rolling and spinning friction: the angular impulse of a contact.
//!
//! Bodies that give way a little touch in a patch, and a patch resists turning as a point does not. With p_n the normal
//! impulse and w = omega_A - omega_B the relative angular velocity, w_n along the normal and w_t across it, the angular
//! impulse (q_n, q_t) on A, B getting the opposite, keeps
//!
//! ```text
//! spinning  |q_n| <= l_s p_n;  w_n = 0 inside the bounds;  q_n = -l_s p_n sign(w_n) at them
//! rolling   |q_t| <= l_r p_n;  w_t = 0 inside the disc;    q_t = -l_r p_n w_t / |w_t| on its rim
//! ```
//!
//! with two lengths l_s, `spinning_friction`, and l_r, `rolling_friction`, of the pair of materials: dry friction of
//! turning (Le Saux, Leine & Glocker 2005, "Dynamics of a rolling disk in the presence of dry friction", J. Nonlinear
//! Sci. 15). Neither knows of the slip of the contact: the law is the simple one in which the three do not couple.

use glam::{DMat3, DVec3};

use crate::body::Body;
use crate::disc::friction_in_disc;
use crate::math::length;
use crate::model::Coefficients;
use crate::response::Principal;

/// What a contact with rolling or spinning friction has beside its other data. Few pairs of materials have it, so that
/// it is kept apart.
#[derive(Clone, Debug)]
pub struct Roll {
    /// Bound of the spinning part, per normal impulse [m].
    pub spinning: f64,
    /// Bound of the rolling part, per normal impulse [m].
    pub rolling: f64,
    /// Columns: the normal, and the two directions across it in which the rolling part of K is diagonal.
    pub axes: DMat3,
    /// Diagonal of K = I_A^-1 + I_B^-1 along the axes [1/(kg m^2)].
    pub k: DVec3,
    /// What a spinning impulse does to the two rolling velocities [1/(kg m^2)].
    k_coupling: (f64, f64),
    /// Angular impulse of the solve at hand, along the axes [N m s].
    pub impulse: DVec3,
}

impl Roll {
    /// Of a contact between bodies A and B; None where the materials let turn freely, or where nothing can turn.
    #[must_use]
    pub fn new(
        coefficients: &Coefficients,
        a: &Body,
        b: &Body,
        normal: DVec3,
    ) -> Option<Box<Self>> {
        let (spinning, rolling) = (
            coefficients.spinning_friction,
            coefficients.rolling_friction,
        );
        if spinning == 0.0 && rolling == 0.0 {
            return None;
        }
        let inverse = a.inverse_inertia + b.inverse_inertia;
        let Principal { axes, k, coupling } = Principal::of(&inverse, normal);
        // A thin rod cannot be spun up about its own axis: a torque that does nothing may have any bound but no pole.
        let least = 1e-12 * k.max_element();
        (least > 0.0).then(|| {
            Box::new(Self {
                spinning,
                rolling,
                axes,
                k: k.max(DVec3::splat(least)),
                k_coupling: coupling,
                impulse: DVec3::ZERO,
            })
        })
    }

    /// World vector of components along the axes.
    #[must_use]
    pub fn to_world(&self, local: DVec3) -> DVec3 {
        self.axes * local
    }

    /// Components of a world vector along the axes.
    #[must_use]
    pub fn to_local(&self, vector: DVec3) -> DVec3 {
        self.axes.transpose() * vector
    }

    /// The angular impulse brought into its bounds under a normal impulse.
    #[must_use]
    pub fn in_bounds(&self, impulse: DVec3, normal_impulse: f64) -> DVec3 {
        let (bound, radius) = (
            self.spinning * normal_impulse,
            self.rolling * normal_impulse,
        );
        let size = length(impulse.y, impulse.z);
        let scale = if size > radius { radius / size } else { 1.0 };
        DVec3::new(
            impulse.x.clamp(-bound, bound),
            impulse.y * scale,
            impulse.z * scale,
        )
    }

    /// The exact answer to a relative angular velocity `w` along the axes, which the present impulse has led to.
    #[must_use]
    pub fn answer(&self, w: DVec3, normal_impulse: f64) -> DVec3 {
        let (old, bound) = (self.impulse, self.spinning * normal_impulse);
        let spin = (old.x - w.x / self.k.x).clamp(-bound, bound);
        let change = spin - old.x;
        let b1 = w.y + self.k_coupling.0 * change - self.k.y * old.y;
        let b2 = w.z + self.k_coupling.1 * change - self.k.z * old.z;
        let radius = self.rolling * normal_impulse;
        let (q1, q2) = friction_in_disc((b1, b2), (self.k.y, self.k.z), radius);
        DVec3::new(spin, q1, q2)
    }

    /// A change of the angular impulse as a speed, comparable with those of a contact whose normal has this K [m/s]:
    /// an angular velocity times sqrt(k_n / k), the arm at which it would cost the same energy.
    #[must_use]
    pub fn speed_of(&self, change: DVec3, k_normal: f64) -> f64 {
        let scale = self.k * k_normal;
        let speed = |q: f64, s: f64| q.abs() * s.sqrt();
        speed(change.x, scale.x)
            .max(speed(change.y, scale.y))
            .max(speed(change.z, scale.z))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::{MassProperties, State};

    fn body(moments: DVec3) -> Body {
        Body::new(
            MassProperties::new(1.0, DMat3::from_diagonal(moments)),
            State::default(),
        )
    }

    fn coefficients(rolling_friction: f64, spinning_friction: f64) -> Coefficients {
        Coefficients {
            restitution: 0.0,
            static_friction: 0.5,
            kinetic_friction: 0.5,
            rolling_friction,
            spinning_friction,
        }
    }

    fn roll(rolling: f64, spinning: f64) -> Box<Roll> {
        let normal = DVec3::new(2.0, -1.0, 2.0) / 3.0;
        let bodies = (
            body(DVec3::new(1.0, 2.0, 2.5)),
            body(DVec3::new(0.5, 0.7, 0.4)),
        );
        Roll::new(
            &coefficients(rolling, spinning),
            &bodies.0,
            &bodies.1,
            normal,
        )
        .unwrap()
    }

    #[test]
    fn materials_that_turn_freely_have_none() {
        let one = body(DVec3::ONE);
        assert!(Roll::new(&coefficients(0.0, 0.0), &one, &one, DVec3::Z).is_none());
        let fixed = Body::new(MassProperties::fixed(), State::default());
        assert!(Roll::new(&coefficients(1.0, 1.0), &fixed, &fixed, DVec3::Z).is_none());
    }

    /// The velocity after the answer, by the full matrix: stopped where the bounds allow it.
    #[test]
    fn wide_bounds_stop_all_turning() {
        let mut roll = roll(10.0, 10.0);
        roll.impulse = DVec3::new(0.1, -0.2, 0.3);
        let w = DVec3::new(0.4, 1.0, -0.7);
        let new = roll.answer(w, 1.0);
        let inverse = body(DVec3::new(1.0, 2.0, 2.5)).inverse_inertia
            + body(DVec3::new(0.5, 0.7, 0.4)).inverse_inertia;
        let after = w + roll.to_local(inverse * roll.to_world(new - roll.impulse));
        // Rolling stops for the new spinning impulse; spinning for the old rolling impulses.
        assert!(length(after.y, after.z) < 1e-14);
        assert!((w.x + roll.k.x * (new.x - roll.impulse.x)).abs() < 1e-14);
    }

    #[test]
    fn narrow_bounds_are_reached_against_the_turning() {
        let roll = roll(0.02, 0.05);
        let new = roll.answer(DVec3::new(-0.4, 1.0, -0.7), 2.0);
        assert_eq!(new.x, 0.1);
        assert!((length(new.y, new.z) - 0.04).abs() < 1e-15);
        assert!(new.y < 0.0 && new.z > 0.0);
        assert_eq!(roll.in_bounds(new * 0.5, 2.0), new * 0.5);
        let cut = roll.in_bounds(new * 3.0, 2.0);
        assert!((cut - new).length() < 1e-15);
    }
}
