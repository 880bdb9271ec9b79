//! The world and its step.

use std::mem::discriminant;

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::approach::{near_margin, Approach, StepStart};
use crate::articulation::{Articulation, Hold};
use crate::body::{Body, MassProperties, State};
use crate::broadphase::Broadphase;
use crate::collide::{Detector, Job, Oracle};
use crate::contact::{Contact, Memory};
use crate::force::{Forces, Potential, Powers};
use crate::impact::{gap_change, Event, Impacts, Rules, Scene};
use crate::integrator::Dynamics;
use crate::joint::{Ahead, Cause, JointState, Joints, Row};
use crate::ledger::{Energies, Ledger};
use crate::loads::{work_of_fixed, Loads};
use crate::math::length;
use crate::model::{Geom, Model, PairTable, Settings, Stabilization};
use crate::mover::Twist;
use crate::paths::Paths;
use crate::position::{Correction, SLOP};
use crate::shape::Aabb;
use crate::solver::{Limits, Report, Solver};

/// Speeds above this are a blow-up, not physics [m/s].
const SPEED_LIMIT: f64 = 1e8;
/// Where sweeps run out, velocities are off by this many times what the last sweep still changed.
const NOISE: f64 = 10.0;
/// A body slower than this, in its fastest point, rests [m/s].
const REST_SPEED: f64 = 1e-3;

/// Why a step could not be made.
#[derive(Clone, Debug, PartialEq)]
pub enum Failure {
    /// A body's state is not finite, or faster than any body can be.
    Diverged {
        /// Index of the body.
        body: usize,
        /// [s]
        time: f64,
    },
    /// The oracle failed; its message.
    Oracle(String),
}

/// Everything that a step needs, and the state that it advances.
pub struct World {
    pub(crate) settings: Settings,
    pub(crate) geoms: Vec<Geom>,
    pairs: PairTable,
    /// Those of the scene, and the world itself as the last.
    pub(crate) bodies: Vec<Body>,
    forces: Forces,
    joints: Joints,
    pub(crate) articulation: Articulation,
    paths: Paths,
    pub(crate) loads: Loads,
    pub(crate) contacts: Vec<Contact>,
    pub(crate) memory: Memory,
    broadphase: Broadphase,
    pub(crate) detector: Detector,
    approach: Approach,
    impacts: Impacts,
    solver: Solver,
    correction: Correction,
    pub(crate) ledger: Ledger,
    report: Report,
    step: u64,
    resting_steps: u64,
    pub(crate) fallbacks: u64,
    boxes: Vec<Aabb>,
    candidates: Vec<(u32, u32)>,
    jobs: Vec<Job>,
    starts: Vec<DVec3>,
    gaps: Vec<f64>,
    every: Vec<usize>,
    match_radius: Vec<f64>,
    pub(crate) noise: Vec<f64>,
    /// Of the joints' rows as the integrator left them.
    values: Vec<f64>,
    /// Part of the step that is already made [s].
    pub(crate) passed: f64,
}

/// What a checkpoint holds: all that the next step depends on.
#[derive(Serialize, Deserialize)]
struct Snapshot {
    step: u64,
    resting_steps: u64,
    fallbacks: u64,
    states: Vec<State>,
    memory: Memory,
    noise: Vec<f64>,
    ledger: Ledger,
    events: Vec<Event>,
    joints: JointState,
    holds: Vec<Hold>,
    turns: Vec<f64>,
}

