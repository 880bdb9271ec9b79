//! Box against box: the axis of least overlap among 15.

use crate::shape::Pose;
use glam::{DMat3, DVec3};

/// Squared sine below which two edges are parallel; their cross product would be rounding.
const PARALLEL: f64 = 1e-10;
/// A cross product of edges must win by this share of the boxes' size over a face's normal.
const PREFER_FACES: f64 = 1e-9;

/// Unit normal from B to A along which the boxes are farthest apart or least overlapped; None when they are farther
/// apart than the margin.
///
/// Separating axes of two oriented boxes: 3 + 3 face normals and 9 cross products of edges (Gottschalk, Lin and
/// Manocha 1996; Ericson 2005, section 4.4.1). In A's frame, with t the centre of B and R_ij = a_i . b_j:
///
/// ```text
/// a_i:       s = |t_i|           - (A_i + sum_j B_j |R_ij|)
/// b_j:       s = |t . b_j|       - (B_j + sum_i A_i |R_ij|)
/// a_i x b_j: s = (|t . a_i x b_j| - (A_k |R_lj| + A_l |R_kj| + B_m |R_in| + B_n |R_im|)) / |a_i x b_j|
/// ```
pub(crate) fn separating_axis(
    half_a: DVec3,
    a: &Pose,
    half_b: DVec3,
    b: &Pose,
    margin: f64,
) -> Option<DVec3> {
    let relative = a.relative(b);
    let (t, r) = (relative.position, relative.rotation);
    let abs = DMat3::from_cols(r.x_axis.abs(), r.y_axis.abs(), r.z_axis.abs());
    let t_b = r.transpose() * t;
    let face_a = t.abs() - half_a - abs * half_b;
    let face_b = t_b.abs() - half_b - abs.transpose() * half_a;
    let mut best = Best::of_faces(face_a, face_b, &r, t, t_b);
    if best.separation >= margin {
        return None;
    }
    best.separation += PREFER_FACES * (half_a.max_element() + half_b.max_element());
    let best = with_edges(best, (half_a, half_b), t, &r, &abs, margin)?;
    Some(-a.direction(best.axis.normalize_or_zero()))
}

/// The best axis so far, from A to B, in A's frame.
struct Best {
    separation: f64,
    axis: DVec3,
}

impl Best {
    fn of_faces(face_a: DVec3, face_b: DVec3, r: &DMat3, t: DVec3, t_b: DVec3) -> Self {
        let (i, j) = (face_a.max_position(), face_b.max_position());
        if face_a[i] >= face_b[j] {
            Self {
                separation: face_a[i],
                axis: DVec3::AXES[i] * 1f64.copysign(t[i]),
            }
        } else {
            Self {
                separation: face_b[j],
                axis: r.col(j) * 1f64.copysign(t_b[j]),
            }
        }
    }
}

fn with_edges(
    mut best: Best,
    (half_a, half_b): (DVec3, DVec3),
    t: DVec3,
    r: &DMat3,
    abs: &DMat3,
    margin: f64,
) -> Option<Best> {
    for i in 0..3 {
        let (k, l) = ((i + 1) % 3, (i + 2) % 3);
        for j in 0..3 {
            let (column, sizes) = (r.col(j), abs.col(j));
            let sine_squared = 1.0 - column[i] * column[i];
            if sine_squared < PARALLEL {
                continue;
            }
            let (m, n) = ((j + 1) % 3, (j + 2) % 3);
            // a_i x b_j has the components -b_j.l along a_k and b_j.k along a_l.
            let along = t[l] * column[k] - t[k] * column[l];
            let reach_a = half_a[k] * sizes[l] + half_a[l] * sizes[k];
            let reach_b = half_b[m] * abs.col(n)[i] + half_b[n] * abs.col(m)[i];
            let stretched = along.abs() - reach_a - reach_b;
            if stretched <= best.separation.min(0.0) {
                continue; // the more so divided by a sine
            }
            let separation = stretched / sine_squared.sqrt();
            if separation >= margin {
                return None;
            }
            if separation > best.separation {
                let axis = DVec3::AXES[i].cross(column) * 1f64.copysign(along);
                best = Best { separation, axis };
            }
        }
    }
    Some(best)
}
