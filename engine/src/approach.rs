//! From found points to the contacts of a step.
//!
//! Points that nearly touch become contacts as they are. A pair that will be hit within the step is followed to the
//! instant of touching by conservative advancement (Mirtich 1996): advance by gap / closing speed, look again, until
//! the gap is closed; its contacts are those at that instant, with the normal and the arms that hold there. Pairs that
//! pass each other drop out on the way.

use crate::body::Body;
use crate::collide::{Detector, Found, Job, Oracle, Stretch, STRETCH};
use crate::contact::{relative_velocity, Contact, Meeting};
use crate::impact::{normal_acceleration, touching_instant, Rules};
use crate::math::rotation_from_vector;
use crate::model::{Geom, PairTable, Settings};
use crate::mover::Twist;
use crate::narrowphase::ContactPoint;
use crate::shape::Pose;
use crate::team::both;

/// Contacts appear before the surfaces touch, at this part of the smaller geom's bounding radius.
const NEAR: f64 = 0.01;
/// A gap closed to this part of the near margin is touching.
const TOUCHING: f64 = 1e-6;
/// Looks at most on the way to touching.
const ROUNDS: usize = 12;

/// The world as it stands when a step begins.
pub struct StepStart<'a> {
    /// Simulation settings.
    pub settings: &'a Settings,
    /// Collision shapes.
    pub geoms: &'a [Geom],
    /// Material pairs.
    pub pairs: &'a PairTable,
    /// Bodies at the start of the step.
    pub bodies: &'a [Body],
    /// Their accelerations but for contacts.
    pub accelerations: &'a [Twist],
    /// What the last contact solve may have left of each body's velocity [m/s].
    pub noise: &'a [f64],
    /// When an approach counts as an impact.
    pub rules: Rules,
}

/// Gap up to which a point is a contact although nothing moves [m].
#[must_use]
pub fn near_margin(a: &Geom, b: &Geom) -> f64 {
    NEAR * a
        .shape
        .bounding_radius()
        .min(b.shape.bounding_radius())
        .min(1e3)
}

/// A pair on its way to touching.
#[derive(Clone, Copy)]
struct Pursuit {
    job: u32,
    instant: f64,
    state: Chase,
}

#[derive(Clone, Copy, PartialEq)]
enum Chase {
    Open,
    Touching,
    Missed,
}

/// Working memory.
#[derive(Default)]
pub struct Approach {
    pursuits: Vec<Pursuit>,
    /// Of each job, the instant at which one of its points is hit.
    touches: Vec<f64>,
    jobs: Vec<Job>,
}

impl Approach {
    /// Fill `out` with the contacts of the step, in the order of the jobs. Returns whether any may be hit within it.
    ///
    /// # Errors
    /// The oracle's message.
    pub fn contacts(
        &mut self,
        start: &StepStart,
        jobs: &[Job],
        detector: &mut Detector,
        oracle: &mut dyn Oracle,
        out: &mut Vec<Contact>,
    ) -> Result<bool, String> {
        let stretches = detector.stretches();
        // Contacts of the step before are written over.
        out.resize_with(count_near(stretches), Contact::default);
        self.touches.clear();
        self.touches.resize(jobs.len(), f64::INFINITY);
        start.survey_all(jobs, (0, stretches), &mut self.touches, out);
        self.pursuits.clear();
        for (job, &instant) in (0..).zip(&self.touches) {
            if instant > 0.0 && instant.is_finite() {
                self.pursuits.push(Pursuit {
                    job,
                    instant,
                    state: Chase::Open,
                });
            }
        }
        if !self.pursuits.is_empty() {
            self.pursue(start, jobs, detector, oracle, out)?;
        }
        Ok(self.touches.iter().any(|instant| instant.is_finite()))
    }

