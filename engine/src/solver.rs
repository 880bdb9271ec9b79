//! Contacts solved together: sweeps over the contacts, and conjugate gradients over those that carry.
//!
//! Unknown are the impulses p = (p_n, p_1, p_2) of every contact, with u = (u_n, u_1, u_2) its relative velocity after
//! all impulses. Asked is, for every contact at once,
//!
//! ```text
//! normal    0 <= p_n,  u_n >= target,  p_n (u_n - target) = 0             (Signorini)
//! friction  |p_t| <= mu p_n;  u_t = 0 inside the disc;  p_t = -mu p_n u_t / |u_t| on its rim   (Coulomb)
//! ```
//!
//! A sweep solves one contact after the other exactly, with the others held (projected Gauss-Seidel). Sweeps find out
//! quickly which contacts carry, which stick and which slide, but pass loads on slowly: for a light body under a heavy
//! one the error falls by 1 / (1 + m/M) a sweep. So after a few sweeps the contacts that carry are solved together as
//! a linear system by conjugate gradients, with open contacts open and sliding friction as it stands; sweeps then
//! check and mend the guess (subspace minimisation: Silcowitz, Niebe & Erleben 2010, "Projected Gauss-Seidel subspace
//! minimization method for interactive rigid body dynamics", GRAPP).

use glam::DVec3;

use crate::body::Body;
use crate::contact::{Contact, Friction};
use crate::islands::Islands;
use crate::math::length;
use crate::mover::{velocity_of, Mover, Part};
use crate::subspace::Subspace;

/// Sweeps between two linear solves.
const SWEEPS: usize = 4;
/// Passes of all linear solves together, per sweep allowed. With fewer a pyramid of 210 boxes does not come to rest.
const PASSES: usize = 6;
/// A linear solve goes on until its residual is this part of what it was: its guess of which contacts carry is seldom
/// worth more.
const LEAP: f64 = 1e-3;

/// What a solve came to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Report {
    /// Greatest change of a relative velocity in the last sweep of any island [m/s].
    pub residual: f64,
    /// Sweeps made, in the island that took most.
    pub iterations: usize,
}

/// How far to go.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Sweeps at most.
    pub iterations: usize,
    /// Stop below this residual [m/s].
    pub tolerance: f64,
}

impl Limits {
    /// A part of the sweeps.
    fn share(self, parts: usize) -> Self {
        Self {
            iterations: self.iterations.div_ceil(parts),
            ..self
        }
    }
}

impl Report {
    fn then(self, next: Self) -> Self {
        Self {
            residual: next.residual,
            iterations: self.iterations + next.iterations,
        }
    }
}

/// Working memory, kept from solve to solve.
#[derive(Clone, Debug, Default)]
pub struct Solver {
    movers: Vec<Mover>,
    /// Impulses with the least residual so far.
    best: Vec<DVec3>,
    subspace: Subspace,
    islands: Islands,
    island: Vec<usize>,
    residuals: Vec<f64>,
}

impl Solver {
    /// Solve the contacts named by `which`, from the impulses that stand in them. The result stays in
    /// `contact.impulse`; bodies are not touched.
    pub fn solve(
        &mut self,
        bodies: &[Body],
        contacts: &mut [Contact],
        which: &[usize],
        limits: Limits,
    ) -> Report {
        self.load(bodies, contacts, which);
        self.residuals.clear();
        self.residuals.resize(bodies.len(), 0.0);
        let mut report = Report::default();
        let (mut islands, mut island) = (
            std::mem::take(&mut self.islands),
            std::mem::take(&mut self.island),
        );
        islands.divide(bodies, contacts, which);
        let mut start = 0;
        while let Some(next) = islands.take(start, &mut island) {
            start = next;
            let one = self.solve_island(contacts, &island, limits);
            report.residual = report.residual.max(one.residual);
            report.iterations = report.iterations.max(one.iterations);
            for &k in &island {
                self.residuals[contacts[k].bodies.0] = one.residual;
                self.residuals[contacts[k].bodies.1] = one.residual;
            }
        }
        (self.islands, self.island) = (islands, island);
        report
    }

    /// Residual of the last solve around each body [m/s].
    #[must_use]
    pub fn residuals(&self) -> &[f64] {
        &self.residuals
    }

