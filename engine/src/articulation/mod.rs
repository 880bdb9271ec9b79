//! All joints at once: the linear system of their rows, solved directly.
//!
//! With J the rows, M the masses and x the impulses, a set of joints asks for J (v + M^-1 J^T x) = target. The matrix
//! A = J M^-1 J^T couples rows that share a moving body, so a chain gives a band and a tree of joints no fill at all: a
//! direct solve costs as much as the mechanism has joints, and is as exact for a weight of a tonne on a chain of grams as
//! for equal links. Redundant rows (a door on two hinges) make A singular: a share EPSILON of the diagonal is then
//! added, and taken back by iterative refinement, which leaves of all solutions one that is next to the smallest.
//!
//! Motors, dry friction and limits are rows with bounds lower <= x <= upper. Which of them stand at a bound is found by
//! an active set: solve with the free ones, clamp those beyond their bounds, free those that are pushed inwards, until
//! nothing changes (Hintermueller, Ito & Kunisch 2002, "The primal-dual active set strategy as a semismooth Newton
//! method"; every sixth round only the first to change does, which cannot cycle: Murty 1974).

mod assembly;
mod ldu;
mod levers;
mod square;
mod swing;

use std::collections::BTreeSet;

use glam::{DMat3, DQuat, DVec3};
use serde::{Deserialize, Serialize};

use crate::body::Body;
use crate::contact::Contact;
use crate::force::Wrench;
use crate::joint::{Ahead, Cause, Course, DriveRow, End, Joints, Kind, Row};
use crate::mover::{Mover, Moving, Twist, Yielding};
use assembly::{Assembly, Member, IDLE, WIDTH};
use levers::Place;
use square::Column;

/// Rounds of the active set at most.
const ROUNDS: usize = 60;

/// A limit this near is reached [m or rad].
const REACHED: f64 = 1e-6;

/// Whether a bounded row pushes as much as it takes, or as much as it may.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Hold {
    /// Between its bounds.
    Free,
    /// At the lower bound.
    Lower,
    /// At the upper bound.
    Upper,
}

/// What a row is to reach, and with how much.
#[derive(Clone, Copy, Debug)]
pub struct Aim {
    /// Rate [m/s or rad/s].
    pub target: f64,
    /// Least impulse [N s or N m s].
    pub lower: f64,
    /// Greatest impulse.
    pub upper: f64,
}

impl Aim {
    /// A row that may push both ways without bound.
    #[must_use]
    pub fn held(target: f64) -> Self {
        Self {
            target,
            lower: f64::NEG_INFINITY,
            upper: f64::INFINITY,
        }
    }

    /// What a drive is to do in a step of `h`.
    #[must_use]
    pub fn of_step(drive: &DriveRow, h: f64) -> Self {
        Self {
            target: drive.target,
            lower: drive.lower * h,
            upper: drive.upper * h,
        }
    }

    /// What a drive does in no time: only a limit that is reached can push, and it keeps the coordinate from going on.
    #[must_use]
    pub fn of_impact(drive: &DriveRow, bodies: &[Body]) -> Self {
        if drive.cause != Cause::Limit || drive.is_idle() || drive.row.value > REACHED {
            return Self::IDLE;
        }
        Self {
            target: drive.row.rate(bodies).min(0.0),
            lower: 0.0,
            upper: f64::INFINITY,
        }
    }

    /// A row that takes no part.
    pub const IDLE: Self = Self {
        target: 0.0,
        lower: 0.0,
        upper: 0.0,
    };

    fn is_idle(&self) -> bool {
        self.lower == 0.0 && self.upper == 0.0
    }
}

