//! Contacts solved together: projected Gauss-Seidel, accelerated by nonsmooth nonlinear conjugate gradients.
//!
//! Unknown are the impulses p = (p_n, p_1, p_2) of every contact, with u = (u_n, u_1, u_2) its relative velocity after
//! all impulses. Asked is, for every contact at once,
//!
//! ```text
//! normal    0 <= p_n,  u_n >= target,  p_n (u_n - target) = 0             (Signorini)
//! friction  |p_t| <= mu p_n;  u_t = 0 inside the disc;  p_t = -mu p_n u_t / |u_t| on its rim   (Coulomb)
//! ```
//!
//! A sweep solves one contact after the other exactly, with the others held. Sweeps alone are slow on tall stacks and
//! great mass ratios (a light body under a heavy one: factor 1 / (1 + m/M) a sweep); the conjugate directions of
//! Silcowitz, Niebe & Erleben 2010 ("A nonsmooth nonlinear conjugate gradient method for interactive contact force
//! problems", Visual Computer 26) cost one more pass and mend that.

use glam::{DMat3, DVec3};

use crate::body::Body;
use crate::contact::{Contact, Friction};

/// What a solve came to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Report {
    /// Greatest change of a relative velocity in the last sweep [m/s].
    pub residual: f64,
    /// Sweeps made.
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

/// What the sweeps read and write of a body, close together in memory.
#[derive(Clone, Copy, Debug)]
struct Mover {
    velocity: DVec3,
    angular_velocity: DVec3,
    inverse_mass: f64,
    inverse_inertia: DMat3,
}

impl Mover {
    fn push(&mut self, p: DVec3, r: DVec3) {
        self.velocity += p * self.inverse_mass;
        self.angular_velocity += self.inverse_inertia * r.cross(p);
    }

    fn velocity_at(&self, r: DVec3) -> DVec3 {
        self.velocity + self.angular_velocity.cross(r)
    }
}

