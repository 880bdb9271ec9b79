//! The solve of contacts and drives within a step, and its books.

use std::ops::Range;

use glam::DVec3;

use crate::body::Body;
use crate::contact::{Contact, Remembered};
use crate::joint::{Cause, Course};
use crate::ledger::Ledger;
use crate::loads::work_of_fixed;
use crate::math::length;
use crate::model::Stabilization;
use crate::solver::{Limits, Report, Solver};
use crate::team::{gather, HANDFUL};

use super::aim::{Aimed, Aims};
use super::World;

/// Where sweeps run out, velocities are off by this many times what the last sweep still changed.
const NOISE: f64 = 10.0;
/// Where sweeps stall, this part of what gravity gives in a step is left.
const CALM: f64 = 1e-3;

impl World {
    /// Impulses that keep bodies apart, rub them and drive their joints, all together, from where the bodies would be
    /// without them. They act on the motion as constant forces.
    pub(super) fn solve_contacts(&mut self, h: f64) {
        self.aim_contacts(h);
        if self.contacts.is_empty() && self.articulation.drives().is_empty() {
            self.report = Report::default();
            self.noise.fill(0.0);
        } else {
            self.solve_bounded(h);
        }
        let system = (&self.joints, &self.articulation);
        self.loads.hold(&self.contacts, system, h);
        self.note_contacts(h);
        self.note_drives(h);
        self.arrest(true, h);
        self.arrest(false, h);
    }

    /// Contacts, drives, and the joints that hold meanwhile.
    fn solve_bounded(&mut self, h: f64) {
        let pull = if self.settings.stabilization == Stabilization::Baumgarte {
            self.settings.baumgarte / h
        } else {
            0.0
        };
        let hold = |row: &Course| {
            if pull > 0.0 {
                -pull * row.value
            } else {
                -h * row.bias
            }
        };
        self.articulation.aim_step(hold, h);
        self.every.clear();
        self.every.extend(0..self.contacts.len());
        let limits = Limits {
            iterations: self.settings.iterations,
            tolerance: self.settings.tolerance,
            calm: CALM * self.forces.gravity().length() * h,
            quiet_speed: self.settings.slip_speed,
        };
        self.solver.load_after(&self.bodies, &self.loads.free, h);
        self.report = self.solver.solve(
            &mut self.contacts,
            &self.every,
            &mut self.articulation,
            limits,
        );
        let tolerance = self.settings.tolerance;
        for (noise, &residual) in self.noise.iter_mut().zip(self.solver.residuals()) {
            *noise = if residual < tolerance {
                0.0
            } else {
                NOISE * residual
            };
        }
        self.articulation.keep_holds();
        self.lock_joints();
    }

    /// Coordinates that a limit or friction brings to rest, or keeps there, are rows of the joints for this step.
    fn lock_joints(&mut self) {
        for (k, drive) in self.articulation.drives().iter().enumerate() {
            if let Some(lock) = drive.lock.filter(|_| self.articulation.reaches(k)) {
                self.joints.lock(k, lock);
            }
        }
    }

    /// What speed locked coordinates have is lost, to an impact against the limit or to friction.
    fn arrest(&mut self, by_limit: bool, h: f64) {
        if !self.joints.any_locked(by_limit) {
            return;
        }
        self.articulation.load_bilateral(&self.joints, &self.bodies);
        self.articulation.clear_impulses();
        self.articulation.note_rates(&self.bodies);
        let before = self.kinetic_energy(h);
        let rows = self.articulation.rows();
        self.joints.arrest(rows, by_limit, &mut self.values);
        self.articulation.kick(&mut self.bodies, &self.values);
        let lost = before - self.kinetic_energy(h);
        if by_limit {
            self.ledger.lost_impact += lost;
        } else {
            self.ledger.lost_friction += lost;
        }
    }

    /// Of the velocities v + a s dt / 2 on the integrator's parabola, see `impact.rs`, to first order in dt [J].
    fn kinetic_energy(&self, h: f64) -> f64 {
        let of = |b: &Body| b.kinetic_energy().0 + b.kinetic_energy().1;
        let moving = self.bodies.iter().filter(|b| !b.is_fixed());
        moving.map(of).sum::<f64>() + 0.5 * self.rules(h).offset() * self.loads.power(&self.bodies)
    }

