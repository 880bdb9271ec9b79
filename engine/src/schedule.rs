//! Who is served with whom: contacts in bunches, no two of a bunch with a moving body in common.
//!
//! Contacts that have no moving body in common do not feel each other, and may be answered at once. Each contact goes
//! into the first bunch with room behind all that hold an earlier contact of its bodies. So whatever feels it keeps its
//! turn: bunches one after the other do what contacts one after the other would, and backwards likewise, to the last bit.
//! In a heap nearly all bunches are full.

use crate::lanes::WIDTH;

/// Of a lane that holds no contact.
const NOBODY: u32 = u32::MAX;

/// Contacts of a bunch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Bunch([u32; WIDTH]);

/// The bunches, and working memory.
#[derive(Clone, Debug, Default)]
pub(crate) struct Schedule {
    pub(crate) bunches: Vec<Bunch>,
    /// Of every bunch itself while it has room, else a later one that may have; and of the bunch to come.
    rooms: Vec<u32>,
    /// Of every body, the bunch behind all that hold it.
    turns: Vec<u32>,
    first: u32,
}

impl Bunch {
    /// The contacts with their lanes.
    #[inline]
    pub(crate) fn members(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let held = self.0.iter().take_while(|&&k| k != NOBODY);
        held.enumerate().map(|(lane, &k)| (lane, k as usize))
    }

    /// One contact a lane; the first is repeated where there are fewer.
    #[inline]
    pub(crate) fn filled(&self) -> [usize; WIDTH] {
        self.0
            .map(|k| if k == NOBODY { self.0[0] } else { k } as usize)
    }

    /// Which lanes hold a contact of their own.
    pub(crate) fn held(&self) -> [bool; WIDTH] {
        self.0.map(|k| k != NOBODY)
    }

    /// Another contact; returns whether it was the last with room.
    fn add(&mut self, slot: u32) -> bool {
        let free = self.0.iter().take_while(|&&k| k != NOBODY).count();
        self.0[free] = slot;
        free + 1 == WIDTH
    }
}

impl Schedule {
    /// For contacts between so many bodies.
    pub(crate) fn begin(&mut self, bodies: usize) {
        self.bunches.clear();
        self.rooms.clear();
        self.rooms.push(0);
        self.turns.clear();
        self.turns.resize(bodies, 0);
        self.first = 0;
    }

    /// What comes now is served behind all that was put before.
    pub(crate) fn part(&mut self) {
        self.first = self.next();
    }

    fn next(&self) -> u32 {
        #[allow(clippy::cast_possible_truncation)]
        let next = self.bunches.len() as u32;
        next
    }

    /// A contact that moves these bodies.
    pub(crate) fn put(&mut self, slot: u32, moved: impl Iterator<Item = u32> + Clone) {
        let turns = moved.clone().map(|body| self.turns[body as usize]);
        let turn = turns.fold(self.first, u32::max);
        let place = self.room(turn);
        if place == self.next() {
            self.bunches.push(Bunch([NOBODY; WIDTH]));
            self.rooms.push(place + 1);
        }
        if self.bunches[place as usize].add(slot) {
            self.rooms[place as usize] = place + 1;
        }
        for body in moved {
            self.turns[body as usize] = place + 1;
        }
    }

    /// The first bunch with room, from this one on.
    fn room(&mut self, mut place: u32) -> u32 {
        while self.rooms[place as usize] != place {
            let next = self.rooms[place as usize];
            self.rooms[place as usize] = self.rooms[next as usize];
            place = next;
        }
        place
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scheduled(pairs: &[[u32; 2]]) -> Vec<Vec<usize>> {
        let mut schedule = Schedule::default();
        schedule.begin(10);
        for (slot, pair) in (0..).zip(pairs) {
            schedule.put(slot, pair.iter().copied());
        }
        let members = |bunch: &Bunch| bunch.members().map(|(_, k)| k).collect();
        schedule.bunches.iter().map(members).collect()
    }

    #[test]
    fn contacts_of_a_body_keep_their_order() {
        let chain = [[0, 1], [1, 2], [2, 3], [3, 4]];
        assert_eq!(scheduled(&chain), [[0], [1], [2], [3]]);
    }

    #[test]
    fn others_fill_the_first_bunch_with_room() {
        let apart = [[0, 1], [2, 3], [4, 5], [6, 7], [8, 9]];
        assert_eq!(scheduled(&apart), [vec![0, 1, 2, 3], vec![4]]);
        let mixed = [[0, 1], [1, 2], [3, 4], [4, 5], [6, 7], [8, 9]];
        assert_eq!(scheduled(&mixed), [vec![0, 2, 4, 5], vec![1, 3]]);
    }

    #[test]
    fn a_part_waits_for_the_one_before() {
        let mut schedule = Schedule::default();
        schedule.begin(4);
        schedule.put(0, [0, 1].into_iter());
        schedule.part();
        schedule.put(1, [2, 3].into_iter());
        assert_eq!(schedule.bunches.len(), 2);
    }
}