/// Working memory, kept from solve to solve.
#[derive(Clone, Debug, Default)]
pub struct Solver {
    movers: Vec<Mover>,
    before: Vec<DVec3>,
    direction: Vec<DVec3>,
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
        if which.is_empty() {
            return Report::default();
        }
        self.load(bodies, contacts, which);
        let mut report = self.iterate(contacts, which, limits);
        // Static contacts that gave way slide from here on; the others hear of it. Twice is enough: a contact changes
        // only from static to kinetic.
        for _ in 0..2 {
            let left = limits.iterations.saturating_sub(report.iterations);
            if left == 0 || !self.release_slipping(contacts, which, limits.tolerance) {
                break;
            }
            let more = self.iterate(contacts, which, Limits { iterations: left, ..limits });
            report = Report {
                residual: more.residual,
                iterations: report.iterations + more.iterations,
            };
        }
        report
    }

    fn load(&mut self, bodies: &[Body], contacts: &[Contact], which: &[usize]) {
        self.movers.clear();
        self.movers.extend(bodies.iter().map(|b| Mover {
            velocity: b.state.velocity,
            angular_velocity: b.angular_velocity,
            inverse_mass: b.mass.inverse_mass,
            inverse_inertia: b.inverse_inertia,
        }));
        for &k in which {
            let contact = &contacts[k];
            if contact.impulse != DVec3::ZERO {
                self.push(contact, contact.impulse);
            }
        }
    }

    /// Sweeps along conjugate directions. `g` is the change that a sweep makes, beta = |g|^2 / |g_before|^2 in the
    /// metric of the effective masses; where the change grows the direction is dropped (Silcowitz et al., alg. 2).
    fn iterate(&mut self, contacts: &mut [Contact], which: &[usize], limits: Limits) -> Report {
        self.direction.clear();
        self.direction.resize(which.len(), DVec3::ZERO);
        let mut last = 0.0;
        let mut report = Report::default();
        for iteration in 0..limits.iterations {
            let (residual, square) = self.sweep(contacts, which, iteration % 2 == 1);
            report = Report { residual, iterations: iteration + 1 };
            if residual < limits.tolerance || iteration + 1 == limits.iterations {
                break;
            }
            let beta = if last > 0.0 { square / last } else { 2.0 };
            last = square;
            self.extrapolate(contacts, which, beta);
        }
        report
    }

    /// One sweep; returns the greatest change [m/s] and the sum of squares of all changes [J]. Odd sweeps go backwards:
    /// what a stack passes on reaches both its ends.
    fn sweep(&mut self, contacts: &mut [Contact], which: &[usize], backwards: bool) -> (f64, f64) {
        self.before.clear();
        self.before.extend(which.iter().map(|&k| contacts[k].impulse));
        let (mut worst, mut square) = (0.0_f64, 0.0);
        for step in 0..which.len() {
            let slot = if backwards { which.len() - 1 - step } else { step };
            let contact = &mut contacts[which[slot]];
            let old = contact.impulse;
            self.solve_contact(contact);
            let change = contact.impulse - old;
            let by_velocity = DVec3::new(
                change.x * contact.k_normal,
                change.y * contact.k_tangent.0,
                change.z * contact.k_tangent.1,
            );
            worst = worst.max(by_velocity.abs().max_element());
            square += by_velocity.dot(change);
        }
        (worst, square)
    }

    /// After a sweep that made the change g: direction <- beta direction + g, and impulses go on by beta direction.
    fn extrapolate(&mut self, contacts: &mut [Contact], which: &[usize], beta: f64) {
        for (slot, &k) in which.iter().enumerate() {
            let contact = &mut contacts[k];
            let change = contact.impulse - self.before[slot];
            if beta > 1.0 {
                self.direction[slot] = change;
                continue;
            }
            let onward = self.direction[slot] * beta;
            self.direction[slot] = onward + change;
            if onward != DVec3::ZERO {
                contact.impulse += onward;
                let contact = &contacts[k];
                self.push(contact, onward);
            }
        }
    }

    /// The exact answer of one contact, the others held.
    fn solve_contact(&mut self, c: &mut Contact) {
        let (a, b) = (&self.movers[c.bodies.0], &self.movers[c.bodies.1]);
        let u = c.to_local(a.velocity_at(c.arms.0) - b.velocity_at(c.arms.1));
        let old = c.impulse;
        let normal = (old.x - (u.x - c.target) / c.k_normal).max(0.0);
        let change = normal - old.x;
        // Velocity of the tangents with the new normal impulse and without friction.
        let b1 = u.y + c.k_coupling.0 * change - c.k_tangent.0 * old.y;
        let b2 = u.z + c.k_coupling.1 * change - c.k_tangent.1 * old.z;
        let mu = match c.friction {
            Friction::Static => c.coefficients.static_friction,
            Friction::Kinetic => c.coefficients.kinetic_friction,
        };
        let (p1, p2) = friction_in_disc((b1, b2), c.k_tangent, mu * normal);
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
    fn release_slipping(&self, contacts: &mut [Contact], which: &[usize], tolerance: f64) -> bool {
        let mut any = false;
        for &k in which {
            let c = &mut contacts[k];
            let full = c.coefficients.static_friction * c.impulse.x;
            let held = c.impulse.y.hypot(c.impulse.z) < full * (1.0 - 1e-9);
            if c.friction == Friction::Kinetic || held || c.impulse.x == 0.0 {
                continue;
            }
            let (a, b) = (&self.movers[c.bodies.0], &self.movers[c.bodies.1]);
            let u = c.to_local(a.velocity_at(c.arms.0) - b.velocity_at(c.arms.1));
            if u.y.hypot(u.z) > 10.0 * tolerance {
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
    let mut s = (b.0.hypot(b.1) / radius - k.0.max(k.1)).max(0.0);
    for _ in 0..20 {
        let p = (-b.0 / (k.0 + s), -b.1 / (k.1 + s));
        let length = p.0.hypot(p.1);
        let slope = -(p.0 * p.0 / (k.0 + s) + p.1 * p.1 / (k.1 + s)) / length;
        let move_by = (length - radius) / radius * length / slope;
        s -= move_by;
        if move_by.abs() <= 1e-14 * (k.0 + s) {
            break;
        }
    }
    let p = (-b.0 / (k.0 + s), -b.1 / (k.1 + s));
    let scale = radius / p.0.hypot(p.1);
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
        assert!((p.0.hypot(p.1) - radius).abs() < 1e-15);
        assert!((slip.0 * p.1 - slip.1 * p.0).abs() < 1e-12, "antiparallel");
        assert!(slip.0 * p.0 + slip.1 * p.1 < 0.0);
    }
}
