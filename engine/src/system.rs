//! What one island is solved with: its contacts, how its bodies move, and its joints.

use glam::DVec3;

use crate::articulation::Articulation;
use crate::layout::{visit, Layer};
use crate::mover::{Mover, Part, Window};
use crate::point::Point;

/// What one island is solved with.
pub(crate) struct System<'a> {
    pub(crate) points: &'a mut [Point],
    pub(crate) movers: &'a mut [Mover],
    pub(crate) joints: Option<Jointed<'a>>,
    pub(crate) parts: &'a [Layer],
}

/// The joints of an island.
pub(crate) struct Jointed<'a> {
    pub(crate) articulation: &'a mut Articulation,
    pub(crate) assemblies: &'a [u32],
}

impl System<'_> {
    /// Joints take up what contacts did to them, exactly.
    pub(crate) fn hold_joints(&mut self) {
        if let Some(joints) = &mut self.joints {
            for &assembly in joints.assemblies {
                joints.articulation.solve(assembly as usize, self.movers);
            }
        }
    }

    /// Bodies of an assembly.
    pub(crate) fn bodies(&self, assembly: u32) -> &[usize] {
        let joints = self.joints.as_ref();
        joints.map_or(&[], |j| j.articulation.bodies(assembly as usize))
    }

    /// Bodies get the impulses that contacts begin with.
    pub(crate) fn push(&mut self) {
        let movers = Window::new(self.movers);
        visit(self.parts, self.points, movers, false, &|list, movers| {
            for p in list.iter() {
                p.push(movers, p.impulse);
                if let Some(roll) = &p.roll {
                    p.turn(movers, roll.to_world(roll.impulse));
                }
            }
            0.0
        });
    }

    /// Those of all contacts, then the angular ones of those that have any.
    pub(crate) fn impulses(&self) -> impl Iterator<Item = DVec3> + '_ {
        let rolls = self.points.iter().filter_map(|p| p.roll.as_ref());
        self.points
            .iter()
            .map(|p| p.impulse)
            .chain(rolls.map(|roll| roll.impulse))
    }

    /// Impulses brought back into their cones; returns the greatest change of a velocity [m/s].
    pub(crate) fn cut(&mut self, part: Part) -> f64 {
        let mut worst = 0.0_f64;
        for p in self.points.iter_mut() {
            let change = p.allowed(p.impulse, part) - p.impulse;
            p.impulse += change;
            p.push(self.movers, change);
            worst = worst.max((change * p.k()).abs().max_element());
        }
        worst
    }

    pub(crate) fn set_impulses(&mut self, impulses: &[DVec3]) {
        let (pushes, turns) = impulses.split_at(self.points.len());
        for (p, &new) in self.points.iter_mut().zip(pushes) {
            let change = new - p.impulse;
            p.impulse = new;
            p.push(self.movers, change);
        }
        let mut turns = turns.iter();
        for p in self.points.iter_mut() {
            p.set_turn(self.movers, |roll| {
                turns.next().copied().unwrap_or(roll.impulse)
            });
        }
        self.hold_joints();
    }

    /// One sweep; returns the greatest change of a relative velocity [m/s].
    pub(crate) fn sweep(&mut self, part: Part, backwards: bool) -> f64 {
        let movers = Window::new(self.movers);
        let one = |p: &mut Point, movers: &mut Window| {
            let change = p.solve(movers, part);
            if part == Part::All {
                change.max(p.solve_roll(movers))
            } else {
                change
            }
        };
        let worst = visit(
            self.parts,
            self.points,
            movers,
            backwards,
            &|list, movers| {
                let mut worst = 0.0_f64;
                let mut each = |p: &mut Point| worst = worst.max(one(p, movers));
                if backwards {
                    list.iter_mut().rev().for_each(&mut each);
                } else {
                    list.iter_mut().for_each(&mut each);
                }
                worst
            },
        );
        self.hold_joints();
        worst
    }

    /// Static contacts on the rim of their disc that slip nevertheless become kinetic.
    pub(crate) fn release_slipping(&mut self, noticeable: f64) -> bool {
        let mut any = false;
        for p in self.points.iter_mut() {
            any |= p.release(self.movers, noticeable);
        }
        any
    }
}
