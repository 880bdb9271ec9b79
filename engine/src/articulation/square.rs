//! Vectors and matrices of three rows. A column has a fourth place, always 0, so that it fills a register of four numbers
//! where the processor has them (`lanes::vectorised`).

use std::ops::{Add, AddAssign, Index, IndexMut, Mul, Sub, SubAssign};

use glam::DVec3;

/// Three numbers, and 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(align(32))]
pub(crate) struct Column([f64; 4]);

impl Column {
    pub(crate) const ZERO: Self = Self([0.0; 4]);
    pub(crate) const AXES: [Self; 3] = [
        Self([1.0, 0.0, 0.0, 0.0]),
        Self([0.0, 1.0, 0.0, 0.0]),
        Self([0.0, 0.0, 1.0, 0.0]),
    ];

    #[inline(always)]
    pub(crate) const fn new([x, y, z]: [f64; 3]) -> Self {
        Self([x, y, z, 0.0])
    }

    #[inline(always)]
    pub(crate) fn to_array(self) -> [f64; 3] {
        let [x, y, z, _] = self.0;
        [x, y, z]
    }

    #[inline(always)]
    pub(crate) fn dot(self, other: DVec3) -> f64 {
        self.0[0] * other.x + self.0[1] * other.y + self.0[2] * other.z
    }

    /// Greatest magnitude.
    pub(crate) fn greatest(self) -> f64 {
        DVec3::from_array(self.to_array()).abs().max_element()
    }

    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let (a, b) = (self.0, other.0);
        Self([f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2]), f(a[3], b[3])])
    }
}

impl Index<usize> for Column {
    type Output = f64;

    #[inline(always)]
    fn index(&self, row: usize) -> &f64 {
        &self.0[row]
    }
}

impl IndexMut<usize> for Column {
    #[inline(always)]
    fn index_mut(&mut self, row: usize) -> &mut f64 {
        &mut self.0[row]
    }
}

impl Add for Column {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl Sub for Column {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

impl Mul<f64> for Column {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: f64) -> Self {
        self.zip(self, |a, _| a * factor)
    }
}

/// Row by row.
impl Mul for Column {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip(other, |a, b| a * b)
    }
}

impl AddAssign for Column {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Column {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

/// A matrix of three columns.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Square(pub(crate) [Column; 3]);

impl Square {
    pub(crate) const ZERO: Self = Self([Column::ZERO; 3]);

    #[inline(always)]
    pub(crate) fn transposed(self) -> Self {
        let [a, b, c] = self.0;
        let row = |k: usize| Column::new([a[k], b[k], c[k]]);
        Self([row(0), row(1), row(2)])
    }

    #[inline(always)]
    pub(crate) fn diagonal(&self) -> [f64; 3] {
        [self.0[0][0], self.0[1][1], self.0[2][2]]
    }

    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(Column, Column) -> Column) -> Self {
        let (a, b) = (self.0, other.0);
        Self([f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2])])
    }
}

impl Mul<Column> for Square {
    type Output = Column;

    #[inline(always)]
    fn mul(self, x: Column) -> Column {
        let [a, b, c] = self.0;
        a * x[0] + b * x[1] + c * x[2]
    }
}

impl Mul for Square {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let [a, b, c] = other.0;
        Self([self * a, self * b, self * c])
    }
}

impl AddAssign for Square {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = self.zip(other, |a, b| a + b);
    }
}

impl SubAssign for Square {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = self.zip(other, |a, b| a - b);
    }
}