    /// First how much each contact carries, with friction as it stands: friction that is cut off at a cone which is
    /// still too narrow would leave the contacts of a body straining against each other. Static contacts that gave way
    /// slide from there on, and others may give way then; a third of the sweeps is kept for that. It ends, because a
    /// contact changes only from static to kinetic. What slips only because the sweeps have not arrived is not let go.
    fn solve_island(
        &mut self,
        contacts: &mut [Contact],
        which: &[usize],
        limits: Limits,
    ) -> Report {
        let mut report = self.iterate(contacts, which, Part::Normals, limits.share(3));
        report = report.then(self.iterate(contacts, which, Part::All, limits.share(3)));
        while report.iterations < limits.iterations {
            let noticeable = 10.0 * report.residual.max(limits.tolerance);
            let released = self.release_slipping(contacts, which, noticeable);
            if !released && report.residual < limits.tolerance {
                break;
            }
            let left = Limits {
                iterations: limits.iterations - report.iterations,
                ..limits
            };
            report = report.then(self.iterate(contacts, which, Part::All, left));
        }
        report
    }

    fn load(&mut self, bodies: &[Body], contacts: &[Contact], which: &[usize]) {
        self.movers.clear();
        self.movers.extend(bodies.iter().map(Mover::of));
        for &k in which {
            let contact = &contacts[k];
            if contact.impulse != DVec3::ZERO {
                self.push(contact, contact.impulse);
            }
        }
    }

    /// Sweeps and linear solves in turn, until a sweep changes nothing any more. Ends with a sweep, so that every
    /// impulse lies in its cone. A linear solve may guess wrongly which contacts carry, and the next sweeps then have
    /// more to mend than before: the next guess waits longer, and where the sweeps run out the best impulses are taken.
    fn iterate(
        &mut self,
        contacts: &mut [Contact],
        which: &[usize],
        part: Part,
        limits: Limits,
    ) -> Report {
        let mut iterations = 0;
        let mut best = f64::INFINITY;
        let mut patience = SWEEPS;
        let mut passes = PASSES * limits.iterations;
        loop {
            let mut residual = f64::INFINITY;
            for _ in 0..patience {
                residual = self.sweep(contacts, which, part, iterations % 2 == 1);
                iterations += 1;
                if residual < limits.tolerance || iterations >= limits.iterations {
                    break;
                }
            }
            if residual < limits.tolerance {
                return Report {
                    residual,
                    iterations,
                };
            }
            if residual > 0.5 * best {
                patience *= 2;
            }
            if residual < best {
                best = residual;
                self.best.clear();
                self.best.extend(which.iter().map(|&k| contacts[k].impulse));
            }
            if iterations >= limits.iterations {
                self.return_to_best(contacts, which);
                return Report {
                    residual: best,
                    iterations,
                };
            }
            passes -= self.leap(contacts, which, part, passes, limits.tolerance / residual);
        }
    }

    fn return_to_best(&mut self, contacts: &mut [Contact], which: &[usize]) {
        for (slot, &k) in which.iter().enumerate() {
            let change = self.best[slot] - contacts[k].impulse;
            contacts[k].impulse = self.best[slot];
            self.push(&contacts[k], change);
        }
    }

    /// One sweep; returns the greatest change of a relative velocity [m/s]. Every other sweep goes backwards: what a
    /// stack passes on reaches both its ends.
    fn sweep(
        &mut self,
        contacts: &mut [Contact],
        which: &[usize],
        part: Part,
        backwards: bool,
    ) -> f64 {
        let mut worst = 0.0_f64;
        for step in 0..which.len() {
            let slot = if backwards {
                which.len() - 1 - step
            } else {
                step
            };
            let contact = &mut contacts[which[slot]];
            let old = contact.impulse;
            self.solve_contact(contact, part);
            let change = (contact.impulse - old) * contact.stiffness();
            worst = worst.max(change.abs().max_element());
        }
        worst
    }