impl World {
    /// Build the world at its start.
    #[must_use]
    pub fn new(model: Model) -> Self {
        let bodies = place_bodies(&model);
        let forces = Forces::new(model.forces, &bodies);
        let joints = Joints::new(model.joints, model.drives, &bodies);
        let ahead = Ahead {
            time: 0.0,
            timestep: model.settings.timestep,
            lead: model.settings.integrator.lead(),
        };
        let mut world = Self {
            broadphase: Broadphase::new(&model.geoms, &model.no_contact),
            noise: vec![0.0; bodies.len()],
            match_radius: model
                .geoms
                .iter()
                .map(|g| 0.2 * g.shape.bounding_radius())
                .collect(),
            articulation: Articulation::new(&joints, &bodies, ahead),
            paths: Paths::new(model.motions, &bodies),
            loads: Loads::new(bodies.len()),
            settings: model.settings,
            geoms: model.geoms,
            pairs: model.pairs,
            bodies,
            forces,
            joints,
            contacts: Vec::new(),
            memory: Memory::default(),
            detector: Detector::default(),
            approach: Approach::default(),
            impacts: Impacts::default(),
            solver: Solver::default(),
            correction: Correction::default(),
            ledger: Ledger::default(),
            report: Report::default(),
            step: 0,
            resting_steps: 0,
            fallbacks: 0,
            boxes: Vec::new(),
            candidates: Vec::new(),
            jobs: Vec::new(),
            starts: Vec::new(),
            gaps: Vec::new(),
            every: Vec::new(),
            values: Vec::new(),
            passed: 0.0,
        };
        world.paths.arrive(&mut world.bodies, 0.0);
        world.ledger.initial = world.energies().total();
        world
    }

    /// One step of the timestep.
    ///
    /// # Errors
    /// [`Failure`]; the state is then that of the failed step.
    pub fn step(&mut self, oracle: &mut dyn Oracle) -> Result<(), Failure> {
        self.impacts.begin_step();
        if self.settings.locates() {
            self.advance_located(oracle)?;
        } else {
            self.advance(self.settings.timestep, oracle)?;
        }
        self.step += 1;
        self.passed = 0.0;
        self.observe();
        self.watch()
    }

    /// Move on by `h`.
    pub(crate) fn advance(&mut self, h: f64, oracle: &mut dyn Oracle) -> Result<(), Failure> {
        self.survey(h, oracle)?;
        self.resolve_impacts(&self.rules(h));
        self.finish(h);
        Ok(())
    }

    /// What acts on bodies, and what touches or will touch within `h`.
    pub(crate) fn survey(&mut self, h: f64, oracle: &mut dyn Oracle) -> Result<(), Failure> {
        self.impacts.begin_part(self.bodies.len());
        self.evaluate_forces(h);
        self.collide(h, oracle)
    }

    /// Contacts and joints, then the motion, then what it left of overlaps.
    pub(crate) fn finish(&mut self, h: f64) {
        self.solve_contacts(h);
        self.move_bodies(h);
        self.correct_positions();
    }

    /// Accelerations of bodies, as their joints allow them, and what drives and limits of joints ask for.
    pub(crate) fn evaluate_forces(&mut self, h: f64) {
        let ahead = Ahead {
            time: self.time(),
            timestep: h,
            lead: self.settings.integrator.lead(),
        };
        self.paths
            .depart(&mut self.bodies, ahead.time, h, ahead.lead);
        self.joints.release();
        let system = (&self.forces, &self.joints, &mut self.articulation);
        self.loads.evaluate(&self.bodies, system, ahead);
    }

    /// Contacts of this step: points that are nearly touching, and points that will touch before the step ends, at
    /// the instant of touching.
    fn collide(&mut self, h: f64, oracle: &mut dyn Oracle) -> Result<(), Failure> {
        let travel = |(b, a): (&Body, &Twist)| {
            let spin = b.angular_velocity.length() + a.angular_velocity.length() * h;
            // A half-space reaches infinitely far, but most stand still.
            let swept = if spin > 0.0 { spin * b.reach } else { 0.0 };
            h * (b.state.velocity.length() + a.velocity.length() * h + swept)
        };
        let bodies = self.bodies.iter();
        let travels: Vec<f64> = bodies.zip(&self.loads.accelerations).map(travel).collect();
        self.find_candidates(&travels);
        self.jobs.clear();
        for &(i, j) in &self.candidates {
            let (a, b) = (&self.geoms[i as usize], &self.geoms[j as usize]);
            let margin = near_margin(a, b) + travels[a.body] + travels[b.body];
            self.jobs.push(self.job((i, j), margin));
        }
        let start = StepStart {
            settings: &self.settings,
            geoms: &self.geoms,
            pairs: &self.pairs,
            bodies: &self.bodies,
            accelerations: &self.loads.accelerations,
            noise: &self.noise,
            rules: self.rules(h),
        };
        self.detector
            .run(&self.geoms, &self.jobs, self.settings.fcl_only, oracle)
            .and_then(|()| {
                self.approach.contacts(
                    &start,
                    &self.jobs,
                    &mut self.detector,
                    oracle,
                    &mut self.contacts,
                )
            })
            .map_err(Failure::Oracle)
    }

