//! All joints of a world: their rows, coordinates, reactions and what of them changes over time.

use std::f64::consts::TAU;
use std::ops::Range;

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::layout::Equation;
use super::lock::Lock;
use super::measure::Measure;
use super::model::{DriveModel, JointModel, Kind};
use super::placement::{Motion, Mount, Placement};
use super::row::{End, Row};
use crate::body::Body;

/// What checkpoints keep of the joints.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct JointState {
    /// Every coordinate as last observed; angles count their turns.
    seen: Vec<f64>,
    broken: Vec<bool>,
}

/// A joint ready for the step.
#[derive(Clone, Debug)]
pub(super) struct Joint {
    pub(super) model: JointModel,
    pub(super) mounts: [Mount; 2],
    /// Its first row among all.
    first_row: usize,
    /// Its first coordinate among all.
    first_coordinate: usize,
    /// Drives that can hold their coordinate still; each has a row behind the equations.
    lockable: Vec<usize>,
}

impl Joint {
    fn equations(&self) -> &'static [Equation] {
        self.model.kind.layout().equations
    }

    fn coordinates(&self) -> &'static [Measure] {
        self.model.kind.layout().coordinates
    }

    pub(super) fn lockable(&self) -> &[usize] {
        &self.lockable
    }

    fn row_count(&self) -> usize {
        self.equations().len() + self.lockable.len()
    }
}

/// The joints of a world and their drives.
#[derive(Clone, Debug)]
pub struct Joints {
    pub(super) joints: Vec<Joint>,
    pub(super) drives: Vec<DriveModel>,
    /// Of each drive, in the step at hand.
    pub(super) locks: Vec<Option<Lock>>,
    state: JointState,
}

impl Joints {
    /// As the bodies stand now; angles start within half a turn of zero. The models must pass `check`.
    ///
    /// `drives` keep their order; after them comes one for the rim of each cone joint.
    #[must_use]
    pub fn new(models: Vec<JointModel>, mut drives: Vec<DriveModel>, bodies: &[Body]) -> Self {
        drives.extend(
            models
                .iter()
                .enumerate()
                .filter_map(|(j, model)| rim(j, model)),
        );
        for drive in &mut drives {
            drive.drop_limits_of_distances(&models[drive.joint]);
        }
        let (mut row, mut coordinate) = (0, 0);
        let mut joints = Vec::with_capacity(models.len());
        for (j, model) in models.into_iter().enumerate() {
            let locks = |k: &usize| drives[*k].joint == j && drives[*k].can_lock();
            let mount = |k: usize| Mount::new(model.bodies[k], model.anchors[k], model.frames[k]);
            let joint = Joint {
                mounts: [mount(0), mount(1)],
                model,
                first_row: row,
                first_coordinate: coordinate,
                lockable: (0..drives.len()).filter(locks).collect(),
            };
            row += joint.row_count();
            coordinate += joint.coordinates().len();
            joints.push(joint);
        }
        let state = JointState {
            seen: vec![0.0; coordinate],
            broken: vec![false; joints.len()],
        };
        let mut all = Self {
            joints,
            locks: vec![None; drives.len()],
            drives,
            state,
        };
        all.observe(bodies);
        all
    }

    /// Number of joints.
    #[must_use]
    pub fn len(&self) -> usize {
        self.joints.len()
    }

