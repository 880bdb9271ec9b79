//! How far a rate that follows a profile has led.

use std::sync::Arc;

use super::Profile;

/// Width of the panels whose integrals are kept [s]. It bounds the work of one evaluation, not the accuracy: panels are
/// halved where the formula needs it. A power of two, so that the limits are exact.
const PANEL: f64 = 1.0 / 128.0;
/// Halvings of a panel at most; a kink then lies in a piece of 2 microseconds.
const HALVINGS: u32 = 12;
/// A panel is good when halving it moves its integral by less than this part of the integral of |f|.
const TOLERANCE: f64 = 1e-13;

/// Nodes and weights of Gauss-Legendre quadrature with 8 points on [-1, 1], exact to degree 15 (Abramowitz & Stegun
/// 1964, table 25.4).
const RULE: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];

/// The integral of a profile over the time since its start: closed form where there is one, Gauss-Legendre for
/// expressions. A pure function of the profile and the time; what is kept only saves work.
#[derive(Clone, Debug)]
pub struct Integral {
    /// `None` is the constant 1.
    profile: Option<Arc<Profile>>,
    /// Of an expression: the integrals from 0 to the ends of the panels, 0 first.
    sums: Vec<f64>,
}

impl Integral {
    /// Of this profile; `None` is the constant 1.
    #[must_use]
    pub fn new(profile: Option<Arc<Profile>>) -> Self {
        Self {
            profile,
            sums: vec![0.0],
        }
    }

    /// From 0 to `t` [s]; 0 for negative `t`.
    #[must_use]
    pub fn value(&self, t: f64) -> f64 {
        let t = t.max(0.0);
        let Some(profile) = &self.profile else {
            return t;
        };
        if let Some(closed) = profile.closed_integral(t) {
            return closed;
        }
        let whole = panels(t);
        let kept = whole.min(self.sums.len() - 1);
        let sum = (kept..whole).fold(self.sums[kept], |sum, k| sum + panel(profile, k));
        sum + adaptive(profile, start(whole), t, HALVINGS)
    }

    /// Keep the panels up to `t` [s], so that values from there on cost one panel.
    pub fn observe(&mut self, t: f64) {
        let Some(profile) = &self.profile else {
            return;
        };
        if !matches!(**profile, Profile::Expression(_)) {
            return;
        }
        for k in self.sums.len() - 1..panels(t.max(0.0)) {
            self.sums.push(self.sums[k] + panel(profile, k));
        }
    }
}

/// Number of whole panels before `t`.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn panels(t: f64) -> usize {
    (t / PANEL).floor() as usize
}

/// Where the panel `k` starts [s].
#[allow(clippy::cast_precision_loss)]
fn start(k: usize) -> f64 {
    k as f64 * PANEL
}

fn panel(profile: &Profile, k: usize) -> f64 {
    adaptive(profile, start(k), start(k + 1), HALVINGS)
}

/// Integral from `a` to `b`, halved until halving changes nothing any more.
fn adaptive(profile: &Profile, a: f64, b: f64, halvings: u32) -> f64 {
    let middle = 0.5 * (a + b);
    let (whole, _) = gauss_legendre(profile, a, b);
    let (left, left_size) = gauss_legendre(profile, a, middle);
    let (right, right_size) = gauss_legendre(profile, middle, b);
    let both = left + right;
    let bad = (whole - both).abs() > TOLERANCE * (left_size + right_size);
    if bad && halvings > 0 {
        adaptive(profile, a, middle, halvings - 1) + adaptive(profile, middle, b, halvings - 1)
    } else {
        both
    }
}

/// Integrals of f and of |f| from `a` to `b`.
fn gauss_legendre(profile: &Profile, a: f64, b: f64) -> (f64, f64) {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    let (mut sum, mut size) = (0.0, 0.0);
    for (node, weight) in RULE {
        for x in [-node, node] {
            let f = profile.value(middle + half * x);
            sum += weight * f;
            size += weight * f.abs();
        }
    }
    (half * sum, half * size)
}
