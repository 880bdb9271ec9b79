//! How bodies move, four abreast.

use glam::DVec3;
use pulp::Simd;

use crate::lanes::{transposed, Four, Lanes, Real, Vectors, WIDTH};
use crate::mover::{Twist, Window};

/// A twist in memory: velocity, angular velocity, and two numbers that are not used.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(align(64))]
pub(crate) struct Motion(pub(crate) [Four; 2]);

impl Motion {
    pub(crate) fn of(twist: &Twist) -> Self {
        let (v, w) = (twist.velocity, twist.angular_velocity);
        Self([[v.x, v.y, v.z, w.x], [w.y, w.z, 0.0, 0.0]])
    }

    pub(crate) fn twist(&self) -> Twist {
        let [[vx, vy, vz, wx], [wy, wz, ..]] = self.0;
        Twist {
            velocity: DVec3::new(vx, vy, vz),
            angular_velocity: DVec3::new(wx, wy, wz),
        }
    }
}

/// Twists of four bodies.
#[derive(Clone, Copy)]
pub(crate) struct Twists<S: Simd> {
    pub(crate) velocity: Vectors<S>,
    pub(crate) angular_velocity: Vectors<S>,
}

impl<S: Simd> Twists<S> {
    #[inline(always)]
    pub(crate) fn load(simd: S, motions: &Window<Motion>, bodies: [u32; WIDTH]) -> Self {
        let rows = bodies.map(|k| motions[k as usize].0);
        let columns = |half: usize| transposed(rows.map(|row| Lanes::load(simd, row[half])));
        let ([vx, vy, vz, wx], [wy, wz, ..]) = (columns(0), columns(1));
        Self {
            velocity: Vectors::new([vx, vy, vz]),
            angular_velocity: Vectors::new([wx, wy, wz]),
        }
    }

    /// The first comes last: it counts where other lanes have the same body.
    #[inline(always)]
    pub(crate) fn store(self, motions: &mut Window<Motion>, bodies: [u32; WIDTH]) {
        let [vx, vy, vz] = self.velocity.coordinates();
        let [wx, wy, wz] = self.angular_velocity.coordinates();
        let none = wx.constant(0.0);
        let first = transposed([vx, vy, vz, wx]).map(Lanes::store);
        let second = transposed([wy, wz, none, none]).map(Lanes::store);
        for lane in (0..WIDTH).rev() {
            motions[bodies[lane] as usize].0 = [first[lane], second[lane]];
        }
    }

    /// v + omega x r
    #[inline(always)]
    pub(crate) fn at(&self, r: Vectors<S>) -> Vectors<S> {
        self.velocity + self.angular_velocity.cross(r)
    }
}