/// The rows of all joints and the systems that they form.
#[derive(Clone, Debug, Default)]
pub struct Articulation {
    /// Of the bilateral rows of all joints.
    courses: Vec<Course>,
    /// Their biases are those of velocities at these poses.
    biased: bool,
    drives: Vec<DriveRow>,
    /// Drives take part.
    driven: bool,
    assemblies: Vec<Assembly>,
    /// Assembly and place of each row: the bilateral ones, then those of the drives.
    places: Vec<(usize, Place)>,
    /// Bodies with joints, and where they were when the rows were loaded.
    touched: Vec<usize>,
    poses: Vec<Pose>,
    /// The assembly of each body.
    homes: Vec<Option<usize>>,
    aims: Vec<Aim>,
    /// Of the solve at hand, one a row.
    impulses: Vec<f64>,
    marked: Vec<f64>,
    holds: Vec<Hold>,
    /// Of the drives in the last step: where the next search begins.
    kept: Vec<Hold>,
    /// Of each body, see [`Levers::answer`].
    answers: Vec<(f64, DMat3)>,
    trial: Vec<Twist>,
}

impl Articulation {
    /// Find out which joints hang together.
    #[must_use]
    pub fn new(joints: &Joints, bodies: &[Body], ahead: Ahead) -> Self {
        let mut drives = Vec::new();
        joints.drive_rows(bodies, ahead, &mut drives);
        let bilateral = (0..joints.len()).map(|j| joints.rows_of(j).len()).sum();
        let members: Vec<Member> = (0..joints.len())
            .map(|j| {
                let own = drives.iter().enumerate().filter(|(_, d)| d.joint == j);
                let rows = joints.rows_of(j).chain(own.map(|(k, _)| bilateral + k));
                let touched = bodies_of(joints, j);
                let moving = touched.iter().filter(|&&b| !bodies[b].is_fixed());
                Member {
                    rows: rows.collect(),
                    bodies: moving.copied().collect(),
                    touched,
                }
            })
            .collect();
        let touched: BTreeSet<usize> = members.iter().flat_map(|m| m.touched.clone()).collect();
        let assemblies = assembly::divide(&members);
        let rows = bilateral + drives.len();
        let mut homes = vec![None; bodies.len()];
        let mut places = vec![(0, (0, 0)); rows];
        for (index, assembly) in assemblies.iter().enumerate() {
            for &body in &assembly.bodies {
                homes[body] = Some(index);
            }
            for (block, rows) in assembly.blocks.iter().enumerate() {
                for (column, &row) in rows.iter().enumerate().filter(|(_, &row)| row != IDLE) {
                    places[row] = (index, (block, column));
                }
            }
        }
        Self {
            courses: vec![Course::default(); bilateral],
            assemblies,
            places,
            touched: touched.into_iter().collect(),
            homes,
            holds: vec![Hold::Lower; rows],
            kept: vec![Hold::Lower; drives.len()],
            impulses: vec![0.0; rows],
            aims: vec![Aim::IDLE; rows],
            answers: vec![(0.0, DMat3::ZERO); bodies.len()],
            drives,
            ..Self::default()
        }
    }

    /// Some rows follow from others, as they were factored last.
    #[must_use]
    pub fn is_redundant(&self) -> bool {
        self.assemblies.iter().any(Assembly::is_redundant)
    }

