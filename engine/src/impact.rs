//! Impacts: what happens in no time.
//!
//! A contact is hit when its surfaces approach faster than a resting contact could within one step, and touch before
//! the step ends. It is hit at its own instant t inside the step, on the parabola that the integrator's positions lie
//! on, x(t) = x + v t + a t (t + s dt) / 2 with s = 2 lead - 1 (semi-implicit Euler has s = 1: its velocities are those of
//! the parabola half a step earlier, so the velocity at t is v + a (t + dt/2)). Newton's rule at that instant,
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

use crate::articulation::{Aim, Articulation};
use crate::body::Body;
use crate::contact::Contact;
use crate::mover::Twist;
use crate::solver::{Limits, Report, Solver};
use crate::team::fill;

/// Generations in one step at most. What approaches after that is stopped by the contact solve, without restitution;
/// so is everything that is driven into an approach from which it would not rebound: plastic impacts pass through a
/// heap all at once, not in generations.
const GENERATIONS: usize = 100;

/// Where the solve leaves this part of the fastest approach there is no solution: friction holds what restitution wants to
/// throw back, as when a pendulum wedges itself onto a floor (Painleve's paradox). Such an impact is plastic.
const JAMMED: f64 = 1e-2;

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
    /// What is left of the step, or all of it [s].
    pub timestep: f64,
    /// Instants from here on are of no interest [s].
    pub horizon: f64,
    /// The whole step [s]: what a resting contact may gain in it is no impact.
    pub whole: f64,
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
    /// Weight of the end velocity in a displacement, see [`crate::integrator::Integrator::lead`].
    pub lead: f64,
}

impl Rules {
    /// s dt: by how much the integrator's parabola lies ahead of its velocities, twice [s].
    #[must_use]
    pub fn offset(&self) -> f64 {
        (2.0 * self.lead - 1.0) * self.timestep
    }
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
    /// Relative angular velocities of the hit contacts before the impulses, in world axes [rad/s].
    turning: Vec<DVec3>,
    /// From the carried velocity to the one at the instant, of each hit contact.
    gained: Vec<f64>,
    elastic: Outcome,
    plastic: Outcome,
    /// What the rows of the joints passed on in the impacts of this step [N s or N m s].
    pub joint_impulses: Vec<f64>,
    /// The instant of the impacts on each assembly of joints.
    joint_instants: Vec<f64>,
    /// Work of the impulses of this part of the step [J]: normal and tangential parts.
    pub work: (f64, f64),
    /// Work that conveyors and bodies on a prescribed path did in them [J].
    pub driven_work: f64,
    /// Of each body, in this step.
    pub kinks: Vec<Kink>,
    /// Since they were last taken away.
    pub events: Vec<Event>,
    /// Some contact was hit in this step.
    pub any: bool,
}

/// What a solve of the hit contacts came to.
#[derive(Clone, Debug, Default)]
struct Outcome {
    /// Of each hit contact, along normal and tangents [N s].
    impulses: Vec<DVec3>,
    /// Relative velocity of each hit contact afterwards, as the integrator carries it [m/s].
    after: Vec<DVec3>,
    /// Angular impulse of each hit contact, in world axes [N m s].
    turns: Vec<DVec3>,
    /// Relative angular velocity of each hit contact afterwards, in world axes [rad/s].
    turning: Vec<DVec3>,
    /// Of each row of the joints.
    joints: Vec<f64>,
}

impl Outcome {
    fn take(
        &mut self,
        hit: &[usize],
        contacts: &[Contact],
        solver: &Solver,
        joints: &Articulation,
    ) {
        self.impulses.clear();
        self.impulses
            .extend(hit.iter().map(|&k| contacts[k].impulse));
        self.after.clear();
        self.after
            .extend(hit.iter().map(|&k| solver.velocity(&contacts[k])));
        self.turns.clear();
        self.turns.extend(hit.iter().map(|&k| contacts[k].turn()));
        self.turning.clear();
        self.turning
            .extend(hit.iter().map(|&k| solver.turning(&contacts[k])));
        self.joints.clear();
        self.joints.extend_from_slice(joints.impulses());
    }

