//! The contacts that carry, solved together by an interior-point method: dear, but it finds them from any start.
//!
//! A guess at the contacts that carry and stick (see `carrying.rs`) is quick where it is nearly right. In a wall that has
//! been rattled hundreds of corners hold or not, and each wrong one tips a body. Here no contact is taken for open or
//! closed before the end. With mu n taken out of the normals, impulse x (times K: as a speed) and
//! velocity s lie in Lorentz' cone L, |x_t| <= x_n and |s_t| <= s_n, and are orthogonal (De Saxce & Feng 1998):
//!
//! ```text
//! x = K (mu p_n, p_t),   s = ((v_n + mu |v_t|) / mu, v_t) + R (x - x0),   x o s = 0
//! M w = J^T (p - p0)
//! ```
//!
//! with the compliance R about the impulses x0 that stand. The path x o s = nu^2 e is followed from the middle of the
//! cone to nu = 0, in the scaling of Nesterov and Todd, by Mehrotra's predictor and corrector (Vandenberghe 2010, "The
//! CVXOPT linear and quadratic cone program solvers"); mu |v_t| follows from step to step. The matrix of its steps is
//! that of `direct.rs`, with (W^2 + R)^-1 for the contacts.

use glam::{DMat3, DVec3};

use crate::direct::{Direct, Six};
use crate::lorentz::{self, Scaling};
use crate::math::length;
use crate::mover::Mover;
use crate::point::Point;

/// R, which makes redundant contacts harmless.
const COMPLIANCE: f64 = 1e-8;
/// Steps at most.
const STEPS: usize = 30;
/// Part of the way to the cone's boundary that a step goes.
const NEARLY: f64 = 0.95;
/// nu at the start is at least this [m/s].
const WIDTH: f64 = 1e-5;
/// Friction below this makes the cone too narrow.
const NARROW: f64 = 0.01;

/// A contact on its way.
#[derive(Clone, Copy, Debug)]
struct Track {
    axes: DMat3,
    friction: f64,
    /// K of the normal [1/kg].
    k: f64,
    start: DVec3,
    /// Relative velocity along normal and tangents [m/s].
    velocity: DVec3,
    x: DVec3,
    s: DVec3,
    scaling: Scaling,
    /// (W^2 + R)^-1
    inverse: DMat3,
    /// What x gains in the step at hand while the velocity stays.
    gain: DVec3,
    /// What s lacks of the velocity.
    missing: DVec3,
    /// Of the step at hand.
    step: (DVec3, DVec3),
    change: DVec3,
}

impl Track {
    fn of(p: &Point, movers: &[Mover], width: f64) -> Self {
        let narrowed = |p: DVec3, mu: f64| DVec3::new(mu * p.x, p.y, p.z);
        let start = narrowed(p.impulse, p.cone.friction) * p.cone.k[0];
        let mut track = Self {
            axes: p.frame(),
            friction: p.cone.friction,
            k: p.cone.k[0],
            start,
            velocity: p.velocity(movers),
            x: start,
            s: DVec3::ZERO,
            scaling: Scaling::default(),
            inverse: DMat3::ZERO,
            gain: DVec3::ZERO,
            missing: DVec3::ZERO,
            step: (DVec3::ZERO, DVec3::ZERO),
            change: DVec3::ZERO,
        };
        track.x.x = start.x.max(length(start.y, start.z) + width);
        track.s = track.aim();
        let least = width * (width / track.x.x).min(1.0);
        track.s.x = track.s.x.max(length(track.s.y, track.s.z) + least);
        track
    }

    fn widened(&self, v: DVec3) -> DVec3 {
        DVec3::new(v.x / self.friction, v.y, v.z)
    }

    /// s but for the compliance.
    fn aim(&self) -> DVec3 {
        let slip = length(self.velocity.y, self.velocity.z);
        self.widened(self.velocity) + DVec3::X * slip
    }

    /// The impulse that x stands for [N s].
    fn impulse(&self, x: DVec3) -> DVec3 {
        self.widened(x) / self.k
    }

    fn scale(&mut self) {
        self.scaling = Scaling::of(self.x, self.s);
        self.inverse = self.scaling.square(|w| 1.0 / (w + COMPLIANCE));
    }

    /// What the contact resists with, in world axes.
    fn stiffness(&self) -> DMat3 {
        let widen = DMat3::from_diagonal(DVec3::new(1.0 / self.friction, 1.0, 1.0));
        let local = widen * self.inverse * widen * (1.0 / self.k);
        self.axes * local * self.axes.transpose()
    }

