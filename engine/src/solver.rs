//! Contacts and joints solved together: sweeps over the contacts, and linear solves over those that carry.
//!
//! Unknown are the impulses p = (p_n, p_1, p_2) of every contact, with u = (u_n, u_1, u_2) its relative velocity after
//! all impulses. Asked is, for every contact at once,
//!
//! ```text
//! normal    0 <= p_n,  u_n >= target,  p_n (u_n - target) = 0             (Signorini)
//! friction  |p_t| <= mu p_n;  u_t = 0 inside the disc;  p_t = -mu p_n u_t / |u_t| on its rim   (Coulomb)
//! ```
//!
//! Contacts with rolling and spinning friction have three more of the same kind (see `roll.rs`), which follow after
//! friction.
//!
//! A sweep solves one contact after the other exactly, with the others held (projected Gauss-Seidel). Sweeps find out
//! quickly which contacts carry, which stick and which slide, but pass loads on slowly: for a light body under a heavy
//! one the error falls by 1 / (1 + m/M) a sweep. So after a few sweeps the contacts that carry are solved together as
//! a linear system (see `subspace.rs`), with open contacts open and sliding friction as it stands; sweeps then
//! check and mend the guess (subspace minimisation: Silcowitz, Niebe & Erleben 2010, "Projected Gauss-Seidel subspace
//! minimization method for interactive rigid body dynamics", GRAPP).
//!
//! Joints are not swept: after every sweep they are solved exactly for what the contacts did (`articulation`), and the
//! linear solves see bodies with their joints.

use glam::DVec3;

use crate::articulation::Articulation;
use crate::body::Body;
use crate::contact::{Contact, Friction};
use crate::disc::friction_in_disc;
use crate::islands::{Island, Islands};
use crate::joint::Row;
use crate::math::length;
use crate::mover::{Mover, Part, Twist};
use crate::roll::Roll;
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
    island: Island,
    residuals: Vec<f64>,
}

/// What one island is solved with.
pub(crate) struct System<'a> {
    pub(crate) contacts: &'a mut [Contact],
    pub(crate) articulation: &'a mut Articulation,
    pub(crate) island: &'a Island,
    pub(crate) movers: &'a mut [Mover],
}

impl Solver {
    /// Begin from the bodies as they move now.
    pub fn load(&mut self, bodies: &[Body]) {
        self.movers.clear();
        self.movers.extend(bodies.iter().map(Mover::of));
    }

    /// Begin from the bodies as they will move after the time `h` at these accelerations.
    pub fn load_after(&mut self, bodies: &[Body], accelerations: &[Twist], h: f64) {
        self.load(bodies);
        for (mover, a) in self.movers.iter_mut().zip(accelerations) {
            mover.twist.add_scaled(a, h);
        }
    }

    /// Solve the contacts named by `which`, from the impulses that stand in them, and all joints, as they were aimed.
    /// The results stay in `contact.impulse` and in the articulation; bodies are not touched, `velocity` tells how
    /// they would move.
    pub fn solve(
        &mut self,
        contacts: &mut [Contact],
        which: &[usize],
        articulation: &mut Articulation,
        limits: Limits,
    ) -> Report {
        for &k in which {
            let c = &contacts[k];
            push(&mut self.movers, c, c.impulse);
            turn(&mut self.movers, c, c.turn());
        }
        self.residuals.clear();
        self.residuals.resize(self.movers.len(), 0.0);
        let mut report = Report::default();
        let mut island = std::mem::take(&mut self.island);
        self.islands
            .divide(&self.movers, contacts, which, articulation);
        let mut start = 0;
        while let Some(next) = self.islands.take(start, &mut island) {
            start = next;
            let one = self.solve_island(contacts, articulation, &island, limits);
            report.residual = report.residual.max(one.residual);
            report.iterations = report.iterations.max(one.iterations);
            for &k in &island.contacts {
                self.residuals[contacts[k].bodies.0] = one.residual;
                self.residuals[contacts[k].bodies.1] = one.residual;
            }
        }
        self.island = island;
        report
    }

    fn solve_island(
        &mut self,
        contacts: &mut [Contact],
        articulation: &mut Articulation,
        island: &Island,
        limits: Limits,
    ) -> Report {
        let mut movers = std::mem::take(&mut self.movers);
        let mut system = System {
            contacts,
            articulation,
            island,
            movers: &mut movers,
        };
        system.hold_joints();
        let report = if island.contacts.is_empty() {
            Report::default()
        } else {
            self.release(&mut system, limits)
        };
        self.movers = movers;
        report
    }

