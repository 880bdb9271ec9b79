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
//! a linear system (see `carrying.rs`, `subspace.rs`), with open contacts open and sliding friction as it stands; sweeps then
//! check and mend the guess (subspace minimisation: Silcowitz, Niebe & Erleben 2010, "Projected Gauss-Seidel subspace
//! minimization method for interactive rigid body dynamics", GRAPP).
//!
//! Sweeps over many contacts carry on what the sweeps before were about (see `conjugate.rs`).
//!
//! Joints are not swept: after every sweep they are solved exactly for what the contacts did (`articulation`), and the
//! linear solves see bodies with their joints.

use std::sync::{Mutex, PoisonError};

use glam::DVec3;

use crate::articulation::Articulation;
use crate::body::Body;
use crate::carrying::Carrying;
use crate::contact::Contact;
use crate::direct::Direct;
use crate::interior::Interior;
use crate::islands::{index, Islands};
use crate::joint::Row;
use crate::layout::{visit, Block, Layer, Layout, Plan};
use crate::mover::{Mover, Part, Twist, Window};
use crate::pack::Packs;
use crate::point::Point;
use crate::subspace::Subspace;
use crate::team::{both, each_with, fill, gather};

/// Sweeps between two linear solves; twice as many where these are not exact.
const SWEEPS: usize = 2;
/// Sweeps over an island before its contacts are put into packs, which costs as much as they save in a few.
const PACKING: usize = 4;
/// Passes of all linear solves together, per sweep allowed. With fewer a pyramid of 210 boxes does not come to rest.
const PASSES: usize = 6;
/// A linear solve goes on until its residual is this part of what it was: its guess of which contacts carry is seldom
/// worth more.
const LEAP: f64 = 1e-3;

/// After a leap, a first sweep that changes this many times as much as before says that the guess was wrong.
const ASTRAY: f64 = 8.0;
/// Sweeps for loads on their own, where sweeps are all there is.
const LOADS: usize = 4;
/// A tolerance below this [m/s], such as that of impacts, is too fine for direct solves: they divide rounding errors by
/// their compliance.
const DIGITS: f64 = 1e-8;
/// Times that contacts may let go in a guess at the loads.
const ROUNDS: usize = 8;
/// Wrong guesses that are dear, in one solve.
const MISTAKES: usize = 3;
/// Products of blocks per contact that a direct solve may take at any time: what a few sweeps cost.
const CHEAP: usize = 1;
/// Where all is quiet: a wall of 30 layers takes 8, of 60 layers 15, a heap of a thousand balls 50.
const DEAR: usize = 16;

/// Slot of a contact that is not solved.
const NOWHERE: u32 = u32::MAX;

/// What a solve came to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Report {
    /// Greatest change of a relative velocity in the last sweep of any island [m/s].
    pub residual: f64,
    /// Sweeps made, in the island that took most.
    pub iterations: usize,
    /// More sweeps, as many as were allowed, would not have mattered.
    stalled: bool,
}

/// How far to go.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Sweeps at most.
    pub iterations: usize,
    /// Stop below this residual [m/s].
    pub tolerance: f64,
    /// Stop below this residual where sweeps stall [m/s].
    pub calm: f64,
    /// Contacts that meet at up to this speed are at rest [m/s].
    pub quiet_speed: f64,
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
    /// Of two islands.
    fn and(self, other: Self) -> Self {
        Self {
            residual: self.residual.max(other.residual),
            iterations: self.iterations.max(other.iterations),
            stalled: self.stalled || other.stalled,
        }
    }

    fn then(self, next: Self) -> Self {
        Self {
            iterations: self.iterations + next.iterations,
            ..next
        }
    }
}

/// Contacts that are worth handing to another thread.
const HANDFUL: usize = 200;

/// How the residual falls from sweep to sweep.
struct Pace {
    last: f64,
    slow: usize,
}

impl Pace {
    /// After `made` sweeps, would all that are `left` not even halve it, at this pace? Asked twice, to be sure.
    fn stalls(&mut self, residual: f64, made: usize, left: usize) -> bool {
        #[allow(clippy::cast_precision_loss)]
        let hoped = 0.5 * self.last * made as f64 / left as f64;
        self.slow = if self.last - residual < hoped {
            self.slow + 1
        } else {
            0
        };
        self.last = residual;
        self.slow >= 2
    }
}

