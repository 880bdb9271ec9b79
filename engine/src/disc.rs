//! The disc that bounds friction, solved in closed form; for one contact, or for several abreast.

use crate::lanes::{Mask, Real};

/// A vector in the plane of contact.
pub(crate) type Pair<T> = (T, T);

/// The tangential impulse that stops the slip, or the one on the rim of the disc that opposes the slip that is left;
/// with K = diag(k) and b the slip without friction, p = -K^-1 b where |p| <= radius.
pub(crate) fn friction_in_disc<T: Real>(b: Pair<T>, k: Pair<T>, radius: T) -> Pair<T> {
    let stop = (-b.0 / k.0, -b.1 / k.1);
    let slides = is_inside(stop, radius).not();
    if !slides.any() {
        return stop;
    }
    let rim = friction_on_rim(b, k, radius, slides);
    (slides.select(rim.0, stop.0), slides.select(rim.1, stop.1))
}

/// The impulse on the rim, of those that slide.
///
/// Slip and impulse are antiparallel, K p + b = -s p with s > 0 and |p| = radius, so p_i = -b_i / (k_i + s). Where both k
/// are the same, or lost beside s, p is antiparallel to b.
#[inline(always)]
pub(crate) fn friction_on_rim<T: Real>(
    b: Pair<T>,
    k: Pair<T>,
    radius: T,
    slides: T::Mask,
) -> Pair<T> {
    let zero = radius.constant(0.0);
    let slip = length(b);
    let askew = ((k.0 - k.1).abs() * radius)
        .within(slip * slip.constant(1e-15))
        .not();
    let open = slides.and(askew);
    let d = if open.any() {
        let s = root_of_secular_equation(b, k, (radius, slip), open);
        let d = direction(b, (k.0 + s, k.1 + s));
        (open.select(d.0, b.0), open.select(d.1, b.1))
    } else {
        b
    };
    let scale = radius.within(zero).select(zero, -radius / length(d));
    (d.0 * scale, d.1 * scale)
}

/// Along (b_1 / k_1, b_2 / k_2).
#[inline(always)]
fn direction<T: Real>(b: Pair<T>, k: Pair<T>) -> Pair<T> {
    (b.0 * k.1, b.1 * k.0)
}

/// Of |p(s)| = radius, for those that are `open`, by Newton on 1/|p|, which is nearly linear in s (More & Sorensen 1983):
///
/// ```text
/// s -> s + (|p| - radius) / radius  |p|^2 / (p_1^2 / (k_1 + s) + p_2^2 / (k_2 + s))
/// ```
///
/// from where it is for small differences of k: s = |b| / radius less the mean of k along b.
#[inline(always)]
fn root_of_secular_equation<T: Real>(
    b: Pair<T>,
    k: Pair<T>,
    (radius, slip): (T, T),
    mut open: T::Mask,
) -> T {
    let one = slip.constant(1.0);
    let (squares, square) = ((b.0 * b.0, b.1 * b.1), slip * slip);
    let mean = (k.0 * squares.0 + k.1 * squares.1) / square;
    let mut s = (slip / radius - mean).max(slip.constant(0.0));
    for _ in 0..20 {
        let (one_s, two_s) = (k.0 + s, k.1 + s);
        let both = one / (one_s * two_s);
        let give = (two_s * both, one_s * both);
        let p = (b.0 * give.0, b.1 * give.1);
        let squares = (p.0 * p.0, p.1 * p.1);
        let square = squares.0 + squares.1;
        let slope = squares.0 * give.0 + squares.1 * give.1;
        let move_by = (square.sqrt() - radius) * square / (radius * slope);
        s = open.select((s + move_by).max(s.constant(0.0)), s);
        // It converges quadratically.
        let found = (move_by.abs() * give.0).within(s.constant(1e-8));
        open = open.and(found.not());
        if !open.any() {
            break;
        }
    }
    s
}

#[inline(always)]
pub(crate) fn is_inside<T: Real>(p: Pair<T>, radius: T) -> T::Mask {
    (p.0 * p.0 + p.1 * p.1).within(radius * radius)
}

#[inline(always)]
fn length<T: Real>(p: Pair<T>) -> T {
    (p.0 * p.0 + p.1 * p.1).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::length;

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
