//! The world and its step.

use std::mem::discriminant;

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::approach::{near_margin, Approach, StepStart};
use crate::body::{Body, State};
use crate::broadphase::Broadphase;
use crate::collide::{Detector, Job, Oracle};
use crate::contact::{relative_velocity, Contact, Memory};
use crate::impact::{gap_change, Event, Impacts, Rules};
use crate::integrator::{drift, kick};
use crate::ledger::{Energies, Ledger};
use crate::math::length;
use crate::model::{Geom, Model, PairTable, Settings, Stabilization};
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
    settings: Settings,
    geoms: Vec<Geom>,
    pairs: PairTable,
    bodies: Vec<Body>,
    accelerations: Vec<DVec3>,
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
    boxes: Vec<Aabb>,
    candidates: Vec<(u32, u32)>,
    jobs: Vec<Job>,
    starts: Vec<DVec3>,
    gaps: Vec<f64>,
    every: Vec<usize>,
    match_radius: Vec<f64>,
    noise: Vec<f64>,
}

/// What a checkpoint holds: all that the next step depends on.
#[derive(Serialize, Deserialize)]
struct Snapshot {
    step: u64,
    resting_steps: u64,
    states: Vec<State>,
    memory: Memory,
    noise: Vec<f64>,
    ledger: Ledger,
    events: Vec<Event>,
}

impl World {
    /// Build the world at its start.
    #[must_use]
    pub fn new(model: Model) -> Self {
        let mut bodies: Vec<Body> = model
            .bodies
            .into_iter()
            .map(|(mass, state, omega)| {
                let mut body = Body::new(mass, state);
                body.set_angular_velocity(omega);
                body
            })
            .collect();
        for geom in &model.geoms {
            let reach = geom.position.length() + geom.shape.bounding_radius();
            let body = &mut bodies[geom.body];
            body.reach = body.reach.max(reach);
        }
        let mut world = Self {
            broadphase: Broadphase::new(&model.geoms, &model.no_contact),
            accelerations: vec![DVec3::ZERO; bodies.len()],
            noise: vec![0.0; bodies.len()],
            match_radius: model
                .geoms
                .iter()
                .map(|g| 0.2 * g.shape.bounding_radius())
                .collect(),
            settings: model.settings,
            geoms: model.geoms,
            pairs: model.pairs,
            bodies,
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
            boxes: Vec::new(),
            candidates: Vec::new(),
            jobs: Vec::new(),
            starts: Vec::new(),
            gaps: Vec::new(),
            every: Vec::new(),
        };
        world.ledger.initial = world.energies().total();
        world
    }

    /// One step of the timestep.
    ///
    /// # Errors
    /// [`Failure`]; the state is then that of the failed step.
    pub fn step(&mut self, oracle: &mut dyn Oracle) -> Result<(), Failure> {
        self.evaluate_forces();
        self.collide(oracle)?;
        self.resolve_impacts();
        self.apply_forces();
        self.solve_contacts();
        self.move_bodies();
        self.correct_positions();
        self.step += 1;
        self.watch()
    }

    /// Accelerations of free bodies.
    fn evaluate_forces(&mut self) {
        for (a, body) in self.accelerations.iter_mut().zip(&self.bodies) {
            *a = if body.is_fixed() {
                DVec3::ZERO
            } else {
                self.settings.gravity
            };
        }
    }