/// Working memory, kept from solve to solve.
#[derive(Debug, Default)]
pub struct Solver {
    /// Of all bodies.
    movers: Vec<Mover>,
    /// Of all bodies [m].
    centres: Vec<DVec3>,
    /// Sum of what accelerates bodies [m/s^2].
    down: DVec3,
    /// Bodies of the contacts to be solved.
    pairs: Vec<(u32, u32)>,
    /// Those of the solve before: from the same pairs follow the same islands.
    pairs_before: Vec<(u32, u32)>,
    /// Bodies that connect nothing.
    fixed: Vec<bool>,
    islands: Islands,
    layout: Layout,
    /// Island by island.
    points: Vec<Point>,
    /// Of the islands without joints, island by island.
    placed: Vec<Mover>,
    reports: Vec<Report>,
    /// Of each contact its point.
    slots: Vec<u32>,
    /// Some contact has rolling friction.
    rolls: bool,
    /// Who solves islands: as many as do it at once.
    workers: Mutex<Vec<Worker>>,
    residuals: Vec<f64>,
}

/// Solves one island after the other.
#[derive(Debug, Default)]
struct Worker {
    /// Sweeps over the island at hand.
    swept: usize,
    /// It has joints or rolling friction.
    coupled: bool,
    packs: Packs,
    /// Impulses before the last leap.
    kept: Vec<DVec3>,
    subspace: Subspace,
    direct: Direct,
    carrying: Carrying,
    interior: Interior,
    /// Of the island at hand, once it was asked for.
    leap: Option<Leap>,
    /// Wrong guesses in it.
    wrong: usize,
    /// The interior was gone through for it.
    sought: bool,
}

/// How the contacts of an island that carry are solved together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Leap {
    /// By Cholesky's factor.
    Direct {
        /// It costs no more than a few sweeps.
        cheap: bool,
    },
    /// By GMRES, where there are joints or rolling friction, and in impacts.
    Krylov,
    /// Not at all: it would cost more than it brings.
    Never,
}

/// What one island is solved with.
pub(crate) struct System<'a> {
    pub(crate) points: &'a mut [Point],
    pub(crate) movers: &'a mut [Mover],
    pub(crate) joints: Option<Jointed<'a>>,
    parts: &'a [Layer],
}

/// The joints of an island.
pub(crate) struct Jointed<'a> {
    pub(crate) articulation: &'a mut Articulation,
    pub(crate) assemblies: &'a [u32],
}

/// Islands without joints, one after the other, with what is theirs.
struct Chunk<'a> {
    blocks: &'a [Block],
    points: &'a mut [Point],
    movers: &'a mut [Mover],
    reports: &'a mut [Report],
}

impl Solver {
    /// Begin from the bodies as they move now.
    pub fn load(&mut self, bodies: &[Body]) {
        let blank = Mover::of(&bodies[0]);
        fill(&mut self.movers, (bodies.len(), blank), &|k| {
            Mover::of(&bodies[k])
        });
        self.note_centres(bodies);
        self.down = DVec3::ZERO;
    }

    /// Begin from the bodies as they will move after the time `h` at these accelerations.
    pub fn load_after(&mut self, bodies: &[Body], accelerations: &[Twist], h: f64) {
        let blank = Mover::of(&bodies[0]);
        fill(&mut self.movers, (bodies.len(), blank), &|k| {
            let mut mover = Mover::of(&bodies[k]);
            mover.twist.add_scaled(&accelerations[k], h);
            mover
        });
        self.note_centres(bodies);
        self.down = accelerations.iter().map(|a| a.velocity).sum();
    }