    /// The part `s` of the way to another outcome.
    fn blend(&mut self, other: &Self, s: f64) {
        for (own, others) in [
            (&mut self.impulses, &other.impulses),
            (&mut self.after, &other.after),
            (&mut self.turns, &other.turns),
            (&mut self.turning, &other.turning),
        ] {
            for (a, b) in own.iter_mut().zip(others) {
                *a = a.lerp(*b, s);
            }
        }
        for (a, b) in self.joints.iter_mut().zip(&other.joints) {
            *a += s * (b - *a);
        }
    }
}

/// What impacts act on.
pub struct Scene<'a> {
    /// All bodies.
    pub bodies: &'a mut [Body],
    /// Their accelerations.
    pub accelerations: &'a [Twist],
    /// Contacts of the step.
    pub contacts: &'a mut [Contact],
    /// Joints, loaded at the bodies' poses.
    pub articulation: &'a mut Articulation,
}

impl Impacts {
    /// No impact yet in this step.
    pub fn begin_step(&mut self) {
        self.joint_impulses.clear();
    }

    /// No impact yet in this part of the step: every path is straight.
    pub fn begin_part(&mut self, bodies: usize) {
        self.kinks.clear();
        self.kinks.resize(bodies, Kink::default());
        self.work = (0.0, 0.0);
        self.driven_work = 0.0;
        self.any = false;
    }

    /// Resolve all impacts of a step: changes velocities of bodies and impact impulses of contacts, and leaves `kinks`.
    pub fn resolve(&mut self, scene: &mut Scene, rules: &Rules) {
        self.joint_impulses
            .resize(scene.articulation.impulses().len(), 0.0);
        for generation in 0..GENERATIONS {
            self.find_hit(scene, rules);
            let rebounds =
                |&k: &usize| rebounds(&scene.contacts[k], scene.bodies, scene.accelerations, rules);
            if self.hit.is_empty() || (generation > 0 && !self.hit.iter().any(rebounds)) {
                break;
            }
            self.any = true;
            self.reflect(scene, rules);
        }
    }

    /// Of all contacts that will touch at speed, those that no other precedes on either of their bodies, or on a body
    /// that joints tie to them.
    fn find_hit(&mut self, scene: &Scene, rules: &Rules) {
        let (bodies, contacts) = (&*scene.bodies, &*scene.contacts);
        self.hit.clear();
        let (kinks, accelerations) = (&self.kinks, scene.accelerations);
        fill(&mut self.instants, (contacts.len(), 0.0), &|k| {
            let c = &contacts[k];
            let kinks = Kinks(kinks[c.bodies.0], kinks[c.bodies.1]);
            kinks.hit_at(c, bodies, accelerations, rules)
        });
        if self.instants.iter().all(|instant| instant.is_infinite()) {
            return;
        }
        self.earliest.clear();
        self.earliest.resize(bodies.len(), f64::INFINITY);
        let leader = |k: usize| scene.articulation.leader(k);
        for (c, &instant) in contacts.iter().zip(&self.instants) {
            for k in [leader(c.bodies.0), leader(c.bodies.1)] {
                self.earliest[k] = self.earliest[k].min(instant);
            }
        }
        let same = SAME * rules.timestep;
        for (index, (c, &instant)) in contacts.iter().zip(&self.instants).enumerate() {
            let first =
                |k: usize| bodies[k].is_fixed() || instant <= self.earliest[leader(k)] + same;
            if instant.is_finite() && first(c.bodies.0) && first(c.bodies.1) {
                self.hit.push(index);
            }
        }
    }

