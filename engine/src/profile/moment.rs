//! An instant and the step that it belongs to.

/// Parts of a step below this are rounding of the clock.
const ROUNDING: f64 = 1e-9;

/// An instant seen from inside a step, or by itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    /// [s]
    pub time: f64,
    /// Start of the step [s].
    start: f64,
    /// Length of the step [s]; 0 for an instant by itself.
    length: f64,
}

impl Moment {
    /// By itself.
    #[must_use]
    pub fn at(time: f64) -> Self {
        Self::within(time, (time, 0.0))
    }

    /// Of a step, given by its start and its length [s].
    #[must_use]
    pub fn within(time: f64, (start, length): (f64, f64)) -> Self {
        Self {
            time,
            start,
            length,
        }
    }

    /// Which part of the step lies in [from, until); of an instant by itself all or nothing.
    #[must_use]
    pub fn share(&self, from: f64, until: f64) -> f64 {
        if self.length == 0.0 {
            return f64::from(u8::from(from <= self.time && self.time < until));
        }
        let first = (from - self.start).max(0.0);
        let last = (until - self.start).min(self.length);
        let share = (last - first) / self.length;
        if share > 1.0 - ROUNDING {
            1.0
        } else if share < ROUNDING {
            0.0
        } else {
            share
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const INFINITE: f64 = f64::INFINITY;

    #[test]
    fn shares_of_all_steps_make_the_window() {
        let (from, until, h) = (0.103_7, 0.500_81, 1e-2);
        let steps = (0..100).map(|k| f64::from(k) * h);
        let sum: f64 = steps
            .map(|t| Moment::within(t, (t, h)).share(from, until) * h)
            .sum();
        assert!((sum - (until - from)).abs() < 1e-15);
    }

    #[test]
    fn a_window_inside_one_step() {
        let share = Moment::within(0.1, (0.0, 0.1)).share(0.02, 0.05);
        assert!((share - 0.3).abs() < 1e-15);
    }

    #[test]
    fn steps_that_end_at_an_edge_are_whole() {
        let share =
            |start: f64, from: f64| Moment::within(start, (start, 0.1)).share(from, INFINITE);
        assert_eq!(share(3.0 * 0.1, 0.3), 1.0); // 3.0 * 0.1 > 0.3
        assert_eq!(share(2.0 * 0.1, 0.3), 0.0);
        assert_eq!(share(0.0, 0.0), 1.0);
        assert_eq!(share(0.0, f64::NEG_INFINITY), 1.0);
    }

    #[test]
    fn an_instant_is_inside_or_not() {
        let shares = [0.99, 1.0, 1.5, 2.0].map(|t| Moment::at(t).share(1.0, 2.0));
        assert_eq!(shares, [0.0, 1.0, 1.0, 0.0]);
    }
}