    fn note_centres(&mut self, bodies: &[Body]) {
        fill(&mut self.centres, (bodies.len(), DVec3::ZERO), &|k| {
            bodies[k].state.position
        });
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
        self.residuals.clear();
        self.residuals.resize(self.movers.len(), 0.0);
        if which.is_empty() && articulation.is_empty() {
            return Report::default();
        }
        self.lay_out(contacts, which, articulation);
        self.lend(contacts, which, limits);
        self.solve_free(limits);
        self.solve_jointed(articulation, limits);
        self.give_back(contacts, which);
        let reports = self.reports.iter();
        reports.fold(Report::default(), |worst, one| worst.and(*one))
    }

    /// Who is solved with whom, and where.
    fn lay_out(&mut self, contacts: &[Contact], which: &[usize], articulation: &Articulation) {
        std::mem::swap(&mut self.pairs, &mut self.pairs_before);
        fill(&mut self.pairs, (which.len(), (0, 0)), &|k| {
            let (a, b) = contacts[which[k]].bodies;
            (index(a), index(b))
        });
        let movers = &self.movers;
        let as_before = self.pairs == self.pairs_before
            && self.fixed.len() == movers.len()
            && articulation.is_empty();
        if !as_before {
            fill(&mut self.fixed, (movers.len(), false), &|k| {
                movers[k].inverse_mass == 0.0
            });
            self.islands.divide(&self.pairs, &self.fixed, articulation);
        }
        if !(as_before && self.layout.is_uncut()) {
            let plan = Plan {
                pairs: &self.pairs,
                centres: &self.centres,
                down: self.down,
                fixed: &self.fixed,
            };
            self.layout.arrange(&self.islands, plan);
        }
        let bodies = &self.layout.bodies;
        if let Some(&blank) = movers.first() {
            fill(&mut self.placed, (bodies.len(), blank), &|slot| {
                movers[bodies[slot] as usize]
            });
        }
        self.reports.clear();
        let islands = self.islands.count().0;
        self.reports.resize(islands, Report::default());
    }

    /// Contacts as the sweeps see them, island by island.
    fn lend(&mut self, contacts: &mut [Contact], which: &[usize], limits: Limits) {
        let (order, ends) = (&self.layout.contacts, &self.layout.ends);
        self.slots.clear();
        self.slots.resize(contacts.len(), NOWHERE);
        for (slot, &k) in (0..).zip(order) {
            self.slots[which[k as usize]] = slot;
        }
        let lent = &*contacts;
        let rolls = |part: &[Contact]| part.iter().any(|c| c.roll.is_some());
        self.rolls = gather(lent, HANDFUL, &rolls, &|a, b| a || b);
        fill(&mut self.points, (order.len(), Point::default()), &|slot| {
            let c = &lent[which[order[slot] as usize]];
            Point::of(c, ends[slot], limits.quiet_speed)
        });
        self.pass_rolls(contacts);
    }

    /// Rolling friction, to the points that have none and back again.
    fn pass_rolls(&mut self, contacts: &mut [Contact]) {
        if !self.rolls {
            return;
        }
        for (c, &slot) in contacts.iter_mut().zip(&self.slots) {
            if let Some(p) = self.points.get_mut(slot as usize) {
                std::mem::swap(&mut p.roll, &mut c.roll);
            }
        }
    }

    /// Islands without joints, some at once.
    fn solve_free(&mut self, limits: Limits) {
        let (_, free) = self.islands.count();
        let blocks = &self.layout.blocks[..];
        let points = blocks.last().map_or(0, |last| last.points.end);
        let chunk = Chunk {
            blocks,
            points: &mut self.points[..points],
            movers: &mut self.placed,
            reports: &mut self.reports[..free],
        };
        chunk.solve(&self.layout.parts, &self.workers, limits);
        for (block, report) in blocks.iter().zip(&self.reports) {
            for place in block.movers.clone() {
                let body = self.layout.bodies[place] as usize;
                let mover = &mut self.movers[body];
                if mover.inverse_mass != 0.0 {
                    mover.twist = self.placed[place].twist;
                    self.residuals[body] = report.residual;
                }
            }
        }
    }

