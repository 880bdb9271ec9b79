//! The narrow phase over many pairs: own kernels where they exist, an oracle (FCL) elsewhere.

use std::ops::Range;

use crate::approach::near_margin;
use crate::islands::index;
use crate::model::Geom;
use crate::narrowphase::{self, ContactPoint, Scratch, Verdict};
use crate::shape::{Pose, Shape};
use crate::team::divide;
use glam::DVec3;

/// A question to the oracle: how do these two geoms lie to each other?
#[derive(Clone, Copy, Debug)]
pub struct Query {
    /// Geoms A and B.
    pub geoms: (u32, u32),
    /// Triangle of an exact mesh, -1 for every other shape.
    pub triangles: (i32, i32),
    /// Poses of the geoms.
    pub poses: (Pose, Pose),
    /// Farther apart than this is of no interest [m].
    pub margin: f64,
}

/// The oracle's answer, where the geoms are nearer than the margin.
#[derive(Clone, Copy, Debug)]
pub struct Answer {
    /// Unit vector from B to A.
    pub normal: DVec3,
    /// Positive overlap [m].
    pub depth: f64,
    /// A point between the surfaces [m].
    pub position: DVec3,
}

/// Somebody who knows every pair of shapes.
pub trait Oracle: Send {
    /// Answer all queries, in order; `None` where the geoms are apart.
    ///
    /// # Errors
    /// A message when the oracle itself fails.
    fn ask(&mut self, queries: &[Query], answers: &mut Vec<Option<Answer>>) -> Result<(), String>;
}

/// Stands where every pair has a kernel.
pub struct NoOracle;

impl Oracle for NoOracle {
    fn ask(&mut self, _: &[Query], _: &mut Vec<Option<Answer>>) -> Result<(), String> {
        Err("a pair of shapes needs FCL, but no FCL callback was given".into())
    }
}

/// One pair to look at.
#[derive(Clone, Copy, Debug)]
pub struct Job {
    /// Geoms A and B.
    pub geoms: (u32, u32),
    /// Their poses.
    pub poses: (Pose, Pose),
    /// Points with a gap below this are wanted [m].
    pub margin: f64,
}

impl Job {
    /// Stands where no job is yet.
    pub const NONE: Self = Self {
        geoms: (0, 0),
        poses: (Pose::IDENTITY, Pose::IDENTITY),
        margin: 0.0,
    };
}

/// A contact point and the job that it answers.
#[derive(Clone, Copy, Debug)]
pub struct Found {
    /// Index of the job.
    pub job: u32,
    /// The point nearly touches.
    pub near: bool,
    /// The point.
    pub point: ContactPoint,
}

/// Jobs that are done at a stretch.
const STRETCH: usize = 64;

/// Runs jobs; keeps its working memory.
#[derive(Default)]
pub struct Detector {
    /// One for each stretch of jobs.
    probes: Vec<Probe>,
    scratch: Scratch,
    points: Vec<ContactPoint>,
    triangles: Vec<u32>,
    queries: Vec<Query>,
    asked_for: Vec<u32>,
    answers: Vec<Option<Answer>>,
    /// Points of the last run, ordered by job.
    pub found: Vec<Found>,
}

/// Does a stretch of jobs.
#[derive(Default)]
struct Probe {
    scratch: Scratch,
    points: Vec<ContactPoint>,
    found: Vec<Found>,
    /// Jobs that are left to FCL.
    unanswered: Vec<u32>,
}

impl Probe {
    /// Do the jobs of these indices.
    fn run(&mut self, geoms: &[Geom], jobs: &[Job], range: Range<usize>, fcl_only: bool) {
        self.found.clear();
        self.unanswered.clear();
        for (index, job) in (index(range.start)..).zip(&jobs[range]) {
            self.points.clear();
            let verdict = if fcl_only {
                Verdict::AskFcl
            } else {
                let (a, b) = shapes(geoms, job);
                let ((pose_a, pose_b), margin) = (&job.poses, job.margin);
                let (scratch, points) = (&mut self.scratch, &mut self.points);
                narrowphase::collide(a, pose_a, b, pose_b, margin, scratch, points)
            };
            match verdict {
                Verdict::Answered => {
                    let (near, points) = (near_depth(geoms, job.geoms), self.points.iter());
                    self.found
                        .extend(points.map(|&point| Found::new(index, near, point)));
                }
                Verdict::AskFcl => self.unanswered.push(index),
            }
        }
    }
}