    /// Follow all pursuits together, so that the oracle is asked once a round.
    fn pursue(
        &mut self,
        start: &StepStart,
        jobs: &[Job],
        detector: &mut Detector,
        oracle: &mut dyn Oracle,
        out: &mut Vec<Contact>,
    ) -> Result<(), String> {
        let hits = out.len();
        for _ in 0..ROUNDS {
            self.jobs.clear();
            self.jobs.extend(
                self.pursuits
                    .iter()
                    .map(|p| start.job_at(&jobs[p.job as usize], p.instant)),
            );
            detector.run(start.geoms, &self.jobs, start.settings.fcl_only, oracle)?;
            let mut open = false;
            out.truncate(hits);
            for points in detector.stretches().iter().flat_map(Stretch::answers) {
                let pursuit = &mut self.pursuits[points[0].job as usize];
                let job = &jobs[pursuit.job as usize];
                let before = out.len();
                let near = points.iter().filter(|f| f.near).count();
                out.resize_with(before + near, Contact::default);
                let places = &mut out[before..].iter_mut();
                let next = start.survey(job, points, pursuit.instant, places);
                start.advance(pursuit, job, points, next);
                open |= pursuit.state == Chase::Open;
                if pursuit.state == Chase::Missed {
                    out.truncate(before);
                }
            }
            if !open {
                break;
            }
        }
        self.replace(start, jobs, hits, out);
        Ok(())
    }

    /// Contacts of pairs that were pursued to touching stand for those found at the start of the step. A pair that turned
    /// out to pass keeps those that it rests on, without the ones that seemed about to be hit.
    fn replace(&self, start: &StepStart, jobs: &[Job], hits: usize, out: &mut Vec<Contact>) {
        let pairs_of = |state: Chase| {
            let some = self.pursuits.iter().filter(move |p| p.state == state);
            some.map(|p| jobs[p.job as usize].geoms).collect::<Vec<_>>()
        };
        let missed = pairs_of(Chase::Missed);
        let mut pursued: Vec<(u32, u32)> = out[hits..].iter().map(|c| c.geoms).collect();
        pursued.dedup();
        let mut index = 0;
        out.retain(|c| {
            index += 1;
            let passes = missed.binary_search(&c.geoms).is_ok()
                && touching_instant(c, start.bodies, start.accelerations, &start.rules).is_finite();
            index > hits || !(passes || pursued.binary_search(&c.geoms).is_ok())
        });
        out.sort_by_key(|c| c.geoms);
    }
}

/// Points that nearly touch.
fn count_near(stretches: &[Stretch]) -> usize {
    stretches.iter().map(Stretch::near).sum()
}