    /// Relative velocity of a contact after the solve, along normal and tangents [m/s].
    #[must_use]
    pub fn velocity(&self, c: &Contact) -> DVec3 {
        c.velocity_ahead(&self.movers)
    }

    /// Relative angular velocity of a contact after the solve, in world axes [rad/s].
    #[must_use]
    pub fn turning(&self, c: &Contact) -> DVec3 {
        c.turning(&self.movers)
    }

    /// dC/dt of a row after the solve.
    #[must_use]
    pub fn rate(&self, row: &Row) -> f64 {
        row.rate(&self.movers)
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
    fn release(&mut self, system: &mut System, limits: Limits) -> Report {
        let mut report = self.iterate(system, Part::Normals, limits.share(3));
        report = report.then(self.iterate(system, Part::All, limits.share(3)));
        while report.iterations < limits.iterations {
            let noticeable = 10.0 * report.residual.max(limits.tolerance);
            let released = system.release_slipping(noticeable);
            if !released && report.residual < limits.tolerance {
                break;
            }
            let left = Limits {
                iterations: limits.iterations - report.iterations,
                ..limits
            };
            report = report.then(self.iterate(system, Part::All, left));
        }
        report
    }

    /// Sweeps and linear solves in turn, until a sweep changes nothing any more. Ends with a sweep, so that every
    /// impulse lies in its cone. A linear solve may guess wrongly which contacts carry, and the next sweeps then have
    /// more to mend than before: the next guess waits longer, and where the sweeps run out the best impulses are taken.
    fn iterate(&mut self, system: &mut System, part: Part, limits: Limits) -> Report {
        let mut iterations = 0;
        let mut best = f64::INFINITY;
        let mut patience = SWEEPS;
        let mut passes = PASSES * limits.iterations;
        loop {
            let mut residual = f64::INFINITY;
            for _ in 0..patience {
                residual = system.sweep(part, iterations % 2 == 1);
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
                self.best.extend(system.impulses());
            }
            if iterations >= limits.iterations {
                system.set_impulses(&self.best);
                return Report {
                    residual: best,
                    iterations,
                };
            }
            passes -= self.leap(system, part, passes, limits.tolerance / residual);
        }
    }

    /// Solve the contacts that carry as a linear system, and bring the result back into the cones. Returns the number
    /// of passes over the contacts that it took, at most `budget`.
    fn leap(&mut self, system: &mut System, part: Part, budget: usize, reduction: f64) -> usize {
        let reduction = (0.1 * reduction).max(LEAP);
        let passes = self.subspace.solve(system, part, (budget, reduction));
        for (slot, &k) in system.island.contacts.iter().enumerate() {
            let old = system.contacts[k].impulse;
            let new = match part {
                Part::Normals => {
                    (old + self.subspace.step(slot)).max(DVec3::new(0.0, f64::MIN, f64::MIN))
                }
                Part::All => system.contacts[k].in_cone(old + self.subspace.step(slot)),
            };
            system.contacts[k].impulse = new;
            push(system.movers, &system.contacts[k], new - old);
        }
        if part == Part::All {
            for (slot, step) in self.subspace.turns() {
                let c = &mut system.contacts[system.island.contacts[slot]];
                let normal = c.impulse.x;
                set_turn(system.movers, c, |roll| {
                    roll.in_bounds(roll.impulse + step, normal)
                });
            }
        }
        system.hold_joints();
        passes
    }
}

impl System<'_> {
    /// Joints take up what contacts did to them, exactly.
    fn hold_joints(&mut self) {
        for &assembly in &self.island.assemblies {
            self.articulation.solve(assembly, self.movers);
        }
    }

