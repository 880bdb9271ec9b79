//! Which pairs of geoms may touch.
//!
//! Geoms are listed as neighbours while their enlarged boxes overlap, and the list is kept from step to step: as long as
//! every box stays inside its enlarged one, only neighbours can overlap. When one leaves, all are enlarged and listed
//! anew: boxes are put into the columns of a grid, and each column is swept along x (Baraff 1992). What `pairs` finds is
//! told by the boxes of now alone, so that a resumed run finds the same.

use std::collections::HashSet;

use glam::DVec3;

use crate::model::Geom;
use crate::shape::{Aabb, Pose, Shape};
use crate::team::{fill, gather, HANDFUL};

/// Boxes are enlarged by this part of their mean extent, and by what they grew for `HEADWAY` steps more.
const SLACK: f64 = 0.1;
const HEADWAY: f64 = 2.0;
/// Columns that a box may be put into; larger ones are tested against all others.
const SPREAD: usize = 64;
/// Columns have this many mean extents of a box.
const WIDTH: f64 = 2.0;

/// Where the geoms are, and what their boxes grew by.
pub struct Places<'a> {
    /// All geoms.
    pub geoms: &'a [Geom],
    /// Their poses.
    pub poses: &'a [Pose],
    /// Boxes that contain all that may matter of them in the step.
    pub boxes: &'a [Aabb],
    /// What each body may travel in the step [m].
    pub travels: &'a [f64],
}

/// Finds pairs of overlapping boxes. Keeps its neighbours and its working memory from step to step.
#[derive(Clone, Debug, Default)]
pub struct Broadphase {
    /// Geoms without bounds.
    unbounded: Vec<u32>,
    bounded: Vec<u32>,
    excluded: HashSet<(u32, u32)>,
    enlarged: Vec<Aabb>,
    /// Pairs (a < b) whose enlarged boxes overlap, sorted.
    neighbours: Vec<(u32, u32)>,
    /// Of each pair of neighbours: the boxes of now overlap.
    meets: Vec<bool>,
    columns: Columns,
}

impl Broadphase {
    /// `no_contact` are pairs of bodies.
    #[must_use]
    pub fn new(geoms: &[Geom], no_contact: &[(usize, usize)]) -> Self {
        let mut out = Self::default();
        for (index, geom) in (0u32..).zip(geoms) {
            match geom.shape {
                Shape::HalfSpace => out.unbounded.push(index),
                _ => out.bounded.push(index),
            }
        }
        for &(a, b) in no_contact {
            #[allow(clippy::cast_possible_truncation)]
            out.excluded.insert((a.min(b) as u32, a.max(b) as u32));
        }
        out
    }

    /// Fill `out` with the pairs (a < b) of geoms whose boxes overlap, or a half-space, sorted. `movable` says which
    /// bodies can move.
    pub fn pairs(
        &mut self,
        places: &Places,
        movable: impl Fn(usize) -> bool,
        out: &mut Vec<(u32, u32)>,
    ) {
        if self.has_left(places.boxes) {
            self.enlarge(places);
            self.list_neighbours(places, movable);
        }
        let neighbours = &self.neighbours;
        fill(&mut self.meets, (neighbours.len(), false), &|k| {
            places.meet(neighbours[k])
        });
        out.clear();
        let near = neighbours.iter().zip(&self.meets).filter(|(_, &meet)| meet);
        out.extend(near.map(|(&pair, _)| pair));
    }

    /// A box is not inside its enlarged one.
    fn has_left(&self, boxes: &[Aabb]) -> bool {
        let inside = |&k: &u32| self.enlarged[k as usize].contains(&boxes[k as usize]);
        let all_inside = |part: &[u32]| part.iter().all(inside);
        self.enlarged.len() != boxes.len()
            || !gather(&self.bounded[..], HANDFUL, &all_inside, &|a, b| a && b)
    }

    fn enlarge(&mut self, places: &Places) {
        let grown = places.boxes.iter().zip(places.geoms).map(|(aabb, geom)| {
            let mean = aabb.extent().element_sum() / 3.0;
            aabb.expanded(SLACK * mean + HEADWAY * places.travels[geom.body])
        });
        self.enlarged.clear();
        self.enlarged.extend(grown);
    }

    fn list_neighbours(&mut self, places: &Places, movable: impl Fn(usize) -> bool) {
        let mut found = std::mem::take(&mut self.neighbours);
        let mut columns = std::mem::take(&mut self.columns);
        found.clear();
        let mut admit = |i: u32, j: u32| {
            if self.may_touch(places.geoms, i, j, &movable) {
                found.push((i.min(j), i.max(j)));
            }
        };
        for &i in &self.bounded {
            self.unbounded.iter().for_each(|&j| admit(i, j));
        }
        columns.sweep(&self.bounded, &self.enlarged, admit);
        self.columns = columns;
        found.sort_unstable();
        self.neighbours = found;
    }