impl StepStart<'_> {
    fn geoms(&self, job: &Job) -> (&Geom, &Geom) {
        (
            &self.geoms[job.geoms.0 as usize],
            &self.geoms[job.geoms.1 as usize],
        )
    }

    fn near(&self, job: &Job) -> f64 {
        let (a, b) = self.geoms(job);
        near_margin(a, b)
    }

    /// The centre-of-mass pose of a body at an instant of the step, if nothing hits it: x + v t + a t (t + s dt) / 2.
    fn pose_at(&self, body: usize, t: f64) -> Pose {
        let b = &self.bodies[body];
        if t == 0.0 {
            return b.pose();
        }
        let fall = self.fall(t);
        let a = &self.accelerations[body];
        let turn = rotation_from_vector(b.angular_velocity * t + a.angular_velocity * fall);
        Pose {
            position: b.state.position + b.state.velocity * t + a.velocity * fall,
            rotation: glam::DMat3::from_quat(turn) * b.rotation,
        }
    }

    /// Displacement at the instant t by a unit acceleration, t (t + s dt) / 2 [s^2].
    fn fall(&self, t: f64) -> f64 {
        0.5 * t * (t + self.rules.offset())
    }

    fn job_at(&self, job: &Job, t: f64) -> Job {
        let (a, b) = self.geoms(job);
        let poses = (
            a.pose(&self.pose_at(a.body, t)),
            b.pose(&self.pose_at(b.body, t)),
        );
        Job { poses, ..*job }
    }

    /// Contacts at those of the points, found with both bodies where they are at the instant `t`, that nearly touch, each to
    /// the next of the `places`. Returns the first instant at which one of the points is hit, infinite when none is.
    fn survey<'a>(
        &self,
        job: &Job,
        points: &[Found],
        t: f64,
        places: &mut impl Iterator<Item = &'a mut Contact>,
    ) -> f64 {
        let meeting = self.meeting(job, t);
        let mut earliest = f64::INFINITY;
        for found in points {
            let mut far = None;
            let place = if found.near { places.next() } else { None };
            let c = place.unwrap_or_else(|| far.insert(Contact::default()));
            self.put(&meeting, &found.point, t, c);
            let touch = touching_instant(c, self.bodies, self.accelerations, &self.rules);
            earliest = earliest.min(touch);
        }
        earliest
    }

    /// The same for all points found at the start of the step, some stretches of jobs at once: contacts to `out`, and each
    /// job's first instant to its place in `touches`. The first of these stretches has this number.
    fn survey_all(
        &self,
        jobs: &[Job],
        (first, stretches): (usize, &[Stretch]),
        touches: &mut [f64],
        out: &mut [Contact],
    ) {
        if stretches.len() > 1 {
            let half = stretches.len() / 2;
            let (a, b) = stretches.split_at(half);
            let (touches_a, touches_b) = touches.split_at_mut(half * STRETCH);
            let (out_a, out_b) = out.split_at_mut(count_near(a));
            both(
                || self.survey_all(jobs, (first, a), touches_a, out_a),
                || self.survey_all(jobs, (first + half, b), touches_b, out_b),
            );
            return;
        }
        let mut places = out.iter_mut();
        for points in stretches.iter().flat_map(Stretch::answers) {
            let job = points[0].job as usize;
            touches[job - first * STRETCH] = self.survey(&jobs[job], points, 0.0, &mut places);
        }
    }

    fn meeting(&self, job: &Job, t: f64) -> Meeting<'_> {
        let (a, b) = self.geoms(job);
        let centre = |body: usize| match t {
            0.0 => self.bodies[body].state.position,
            _ => self.pose_at(body, t).position,
        };
        let coefficients = self.pairs.get(a.material, b.material);
        let centres = (centre(a.body), centre(b.body));
        Meeting::new(job.geoms, (a, b), self.bodies, centres, coefficients)
    }

    /// A contact becomes the one at a point found at the instant `t`. Its gap is traced back along the paths to the start of the step.
    fn put(&self, meeting: &Meeting, point: &ContactPoint, t: f64, c: &mut Contact) {
        meeting.put(point, c);
        c.noise = self.noise[c.bodies.0].max(self.noise[c.bodies.1]);
        if t > 0.0 {
            let fall = normal_acceleration(c, self.accelerations) * self.fall(t);
            c.gap -= relative_velocity(self.bodies, c.bodies, c.arms).dot(c.normal) * t + fall;
            c.instant = t;
        }
    }

    /// One look at a pursued pair, whose points were found at its instant and are hit at `next`: touching, missed, or
    /// farther on.
    fn advance(&self, pursuit: &mut Pursuit, job: &Job, points: &[Found], next: f64) {
        if pursuit.state != Chase::Open {
            return;
        }
        let deepest = points
            .iter()
            .map(|f| f.point.depth)
            .fold(f64::NEG_INFINITY, f64::max);
        let closed = deepest.abs() <= TOUCHING * self.near(job);
        if closed || (next - pursuit.instant).abs() <= 1e-9 * self.settings.timestep {
            pursuit.state = Chase::Touching;
        } else if next.is_finite() {
            pursuit.instant = next;
        } else {
            pursuit.state = Chase::Missed;
            pursuit.instant = 0.0;
        }
    }
}
