//! An island solved: sweeps over its contacts, and linear solves over those that carry, in turn (see `solver.rs`).

use glam::DVec3;

use crate::carrying::Carrying;
use crate::direct::Direct;
use crate::interior::Interior;
use crate::mover::Part;
use crate::pack::Packs;
use crate::point::Point;
use crate::subspace::Subspace;
use crate::system::System;

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
    pub(crate) fn and(self, other: Self) -> Self {
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

/// Solves one island after the other.
#[derive(Debug, Default)]
pub(crate) struct Worker {
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

impl Worker {
    /// Solve an island from the impulses that stand in its contacts.
    pub(crate) fn solve(&mut self, system: &mut System, limits: Limits) -> Report {
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
