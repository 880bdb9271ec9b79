//! Located impacts: a step is divided at the instants at which surfaces touch.
//!
//! The instant is the root of the gap on the integrator's own path: moving by h is a step of the integrator of that
//! length, with resting contacts and joints, so that what is found is exactly what is then done. The parabola that the step
//! begins with tells where to look (`approach`); Newton's method on whole trial steps puts it right where forces vary.
//! Then Newton's rule of impact acts, and the rest of the step goes on from there. A bouncing body so keeps the order of its
//! integrator.

use crate::articulation::Hold;
use crate::body::Body;
use crate::collide::Oracle;
use crate::contact::Memory;
use crate::impact::{touching_instant, touching_speed, Rules};
use crate::ledger::Ledger;

use super::{Failure, World};

/// Parts of a step at most; one that needs more is finished as a stepped one.
const PARTS: usize = 1000;
/// Impacts within this part of a step are simultaneous, and so near that nothing need move before them.
const NOW: f64 = 1e-8;
/// This part of a step is nothing left: an impact fell on its end, and belongs to the next one.
const NOTHING: f64 = 1e-12;
/// Trial steps towards one impact at most.
const TRIALS: usize = 8;
/// An overlap this small is none [m].
const CLOSED: f64 = 1e-13;

/// The next touching.
struct Touch {
    geoms: (u32, u32),
    instant: f64,
    speed: f64,
}

/// What a trial step changes.
struct Mark {
    bodies: Vec<Body>,
    memory: Memory,
    ledger: Ledger,
    noise: Vec<f64>,
    holds: Vec<Hold>,
}

impl World {
    /// One step, impact by impact.
    pub(super) fn advance_located(&mut self, oracle: &mut dyn Oracle) -> Result<(), Failure> {
        for _ in 0..PARTS {
            let left = self.settings.timestep - self.passed;
            if left <= NOTHING * self.settings.timestep {
                return Ok(());
            }
            self.survey(left, oracle)?;
            let rules = self.rules(left);
            let now = NOW * self.settings.timestep;
            match self.first_touch(&rules) {
                None => {
                    self.finish(left);
                    self.report_whole_step(left);
                    return Ok(());
                }
                Some(touch) if touch.instant <= now => {
                    self.resolve_impacts(&Rules {
                        horizon: now,
                        ..rules
                    });
                }
                Some(touch) => self.approach_touch(&touch, left, oracle)?,
            }
        }
        self.fallbacks += 1;
        self.advance(self.settings.timestep - self.passed, oracle)
    }

    /// Contacts of the last part, of length `h`, are handed out as if it had been the whole step: forces are impulses over
    /// the timestep.
    fn report_whole_step(&mut self, h: f64) {
        let share = self.settings.timestep / h;
        for c in &mut self.contacts {
            c.impulse *= share;
        }
    }

    fn first_touch(&self, rules: &Rules) -> Option<Touch> {
        let accelerations = &self.loads.accelerations;
        let touch = |c: &crate::contact::Contact| {
            let instant = touching_instant(c, &self.bodies, accelerations, rules);
            Touch {
                geoms: c.geoms,
                instant,
                speed: touching_speed(c, &self.bodies, accelerations, instant, rules),
            }
        };
        let touches = self.contacts.iter().map(touch);
        touches
            .filter(|t| t.instant.is_finite())
            .min_by(|a, b| a.instant.total_cmp(&b.instant))
    }

    /// Move on to the instant of touching. Where the gap is still open then, the search goes on from there: no other pair
    /// touches earlier, and one that only grazes must not take the world past the others.
    fn approach_touch(
        &mut self,
        touch: &Touch,
        left: f64,
        oracle: &mut dyn Oracle,
    ) -> Result<(), Failure> {
        let rules = self.rules(left);
        let (bodies, accelerations) = (&self.bodies, &self.loads.accelerations);
        // Only what rests takes part in the motion until then.
        self.contacts
            .retain(|c| touching_instant(c, bodies, accelerations, &rules).is_infinite());
        let start = self.mark();
        let mut h = touch.instant;
        for trial in 1..=TRIALS {
            self.evaluate_forces(h);
            self.finish(h);
            let Some(gap) = self.gap_between(touch.geoms, oracle)? else {
                break;
            };
            if gap >= -CLOSED || trial == TRIALS {
                break;
            }
            self.rewind(&start);
            let next = h + gap / touch.speed;
            h = if next > 0.0 { next } else { 0.5 * h };
        }
        self.passed += h;
        Ok(())
    }

    /// Gap between two geoms where they are now, none where they are far from each other.
    fn gap_between(
        &mut self,
        geoms: (u32, u32),
        oracle: &mut dyn Oracle,
    ) -> Result<Option<f64>, Failure> {
        let (a, b) = (&self.geoms[geoms.0 as usize], &self.geoms[geoms.1 as usize]);
        let job = self.job(geoms, crate::approach::near_margin(a, b));
        self.detector
            .run(&self.geoms, &[job], self.settings.fcl_only, oracle)
            .map_err(Failure::Oracle)?;
        let depths = self.detector.found().map(|f| f.point.depth);
        Ok(depths.reduce(f64::max).map(|depth| -depth))
    }

    fn mark(&self) -> Mark {
        Mark {
            bodies: self.bodies.clone(),
            memory: self.memory.clone(),
            ledger: self.ledger,
            noise: self.noise.clone(),
            holds: self.articulation.kept_holds().to_vec(),
        }
    }

    fn rewind(&mut self, mark: &Mark) {
        self.bodies.clone_from(&mark.bodies);
        self.memory.clone_from(&mark.memory);
        self.ledger = mark.ledger;
        self.noise.clone_from(&mark.noise);
        self.articulation.keep(&mark.holds);
    }
}