    /// Islands with joints, one after the other.
    fn solve_jointed(&mut self, articulation: &mut Articulation, limits: Limits) {
        let (islands, free) = self.islands.count();
        let workers = self.workers.get_mut();
        let workers = workers.unwrap_or_else(PoisonError::into_inner);
        let mut worker = workers.pop().unwrap_or_default();
        for island in free..islands {
            let points = &mut self.points[self.islands.contacts.range(island)];
            let mut system = System {
                points,
                movers: &mut self.movers,
                joints: Some(Jointed {
                    articulation,
                    assemblies: self.islands.assemblies.of(island),
                }),
                parts: &[Layer::WHOLE],
            };
            let report = worker.solve(&mut system, limits);
            for &body in self.islands.bodies.of(island) {
                self.residuals[body as usize] = report.residual;
            }
            self.reports[island] = report;
        }
        workers.push(worker);
    }

    fn give_back(&mut self, contacts: &mut [Contact], which: &[usize]) {
        self.pass_rolls(contacts);
        let points = &self.points;
        if which.len() == contacts.len() {
            each_with(contacts, &self.slots, &|c, &slot| {
                points[slot as usize].tell(c)
            });
            return;
        }
        for (p, &k) in points.iter().zip(&self.layout.contacts) {
            p.tell(&mut contacts[which[k as usize]]);
        }
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
}

impl Chunk<'_> {
    /// Solve its islands; as soon as they are many, halves of them at once.
    fn solve(self, parts: &[Layer], workers: &Mutex<Vec<Worker>>, limits: Limits) {
        if self.blocks.len() > 1 && self.points.len() > HANDFUL {
            let (a, b) = self.halves();
            both(
                || a.solve(parts, workers, limits),
                || b.solve(parts, workers, limits),
            );
            return;
        }
        let locked = || workers.lock().unwrap_or_else(PoisonError::into_inner);
        let mut worker = locked().pop().unwrap_or_default();
        let (mut points, mut movers) = (self.points, self.movers);
        for (block, report) in self.blocks.iter().zip(self.reports) {
            let (own_points, later_points) = points.split_at_mut(block.points.len());
            let (own_movers, later_movers) = movers.split_at_mut(block.movers.len());
            let mut system = System {
                points: own_points,
                movers: own_movers,
                joints: None,
                parts: &parts[block.parts.clone()],
            };
            *report = worker.solve(&mut system, limits);
            (points, movers) = (later_points, later_movers);
        }
        locked().push(worker);
    }

    /// Where about half of the contacts are on either side.
    fn halves(self) -> (Self, Self) {
        let (first, last) = (&self.blocks[0], self.blocks.len() - 1);
        let half = first.points.start + self.points.len() / 2;
        let at = self.blocks.partition_point(|b| b.points.end < half);
        let at = at.clamp(1, last);
        let border = &self.blocks[at];
        let (points, movers) = (
            border.points.start - first.points.start,
            border.movers.start - first.movers.start,
        );
        let (blocks, later_blocks) = self.blocks.split_at(at);
        let (points, later_points) = self.points.split_at_mut(points);
        let (movers, later_movers) = self.movers.split_at_mut(movers);
        let (reports, later_reports) = self.reports.split_at_mut(at);
        let first = Self {
            blocks,
            points,
            movers,
            reports,
        };
        let second = Self {
            blocks: later_blocks,
            points: later_points,
            movers: later_movers,
            reports: later_reports,
        };
        (first, second)
    }
}

impl Worker {
    /// Solve an island from the impulses that stand in its contacts.
    fn solve(&mut self, system: &mut System, limits: Limits) -> Report {
        let coupled = system.joints.is_some() || system.points.iter().any(|p| p.roll.is_some());
        let krylov = coupled || limits.tolerance < DIGITS;
        (self.leap, self.wrong, self.sought) = (krylov.then_some(Leap::Krylov), 0, false);
        self.packs.clear();
        (self.swept, self.coupled) = (0, coupled);
        system.push();
        system.hold_joints();
        if system.points.is_empty() {
            return Report::default();
        }
        self.release(system, limits)
    }