    /// No joints at all.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.joints.is_empty()
    }

    /// What joint `j` is.
    #[must_use]
    pub fn model(&self, j: usize) -> &JointModel {
        &self.joints[j].model
    }

    /// The bilateral rows of joint `j` among those of `rows`: its equations, then those of coordinates that can be held.
    #[must_use]
    pub fn rows_of(&self, j: usize) -> Range<usize> {
        let joint = &self.joints[j];
        joint.first_row..joint.first_row + joint.row_count()
    }

    /// All bilateral rows, joint after joint, each with its number, as a sum of rows between two bodies: of two rows that of a
    /// gear, of none that of a broken joint and of a coordinate that is not held. With their biases where that is asked.
    #[inline]
    pub fn rows(&self, bodies: &[Body], biased: bool, mut each: impl FnMut(usize, &[Row])) {
        for (j, joint) in self.joints.iter().enumerate() {
            let mut numbers = self.rows_of(j);
            if self.state.broken[j] {
                numbers.for_each(|r| each(r, &[]));
                continue;
            }
            let at = Placement::new(&joint.mounts, bodies);
            let motion = biased.then(|| Motion::new(&at, bodies));
            for (&equation, r) in joint.equations().iter().zip(&mut numbers) {
                match (equation, joint.model.kind) {
                    (Equation::Gear, Kind::Gear { ratio, joints }) => {
                        let [first, second] = joints.map(|k| self.angle_row(k, bodies));
                        each(r, &[second, first.scaled(-ratio)]);
                    }
                    _ => each(r, &[self.row(joint, equation, &at, motion.as_ref())]),
                }
            }
            for (&k, r) in joint.lockable().iter().zip(numbers) {
                let Some(lock) = self.locks[k] else {
                    each(r, &[]);
                    continue;
                };
                let mut row =
                    self.placed_row(joint, self.drives[k].coordinate, &at, motion.as_ref());
                row.value -= lock.place;
                each(r, &[row]);
            }
        }
    }

    /// By how much every row is off from the value wanted of it, into `out`; returns the largest [m or rad].
    pub fn errors(&self, bodies: &[Body], wanted: &[f64], out: &mut Vec<f64>) -> f64 {
        self.values(bodies, out);
        let mut largest = 0.0_f64;
        for (value, want) in out.iter_mut().zip(wanted) {
            *value = want - *value;
            largest = largest.max(value.abs());
        }
        largest
    }

    /// The values of `rows` alone.
    pub fn values(&self, bodies: &[Body], out: &mut Vec<f64>) {
        out.clear();
        for (j, joint) in self.joints.iter().enumerate() {
            if self.state.broken[j] {
                out.resize(out.len() + joint.row_count(), 0.0);
                continue;
            }
            let at = Placement::new(&joint.mounts, bodies);
            for &equation in joint.equations() {
                out.push(self.value(joint, equation, &at, bodies));
            }
            for &k in joint.lockable() {
                let off =
                    |lock: Lock| self.placed(joint, self.drives[k].coordinate, &at) - lock.place;
                out.push(self.locks[k].map_or(0.0, off));
            }
        }
    }

    #[inline(always)]
    fn row(
        &self,
        joint: &Joint,
        equation: Equation,
        at: &Placement,
        motion: Option<&Motion>,
    ) -> Row {
        match (equation, joint.model.kind) {
            (Equation::Zero(measure), _) => measure.row(at, motion),
            (Equation::Length, Kind::Distance { length }) => {
                let mut row = Measure::Length.row(at, motion);
                row.value -= length;
                row
            }
            (Equation::Thread, Kind::Screw { pitch }) => {
                let angle = self.placed_row(joint, 0, at, motion);
                Measure::Gap(2).row(at, motion).plus(&angle.scaled(-pitch))
            }
            _ => unreachable!("the table of kinds gives each kind its own equations"),
        }
    }

    fn value(&self, joint: &Joint, equation: Equation, at: &Placement, bodies: &[Body]) -> f64 {
        match (equation, joint.model.kind) {
            (Equation::Zero(measure), _) => measure.value(at),
            (Equation::Length, Kind::Distance { length }) => at.gap.length() - length,
            (Equation::Thread, Kind::Screw { pitch }) => {
                Measure::Gap(2).value(at) - pitch * self.placed(joint, 0, at)
            }
            (Equation::Gear, Kind::Gear { ratio, joints }) => {
                let [first, second] = joints.map(|k| self.angle(k, bodies));
                second - ratio * first
            }
            _ => unreachable!("the table of kinds gives each kind its own equations"),
        }
    }

    /// Coordinate `k` of a joint placed so; angles on the branch nearest to the one last observed.
    fn placed(&self, joint: &Joint, k: usize, at: &Placement) -> f64 {
        let measure = joint.coordinates()[k];
        let value = measure.value(at);
        if measure.wraps() {
            nearest_turn(value, self.state.seen[joint.first_coordinate + k])
        } else {
            value
        }
    }

    /// Its row.
    fn placed_row(&self, joint: &Joint, k: usize, at: &Placement, motion: Option<&Motion>) -> Row {
        let mut row = joint.coordinates()[k].row(at, motion);
        row.value = self.placed(joint, k, at);
        row
    }

    /// Row of coordinate `k` of joint `j`, with the coordinate as its value.
    pub(super) fn coordinate_row(&self, j: usize, k: usize, bodies: &[Body]) -> Row {
        let joint = &self.joints[j];
        let at = Placement::new(&joint.mounts, bodies);
        self.placed_row(joint, k, &at, Some(&Motion::new(&at, bodies)))
    }

    /// Coordinate `k` of joint `j`.
    pub(super) fn placed_coordinate(&self, j: usize, k: usize, bodies: &[Body]) -> f64 {
        let joint = &self.joints[j];
        self.placed(joint, k, &Placement::new(&joint.mounts, bodies))
    }

    fn angle_row(&self, j: usize, bodies: &[Body]) -> Row {
        self.coordinate_row(j, first_angle(&self.joints[j]), bodies)
    }

    fn angle(&self, j: usize, bodies: &[Body]) -> f64 {
        self.placed_coordinate(j, first_angle(&self.joints[j]), bodies)
    }

    /// Count the turns of angles; once a step, while no angle has gone further than half a turn.
    pub fn observe(&mut self, bodies: &[Body]) {
        for j in 0..self.joints.len() {
            let first = self.joints[j].first_coordinate;
            for k in 0..self.joints[j].coordinates().len() {
                self.state.seen[first + k] = self.placed_coordinate(j, k, bodies);
            }
        }
    }

    /// Coordinate `k` of joint `j` [rad or m], none where the joint has no such coordinate.
    #[must_use]
    pub fn coordinate(&self, j: usize, k: usize, bodies: &[Body]) -> Option<f64> {
        let joint = &self.joints[j];
        (k < joint.coordinates().len()).then(|| self.placed_coordinate(j, k, bodies))
    }

    /// How far joint `j` is from holding: root of the sum of squares of its rows, lengths [m] and angles [rad] apart.
    /// Zero once it broke.
    #[must_use]
    pub fn violation(&self, j: usize, bodies: &[Body]) -> (f64, f64) {
        if self.state.broken[j] {
            return (0.0, 0.0);
        }
        let joint = &self.joints[j];
        let at = Placement::new(&joint.mounts, bodies);
        let (mut lengths, mut angles) = (0.0, 0.0);
        for &equation in joint.equations() {
            let value = self.value(joint, equation, &at, bodies);
            if equation.is_angular() {
                angles += value * value;
            } else {
                lengths += value * value;
            }
        }
        (lengths.sqrt(), angles.sqrt())
    }

    /// Impulse [N s] and turning impulse [N m s] on body A that joint `j` passes on: the sum of J_A^T lambda, the turning
    /// impulse about the anchor of A. With forces instead of impulses: force and torque. Of a gear: on its first wheel.
    ///
    /// `pushes` are the ends of its rows, bilateral or of its drives, each with the impulse of its row.
    #[must_use]
    pub fn reaction(
        &self,
        j: usize,
        pushes: impl Iterator<Item = (End, f64)>,
        bodies: &[Body],
    ) -> (DVec3, DVec3) {
        let [mount, _] = &self.joints[j].mounts;
        let (mut impulse, mut turning) = (DVec3::ZERO, DVec3::ZERO);
        for (end, lambda) in pushes.filter(|(end, _)| end.body == mount.body) {
            impulse += lambda * end.linear;
            turning += lambda * end.angular;
        }
        (impulse, turning - mount.arm(bodies).cross(impulse))
    }

    /// Some joint breaks under too great a load.
    #[must_use]
    pub fn can_break(&self) -> bool {
        let finite = |m: &JointModel| m.break_force.is_finite() || m.break_torque.is_finite();
        self.joints.iter().any(|joint| finite(&joint.model))
    }

    /// Break every joint whose force [N] or torque [N m] about its anchor is more than it bears, and gears with their joints.
    pub fn break_overloaded(&mut self, loads: &[(DVec3, DVec3)]) {
        for (j, (force, torque)) in loads.iter().enumerate() {
            let model = &self.joints[j].model;
            if force.length() > model.break_force || torque.length() > model.break_torque {
                self.state.broken[j] = true;
            }
        }
        for j in 0..self.joints.len() {
            if let Kind::Gear { joints, .. } = self.joints[j].model.kind {
                self.state.broken[j] |= joints.iter().any(|&k| self.state.broken[k]);
            }
        }
    }

    /// Joint `j` broke.
    #[must_use]
    pub fn is_broken(&self, j: usize) -> bool {
        self.state.broken[j]
    }

    /// For checkpoints.
    #[must_use]
    pub fn state(&self) -> &JointState {
        &self.state
    }

    /// Go back to a checkpoint.
    ///
    /// # Errors
    /// When the state is one of other joints.
    pub fn set_state(&mut self, state: JointState) -> Result<(), String> {
        if state.seen.len() != self.state.seen.len()
            || state.broken.len() != self.state.broken.len()
        {
            return Err("the state belongs to other joints".into());
        }
        self.state = state;
        Ok(())
    }
}

impl DriveModel {
    /// A distance cannot fall below zero by itself: a limit there would stop bodies that pass each other closely.
    fn drop_limits_of_distances(&mut self, joint: &JointModel) {
        let measure = joint.kind.layout().coordinates[self.coordinate];
        if measure == Measure::Length && self.limits[0] <= 0.0 {
            self.limits[0] = f64::NEG_INFINITY;
        }
    }
}

/// The limit of a cone joint's angle.
fn rim(joint: usize, model: &JointModel) -> Option<DriveModel> {
    let Kind::Cone {
        max_angle,
        restitution,
    } = model.kind
    else {
        return None;
    };
    Some(DriveModel {
        limits: [f64::NEG_INFINITY, max_angle],
        restitution,
        ..DriveModel::free(joint, 0)
    })
}

/// Number of a joint's first coordinate that is an angle.
fn first_angle(joint: &Joint) -> usize {
    let found = joint.coordinates().iter().position(|c| c.wraps());
    found.expect("a gear's joints have angles")
}

/// `angle` plus whole turns, nearest to `seen`.
fn nearest_turn(angle: f64, seen: f64) -> f64 {
    angle + TAU * ((seen - angle) / TAU).round()
}
