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
//!
//! Here contacts and bodies are laid out island by island; `worker.rs` solves one of them.

use std::sync::{Mutex, PoisonError};

use glam::DVec3;

use crate::articulation::Articulation;
use crate::body::Body;
use crate::contact::Contact;
use crate::islands::{index, Islands};
use crate::joint::Row;
use crate::layout::{Block, Layer, Layout, Plan};
use crate::mover::{Mover, Twist};
use crate::point::Point;
use crate::system::{Jointed, System};
use crate::team::{both, each_with, fill, gather};
use crate::worker::Worker;
pub use crate::worker::{Limits, Report};

/// Slot of a contact that is not solved.
const NOWHERE: u32 = u32::MAX;
/// Contacts that are worth handing to another thread.
const HANDFUL: usize = 200;

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