    /// First how much each contact carries, with friction as it stands: friction that is cut off at a cone which is
    /// still too narrow would leave the contacts of a body straining against each other. Static contacts that gave way
    /// slide from there on, and others may give way then; a third of the sweeps is kept for that. It ends, because a
    /// contact changes only from static to kinetic. What slips only because the sweeps have not arrived is not let go.
    /// Where sweeps are all there is, loads on their own get a few only: they are of another balance than loads with
    /// friction, and last step's impulses are nearer to that.
    fn release(&mut self, system: &mut System, limits: Limits) -> Report {
        let mut report = self.iterate(system, Part::Normals, limits.share(3));
        report = report.then(self.iterate(system, Part::All, limits.share(3)));
        self.packs.hand_back(system.points, system.movers);
        while report.iterations < limits.iterations {
            let noticeable = 10.0 * report.residual.max(limits.tolerance);
            let released = system.release_slipping(noticeable);
            if !released && (report.stalled || report.residual < limits.tolerance) {
                break;
            }
            let left = Limits {
                iterations: limits.iterations - report.iterations,
                ..limits
            };
            report = report.then(self.iterate(system, Part::All, left));
            self.packs.hand_back(system.points, system.movers);
        }
        report
    }

    /// Sweeps and leaps in turn, until a sweep changes nothing any more. Ends with a sweep, so that every impulse lies in
    /// its cone. A leap may guess wrongly which contacts carry, and the next sweeps then have more to mend than before:
    /// then its impulses are taken back, and the next guess waits longer; one at the loads alone is the last.
    fn iterate(&mut self, system: &mut System, part: Part, limits: Limits) -> Report {
        let mut iterations = 0;
        let mut patience = match self.leap {
            Some(Leap::Krylov) => 2 * SWEEPS,
            _ => SWEEPS,
        };
        let mut passes = PASSES * limits.iterations;
        let mut start = f64::INFINITY;
        let mut pace = Pace {
            last: f64::INFINITY,
            slow: 0,
        };
        loop {
            let sweeps = patience.min(limits.iterations - iterations);
            let (mut residual, made) = self.sweeps(
                system,
                (part, iterations),
                (sweeps, limits.tolerance),
                ASTRAY * start,
            );
            iterations += made;
            let converged = residual < limits.tolerance;
            let wrong = residual > start && !converged;
            if wrong {
                self.packs.hand_back(system.points, system.movers);
                system.set_impulses(&self.kept);
                residual = start;
            }
            if converged || iterations >= limits.iterations {
                return Report {
                    residual,
                    iterations,
                    stalled: false,
                };
            }
            if residual > 0.5 * start {
                patience *= 2;
            }
            start = f64::INFINITY;
            if wrong {
                self.discourage(residual < limits.calm);
                if part == Part::Normals && self.leap != Some(Leap::Krylov) {
                    return Report {
                        residual,
                        iterations,
                        stalled: false,
                    };
                }
            } else if self.may_leap(system) {
                start = residual;
                self.packs.hand_back(system.points, system.movers);
                self.kept.clear();
                self.kept.extend(system.impulses());
                passes -= self.leap(system, part, passes, (residual, limits));
            } else {
                let stalled = pace.stalls(residual, made, limits.iterations - iterations);
                if (part == Part::Normals && iterations >= LOADS)
                    || (stalled && residual < limits.calm)
                {
                    return Report {
                        residual,
                        iterations,
                        stalled,
                    };
                }
            }
        }
    }

    /// So many sweeps, the first of which is the `first` of all; less when one changes less than the tolerance or more
    /// than `astray`. Every other sweep goes backwards: what a stack passes on reaches both its ends. Returns the last
    /// one's residual, and how many were made.
    fn sweeps(
        &mut self,
        system: &mut System,
        (part, first): (Part, usize),
        (most, tolerance): (usize, f64),
        astray: f64,
    ) -> (f64, usize) {
        let (mut residual, mut made) = (f64::INFINITY, 0);
        while made < most {
            made += 1;
            let backwards = (first + made) % 2 == 0;
            if self.swept == PACKING && !self.coupled {
                self.packs
                    .arrange(system.parts, system.points, system.movers);
            }
            self.swept += 1;
            residual = if self.packs.are_used() {
                if backwards {
                    self.packs.carry_on(system.points, system.movers);
                }
                self.packs
                    .sweep((system.points, system.movers), part, backwards)
            } else {
                system.sweep(part, backwards)
            };
            if residual < tolerance || residual > astray {
                break;
            }
        }
        (residual, made)
    }

