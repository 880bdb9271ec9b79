//! Joints that hang together through moving bodies, in the order in which their rows are eliminated.

use std::collections::BTreeSet;

use super::ldu::{Ldu, Matrix};
use super::levers::Levers;
use super::square::{Column, Square};
use super::Hold;
use crate::body::Body;
use crate::joint::Course;
use crate::mover::{Moving, Yielding};

/// Share of the diagonal that is added to it where rows are redundant. Greater, and refinement converges slowly; smaller, and
/// rounding errors grow.
const EPSILON: f64 = 1e-10;
/// What is left of what is asked need not be refined when it is this part of it.
const REFINED: f64 = 1e-14;
/// Refinements at most; two are often enough.
const REFINEMENTS: usize = 6;
/// Rows of a block.
pub(crate) const WIDTH: usize = 3;
/// The row of an idle place: none has this number.
pub(crate) const IDLE: usize = usize::MAX;

/// A connected set of joints and its linear system. The rows of each joint fill blocks of three; where they do not come
/// out even, the rest of the last block is idle.
#[derive(Clone, Debug, Default)]
pub(crate) struct Assembly {
    /// Of each block, the row in each of its places.
    pub(crate) blocks: Vec<[usize; WIDTH]>,
    /// Moving bodies, ascending.
    pub(crate) bodies: Vec<usize>,
    pub(crate) levers: Levers,
    ldu: Ldu,
    ldu_ahead: Ldu,
    /// A is factored, over the rows that are free.
    pub(crate) factored: bool,
    /// It has no redundant rows, and nothing was added to its diagonal.
    regular: bool,
    /// Of each block, 1 for its free rows; and whether all rows are.
    masks: Vec<Column>,
    whole: bool,
    /// Working memory, one number a row.
    pub(crate) solution: Vec<Column>,
    rest: Vec<Column>,
    step: Vec<Column>,
}

impl Assembly {
    /// `solution` := what is asked of each free row; 0 of the others.
    pub(crate) fn ask(&mut self, holds: &[Hold], asked: impl Fn(usize) -> f64) {
        for (x, rows) in self.solution.iter_mut().zip(&self.blocks) {
            *x = Column::new(rows.map(|row| if_free(holds, row, || asked(row))));
        }
    }

    /// `solution` := what each free row lacks of a rate, as bodies move.
    pub(crate) fn ask_rates(
        &mut self,
        holds: &[Hold],
        moving: &[impl Moving],
        target: impl Fn(usize) -> f64,
    ) {
        for (block, (x, rows)) in self.solution.iter_mut().zip(&self.blocks).enumerate() {
            let rates = self.levers.rate(block, moving);
            let mask = rows.map(|row| if_free(holds, row, || 1.0));
            let targets = rows.map(|row| if_free(holds, row, || target(row)));
            *x = Column::new(targets) - Column::new(mask) * rates;
        }
    }

    /// Rates of its bilateral rows are those of bodies that move like this.
    pub(crate) fn note_rates(&self, moving: &[impl Moving], courses: &mut [Course]) {
        for (block, rows) in self.blocks.iter().enumerate() {
            let rates = self.levers.rate(block, moving).to_array();
            for (&row, rate) in rows.iter().zip(rates) {
                if let Some(course) = courses.get_mut(row) {
                    course.rate = rate;
                }
            }
        }
    }

    /// Some rows follow from others.
    pub(crate) fn is_redundant(&self) -> bool {
        self.factored && !self.regular
    }

    /// `solution` is zero.
    pub(crate) fn asks_nothing(&self) -> bool {
        greatest(&self.solution) == 0.0
    }

    /// `solution` adds to the impulses of the rows.
    pub(crate) fn add_to(&self, impulses: &mut [f64]) {
        for (x, rows) in self.solution.iter().zip(&self.blocks) {
            for (&row, x) in rows.iter().zip(x.to_array()) {
                if let Some(impulse) = impulses.get_mut(row) {
                    *impulse += x;
                }
            }
        }
    }

    /// Impulses of `solution` act on velocities.
    pub(crate) fn push(&self, moving: &mut [impl Yielding]) {
        for (block, &x) in self.solution.iter().enumerate() {
            self.levers.push(block, x, moving);
        }
    }