    /// Newton's rule for all contacts of this generation together.
    fn reflect(&mut self, scene: &mut Scene, rules: &Rules) {
        self.before.clear();
        self.turning.clear();
        self.gained.clear();
        let mut fastest = 0.0_f64;
        for &k in &self.hit {
            let c = &mut scene.contacts[k];
            let u = c.velocity(scene.bodies);
            let gained = gained_speed(c, scene.accelerations, self.instants[k], rules);
            c.choose_friction(u, rules.slip_speed);
            c.target = reflected(u.x, gained, c, scene.accelerations, rules);
            fastest = fastest.max(u.length());
            self.before.push(u + DVec3::X * gained);
            self.turning.push(c.turning(scene.bodies));
            self.gained.push(gained);
        }
        // Relative to the fastest: impacts are few, and what they do lasts.
        let limits = Limits {
            iterations: 2 * rules.iterations,
            tolerance: (1e-10 * fastest).min(rules.tolerance),
            calm: 0.0,
            quiet_speed: f64::INFINITY,
        };
        let report = self.solve(scene, limits);
        if report.residual > JAMMED * fastest {
            self.forgo_restitution(scene, limits);
        }
        self.elastic
            .take(&self.hit, scene.contacts, &self.solver, scene.articulation);
        self.keep_energy(scene, limits);
        self.apply(scene, rules);
    }

    /// Plastic impacts of the hit contacts instead of those that they were aimed at.
    fn forgo_restitution(&mut self, scene: &mut Scene, limits: Limits) {
        for &k in &self.hit {
            scene.contacts[k].target = scene.contacts[k].target.min(0.0);
        }
        self.solve(scene, limits);
    }

    fn solve(&mut self, scene: &mut Scene, limits: Limits) -> Report {
        for &k in &self.hit {
            scene.contacts[k].clear_impulse();
        }
        // Joints keep the rates that they have; of the drives only a limit can push without bound.
        let bodies = &*scene.bodies;
        scene.articulation.note_rates(bodies);
        scene
            .articulation
            .aim(|row| row.rate, |drive| Aim::of_impact(drive, bodies));
        self.solver.load(bodies);
        self.solver
            .solve(scene.contacts, &self.hit, scene.articulation, limits)
    }

    /// Work of the impulses, sum of J . (u + u') / 2, must not be positive. With restitution a part s of the impulses
    /// beyond the plastic ones it is a quadratic in s, at most zero for s = 0; take the greatest s that keeps it so.
    fn keep_energy(&mut self, scene: &mut Scene, limits: Limits) {
        let full = self.work_of(&self.elastic, &self.elastic);
        let scale: f64 = self
            .elastic
            .impulses
            .iter()
            .zip(&self.before)
            .map(|(p, u)| (p.x * u.x).abs())
            .sum();
        if full <= 1e-12 * scale {
            return;
        }
        self.forgo_restitution(scene, limits);
        self.plastic
            .take(&self.hit, scene.contacts, &self.solver, scene.articulation);
        // W(s) = (1 - s)^2 W_pp + s (1 - s) (W_pe + W_ep) + s^2 W_ee, with W_xy the impulses of x on the velocities of y.
        let none = self.work_of(&self.plastic, &self.plastic);
        let mixed =
            self.work_of(&self.plastic, &self.elastic) + self.work_of(&self.elastic, &self.plastic);
        let (a, b) = (full - mixed + none, mixed - 2.0 * none);
        let root = (b * b - 4.0 * a * none).max(0.0).sqrt();
        // none <= 0 < full: exactly one root lies in [0, 1]; written so that nothing cancels.
        let s = if b >= 0.0 {
            -2.0 * none / (b + root)
        } else {
            (root - b) / (2.0 * a)
        };
        self.plastic.blend(&self.elastic, s.clamp(0.0, 1.0));
        std::mem::swap(&mut self.plastic, &mut self.elastic);
    }

    /// Sum over the hit contacts of J . (u + u') / 2 [J].
    fn work_of(&self, pushing: &Outcome, moving: &Outcome) -> f64 {
        let mut sum = 0.0;
        for (slot, p) in pushing.impulses.iter().enumerate() {
            let after = moving.after[slot] + DVec3::X * self.gained[slot];
            sum += 0.5 * p.dot(self.before[slot] + after);
            let turning = self.turning[slot] + moving.turning[slot];
            sum += 0.5 * pushing.turns[slot].dot(turning);
        }
        sum
    }