    /// Different bodies, at least one of which moves, and nobody said that they do not touch.
    pub fn may_touch(
        &self,
        geoms: &[Geom],
        i: u32,
        j: u32,
        movable: &impl Fn(usize) -> bool,
    ) -> bool {
        let (a, b) = (geoms[i as usize].body, geoms[j as usize].body);
        #[allow(clippy::cast_possible_truncation)]
        let key = (a.min(b) as u32, a.max(b) as u32);
        a != b
            && (movable(a) || movable(b))
            && (self.excluded.is_empty() || !self.excluded.contains(&key))
    }
}

impl Places<'_> {
    /// Two boxes overlap, or a box and what a half-space may reach.
    fn meet(&self, (i, j): (u32, u32)) -> bool {
        let is_half_space = |k: u32| matches!(self.geoms[k as usize].shape, Shape::HalfSpace);
        match (is_half_space(i), is_half_space(j)) {
            (false, false) => self.boxes[i as usize].overlaps(&self.boxes[j as usize]),
            (true, false) => self.reaches(i, j),
            (false, true) => self.reaches(j, i),
            (true, true) => false,
        }
    }

    /// The corner of a box that is deepest in a half-space is no farther from it than the half-space travels. What is not
    /// a number is looked at.
    fn reaches(&self, half_space: u32, other: u32) -> bool {
        let (plane, aabb) = (
            &self.poses[half_space as usize],
            &self.boxes[other as usize],
        );
        let normal = plane.rotation.z_axis;
        let middle = normal.dot(aabb.center() - plane.position);
        let height = middle - 0.5 * normal.abs().dot(aabb.extent());
        let apart = height > self.travels[self.geoms[half_space as usize].body];
        !apart
    }
}

/// A grid of columns along x.
#[derive(Clone, Debug, Default)]
struct Columns {
    /// Column, lower end along x, and geom.
    entries: Vec<(u32, f64, u32)>,
    /// In more columns than it is worth.
    large: Vec<u32>,
    boxes: Vec<Aabb>,
}

/// What divides y and z into columns.
struct Grid {
    origin: DVec3,
    width: f64,
    across: u32,
    up: u32,
}

impl Columns {
    /// Tell every pair of overlapping boxes of the listed ones once.
    fn sweep(&mut self, listed: &[u32], boxes: &[Aabb], mut found: impl FnMut(u32, u32)) {
        let Some(grid) = Grid::around(listed, boxes) else {
            return;
        };
        self.fill(&grid, listed, boxes);
        for (column, entries) in self
            .entries
            .chunk_by(|a, b| a.0 == b.0)
            .map(|e| (e[0].0, e))
        {
            self.boxes.clear();
            let of = entries.iter().map(|entry| boxes[entry.2 as usize]);
            self.boxes.extend(of);
            for (k, a) in self.boxes.iter().enumerate() {
                let later = self.boxes[k + 1..].iter().zip(&entries[k + 1..]);
                for (b, entry) in later.take_while(|(b, _)| b.min.x <= a.max.x) {
                    // Boxes that share several columns are told in the one with their common lower corner.
                    if a.overlaps(b) && grid.column(a.min.max(b.min)) == column {
                        found(entries[k].2, entry.2);
                    }
                }
            }
        }
        self.sweep_large(listed, boxes, found);
    }

    fn fill(&mut self, grid: &Grid, listed: &[u32], boxes: &[Aabb]) {
        self.entries.clear();
        self.large.clear();
        for &k in listed {
            let aabb = &boxes[k as usize];
            let (low, high) = (grid.cell(aabb.min), grid.cell(aabb.max));
            let count = (high.0 - low.0 + 1) as usize * (high.1 - low.1 + 1) as usize;
            if count > SPREAD {
                self.large.push(k);
                continue;
            }
            for up in low.1..=high.1 {
                for across in low.0..=high.0 {
                    let column = up * grid.across + across;
                    self.entries.push((column, aabb.min.x, k));
                }
            }
        }
        // Ties are broken by index, so that nothing depends on an order of before.
        self.entries.sort_unstable_by(|a, b| {
            (a.0.cmp(&b.0))
                .then(a.1.total_cmp(&b.1))
                .then(a.2.cmp(&b.2))
        });
    }

    fn sweep_large(&self, listed: &[u32], boxes: &[Aabb], mut found: impl FnMut(u32, u32)) {
        for &i in &self.large {
            for &j in listed {
                let twice = j <= i && self.large.binary_search(&j).is_ok();
                if !twice && boxes[i as usize].overlaps(&boxes[j as usize]) {
                    found(i, j);
                }
            }
        }
    }
}

