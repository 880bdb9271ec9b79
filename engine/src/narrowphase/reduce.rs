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
    kept: &mut Vec<Kept>,
) {
    let count = points.len().saturating_sub(start);
    if count <= 1 || (count <= limit && resolution == 0.0) {
        return;
    }
    kept.clear();
    farthest_first(&points[start..], start, limit, resolution, kept);
    replace(points, start, kept);
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
    kept: &mut Vec<Kept>,
) {
    kept.clear();
    let mut rest = start;
    while rest < points.len() && kept.len() < limit {
        let Some(leader) = deepest(&points[rest..]).map(|(_, leader)| leader) else {
            break;
        };
        points[rest..].sort_by_key(|p| p.normal.dot(leader.normal) <= SAME_NORMAL);
        let group = points[rest..]
            .partition_point(|p| p.normal.dot(leader.normal) > SAME_NORMAL)
            .max(1);
        farthest_first(
            &points[rest..rest + group],
            rest,
            (limit - kept.len()).min(8),
            resolution,
            kept,
        );
        rest += group;
    }
    replace(points, start, kept);
}

/// A chosen point and its place in the list.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kept {
    index: usize,
    point: ContactPoint,
}

/// Puts the chosen points, in their old order, into the place of all from `start` on.
fn replace(points: &mut Vec<ContactPoint>, start: usize, kept: &mut [Kept]) {
    kept.sort_unstable_by_key(|k| k.index);
    points.truncate(start);
    points.extend(kept.iter().map(|k| k.point));
}

/// Appends the choice to `kept`, numbered from `first` on; stops early when every point lies within `resolution` [m] of
/// a kept one.
fn farthest_first(
    points: &[ContactPoint],
    first: usize,
    limit: usize,
    resolution: f64,
    kept: &mut Vec<Kept>,
) {
    let start = kept.len();
    let mut next = deepest(points);
    while let Some((index, point)) = next {
        kept.push(Kept {
            index: first + index,
            point,
        });
        if kept.len() - start >= limit {
            return;
        }
        next = farthest(points, &kept[start..], resolution);
    }
}

fn deepest(points: &[ContactPoint]) -> Option<(usize, ContactPoint)> {
    points
        .iter()
        .copied()
        .enumerate()
        .reduce(|best, p| if p.1.depth > best.1.depth { p } else { best })
}

fn farthest(
    points: &[ContactPoint],
    kept: &[Kept],
    resolution: f64,
) -> Option<(usize, ContactPoint)> {
    let mut best = None;
    let mut best_distance = resolution * resolution;
    for (index, p) in points.iter().enumerate() {
        let squares = kept
            .iter()
            .map(|k| k.point.position.distance_squared(p.position));
        let distance = squares.fold(f64::INFINITY, f64::min);
        if distance > best_distance {
            best_distance = distance;
            best = Some((index, *p));
        }
    }
    best
}
