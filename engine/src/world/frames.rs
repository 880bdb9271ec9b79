//! Readings of frames that follow each other, as columns of plain numbers.
//!
//! They are taken between two steps, while the state is in cache and nobody waits for them.

use glam::{DQuat, DVec3};

use crate::body::Body;
use crate::contact::Contact;
use crate::impact::Event;
use crate::ledger::Energies;

use super::World;

/// Contacts that are read column by column while they are in the nearest cache.
const AT_ONCE: usize = 32;

/// What of a world is kept.
#[derive(Clone, Debug, Default)]
pub struct Choice {
    /// These bodies; all of them when `None`.
    pub bodies: Option<Vec<usize>>,
    /// Linear and angular momentum of all that moves.
    pub momentum: bool,
    /// Energies and their books.
    pub energy: bool,
    /// Contact points.
    pub contacts: bool,
    /// So many joints, from the first on.
    pub joints: usize,
    /// Springs.
    pub springs: bool,
}

/// When frames are due, in steps since the start.
#[derive(Clone, Copy, Debug)]
pub struct Plan {
    /// At multiples of this, at least 1.
    pub every: u64,
    /// And at the last step of the run.
    pub last: u64,
    /// Nothing follows on a frame in which all has rested for this long [s].
    pub rest_time: f64,
}

impl Plan {
    /// Whether a step has a frame.
    #[must_use]
    pub fn has_frame(&self, step: u64) -> bool {
        step % self.every == 0 || step == self.last
    }

    /// Keep the present state when it is due; false when the run is to go no further.
    pub fn keep(&self, world: &mut World, frames: &mut Frames) -> bool {
        let due = self.has_frame(world.steps());
        if due {
            frames.keep(world);
        }
        !(due && world.rest_time() >= self.rest_time)
    }
}

/// One frame of the world as a whole.
#[derive(Clone, Copy, Debug)]
pub struct Summary {
    /// Steps made.
    pub step: u64,
    /// Velocity error that the solve left [m/s].
    pub residual: f64,
    /// Sweeps of the solve.
    pub iterations: usize,
    /// Contact points of the last step.
    pub contacts: usize,
    /// Steps in which located impacts were given up.
    pub fallbacks: u64,
    /// Linear [kg m/s] and angular [kg m^2/s], where wanted.
    pub momentum: Option<(DVec3, DVec3)>,
    /// Where wanted.
    pub energies: Option<Energies>,
}

/// A row for each body and frame.
#[derive(Debug, Default)]
pub struct BodyRows {
    /// Of the centre of mass [m].
    pub position: Vec<[f64; 3]>,
    /// (w, x, y, z)
    pub orientation: Vec<[f64; 4]>,
    /// [m/s]
    pub velocity: Vec<[f64; 3]>,
    /// World axes [rad/s].
    pub angular_velocity: Vec<[f64; 3]>,
}

impl BodyRows {
    fn like(other: &Self) -> Self {
        let count = other.position.len();
        Self {
            position: Vec::with_capacity(count),
            orientation: Vec::with_capacity(count),
            velocity: Vec::with_capacity(count),
            angular_velocity: Vec::with_capacity(count),
        }
    }

    /// The state of one body.
    pub fn push(&mut self, body: &Body) {
        let q: DQuat = body.state.orientation;
        self.position.push(body.state.position.to_array());
        self.orientation.push([q.w, q.x, q.y, q.z]);
        self.velocity.push(body.state.velocity.to_array());
        self.angular_velocity.push(body.angular_velocity.to_array());
    }
}