    /// Solve the contacts that carry as a linear system, and bring the result back into the cones. Returns the number
    /// of passes over the contacts that it took, at most `budget`.
    fn leap(
        &mut self,
        contacts: &mut [Contact],
        which: &[usize],
        part: Part,
        budget: usize,
        reduction: f64,
    ) -> usize {
        let reduction = (0.1 * reduction).max(LEAP);
        let passes = self
            .subspace
            .solve(contacts, which, part, &self.movers, (budget, reduction));
        for (slot, &k) in which.iter().enumerate() {
            let old = contacts[k].impulse;
            let new = match part {
                Part::Normals => {
                    (old + self.subspace.step(slot)).max(DVec3::new(0.0, f64::MIN, f64::MIN))
                }
                Part::All => contacts[k].in_cone(old + self.subspace.step(slot)),
            };
            contacts[k].impulse = new;
            self.push(&contacts[k], new - old);
        }
        passes
    }

    /// The exact answer of one contact, the others held.
    fn solve_contact(&mut self, c: &mut Contact, part: Part) {
        let u = velocity_of(&self.movers, c);
        let old = c.impulse;
        let normal = (old.x - (u.x - c.target) / c.k_normal).max(0.0);
        let change = normal - old.x;
        // Velocity of the tangents with the new normal impulse and without friction.
        let b1 = u.y + c.k_coupling.0 * change - c.k_tangent.0 * old.y;
        let b2 = u.z + c.k_coupling.1 * change - c.k_tangent.1 * old.z;
        let (p1, p2) = match part {
            Part::Normals => (old.y, old.z),
            Part::All => friction_in_disc((b1, b2), c.k_tangent, c.friction_coefficient() * normal),
        };
        c.impulse = DVec3::new(normal, p1, p2);
        let difference = c.impulse - old;
        if difference != DVec3::ZERO {
            self.push(c, difference);
        }
    }

    fn push(&mut self, c: &Contact, impulse: DVec3) {
        let p = c.to_world(impulse);
        self.movers[c.bodies.0].push(p, c.arms.0);
        self.movers[c.bodies.1].push(-p, c.arms.1);
    }

    /// Static contacts on the rim of their disc that slip nevertheless become kinetic.
    fn release_slipping(&self, contacts: &mut [Contact], which: &[usize], noticeable: f64) -> bool {
        let mut any = false;
        for &k in which {
            let c = &mut contacts[k];
            let full = c.coefficients.static_friction * c.impulse.x;
            let held = length(c.impulse.y, c.impulse.z) < full * (1.0 - 1e-9);
            if c.friction == Friction::Kinetic || held || c.impulse.x == 0.0 {
                continue;
            }
            let u = velocity_of(&self.movers, c);
            if length(u.y, u.z) > noticeable {
                c.friction = Friction::Kinetic;
                any = true;
            }
        }
        any
    }
}

/// The tangential impulse that stops the slip, or the one on the rim of the disc that opposes the slip that is left.
///
/// With K = diag(k) and b the slip without friction: p = -K^-1 b where |p| <= radius; else slip and impulse are
/// antiparallel, K p + b = -s p with s > 0 and |p| = radius, so p_i = -b_i / (k_i + s). The secular equation
/// |p(s)| = radius is solved by Newton on 1/|p|, which is nearly linear in s (More & Sorensen 1983).
fn friction_in_disc(b: (f64, f64), k: (f64, f64), radius: f64) -> (f64, f64) {
    let stop = (-b.0 / k.0, -b.1 / k.1);
    if stop.0 * stop.0 + stop.1 * stop.1 <= radius * radius {
        return stop;
    }
    if radius <= 0.0 {
        return (0.0, 0.0);
    }
    let mut s = (length(b.0, b.1) / radius - k.0.max(k.1)).max(0.0);
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
    fn friction_on_the_rim_opposes_the_slip_that_is_left() {
        let (b, k, radius) = ((3.0, -2.0), (2.0, 7.0), 0.25);
        let p = friction_in_disc(b, k, radius);
        let slip = (b.0 + k.0 * p.0, b.1 + k.1 * p.1);
        assert!((length(p.0, p.1) - radius).abs() < 1e-15);
        assert!((slip.0 * p.1 - slip.1 * p.0).abs() < 1e-12, "antiparallel");
        assert!(slip.0 * p.0 + slip.1 * p.1 < 0.0);
    }
}
