//! Scalar functions of how two joint frames lie to each other, with Jacobian and bias: what joints hold at zero and
//! what they call their coordinates.
//!
//! Notation: x, y, z of A and B are the columns of the joint frames, d the way from the anchor of A to that of B, r the
//! arms, omega the angular velocities. The bias is d2C/dt2 with all accelerations zero; the time derivative of a vector u
//! fixed to A is then u' = omega_A x u and u'' = omega_A x (omega_A x u).

use glam::{DMat3, DVec3};

use super::placement::{Motion, Placement};
use super::row::Row;

/// What is measured. Numbers are axes of A: 0 x, 1 y, 2 z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Measure {
    /// Way of B along an axis of A [m].
    Gap(usize),
    /// Distance of the anchors [m].
    Length,
    /// Component of 2 sin(angle / 2) n of the rotation (angle, n) from frame A to frame B.
    Turn(usize),
    /// Component along x or y of A of the lean of z of B out of z of A, as long as 2 sin(angle / 2).
    Lean(usize),
    /// Cosine of the angle between z of A and x of B.
    Square,
    /// Angle of x of B about z of A [rad].
    Twist,
    /// Angle of B about its x axis, counted from where the z axes agree [rad].
    Bend,
    /// Angle between the z axes [rad], never negative.
    Tilt,
}

/// Below this sine or cosine a direction is rounding noise, and any direction does.
const NO_DIRECTION: f64 = 1e-9;

/// A function of the relative rotation: value, Jacobian of omega_B (that of omega_A is the opposite), first and second
/// time derivative without accelerations.
#[derive(Clone, Copy)]
struct Slope {
    value: f64,
    angular: DVec3,
    rate: f64,
    bias: f64,
}

/// Derivatives of a function f(s, c) of two slopes.
struct Partials {
    s: f64,
    c: f64,
    ss: f64,
    sc: f64,
    cc: f64,
}

impl Measure {
    /// It is an angle, or as small as one.
    pub(super) const fn is_angular(self) -> bool {
        !matches!(self, Self::Gap(_) | Self::Length)
    }

    /// It comes back to the same value after a turn.
    pub(super) const fn wraps(self) -> bool {
        matches!(self, Self::Twist | Self::Bend)
    }

    /// Its value; angles within half a turn of zero.
    pub(super) fn value(self, at: &Placement) -> f64 {
        match self {
            Self::Gap(k) => at.axes.col(k).dot(at.gap),
            Self::Length => at.gap.length(),
            Self::Turn(k) => {
                let turn = at.turn();
                2.0 * sign(turn.w) * turn.xyz()[k]
            }
            _ => self.value_of_axes(&at.axes, &at.axes_of_b()),
        }
    }

    fn value_of_axes(self, a: &DMat3, b: &DMat3) -> f64 {
        match self {
            Self::Gap(_) | Self::Length | Self::Turn(_) => unreachable!("not of the axes alone"),
            Self::Lean(k) => lean(a.col(k).dot(b.z_axis), a.z_axis.dot(b.z_axis)),
            Self::Square => a.z_axis.dot(b.x_axis),
            Self::Twist => libm::atan2(a.y_axis.dot(b.x_axis), a.x_axis.dot(b.x_axis)),
            Self::Bend => libm::atan2(a.z_axis.dot(b.y_axis), a.z_axis.dot(b.z_axis)),
            Self::Tilt => libm::atan2(a.z_axis.cross(b.z_axis).length(), a.z_axis.dot(b.z_axis)),
        }
    }

    /// Its row, with `value` as the value.
    #[inline(always)]
    pub(super) fn row(self, at: &Placement, motion: Option<&Motion>) -> Row {
        match self {
            Self::Gap(k) => gap(at.axes.col(k), at, motion),
            Self::Length => length(at, motion.unwrap_or(&Motion::NONE)),
            _ => self.turning_row(at, motion.unwrap_or(&Motion::NONE)),
        }
    }

    fn turning_row(self, at: &Placement, motion: &Motion) -> Row {
        let slope = self.slope(at, motion);
        at.turning(slope.angular, self.value(at), slope.bias)
    }