    /// No joints at all.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.assemblies.is_empty()
    }

    /// Number of assemblies.
    #[must_use]
    pub fn len(&self) -> usize {
        self.assemblies.len()
    }

    /// The assembly of a body.
    #[must_use]
    pub fn home(&self, body: usize) -> Option<usize> {
        self.homes.get(body).copied().flatten()
    }

    /// One body that stands for all that joints tie together with `body`.
    #[must_use]
    pub fn leader(&self, body: usize) -> usize {
        self.home(body)
            .map_or(body, |assembly| self.assemblies[assembly].bodies[0])
    }

    /// Moving bodies of an assembly.
    #[must_use]
    pub fn bodies(&self, assembly: usize) -> &[usize] {
        &self.assemblies[assembly].bodies
    }

    /// Bilateral rows, joint after joint.
    #[must_use]
    pub fn rows(&self) -> &[Course] {
        &self.courses
    }

    /// The Jacobian of a row, bilateral or, behind these, of a drive.
    pub fn ends(&self, row: usize) -> impl Iterator<Item = End> + '_ {
        let (assembly, place) = self.places[row];
        self.assemblies[assembly].levers.ends(place)
    }

    /// Impulses of the drives in the solve at hand.
    #[must_use]
    pub fn drive_impulses(&self) -> &[f64] {
        &self.impulses[self.courses.len()..]
    }

    /// Aim for a step of `h`: bilateral rows as `bilateral` says, drives as they ask; the search for those at a bound
    /// begins with those of the last step.
    pub fn aim_step(&mut self, bilateral: impl Fn(&Course) -> f64, h: f64) {
        self.aim(bilateral, |drive| Aim::of_step(drive, h));
        for (row, &kept) in (self.courses.len()..).zip(&self.kept) {
            if !self.aims[row].is_idle() {
                self.holds[row] = kept;
            }
        }
    }

    /// Remember which bounded rows stand at a bound.
    pub fn keep_holds(&mut self) {
        self.kept.copy_from_slice(&self.holds[self.courses.len()..]);
    }

    /// What `keep_holds` kept; for checkpoints.
    #[must_use]
    pub fn kept_holds(&self) -> &[Hold] {
        &self.kept
    }

    /// Go back to what `kept_holds` gave here.
    pub(crate) fn keep(&mut self, holds: &[Hold]) {
        self.kept.copy_from_slice(holds);
    }

    /// Take back what `kept_holds` gave.
    ///
    /// # Errors
    /// When it is of other joints.
    pub fn set_kept_holds(&mut self, kept: Vec<Hold>) -> Result<(), String> {
        if kept.len() != self.kept.len() {
            return Err("the checkpoint is of other joints".into());
        }
        self.kept = kept;
        Ok(())
    }

    /// Drive row `k` pushes, and no more than it may: what it aims at is reached.
    #[must_use]
    pub fn reaches(&self, k: usize) -> bool {
        let row = self.courses.len() + k;
        let pushes = self.drives[k].cause != Cause::Limit || self.impulses[row] > 0.0;
        pushes && self.holds[row] == Hold::Free
    }

    /// Drive rows as they were loaded.
    #[must_use]
    pub fn drives(&self) -> &[DriveRow] {
        &self.drives
    }

    /// Impulses of the solve at hand: bilateral rows, then drives.
    #[must_use]
    pub fn impulses(&self) -> &[f64] {
        &self.impulses
    }

    /// Rows at the present poses and velocities, and what the drives want of the step that begins.
    pub fn load(&mut self, joints: &Joints, bodies: &[Body], ahead: Ahead) {
        if !self.drives.is_empty() {
            joints.drive_rows(bodies, ahead, &mut self.drives);
            self.driven = true;
        }
        self.load_anew(joints, bodies);
    }

    /// Bilateral rows at the present poses and velocities; drives take no part until the next `load`.
    pub fn load_bilateral(&mut self, joints: &Joints, bodies: &[Body]) {
        self.driven = false;
        self.load_anew(joints, bodies);
    }

    /// As `load_bilateral`, but the bias of the rows may be that of velocities that bodies had at these poses before.
    pub fn load_near(&mut self, joints: &Joints, bodies: &[Body]) {
        if !(self.biased && self.is_loaded_at(bodies)) {
            self.load_bilateral(joints, bodies);
        }
    }

    /// As `load_bilateral`, but for the bias of the rows.
    pub fn load_places(&mut self, joints: &Joints, bodies: &[Body]) {
        if !self.is_loaded_at(bodies) {
            self.driven = false;
            self.biased = false;
            self.place(joints, bodies, false);
        }
    }

    fn load_anew(&mut self, joints: &Joints, bodies: &[Body]) {
        self.biased = true;
        if self.is_loaded_at(bodies) {
            let courses = &mut self.courses;
            joints.rows(bodies, true, |r, rows| courses[r] = course(rows));
        } else {
            self.place(joints, bodies, true);
        }
    }

    /// Rows and their Jacobians.
    fn place(&mut self, joints: &Joints, bodies: &[Body], biased: bool) {
        let (courses, places) = (&mut self.courses, &self.places);
        let assemblies = &mut self.assemblies;
        joints.rows(bodies, biased, |r, rows| {
            courses[r] = course(rows);
            let (assembly, at) = places[r];
            assemblies[assembly].levers.place(at, rows);
        });
        if self.driven {
            for (drive, &(assembly, at)) in self.drives.iter().zip(&places[courses.len()..]) {
                assemblies[assembly].levers.place(at, &[drive.row]);
            }
        }
        for a in assemblies {
            a.levers.weigh(bodies);
            a.factored = false;
        }
        self.poses.clear();
        self.poses
            .extend(self.touched.iter().map(|&k| pose_of(&bodies[k])));
    }

    /// Bodies have the poses of the last load, and rows are nothing but those of joints.
    fn is_loaded_at(&self, bodies: &[Body]) -> bool {
        let same = |(&k, pose): (&usize, &Pose)| *pose == pose_of(&bodies[k]);
        self.drives.is_empty()
            && self.poses.len() == self.touched.len()
            && self.touched.iter().zip(&self.poses).all(same)
    }

    /// Rates of the bilateral rows are those of bodies that move like this.
    pub(crate) fn note_rates(&mut self, moving: &[impl Moving]) {
        for a in &self.assemblies {
            a.note_rates(moving, &mut self.courses);
        }
    }

    /// Forget the impulses, and aim: bilateral rows as `bilateral` says, drives as `drive` says.
    pub fn aim(&mut self, bilateral: impl Fn(&Course) -> f64, drive: impl Fn(&DriveRow) -> Aim) {
        let (held, driven) = self.aims.split_at_mut(self.courses.len());
        for (aim, row) in held.iter_mut().zip(&self.courses) {
            *aim = if row.holds {
                Aim::held(bilateral(row))
            } else {
                Aim::IDLE
            };
        }
        for (aim, row) in driven.iter_mut().zip(&self.drives) {
            *aim = if self.driven { drive(row) } else { Aim::IDLE };
        }
        self.impulses.fill(0.0);
        for (index, hold) in self.holds.iter_mut().enumerate() {
            if self.aims[index].is_idle() {
                *hold = Hold::Lower;
            } else if index < self.courses.len() {
                *hold = Hold::Free;
            }
        }
    }

    /// Make the rows of an assembly reach their aims from where the bodies are; impulses add up over the calls
    /// since `aim`.
    pub(crate) fn solve(&mut self, assembly: usize, moving: &mut [impl Yielding]) {
        for round in 0..ROUNDS {
            self.clamp(assembly, moving);
            self.solve_free(assembly, moving);
            if !self.change_holds(assembly, moving, round % 6 == 5) {
                return;
            }
        }
        self.clamp(assembly, moving);
        self.solve_free(assembly, moving);
    }

    /// What is left of given motions when the free rows hold still: V - M^-1 J^T A^-1 J V.
    pub(crate) fn respond(&mut self, assembly: usize, motions: &mut [Twist]) {
        self.assemblies[assembly].ask_rates(&self.holds, motions, |_| 0.0);
        self.divide(assembly);
        self.assemblies[assembly].push(motions);
    }

    /// The same to some digits, without refinement.
    fn respond_roughly(&mut self, assembly: usize, motions: &mut [Twist]) {
        let a = &mut self.assemblies[assembly];
        a.ask_rates(&self.holds, motions, |_| 0.0);
        a.factor(&self.holds);
        a.divide_roughly();
        a.push(motions);
    }

    /// Give all bodies the impulses that change the bilateral rows' rates by `missing` (one number a row).
    pub fn kick(&mut self, bodies: &mut [Body], missing: &[f64]) {
        for assembly in 0..self.assemblies.len() {
            self.ask_bilateral(assembly, missing);
            self.divide(assembly);
            self.assemblies[assembly].kick(bodies, &mut self.impulses);
        }
    }

    /// Displacements (as twists times 1 s) that change the bilateral rows' values by `missing`.
    pub fn displacements(&mut self, missing: &[f64], shifts: &mut Vec<Twist>) {
        shifts.clear();
        shifts.resize(self.homes.len(), Twist::default());
        for assembly in 0..self.assemblies.len() {
            self.ask_bilateral(assembly, missing);
            self.divide(assembly);
            self.assemblies[assembly].push(shifts);
        }
    }

    /// Look ahead to the end of a drift: bilateral rows where it leads to, and how bodies answer there to impulses at its
    /// start, see [`Levers::answer`]. Rows and impulses stay those of the start.
    pub fn look_ahead(
        &mut self,
        joints: &Joints,
        bodies: &[Body],
        answer: impl Fn(usize) -> (f64, DMat3),
    ) {
        for a in &self.assemblies {
            a.bodies.iter().for_each(|&k| self.answers[k] = answer(k));
        }
        let (assemblies, places) = (&mut self.assemblies, &self.places);
        joints.rows(bodies, false, |r, rows| {
            let (assembly, at) = places[r];
            assemblies[assembly].levers.place_ahead(at, rows);
        });
        for a in assemblies {
            a.levers.answer(&self.answers);
            a.factor_ahead(&self.holds);
        }
    }

    /// Give all bodies the impulses that change the bilateral rows' values ahead by `missing`, to first order.
    pub fn kick_ahead(&mut self, bodies: &mut [Body], missing: &[f64]) {
        for assembly in 0..self.assemblies.len() {
            self.ask_bilateral(assembly, missing);
            let a = &mut self.assemblies[assembly];
            a.divide_ahead();
            a.kick(bodies, &mut self.impulses);
        }
    }

    /// Where `take_back` goes back to.
    pub fn mark_impulses(&mut self) {
        self.marked.clone_from(&self.impulses);
    }

    /// Impulses are those of the last mark.
    pub fn take_back(&mut self) {
        self.impulses.clone_from(&self.marked);
    }

    fn ask_bilateral(&mut self, assembly: usize, missing: &[f64]) {
        let of = |row: usize| missing.get(row).copied().unwrap_or(0.0);
        self.assemblies[assembly].ask(&self.holds, of);
    }

    /// Bilateral rows change given accelerations so that theirs are as `asked`; their forces stay in `impulses`.
    pub fn hold(&mut self, asked: impl Fn(&Course) -> f64, accelerations: &mut [Twist]) {
        self.aim(asked, |_| Aim::IDLE);
        for assembly in 0..self.assemblies.len() {
            self.solve(assembly, accelerations);
        }
    }

    /// Add J^T y to wrenches, y the forces of the last `hold`.
    pub fn add_forces(&self, wrenches: &mut [Wrench]) {
        for (row, &y) in (0..self.courses.len()).zip(&self.impulses) {
            for end in self.ends(row) {
                wrenches[end.body].force += end.linear * y;
                wrenches[end.body].torque += end.angular * y;
            }
        }
    }

    /// All rows free or idle as bilateral rows are, no impulses yet, drives out of it.
    pub fn clear_impulses(&mut self) {
        self.aim(|_| 0.0, |_| Aim::IDLE);
    }

    /// What is left of K of a contact's normal [1/kg] when the free rows of an assembly hold still.
    pub(crate) fn mobility(&mut self, assembly: usize, c: &Contact, bodies: &[Body]) -> f64 {
        let mut motions = std::mem::take(&mut self.trial);
        motions.clear();
        motions.resize(bodies.len(), Twist::default());
        for (k, impulse, arm) in [
            (c.bodies.0, c.normal, c.arms.0),
            (c.bodies.1, -c.normal, c.arms.1),
        ] {
            motions[k] = Mover::of(&bodies[k]).response(impulse, arm);
        }
        self.respond(assembly, &mut motions);
        let left = c.material_velocity(&motions).x;
        self.trial = motions;
        left
    }

    /// Rows at a bound push just as much as it says.
    fn clamp(&mut self, assembly: usize, moving: &mut [impl Yielding]) {
        let a = &self.assemblies[assembly];
        for (block, rows) in a.blocks.iter().enumerate() {
            let mut changes = Column::ZERO;
            for (column, &row) in rows.iter().enumerate() {
                let bound = match self.holds.get(row) {
                    None | Some(Hold::Free) => continue,
                    Some(Hold::Lower) => self.aims[row].lower,
                    Some(Hold::Upper) => self.aims[row].upper,
                };
                changes[column] = bound - self.impulses[row];
                self.impulses[row] = bound;
            }
            if changes != Column::ZERO {
                a.levers.push(block, changes, moving);
            }
        }
    }

    fn solve_free(&mut self, assembly: usize, moving: &mut [impl Yielding]) {
        let aims = &self.aims;
        self.assemblies[assembly].ask_rates(&self.holds, moving, |row| aims[row].target);
        if self.assemblies[assembly].asks_nothing() {
            return;
        }
        self.divide(assembly);
        let a = &self.assemblies[assembly];
        a.push(moving);
        a.add_to(&mut self.impulses);
    }

    /// Free rows beyond a bound are clamped, clamped rows that would rather be inside are freed.
    fn change_holds(&mut self, assembly: usize, moving: &[impl Moving], only_first: bool) -> bool {
        let mut any = false;
        for slot in 0..WIDTH * self.assemblies[assembly].blocks.len() {
            let row = self.assemblies[assembly].blocks[slot / WIDTH][slot % WIDTH];
            if row < self.courses.len() || row == IDLE || self.aims[row].is_idle() {
                continue;
            }
            let drive = &self.drives[row - self.courses.len()];
            let next = self.wanted_hold(row, drive.row.rate(moving));
            if next != self.holds[row] {
                self.holds[row] = next;
                any = true;
                if only_first {
                    break;
                }
            }
        }
        any
    }

    fn wanted_hold(&self, row: usize, rate: f64) -> Hold {
        let (aim, x) = (self.aims[row], self.impulses[row]);
        let slack = 1e-12 * (1.0 + aim.target.abs());
        match self.holds[row] {
            Hold::Free if x < aim.lower => Hold::Lower,
            Hold::Free if x > aim.upper => Hold::Upper,
            Hold::Lower if rate < aim.target - slack => Hold::Free,
            Hold::Upper if rate > aim.target + slack => Hold::Free,
            same => same,
        }
    }

    /// `solution` := A^-1 `solution` over the free rows; 0 in the others.
    fn divide(&mut self, assembly: usize) {
        let a = &mut self.assemblies[assembly];
        a.factor(&self.holds);
        a.divide();
    }
}

/// Position and orientation.
type Pose = (DVec3, DQuat);

fn pose_of(body: &Body) -> Pose {
    (body.state.position, body.state.orientation)
}

/// Value and bias of a sum of rows.
fn course(rows: &[Row]) -> Course {
    Course {
        value: rows.iter().map(|row| row.value).sum(),
        bias: rows.iter().map(|row| row.bias).sum(),
        holds: !rows.is_empty(),
        rate: 0.0,
    }
}

/// Bodies that a joint touches, ascending; of a gear those of its joints.
fn bodies_of(joints: &Joints, j: usize) -> Vec<usize> {
    let mut bodies = match joints.model(j).kind {
        Kind::Gear { joints: two, .. } => two.map(|k| bodies_of(joints, k)).concat(),
        _ => joints.model(j).bodies.to_vec(),
    };
    bodies.sort_unstable();
    bodies.dedup();
    bodies
}
