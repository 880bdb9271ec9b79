//! Impacts: what happens in no time.
//!
//! A contact is hit when its surfaces approach faster than a resting contact could within one step, and touch before
//! the step ends. It is hit at its own instant t inside the step, on the parabola that the integrator's positions lie
//! on, x(t) = x + v t + a t (t + dt) / 2 (semi-implicit Euler's velocities are those of the parabola half a step
//! earlier, so the velocity at t is v + a (t + dt/2)). Newton's rule at that instant,
//!
//! ```text
//! u_n' = -e u_n
//! ```
//!
//! holds for all contacts that are hit at the same instant together; contacts that are driven into approach by these
//! impulses are hit next, until none approaches: generalised reflections (Smith, Kaufman, Vouga, Tamstorf, Grinspun 2012,
//! "Reflections on simultaneous impact"). So a box that lands flat stays flat, and a row of balls passes momentum
//! through. Where Newton's rule with friction would create energy (Kane & Levinson 1985) the restitution of that
//! generation is lowered until it does not.
//!
//! An impulse at the instant t changes the position at the end of the step by dv (dt - t), not dv dt: the difference
//! -dv t is kept in `shift` and `turn` of the body and applied when bodies move.

use glam::DVec3;

use crate::body::Body;
use crate::contact::Contact;
use crate::solver::{Limits, Solver};

/// Generations in one step at most. What approaches after that is stopped by the contact solve, without restitution;
/// so is everything that is driven into an approach from which it would not rebound: plastic impacts pass through a
/// heap all at once, not in generations.
const GENERATIONS: usize = 100;

/// This part of a step apart is simultaneous.
const SAME: f64 = 1e-3;

/// What impacts add to the motion of a body within the step.
#[derive(Clone, Copy, Debug, Default)]
pub struct Kink {
    /// Correction of the displacement [m].
    pub shift: DVec3,
    /// Correction of the rotation [rad], rotation vector.
    pub turn: DVec3,
    /// Instant of the last impact on this body [s].
    pub instant: f64,
}

/// One impact in one contact point.
#[derive(Clone, Copy, Debug, serde::Serialize, serde::Deserialize)]
pub struct Event {
    /// [s] since the start
    pub time: f64,
    /// Bodies A and B.
    pub bodies: (usize, usize),
    /// [m]
    pub position: DVec3,
    /// From B to A.
    pub normal: DVec3,
    /// Approach speed along the normal [m/s].
    pub speed_before: f64,
    /// Separation speed along the normal [m/s].
    pub speed_after: f64,
    /// Normal impulse [N s].
    pub impulse: f64,
    /// Restitution of the pair of materials.
    pub restitution: f64,
}

/// What the impacts of a step are decided by.
#[derive(Clone, Copy, Debug)]
pub struct Rules {
    /// [s]
    pub timestep: f64,
    /// Time at the start of the step [s].
    pub time: f64,
    /// Slower approaches are left to the contact solve [m/s].
    pub bounce_speed: f64,
    /// Solver's residual [m/s]; slower approaches are noise.
    pub tolerance: f64,
    /// [m/s]
    pub slip_speed: f64,
    /// Sweeps at most.
    pub iterations: usize,
}

/// Working memory of the impact stage.
#[derive(Default)]
pub struct Impacts {
    solver: Solver,
    instants: Vec<f64>,
    earliest: Vec<f64>,
    hit: Vec<usize>,
    /// Relative velocities of the hit contacts at their instants, before the impulses.
    before: Vec<DVec3>,
    /// From the carried velocity to the one at the instant, of each hit contact.
    gained: Vec<f64>,
    elastic: Vec<DVec3>,
    /// Work of the impulses of this step [J]: normal and tangential parts.
    pub work: (f64, f64),
    /// Of each body, in this step.
    pub kinks: Vec<Kink>,
    /// Since they were last taken away.
    pub events: Vec<Event>,
}

impl Impacts {
    /// Resolve all impacts of a step: changes velocities of bodies and impact impulses of contacts, and leaves `kinks`.
    pub fn resolve(
        &mut self,
        bodies: &mut [Body],
        accelerations: &[DVec3],
        contacts: &mut [Contact],
        rules: &Rules,
    ) {
        self.kinks.clear();
        self.kinks.resize(bodies.len(), Kink::default());
        self.work = (0.0, 0.0);
        for generation in 0..GENERATIONS {
            self.find_hit(bodies, accelerations, contacts, rules);
            let rebounds = |&k: &usize| rebounds(&contacts[k], bodies, accelerations, rules);
            if self.hit.is_empty() || (generation > 0 && !self.hit.iter().any(rebounds)) {
                break;
            }
            self.reflect(bodies, accelerations, contacts, rules);
        }
    }

