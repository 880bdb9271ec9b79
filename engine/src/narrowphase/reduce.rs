//! Fewer points that carry the same load.

use super::ContactPoint;
use glam::DVec3;

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
    farthest_first(&points[start..], start, |_| true, limit, resolution, kept);
    replace(points, start, kept);
}

/// Normals nearer than this (cosine; 8 degrees) carry the load together.
const SAME_NORMAL: f64 = 0.99;
/// Groups of nearly equal normals at most, and points in each.
const GROUPS: usize = 16;
const PER_GROUP: usize = 8;

/// Keeps at most `limit` of the points from `start` on: per group of nearly equal normals a few, well spread, the
/// deepest group first. Points within `resolution` [m] of each other in a group count once.
pub(crate) fn by_normal(
    points: &mut Vec<ContactPoint>,
    start: usize,
    limit: usize,
    resolution: f64,
    kept: &mut Vec<Kept>,
) {
    kept.clear();
    let points_now = points.get(start..).unwrap_or(&[]);
    let mut leaders = [DVec3::ZERO; GROUPS];
    for group in 0..GROUPS {
        let free = |p: &ContactPoint| {
            leaders[..group]
                .iter()
                .all(|n| n.dot(p.normal) <= SAME_NORMAL)
        };
        let Some((_, leader)) = deepest(points_now, free) else {
            break;
        };
        let member = |p: &ContactPoint| free(p) && p.normal.dot(leader.normal) > SAME_NORMAL;
        farthest_first(
            points_now,
            start,
            member,
            (limit - kept.len()).min(PER_GROUP),
            resolution,
            kept,
        );
        leaders[group] = leader.normal;
        if kept.len() >= limit {
            break;
        }
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

/// Appends the choice among the members to `kept`, numbered from `first` on; stops early when every member lies within
/// `resolution` [m] of a kept one.
fn farthest_first(
    points: &[ContactPoint],
    first: usize,
    member: impl Fn(&ContactPoint) -> bool,
    limit: usize,
    resolution: f64,
    kept: &mut Vec<Kept>,
) {
    let start = kept.len();
    let mut next = deepest(points, &member);
    while let Some((index, point)) = next {
        kept.push(Kept {
            index: first + index,
            point,
        });
        if kept.len() - start >= limit {
            return;
        }
        next = farthest(points, &member, &kept[start..], resolution);
    }
}

fn deepest(
    points: &[ContactPoint],
    member: impl Fn(&ContactPoint) -> bool,
) -> Option<(usize, ContactPoint)> {
    let members = points
        .iter()
        .copied()
        .enumerate()
        .filter(|(_, p)| member(p));
    members.reduce(|best, p| if p.1.depth > best.1.depth { p } else { best })
}

fn farthest(
    points: &[ContactPoint],
    member: impl Fn(&ContactPoint) -> bool,
    kept: &[Kept],
    resolution: f64,
) -> Option<(usize, ContactPoint)> {
    let mut best = None;
    let mut best_distance = resolution * resolution;
    for (index, p) in points.iter().enumerate().filter(|(_, p)| member(p)) {
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
