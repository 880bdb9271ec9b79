//! Fewer points that carry the same load.

use super::ContactPoint;

/// Keeps at most `limit` of the points from `start` on: the deepest, then again and again the one farthest from all
/// that are kept (Gonzalez 1985, farthest-first traversal). Ties go to the first, so that the choice is stable.
/// Points within `resolution` [m] of each other count once.
pub(crate) fn spread(
    points: &mut Vec<ContactPoint>,
    start: usize,
    limit: usize,
    resolution: f64,
    kept: &mut Vec<ContactPoint>,
) {
    let count = points.len().saturating_sub(start);
    if count <= 1 || (count <= limit && resolution == 0.0) {
        return;
    }
    kept.clear();
    farthest_first(&points[start..], limit, resolution, kept);
    points.truncate(start);
    points.extend_from_slice(kept);
}

/// Normals nearer than this (cosine; 8 degrees) carry the load together.
const SAME_NORMAL: f64 = 0.99;

/// Keeps at most `limit` of the points from `start` on: per group of nearly equal normals at most 8, well spread, the
/// deepest group first. Points within `resolution` [m] of each other in a group count once.
pub(crate) fn by_normal(
    points: &mut Vec<ContactPoint>,
    start: usize,
    limit: usize,
    resolution: f64,
    kept: &mut Vec<ContactPoint>,
) {
    kept.clear();
    let mut rest = start;
    while rest < points.len() && kept.len() < limit {
        let Some(leader) = deepest(&points[rest..]) else {
            break;
        };
        points[rest..].sort_by_key(|p| p.normal.dot(leader.normal) <= SAME_NORMAL);
        let group = points[rest..]
            .partition_point(|p| p.normal.dot(leader.normal) > SAME_NORMAL)
            .max(1);
        farthest_first(
            &points[rest..rest + group],
            (limit - kept.len()).min(8),
            resolution,
            kept,
        );
        rest += group;
    }
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