    /// Of all contacts that will touch at speed, those that no other precedes on either of their bodies.
    fn find_hit(
        &mut self,
        bodies: &[Body],
        accelerations: &[DVec3],
        contacts: &[Contact],
        rules: &Rules,
    ) {
        self.hit.clear();
        self.instants.clear();
        let kinks = &self.kinks;
        let at = |c: &Contact| Kinks(kinks[c.bodies.0], kinks[c.bodies.1]);
        self.instants.extend(
            contacts
                .iter()
                .map(|c| at(c).hit_at(c, bodies, accelerations, rules)),
        );
        self.earliest.clear();
        self.earliest.resize(bodies.len(), f64::INFINITY);
        for (c, &instant) in contacts.iter().zip(&self.instants) {
            for k in [c.bodies.0, c.bodies.1] {
                self.earliest[k] = self.earliest[k].min(instant);
            }
        }
        let same = SAME * rules.timestep;
        for (index, (c, &instant)) in contacts.iter().zip(&self.instants).enumerate() {
            let first = |k: usize| bodies[k].is_fixed() || instant <= self.earliest[k] + same;
            if instant.is_finite() && first(c.bodies.0) && first(c.bodies.1) {
                self.hit.push(index);
            }
        }
    }

    /// Newton's rule for all contacts of this generation together.
    fn reflect(
        &mut self,
        bodies: &mut [Body],
        accelerations: &[DVec3],
        contacts: &mut [Contact],
        rules: &Rules,
    ) {
        self.before.clear();
        self.gained.clear();
        let mut fastest = 0.0_f64;
        for &k in &self.hit {
            let c = &mut contacts[k];
            let u = c.velocity(bodies);
            let gained = gained_speed(c, accelerations, self.instants[k], rules.timestep);
            c.choose_friction(u, rules.slip_speed);
            c.target = reflected(u.x, gained, c, accelerations, rules);
            c.impulse = DVec3::ZERO;
            fastest = fastest.max(u.length());
            self.before.push(u + DVec3::X * gained);
            self.gained.push(gained);
        }
        // Relative to the fastest: impacts are few, and what they do lasts.
        let limits = Limits {
            iterations: 2 * rules.iterations,
            tolerance: (1e-10 * fastest).min(rules.tolerance),
        };
        self.solver.solve(bodies, contacts, &self.hit, limits);
        self.keep_energy(bodies, contacts, limits);
        self.apply(bodies, contacts, rules);
    }

    /// Work of the impulses, sum of J . (u + u') / 2, must not be positive. With restitution a part s of the impulses
    /// beyond the plastic ones it is a quadratic in s, at most zero for s = 0; take the greatest s that keeps it so.
    fn keep_energy(&mut self, bodies: &[Body], contacts: &mut [Contact], limits: Limits) {
        let full = work_of(&self.hit, &self.before, &self.gained, bodies, contacts);
        let scale: f64 = self
            .hit
            .iter()
            .zip(&self.before)
            .map(|(&k, u)| (contacts[k].impulse.x * u.x).abs())
            .sum();
        if full <= 1e-12 * scale {
            return;
        }
        self.elastic.clear();
        self.elastic
            .extend(self.hit.iter().map(|&k| contacts[k].impulse));
        for &k in &self.hit {
            contacts[k].target = contacts[k].target.min(0.0);
            contacts[k].impulse = DVec3::ZERO;
        }
        self.solver.solve(bodies, contacts, &self.hit, limits);
        let plastic: Vec<DVec3> = self.hit.iter().map(|&k| contacts[k].impulse).collect();
        let mut blend = |s: f64| {
            for ((&k, &p), &e) in self.hit.iter().zip(&plastic).zip(&self.elastic) {
                contacts[k].impulse = p.lerp(e, s);
            }
            work_of(&self.hit, &self.before, &self.gained, bodies, contacts)
        };
        let (none, half) = (blend(0.0), blend(0.5));
        let (a, b) = (
            2.0 * (full - 2.0 * half + none),
            4.0 * half - 3.0 * none - full,
        );
        let root = (b * b - 4.0 * a * none).max(0.0).sqrt();
        // none <= 0 < full: exactly one root lies in [0, 1]; written so that nothing cancels.
        let s = if b >= 0.0 {
            -2.0 * none / (b + root)
        } else {
            (root - b) / (2.0 * a)
        };
        blend(s.clamp(0.0, 1.0));
    }