    fn slope(self, at: &Placement, motion: &Motion) -> Slope {
        let (a, b) = (&at.axes, &at.axes_of_b());
        let dot = |u, w| alignment(motion, u, w);
        match self {
            Self::Gap(_) | Self::Length => unreachable!("not a function of the rotation"),
            Self::Turn(k) => turn(k, at, motion),
            Self::Lean(k) => lean_slope(&dot(a.col(k), b.z_axis), &dot(a.z_axis, b.z_axis)),
            Self::Square => dot(a.z_axis, b.x_axis),
            Self::Twist => angle(&dot(a.y_axis, b.x_axis), &dot(a.x_axis, b.x_axis)),
            Self::Bend => angle(&dot(a.z_axis, b.y_axis), &dot(a.z_axis, b.z_axis)),
            Self::Tilt => tilt(at, motion),
        }
    }
}

/// C = e . d with e fixed to A.
///
/// C'  = e . d' + (omega_A x e) . d, d' = v_B + omega_B x r_B - v_A - omega_A x r_A:
///       A (-e, -(r_A + d) x e), B (e, r_B x e)
/// C'' = e . d'' + 2 (omega_A x e) . d' + (omega_A x (omega_A x e)) . d
#[inline(always)]
fn gap(e: DVec3, at: &Placement, motion: Option<&Motion>) -> Row {
    let bias = motion.map_or(0.0, |motion| {
        let spin = motion.spins.0;
        let e_rate = spin.cross(e);
        e.dot(motion.gap_bias) + 2.0 * e_rate.dot(motion.gap_rate) + spin.cross(e_rate).dot(at.gap)
    });
    at.pulling(e, at.arms.0 + at.gap, e.dot(at.gap), bias)
}

/// C = |d|, n = d / |d|.
///
/// C'  = n . d':  A (-n, -r_A x n), B (n, r_B x n)
/// C'' = n . d'' + (|d'|^2 - (n . d')^2) / |d|
///
/// Where the anchors coincide n is the z axis of A, and the last term, which has no limit there, is left out.
fn length(at: &Placement, motion: &Motion) -> Row {
    let distance = at.gap.length();
    let (n, curvature) = if distance > NO_DIRECTION {
        let n = at.gap / distance;
        let across = motion.gap_rate - n * n.dot(motion.gap_rate);
        (n, across.length_squared() / distance)
    } else {
        (at.axes.z_axis, 0.0)
    };
    at.pulling(n, at.arms.0, distance, n.dot(motion.gap_bias) + curvature)
}

/// s = u . w with u fixed to A and w fixed to B.
///
/// s'  = (omega_A x u) . w + u . (omega_B x w) = (omega_B - omega_A) . (w x u)
/// s'' = u'' . w + 2 u' . w' + u . w''
fn alignment(motion: &Motion, u: DVec3, w: DVec3) -> Slope {
    let (spin_a, spin_b) = motion.spins;
    let (u_rate, w_rate) = (spin_a.cross(u), spin_b.cross(w));
    let angular = w.cross(u);
    Slope {
        value: u.dot(w),
        angular,
        rate: (spin_b - spin_a).dot(angular),
        bias: spin_a.cross(u_rate).dot(w) + 2.0 * u_rate.dot(w_rate) + u.dot(spin_b.cross(w_rate)),
    }
}

/// The chain rule: f' = f_s s' + f_c c', f'' = f_s s'' + f_c c'' + f_ss s'^2 + 2 f_sc s' c' + f_cc c'^2.
fn compose(value: f64, f: &Partials, s: &Slope, c: &Slope) -> Slope {
    Slope {
        value,
        angular: f.s * s.angular + f.c * c.angular,
        rate: f.s * s.rate + f.c * c.rate,
        bias: f.s * s.bias
            + f.c * c.bias
            + f.ss * s.rate * s.rate
            + 2.0 * f.sc * s.rate * c.rate
            + f.cc * c.rate * c.rate,
    }
}

