//! Islands laid out for solving: contacts and bodies of an island side by side, and great islands in parts.
//!
//! An island of many contacts is cut in two where it is longest across the direction of loads, which sweeps follow best
//! from end to end, and each part again. Contacts between the two
//! are kept apart: the parts then have no moving body in common and can be swept at once, each as if it were alone,
//! before the contacts that lie between them (nested dissection: George 1973). How an island is cut depends on where its
//! bodies are and on nothing else.

use std::ops::Range;

use glam::DVec3;

use crate::islands::Islands;
use crate::mover::Window;
use crate::team::both;

/// Contacts of a part that is not cut again.
const WHOLE: usize = 800;

/// An island without joints: where its contacts, bodies and parts are.
#[derive(Clone, Debug)]
pub(crate) struct Block {
    pub(crate) points: Range<usize>,
    pub(crate) movers: Range<usize>,
    pub(crate) parts: Range<usize>,
}

/// How many contacts and bodies the two halves of a part have; the rest of its contacts lie between them. A part
/// that is not cut has no halves. The first half follows its part, the second one is farther on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Layer {
    pub(crate) points: (usize, usize),
    movers: usize,
    pub(crate) second: usize,
}

impl Layer {
    /// A part that is not cut.
    pub(crate) const WHOLE: Self = Self {
        points: (0, 0),
        movers: 0,
        second: 0,
    };
}

/// Working memory of the division, and its result.
#[derive(Clone, Debug, Default)]
pub(crate) struct Layout {
    /// Contact in each place, and where its bodies are within its block.
    pub(crate) contacts: Vec<u32>,
    pub(crate) ends: Vec<(u32, u32)>,
    /// Body in each place, block by block; those that are fixed are repeated in every part that touches them.
    pub(crate) bodies: Vec<u32>,
    pub(crate) blocks: Vec<Block>,
    pub(crate) parts: Vec<Layer>,
    /// Place of each body; of a fixed one, in the part at hand.
    places: Vec<u32>,
    /// Moving bodies of the islands as they are being cut, and the half that each body went to.
    cut: Vec<u32>,
    second: Vec<bool>,
    scratch: (Vec<u32>, Vec<u32>),
}

/// What is laid out.
#[derive(Clone, Copy)]
pub(crate) struct Plan<'a> {
    pub(crate) pairs: &'a [(u32, u32)],
    /// Of each body [m].
    pub(crate) centres: &'a [DVec3],
    /// Where loads point, of any length.
    pub(crate) down: DVec3,
    /// Bodies that connect nothing.
    pub(crate) fixed: &'a [bool],
}

impl Layout {
    /// It does not depend on where bodies are.
    pub(crate) fn is_uncut(&self) -> bool {
        self.parts.len() == self.blocks.len()
    }

    /// Lay out the islands that have no joints.
    pub(crate) fn arrange(&mut self, islands: &Islands, plan: Plan) {
        self.contacts.clone_from(&islands.contacts.members);
        self.cut.clone_from(&islands.bodies.members);
        self.places.resize(plan.centres.len(), 0);
        self.second.resize(plan.centres.len(), false);
        self.ends.clear();
        self.bodies.clear();
        self.blocks.clear();
        self.parts.clear();
        for island in 0..islands.count().1 {
            let points = islands.contacts.range(island);
            let (movers, parts) = (self.bodies.len(), self.parts.len());
            self.part(&plan, islands.bodies.range(island), points.clone(), movers);
            self.blocks.push(Block {
                points,
                movers: movers..self.bodies.len(),
                parts: parts..self.parts.len(),
            });
        }
        let jointed = self.contacts[self.ends.len()..].iter();
        let pairs = jointed.map(|&k| plan.pairs[k as usize]);
        self.ends.extend(pairs);
    }

    /// One part of the block whose bodies begin at `base`.
    fn part(&mut self, plan: &Plan, bodies: Range<usize>, points: Range<usize>, base: usize) {
        let this = self.parts.len();
        self.parts.push(Layer::WHOLE);
        let Some((half, first, second)) = self.halves(plan, &bodies, &points) else {
            return self.lay_out_whole(plan, &bodies, &points, base);
        };
        let (middle, own) = (points.start + first, points.start + first + second);
        let start = self.bodies.len();
        self.part(plan, bodies.start..half, points.start..middle, base);
        let (movers, later) = (self.bodies.len() - start, self.parts.len() - this);
        self.part(plan, half..bodies.end, middle..own, base);
        self.parts[this] = Layer {
            points: (first, second),
            movers,
            second: later,
        };
        self.place_ends(plan, own..points.end, base);
    }

