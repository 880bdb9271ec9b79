//! Which pairs of geoms may touch: sweep and prune along one axis (Baraff 1992).

use std::collections::HashSet;

use crate::model::Geom;
use crate::shape::{Aabb, Shape};

/// Finds pairs of overlapping boxes. Keeps its working memory from step to step.
#[derive(Clone, Debug, Default)]
pub struct Broadphase {
    /// Geoms that are sorted and swept.
    swept: Vec<u32>,
    /// Geoms without bounds, tested against every other.
    unbounded: Vec<u32>,
    excluded: HashSet<(u32, u32)>,
}

impl Broadphase {
    /// `no_contact` are pairs of bodies.
    #[must_use]
    pub fn new(geoms: &[Geom], no_contact: &[(usize, usize)]) -> Self {
        let mut out = Self::default();
        for (index, geom) in (0u32..).zip(geoms) {
            match geom.shape {
                Shape::HalfSpace => out.unbounded.push(index),
                _ => out.swept.push(index),
            }
        }
        for &(a, b) in no_contact {
            #[allow(clippy::cast_possible_truncation)]
            out.excluded.insert((a.min(b) as u32, a.max(b) as u32));
        }
        out
    }

    /// Fill `out` with the pairs (a < b) of geoms whose boxes overlap, sorted. `movable` says which bodies can move.
    pub fn pairs(
        &mut self,
        geoms: &[Geom],
        boxes: &[Aabb],
        movable: impl Fn(usize) -> bool,
        out: &mut Vec<(u32, u32)>,
    ) {
        out.clear();
        // Nearly sorted from the step before, where the merge sort of the standard library is linear. Ties are broken
        // by index, so that the order depends on the positions alone and a resumed run finds the same pairs.
        self.swept.sort_by(|&i, &j| {
            let (a, b) = (boxes[i as usize].min.x, boxes[j as usize].min.x);
            a.total_cmp(&b).then(i.cmp(&j))
        });
        for (k, &i) in self.swept.iter().enumerate() {
            let a = &boxes[i as usize];
            for &j in &self.swept[k + 1..] {
                let b = &boxes[j as usize];
                if b.min.x > a.max.x {
                    break;
                }
                if a.overlaps(b) {
                    self.admit(geoms, i, j, &movable, out);
                }
            }
            for &j in &self.unbounded {
                self.admit(geoms, i, j, &movable, out);
            }
        }
        out.sort_unstable();
    }

    fn admit(
        &self,
        geoms: &[Geom],
        i: u32,
        j: u32,
        movable: &impl Fn(usize) -> bool,
        out: &mut Vec<(u32, u32)>,
    ) {
        if self.may_touch(geoms, i, j, movable) {
            out.push((i.min(j), i.max(j)));
        }
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
