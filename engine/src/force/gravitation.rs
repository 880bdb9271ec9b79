//! Newton's attraction between all bodies that have a mass.

use glam::DVec3;

use super::sum::Sum;
use crate::body::Body;

/// F = G m1 m2 / r^2 along the line of centres, energy -G m1 m2 / r; Newton 1687. No softening. Bodies attract as points
/// at their centres of mass, which is exact for spheres. Coincident centres neither attract nor have an energy.
#[derive(Clone, Debug)]
pub(super) struct Gravitation {
    constant: f64,
    /// Index and mass [kg] of those that attract.
    attractors: Vec<(usize, f64)>,
}

impl Gravitation {
    pub(super) fn new(constant: f64, masses: &[f64]) -> Self {
        let all = masses.iter().copied().enumerate();
        Self {
            constant,
            attractors: if constant == 0.0 {
                Vec::new()
            } else {
                all.filter(|&(_, mass)| mass > 0.0).collect()
            },
        }
    }

    pub(super) fn add(&self, sum: &mut Sum<'_>) {
        let bodies = sum.bodies;
        for pair in self.pairs(bodies) {
            let force =
                pair.apart * (pair.strength / (pair.distance * pair.distance * pair.distance));
            sum.interact(pair.bodies.0, force, DVec3::ZERO);
            sum.interact(pair.bodies.1, -force, DVec3::ZERO);
        }
    }

    pub(super) fn energy(&self, bodies: &[Body]) -> f64 {
        self.pairs(bodies).map(|p| -p.strength / p.distance).sum()
    }

    /// Every pair that attracts each other, of which one at least can move by it.
    fn pairs<'a>(&'a self, bodies: &'a [Body]) -> impl Iterator<Item = Pair> + 'a {
        let numbered = self.attractors.iter().enumerate();
        numbered
            .flat_map(|(k, a)| self.attractors[k + 1..].iter().map(move |b| (a, b)))
            .filter(|(a, b)| !(bodies[a.0].is_fixed() && bodies[b.0].is_fixed()))
            .filter_map(|(a, b)| {
                let apart = bodies[b.0].state.position - bodies[a.0].state.position;
                let distance = apart.length();
                (distance > 0.0).then_some(Pair {
                    bodies: (a.0, b.0),
                    apart,
                    distance,
                    strength: self.constant * a.1 * b.1,
                })
            })
    }
}

/// Two bodies that attract each other.
struct Pair {
    bodies: (usize, usize),
    /// From the first to the second [m].
    apart: DVec3,
    /// [m], above 0
    distance: f64,
    /// G m1 m2 [N m^2]
    strength: f64,
}