    /// Bodies and books take in the impulses of `solution`.
    pub(crate) fn kick(&self, bodies: &mut [Body], impulses: &mut [f64]) {
        for (block, &x) in self.solution.iter().enumerate() {
            self.levers.kick(block, x, bodies);
        }
        self.add_to(impulses);
    }

    /// Factor A over the free rows, unless that was done.
    pub(crate) fn factor(&mut self, holds: &[Hold]) {
        self.mark_free(holds);
        if self.factored {
            return;
        }
        let matrix = Free {
            entries: self.levers.matrix(),
            masks: &self.masks,
            whole: self.whole,
        };
        self.regular = self.ldu.factor(0.0, &matrix);
        if !self.regular {
            self.ldu.factor(EPSILON, &matrix);
        }
        self.factored = true;
    }

    /// Factor the matrix of the rows ahead.
    pub(crate) fn factor_ahead(&mut self, holds: &[Hold]) {
        self.mark_free(holds);
        let matrix = Free {
            entries: self.levers.matrix_ahead(),
            masks: &self.masks,
            whole: self.whole,
        };
        self.ldu_ahead.factor(EPSILON, &matrix);
    }

    /// 1 for each free row, 0 for the others.
    fn mark_free(&mut self, holds: &[Hold]) {
        self.whole = true;
        for (mask, rows) in self.masks.iter_mut().zip(&self.blocks) {
            let free = Column::new(rows.map(|row| if_free(holds, row, || 1.0)));
            self.factored &= *mask == free;
            self.whole &= rows.iter().all(|&row| holds.get(row) == Some(&Hold::Free));
            *mask = free;
        }
    }

    /// `solution` := A^-1 `solution`, with the share `EPSILON` on the diagonal if rows are redundant.
    pub(crate) fn divide_roughly(&mut self) {
        self.ldu.solve(&mut self.solution);
    }

    /// The same with the matrix of the rows ahead.
    pub(crate) fn divide_ahead(&mut self) {
        self.ldu_ahead.solve(&mut self.solution);
    }

    /// `solution` := A^-1 `solution`, refined where rows are redundant.
    pub(crate) fn divide(&mut self) {
        if self.regular {
            self.divide_roughly();
            return;
        }
        self.rest.copy_from_slice(&self.solution);
        self.solution.fill(Column::ZERO);
        let asked = greatest(&self.rest);
        let (mut size, mut gain) = (asked, 1.0);
        for _ in 0..=REFINEMENTS {
            self.step.copy_from_slice(&self.rest);
            self.ldu.solve(&mut self.step);
            for (x, step) in self.solution.iter_mut().zip(&self.step) {
                *x += *step;
            }
            // Each refinement gains about as much as the one before.
            if size * gain <= REFINED * asked {
                break;
            }
            self.ldu.subtract_product(&self.step, &mut self.rest);
            let left = greatest(&self.rest);
            if left <= REFINED * asked || left > 0.5 * size {
                break;
            }
            (size, gain) = (left, left / size);
        }
    }
}

/// A matrix without rows and columns that are not free; these get a 1 on the diagonal.
struct Free<'a, M> {
    entries: M,
    masks: &'a [Column],
    whole: bool,
}

impl<M> Free<'_, M> {
    #[inline(always)]
    fn masked(&self, entry: Square, i: usize, k: usize) -> Square {
        if self.whole {
            return entry;
        }
        let column = |c: usize| entry.0[c] * self.masks[i] * self.masks[k][c];
        Square([column(0), column(1), column(2)])
    }
}

impl<M: Matrix> Matrix for Free<'_, M> {
    #[inline(always)]
    fn entries(&self, i: usize, k: usize) -> [Square; 2] {
        let [above, below] = self.entries.entries(i, k);
        [self.masked(above, i, k), self.masked(below, k, i)]
    }

    #[inline(always)]
    fn diagonal(&self, k: usize) -> Square {
        let mut entry = self.masked(self.entries.diagonal(k), k, k);
        if !self.whole {
            (0..3).for_each(|row| entry.0[row][row] += 1.0 - self.masks[k][row]);
        }
        entry
    }
}

/// `value` of a free row, 0 of the others.
fn if_free(holds: &[Hold], row: usize, value: impl FnOnce() -> f64) -> f64 {
    if holds.get(row) == Some(&Hold::Free) {
        value()
    } else {
        0.0
    }
}

fn greatest(values: &[Column]) -> f64 {
    values.iter().fold(0.0, |worst, v| v.greatest().max(worst))
}

