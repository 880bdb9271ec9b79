//! Contacts and joints that hang together: two contacts on one moving body are of the same island, and so are all
//! bodies of an assembly of joints. What happens in one island cannot be felt in another, so each is solved by itself,
//! for as long as it needs.

use crate::articulation::Articulation;
use crate::contact::Contact;
use crate::mover::Mover;

/// Contacts and assemblies that are solved together.
#[derive(Clone, Debug, Default)]
pub(crate) struct Island {
    pub(crate) contacts: Vec<usize>,
    pub(crate) assemblies: Vec<usize>,
}

/// Something on a moving body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Member {
    Contact(usize),
    Assembly(usize),
}

/// Working memory of the division, and its result.
#[derive(Clone, Debug, Default)]
pub(crate) struct Islands {
    /// Per body, another body of the same island, or itself (union-find).
    parents: Vec<usize>,
    /// Root body and member, island by island.
    members: Vec<(usize, Member)>,
}

impl Islands {
    /// Divide the contacts named by `which` and all assemblies; within an island they keep their order.
    pub(crate) fn divide(
        &mut self,
        movers: &[Mover],
        contacts: &[Contact],
        which: &[usize],
        articulation: &Articulation,
    ) {
        let fixed = |body: usize| movers[body].inverse_mass == 0.0;
        self.parents.clear();
        self.parents.extend(0..movers.len());
        for &k in which {
            let (a, b) = contacts[k].bodies;
            if !fixed(a) && !fixed(b) {
                self.join(a, b);
            }
        }
        for assembly in 0..articulation.len() {
            for pair in articulation.bodies(assembly).windows(2) {
                self.join(pair[0], pair[1]);
            }
        }
        self.members.clear();
        for &k in which {
            let (a, b) = contacts[k].bodies;
            let root = self.root(if fixed(a) { b } else { a });
            self.members.push((root, Member::Contact(k)));
        }
        for assembly in 0..articulation.len() {
            if let Some(&body) = articulation.bodies(assembly).first() {
                let root = self.root(body);
                self.members.push((root, Member::Assembly(assembly)));
            }
        }
        self.members.sort_by_key(|&(root, _)| root);
    }

    /// The island that begins at `start`, into `out`; returns where the next one begins, None behind the last.
    pub(crate) fn take(&self, start: usize, out: &mut Island) -> Option<usize> {
        out.contacts.clear();
        out.assemblies.clear();
        let &(root, _) = self.members.get(start)?;
        let island = self.members[start..].iter().take_while(|m| m.0 == root);
        for (_, member) in island {
            match *member {
                Member::Contact(k) => out.contacts.push(k),
                Member::Assembly(k) => out.assemblies.push(k),
            }
        }
        Some(start + out.contacts.len() + out.assemblies.len())
    }

    /// The lesser index leads, so that the result does not depend on the order of the contacts.
    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.parents[a.max(b)] = a.min(b);
    }

    fn root(&mut self, mut body: usize) -> usize {
        while self.parents[body] != body {
            self.parents[body] = self.parents[self.parents[body]];
            body = self.parents[body];
        }
        body
    }
}