    /// Contacts of this step: points that are nearly touching, and points that will touch before the step ends, at
    /// the instant of touching.
    fn collide(&mut self, oracle: &mut dyn Oracle) -> Result<(), Failure> {
        let dt = self.settings.timestep;
        let travel = |b: &Body, a: DVec3| {
            if b.is_fixed() {
                return 0.0;
            }
            dt * (b.state.velocity.length()
                + a.length() * dt
                + b.angular_velocity.length() * b.reach)
        };
        let travels: Vec<f64> = self
            .bodies
            .iter()
            .zip(&self.accelerations)
            .map(|(b, &a)| travel(b, a))
            .collect();
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
            accelerations: &self.accelerations,
            noise: &self.noise,
            rules: self.rules(),
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

    fn rules(&self) -> Rules {
        Rules {
            timestep: self.settings.timestep,
            time: self.time(),
            bounce_speed: self.settings.bounce_speed,
            tolerance: self.settings.tolerance,
            slip_speed: self.settings.slip_speed,
            iterations: self.settings.iterations,
        }
    }

    fn resolve_impacts(&mut self) {
        let rules = self.rules();
        self.impacts.resolve(
            &mut self.bodies,
            &self.accelerations,
            &mut self.contacts,
            &rules,
        );
        self.ledger.book(self.impacts.work.0, self.impacts.work.1);
    }

    /// v += a dt, after noting how the contacts move before that.
    fn apply_forces(&mut self) {
        self.starts.clear();
        for c in &mut self.contacts {
            let u = c.velocity(&self.bodies);
            c.choose_friction(u, self.settings.slip_speed);
            self.starts.push(u);
        }
        for (body, &a) in self.bodies.iter_mut().zip(&self.accelerations) {
            kick(body, a, self.settings.timestep);
        }
    }

    /// Impulses that keep bodies apart and rub them, all contacts together.
    fn solve_contacts(&mut self) {
        let dt = self.settings.timestep;
        let baumgarte = self.settings.stabilization == Stabilization::Baumgarte;
        let beta = if baumgarte {
            self.settings.baumgarte
        } else {
            0.0
        };
        self.gaps.clear();
        for c in &mut self.contacts {
            let gap = c.gap + gap_change(&self.impacts.kinks, c);
            c.target = if gap > 0.0 {
                if gap > SLOP {
                    -gap / dt
                } else {
                    0.0
                }
            } else {
                -beta * gap / dt
            };
            c.impulse = DVec3::ZERO;
            self.gaps.push(gap);
        }
        self.memory
            .recall(&mut self.contacts, &self.bodies, &self.match_radius);
        self.every.clear();
        self.every.extend(0..self.contacts.len());
        let limits = Limits {
            iterations: self.settings.iterations,
            tolerance: self.settings.tolerance,
        };
        self.report = self
            .solver
            .solve(&self.bodies, &mut self.contacts, &self.every, limits);
        let tolerance = self.settings.tolerance;
        for (noise, &residual) in self.noise.iter_mut().zip(self.solver.residuals()) {
            *noise = if residual < tolerance {
                0.0
            } else {
                NOISE * residual
            };
        }
        for c in &self.contacts {
            c.apply(&mut self.bodies, c.impulse);
        }
        self.memory.store(&self.contacts, &self.bodies);
        self.note_contacts();
    }

    /// Velocities after the solve, their work, and the gaps that they lead to.
    fn note_contacts(&mut self) {
        let tolerance = 10.0 * self.settings.tolerance;
        for ((c, start), gap) in self
            .contacts
            .iter_mut()
            .zip(&self.starts)
            .zip(&mut self.gaps)
        {
            c.velocity_after = relative_velocity(&self.bodies, c.bodies, c.arms);
            let u = c.to_local(c.velocity_after);
            let mean = 0.5 * (*start + u);
            self.ledger
                .book(0.0, c.impulse.y * mean.y + c.impulse.z * mean.z);
            // A contact that aims at parting is Baumgarte's: its work takes back an overlap.
            if c.target > 0.0 {
                self.ledger.stabilization += c.impulse.x * mean.x;
            } else {
                self.ledger.book(c.impulse.x * mean.x, 0.0);
            }
            *gap += u.x * self.settings.timestep;
            let loaded = c.impulse.x > 0.0 || c.impact_impulse != DVec3::ZERO;
            c.sliding = loaded && length(u.y, u.z) > tolerance;
        }
    }

    /// x += v dt, and the rotation that goes with it; impacts inside the step had less than the whole step to act.
    fn move_bodies(&mut self) {
        let moving = self.bodies.iter_mut().zip(&self.impacts.kinks);
        for (body, kink) in moving.filter(|(b, _)| !b.is_fixed()) {
            drift(body, self.settings.timestep);
            body.state.position += kink.shift;
            if kink.turn != DVec3::ZERO {
                body.state.orientation =
                    crate::math::rotation_from_vector(kink.turn) * body.state.orientation;
                body.refresh();
            }
        }
    }

    fn correct_positions(&mut self) {
        if self.settings.stabilization == Stabilization::Baumgarte {
            return;
        }
        let before = self.gravitational();
        let beta = self.settings.baumgarte;
        if self
            .correction
            .apply(&mut self.bodies, &self.contacts, &self.gaps, beta)
        {
            self.ledger.stabilization += self.gravitational() - before;
        }
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

    fn gravitational(&self) -> f64 {
        let weight = |b: &Body| -b.mass.mass * self.settings.gravity.dot(b.state.position);
        self.bodies
            .iter()
            .filter(|b| !b.is_fixed())
            .map(weight)
            .sum()
    }

    /// Energies now, and the books so far.
    #[must_use]
    pub fn energies(&self) -> Energies {
        let mut out = Energies {
            gravitational: self.gravitational(),
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
        steps * self.settings.timestep
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

    /// All bodies.
    #[must_use]
    pub fn bodies(&self) -> &[Body] {
        &self.bodies
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
            states: self.bodies.iter().map(|b| b.state).collect(),
            memory: self.memory.clone(),
            noise: self.noise.clone(),
            ledger: self.ledger,
            events: self.impacts.events.clone(),
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
        for (body, state) in self.bodies.iter_mut().zip(&snapshot.states) {
            body.state = *state;
            body.derive();
        }
        self.step = snapshot.step;
        self.resting_steps = snapshot.resting_steps;
        self.memory = snapshot.memory;
        self.noise = snapshot.noise;
        self.ledger = snapshot.ledger;
        self.impacts.events = snapshot.events;
        self.contacts.clear();
        Ok(())
    }
}