/// A row for each contact point and frame.
#[derive(Debug, Default)]
pub struct ContactRows {
    /// Indices of bodies A.
    pub body_a: Vec<i32>,
    /// Indices of bodies B.
    pub body_b: Vec<i32>,
    /// [m]
    pub position: Vec<[f64; 3]>,
    /// From B to A.
    pub normal: Vec<[f64; 3]>,
    /// Of the overlap [m].
    pub depth: Vec<f64>,
    /// Of all impulses of the step, on A [N s].
    pub impulse: Vec<[f64; 3]>,
    /// Its part along the normal [N s].
    pub normal_impulse: Vec<f64>,
    /// Its part along the surface [N s].
    pub tangential_impulse: Vec<[f64; 3]>,
    /// The mean of the impulse over the step [N].
    pub force: Vec<[f64; 3]>,
    /// Before the step's impulses [m/s].
    pub velocity_before: Vec<[f64; 3]>,
    /// After them [m/s].
    pub velocity_after: Vec<[f64; 3]>,
    /// Row of the pair of materials, see [`pair_row`].
    pub pair: Vec<i32>,
    /// 1 where the surfaces slide.
    pub sliding: Vec<i8>,
}

impl ContactRows {
    fn like(other: &Self) -> Self {
        let mut rows = Self::default();
        rows.reserve(other.depth.len());
        rows
    }

    /// Room for more.
    fn reserve(&mut self, count: usize) {
        self.body_a.reserve(count);
        self.body_b.reserve(count);
        self.position.reserve(count);
        self.normal.reserve(count);
        self.depth.reserve(count);
        self.impulse.reserve(count);
        self.normal_impulse.reserve(count);
        self.tangential_impulse.reserve(count);
        self.force.reserve(count);
        self.velocity_before.reserve(count);
        self.velocity_after.reserve(count);
        self.pair.reserve(count);
        self.sliding.reserve(count);
    }

    /// Contacts of the last step of a world. On A: j = j_n n + j_t, F = j / dt.
    #[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap)]
    pub fn extend(&mut self, contacts: &[Contact], world: &World) {
        let (timestep, materials) = (world.settings.timestep, world.pairs.len());
        let pair = |c: &Contact| pair_row(world.materials_of(c), materials) as i32;
        let normal = |c: &Contact| c.impulse.x + c.impact_impulse.dot(c.normal);
        let whole = |c: &Contact| normal(c) * c.normal + c.tangential_impulse();
        self.reserve(contacts.len());
        for some in contacts.chunks(AT_ONCE) {
            let all = || some.iter();
            self.body_a.extend(all().map(|c| c.bodies.0 as i32));
            self.body_b.extend(all().map(|c| c.bodies.1 as i32));
            self.position.extend(all().map(|c| c.position.to_array()));
            self.normal.extend(all().map(|c| c.normal.to_array()));
            self.depth.extend(all().map(|c| -c.gap));
            self.impulse.extend(all().map(|c| whole(c).to_array()));
            self.normal_impulse.extend(all().map(normal));
            self.tangential_impulse
                .extend(all().map(|c| c.tangential_impulse().to_array()));
            self.force
                .extend(all().map(|c| (whole(c) / timestep).to_array()));
            self.velocity_before
                .extend(all().map(|c| c.velocity_before.to_array()));
            self.velocity_after
                .extend(all().map(|c| c.velocity_after.to_array()));
            self.pair.extend(all().map(pair));
            self.sliding.extend(all().map(|c| i8::from(c.sliding)));
        }
    }
}

/// The row of a pair among all of `count` materials, in the order (0, 0), (0, 1), ..., (1, 1), (1, 2), ...
fn pair_row((a, b): (usize, usize), count: usize) -> usize {
    let (first, second) = (a.min(b), a.max(b));
    first * (2 * count + 1 - first) / 2 + second - first
}

/// A row for each joint and frame.
#[derive(Debug, Default)]
pub struct JointRows {
    /// On body A [N].
    pub force: Vec<[f64; 3]>,
    /// On body A, about the anchor [N m].
    pub torque: Vec<[f64; 3]>,
    /// Up to three [m, rad]; not a number beyond those that a joint has.
    pub coordinates: [Vec<f64>; 3],
    /// Error of place [m].
    pub violation: Vec<f64>,
    /// Error of direction [rad].
    pub angular_violation: Vec<f64>,
    /// 1 for those that have let go.
    pub broken: Vec<i8>,
}