impl Found {
    /// Nearly touching from the depth `near` on.
    fn new(job: u32, near: f64, point: ContactPoint) -> Self {
        Self {
            job,
            near: point.depth > near,
            point,
        }
    }
}

fn near_depth(geoms: &[Geom], (a, b): (u32, u32)) -> f64 {
    -near_margin(&geoms[a as usize], &geoms[b as usize])
}

fn shapes<'a>(geoms: &'a [Geom], job: &Job) -> (&'a Shape, &'a Shape) {
    (
        &geoms[job.geoms.0 as usize].shape,
        &geoms[job.geoms.1 as usize].shape,
    )
}

impl Detector {
    /// Answer all jobs into `self.found`.
    ///
    /// # Errors
    /// The oracle's message.
    pub fn run(
        &mut self,
        geoms: &[Geom],
        jobs: &[Job],
        fcl_only: bool,
        oracle: &mut dyn Oracle,
    ) -> Result<(), String> {
        self.found.clear();
        self.queries.clear();
        self.asked_for.clear();
        let stretches = jobs.len().div_ceil(STRETCH);
        if self.probes.len() < stretches {
            self.probes.resize_with(stretches, Probe::default);
        }
        let probes = &mut self.probes[..stretches];
        divide((probes, 0..stretches), 1, &|(probes, range): (
            &mut [Probe],
            Range<usize>,
        )| {
            for (probe, k) in probes.iter_mut().zip(range) {
                let end = jobs.len().min((k + 1) * STRETCH);
                probe.run(geoms, jobs, k * STRETCH..end, fcl_only);
            }
        });
        for k in 0..stretches {
            self.found.extend_from_slice(&self.probes[k].found);
            for n in 0..self.probes[k].unanswered.len() {
                let index = self.probes[k].unanswered[n];
                let job = &jobs[index as usize];
                self.enqueue(index, job, shapes(geoms, job));
            }
        }
        if self.queries.is_empty() {
            return Ok(());
        }
        self.consult(geoms, oracle)?;
        // Sorted by job, the points of a job in the order in which they were found: the sort is stable.
        self.found.sort_by_key(|f| f.job);
        Ok(())
    }

    /// A mesh is asked for triangle by triangle: only there do depth and normal mean something.
    fn enqueue(&mut self, index: u32, job: &Job, shapes: (&Shape, &Shape)) {
        let query = Query {
            geoms: job.geoms,
            triangles: (-1, -1),
            poses: job.poses,
            margin: job.margin,
        };
        let (mesh, other, poses, mesh_first) = match shapes {
            (Shape::Mesh(mesh), other) => (mesh, other, (&job.poses.0, &job.poses.1), true),
            (other, Shape::Mesh(mesh)) => (mesh, other, (&job.poses.1, &job.poses.0), false),
            _ => {
                self.asked_for.push(index);
                self.queries.push(query);
                return;
            }
        };
        let reach = other.aabb(&poses.0.relative(poses.1)).expanded(job.margin);
        self.triangles.clear();
        mesh.overlapping(&reach, &mut self.triangles);
        for &t in &self.triangles {
            #[allow(clippy::cast_possible_wrap)]
            let t = t as i32;
            let triangles = if mesh_first { (t, -1) } else { (-1, t) };
            self.asked_for.push(index);
            self.queries.push(Query { triangles, ..query });
        }
    }

    /// Ask the oracle, and build whole manifolds from its normals. Of an exact mesh it says which triangles are near;
    /// the contact is then that of the whole surface, whose inner edges are no edges.
    fn consult(&mut self, geoms: &[Geom], oracle: &mut dyn Oracle) -> Result<(), String> {
        self.answers.clear();
        oracle.ask(&self.queries, &mut self.answers)?;
        if self.answers.len() != self.queries.len() {
            return Err("FCL answered another number of pairs than it was asked".into());
        }
        let mut answered = None;
        for ((query, answer), &job) in self.queries.iter().zip(&self.answers).zip(&self.asked_for) {
            let Some(answer) = answer else { continue };
            if answered == Some(job) {
                continue;
            }
            answered = Some(job);
            let (a, b) = query.geoms;
            self.points.clear();
            narrowphase::manifold(
                &geoms[a as usize].shape,
                &query.poses.0,
                &geoms[b as usize].shape,
                &query.poses.1,
                answer.normal,
                answer.position,
                query.margin,
                &mut self.scratch,
                &mut self.points,
            );
            let near = near_depth(geoms, query.geoms);
            self.found.extend(
                self.points
                    .iter()
                    .map(|&point| Found::new(job, near, point)),
            );
        }
        Ok(())
    }
}
