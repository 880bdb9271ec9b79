//! Numbers four abreast: the same arithmetic on each, in vector instructions where the processor has them. What is
//! generic over [`Real`] gives the same bits alone and in a lane.

use std::ops::{Add, Div, Mul, Neg, Sub};

use glam::DVec3;
use pulp::bytemuck::cast;
use pulp::{Scalar256b, Simd, WithSimd};

/// How many numbers stand abreast.
pub(crate) const WIDTH: usize = 4;

/// Numbers abreast, in memory.
pub(crate) type Four = [f64; WIDTH];

/// A number, or several abreast.
pub(crate) trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// A yes or no to each.
    type Mask: Mask<Self>;

    /// A constant, as many abreast as this has.
    fn constant(self, value: f64) -> Self;
    fn sqrt(self) -> Self;
    fn abs(self) -> Self;
    fn max(self, other: Self) -> Self;
    /// self <= other
    fn within(self, other: Self) -> Self::Mask;
}

/// A yes or no to each of some numbers abreast.
pub(crate) trait Mask<T>: Copy {
    /// `yes` where it says so, else `no`.
    fn select(self, yes: T, no: T) -> T;
    fn not(self) -> Self;
    fn and(self, other: Self) -> Self;
    fn any(self) -> bool;
}

impl Real for f64 {
    type Mask = bool;

    #[inline(always)]
    fn constant(self, value: f64) -> f64 {
        value
    }

    #[inline(always)]
    fn sqrt(self) -> f64 {
        f64::sqrt(self)
    }

    #[inline(always)]
    fn abs(self) -> f64 {
        f64::abs(self)
    }

    #[inline(always)]
    fn max(self, other: f64) -> f64 {
        f64::max(self, other)
    }

    #[inline(always)]
    fn within(self, other: f64) -> bool {
        self <= other
    }
}

impl Mask<f64> for bool {
    #[inline(always)]
    fn select(self, yes: f64, no: f64) -> f64 {
        if self {
            yes
        } else {
            no
        }
    }

    #[inline(always)]
    fn not(self) -> bool {
        !self
    }

    #[inline(always)]
    fn and(self, other: bool) -> bool {
        self & other
    }

    #[inline(always)]
    fn any(self) -> bool {
        self
    }
}

/// Numbers abreast in a register of `S`, which must have [`WIDTH`] of them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lanes<S: Simd> {
    simd: S,
    numbers: S::f64s,
}

/// A yes or no to each of them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Verdicts<S: Simd> {
    simd: S,
    verdicts: S::m64s,
}

impl<S: Simd> Lanes<S> {
    #[inline(always)]
    pub(crate) fn load(simd: S, numbers: Four) -> Self {
        let numbers = cast(numbers);
        Self { simd, numbers }
    }

    #[inline(always)]
    pub(crate) fn store(self) -> Four {
        cast(self.numbers)
    }

    #[inline(always)]
    fn with(self, numbers: S::f64s) -> Self {
        Self { numbers, ..self }
    }
}

/// Columns of a square whose rows these are.
#[inline(always)]
pub(crate) fn transposed<S: Simd>(rows: [Lanes<S>; WIDTH]) -> [Lanes<S>; WIDTH] {
    let simd = rows[0].simd;
    let [a, b, c, d] = rows.map(Lanes::store);
    let pairs = |a: Four, b: Four| ([a[0], b[0], a[2], b[2]], [a[1], b[1], a[3], b[3]]);
    let ((even, odd), (even_2, odd_2)) = (pairs(a, b), pairs(c, d));
    let halves = |a: Four, b: Four| ([a[0], a[1], b[0], b[1]], [a[2], a[3], b[2], b[3]]);
    let ((first, third), (second, fourth)) = (halves(even, even_2), halves(odd, odd_2));
    [first, second, third, fourth].map(|column| Lanes::load(simd, column))
}

impl<S: Simd> Real for Lanes<S> {
    type Mask = Verdicts<S>;

    #[inline(always)]
    fn constant(self, value: f64) -> Self {
        self.with(self.simd.splat_f64s(value))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.with(self.simd.sqrt_f64s(self.numbers))
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.with(self.simd.abs_f64s(self.numbers))
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.with(self.simd.max_f64s(self.numbers, other.numbers))
    }

    #[inline(always)]
    fn within(self, other: Self) -> Verdicts<S> {
        let simd = self.simd;
        let verdicts = simd.less_than_or_equal_f64s(self.numbers, other.numbers);
        Verdicts { simd, verdicts }
    }
}

