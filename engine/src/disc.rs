//! The disc that bounds friction, solved in closed form.

use crate::math::length;

/// The tangential impulse that stops the slip, or the one on the rim of the disc that opposes the slip that is left.
///
/// With K = diag(k) and b the slip without friction: p = -K^-1 b where |p| <= radius; else slip and impulse are
/// antiparallel, K p + b = -s p with s > 0 and |p| = radius, so p_i = -b_i / (k_i + s). The secular equation
/// |p(s)| = radius is solved by Newton on 1/|p|, which is nearly linear in s (More & Sorensen 1983).
pub(crate) fn friction_in_disc(b: (f64, f64), k: (f64, f64), radius: f64) -> (f64, f64) {
    let stop = (-b.0 / k.0, -b.1 / k.1);
    if stop.0 * stop.0 + stop.1 * stop.1 <= radius * radius {
        return stop;
    }
    if radius <= 0.0 {
        return (0.0, 0.0);
    }
    let slip = length(b.0, b.1);
    if radius * k.0.max(k.1) <= 1e-17 * slip {
        // K is lost beside s; of impulses that fade away over many steps the squares would underflow below.
        return (-b.0 / slip * radius, -b.1 / slip * radius);
    }
    let mut s = (slip / radius - k.0.max(k.1)).max(0.0);
    for _ in 0..20 {
        let p = (-b.0 / (k.0 + s), -b.1 / (k.1 + s));
        let size = length(p.0, p.1);
        let slope = -(p.0 * p.0 / (k.0 + s) + p.1 * p.1 / (k.1 + s)) / size;
        let move_by = (size - radius) / radius * size / slope;
        s -= move_by;
        if move_by.abs() <= 1e-14 * (k.0 + s) {
            break;
        }
    }
    let p = (-b.0 / (k.0 + s), -b.1 / (k.1 + s));
    let scale = radius / length(p.0, p.1);
    (p.0 * scale, p.1 * scale)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn friction_stops_the_slip_inside_the_disc() {
        let p = friction_in_disc((0.3, -0.2), (2.0, 5.0), 10.0);
        assert_eq!(p, (-0.15, 0.04));
    }

    #[test]
    fn a_disc_of_hardly_any_radius_is_reached() {
        for radius in [1e-18, 3.098e-120, 1e-300] {
            let p = friction_in_disc((0.53, 2.8e-18), (0.84, 0.84), radius);
            assert!((length(p.0 / radius, p.1 / radius) - 1.0).abs() < 1e-15);
            assert!(p.0 < 0.0);
        }
    }

    #[test]
    fn friction_on_the_rim_opposes_the_slip_that_is_left() {
        let (b, k, radius) = ((3.0, -2.0), (2.0, 7.0), 0.25);
        let p = friction_in_disc(b, k, radius);
        let slip = (b.0 + k.0 * p.0, b.1 + k.1 * p.1);
        assert!((length(p.0, p.1) - radius).abs() < 1e-15);
        assert!((slip.0 * p.1 - slip.1 * p.0).abs() < 1e-12, "antiparallel");
        assert!(slip.0 * p.0 + slip.1 * p.1 < 0.0);
    }
}