    /// Give the impulses to the bodies, and write down what happened.
    fn apply(&mut self, bodies: &mut [Body], contacts: &mut [Contact], rules: &Rules) {
        for &k in &self.hit {
            let c = &mut contacts[k];
            let p = c.to_world(c.impulse);
            c.impact_impulse += p;
            for (body, impulse, arm) in [(c.bodies.0, p, c.arms.0), (c.bodies.1, -p, c.arms.1)] {
                let (b, kink) = (&mut bodies[body], &mut self.kinks[body]);
                if b.is_fixed() {
                    continue; // it has no path to bend, and must not make others wait for its impacts
                }
                let instant = self.instants[k];
                kink.shift -= impulse * (b.mass.inverse_mass * instant);
                kink.turn -= b.inverse_inertia * arm.cross(impulse) * instant;
                kink.instant = instant;
                b.apply_impulse(impulse, arm);
            }
        }
        for ((&k, before), gained) in self.hit.iter().zip(&self.before).zip(&self.gained) {
            let c = &contacts[k];
            let after = c.velocity(bodies) + DVec3::X * *gained;
            let mean = 0.5 * (*before + after);
            self.work.0 += c.impulse.x * mean.x;
            self.work.1 += c.impulse.y * mean.y + c.impulse.z * mean.z;
            if c.impulse.x <= 0.0 {
                continue;
            }
            self.events.push(Event {
                time: rules.time + self.instants[k],
                bodies: c.bodies,
                position: c.position,
                normal: c.normal,
                speed_before: -before.x,
                // A plastic impact leaves to the contact solve what the rest of the step adds.
                speed_after: after.x.max(0.0),
                impulse: c.impulse.x,
                restitution: c.coefficients.restitution,
            });
        }
    }
}

/// Sum over the hit contacts of J . (u + u') / 2 [J], u' = the velocities that the impulses would give.
fn work_of(
    hit: &[usize],
    before: &[DVec3],
    gained: &[f64],
    bodies: &[Body],
    contacts: &[Contact],
) -> f64 {
    // Velocity changes of the bodies, found on copies: generations are small.
    let mut touched: Vec<(usize, Body)> = Vec::new();
    let slot_of = |k: usize, touched: &mut Vec<(usize, Body)>| {
        touched
            .iter()
            .position(|(i, _)| *i == k)
            .unwrap_or_else(|| {
                touched.push((k, bodies[k].clone()));
                touched.len() - 1
            })
    };
    for &k in hit {
        let c = &contacts[k];
        let p = c.to_world(c.impulse);
        for (body, impulse, arm) in [(c.bodies.0, p, c.arms.0), (c.bodies.1, -p, c.arms.1)] {
            let slot = slot_of(body, &mut touched);
            touched[slot].1.apply_impulse(impulse, arm);
        }
    }
    let mut sum = 0.0;
    for ((&k, u), gain) in hit.iter().zip(before).zip(gained) {
        let c = &contacts[k];
        let (a, b) = (
            slot_of(c.bodies.0, &mut touched),
            slot_of(c.bodies.1, &mut touched),
        );
        let after = touched[a].1.velocity_at(c.arms.0) - touched[b].1.velocity_at(c.arms.1);
        sum += 0.5 * c.impulse.dot(*u + c.to_local(after) + DVec3::X * *gain);
    }
    sum
}

/// The kinks of the two bodies of a contact.
struct Kinks(Kink, Kink);

impl Kinks {
    /// The instant at which the contact touches at speed, infinite where it does not within the step.
    fn touching(
        &self,
        c: &Contact,
        bodies: &[Body],
        accelerations: &[DVec3],
        rules: &Rules,
    ) -> f64 {
        let dt = rules.timestep;
        let speed = crate::contact::relative_velocity(bodies, c.bodies, c.arms).dot(c.normal);
        if speed >= -quiet_speed(c, accelerations, rules) {
            return f64::INFINITY;
        }
        let gap = c.gap + self.gap_change(c);
        let earliest = self.0.instant.max(self.1.instant);
        let a = normal_acceleration(c, accelerations);
        let t = first_root(gap, speed + 0.5 * a * dt, 0.5 * a).max(earliest);
        if t < dt {
            t
        } else {
            f64::INFINITY
        }
    }

