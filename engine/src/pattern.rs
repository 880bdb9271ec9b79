//! What Cholesky's factor of a matrix with a block for each body and for each pair in contact looks like.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::islands::index;
use crate::mover::Mover;
use crate::point::Point;

/// Which bodies meet, and what Cholesky's factor of their matrix looks like.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pattern {
    /// Pairs of bodies in contact, as they came: the pattern is good as long as they are the same, and the same of them move.
    pairs: Vec<(u32, u32)>,
    /// Bodies that move, in the order of elimination.
    pub(crate) order: Vec<u32>,
    /// Place of each body in that order, or `FIXED`.
    pub(crate) places: Vec<u32>,
    /// Products of blocks in a factorisation; more than were allowed where it was given up.
    pub(crate) products: usize,
    /// It was not given up.
    complete: bool,
    /// Rows below the diagonal, column by column.
    pub(crate) starts: Vec<usize>,
    pub(crate) rows: Vec<u32>,
    /// Working memory: of each body that moves, those that touch it.
    neighbours: Vec<Vec<u32>>,
}

/// Place of a body that does not move.
pub(crate) const FIXED: u32 = u32::MAX;

impl Pattern {
    /// Of these contacts; false where a factorisation would take more than so many products of blocks.
    pub(crate) fn load(&mut self, points: &[Point], movers: &[Mover], products: usize) -> bool {
        let same = self.places.len() == movers.len()
            && self.pairs.len() == points.len()
            && self.pairs.iter().zip(points).all(|(&(a, b), p)| {
                (a, b) == p.bodies && self.knows(a, movers) && self.knows(b, movers)
            });
        let known = self.complete || self.products > products;
        if !(same && known) {
            self.pairs.clear();
            self.pairs.extend(points.iter().map(|p| p.bodies));
            let mut neighbours = std::mem::take(&mut self.neighbours);
            self.graph(movers, &mut neighbours);
            self.eliminate(&mut neighbours, products);
            self.neighbours = neighbours;
        }
        let whole = |&k: &u32| has_inertia(&movers[k as usize]);
        self.products <= products && self.order.iter().all(whole)
    }

    /// A body of the pattern moves, or does not, as it did when the pattern was made.
    fn knows(&self, body: u32, movers: &[Mover]) -> bool {
        let moves = movers[body as usize].inverse_mass != 0.0;
        moves == (self.places[body as usize] != FIXED)
    }

    /// Moving bodies that touch each one, by the order in which contacts name them; `order` tells who they are. Lists
    /// behind theirs are left empty.
    fn graph(&mut self, movers: &[Mover], neighbours: &mut Vec<Vec<u32>>) {
        neighbours.iter_mut().for_each(Vec::clear);
        if self.places.len() == movers.len() {
            for &body in &self.order {
                self.places[body as usize] = FIXED;
            }
        } else {
            self.places.clear();
            self.places.resize(movers.len(), FIXED);
        }
        self.order.clear();
        let moves = |k: u32| movers[k as usize].inverse_mass != 0.0;
        for &(a, b) in &self.pairs {
            for k in [a, b] {
                if moves(k) && self.places[k as usize] == FIXED {
                    self.places[k as usize] = index(self.order.len());
                    self.order.push(k);
                }
            }
            if neighbours.len() < self.order.len() {
                neighbours.resize_with(self.order.len(), Vec::new);
            }
            if moves(a) && moves(b) {
                let (a, b) = (self.places[a as usize], self.places[b as usize]);
                neighbours[a as usize].push(b);
                neighbours[b as usize].push(a);
            }
        }
        for list in neighbours {
            list.sort_unstable();
            list.dedup();
        }
    }

