//! The world and its step.

mod aim;
mod contacts;
pub mod frames;
mod located;
mod readings;
mod snapshot;

use std::ops::Range;

use glam::DVec3;

use crate::approach::{near_margin, Approach, StepStart};
use crate::articulation::Articulation;
use crate::body::{Body, MassProperties, State};
use crate::broadphase::{Broadphase, Places};
use crate::collide::{Detector, Job, Oracle};
use crate::contact::{Contact, Memory};
use crate::force::{Forces, Powers};
use crate::impact::{Impacts, Rules, Scene};
use crate::integrator::Dynamics;
use crate::joint::{Ahead, Joints};
use crate::ledger::Ledger;
use crate::loads::Loads;
use crate::model::{Geom, Model, PairTable, Settings, Stabilization};
use crate::mover::Twist;
use crate::paths::Paths;
use crate::position::Correction;
use crate::shape::{Aabb, Pose};
use crate::solver::{Report, Solver};
use crate::team::{awake, each, each_with, fill, gather, Team};

/// Speeds above this are a blow-up, not physics [m/s].
const SPEED_LIMIT: f64 = 1e8;
/// A body slower than this, in its fastest point, rests [m/s].
const REST_SPEED: f64 = 1e-3;

/// A contact that keeps less than this part of its K among the joints is held by them. With a hundredth of that a chain
/// that folds up gains more energy than it had.
const RIGID: f64 = 1e-2;