    /// Aim at x o s = nu^2 e; `correct` for what the last step's curvature adds.
    fn prepare(&mut self, nu_squared: f64, correct: bool) {
        let (w, lambda) = (&self.scaling, self.scaling.times(self.x));
        let mut r = DVec3::X * nu_squared - lorentz::product(lambda, lambda);
        if correct {
            r -= lorentz::product(w.times(self.step.0), w.divide(self.step.1));
        }
        self.missing = self.aim() + (self.x - self.start) * COMPLIANCE - self.s;
        let wanted = w.times(lorentz::quotient(r, lambda));
        self.gain = self.inverse * (wanted - self.missing);
    }

    /// The step that follows from the change of the velocity.
    fn answer(&mut self, change: DVec3) {
        self.change = change;
        let wide = self.widened(change);
        let x = self.gain - self.inverse * wide;
        self.step = (x, wide + x * COMPLIANCE + self.missing);
    }

    /// How far the step may go.
    fn room(&self) -> f64 {
        lorentz::room(self.x, self.step.0).min(lorentz::room(self.s, self.step.1))
    }

    fn after(&self, part: f64) -> (DVec3, DVec3) {
        (self.x + self.step.0 * part, self.s + self.step.1 * part)
    }

    fn advance(&mut self, part: f64) {
        (self.x, self.s) = self.after(part);
        self.velocity += self.change * part;
    }
}

/// Working memory of the solve.
#[derive(Clone, Debug, Default)]
pub(crate) struct Interior {
    tracks: Vec<Track>,
    /// w
    moved: Vec<Six>,
    step: Vec<Six>,
}

impl Interior {
    /// Contacts that it is made for.
    pub(crate) fn suits(points: &[Point]) -> bool {
        let suited = |p: &Point| p.quiet && p.cone.friction > NARROW && p.cone.give == 0.0;
        points.iter().all(suited)
    }

    /// Push the contacts to where they all reach what they ask for. Begins as wide as `residual` [m/s], ends at
    /// `tolerance`. Only where the matrix' `products` are known.
    pub(crate) fn solve(
        &mut self,
        direct: &mut Direct,
        (points, movers): (&mut [Point], &mut [Mover]),
        (residual, tolerance): (f64, f64),
    ) {
        let width = residual.max(WIDTH);
        self.tracks.clear();
        let tracks = points.iter().map(|p| Track::of(p, movers, width));
        self.tracks.extend(tracks);
        direct.begin(movers, &mut self.moved);
        for _ in 0..STEPS {
            let gap = self.gap(0.0);
            if gap <= tolerance * tolerance {
                break;
            }
            self.tracks.iter_mut().for_each(Track::scale);
            let stiffness = self.tracks.iter().map(|t| Some(t.stiffness()));
            direct.factorise(points, stiffness);
            self.descend(direct, points, 0.0, false);
            let centring = (self.gap(self.room().min(1.0)) / gap).powi(3).min(1.0);
            self.descend(direct, points, centring * gap, true);
            let part = (NEARLY * self.room()).min(1.0);
            self.tracks.iter_mut().for_each(|t| t.advance(part));
            let moved = self.moved.iter_mut().flatten();
            let step = self.step.iter().flatten();
            moved.zip(step).for_each(|(w, d)| *w += d * part);
        }
        for (track, p) in self.tracks.iter().zip(points) {
            let change = track.impulse(track.x) - p.impulse;
            if change.is_finite() {
                p.impulse += change;
                p.push(movers, change);
            }
        }
    }

    /// Mean of x . s after a part of the step.
    #[allow(clippy::cast_precision_loss)]
    fn gap(&self, part: f64) -> f64 {
        let product = |t: &Track| {
            let (x, s) = t.after(part);
            x.dot(s)
        };
        self.tracks.iter().map(product).sum::<f64>() / self.tracks.len() as f64
    }

    fn room(&self) -> f64 {
        let rooms = self.tracks.iter().map(Track::room);
        rooms.fold(f64::INFINITY, f64::min)
    }

    /// The step towards x o s = nu^2 e.
    fn descend(&mut self, direct: &Direct, points: &[Point], nu_squared: f64, correct: bool) {
        direct.momenta(&self.moved, &mut self.step);
        self.step.iter_mut().flatten().for_each(|x| *x = -*x);
        for (t, p) in self.tracks.iter_mut().zip(points) {
            t.prepare(nu_squared, correct);
            let gained = t.impulse(t.x + t.gain - t.start);
            direct.add_impulse(&mut self.step, p, gained);
        }
        direct.divide(&mut self.step);
        for (t, p) in self.tracks.iter_mut().zip(points) {
            t.answer(direct.relative(p, &self.step));
        }
    }
}