    /// Where every contact's normal velocity is to go, its friction, and the impulse to begin with.
    fn aim_contacts(&mut self, h: f64) {
        let count = self.contacts.len();
        self.gaps.resize(count, 0.0);
        self.starts.resize(count, DVec3::ZERO);
        let aims = Aims {
            bodies: &self.bodies,
            geoms: &self.geoms,
            kinks: self.impacts.any.then_some(&self.impacts.kinks),
            settings: &self.settings,
            h,
        };
        aims.aim_all(Aimed {
            contacts: &mut self.contacts,
            starts: &mut self.starts,
            gaps: &mut self.gaps,
            memory: self.memory.recall(&self.match_radius, h),
        });
    }

    /// Velocities after the solve, their work, and the gaps that they lead to. The impulses are remembered.
    fn note_contacts(&mut self, h: f64) {
        let notes = Notes {
            bodies: &self.bodies,
            solver: &self.solver,
            slow: 10.0 * self.settings.tolerance,
            lead: self.settings.integrator.lead(),
            h,
        };
        let before = self.ledger;
        let count = self.contacts.len();
        let noted = (
            (&self.starts[..], &mut self.gaps[..]),
            (self.memory.renew(count), 0..count),
        );
        let work = |(contacts, ((starts, gaps), (memory, range))): NotedPart| {
            let mut ledger = if range.start == 0 {
                before
            } else {
                Ledger::default()
            };
            let contacts = contacts.iter_mut().zip(memory);
            for ((c, place), (start, gap)) in contacts.zip(starts.iter().zip(gaps)) {
                *place = notes.note(c, *start, gap, &mut ledger);
            }
            ledger
        };
        self.ledger = gather(
            (&mut self.contacts[..], noted),
            HANDFUL,
            &work,
            &|a: Ledger, b| a.plus(&b),
        );
    }

    /// Work of motors, and what limits and dry friction take.
    fn note_drives(&mut self, h: f64) {
        let impulses = self.articulation.drive_impulses();
        for (k, (drive, &impulse)) in self.articulation.drives().iter().zip(impulses).enumerate() {
            if drive.is_idle() || self.joints.is_locked(k) {
                continue;
            }
            let mean = 0.5 * (drive.row.rate(&self.bodies) + self.solver.rate(&drive.row));
            let work = impulse * mean;
            self.ledger.work_motors += work_of_fixed(&drive.row, impulse, &self.bodies);
            match drive.cause {
                Cause::Limit => self.ledger.book(work, 0.0),
                Cause::Friction => self.ledger.book(0.0, work),
                Cause::Motor => {
                    let rubbed = drive.friction * h * mean.abs();
                    self.ledger.lost_friction += rubbed;
                    self.ledger.work_motors += work + rubbed;
                }
            }
        }
    }
}

type NotedPart<'a> = (
    &'a mut [Contact],
    (
        (&'a [DVec3], &'a mut [f64]),
        (&'a mut [Remembered], Range<usize>),
    ),
);

/// What a solve came to.
struct Notes<'a> {
    bodies: &'a [Body],
    solver: &'a Solver,
    /// Slower than this is no sliding [m/s].
    slow: f64,
    lead: f64,
    h: f64,
}

impl Notes<'_> {
    /// The velocity of a contact that began with `start`, its work, and the gap that it leads to. Returns what is to be
    /// remembered of it.
    fn note(
        &self,
        c: &mut Contact,
        start: DVec3,
        gap: &mut f64,
        ledger: &mut Ledger,
    ) -> Remembered {
        let p = c.to_world(c.impulse);
        let u = self.solver.velocity(c);
        c.velocity_after = c.to_world(u);
        // Impulses act with the arms of now, so their work is that of the velocities with these arms.
        let mean = 0.5 * (start + u - c.ahead);
        ledger.book(0.0, c.impulse.y * mean.y + c.impulse.z * mean.z);
        // A contact that aims at parting is Baumgarte's: its work takes back an overlap.
        if c.target > 0.0 {
            ledger.stabilization += c.impulse.x * mean.x;
        } else {
            ledger.book(c.impulse.x * mean.x, 0.0);
        }
        ledger.work_motors -= p.dot(c.driven(self.bodies));
        if let Some(roll) = &c.roll {
            let turned = roll.to_world(roll.impulse);
            let mean = 0.5 * (c.turning(self.bodies) + self.solver.turning(c));
            ledger.book(0.0, turned.dot(mean));
            ledger.work_motors -= turned.dot(c.driven_turning(self.bodies));
        }
        *gap += ((1.0 - self.lead) * start.x + self.lead * u.x) * self.h;
        let loaded = c.impulse.x > 0.0 || c.impact_impulse != DVec3::ZERO;
        c.sliding = loaded && length(u.y, u.z) > self.slow;
        Remembered::of(c, p, self.bodies, self.h)
    }
}
