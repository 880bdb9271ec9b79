//! Checkpoints: everything that the next step depends on, as bytes.

use serde::{Deserialize, Serialize};

use crate::articulation::Hold;
use crate::body::State;
use crate::contact::Memory;
use crate::impact::Event;
use crate::joint::JointState;
use crate::ledger::Ledger;

use super::World;

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
