//! Fewer points that carry the same load.

use super::ContactPoint;

/// Keeps at most `limit` of the points from `start` on: the deepest, then again and again the one farthest from all
/// that are kept (Gonzalez 1985, farthest-first traversal). Ties go to the first, so that the choice is stable.
pub(crate) fn spread(
    points: &mut Vec<ContactPoint>,
    start: usize,
    limit: usize,
    kept: &mut Vec<ContactPoint>,
) {
    if points.len().saturating_sub(start) <= limit {
        return;
    }
    kept.clear();
    farthest_first(&points[start..], limit, 0.0, kept);
    points.truncate(start);
    points.extend_from_slice(kept);
}

/// Appends to `kept`; stops early when every point lies within `resolution` [m] of a kept one.
pub(crate) fn farthest_first(
    points: &[ContactPoint],
    limit: usize,
    resolution: f64,
    kept: &mut Vec<ContactPoint>,
) {
    let start = kept.len();
    let mut next = deepest(points);
    while let Some(point) = next {
        kept.push(point);
        if kept.len() - start >= limit {
            return;
        }
        next = farthest(points, &kept[start..], resolution);
    }
}

fn deepest(points: &[ContactPoint]) -> Option<ContactPoint> {
    points
        .iter()
        .copied()
        .reduce(|best, p| if p.depth > best.depth { p } else { best })
}

fn farthest(
    points: &[ContactPoint],
    kept: &[ContactPoint],
    resolution: f64,
) -> Option<ContactPoint> {
    let mut best = None;
    let mut best_distance = resolution * resolution;
    for p in points {
        let distance = kept
            .iter()
            .map(|k| k.position.distance_squared(p.position))
            .fold(f64::INFINITY, f64::min);
        if distance > best_distance {
            best_distance = distance;
            best = Some(*p);
        }
    }
    best
}