/// What the division needs to know of a joint.
pub(crate) struct Member {
    /// Bodies that it touches, ascending, and those of them that move.
    pub(crate) touched: Vec<usize>,
    pub(crate) bodies: Vec<usize>,
    /// Its rows.
    pub(crate) rows: Vec<usize>,
}

/// Divide joints into assemblies, those with the least joint first.
pub(crate) fn divide(joints: &[Member]) -> Vec<Assembly> {
    let neighbours = neighbours(joints);
    let mut seen = vec![false; joints.len()];
    let mut assemblies = Vec::new();
    for first in 0..joints.len() {
        if seen[first] {
            continue;
        }
        let mut members = vec![first];
        seen[first] = true;
        let mut next = 0;
        while let Some(&joint) = members.get(next) {
            for &other in &neighbours[joint] {
                if !std::mem::replace(&mut seen[other], true) {
                    members.push(other);
                }
            }
            next += 1;
        }
        assemblies.push(assemble(joints, &neighbours, members));
    }
    assemblies
}

fn neighbours(joints: &[Member]) -> Vec<BTreeSet<usize>> {
    let bodies = joints
        .iter()
        .flat_map(|j| &j.bodies)
        .max()
        .map_or(0, |&b| b + 1);
    let mut at_body = vec![Vec::new(); bodies];
    for (index, joint) in joints.iter().enumerate() {
        for &body in &joint.bodies {
            at_body[body].push(index);
        }
    }
    let mut out = vec![BTreeSet::new(); joints.len()];
    for (index, joint) in joints.iter().enumerate() {
        for &body in &joint.bodies {
            out[index].extend(at_body[body].iter().filter(|&&other| other != index));
        }
    }
    out
}

fn assemble(joints: &[Member], neighbours: &[BTreeSet<usize>], members: Vec<usize>) -> Assembly {
    let order = elimination_order(neighbours, &members);
    let bodies: BTreeSet<usize> = members
        .iter()
        .flat_map(|&j| joints[j].bodies.clone())
        .collect();
    let (mut rows, mut touched) = (Vec::new(), Vec::new());
    let mut columns: Vec<Vec<usize>> = Vec::new();
    let mut ranges = vec![0..0; joints.len()];
    for &joint in &order {
        let first = columns.len();
        let mut earlier: Vec<usize> = neighbours[joint]
            .iter()
            .flat_map(|&other| ranges[other].clone())
            .collect();
        earlier.sort_unstable();
        for block in first..first + joints[joint].rows.len().div_ceil(WIDTH) {
            columns.push(earlier.iter().copied().chain(first..block).collect());
            touched.push(joints[joint].touched.clone());
        }
        ranges[joint] = first..columns.len();
        for own in joints[joint].rows.chunks(WIDTH) {
            let mut block = [IDLE; WIDTH];
            block[..own.len()].copy_from_slice(own);
            rows.push(block);
        }
    }
    let blank = vec![Column::ZERO; columns.len()];
    Assembly {
        ldu: Ldu::new(&columns),
        ldu_ahead: Ldu::new(&columns),
        levers: Levers::new(&touched),
        solution: blank.clone(),
        rest: blank.clone(),
        masks: blank.clone(),
        step: blank,
        factored: false,
        regular: false,
        whole: false,
        blocks: rows,
        bodies: bodies.into_iter().collect(),
    }
}

/// Minimum degree: always the joint with the fewest neighbours left, whose neighbours then become each other's. Chains
/// and trees are eliminated from their ends without fill, from all of them in turn: what follows each other then does not wait
/// for each other in a processor that works ahead.
fn elimination_order(neighbours: &[BTreeSet<usize>], members: &[usize]) -> Vec<usize> {
    let mut left: BTreeSet<usize> = members.iter().copied().collect();
    let mut graph = neighbours.to_vec();
    let mut changed = vec![0; neighbours.len()];
    let mut order = Vec::with_capacity(members.len());
    while let Some(&joint) = left
        .iter()
        .min_by_key(|&&j| (graph[j].len(), changed[j], j))
    {
        left.remove(&joint);
        order.push(joint);
        let clique = std::mem::take(&mut graph[joint]);
        for &a in &clique {
            changed[a] = order.len();
            graph[a].remove(&joint);
            graph[a].extend(clique.iter().filter(|&&b| b != a));
        }
    }
    order
}
