//! What the world hands out: energies, loads of joints, contacts of the present state.

use glam::DVec3;

use crate::body::Body;
use crate::collide::{Job, Oracle};
use crate::contact::{Contact, Meeting};
use crate::force::Potential;
use crate::impact::Event;
use crate::joint::Joints;
use crate::ledger::Energies;
use crate::model::Geom;
use crate::solver::Report;

use super::{Failure, World};

impl World {
    /// Contact points nearer than `margin` in the present state, without stepping.
    ///
    /// # Errors
    /// The oracle's.
    pub fn detect(
        &mut self,
        margin: f64,
        oracle: &mut dyn Oracle,
    ) -> Result<Vec<Contact>, Failure> {
        self.travels.clear();
        self.travels.resize(self.bodies.len(), margin);
        self.find_candidates();
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
            Meeting::new((i, j), (a, b), &self.bodies, centres, coefficients).contact(&found.point)
        };
        Ok(self.detector.found().map(contact).collect())
    }

    /// Whether contacts are asked of an oracle.
    #[must_use]
    pub fn needs_oracle(&self) -> bool {
        self.settings.fcl_only
    }

    pub(super) fn potential(&self) -> Potential {
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

    /// Linear momentum, sum of m v, and angular momentum about the world's origin, sum of m x cross v + L, of all that moves
    /// [kg m/s, kg m^2/s].
    #[must_use]
    pub fn momentum(&self) -> (DVec3, DVec3) {
        let mut out = (DVec3::ZERO, DVec3::ZERO);
        for body in self.bodies.iter().filter(|b| !b.is_fixed()) {
            let p = body.mass.mass * body.state.velocity;
            out.0 += p;
            out.1 += body.state.position.cross(p) + body.state.angular_momentum;
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
        self.loads
            .solve_reactions(&self.bodies, system, (&self.paths, time));
        let drives = self.articulation.drives();
        let articulation = &self.articulation;
        let impacts = &self.impacts.joint_impulses;
        let impulses = self.articulation.impulses().iter().enumerate();
        // Like forces of contacts, an impact counts as a mean over its step.
        let forces: Vec<f64> = impulses
            .map(|(k, &x)| x + impacts.get(k).unwrap_or(&0.0) / self.settings.timestep)
            .collect();
        let one = |j: usize| {
            let rows = self.joints.rows_of(j);
            let pushes = rows.flat_map(|r| articulation.ends(r).map(move |end| (end, r)));
            let pushes = pushes.map(|(end, r)| (end, forces[r]));
            let held = self.joints.reaction(j, pushes, &self.bodies);
            let pulled = self.joints.pull_on(j, &self.bodies, time);
            let mut load = (held.0 + pulled.0, held.1 + pulled.1);
            let forces = drives.iter().zip(&self.loads.drive_forces);
            for (drive, &force) in forces.filter(|(d, _)| d.joint == j) {
                let pushes = drive.row.ends.map(|end| (end, force));
                let (f, t) = self.joints.reaction(j, pushes.into_iter(), &self.bodies);
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

    /// Materials of A and B.
    #[must_use]
    pub fn materials_of(&self, c: &Contact) -> (usize, usize) {
        let material = |k: u32| self.geoms[k as usize].material;
        (material(c.geoms.0), material(c.geoms.1))
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
}