impl Grid {
    /// Around all boxes with finite corners; None when there are none. As many columns as boxes at most.
    fn around(listed: &[u32], boxes: &[Aabb]) -> Option<Self> {
        let all = || listed.iter().map(|&k| &boxes[k as usize]);
        let finite = || all().filter(|b| b.min.is_finite() && b.max.is_finite());
        let count = finite().count();
        let whole = finite().fold(Aabb::EMPTY, |sum, b| sum.union(*b));
        if count == 0 {
            return None;
        }
        let mean = finite().map(|b| b.extent().element_sum()).sum::<f64>() / (3.0 * count as f64);
        let size = whole.extent();
        let least = (size.y * size.z / count as f64).sqrt();
        let width = (WIDTH * mean)
            .max(least)
            .max(size.max_element() / 1e4)
            .max(1e-12);
        let columns = |length: f64| (length / width) as u32 + 1;
        Some(Self {
            origin: whole.min,
            width,
            across: columns(size.y),
            up: columns(size.z),
        })
    }

    /// Along y and z; what lies outside belongs to the columns at the rim.
    fn cell(&self, p: DVec3) -> (u32, u32) {
        let along =
            |x: f64, from: f64, count: u32| (((x - from) / self.width) as u32).min(count - 1);
        (
            along(p.y, self.origin.y, self.across),
            along(p.z, self.origin.z, self.up),
        )
    }

    fn column(&self, p: DVec3) -> u32 {
        let (across, up) = self.cell(p);
        up * self.across + across
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::narrowphase::testing::Random;
    use glam::DMat3;

    const REACH: f64 = 0.1;

    fn ball(body: usize, radius: f64) -> Geom {
        Geom {
            body,
            shape: Shape::Sphere { radius },
            position: DVec3::ZERO,
            rotation: DMat3::IDENTITY,
            material: 0,
        }
    }

    fn pose(position: DVec3) -> Pose {
        Pose {
            position,
            ..Pose::IDENTITY
        }
    }

    fn vector(random: &mut Random) -> DVec3 {
        DVec3::new(random.next(), random.next(), random.next())
    }

    /// Every pair by brute force.
    fn expected(geoms: &[Geom], poses: &[Pose], boxes: &[Aabb]) -> Vec<(u32, u32)> {
        let plane = geoms.len() - 1;
        let mut out = Vec::new();
        for i in 0..plane {
            for j in i + 1..plane {
                if boxes[i].overlaps(&boxes[j]) && !(i % 7 == 0 && j % 7 == 0) {
                    out.push((i as u32, j as u32));
                }
            }
            if i % 7 != 0 && boxes[i].min.z <= poses[plane].position.z {
                out.push((i as u32, plane as u32));
            }
        }
        out
    }

    /// Balls of very different sizes that wander, slowly and then far, over a plane; every seventh is fixed.
    #[test]
    fn finds_what_brute_force_finds_while_everything_moves() {
        let mut random = Random(5);
        let mut geoms: Vec<Geom> = (0..300)
            .map(|k| {
                ball(
                    k,
                    REACH * (0.2 + (k % 5) as f64) * if k % 97 == 0 { 30.0 } else { 1.0 },
                )
            })
            .collect();
        geoms.push(Geom {
            shape: Shape::HalfSpace,
            ..ball(300, 0.0)
        });
        let mut places: Vec<DVec3> = geoms.iter().map(|_| 3.0 * vector(&mut random)).collect();
        let travels = vec![0.0; geoms.len()];
        let mut broadphase = Broadphase::new(&geoms, &[]);
        let (mut found, mut kept) = (Vec::new(), 0);
        for step in 0..200 {
            let far = if step % 50 == 49 { 1.0 } else { 2e-3 };
            places
                .iter_mut()
                .for_each(|p| *p += far * vector(&mut random));
            let poses: Vec<Pose> = places.iter().map(|p| pose(*p)).collect();
            let of = geoms.iter().zip(&poses).map(|(g, p)| g.shape.aabb(p));
            let boxes: Vec<Aabb> = of.collect();
            let before = broadphase.enlarged.first().map(|b| b.min);
            let now = Places {
                geoms: &geoms,
                poses: &poses,
                boxes: &boxes,
                travels: &travels,
            };
            broadphase.pairs(&now, |k| k % 7 != 0 && k != 300, &mut found);
            assert_eq!(found, expected(&geoms, &poses, &boxes), "step {step}");
            kept += i32::from(before == broadphase.enlarged.first().map(|b| b.min));
        }
        assert!(kept > 50, "neighbours were kept in {kept} steps");
    }
}