    /// Cut a part: bodies along the longest extent, contacts into those of the first half, those of the second, and
    /// those between them. Returns where the second half's bodies begin, and how many contacts the halves have; None
    /// where it is not worth it, everything then as it was.
    fn halves(
        &mut self,
        plan: &Plan,
        bodies: &Range<usize>,
        points: &Range<usize>,
    ) -> Option<(usize, usize, usize)> {
        if points.len() <= WHOLE || bodies.len() < 2 {
            return None;
        }
        let half = bodies.len() / 2;
        let list = &mut self.cut[bodies.clone()];
        let axis = longest_extent(list, plan);
        let along = |k: u32| plan.centres[k as usize].dot(axis);
        list.select_nth_unstable_by(half, |&a, &b| along(a).total_cmp(&along(b)).then(a.cmp(&b)));
        for (place, &body) in list.iter().enumerate() {
            self.second[body as usize] = place >= half;
        }
        let counts = self.sort_contacts(plan, points.clone());
        if points.len() - counts.0 - counts.1 > points.len() / 3 {
            self.contacts[points.clone()].sort_unstable();
            return None;
        }
        Some((bodies.start + half, counts.0, counts.1))
    }

    /// Contacts of the first half, of the second, and those between them, each in their order.
    fn sort_contacts(&mut self, plan: &Plan, points: Range<usize>) -> (usize, usize) {
        let second = &self.second;
        let home = |k: u32| {
            let (a, b) = plan.pairs[k as usize];
            let (in_a, in_b) = (second[a as usize], second[b as usize]);
            match (plan.fixed[a as usize], plan.fixed[b as usize]) {
                (true, _) => usize::from(in_b),
                (_, true) => usize::from(in_a),
                _ if in_a == in_b => usize::from(in_a),
                _ => 2,
            }
        };
        let list = &mut self.contacts[points];
        let mut first = 0;
        self.scratch.0.clear();
        self.scratch.1.clear();
        for place in 0..list.len() {
            let k = list[place];
            match home(k) {
                0 => {
                    list[first] = k;
                    first += 1;
                }
                1 => self.scratch.0.push(k),
                _ => self.scratch.1.push(k),
            }
        }
        let (others, between) = (&self.scratch.0, &self.scratch.1);
        let own = first + others.len();
        list[first..own].copy_from_slice(others);
        list[own..].copy_from_slice(between);
        (first, others.len())
    }

    /// Bodies in ascending order, and behind them the fixed ones that they touch.
    fn lay_out_whole(
        &mut self,
        plan: &Plan,
        bodies: &Range<usize>,
        points: &Range<usize>,
        base: usize,
    ) {
        self.cut[bodies.clone()].sort_unstable();
        let first = self.bodies.len();
        for k in bodies.clone() {
            self.place(self.cut[k]);
        }
        for slot in points.clone() {
            let (a, b) = plan.pairs[self.contacts[slot] as usize];
            for body in [a, b].into_iter().filter(|&k| plan.fixed[k as usize]) {
                let known = self.places[body as usize] as usize;
                if known < first || self.bodies.get(known) != Some(&body) {
                    self.place(body);
                }
            }
        }
        self.place_ends(plan, points.clone(), base);
    }

    #[allow(clippy::cast_possible_truncation)]
    fn place(&mut self, body: u32) {
        self.places[body as usize] = self.bodies.len() as u32;
        self.bodies.push(body);
    }

    #[allow(clippy::cast_possible_truncation)]
    fn place_ends(&mut self, plan: &Plan, points: Range<usize>, base: usize) {
        self.ends.resize(self.ends.len().max(points.end), (0, 0));
        let place = |k: u32| self.places[k as usize] - base as u32;
        for slot in points {
            let (a, b) = plan.pairs[self.contacts[slot] as usize];
            self.ends[slot] = (place(a), place(b));
        }
    }
}

/// The axis along which these bodies are farthest apart, of those across the loads.
fn longest_extent(bodies: &[u32], plan: &Plan) -> DVec3 {
    let ends = bodies
        .iter()
        .fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), &k| {
            let x = plan.centres[k as usize];
            (low.min(x), high.max(x))
        });
    let mut extent = ends.1 - ends.0;
    if plan.down != DVec3::ZERO {
        extent[plan.down.abs().max_position()] = 0.0;
    }
    DVec3::AXES[extent.max_position()]
}

/// Visit the lists of a part, forwards or backwards, its halves at once; returns the greatest of what the visits
/// return.
pub(crate) fn visit<T: Send, B: Send>(
    parts: &[Layer],
    list: &mut [T],
    mut movers: Window<B>,
    backwards: bool,
    one: &(impl Fn(&mut [T], &mut Window<B>) -> f64 + Sync),
) -> f64 {
    let part = parts[0];
    let (halves, own) = list.split_at_mut(part.points.0 + part.points.1);
    let before = if backwards {
        one(own, &mut movers)
    } else {
        0.0
    };
    let mut worst = before;
    if part.second > 0 {
        let (a, b) = halves.split_at_mut(part.points.0);
        let (of_a, of_b) = movers.halves(part.movers);
        let (a, b) = both(
            || visit(&parts[1..], a, of_a, backwards, one),
            || visit(&parts[part.second..], b, of_b, backwards, one),
        );
        worst = worst.max(a).max(b);
    }
    if !backwards {
        worst = worst.max(one(own, &mut movers));
    }
    worst
}