    /// Pairs of geoms whose boxes, grown by what the bodies may travel in a step, overlap.
    fn find_candidates(&mut self, travels: &[f64]) {
        self.boxes.clear();
        for geom in &self.geoms {
            let pose = geom.pose(&self.bodies[geom.body].pose());
            let grown = travels[geom.body] + near_margin(geom, geom);
            self.boxes.push(geom.shape.aabb(&pose).expanded(grown));
        }
        let bodies = &self.bodies;
        self.broadphase.pairs(
            &self.geoms,
            &self.boxes,
            |k| !bodies[k].is_fixed(),
            &mut self.candidates,
        );
    }

    /// Two geoms where their bodies are now.
    pub(crate) fn job(&self, geoms: (u32, u32), margin: f64) -> Job {
        let pose = |k: u32| {
            let geom = &self.geoms[k as usize];
            geom.pose(&self.bodies[geom.body].pose())
        };
        Job {
            geoms,
            poses: (pose(geoms.0), pose(geoms.1)),
            margin,
        }
    }

    pub(crate) fn rules(&self, h: f64) -> Rules {
        Rules {
            timestep: h,
            horizon: h,
            whole: self.settings.timestep,
            time: self.time(),
            bounce_speed: self.settings.bounce_speed,
            tolerance: self.settings.tolerance,
            slip_speed: self.settings.slip_speed,
            iterations: self.settings.iterations,
            lead: self.settings.integrator.lead(),
        }
    }

    pub(crate) fn resolve_impacts(&mut self, rules: &Rules) {
        let mut scene = Scene {
            bodies: &mut self.bodies,
            accelerations: &self.loads.accelerations,
            contacts: &mut self.contacts,
            articulation: &mut self.articulation,
        };
        self.impacts.resolve(&mut scene, rules);
        if self.impacts.any {
            self.ledger.book(self.impacts.work.0, self.impacts.work.1);
            self.ledger.work_motors += self.impacts.driven_work;
            self.evaluate_forces(rules.timestep);
        }
    }