    /// Guesses that are dear are given up when they are wrong again and again, and at once where little is left to do.
    fn discourage(&mut self, calm: bool) {
        self.wrong += 1;
        let enough = calm || self.wrong >= MISTAKES;
        if self.leap == Some(Leap::Direct { cheap: false }) && enough {
            self.leap = Some(Leap::Never);
        }
    }

    /// Decides it for the island, once.
    fn may_leap(&mut self, system: &System) -> bool {
        let leap = self.leap.unwrap_or_else(|| self.choose_leap(system));
        self.leap = Some(leap);
        leap != Leap::Never
    }

    /// Where things rest, impulses last, and so would their errors; in a heap that tumbles the contacts that carry are
    /// others every step, and a dear guess at them is seldom right.
    fn choose_leap(&mut self, system: &System) -> Leap {
        let points = &*system.points;
        let most = bearable(points) * points.len();
        match self.direct.products(points, system.movers, most) {
            Some(products) => Leap::Direct {
                cheap: products <= CHEAP * points.len(),
            },
            None => Leap::Never,
        }
    }

    /// Solve the contacts that carry as a linear system, and bring the result back into the cones. Returns the number
    /// of passes over the contacts that it took, at most `budget`.
    ///
    /// Contacts that would have to pull let go, and the others are solved without them: of the corners of a wall that is
    /// still settling, hundreds are held at first that are about to open, and a single guess strains against them. Where
    /// all is slow, but guesses were wrong, the contacts that carry are sought from the interior of their cones, once.
    fn leap(
        &mut self,
        system: &mut System,
        part: Part,
        budget: usize,
        (residual, limits): (f64, Limits),
    ) -> usize {
        if self.leap == Some(Leap::Krylov) {
            let reduction = (0.1 * limits.tolerance / residual).max(LEAP);
            return self.leap_by_gmres(system, part, (budget, reduction));
        }
        let lost = self.wrong > 1 && !self.sought && residual > limits.calm;
        if part == Part::All && lost && Interior::suits(system.points) {
            self.sought = true;
            let (points, movers) = (&mut *system.points, &mut *system.movers);
            let widths = (residual, limits.tolerance);
            self.interior
                .solve(&mut self.direct, (points, movers), widths);
            return 0;
        }
        let settling = residual > limits.calm && system.points.iter().all(|p| p.quiet);
        let rounds = if settling && part == Part::Normals {
            ROUNDS
        } else {
            1
        };
        for _ in 0..rounds {
            let (points, movers) = (&mut *system.points, &mut *system.movers);
            self.carrying.solve(&mut self.direct, points, movers, part);
            if system.cut(part) <= limits.tolerance {
                break;
            }
        }
        0
    }

    fn leap_by_gmres(&mut self, system: &mut System, part: Part, effort: (usize, f64)) -> usize {
        let passes = self.subspace.solve(system, part, effort);
        for (slot, p) in system.points.iter_mut().enumerate() {
            let old = p.impulse;
            p.impulse = p.allowed(old + self.subspace.step(slot), part);
            p.push(system.movers, p.impulse - old);
        }
        if part == Part::All {
            for (slot, step) in self.subspace.turns() {
                let p = &mut system.points[slot];
                let normal = p.impulse.x;
                p.set_turn(system.movers, |roll| {
                    roll.in_bounds(roll.impulse + step, normal)
                });
            }
        }
        system.hold_joints();
        passes
    }
}

/// Products of blocks per contact that a direct solve may take: where nine of ten contacts rest, and the others may be
/// what still settles, what a wall takes; where all rest, what small heaps take, too.
fn bearable(points: &[Point]) -> usize {
    let restless = points.iter().filter(|p| !p.quiet).count();
    match restless {
        0 => DEAR,
        _ if 10 * restless <= points.len() => DEAR / 2,
        _ => CHEAP,
    }
}

