//! Coulomb's cone: the exact answer of one contact with all others held; for one, or for several abreast.

use crate::disc::{friction_on_rim, is_inside, Pair};
use crate::lanes::{Mask, Real};
use crate::mover::Part;

/// What the answer of a contact depends on beside its velocity.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Cone<T> {
    /// Diagonal of K: normal, tangent 1, tangent 2 [1/kg].
    pub(crate) k: [T; 3],
    /// 1 / (k + give) of the normal, 1 / k of the tangents.
    pub(crate) inverse: [T; 3],
    /// What a normal impulse does to the two tangential velocities [1/kg].
    pub(crate) k_coupling: Pair<T>,
    /// By how much the contact gives way to its normal impulse [1/kg].
    pub(crate) give: T,
    /// mu of the solve at hand.
    pub(crate) friction: T,
}

impl<T: Real> Cone<T> {
    /// The impulse that answers the velocity `u`, normal beyond the target and slip, which the impulse `old` has led to.
    /// The slip is that with the new normal impulse and the old friction.
    #[inline(always)]
    pub(crate) fn answer(&self, u: [T; 3], old: [T; 3], part: Part) -> [T; 3] {
        let none = old[0].constant(0.0);
        let normal = (old[0] - (u[0] + self.give * old[0]) * self.inverse[0]).max(none);
        if part == Part::Normals {
            return [normal, old[1], old[2]];
        }
        if !normal.within(none).not().any() {
            return [none; 3];
        }
        let change = normal - old[0];
        let slip = (
            u[1] + self.k_coupling.0 * change,
            u[2] + self.k_coupling.1 * change,
        );
        let stop = (
            old[1] - slip.0 * self.inverse[1],
            old[2] - slip.1 * self.inverse[2],
        );
        let radius = self.friction * normal;
        let slides = is_inside(stop, radius).not();
        if !slides.any() {
            return [normal, stop.0, stop.1];
        }
        let k = (self.k[1], self.k[2]);
        let without = (slip.0 - k.0 * old[1], slip.1 - k.1 * old[2]);
        let rim = friction_on_rim(without, k, radius, slides);
        [
            normal,
            slides.select(rim.0, stop.0),
            slides.select(rim.1, stop.1),
        ]
    }
}

impl<T: Copy> Cone<T> {
    /// Each of the numbers turned into something else.
    #[inline(always)]
    pub(crate) fn map<U>(&self, f: impl Fn(T) -> U) -> Cone<U> {
        Cone {
            k: self.k.map(&f),
            inverse: self.inverse.map(&f),
            k_coupling: (f(self.k_coupling.0), f(self.k_coupling.1)),
            give: f(self.give),
            friction: f(self.friction),
        }
    }
}
