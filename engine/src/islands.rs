//! Contacts that hang together: two contacts on one moving body are of the same island. What happens in one island
//! cannot be felt in another, so each is solved by itself, for as long as it needs.

use crate::body::Body;
use crate::contact::Contact;

/// Working memory of the division, and its result.
#[derive(Clone, Debug, Default)]
pub(crate) struct Islands {
    /// Per body, another body of the same island, or itself (union-find).
    parents: Vec<usize>,
    /// Contacts, island by island.
    members: Vec<(usize, usize)>,
}

impl Islands {
    /// Divide the contacts named by `which`; within an island they keep their order.
    pub(crate) fn divide(&mut self, bodies: &[Body], contacts: &[Contact], which: &[usize]) {
        self.parents.clear();
        self.parents.extend(0..bodies.len());
        for &k in which {
            let (a, b) = contacts[k].bodies;
            if !bodies[a].is_fixed() && !bodies[b].is_fixed() {
                let (a, b) = (self.root(a), self.root(b));
                // The lesser index leads, so that the result does not depend on the order of the contacts.
                self.parents[a.max(b)] = a.min(b);
            }
        }
        self.members.clear();
        for &k in which {
            let (a, b) = contacts[k].bodies;
            let moving = if bodies[a].is_fixed() { b } else { a };
            let root = self.root(moving);
            self.members.push((root, k));
        }
        self.members.sort_by_key(|&(root, _)| root);
    }

    /// Put the contacts of the island that begins at `start` into `out`; returns where the next one begins, None
    /// behind the last.
    pub(crate) fn take(&self, start: usize, out: &mut Vec<usize>) -> Option<usize> {
        out.clear();
        let &(root, _) = self.members.get(start)?;
        let island = self.members[start..].iter().take_while(|m| m.0 == root);
        out.extend(island.map(|m| m.1));
        Some(start + out.len())
    }

    fn root(&mut self, mut body: usize) -> usize {
        while self.parents[body] != body {
            self.parents[body] = self.parents[self.parents[body]];
            body = self.parents[body];
        }
        body
    }
}