/// f = atan2(s, c), r^2 = s^2 + c^2: f_s = c / r^2, f_c = -s / r^2, f_ss = -2 s c / r^4 = -f_cc, f_sc = (s^2 - c^2) / r^4.
///
/// r is 1 where the joint holds; it vanishes where the axes have come loose by a quarter turn, and there any slope does.
fn angle(s: &Slope, c: &Slope) -> Slope {
    let square = (s.value * s.value + c.value * c.value).max(NO_DIRECTION);
    let bent = 2.0 * s.value * c.value / (square * square);
    let f = Partials {
        s: c.value / square,
        c: -s.value / square,
        ss: -bent,
        sc: (s.value * s.value - c.value * c.value) / (square * square),
        cc: bent,
    };
    compose(libm::atan2(s.value, c.value), &f, s, c)
}

/// cos(angle / 2) of the lean whose cosine is `c`, kept off zero.
fn half_cosine(c: f64) -> f64 {
    (0.5 * (1.0 + c)).max(NO_DIRECTION).sqrt()
}

/// f = s / h with h = cos(angle / 2) = sqrt((1 + c) / 2).
///
/// s = sin(angle) times a direction cosine alone would be zero after half a turn too; f grows up to there.
fn lean(s: f64, c: f64) -> f64 {
    s / half_cosine(c)
}

/// With h_c = 1 / (4 h): f_s = 1 / h, f_c = -s / (4 h^3), f_ss = 0, f_sc = -1 / (4 h^3), f_cc = 3 s / (16 h^5).
fn lean_slope(s: &Slope, c: &Slope) -> Slope {
    let h = half_cosine(c.value);
    let cubed = h * h * h;
    let f = Partials {
        s: 1.0 / h,
        c: -s.value / (4.0 * cubed),
        ss: 0.0,
        sc: -1.0 / (4.0 * cubed),
        cc: 3.0 * s.value / (16.0 * cubed * h * h),
    };
    compose(lean(s.value, c.value), &f, s, c)
}

/// C = 2 v_k of the quaternion (w, v) from frame A to frame B, taken with w >= 0: 2 sin(angle / 2) n_k.
///
/// With W = omega_B - omega_A and W_A = omega_A, both in axes of A: w' = -W . v / 2, v' = (w W + W x v) / 2, and W' = -W_A x W
/// because the axes turn. Hence
///
/// C'  = (w e_k + v x e_k) . W
/// C'' = (w e_k + v x e_k) . W' - |W|^2 v_k / 2, for -(W . v) W + W x (W x v) = -|W|^2 v
///
/// Dot products of axes (Shabana's and Chrono's usual choice) would be zero after 180 degrees too; this is zero only where
/// the frames agree, and flips at 180 degrees, where both ways back are equally long.
fn turn(k: usize, at: &Placement, motion: &Motion) -> Slope {
    let axes = &at.axes;
    let to_a = axes.transpose();
    let spin_a = to_a * motion.spins.0;
    let spin = to_a * (motion.spins.1 - motion.spins.0);
    let turn = at.turn();
    let side = sign(turn.w);
    let (w, v) = (side * turn.w, side * turn.xyz());
    let e = DVec3::AXES[k];
    let slope = w * e + v.cross(e);
    Slope {
        value: 2.0 * v[k],
        angular: *axes * slope,
        rate: slope.dot(spin),
        bias: -slope.dot(spin_a.cross(spin)) - 0.5 * spin.length_squared() * v[k],
    }
}

/// C = angle between the z axes, n = z_A x z_B / sin C.
///
/// C' = n . (omega_B - omega_A); from c = cos C: C'' = -(c'' + c C'^2) / sin C.
///
/// Where the axes agree n is the x axis of A and the bias, which has no limit there, is left out.
fn tilt(at: &Placement, motion: &Motion) -> Slope {
    let (a, b) = (at.axes.z_axis, at.axes_of_b().z_axis);
    let cross = a.cross(b);
    let sine = cross.length();
    let cosine = alignment(motion, a, b);
    let n = if sine > NO_DIRECTION {
        cross / sine
    } else {
        at.axes.x_axis
    };
    let rate = n.dot(motion.spins.1 - motion.spins.0);
    let bias = if sine > NO_DIRECTION {
        -(cosine.bias + cosine.value * rate * rate) / sine
    } else {
        0.0
    };
    Slope {
        value: libm::atan2(sine, cosine.value),
        angular: n,
        rate,
        bias,
    }
}

/// 1 or -1; 1 for zero.
fn sign(x: f64) -> f64 {
    if x < 0.0 {
        -1.0
    } else {
        1.0
    }
}