    /// Impulses that keep bodies apart, rub them and drive their joints, all together, from where the bodies would be
    /// without them. They act on the motion as constant forces.
    fn solve_contacts(&mut self, h: f64) {
        self.aim_contacts(h);
        let pull = if self.settings.stabilization == Stabilization::Baumgarte {
            self.settings.baumgarte / h
        } else {
            0.0
        };
        let hold = |row: &Row| {
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
        let system = (&self.joints, &self.articulation);
        self.loads.hold(&self.contacts, system, h);
        self.memory.store(&self.contacts, &self.bodies, h);
        self.note_contacts(h);
        self.note_drives(h);
        self.arrest(true, h);
        self.arrest(false, h);
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
        let rows = self.articulation.rows();
        self.joints
            .arrest(rows, &self.bodies, by_limit, &mut self.values);
        let before = self.kinetic_energy(h);
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
        let baumgarte = self.settings.stabilization == Stabilization::Baumgarte;
        let lead = self.settings.integrator.lead();
        self.gaps.clear();
        self.starts.clear();
        for c in &mut self.contacts {
            let u = c.velocity(&self.bodies);
            c.choose_friction(u, self.settings.slip_speed);
            let gap = c.gap + gap_change(&self.impacts.kinks, c);
            c.target = if gap > SLOP {
                closing_speed(gap, u.x, h, lead)
            } else if baumgarte && gap < 0.0 {
                -self.settings.baumgarte * gap / h
            } else {
                0.0
            };
            c.clear_impulse();
            self.starts.push(u);
            self.gaps.push(gap);
        }
        self.memory
            .recall(&mut self.contacts, &self.bodies, &self.match_radius, h);
    }

    /// Velocities after the solve, their work, and the gaps that they lead to.
    fn note_contacts(&mut self, h: f64) {
        let tolerance = 10.0 * self.settings.tolerance;
        let lead = self.settings.integrator.lead();
        for ((c, start), gap) in self
            .contacts
            .iter_mut()
            .zip(&self.starts)
            .zip(&mut self.gaps)
        {
            let u = self.solver.velocity(c);
            c.velocity_after = c.to_world(u);
            let mean = 0.5 * (*start + u);
            self.ledger
                .book(0.0, c.impulse.y * mean.y + c.impulse.z * mean.z);
            // A contact that aims at parting is Baumgarte's: its work takes back an overlap.
            if c.target > 0.0 {
                self.ledger.stabilization += c.impulse.x * mean.x;
            } else {
                self.ledger.book(c.impulse.x * mean.x, 0.0);
            }
            self.ledger.work_motors -= c.to_world(c.impulse).dot(c.driven(&self.bodies));
            if let Some(roll) = &c.roll {
                let turned = roll.to_world(roll.impulse);
                let mean = 0.5 * (c.turning(&self.bodies) + self.solver.turning(c));
                self.ledger.book(0.0, turned.dot(mean));
                let driven = c.driven_turning(&self.bodies);
                self.ledger.work_motors -= turned.dot(driven);
            }
            *gap += ((1.0 - lead) * start.x + lead * u.x) * h;
            let loaded = c.impulse.x > 0.0 || c.impact_impulse != DVec3::ZERO;
            c.sliding = loaded && length(u.y, u.z) > tolerance;
        }
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
            self.ledger.work_motors += work_of_fixed(&[drive.row], &[impulse], &self.bodies);
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

    /// The integrator's step, with contacts and drives as constant forces. Impacts inside the step had less than the
    /// whole step to act.
    fn move_bodies(&mut self, h: f64) {
        let time = self.time();
        if !self.paths.is_empty() {
            self.paths.arrive(&mut self.bodies, time);
            self.articulation.load_bilateral(&self.joints, &self.bodies);
            let rows = self.articulation.rows();
            self.loads.note_fixed(rows, &self.bodies);
        }
        let loads = &mut self.loads;
        loads.reactions.clear();
        let mut d = Dynamics {
            forces: &self.forces,
            joints: &self.joints,
            articulation: &mut self.articulation,
            paths: &self.paths,
            span: (time, h),
            held: &loads.held,
            beta: self.settings.baumgarte,
            baumgarte: self.settings.stabilization == Stabilization::Baumgarte,
            work: Powers::default(),
            stabilization: 0.0,
            reactions: &mut loads.reactions,
            scratch: &mut loads.scratch,
        };
        self.settings.integrator.advance(&mut self.bodies, &mut d);
        let (work, stabilization) = (d.work, d.stabilization);
        // Kicks add to the angular velocity; from the same momentum and pose it is to be the same, also after a resume.
        self.bodies.iter_mut().for_each(Body::derive);
        self.ledger.work_forces += work.forces;
        self.ledger.work_motors += work.motors;
        self.ledger.lost_damping -= work.damping;
        self.ledger.stabilization += stabilization;
        if !self.paths.is_empty() {
            let rows = self.articulation.rows();
            self.ledger.work_motors += self.loads.work_of_paths(rows, &self.bodies);
        }
        self.joints.values(&self.bodies, &mut self.values);
        for (body, kink) in self.bodies.iter_mut().zip(&self.impacts.kinks) {
            kink.straighten(body);
        }
        self.paths.arrive(&mut self.bodies, time + h);
    }

    /// Overlaps are taken back by moving bodies; joints then are put back as the integrator left them.
    fn correct_positions(&mut self) {
        if self.settings.stabilization == Stabilization::Baumgarte {
            return;
        }
        let before = self.potential().total();
        let beta = self.settings.baumgarte;
        let moved = self
            .correction
            .apply(&mut self.bodies, &self.contacts, &self.gaps, beta);
        if (moved || self.impacts.any) && !self.articulation.is_empty() {
            let scratch = &mut self.loads.scratch;
            self.articulation
                .restore(&self.joints, &mut self.bodies, &self.values, scratch);
        }
        if moved {
            self.ledger.stabilization += self.potential().total() - before;
        }
    }

    /// What counts turns has seen another step.
    fn observe(&mut self) {
        self.joints.observe(&self.bodies);
        if self.joints.can_break() {
            self.break_joints();
        }
        self.forces.observe(&self.bodies);
        self.paths.observe(self.time());
    }

    /// Joints that carry more than they bear let go. What their springs held is lost.
    fn break_joints(&mut self) {
        let loads = self.joint_loads();
        let before = self.joints.spring_energy(&self.bodies);
        self.joints.break_overloaded(&loads);
        self.ledger.lost_impact += before - self.joints.spring_energy(&self.bodies);
    }

    /// Has anything blown up? Does everything rest?
    fn watch(&mut self) -> Result<(), Failure> {
        let mut resting = true;
        for (index, body) in self
            .bodies
            .iter()
            .enumerate()
            .filter(|(_, b)| !b.is_fixed())
        {
            let speed = body.state.velocity.length();
            let spin = body.angular_velocity.length();
            if !(speed < SPEED_LIMIT && body.state.position.is_finite() && spin.is_finite()) {
                return Err(Failure::Diverged {
                    body: index,
                    time: self.time(),
                });
            }
            resting &= speed + spin * body.reach.max(1e-3) < REST_SPEED;
        }
        self.resting_steps = if resting { self.resting_steps + 1 } else { 0 };
        Ok(())
    }

    /// Contact points nearer than `margin` in the present state, without stepping.
    ///
    /// # Errors
    /// The oracle's.
    pub fn detect(
        &mut self,
        margin: f64,
        oracle: &mut dyn Oracle,
    ) -> Result<Vec<Contact>, Failure> {
        self.find_candidates(&vec![margin; self.bodies.len()]);
        let jobs: Vec<Job> = self
            .candidates
            .iter()
            .map(|&pair| self.job(pair, margin))
            .collect();
        self.detector
            .run(&self.geoms, &jobs, self.settings.fcl_only, oracle)
            .map_err(Failure::Oracle)?;
        let contact = |found: &crate::collide::Found| {
            let (i, j) = jobs[found.job as usize].geoms;
            let (a, b) = (&self.geoms[i as usize], &self.geoms[j as usize]);
            let centres = (
                self.bodies[a.body].state.position,
                self.bodies[b.body].state.position,
            );
            let coefficients = self.pairs.get(a.material, b.material);
            Contact::new(
                (i, j),
                (a, b),
                &self.bodies,
                centres,
                coefficients,
                &found.point,
            )
        };
        Ok(self.detector.found.iter().map(contact).collect())
    }

    /// True when a pair of shapes that may meet has no kernel here.
    #[must_use]
    pub fn needs_oracle(&self) -> bool {
        let asks = |a: &Geom, b: &Geom| {
            self.settings.fcl_only || !crate::narrowphase::has_kernel(&a.shape, &b.shape)
        };
        let movable = |k: usize| !self.bodies[k].is_fixed();
        // Two of a kind stand for all of that kind: scenes have many geoms and few kinds.
        let mut chosen: Vec<u32> = Vec::new();
        for (index, geom) in (0u32..).zip(&self.geoms) {
            let alike = |k: &&u32| {
                let other = &self.geoms[**k as usize];
                discriminant(&other.shape) == discriminant(&geom.shape)
                    && movable(other.body) == movable(geom.body)
                    && other.body != geom.body
            };
            if chosen.iter().filter(alike).count() < 2 {
                chosen.push(index);
            }
        }
        chosen.iter().enumerate().any(|(n, &i)| {
            chosen[n + 1..].iter().any(|&j| {
                asks(&self.geoms[i as usize], &self.geoms[j as usize])
                    && self.broadphase.may_touch(&self.geoms, i, j, &movable)
            })
        })
    }

    fn potential(&self) -> Potential {
        let mut potential = self.forces.potential(&self.bodies);
        potential.spring += self.joints.spring_energy(&self.bodies);
        potential
    }

    /// Energies now, and the books so far.
    #[must_use]
    pub fn energies(&self) -> Energies {
        let mut out = Energies {
            potential: self.potential(),
            ledger: self.ledger,
            ..Energies::default()
        };
        for body in self.bodies.iter().filter(|b| !b.is_fixed()) {
            let (translational, rotational) = body.kinetic_energy();
            out.kinetic_translational += translational;
            out.kinetic_rotational += rotational;
        }
        out
    }

    /// [s] since the start: the number of steps times the timestep.
    #[must_use]
    pub fn time(&self) -> f64 {
        #[allow(clippy::cast_precision_loss)]
        let steps = self.step as f64;
        steps * self.settings.timestep + self.passed
    }

    /// Steps made.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.step
    }

    /// For how long every body has rested [s].
    #[must_use]
    pub fn rest_time(&self) -> f64 {
        #[allow(clippy::cast_precision_loss)]
        let steps = self.resting_steps as f64;
        steps * self.settings.timestep
    }

    /// All bodies of the scene.
    #[must_use]
    pub fn bodies(&self) -> &[Body] {
        &self.bodies[..self.bodies.len() - 1]
    }

    /// The same, and the world behind them.
    #[must_use]
    pub fn all_bodies(&self) -> &[Body] {
        &self.bodies
    }

    /// Steps in which located impacts were more than a step may have.
    #[must_use]
    pub fn fallbacks(&self) -> u64 {
        self.fallbacks
    }

    /// All joints.
    #[must_use]
    pub fn joints(&self) -> &Joints {
        &self.joints
    }

    /// Of every spring: length and tension, or angle and torque.
    pub fn springs(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        self.forces.readings(&self.bodies)
    }

    /// Of every joint, stops included, at this instant: force [N] and torque [N m] about its anchor, on body A.
    pub fn joint_loads(&mut self) -> Vec<(DVec3, DVec3)> {
        let time = self.time();
        let system = (&self.forces, &self.joints, &mut self.articulation);
        self.loads.solve_reactions(&self.bodies, system, time);
        let drives = self.articulation.drives();
        let rows = self.articulation.rows();
        let impacts = &self.impacts.joint_impulses;
        let impulses = self.articulation.impulses().iter().enumerate();
        // Like forces of contacts, an impact counts as a mean over its step.
        let forces: Vec<f64> = impulses
            .map(|(k, &x)| x + impacts.get(k).unwrap_or(&0.0) / self.settings.timestep)
            .collect();
        let one = |j: usize| {
            let own = self.joints.rows_of(j);
            let held = self
                .joints
                .reaction(j, &rows[own.clone()], &forces[own], &self.bodies);
            let pulled = self.joints.pull_on(j, &self.bodies, time);
            let mut load = (held.0 + pulled.0, held.1 + pulled.1);
            let forces = drives.iter().zip(&self.loads.drive_forces);
            for (drive, &force) in forces.filter(|(d, _)| d.joint == j) {
                let (f, t) = self
                    .joints
                    .reaction(j, &[drive.row], &[force], &self.bodies);
                load = (load.0 + f, load.1 + t);
            }
            load
        };
        (0..self.joints.len()).map(one).collect()
    }

    /// All geoms.
    #[must_use]
    pub fn geoms(&self) -> &[Geom] {
        &self.geoms
    }

    /// Contacts of the last step.
    #[must_use]
    pub fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// What the contact solve of the last step came to.
    #[must_use]
    pub fn report(&self) -> Report {
        self.report
    }

    /// Impacts since the last call.
    pub fn take_events(&mut self) -> Vec<Event> {
        std::mem::take(&mut self.impacts.events)
    }

    /// Everything that the next step depends on.
    ///
    /// # Errors
    /// When it cannot be written; does not happen with memory to spare.
    pub fn save(&self) -> Result<Vec<u8>, String> {
        let snapshot = Snapshot {
            step: self.step,
            resting_steps: self.resting_steps,
            fallbacks: self.fallbacks,
            states: self.bodies.iter().map(|b| b.state).collect(),
            memory: self.memory.clone(),
            noise: self.noise.clone(),
            ledger: self.ledger,
            events: self.impacts.events.clone(),
            joints: self.joints.state().clone(),
            holds: self.articulation.kept_holds().to_vec(),
            turns: self.forces.turns(),
        };
        postcard::to_stdvec(&snapshot).map_err(|e| e.to_string())
    }

    /// Go on from where `save` was called, in a world of the same model.
    ///
    /// # Errors
    /// When the bytes are not such a checkpoint.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), String> {
        let snapshot: Snapshot = postcard::from_bytes(bytes).map_err(|e| e.to_string())?;
        if snapshot.states.len() != self.bodies.len() || snapshot.noise.len() != self.bodies.len() {
            return Err("the checkpoint is of another number of bodies".into());
        }
        self.articulation.set_kept_holds(snapshot.holds)?;
        self.joints.set_state(snapshot.joints)?;
        if !self.forces.set_turns(&snapshot.turns) {
            return Err("the checkpoint is of other springs".into());
        }
        for (body, state) in self.bodies.iter_mut().zip(&snapshot.states) {
            body.state = *state;
            body.derive();
        }
        self.step = snapshot.step;
        let time = self.time();
        self.paths.arrive(&mut self.bodies, time);
        self.resting_steps = snapshot.resting_steps;
        self.fallbacks = snapshot.fallbacks;
        self.memory = snapshot.memory;
        self.noise = snapshot.noise;
        self.ledger = snapshot.ledger;
        self.impacts.events = snapshot.events;
        self.contacts.clear();
        Ok(())
    }
}

