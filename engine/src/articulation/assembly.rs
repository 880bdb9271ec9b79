//! Joints that hang together through moving bodies, in the order in which their rows are eliminated.

use std::collections::BTreeSet;

use super::ldl::Ldl;

/// A connected set of joints and its linear system.
#[derive(Clone, Debug, Default)]
pub(crate) struct Assembly {
    /// Rows in the order of elimination.
    pub(crate) rows: Vec<usize>,
    /// Moving bodies, ascending.
    pub(crate) bodies: Vec<usize>,
    pub(crate) ldl: Ldl,
    /// The rows that were free when it was last factored; empty when that was at other poses.
    pub(crate) factored: Vec<bool>,
    /// Working memory, one number a row.
    pub(crate) solution: Vec<f64>,
    pub(crate) rest: Vec<f64>,
    pub(crate) step: Vec<f64>,
}

/// What the division needs to know of a joint.
pub(crate) struct Member {
    /// Moving bodies that it touches.
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
    let rows: Vec<usize> = order.iter().flat_map(|&j| joints[j].rows.clone()).collect();
    let bodies: BTreeSet<usize> = members
        .iter()
        .flat_map(|&j| joints[j].bodies.clone())
        .collect();
    let mut place = vec![usize::MAX; joints.len()];
    let mut starts = Vec::new();
    let mut total = 0;
    for (slot, &joint) in order.iter().enumerate() {
        place[joint] = slot;
        starts.push(total);
        total += joints[joint].rows.len();
    }
    let mut columns: Vec<Vec<usize>> = Vec::with_capacity(total);
    for (slot, &joint) in order.iter().enumerate() {
        let mut earlier: Vec<usize> = neighbours[joint]
            .iter()
            .filter(|&&other| place[other] < slot)
            .flat_map(|&other| {
                starts[place[other]]..starts[place[other]] + joints[other].rows.len()
            })
            .collect();
        earlier.sort_unstable();
        for own in starts[slot]..starts[slot] + joints[joint].rows.len() {
            columns.push(earlier.iter().copied().chain(starts[slot]..own).collect());
        }
    }
    Assembly {
        ldl: Ldl::new(&columns),
        solution: vec![0.0; rows.len()],
        rest: vec![0.0; rows.len()],
        step: vec![0.0; rows.len()],
        factored: Vec::with_capacity(rows.len()),
        rows,
        bodies: bodies.into_iter().collect(),
    }
}

/// Minimum degree: always the joint with the fewest neighbours left, whose neighbours then become each other's. Chains
/// and trees are eliminated from their ends without fill.
fn elimination_order(neighbours: &[BTreeSet<usize>], members: &[usize]) -> Vec<usize> {
    let mut left: BTreeSet<usize> = members.iter().copied().collect();
    let mut graph = neighbours.to_vec();
    let mut order = Vec::with_capacity(members.len());
    while let Some(&joint) = left.iter().min_by_key(|&&j| (graph[j].len(), j)) {
        left.remove(&joint);
        order.push(joint);
        let clique = std::mem::take(&mut graph[joint]);
        for &a in &clique {
            graph[a].remove(&joint);
            graph[a].extend(clique.iter().filter(|&&b| b != a));
        }
    }
    order
}
