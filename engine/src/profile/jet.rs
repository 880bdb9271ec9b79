//! Numbers that carry their first and second rate of change along (forward-mode differentiation).
//!
//! Griewank & Walther 2008, Evaluating Derivatives, 2nd ed., chapter 13. Where a function has a kink its rates are those
//! to the right, where it jumps they are 0.

use std::f64::consts::LN_10;

use super::program::{Binary, Unary};

/// A value and its rates of change in time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Jet {
    pub(super) value: f64,
    /// [1/s]
    pub(super) rate: f64,
    /// Rate of the rate [1/s^2].
    pub(super) curvature: f64,
}

impl Jet {
    pub(super) fn constant(value: f64) -> Self {
        Self {
            value,
            rate: 0.0,
            curvature: 0.0,
        }
    }

    /// The time itself.
    pub(super) fn time(t: f64) -> Self {
        Self {
            value: t,
            rate: 1.0,
            curvature: 0.0,
        }
    }

    /// f(a) with f, f', f'' given here: d2f/dt2 = f' a'' + f'' a'^2.
    fn map(self, value: f64, first: f64, second: f64) -> Self {
        Self {
            value,
            rate: times(self.rate, first),
            curvature: times(self.curvature, first) + times(self.rate * self.rate, second),
        }
    }

    /// f(a, b) with f, (`f_a`, `f_b`) and (`f_aa`, `f_ab`, `f_bb`) given here.
    fn join(self, b: Self, value: f64, first: [f64; 2], second: [f64; 3]) -> Self {
        let a = self;
        Self {
            value,
            rate: times(a.rate, first[0]) + times(b.rate, first[1]),
            curvature: times(a.curvature, first[0])
                + times(b.curvature, first[1])
                + times(a.rate * a.rate, second[0])
                + times(2.0 * a.rate * b.rate, second[1])
                + times(b.rate * b.rate, second[2]),
        }
    }

    pub(super) fn unary(self, function: Unary) -> Self {
        let x = self.value;
        match function {
            Unary::Negate => self.map(-x, -1.0, 0.0),
            Unary::Sin => self.map(libm::sin(x), libm::cos(x), -libm::sin(x)),
            Unary::Cos => self.map(libm::cos(x), -libm::sin(x), -libm::cos(x)),
            Unary::Tan => {
                let t = libm::tan(x);
                self.map(t, 1.0 + t * t, 2.0 * t * (1.0 + t * t))
            }
            Unary::Asin => {
                let r = 1.0 / (1.0 - x * x).sqrt();
                self.map(libm::asin(x), r, x * r * r * r)
            }
            Unary::Acos => {
                let r = 1.0 / (1.0 - x * x).sqrt();
                self.map(libm::acos(x), -r, -x * r * r * r)
            }
            Unary::Atan => {
                let r = 1.0 / (1.0 + x * x);
                self.map(libm::atan(x), r, -2.0 * x * r * r)
            }
            Unary::Exp => {
                let e = libm::exp(x);
                self.map(e, e, e)
            }
            Unary::Log => self.map(libm::log(x), 1.0 / x, -1.0 / (x * x)),
            Unary::Log10 => self.map(libm::log10(x), 1.0 / (LN_10 * x), -1.0 / (LN_10 * x * x)),
            Unary::Sqrt => self.map(x.sqrt(), 0.5 / x.sqrt(), -0.25 / (x * x.sqrt())),
            Unary::Abs if x == 0.0 => self.map(0.0, self.rate.signum(), 0.0),
            Unary::Abs => self.map(x.abs(), x.signum(), 0.0),
            Unary::Floor => Self::constant(x.floor()),
            Unary::Ceil => Self::constant(x.ceil()),
            Unary::Round => Self::constant(x.round_ties_even()),
            Unary::Sinh => self.map(libm::sinh(x), libm::cosh(x), libm::sinh(x)),
            Unary::Cosh => self.map(libm::cosh(x), libm::sinh(x), libm::cosh(x)),
            Unary::Tanh => {
                let t = libm::tanh(x);
                self.map(t, 1.0 - t * t, -2.0 * t * (1.0 - t * t))
            }
        }
    }

    pub(super) fn binary(self, b: Self, function: Binary) -> Self {
        let (x, y) = (self.value, b.value);
        match function {
            Binary::Add => self.join(b, x + y, [1.0, 1.0], [0.0; 3]),
            Binary::Subtract => self.join(b, x - y, [1.0, -1.0], [0.0; 3]),
            Binary::Multiply => self.join(b, x * y, [y, x], [0.0, 1.0, 0.0]),
            Binary::Divide => {
                let (q, r) = (x / y, 1.0 / y);
                self.join(b, q, [r, -q * r], [0.0, -r * r, 2.0 * q * r * r])
            }
            Binary::Power => self.power(b),
            Binary::Atan2 => self.atan2(b),
            Binary::Min => [b, self][usize::from(self.is_below(b))],
            Binary::Max => [self, b][usize::from(self.is_below(b))],
            Binary::Hypot => self.hypot(b),
        }
    }

    /// Smaller than `b`, or about to be.
    fn is_below(self, b: Self) -> bool {
        (self.value, self.rate) < (b.value, b.rate)
    }

    /// x^y: `f_x` = y x^(y-1), `f_y` = x^y ln x, and theirs.
    fn power(self, b: Self) -> Self {
        let (x, y) = (self.value, b.value);
        let (value, log) = (libm::pow(x, y), libm::log(x));
        let below = |k: f64| libm::pow(x, y - k);
        let first = [times(y, below(1.0)), value * log];
        let second = [
            times(y * (y - 1.0), below(2.0)),
            below(1.0) * (1.0 + y * log),
            value * log * log,
        ];
        self.join(b, value, first, second)
    }

    /// The angle of the point (y, x) with y = self: `f_y` = x / r^2, `f_x` = -y / r^2.
    fn atan2(self, b: Self) -> Self {
        let (y, x) = (self.value, b.value);
        let r2 = x * x + y * y;
        let (u, v) = (x / r2, y / r2);
        let second = [-2.0 * u * v, v * v - u * u, 2.0 * u * v];
        self.join(b, libm::atan2(y, x), [u, -v], second)
    }

    /// sqrt(x^2 + y^2), whose gradient is a unit vector; from the origin it leaves along a straight line.
    fn hypot(self, b: Self) -> Self {
        let value = libm::hypot(self.value, b.value);
        if value == 0.0 {
            return Self {
                value,
                rate: libm::hypot(self.rate, b.rate),
                curvature: 0.0,
            };
        }
        let (u, v) = (self.value / value, b.value / value);
        let second = [v * v / value, -u * v / value, u * u / value];
        self.join(b, value, [u, v], second)
    }
}

/// A product that is 0 when its first factor is, even where the other is infinite: what does not change has no rate,
/// however steep the function.
fn times(change: f64, slope: f64) -> f64 {
    if change == 0.0 {
        0.0
    } else {
        change * slope
    }
}