/// Bodies at their starts, and the world behind them.
fn place_bodies(model: &Model) -> Vec<Body> {
    let mut bodies: Vec<Body> = Vec::with_capacity(model.bodies.len() + 1);
    for (mass, state, omega) in &model.bodies {
        let mut body = Body::new(mass.clone(), *state);
        body.set_angular_velocity(*omega);
        bodies.push(body);
    }
    bodies.push(Body::new(MassProperties::fixed(), State::default()));
    for geom in &model.geoms {
        let reach = geom.position.length() + geom.shape.bounding_radius();
        let body = &mut bodies[geom.body];
        body.reach = body.reach.max(reach);
    }
    for (body, &velocity) in bodies.iter_mut().zip(&model.surface_velocities) {
        body.surface_velocity = velocity;
    }
    bodies
}

/// The normal velocity at the end of a step of `h` that just closes a gap, from the velocity `start` at its beginning:
/// gap + ((1 - lead) start + lead end) h = 0. A contact never asks for more than parting with no speed.
fn closing_speed(gap: f64, start: f64, h: f64, lead: f64) -> f64 {
    if lead == 0.0 {
        return -gap / h; // this step's displacement is settled; the next one is to close the gap at most
    }
    ((-gap / h - (1.0 - lead) * start) / lead).min(0.0)
}