    /// The same, but a contact that was followed to its touching is hit at just the instant that its arms belong to,
    /// so that the angular momentum of the impact is kept to the last bit.
    fn hit_at(&self, c: &Contact, bodies: &[Body], accelerations: &[DVec3], rules: &Rules) -> f64 {
        let t = self.touching(c, bodies, accelerations, rules);
        let earliest = self.0.instant.max(self.1.instant);
        let own = (t - c.instant).abs() <= SAME * rules.timestep && c.instant >= earliest;
        if own {
            c.instant
        } else {
            t
        }
    }

    /// What the kinks do to the gap of a contact [m].
    fn gap_change(&self, c: &Contact) -> f64 {
        let a = self.0.shift + self.0.turn.cross(c.arms.0);
        let b = self.1.shift + self.1.turn.cross(c.arms.1);
        c.normal.dot(a - b)
    }
}

/// The instant within the step at which a contact will be hit if nothing else hits its bodies before, infinite where
/// it will not [s].
#[must_use]
pub fn touching_instant(
    c: &Contact,
    bodies: &[Body],
    accelerations: &[DVec3],
    rules: &Rules,
) -> f64 {
    Kinks(Kink::default(), Kink::default()).touching(c, bodies, accelerations, rules)
}

/// What impacts did to the gap of a contact in this step [m].
#[must_use]
pub fn gap_change(kinks: &[Kink], c: &Contact) -> f64 {
    Kinks(kinks[c.bodies.0], kinks[c.bodies.1]).gap_change(c)
}

/// a_A - a_B along the normal [m/s^2].
#[must_use]
pub fn normal_acceleration(c: &Contact, accelerations: &[DVec3]) -> f64 {
    (accelerations[c.bodies.0] - accelerations[c.bodies.1]).dot(c.normal)
}

/// Approach up to this speed is what a resting contact may show within a step: forces may bring it about, or the last
/// contact solve may have left it; the next one takes it away [m/s].
#[must_use]
pub fn quiet_speed(c: &Contact, accelerations: &[DVec3], rules: &Rules) -> f64 {
    // Not of the difference: a body that is held from below falls onto it, whatever its own acceleration is.
    let along = |body: usize| accelerations[body].dot(c.normal).abs();
    (along(c.bodies.0).max(along(c.bodies.1)) * rules.timestep)
        .max(rules.tolerance)
        .max(rules.bounce_speed)
        .max(c.noise)
}

/// From the velocity that semi-implicit Euler carries at the start of a step to the velocity at the instant t of the
/// parabola through its positions: a (t + dt/2), along the normal [m/s].
fn gained_speed(c: &Contact, accelerations: &[DVec3], instant: f64, timestep: f64) -> f64 {
    normal_acceleration(c, accelerations) * (instant + 0.5 * timestep)
}

/// The contact leaves again, faster than a resting contact may.
fn rebounds(c: &Contact, bodies: &[Body], accelerations: &[DVec3], rules: &Rules) -> bool {
    -c.coefficients.restitution * c.velocity(bodies).x > quiet_speed(c, accelerations, rules)
}

/// The normal velocity to leave with, -e times the one at touching, as the integrator carries it. A bounce so small
/// that the next step would end it counts as none.
fn reflected(speed: f64, gained: f64, c: &Contact, accelerations: &[DVec3], rules: &Rules) -> f64 {
    let leave = -c.coefficients.restitution * (speed + gained);
    if leave <= quiet_speed(c, accelerations, rules) {
        return 0.0;
    }
    leave - gained
}

/// Least t >= 0 with c + b t + a t^2 <= 0, infinite where there is none; 0 where c is not positive.
fn first_root(c: f64, b: f64, a: f64) -> f64 {
    if c <= 0.0 {
        return 0.0;
    }
    let square = b * b - 4.0 * a * c;
    if square < 0.0 {
        return f64::INFINITY;
    }
    // Both forms of the root: 2c / (-b + sqrt) does not cancel for b < 0.
    let root = square.sqrt();
    if b < 0.0 {
        return 2.0 * c / (root - b);
    }
    if a < 0.0 {
        return (-b - root) / (2.0 * a);
    }
    f64::INFINITY
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn first_root_of_falling_approaching_and_parting() {
        assert_eq!(first_root(-0.1, 1.0, 0.0), 0.0);
        assert_eq!(first_root(1.0, -2.0, 0.0), 0.5);
        assert!((first_root(1.0, 0.0, -0.5) - 2.0_f64.sqrt()).abs() < 1e-15);
        assert!((first_root(1.0, 1.0, -0.5) - (1.0 + 3.0_f64.sqrt())).abs() < 1e-14);
        assert_eq!(first_root(1.0, 1.0, 0.5), f64::INFINITY);
    }
}