impl<S: Simd> Mask<Lanes<S>> for Verdicts<S> {
    #[inline(always)]
    fn select(self, yes: Lanes<S>, no: Lanes<S>) -> Lanes<S> {
        yes.with(
            self.simd
                .select_f64s(self.verdicts, yes.numbers, no.numbers),
        )
    }

    #[inline(always)]
    fn not(self) -> Self {
        let verdicts = self.simd.not_m64s(self.verdicts);
        Self { verdicts, ..self }
    }

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        let verdicts = self.simd.and_m64s(self.verdicts, other.verdicts);
        Self { verdicts, ..self }
    }

    #[inline(always)]
    fn any(self) -> bool {
        let [a, b, c, d]: [u64; WIDTH] = cast(self.verdicts);
        a | b | c | d != 0
    }
}

macro_rules! lane_by_lane {
    ($operator:ident, $function:ident, $instruction:ident) => {
        impl<S: Simd> $operator for Lanes<S> {
            type Output = Self;

            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                self.with(self.simd.$instruction(self.numbers, other.numbers))
            }
        }
    };
}

lane_by_lane!(Add, add, add_f64s);
lane_by_lane!(Sub, sub, sub_f64s);
lane_by_lane!(Mul, mul, mul_f64s);
lane_by_lane!(Div, div, div_f64s);

impl<S: Simd> Neg for Lanes<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.with(self.simd.neg_f64s(self.numbers))
    }
}

/// Vectors abreast, in memory.
pub(crate) type FourVectors = [Four; 3];

/// One coordinate of all of them after the other.
#[inline(always)]
pub(crate) fn abreast(vectors: [DVec3; WIDTH]) -> FourVectors {
    [
        vectors.map(|v| v.x),
        vectors.map(|v| v.y),
        vectors.map(|v| v.z),
    ]
}

/// Vectors abreast.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Vectors<S: Simd> {
    x: Lanes<S>,
    y: Lanes<S>,
    z: Lanes<S>,
}

impl<S: Simd> Vectors<S> {
    #[inline(always)]
    pub(crate) fn new([x, y, z]: [Lanes<S>; 3]) -> Self {
        Self { x, y, z }
    }

    #[inline(always)]
    pub(crate) fn load(simd: S, vectors: FourVectors) -> Self {
        Self::new(vectors.map(|numbers| Lanes::load(simd, numbers)))
    }

    #[inline(always)]
    pub(crate) fn simd(&self) -> S {
        self.x.simd
    }

    #[inline(always)]
    pub(crate) fn coordinates(self) -> [Lanes<S>; 3] {
        [self.x, self.y, self.z]
    }

    #[inline(always)]
    pub(crate) fn dot(self, other: Self) -> Lanes<S> {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    #[inline(always)]
    pub(crate) fn cross(self, other: Self) -> Self {
        Self {
            x: self.y * other.z - other.y * self.z,
            y: self.z * other.x - other.z * self.x,
            z: self.x * other.y - other.x * self.y,
        }
    }

    /// A symmetric matrix, given by xx, yy, zz, yz, zx, xy, times these vectors.
    #[inline(always)]
    pub(crate) fn transformed(self, [xx, yy, zz, yz, zx, xy]: [Lanes<S>; 6]) -> Self {
        Self {
            x: xx * self.x + xy * self.y + zx * self.z,
            y: xy * self.x + yy * self.y + yz * self.z,
            z: zx * self.x + yz * self.y + zz * self.z,
        }
    }
}

impl<S: Simd> Mul<Lanes<S>> for Vectors<S> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: Lanes<S>) -> Self {
        Self {
            x: self.x * factor,
            y: self.y * factor,
            z: self.z * factor,
        }
    }
}

impl<S: Simd> Add for Vectors<S> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            x: self.x + other.x,
            y: self.y + other.y,
            z: self.z + other.z,
        }
    }
}

impl<S: Simd> Sub for Vectors<S> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self {
            x: self.x - other.x,
            y: self.y - other.y,
            z: self.z - other.z,
        }
    }
}

impl<S: Simd> Neg for Vectors<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self {
            x: -self.x,
            y: -self.y,
            z: -self.z,
        }
    }
}

/// Work done with the instructions that this processor has; in either way with the same bits. What it calls must be
/// inlined to have them, too.
pub(crate) fn vectorised<W: WithSimd>(work: W) -> W::Output {
    #[cfg(target_arch = "x86_64")]
    if let Some(simd) = pulp::x86::V3::try_new() {
        return Simd::vectorize(simd, work);
    }
    Scalar256b.vectorize(work)
}
