//! What an impulse in a point of contact does to the relative velocity there: the collision matrix K (Mirtich 1996), and
//! K along a normal and the tangents in which friction is simplest.

use glam::{DMat3, DVec3};

use crate::body::Body;
use crate::math::tangents;

/// Tangential eigenvalues that differ by less than this share have no directions worth finding.
const EQUAL: f64 = 1e-9;

/// K: its columns are the relative velocities that unit impulses along x, y and z give,
///
/// ```text
/// K = (1/m_A + 1/m_B) 1 - [r_A] I_A^-1 [r_A] - [r_B] I_B^-1 [r_B],    [r] d = r x d    [1/kg]
/// ```
#[inline]
pub(crate) fn response(a: &Body, b: &Body, arms: (DVec3, DVec3)) -> DMat3 {
    let straight = a.mass.inverse_mass + b.mass.inverse_mass;
    let mut k = DMat3::from_diagonal(DVec3::splat(straight));
    for (body, arm) in [(a, arms.0), (b, arms.1)] {
        if !body.is_fixed() {
            k += turning_response(&body.inverse_inertia, arm);
        }
    }
    k
}

/// -[r] I^-1 [r]: column d is (I^-1 (r x d)) x r.
fn turning_response(inverse: &DMat3, r: DVec3) -> DMat3 {
    let (x, y, z) = (inverse.x_axis, inverse.y_axis, inverse.z_axis);
    DMat3::from_cols(
        (y * r.z - z * r.y).cross(r),
        (z * r.x - x * r.z).cross(r),
        (x * r.y - y * r.x).cross(r),
    )
}

/// A symmetric K along a normal and two tangents between which it has no coupling, so that the friction disc can be
/// solved in closed form.
pub(crate) struct Principal {
    /// Normal, tangent 1, tangent 2 = normal x tangent 1.
    pub(crate) axes: DMat3,
    /// Diagonal of K: normal, tangent 1, tangent 2.
    pub(crate) k: DVec3,
    /// K between the normal and the two tangents.
    pub(crate) coupling: (f64, f64),
}

impl Principal {
    #[inline]
    pub(crate) fn of(k: &DMat3, normal: DVec3) -> Self {
        let (u, w) = tangents(normal);
        let (kn, ku) = (*k * normal, *k * u);
        let (uu, uw, ww) = (ku.dot(u), ku.dot(w), (*k * w).dot(w));
        let (c, s, eigenvalues) = diagonalise(uu, uw, ww);
        let (nu, nw) = (kn.dot(u), kn.dot(w));
        Self {
            axes: DMat3::from_cols(normal, u * c + w * s, w * c - u * s),
            k: DVec3::new(kn.dot(normal), eigenvalues.0, eigenvalues.1),
            coupling: (nu * c + nw * s, nw * c - nu * s),
        }
    }
}

/// Cosine and sine of the angle by which u and w are turned into the eigenvectors of ((uu, uw), (uw, ww)), and its
/// eigenvalues, the greater one first.
fn diagonalise(uu: f64, uw: f64, ww: f64) -> (f64, f64, (f64, f64)) {
    let (half, middle) = (0.5 * (uu - ww), 0.5 * (uu + ww));
    let radius = (half * half + uw * uw).sqrt();
    if radius <= 2.0 * EQUAL * middle {
        return (1.0, 0.0, (uu, ww));
    }
    // Eigenvector of the greater eigenvalue; of the two forms the one without cancellation.
    let (c, s) = if half >= 0.0 {
        (radius + half, uw)
    } else {
        (uw, radius - half)
    };
    let shorten = 1.0 / (c * c + s * s).sqrt();
    (c * shorten, s * shorten, (middle + radius, middle - radius))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::{MassProperties, State};
    use glam::DQuat;

    fn body(mass: f64, moments: DVec3, turned: DVec3) -> Body {
        let state = State {
            orientation: DQuat::from_scaled_axis(turned),
            ..State::default()
        };
        Body::new(
            MassProperties::new(mass, DMat3::from_diagonal(moments)),
            state,
        )
    }

    /// Impulses on two bodies, against the relative velocity that they then have.
    #[test]
    fn an_impulse_changes_the_velocity_by_k() {
        let fixed = Body::new(MassProperties::fixed(), State::default());
        let a = body(2.0, DVec3::new(0.3, 0.4, 0.5), DVec3::new(0.3, -0.8, 0.1));
        let b = body(0.7, DVec3::new(0.1, 0.1, 0.02), DVec3::new(1.0, 0.2, 0.4));
        let arms = (DVec3::new(0.1, 0.7, -0.3), DVec3::new(-0.4, 0.2, 0.5));
        for (a, b) in [(&a, &b), (&a, &fixed), (&fixed, &b)] {
            let k = response(a, b, arms);
            for impulse in DVec3::AXES {
                let (mut a, mut b) = (a.clone(), b.clone());
                a.apply_impulse(impulse, arms.0);
                b.apply_impulse(-impulse, arms.1);
                let gained = a.velocity_at(arms.0) - b.velocity_at(arms.1);
                assert!((gained - k * impulse).length() < 1e-13);
            }
        }
    }

    #[test]
    fn tangents_have_no_coupling() {
        let a = body(2.0, DVec3::new(0.3, 0.4, 0.5), DVec3::new(0.3, -0.8, 0.1));
        let fixed = Body::new(MassProperties::fixed(), State::default());
        for arm in [DVec3::new(0.1, 0.7, -0.3), DVec3::new(-2.0, 0.1, 0.4)] {
            let k = response(&a, &fixed, (arm, DVec3::ZERO));
            for normal in [DVec3::Z, DVec3::NEG_Z, DVec3::new(0.6, 0.0, -0.8)] {
                let principal = Principal::of(&k, normal);
                let axes = principal.axes;
                let local = axes.transpose() * k * axes;
                assert!((axes.transpose() * axes).abs_diff_eq(DMat3::IDENTITY, 1e-15));
                assert!((axes.determinant() - 1.0).abs() < 1e-14 && axes.x_axis == normal);
                let expected = DMat3::from_cols(
                    DVec3::new(principal.k.x, principal.coupling.0, principal.coupling.1),
                    DVec3::new(principal.coupling.0, principal.k.y, 0.0),
                    DVec3::new(principal.coupling.1, 0.0, principal.k.z),
                );
                assert!(local.abs_diff_eq(expected, 1e-13));
                assert!(principal.k.y >= principal.k.z && principal.k.z > 0.0);
            }
        }
    }
}
