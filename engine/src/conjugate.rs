//! Sweeps that converge faster: each pair of them, forwards and backwards, carries on what the pairs before were about.
//!
//! With y the impulses of an island and the motions that they lead to, and S(y) what a pair of sweeps makes of them, the
//! directions d that y goes are made conjugate, as by Fletcher & Reeves 1964 (Silcowitz-Hansen, Niebe & Erleben 2010, "A
//! nonsmooth nonlinear conjugate gradient method for interactive contact force problems", The Visual Computer 26):
//!
//! ```text
//! g = S(y) - y,   beta = |g|^2 / |g before|^2, 0 where this is not below 1,   d := g + beta d,   y := y + d
//! ```
//!
//! in the norm of what impulses do to their own contacts. Motions are linear in impulses, so they take part like them.
//! Impulses may leave their cones by it; the next sweep brings them back.

use pulp::Simd;

use crate::lanes::{Four, Lanes, WIDTH};

/// Some numbers, four abreast, at the start of the pair of sweeps at hand, and where they went by the last one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Course<const N: usize> {
    start: [Four; N],
    direction: [Four; N],
}

impl<const N: usize> Course<N> {
    /// At rest.
    pub(crate) fn of(start: [Four; N]) -> Self {
        Self {
            start,
            direction: [[0.0; WIDTH]; N],
        }
    }

    /// The share of |g|^2 of the numbers that stand `now`, in the norm of `k`.
    #[inline(always)]
    pub(crate) fn square<S: Simd>(&self, simd: S, now: &[Four; N], k: &[Four; N]) -> Lanes<S> {
        let mut sum = Lanes::load(simd, [0.0; WIDTH]);
        for ((now, start), k) in now.iter().zip(&self.start).zip(k) {
            let [now, start, k] = [now, start, k].map(|x| Lanes::load(simd, *x));
            let g = now - start;
            sum = sum + g * g * k;
        }
        sum
    }

    /// Carry the numbers that stand `now` on.
    #[inline(always)]
    pub(crate) fn carry_on<S: Simd>(&mut self, simd: S, now: &mut [Four; N], beta: f64) {
        let load = |x| Lanes::load(simd, x);
        let beta = load([beta; WIDTH]);
        let course = self.start.iter().zip(&mut self.direction);
        for (now, (start, direction)) in now.iter_mut().zip(course) {
            let next = load(*now) + beta * load(*direction);
            *direction = (next - load(*start)).store();
            *now = next.store();
        }
        self.start = *now;
    }
}

/// An island's impulses and motions, pack by pack and body by body.
#[derive(Clone, Debug)]
pub(crate) struct Conjugate {
    pub(crate) impulses: Vec<Course<3>>,
    pub(crate) motions: Vec<Course<2>>,
    /// |g|^2 of the last pair of sweeps.
    square: f64,
}

impl Default for Conjugate {
    fn default() -> Self {
        Self {
            impulses: Vec::new(),
            motions: Vec::new(),
            square: f64::INFINITY,
        }
    }
}

impl Conjugate {
    /// Impulses and motions are no longer those of the sweeps before.
    pub(crate) fn clear(&mut self) {
        self.impulses.clear();
        self.motions.clear();
        self.square = f64::INFINITY;
    }

    /// beta after a pair of sweeps of this |g|^2.
    pub(crate) fn beta(&mut self, square: f64) -> f64 {
        let last = std::mem::replace(&mut self.square, square);
        if square < last {
            square / last
        } else {
            0.0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_that_do_not_get_on_begin_anew() {
        let mut conjugate = Conjugate::default();
        let squares = [4.0, 1.0, 2.0, 1.0, 0.0, 0.0];
        let betas = squares.map(|square| conjugate.beta(square));
        assert_eq!(betas, [0.0, 0.25, 0.0, 0.5, 0.0, 0.0]);
    }
}