impl JointRows {
    /// The first `count` joints at this instant.
    pub fn push(&mut self, world: &mut World, count: usize) {
        let loads = world.joint_loads();
        let (joints, bodies) = (&world.joints, &world.bodies);
        for (j, (force, torque)) in loads.into_iter().take(count).enumerate() {
            self.force.push(force.to_array());
            self.torque.push(torque.to_array());
            for (k, column) in self.coordinates.iter_mut().enumerate() {
                column.push(joints.coordinate(j, k, bodies).unwrap_or(f64::NAN));
            }
            let (place, direction) = joints.violation(j, bodies);
            self.violation.push(place);
            self.angular_violation.push(direction);
            self.broken.push(i8::from(joints.is_broken(j)));
        }
    }
}

/// Frames in the order of time, and impacts up to the last of them.
#[derive(Debug, Default)]
pub struct Frames {
    choice: Choice,
    /// One for each frame.
    pub summaries: Vec<Summary>,
    /// The chosen bodies.
    pub bodies: BodyRows,
    /// The contact points of the steps that led to the frames; empty where not wanted.
    pub contacts: ContactRows,
    /// The chosen joints.
    pub joints: JointRows,
    /// Length and tension, or angle and torque, of each spring; empty where not wanted.
    pub springs: Vec<(f64, f64)>,
    /// Impacts since the last hand-out.
    pub events: Vec<Event>,
}

impl Frames {
    /// None yet.
    #[must_use]
    pub fn new(choice: Choice) -> Self {
        Self {
            choice,
            ..Self::default()
        }
    }

    /// What is kept.
    #[must_use]
    pub fn choice(&self) -> &Choice {
        &self.choice
    }

    /// All frames so far, which are forgotten here; room for as many is made.
    pub fn take(&mut self) -> Self {
        let next = Self {
            choice: self.choice.clone(),
            summaries: Vec::with_capacity(self.summaries.len()),
            bodies: BodyRows::like(&self.bodies),
            contacts: ContactRows::like(&self.contacts),
            ..Self::default()
        };
        std::mem::replace(self, next)
    }

    /// The present state as the next frame.
    pub fn keep(&mut self, world: &mut World) {
        self.summaries.push(self.summary(world));
        self.events.append(&mut world.impacts.events);
        let all = world.bodies();
        match &self.choice.bodies {
            None => all.iter().for_each(|b| self.bodies.push(b)),
            Some(some) => some.iter().for_each(|&k| self.bodies.push(&all[k])),
        }
        if self.choice.contacts {
            self.contacts.extend(&world.contacts, world);
        }
        if self.choice.springs {
            self.springs.extend(world.springs());
        }
        if self.choice.joints > 0 {
            self.joints.push(world, self.choice.joints);
        }
    }

    fn summary(&self, world: &World) -> Summary {
        let report = world.report();
        let choice = &self.choice;
        Summary {
            step: world.steps(),
            residual: report.residual,
            iterations: report.iterations,
            contacts: world.contacts.len(),
            fallbacks: world.fallbacks(),
            momentum: choice.momentum.then(|| world.momentum()),
            energies: choice.energy.then(|| world.energies()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{pair_row, Plan};

    #[test]
    fn rows_of_pairs_are_counted_through_the_upper_triangle() {
        let all = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];
        for (row, (a, b)) in all.into_iter().enumerate() {
            assert_eq!((pair_row((a, b), 3), pair_row((b, a), 3)), (row, row));
        }
    }

    #[test]
    fn frames_are_due_at_multiples_and_at_the_end() {
        let plan = Plan {
            every: 4,
            last: 10,
            rest_time: f64::INFINITY,
        };
        let due: Vec<u64> = (0..=12).filter(|&step| plan.has_frame(step)).collect();
        assert_eq!(due, [0, 4, 8, 10, 12]);
    }
}