/// Worlds of fewer bodies are stepped by the thread that asks.
const FEW: usize = 100;
/// Bodies that are watched at a time.
const WATCHED: usize = 1024;

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
    settings: Settings,
    geoms: Vec<Geom>,
    pairs: PairTable,
    /// Those of the scene, and the world itself as the last.
    bodies: Vec<Body>,
    forces: Forces,
    joints: Joints,
    articulation: Articulation,
    paths: Paths,
    loads: Loads,
    contacts: Vec<Contact>,
    memory: Memory,
    broadphase: Broadphase,
    detector: Detector,
    approach: Approach,
    impacts: Impacts,
    solver: Solver,
    correction: Correction,
    ledger: Ledger,
    report: Report,
    step: u64,
    resting_steps: u64,
    fallbacks: u64,
    /// Of each body: how far its geometry may get in the step [m].
    travels: Vec<f64>,
    /// Of each geom.
    poses: Vec<Pose>,
    boxes: Vec<Aabb>,
    candidates: Vec<(u32, u32)>,
    jobs: Vec<Job>,
    starts: Vec<DVec3>,
    gaps: Vec<f64>,
    every: Vec<usize>,
    match_radius: Vec<f64>,
    noise: Vec<f64>,
    /// Of the joints' rows as the integrator left them.
    values: Vec<f64>,
    /// Part of the step that is already made [s].
    passed: f64,
    team: Team,
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
            travels: Vec::new(),
            poses: Vec::new(),
            boxes: Vec::new(),
            candidates: Vec::new(),
            jobs: Vec::new(),
            starts: Vec::new(),
            gaps: Vec::new(),
            every: Vec::new(),
            values: Vec::new(),
            passed: 0.0,
            team: Team::new(1),
        };
        world.paths.arrive(&mut world.bodies, 0.0);
        world.ledger.initial = world.energies().total();
        world
    }

    /// Step on so many threads from now on, at least one. Results are the same for every number.
    pub fn set_threads(&mut self, threads: usize) {
        self.team = Team::new(threads);
    }

    /// Do `work`, such as many steps, on the threads of this world: cheaper than gathering them for every step.
    pub fn together<T: Send>(&mut self, work: impl FnOnce(&mut Self) -> T + Send) -> T {
        if self.bodies.len() < FEW {
            return work(self);
        }
        match self.team.pool() {
            Some(pool) => pool.install(|| work(self)),
            None => work(self),
        }
    }

    /// One step of the timestep.
    ///
    /// # Errors
    /// [`Failure`]; the state is then that of the failed step.
    pub fn step(&mut self, oracle: &mut dyn Oracle) -> Result<(), Failure> {
        self.together(|world| awake(|| world.make_step(oracle)))
    }

    fn make_step(&mut self, oracle: &mut dyn Oracle) -> Result<(), Failure> {
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
    fn advance(&mut self, h: f64, oracle: &mut dyn Oracle) -> Result<(), Failure> {
        if self.survey(h, oracle)? {
            self.resolve_impacts(&self.rules(h));
        }
        self.finish(h);
        Ok(())
    }

    /// What acts on bodies, and what touches or will touch within `h`. Returns whether anything may be hit.
    fn survey(&mut self, h: f64, oracle: &mut dyn Oracle) -> Result<bool, Failure> {
        self.impacts.begin_part(self.bodies.len());
        self.evaluate_forces(h);
        let hits = self.collide(h, oracle)?;
        self.soften_rigid_contacts();
        Ok(hits)
    }

    /// Contacts and joints, then the motion, then what it left of overlaps.
    fn finish(&mut self, h: f64) {
        self.solve_contacts(h);
        self.move_bodies(h);
        self.correct_positions();
    }

    /// Accelerations of bodies, as their joints allow them, and what drives and limits of joints ask for.
    fn evaluate_forces(&mut self, h: f64) {
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
    /// the instant of touching. Returns whether any may be hit.
    fn collide(&mut self, h: f64, oracle: &mut dyn Oracle) -> Result<bool, Failure> {
        self.foresee_travels(h);
        self.find_candidates();
        self.list_jobs();
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

    /// A contact within one mechanism whose joints leave its gap no freedom (links folded back onto a line) could only
    /// strain against them, with a force beyond measure. It gives way a little instead.
    fn soften_rigid_contacts(&mut self) {
        if self.articulation.is_empty() {
            return;
        }
        for c in &mut self.contacts {
            let home = self.articulation.home(c.bodies.0);
            let within = home.filter(|_| home == self.articulation.home(c.bodies.1));
            if let Some(assembly) = within {
                let give = RIGID * c.k_normal;
                if self.articulation.mobility(assembly, c, &self.bodies) < give {
                    c.give = give;
                }
            }
        }
    }

    /// How far the geometry of each body may get within `h`.
    fn foresee_travels(&mut self, h: f64) {
        let travel = |(b, a): (&Body, &Twist)| {
            let spin = b.angular_velocity.length() + a.angular_velocity.length() * h;
            // A half-space reaches infinitely far, but most stand still.
            let swept = if spin > 0.0 { spin * b.reach } else { 0.0 };
            h * (b.state.velocity.length() + a.velocity.length() * h + swept)
        };
        let (bodies, accelerations) = (&self.bodies, &self.loads.accelerations);
        fill(&mut self.travels, (bodies.len(), 0.0), &|k| {
            travel((&bodies[k], &accelerations[k]))
        });
    }

    /// Pairs of geoms whose boxes, grown by what the bodies may travel in a step, overlap.
    fn find_candidates(&mut self) {
        let (geoms, bodies, travels) = (&self.geoms, &self.bodies, &self.travels);
        fill(&mut self.poses, (geoms.len(), Pose::IDENTITY), &|k| {
            geoms[k].pose(&bodies[geoms[k].body].pose())
        });
        let poses = &self.poses;
        fill(&mut self.boxes, (geoms.len(), Aabb::EMPTY), &|k| {
            let geom = &geoms[k];
            let grown = travels[geom.body] + near_margin(geom, geom);
            geom.shape.aabb(&poses[k]).expanded(grown)
        });
        let places = Places {
            geoms: &self.geoms,
            poses: &self.poses,
            boxes: &self.boxes,
            travels: &self.travels,
        };
        let bodies = &self.bodies;
        self.broadphase
            .pairs(&places, |k| !bodies[k].is_fixed(), &mut self.candidates);
    }

    fn list_jobs(&mut self) {
        let (geoms, poses, travels) = (&self.geoms, &self.poses, &self.travels);
        let candidates = &self.candidates;
        fill(&mut self.jobs, (candidates.len(), Job::NONE), &|k| {
            let (i, j) = candidates[k];
            let (a, b) = (&geoms[i as usize], &geoms[j as usize]);
            Job {
                geoms: (i, j),
                poses: (poses[i as usize], poses[j as usize]),
                margin: near_margin(a, b) + travels[a.body] + travels[b.body],
            }
        });
    }

    /// Two geoms where their bodies are now.
    fn job(&self, geoms: (u32, u32), margin: f64) -> Job {
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

    fn rules(&self, h: f64) -> Rules {
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

    fn resolve_impacts(&mut self, rules: &Rules) {
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

    /// The integrator's step, with contacts and drives as constant forces. Impacts inside the step had less than the
    /// whole step to act.
    fn move_bodies(&mut self, h: f64) {
        let time = self.time();
        if !self.paths.is_empty() {
            self.paths.arrive(&mut self.bodies, time);
            self.articulation.load_bilateral(&self.joints, &self.bodies);
            self.loads.note_fixed(&self.articulation, &self.bodies);
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
            closed: true,
            tensions: &loads.tensions,
            swing: 0.0,
            pulls: &loads.wrenches,
            reactions: &mut loads.reactions,
            scratch: &mut loads.scratch,
        };
        self.settings.integrator.advance(&mut self.bodies, &mut d);
        let (work, stabilization) = (d.work, d.stabilization);
        // Kicks add to the angular velocity; from the same momentum and pose it is to be the same, also after a resume.
        if self.settings.integrator.ends_with_kick() || !self.articulation.is_empty() {
            each(&mut self.bodies, &Body::respin);
        }
        self.ledger.work_forces += work.forces;
        self.ledger.work_motors += work.motors;
        self.ledger.lost_damping -= work.damping;
        self.ledger.stabilization += stabilization;
        if !self.paths.is_empty() {
            let work = self.loads.work_of_paths(&self.articulation, &self.bodies);
            self.ledger.work_motors += work;
        }
        if self.impacts.any || !self.contacts.is_empty() {
            self.joints.values(&self.bodies, &mut self.values);
        }
        if self.impacts.any {
            each_with(&mut self.bodies, &self.impacts.kinks, &|body, kink| {
                kink.straighten(body);
            });
        }
        self.paths.arrive(&mut self.bodies, time + h);
    }

    /// Overlaps are taken back by moving bodies; joints then are put back as the integrator left them.
    fn correct_positions(&mut self) {
        let baumgarte = self.settings.stabilization == Stabilization::Baumgarte;
        if baumgarte || (self.contacts.is_empty() && !self.impacts.any) {
            return;
        }
        let before = Correction::is_due(&self.gaps).then(|| self.potential().total());
        if before.is_some() {
            let beta = self.settings.baumgarte;
            self.correction
                .apply(&mut self.bodies, &self.contacts, &self.gaps, beta);
        }
        if (before.is_some() || self.impacts.any) && !self.articulation.is_empty() {
            let scratch = &mut self.loads.scratch;
            self.articulation
                .restore(&self.joints, &mut self.bodies, &self.values, scratch);
        }
        if let Some(before) = before {
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
        let time = self.time();
        let all = (&self.bodies[..], 0..self.bodies.len());
        let resting = gather(all, WATCHED, &|part| is_resting(part), &|a, b| Ok(a? && b?))
            .map_err(|body| Failure::Diverged { body, time })?;
        self.resting_steps = if resting { self.resting_steps + 1 } else { 0 };
        Ok(())
    }
}

/// Do all of these bodies rest? The first that blew up, else.
fn is_resting((bodies, indices): (&[Body], Range<usize>)) -> Result<bool, usize> {
    let mut resting = true;
    for (body, index) in bodies.iter().zip(indices).filter(|(b, _)| !b.is_fixed()) {
        let speed = body.state.velocity.length();
        let spin = body.angular_velocity.length();
        if !(speed < SPEED_LIMIT && body.state.position.is_finite() && spin.is_finite()) {
            return Err(index);
        }
        resting &= speed + spin * body.reach.max(1e-3) < REST_SPEED;
    }
    Ok(resting)
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
