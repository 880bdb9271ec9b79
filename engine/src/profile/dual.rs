//! Numbers that carry their rate of change along (forward-mode differentiation).
//!
//! For f(a(t)) the rate is f'(a) da/dt; Griewank & Walther 2008, Evaluating Derivatives, 2nd ed., chapter 3. Where a
//! function has a kink the rate is the one to the right, where it jumps the rate is 0.

use std::f64::consts::LN_10;

use super::program::{Binary, Unary};

/// A value and its rate of change in time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Dual {
    pub(super) value: f64,
    /// [1/s]
    pub(super) rate: f64,
}

impl Dual {
    pub(super) fn constant(value: f64) -> Self {
        Self { value, rate: 0.0 }
    }

    /// f(self), given f and f' here. What does not change has rate 0 even where f' is infinite.
    fn map(self, value: f64, derivative: f64) -> Self {
        Self {
            value,
            rate: scaled(self.rate, derivative),
        }
    }

    pub(super) fn unary(self, function: Unary) -> Self {
        let x = self.value;
        match function {
            Unary::Negate => self.map(-x, -1.0),
            Unary::Sin => self.map(libm::sin(x), libm::cos(x)),
            Unary::Cos => self.map(libm::cos(x), -libm::sin(x)),
            Unary::Tan => {
                let t = libm::tan(x);
                self.map(t, 1.0 + t * t)
            }
            Unary::Asin => self.map(libm::asin(x), 1.0 / (1.0 - x * x).sqrt()),
            Unary::Acos => self.map(libm::acos(x), -1.0 / (1.0 - x * x).sqrt()),
            Unary::Atan => self.map(libm::atan(x), 1.0 / (1.0 + x * x)),
            Unary::Exp => {
                let e = libm::exp(x);
                self.map(e, e)
            }
            Unary::Log => self.map(libm::log(x), 1.0 / x),
            Unary::Log10 => self.map(libm::log10(x), 1.0 / (LN_10 * x)),
            Unary::Sqrt => self.map(x.sqrt(), 0.5 / x.sqrt()),
            Unary::Abs if x == 0.0 => self.map(0.0, self.rate.signum()),
            Unary::Abs => self.map(x.abs(), x.signum()),
            Unary::Floor => Self::constant(x.floor()),
            Unary::Ceil => Self::constant(x.ceil()),
            Unary::Round => Self::constant(x.round_ties_even()),
            Unary::Sinh => self.map(libm::sinh(x), libm::cosh(x)),
            Unary::Cosh => self.map(libm::cosh(x), libm::sinh(x)),
            Unary::Tanh => {
                let t = libm::tanh(x);
                self.map(t, 1.0 - t * t)
            }
        }
    }

    pub(super) fn binary(self, b: Self, function: Binary) -> Self {
        let a = self;
        let of = |value, rate| Self { value, rate };
        match function {
            Binary::Add => of(a.value + b.value, a.rate + b.rate),
            Binary::Subtract => of(a.value - b.value, a.rate - b.rate),
            Binary::Multiply => {
                let rate = scaled(a.rate, b.value) + scaled(b.rate, a.value);
                of(a.value * b.value, rate)
            }
            Binary::Divide => {
                let quotient = a.value / b.value;
                let rate = scaled(a.rate, 1.0 / b.value) - scaled(b.rate, quotient / b.value);
                of(quotient, rate)
            }
            Binary::Power => a.power(b),
            Binary::Atan2 => {
                let square = a.value * a.value + b.value * b.value;
                let turn = scaled(a.rate, b.value / square) - scaled(b.rate, a.value / square);
                of(libm::atan2(a.value, b.value), turn)
            }
            Binary::Min if a.value == b.value => of(a.value, a.rate.min(b.rate)),
            Binary::Min => [b, a][usize::from(a.value < b.value)],
            Binary::Max if a.value == b.value => of(a.value, a.rate.max(b.rate)),
            Binary::Max => [b, a][usize::from(a.value > b.value)],
            Binary::Hypot => a.hypot(b),
        }
    }

    /// d(a^b) = b a^(b-1) da + a^b ln(a) db
    fn power(self, b: Self) -> Self {
        let value = libm::pow(self.value, b.value);
        let slope = b.value * libm::pow(self.value, b.value - 1.0);
        let base = if b.value == 0.0 {
            0.0
        } else {
            scaled(self.rate, slope)
        };
        Self {
            value,
            rate: base + scaled(b.rate, value * libm::log(self.value)),
        }
    }

    fn hypot(self, b: Self) -> Self {
        let value = libm::hypot(self.value, b.value);
        let rate = if value == 0.0 {
            libm::hypot(self.rate, b.rate)
        } else {
            self.value / value * self.rate + b.value / value * b.rate
        };
        Self { value, rate }
    }
}

/// rate times derivative, 0 where nothing changes.
fn scaled(rate: f64, derivative: f64) -> f64 {
    if rate == 0.0 {
        0.0
    } else {
        rate * derivative
    }
}