    /// Give the impulses to the bodies, and write down what happened.
    fn apply(&mut self, scene: &mut Scene, rules: &Rules) {
        self.joint_instants.clear();
        self.joint_instants.resize(scene.articulation.len(), 0.0);
        let impulses = self.elastic.impulses.iter().zip(&self.elastic.turns);
        for (&k, (&impulse, &q)) in self.hit.iter().zip(impulses) {
            let c = &mut scene.contacts[k];
            c.impulse = impulse;
            let p = c.to_world(impulse);
            c.impact_impulse += p;
            let instant = self.instants[k];
            for (body, impulse, arm, turn) in
                [(c.bodies.0, p, c.arms.0, q), (c.bodies.1, -p, c.arms.1, -q)]
            {
                let kink = &mut self.kinks[body];
                kink.bend(
                    &mut scene.bodies[body],
                    impulse,
                    arm.cross(impulse) + turn,
                    instant,
                );
                if let Some(assembly) = scene.articulation.home(body) {
                    self.joint_instants[assembly] = self.joint_instants[assembly].max(instant);
                }
            }
        }
        self.apply_joints(scene);
        self.note(scene, rules);
    }

    fn apply_joints(&mut self, scene: &mut Scene) {
        let impulses = self.elastic.joints.iter().enumerate();
        for ((row, &x), sum) in impulses.zip(&mut self.joint_impulses) {
            if x == 0.0 {
                continue;
            }
            *sum += x;
            for end in scene.articulation.ends(row) {
                let home = scene.articulation.home(end.body);
                let instant = home.map_or(0.0, |assembly| self.joint_instants[assembly]);
                let body = &mut scene.bodies[end.body];
                self.kinks[end.body].bend(body, end.linear * x, end.angular * x, instant);
            }
        }
    }