    /// Those of all contacts, then the angular ones of those that have any.
    fn impulses(&self) -> impl Iterator<Item = DVec3> + '_ {
        let contacts = || self.island.contacts.iter().map(|&k| &self.contacts[k]);
        let rolls = contacts().filter_map(|c| c.roll.as_ref());
        contacts()
            .map(|c| c.impulse)
            .chain(rolls.map(|roll| roll.impulse))
    }

    fn set_impulses(&mut self, impulses: &[DVec3]) {
        let (pushes, turns) = impulses.split_at(self.island.contacts.len());
        for (&k, &new) in self.island.contacts.iter().zip(pushes) {
            let change = new - self.contacts[k].impulse;
            self.contacts[k].impulse = new;
            push(self.movers, &self.contacts[k], change);
        }
        let mut turns = turns.iter();
        for &k in &self.island.contacts {
            set_turn(self.movers, &mut self.contacts[k], |roll| {
                turns.next().copied().unwrap_or(roll.impulse)
            });
        }
        self.hold_joints();
    }

    /// One sweep; returns the greatest change of a relative velocity [m/s]. Every other sweep goes backwards: what a
    /// stack passes on reaches both its ends.
    fn sweep(&mut self, part: Part, backwards: bool) -> f64 {
        let mut worst = 0.0_f64;
        let which = &self.island.contacts;
        for step in 0..which.len() {
            let slot = if backwards {
                which.len() - 1 - step
            } else {
                step
            };
            let contact = &mut self.contacts[which[slot]];
            let old = contact.impulse;
            solve_contact(self.movers, contact, part);
            let change = (contact.impulse - old) * contact.stiffness();
            worst = worst.max(change.abs().max_element());
            if part == Part::All {
                worst = worst.max(solve_roll(self.movers, contact));
            }
        }
        self.hold_joints();
        worst
    }

    /// Static contacts on the rim of their disc that slip nevertheless become kinetic.
    fn release_slipping(&mut self, noticeable: f64) -> bool {
        let mut any = false;
        for &k in &self.island.contacts {
            let c = &mut self.contacts[k];
            let full = c.coefficients.static_friction * c.impulse.x;
            let held = length(c.impulse.y, c.impulse.z) < full * (1.0 - 1e-9);
            if c.friction == Friction::Kinetic || held || c.impulse.x == 0.0 {
                continue;
            }
            let u = c.velocity_ahead(self.movers);
            if length(u.y, u.z) > noticeable {
                c.friction = Friction::Kinetic;
                any = true;
            }
        }
        any
    }
}

/// The exact answer of one contact, the others held.
fn solve_contact(movers: &mut [Mover], c: &mut Contact, part: Part) {
    let u = c.velocity_ahead(movers);
    let old = c.impulse;
    let missing = c.target - u.x - c.give * old.x;
    let normal = (old.x + missing / (c.k_normal + c.give)).max(0.0);
    let change = normal - old.x;
    // Velocity of the tangents with the new normal impulse and without friction.
    let b1 = u.y + c.k_coupling.0 * change - c.k_tangent.0 * old.y;
    let b2 = u.z + c.k_coupling.1 * change - c.k_tangent.1 * old.z;
    let (p1, p2) = match part {
        Part::Normals => (old.y, old.z),
        Part::All => friction_in_disc((b1, b2), c.k_tangent, c.friction_coefficient() * normal),
    };
    c.impulse = DVec3::new(normal, p1, p2);
    push(movers, c, c.impulse - old);
}

fn push(movers: &mut [Mover], c: &Contact, impulse: DVec3) {
    if impulse == DVec3::ZERO {
        return;
    }
    let p = c.to_world(impulse);
    movers[c.bodies.0].push(p, c.arms.0);
    movers[c.bodies.1].push(-p, c.arms.1);
}

/// The exact answer of the rolling and spinning friction of a contact, all else held; returns the change as a speed.
fn solve_roll(movers: &mut [Mover], c: &mut Contact) -> f64 {
    if c.roll.is_none() {
        return 0.0;
    }
    let (w, normal) = (c.turning(movers), c.impulse.x);
    set_turn(movers, c, |roll| roll.answer(roll.to_local(w), normal))
}

/// Change the angular impulse of a contact that has any; returns the change as a speed.
fn set_turn(movers: &mut [Mover], c: &mut Contact, new: impl FnOnce(&Roll) -> DVec3) -> f64 {
    let Some(roll) = &mut c.roll else {
        return 0.0;
    };
    let new = new(roll);
    let change = new - roll.impulse;
    roll.impulse = new;
    let (q, speed) = (roll.to_world(change), roll.speed_of(change, c.k_normal));
    turn(movers, c, q);
    speed
}

fn turn(movers: &mut [Mover], c: &Contact, q: DVec3) {
    if q != DVec3::ZERO {
        movers[c.bodies.0].turn(q);
        movers[c.bodies.1].turn(-q);
    }
}