impl System<'_> {
    /// Joints take up what contacts did to them, exactly.
    fn hold_joints(&mut self) {
        if let Some(joints) = &mut self.joints {
            for &assembly in joints.assemblies {
                joints.articulation.solve(assembly as usize, self.movers);
            }
        }
    }

    /// Bodies of an assembly.
    pub(crate) fn bodies(&self, assembly: u32) -> &[usize] {
        let joints = self.joints.as_ref();
        joints.map_or(&[], |j| j.articulation.bodies(assembly as usize))
    }

    /// Bodies get the impulses that contacts begin with.
    fn push(&mut self) {
        let movers = Window::new(self.movers);
        visit(self.parts, self.points, movers, false, &|list, movers| {
            for p in list.iter() {
                p.push(movers, p.impulse);
                if let Some(roll) = &p.roll {
                    p.turn(movers, roll.to_world(roll.impulse));
                }
            }
            0.0
        });
    }

    /// Those of all contacts, then the angular ones of those that have any.
    fn impulses(&self) -> impl Iterator<Item = DVec3> + '_ {
        let rolls = self.points.iter().filter_map(|p| p.roll.as_ref());
        self.points
            .iter()
            .map(|p| p.impulse)
            .chain(rolls.map(|roll| roll.impulse))
    }

    /// Impulses brought back into their cones; returns the greatest change of a velocity [m/s].
    fn cut(&mut self, part: Part) -> f64 {
        let mut worst = 0.0_f64;
        for p in self.points.iter_mut() {
            let change = p.allowed(p.impulse, part) - p.impulse;
            p.impulse += change;
            p.push(self.movers, change);
            worst = worst.max((change * p.k()).abs().max_element());
        }
        worst
    }

    fn set_impulses(&mut self, impulses: &[DVec3]) {
        let (pushes, turns) = impulses.split_at(self.points.len());
        for (p, &new) in self.points.iter_mut().zip(pushes) {
            let change = new - p.impulse;
            p.impulse = new;
            p.push(self.movers, change);
        }
        let mut turns = turns.iter();
        for p in self.points.iter_mut() {
            p.set_turn(self.movers, |roll| {
                turns.next().copied().unwrap_or(roll.impulse)
            });
        }
        self.hold_joints();
    }

    /// One sweep; returns the greatest change of a relative velocity [m/s].
    fn sweep(&mut self, part: Part, backwards: bool) -> f64 {
        let movers = Window::new(self.movers);
        let one = |p: &mut Point, movers: &mut Window| {
            let change = p.solve(movers, part);
            if part == Part::All {
                change.max(p.solve_roll(movers))
            } else {
                change
            }
        };
        let worst = visit(
            self.parts,
            self.points,
            movers,
            backwards,
            &|list, movers| {
                let mut worst = 0.0_f64;
                let mut each = |p: &mut Point| worst = worst.max(one(p, movers));
                if backwards {
                    list.iter_mut().rev().for_each(&mut each);
                } else {
                    list.iter_mut().for_each(&mut each);
                }
                worst
            },
        );
        self.hold_joints();
        worst
    }

    /// Static contacts on the rim of their disc that slip nevertheless become kinetic.
    fn release_slipping(&mut self, noticeable: f64) -> bool {
        let mut any = false;
        for p in self.points.iter_mut() {
            any |= p.release(self.movers, noticeable);
        }
        any
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn paced(residuals: &[f64], left: usize) -> Vec<bool> {
        let mut pace = Pace {
            last: f64::INFINITY,
            slow: 0,
        };
        let ask = |&residual: &f64| pace.stalls(residual, 2, left);
        residuals.iter().map(ask).collect()
    }

    #[test]
    fn sweeps_that_do_not_get_on_stall() {
        assert_eq!(paced(&[4.0, 3.9, 3.8, 3.7], 20), [false, false, true, true]);
    }

    #[test]
    fn sweeps_that_get_on_do_not_stall() {
        assert_eq!(paced(&[4.0, 3.7, 3.6, 3.3], 20), [false; 4]);
        assert_eq!(
            paced(&[4.0, 3.9, 3.8, 3.7], 200),
            [false; 4],
            "more sweeps, more patience"
        );
    }
}