    fn note(&mut self, scene: &mut Scene, rules: &Rules) {
        for (slot, &k) in self.hit.iter().enumerate() {
            let c = &scene.contacts[k];
            let before = self.before[slot];
            let after = self.elastic.after[slot] + DVec3::X * self.gained[slot];
            let mean = 0.5 * (before + after);
            self.work.0 += c.impulse.x * mean.x;
            self.work.1 += c.impulse.y * mean.y + c.impulse.z * mean.z;
            let turning = 0.5 * (self.turning[slot] + self.elastic.turning[slot]);
            self.work.1 += self.elastic.turns[slot].dot(turning);
            self.driven_work -= c.to_world(c.impulse).dot(c.driven(scene.bodies))
                + self.elastic.turns[slot].dot(c.driven_turning(scene.bodies));
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

impl Kink {
    /// An impulse and an angular impulse at an instant: the body gets them, and its path bends there and not at the
    /// start of the step.
    fn bend(&mut self, body: &mut Body, impulse: DVec3, turn: DVec3, instant: f64) {
        if body.is_fixed() {
            return; // it has no path to bend, and must not make others wait for its impacts
        }
        self.shift -= impulse * (body.mass.inverse_mass * instant);
        self.turn -= body.inverse_inertia * turn * instant;
        self.instant = instant;
        body.apply_wrench(impulse, turn);
    }

    /// Put a body where its bent path ends, after a step that ran on straight.
    pub fn straighten(&self, body: &mut Body) {
        body.state.position += self.shift;
        if self.turn != DVec3::ZERO {
            body.state.orientation =
                crate::math::rotation_from_vector(self.turn) * body.state.orientation;
            body.refresh();
        }
    }
}

/// The kinks of the two bodies of a contact.
struct Kinks(Kink, Kink);

impl Kinks {
    /// The instant at which the contact touches at speed, infinite where it does not within the step.
    fn touching(
        &self,
        c: &Contact,
        bodies: &[Body],
        accelerations: &[Twist],
        rules: &Rules,
    ) -> f64 {
        let speed = crate::contact::relative_velocity(bodies, c.bodies, c.arms).dot(c.normal);
        // Most contacts rest, and need not be asked what forces may bring about.
        if speed >= -noise_floor(c, rules) || speed >= -quiet_speed(c, accelerations, rules) {
            return f64::INFINITY;
        }
        let gap = c.gap + self.gap_change(c);
        let earliest = self.0.instant.max(self.1.instant);
        let a = normal_acceleration(c, accelerations);
        let t = first_root(gap, speed + 0.5 * a * rules.offset(), 0.5 * a).max(earliest);
        if t < rules.horizon {
            t
        } else {
            f64::INFINITY
        }
    }

    /// The same, but a contact that was followed to its touching is hit at just the instant that its arms belong to,
    /// so that the angular momentum of the impact is kept to the last bit.
    fn hit_at(&self, c: &Contact, bodies: &[Body], accelerations: &[Twist], rules: &Rules) -> f64 {
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
    accelerations: &[Twist],
    rules: &Rules,
) -> f64 {
    Kinks(Kink::default(), Kink::default()).touching(c, bodies, accelerations, rules)
}

/// Speed of approach that a contact touches with, at an instant of the step [m/s].
#[must_use]
pub fn touching_speed(
    c: &Contact,
    bodies: &[Body],
    accelerations: &[Twist],
    instant: f64,
    rules: &Rules,
) -> f64 {
    let carried = crate::contact::relative_velocity(bodies, c.bodies, c.arms).dot(c.normal);
    -carried - gained_speed(c, accelerations, instant, rules)
}

/// What impacts did to the gap of a contact in this step [m].
#[must_use]
pub fn gap_change(kinks: &[Kink], c: &Contact) -> f64 {
    Kinks(kinks[c.bodies.0], kinks[c.bodies.1]).gap_change(c)
}

/// Acceleration of A's point against B's along the normal, without the centripetal parts [m/s^2].
#[must_use]
pub fn normal_acceleration(c: &Contact, accelerations: &[Twist]) -> f64 {
    let (a, b) = (&accelerations[c.bodies.0], &accelerations[c.bodies.1]);
    (a.at(c.arms.0) - b.at(c.arms.1)).dot(c.normal)
}

/// Approach up to this speed is what a resting contact may show within a step: forces may bring it about, or the last
/// contact solve may have left it; the next one takes it away [m/s].
#[must_use]
pub fn quiet_speed(c: &Contact, accelerations: &[Twist], rules: &Rules) -> f64 {
    // Not of the difference: a body that is held from below falls onto it, whatever its own acceleration is.
    let along = |body: usize, arm: DVec3| accelerations[body].at(arm).dot(c.normal).abs();
    (along(c.bodies.0, c.arms.0).max(along(c.bodies.1, c.arms.1)) * rules.whole)
        .max(noise_floor(c, rules))
}

/// The part of it that has nothing to do with forces [m/s].
fn noise_floor(c: &Contact, rules: &Rules) -> f64 {
    rules.tolerance.max(rules.bounce_speed).max(c.noise)
}

/// From the velocity that the integrator carries at the start of a step to the velocity at the instant t of the parabola
/// through its positions: a (t + s dt / 2), along the normal [m/s].
fn gained_speed(c: &Contact, accelerations: &[Twist], instant: f64, rules: &Rules) -> f64 {
    normal_acceleration(c, accelerations) * (instant + 0.5 * rules.offset())
}

/// The contact leaves again, faster than a resting contact may.
fn rebounds(c: &Contact, bodies: &[Body], accelerations: &[Twist], rules: &Rules) -> bool {
    -c.coefficients.restitution * c.velocity(bodies).x > quiet_speed(c, accelerations, rules)
}

/// The normal velocity to leave with, -e times the one at touching, as the integrator carries it. A bounce so small
/// that the next step would end it counts as none.
fn reflected(speed: f64, gained: f64, c: &Contact, accelerations: &[Twist], rules: &Rules) -> f64 {
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
