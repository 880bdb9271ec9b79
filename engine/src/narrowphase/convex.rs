//! Any convex shape against any other, by how far each reaches in a direction: where there is no closed form.
//!
//! Apart, the nearest points give the direction (`gjk`), overlapping, the polytope of differences (`expanding`); both are
//! climbed from (`polish`), so that the direction is as exact as the shapes' reach. Spheres and capsules go without their
//! skin, as points and segments, which overlap seldom.

use super::expanding::Polytope;
use super::gjk::{self, Gap};
use super::polish::{self, Buffers, Core, Polished};
use super::Posed;
use glam::DVec3;

/// A direction is good enough to climb from when the gap along it is less than the distance of two points by this share
/// of the smaller shape.
const ROUGH: f64 = 1e-2;
/// Distances from this share of the smaller shape on tell a direction.
const TOUCHING: f64 = 1e-9;
/// Overlaps up to this share of the smaller shape are left as the climb found them: no other can be less by more.
const SHALLOW: f64 = 2e-7;

/// The direction in which two shapes are least apart or least overlapped; None when they are at least the margin apart.
pub(crate) fn separation(
    a: &Posed,
    b: &Posed,
    margin: f64,
    polytope: &mut Polytope,
    buffers: &mut Buffers,
) -> Option<Polished> {
    let (core_a, core_b) = (Core::of(a.shape), Core::of(b.shape));
    let skin = core_a.skin + core_b.skin;
    let (core_a, core_b) = (core_a.posed(a), core_b.posed(b));
    let scale = a.shape.bounding_radius().min(b.shape.bounding_radius());
    let toward = a.pose.point(a.shape.center()) - b.pose.point(b.shape.center());
    let toward = toward.try_normalize().unwrap_or(DVec3::Z);
    let (limit, fine) = (margin + skin, ROUGH * scale);
    let (start, apart) = match gjk::gap(&core_a, &core_b, DVec3::ZERO, toward, limit, fine) {
        Gap::Beyond => return None,
        Gap::Open(found) => ((found.p - found.q).try_normalize().unwrap_or(toward), true),
        Gap::Closed => (toward, false),
    };
    let mut best = polish::ascend(a, b, start, buffers);
    if best.is_peak && -best.separation - skin < SHALLOW * scale {
        return Some(best);
    }
    if apart {
        if let Gap::Open(found) = gjk::gap(&core_a, &core_b, DVec3::ZERO, start, limit, 0.0) {
            let fine = polish::polish(a, b, found.p - found.q, buffers);
            best = fine.map_or(best, |fine| best.better(fine));
            if best.separation + skin > TOUCHING * scale {
                return Some(best);
            }
        }
    }
    let best = polytope.least_overlap(
        best,
        (scale, skin),
        |n| core_b.support(n) - core_a.support(-n),
        |n| polish::ascend(a, b, n, buffers),
    );
    if best.is_peak {
        return Some(best);
    }
    let climbed = polish::polish(a, b, best.normal, buffers)?;
    Some(best.better(climbed))
}
