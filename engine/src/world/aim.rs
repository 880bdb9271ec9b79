//! Where the contacts of a step are to go: their normal velocity, their friction, and the impulse to begin with.

use glam::DVec3;

use crate::body::Body;
use crate::contact::{Contact, Recall};
use crate::impact::{gap_change, Kink};
use crate::model::{Geom, Settings, Stabilization};
use crate::position::SLOP;
use crate::team::{both, HANDFUL};

/// What contacts are aimed by.
pub(super) struct Aims<'a> {
    pub(super) bodies: &'a [Body],
    pub(super) geoms: &'a [Geom],
    /// Where bodies were hit.
    pub(super) kinks: Option<&'a Vec<Kink>>,
    pub(super) settings: &'a Settings,
    pub(super) h: f64,
}

/// Contacts in the order of their geoms, and what is found for each.
pub(super) struct Aimed<'a> {
    pub(super) contacts: &'a mut [Contact],
    /// Velocities, along normal and tangents [m/s].
    pub(super) starts: &'a mut [DVec3],
    /// [m]
    pub(super) gaps: &'a mut [f64],
    pub(super) memory: Recall<'a>,
}

impl Aimed<'_> {
    /// The border between two pairs of geoms at which to cut; None where it is not worth it.
    fn border(&self) -> Option<usize> {
        let half = self.contacts.len() / 2;
        let pair = self.contacts.get(half).filter(|_| half > HANDFUL)?.geoms;
        let border = self.contacts.partition_point(|c| c.geoms < pair);
        (border > 0).then_some(border)
    }

    fn split_at(self, border: usize) -> (Self, Self) {
        let (memory, later_memory) = self.memory.split_at(self.contacts[border].geoms);
        let (contacts, later_contacts) = self.contacts.split_at_mut(border);
        let (starts, later_starts) = self.starts.split_at_mut(border);
        let (gaps, later_gaps) = self.gaps.split_at_mut(border);
        let part = |contacts, starts, gaps, memory| Self {
            contacts,
            starts,
            gaps,
            memory,
        };
        (
            part(contacts, starts, gaps, memory),
            part(later_contacts, later_starts, later_gaps, later_memory),
        )
    }
}

impl Aims<'_> {
    /// Aim all contacts, parts of them at once, and start them from what is remembered.
    pub(super) fn aim_all(&self, mut list: Aimed) {
        if let Some(border) = list.border() {
            let (a, b) = list.split_at(border);
            both(|| self.aim_all(a), || self.aim_all(b));
            return;
        }
        let found = list.starts.iter_mut().zip(list.gaps);
        for (c, (start, gap)) in list.contacts.iter_mut().zip(found) {
            (*start, *gap) = self.aim(c);
            list.memory.start(c, self.bodies);
        }
    }

    /// Aim a contact. Returns its velocity [m/s], along normal and tangents, and its gap [m].
    fn aim(&self, c: &mut Contact) -> (DVec3, f64) {
        let (settings, h) = (self.settings, self.h);
        let lead = settings.integrator.lead();
        // Semi-implicit Euler moves bodies with the end velocity over the whole step: half a step ahead is its mean.
        let ahead = if lead == 1.0 { 0.5 * h } else { h };
        let u = c.velocity(self.bodies);
        c.choose_friction(u, settings.slip_speed);
        let gap = c.gap + self.kinks.map_or(0.0, |kinks| gap_change(kinks, c));
        c.target = if gap > SLOP {
            closing_speed(gap, u.x, h, lead)
        } else if settings.stabilization == Stabilization::Baumgarte && gap < 0.0 {
            -settings.baumgarte * gap / h
        } else {
            0.0
        };
        let centres = [self.centre(c.geoms.0), self.centre(c.geoms.1)];
        c.ahead = c.turning_ahead(self.bodies, centres, ahead);
        c.clear_impulse();
        (u, gap)
    }

    /// Of a round geom, from its body's centre of mass [m].
    fn centre(&self, k: u32) -> Option<DVec3> {
        let geom = &self.geoms[k as usize];
        let arm = || self.bodies[geom.body].rotation * geom.position;
        geom.shape.is_round().then(arm)
    }
}

/// The normal velocity at the end of a step of `h` that just closes a gap, from the velocity `start` at its beginning:
/// gap + ((1 - lead) start + lead end) h = 0. A contact never asks for more than parting with no speed.
fn closing_speed(gap: f64, start: f64, h: f64, lead: f64) -> f64 {
    if lead == 0.0 {
        return -gap / h; // this step's displacement is settled; the next one is to close the gap at most
    }
    ((-gap / h - (1.0 - lead) * start) / lead).min(0.0)
}
