//! Contacts and joints that hang together: two contacts on one moving body are of the same island, and so are all
//! bodies of an assembly of joints. What happens in one island cannot be felt in another, so each is solved by itself,
//! for as long as it needs.

use std::ops::Range;

use crate::articulation::Articulation;

/// Of a body in no island.
const NONE: u32 = u32::MAX;

/// Working memory of the division, and its result.
#[derive(Clone, Debug, Default)]
pub(crate) struct Islands {
    /// Per body, another body of the same island, or itself (union-find).
    parents: Vec<u32>,
    /// Per leading body the number of its island.
    numbers: Vec<u32>,
    /// Islands without joints come first.
    free: usize,
    pub(crate) contacts: Groups,
    pub(crate) bodies: Groups,
    pub(crate) assemblies: Groups,
}

/// Members of islands, island by island, those of one in ascending order.
#[derive(Clone, Debug, Default)]
pub(crate) struct Groups {
    starts: Vec<usize>,
    pub(crate) members: Vec<u32>,
}

impl Groups {
    /// Where the members of an island are.
    pub(crate) fn range(&self, island: usize) -> Range<usize> {
        self.starts[island]..self.starts[island + 1]
    }

    pub(crate) fn of(&self, island: usize) -> &[u32] {
        &self.members[self.range(island)]
    }

    /// Members, each with its island, by counting; those without an island are left out.
    fn fill(&mut self, islands: usize, members: impl Iterator<Item = (u32, u32)> + Clone) {
        let listed = || members.clone().filter(|&(island, _)| island != NONE);
        self.starts.clear();
        self.starts.resize(islands + 2, 0);
        listed().for_each(|(island, _)| self.starts[island as usize + 2] += 1);
        for k in 2..self.starts.len() {
            self.starts[k] += self.starts[k - 1];
        }
        self.members.clear();
        self.members.resize(self.starts[islands + 1], 0);
        for (island, member) in listed() {
            let next = &mut self.starts[island as usize + 1];
            self.members[*next] = member;
            *next += 1;
        }
        self.starts.pop();
    }
}

impl Islands {
    /// How many there are, and how many of them, the first ones, have no joints.
    pub(crate) fn count(&self) -> (usize, usize) {
        (self.contacts.starts.len() - 1, self.free)
    }

    /// Divide contacts between pairs of bodies, and all assemblies. `still` bodies connect nothing.
    pub(crate) fn divide(
        &mut self,
        pairs: &[(u32, u32)],
        still: &[bool],
        articulation: &Articulation,
    ) {
        let bodies = still.len();
        let fixed = |k: u32| still[k as usize];
        self.parents.clear();
        self.parents.extend(0..index(bodies));
        for &(a, b) in pairs.iter().filter(|&&(a, b)| !fixed(a) && !fixed(b)) {
            self.join(a, b);
        }
        let assemblies = 0..articulation.len();
        for assembly in assemblies.clone() {
            for pair in articulation.bodies(assembly).windows(2) {
                self.join(index(pair[0]), index(pair[1]));
            }
        }
        (0..bodies).for_each(|k| self.parents[k] = self.root(index(k)));
        let leaders = &self.parents;
        let leader = |&(a, b): &(u32, u32)| leaders[if fixed(a) { b } else { a } as usize];
        let first = |assembly: usize| {
            let body = articulation.bodies(assembly).first();
            body.map_or(NONE, |&body| leaders[body])
        };
        self.numbers.clear();
        self.numbers.resize(bodies, NONE);
        let (free, all) = number(
            &mut self.numbers,
            pairs.iter().map(leader),
            assemblies.clone().map(first),
        );
        self.free = free;
        let numbers = &self.numbers;
        let of = |leader: u32| numbers.get(leader as usize).copied().unwrap_or(NONE);
        let contacts = (0..).zip(pairs).map(|(k, pair)| (of(leader(pair)), k));
        self.contacts.fill(all, contacts);
        let moving = (0..index(bodies)).filter(|&k| !fixed(k));
        self.bodies
            .fill(all, moving.map(|k| (of(leaders[k as usize]), k)));
        self.assemblies
            .fill(all, assemblies.map(|k| (of(first(k)), index(k))));
    }

    /// The lesser index leads, so that the result does not depend on the order of the contacts.
    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        self.parents[a.max(b) as usize] = a.min(b);
    }

    fn root(&mut self, mut body: u32) -> u32 {
        while self.parents[body as usize] != body {
            self.parents[body as usize] = self.parents[self.parents[body as usize] as usize];
            body = self.parents[body as usize];
        }
        body
    }
}

/// Number the islands of these leaders, those without joints first, each kind by ascending leaders. Returns how many there
/// are without joints, and at all.
fn number(
    numbers: &mut [u32],
    contacts: impl Iterator<Item = u32>,
    assemblies: impl Iterator<Item = u32>,
) -> (usize, usize) {
    const FREE: u32 = NONE - 1;
    const JOINTED: u32 = NONE - 2;
    contacts.for_each(|leader| numbers[leader as usize] = FREE);
    let known = assemblies.filter(|&leader| leader != NONE);
    known.for_each(|leader| numbers[leader as usize] = JOINTED);
    let mut next = 0;
    let mut ends = [0; 2];
    for (kind, end) in [FREE, JOINTED].into_iter().zip(&mut ends) {
        for number in numbers.iter_mut().filter(|number| **number == kind) {
            *number = next;
            next += 1;
        }
        *end = next as usize;
    }
    (ends[0], ends[1])
}

/// Bodies and contacts are counted by 32 bits.
pub(crate) fn index(k: usize) -> u32 {
    #[allow(clippy::cast_possible_truncation)]
    let k = k as u32;
    k
}
