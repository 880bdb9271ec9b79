//! Small pieces of algebra that glam does not have. Trigonometry comes from `libm`, which gives the same bits on
//! every platform.

use glam::{DMat3, DQuat, DVec3};

/// Unit quaternion of the rotation vector `v` [rad]: (cos |v|/2, sin(|v|/2) v/|v|).
#[must_use]
pub fn rotation_from_vector(v: DVec3) -> DQuat {
    let angle = v.length();
    // sin(x/2)/x -> 1/2 - x^2/48 as x -> 0; below 1e-6 the next term is under the rounding error.
    let scale = if angle > 1e-6 {
        libm::sin(0.5 * angle) / angle
    } else {
        0.5 - angle * angle / 48.0
    };
    DQuat::from_xyzw(
        v.x * scale,
        v.y * scale,
        v.z * scale,
        libm::cos(0.5 * angle),
    )
    .normalize()
}

/// Rotation vector [rad] of a unit quaternion, with an angle of at most pi: the inverse of [`rotation_from_vector`].
#[must_use]
pub fn rotation_vector(q: DQuat) -> DVec3 {
    let q = if q.w < 0.0 { -q } else { q };
    let axis = DVec3::new(q.x, q.y, q.z);
    let sine = axis.length();
    // angle / sin(angle / 2) -> 2 as the angle goes to 0.
    let scale = if sine > 1e-9 {
        2.0 * libm::atan2(sine, q.w) / sine
    } else {
        2.0
    };
    axis * scale
}

/// Length of (x, y). The library's `hypot` guards against overflow that cannot happen here, and its last bit depends
/// on the platform.
#[must_use]
pub fn length(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

/// An orthonormal pair (t1, t2) with t1 x t2 = n, for a unit vector n.
///
/// Duff et al. 2017, "Building an Orthonormal Basis, Revisited": no branch but the sign, no loss of precision.
#[must_use]
pub fn tangents(n: DVec3) -> (DVec3, DVec3) {
    let sign = 1.0_f64.copysign(n.z);
    let a = -1.0 / (sign + n.z);
    let b = n.x * n.y * a;
    let t1 = DVec3::new(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x);
    let t2 = DVec3::new(b, sign + n.y * n.y * a, -n.y);
    (t1, t2)
}

/// Eigenvalues and eigenvectors of a symmetric 3 x 3 matrix by cyclic Jacobi rotations.
///
/// Returns (moments, axes) with `a = axes * diag(moments) * axes^T`; `axes` is a proper rotation.
/// Golub & Van Loan, Matrix Computations, 4th ed., algorithm 8.5.2. Converges quadratically: six sweeps reach rounding.
#[must_use]
pub fn symmetric_eigen(a: DMat3) -> (DVec3, DMat3) {
    let mut m = a.to_cols_array_2d();
    let mut v = DMat3::IDENTITY.to_cols_array_2d();
    for _sweep in 0..12 {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            rotate_jacobi(&mut m, &mut v, p, q);
        }
    }
    let mut axes = DMat3::from_cols_array_2d(&v);
    if axes.determinant() < 0.0 {
        axes.z_axis = -axes.z_axis;
    }
    (DVec3::new(m[0][0], m[1][1], m[2][2]), axes)
}

/// One Jacobi rotation that makes `m[p][q]` zero; `v` collects the rotations column by column.
fn rotate_jacobi(m: &mut [[f64; 3]; 3], v: &mut [[f64; 3]; 3], p: usize, q: usize) {
    if m[p][q].abs() <= f64::EPSILON * 1e-3 * (m[p][p].abs() + m[q][q].abs()) {
        m[p][q] = 0.0;
        m[q][p] = 0.0;
        return;
    }
    let tau = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
    let t = 1.0_f64.copysign(tau) / (tau.abs() + (1.0 + tau * tau).sqrt());
    let c = 1.0 / (1.0 + t * t).sqrt();
    let s = t * c;
    for row in m.iter_mut() {
        (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
    }
    let (mp, mq) = (m[p], m[q]);
    for k in 0..3 {
        m[p][k] = c * mp[k] - s * mq[k];
        m[q][k] = s * mp[k] + c * mq[k];
    }
    let (vp, vq) = (v[p], v[q]);
    for k in 0..3 {
        v[p][k] = c * vp[k] - s * vq[k];
        v[q][k] = s * vp[k] + c * vq[k];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eigen_rebuilds_the_matrix() {
        let a = DMat3::from_cols(
            DVec3::new(4.0, 0.3, -0.7),
            DVec3::new(0.3, 2.0, 0.5),
            DVec3::new(-0.7, 0.5, 3.0),
        );
        let (moments, axes) = symmetric_eigen(a);
        let back = axes * DMat3::from_diagonal(moments) * axes.transpose();
        assert!((back - a).to_cols_array().iter().all(|x| x.abs() < 1e-14));
        assert!((axes.determinant() - 1.0).abs() < 1e-14);
    }

    #[test]
    fn rotation_from_vector_is_continuous_where_the_series_takes_over() {
        let below = rotation_from_vector(DVec3::X * 0.999_999e-6);
        let above = rotation_from_vector(DVec3::X * 1.000_001e-6);
        assert!((below.x - above.x).abs() < 2e-12);
        let quarter = rotation_from_vector(DVec3::Z * std::f64::consts::FRAC_PI_2) * DVec3::X;
        assert!((quarter - DVec3::Y).length() < 1e-15);
    }

    #[test]
    fn rotation_vector_takes_back_rotation_from_vector() {
        for v in [
            DVec3::ZERO,
            DVec3::X * 1e-12,
            DVec3::new(0.3, -1.2, 0.5),
            DVec3::Z * 3.1,
        ] {
            assert!((rotation_vector(rotation_from_vector(v)) - v).length() < 1e-15);
            assert!((rotation_vector(-rotation_from_vector(v)) - v).length() < 1e-15);
        }
    }

    #[test]
    fn tangents_are_orthonormal() {
        for n in [DVec3::Z, -DVec3::Z, DVec3::X, DVec3::new(0.48, -0.6, 0.64)] {
            let (t1, t2) = tangents(n);
            assert!((t1.cross(t2) - n).length() < 1e-15);
            assert!((t1.length() - 1.0).abs() < 1e-15 && t1.dot(n).abs() < 1e-15);
        }
    }
}
