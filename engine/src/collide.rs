//! The narrow phase over many pairs: the engine's own kernels, or an oracle (FCL).

use std::ops::Range;

use crate::approach::near_margin;
use crate::islands::index;
use crate::model::Geom;
use crate::narrowphase::{self, ContactPoint, Scratch};
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

/// Stands where no oracle is asked.
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
pub(crate) const STRETCH: usize = 64;

/// Runs jobs; keeps its working memory.
#[derive(Default)]
pub struct Detector {
    /// Those of the last run come first.
    stretches: Vec<Stretch>,
    used: usize,
    triangles: Vec<u32>,
    queries: Vec<Query>,
    asked_for: Vec<u32>,
    answers: Vec<Option<Answer>>,
}

/// Does a stretch of jobs.
#[derive(Default)]
pub(crate) struct Stretch {
    scratch: Scratch,
    points: Vec<ContactPoint>,
    /// Points of the last run, ordered by job.
    found: Vec<Found>,
    /// How many of them nearly touch.
    near: usize,
    /// Jobs that are left to FCL.
    unanswered: Vec<u32>,
}

impl Stretch {
    /// Do the jobs of these indices.
    fn run(&mut self, geoms: &[Geom], jobs: &[Job], range: Range<usize>, fcl_only: bool) {
        self.found.clear();
        self.near = 0;
        self.unanswered.clear();
        for (index, job) in (index(range.start)..).zip(&jobs[range]) {
            self.points.clear();
            if fcl_only {
                self.unanswered.push(index);
                continue;
            }
            let (a, b) = shapes(geoms, job);
            let ((pose_a, pose_b), margin) = (&job.poses, job.margin);
            let (scratch, points) = (&mut self.scratch, &mut self.points);
            narrowphase::collide(a, pose_a, b, pose_b, margin, scratch, points);
            self.keep(index, near_depth(geoms, job.geoms));
        }
    }

    /// The points at hand answer this job; from the depth `near` on they nearly touch.
    fn keep(&mut self, job: u32, near: f64) {
        for &point in &self.points {
            let near = point.depth > near;
            self.near += usize::from(near);
            self.found.push(Found { job, near, point });
        }
    }

    /// How many points nearly touch.
    pub(crate) fn near(&self) -> usize {
        self.near
    }

    /// Points, job by job.
    pub(crate) fn answers(&self) -> impl Iterator<Item = &[Found]> {
        self.found.chunk_by(|a, b| a.job == b.job)
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
    /// Answer all jobs.
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
        self.used = jobs.len().div_ceil(STRETCH);
        if self.stretches.len() < self.used {
            self.stretches.resize_with(self.used, Stretch::default);
        }
        let stretches = &mut self.stretches[..self.used];
        divide((stretches, 0..self.used), 1, &|(stretches, range): (
            &mut [Stretch],
            Range<usize>,
        )| {
            for (stretch, k) in stretches.iter_mut().zip(range) {
                let end = jobs.len().min((k + 1) * STRETCH);
                stretch.run(geoms, jobs, k * STRETCH..end, fcl_only);
            }
        });
        self.queries.clear();
        self.asked_for.clear();
        for k in 0..self.used {
            for n in 0..self.stretches[k].unanswered.len() {
                let index = self.stretches[k].unanswered[n];
                let job = &jobs[index as usize];
                self.enqueue(index, job, shapes(geoms, job));
            }
        }
        if self.queries.is_empty() {
            return Ok(());
        }
        self.consult(geoms, oracle)?;
        for stretch in &mut self.stretches[..self.used] {
            // Sorted by job, the points of a job in the order in which they were found: the sort is stable.
            stretch.found.sort_by_key(|f| f.job);
        }
        Ok(())
    }

    /// Jobs of the last run, stretch by stretch.
    pub(crate) fn stretches(&self) -> &[Stretch] {
        &self.stretches[..self.used]
    }

    /// Points of the last run, ordered by job.
    pub fn found(&self) -> impl Iterator<Item = &Found> {
        self.stretches().iter().flat_map(|stretch| &stretch.found)
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
            let stretch = &mut self.stretches[job as usize / STRETCH];
            stretch.points.clear();
            narrowphase::manifold(
                &geoms[a as usize].shape,
                &query.poses.0,
                &geoms[b as usize].shape,
                &query.poses.1,
                answer.normal,
                answer.position,
                query.margin,
                &mut stretch.scratch,
                &mut stretch.points,
            );
            stretch.keep(job, near_depth(geoms, query.geoms));
        }
        Ok(())
    }
}
