//! Lorentz' cone x_n >= |x_t| in three dimensions, its algebra, and the scaling of Nesterov and Todd.

use glam::{DMat3, DVec3};

use crate::math::length;

/// x_n^2 - |x_t|^2, which is positive inside.
fn determinant(x: DVec3) -> f64 {
    let t = length(x.y, x.z);
    ((x.x - t) * (x.x + t)).max(f64::MIN_POSITIVE)
}

/// a o b = (a . b, a_n b_t + b_n a_t)
pub(crate) fn product(a: DVec3, b: DVec3) -> DVec3 {
    DVec3::new(a.dot(b), a.x * b.y + b.x * a.y, a.x * b.z + b.x * a.z)
}

/// The x for which by o x = r.
pub(crate) fn quotient(r: DVec3, by: DVec3) -> DVec3 {
    let normal = (by.x * r.x - by.y * r.y - by.z * r.z) / determinant(by);
    DVec3::new(
        normal,
        (r.y - normal * by.y) / by.x,
        (r.z - normal * by.z) / by.x,
    )
}

/// How many times d may be added to x, which lies inside, before it leaves the cone.
pub(crate) fn room(x: DVec3, d: DVec3) -> f64 {
    let a = d.x * d.x - d.y * d.y - d.z * d.z;
    let b = x.x * d.x - x.y * d.y - x.z * d.z;
    let c = determinant(x);
    let square = b * b - a * c;
    let q = -(b + square.max(0.0).sqrt().copysign(b));
    let roots = if square >= 0.0 {
        [q / a, c / q]
    } else {
        [-1.0; 2]
    };
    let side = if d.x < 0.0 { -x.x / d.x } else { f64::INFINITY };
    let ahead = roots.into_iter().filter(|&root| root > 0.0);
    ahead.fold(side, f64::min)
}

/// W, symmetric, maps the cone onto itself and x and s to the same point: W x = W^-1 s. It is beta P(w), w of
/// determinant 1.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Scaling {
    w: DVec3,
    beta: f64,
}

impl Scaling {
    /// Of two points inside.
    pub(crate) fn of(x: DVec3, s: DVec3) -> Self {
        let (of_x, of_s) = (determinant(x), determinant(s));
        let (x, s) = (x / of_x.sqrt(), s / of_s.sqrt());
        let gamma = (2.0 * (1.0 + x.dot(s))).sqrt();
        Self {
            w: (s + DVec3::new(x.x, -x.y, -x.z)) / gamma,
            beta: (of_s / of_x).sqrt().sqrt(),
        }
    }

    fn apply(w: DVec3, x: DVec3) -> DVec3 {
        let along = w.y * x.y + w.z * x.z;
        let factor = x.x + along / (1.0 + w.x);
        DVec3::new(w.x * x.x + along, x.y + factor * w.y, x.z + factor * w.z)
    }

    /// W x
    pub(crate) fn times(&self, x: DVec3) -> DVec3 {
        Self::apply(self.w, x) * self.beta
    }

    /// W^-1 x
    pub(crate) fn divide(&self, x: DVec3) -> DVec3 {
        Self::apply(DVec3::new(self.w.x, -self.w.y, -self.w.z), x) / self.beta
    }

    /// f(W^2), by its eigenvalues.
    pub(crate) fn square(&self, f: impl Fn(f64) -> f64) -> DMat3 {
        let (w, scale) = (self.w, self.beta * self.beta);
        let t = length(w.y, w.z);
        let (c, s) = if t > 0.0 {
            (w.y / t, w.z / t)
        } else {
            (1.0, 0.0)
        };
        let most = (w.x + t) * (w.x + t);
        let (along, against, aside) = (f(scale * most), f(scale / most), f(scale));
        let (mean, half) = (0.5 * (along + against), 0.5 * (along - against));
        let (y, z, yz) = (
            mean * c * c + aside * s * s,
            mean * s * s + aside * c * c,
            (mean - aside) * c * s,
        );
        DMat3::from_cols(
            DVec3::new(mean, half * c, half * s),
            DVec3::new(half * c, y, yz),
            DVec3::new(half * s, yz, z),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const X: DVec3 = DVec3::new(2.0, 0.5, -1.2);
    const S: DVec3 = DVec3::new(0.3, 0.1, 0.2);

    fn near(a: DVec3, b: DVec3) -> bool {
        (a - b).abs().max_element() < 1e-13
    }

    #[test]
    fn both_are_scaled_to_one_point() {
        let w = Scaling::of(X, S);
        assert!(near(w.times(X), w.divide(S)));
        assert!(near(w.divide(w.times(X)), X));
        assert!(near(w.square(|w| w) * X, S));
        assert!(near(w.square(|w| 1.0 / w) * S, X));
    }

    #[test]
    fn a_quotient_undoes_a_product() {
        assert!(near(quotient(product(X, S), X), S));
    }

    #[test]
    fn room_ends_at_the_boundary() {
        let d = DVec3::new(-0.4, 1.0, 0.3);
        let end = X + d * room(X, d);
        assert!((end.x - length(end.y, end.z)).abs() < 1e-14);
        assert_eq!(room(X, DVec3::new(1.0, 0.2, 0.0)), f64::INFINITY);
    }
}