    /// Bodies of least degree first (Tinney & Walker 1967); the neighbours that an eliminated body leaves behind then
    /// touch one another. Stops where it takes more than so many products: whatever the order, where every body left
    /// touches d others, one at least is eliminated with d neighbours, and these, which then touch one another, after it.
    fn eliminate(&mut self, neighbours: &mut [Vec<u32>], products: usize) {
        let bodies = self.order.len();
        let mut queue: BinaryHeap<Reverse<(usize, u32)>> = (0..)
            .zip(&neighbours[..bodies])
            .map(|(k, list)| Reverse((list.len(), k)))
            .collect();
        let mut turn = vec![FIXED; bodies];
        let mut sequence: Vec<u32> = Vec::with_capacity(bodies);
        // Of each body, whose neighbour it was found to be last.
        let mut near = vec![FIXED; bodies];
        let mut made = 0;
        self.complete = false;
        self.starts.clear();
        self.rows.clear();
        self.starts.push(0);
        while let Some(Reverse((degree, k))) = queue.pop() {
            if turn[k as usize] != FIXED || neighbours[k as usize].len() != degree {
                continue; // an entry from before its degree changed
            }
            self.products = made + products_down_from(degree);
            if self.products > products {
                return;
            }
            made += degree * (degree + 3) / 2;
            turn[k as usize] = index(sequence.len());
            sequence.push(k);
            let clique = std::mem::take(&mut neighbours[k as usize]);
            near[k as usize] = k;
            clique.iter().for_each(|&i| near[i as usize] = k);
            for &i in &clique {
                let list = &mut neighbours[i as usize];
                list.retain(|&j| near[j as usize] != k);
                list.extend(clique.iter().filter(|&&j| j != i));
                queue.push(Reverse((list.len(), i)));
            }
            self.rows.extend_from_slice(&clique);
            self.starts.push(self.rows.len());
            neighbours[k as usize] = clique;
        }
        self.products = made;
        self.number(&turn, &sequence);
        self.complete = true;
    }

    /// Rows and bodies by their turn in the elimination, instead of as `graph` found them.
    fn number(&mut self, turn: &[u32], sequence: &[u32]) {
        for row in &mut self.rows {
            *row = turn[*row as usize];
        }
        for column in self.starts.windows(2) {
            self.rows[column[0]..column[1]].sort_unstable();
        }
        self.order = sequence.iter().map(|&k| self.order[k as usize]).collect();
        for (place, &body) in (0..).zip(&self.order) {
            self.places[body as usize] = place;
        }
    }

    /// Where the block of a row and an earlier column is.
    pub(crate) fn slot(&self, column: usize, row: u32) -> usize {
        let rows = &self.rows[self.starts[column]..self.starts[column + 1]];
        self.starts[column] + rows.partition_point(|&r| r < row)
    }
}

/// Products of blocks that it takes to eliminate bodies of degree d, d - 1, ... and 0.
fn products_down_from(degree: usize) -> usize {
    degree * (degree + 1) * (degree + 5) / 6
}

/// Its inertia can be found from the inverse.
fn has_inertia(mover: &Mover) -> bool {
    let i = &mover.inverse_inertia;
    let mean = (i.x_axis.x + i.y_axis.y + i.z_axis.z) / 3.0;
    i.determinant() > 1e-6 * mean * mean * mean
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DMat3;

    use crate::contact::Contact;
    use crate::mover::Twist;

    fn mover(inverse_mass: f64) -> Mover {
        Mover {
            twist: Twist::default(),
            inverse_mass,
            inverse_inertia: DMat3::IDENTITY * inverse_mass,
        }
    }

    #[test]
    fn a_pattern_is_not_taken_for_that_of_others_with_the_same_numbers() {
        let points = [Point::of(&Contact::default(), (0, 1), 0.0)];
        let mut pattern = Pattern::default();
        assert!(pattern.load(&points, &[mover(1.0), mover(0.0)], 10));
        assert_eq!(pattern.order, [0]);
        assert!(pattern.load(&points, &[mover(1.0), mover(2.0)], 10));
        assert_eq!(pattern.order.len(), 2);
        assert!(pattern.load(&points, &[mover(0.0), mover(2.0)], 10));
        assert_eq!(pattern.order, [1]);
    }

    fn touching(pairs: &[(u32, u32)]) -> Vec<Point> {
        let point = |&pair| Point::of(&Contact::default(), pair, 0.0);
        pairs.iter().map(point).collect()
    }

    #[test]
    fn what_an_eliminated_body_leaves_behind_touches() {
        // A ring of four: the body that goes first leaves a triangle.
        let ring = touching(&[(0, 1), (1, 2), (2, 3), (3, 0)]);
        let mut pattern = Pattern::default();
        assert!(pattern.load(&ring, &[mover(1.0); 4], 100));
        assert_eq!(pattern.starts, [0, 2, 4, 5, 5]);
        assert_eq!(pattern.rows, [1, 3, 2, 3, 3]);
        assert_eq!(pattern.products, 5 + 5 + 2);
    }

    #[test]
    fn it_is_given_up_when_and_only_when_it_takes_too_much() {
        let all = |k: u32| (0..k).map(move |other| (k, other));
        let clique: Vec<_> = (1..6).flat_map(all).collect();
        let products = products_down_from(5);
        let mut pattern = Pattern::default();
        assert!(!pattern.load(&touching(&clique), &[mover(1.0); 6], products - 1));
        assert!(pattern.load(&touching(&clique), &[mover(1.0); 6], products));
        assert_eq!(pattern.products, products);
    }
}
