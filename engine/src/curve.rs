//! A function of one variable made of straight pieces, with its integral.

/// value + slope (x - start), and the integral of the curve from 0 to x.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Piece {
    start: f64,
    value: f64,
    slope: f64,
    /// Of the curve, from 0 to `start`.
    integral: f64,
}

impl Piece {
    fn new(start: f64, value: f64, slope: f64) -> Self {
        Self {
            start,
            value,
            slope,
            integral: 0.0,
        }
    }

    /// The straight line through two samples; flat where they stand above each other.
    fn between(a: (f64, f64), b: (f64, f64)) -> Self {
        let width = b.0 - a.0;
        let slope = if width > 0.0 {
            (b.1 - a.1) / width
        } else {
            0.0
        };
        Self::new(a.0, a.1, slope)
    }

    fn value_at(&self, x: f64) -> f64 {
        self.value + self.slope * (x - self.start)
    }

    fn integral_at(&self, x: f64) -> f64 {
        let d = x - self.start;
        self.integral + d * (self.value + 0.5 * self.slope * d)
    }
}

/// Straight pieces, one after the other; the first reaches to minus infinity, the last to infinity.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// By rising start; at a jump the later piece counts.
    pieces: Vec<Piece>,
}

impl Curve {
    /// `value + slope x`.
    #[must_use]
    pub fn line(value: f64, slope: f64) -> Self {
        Self::of(vec![Piece::new(0.0, value, slope)])
    }

    /// Straight lines between `samples` (x, y) with rising x, at least one, extrapolated along the outermost lines.
    #[must_use]
    pub fn extended(samples: &[(f64, f64)]) -> Self {
        if let [(x, y)] = *samples {
            return Self::of(vec![Piece::new(x, y, 0.0)]);
        }
        let lines = samples.windows(2).map(|w| Piece::between(w[0], w[1]));
        Self::of(lines.collect())
    }

    /// Straight lines between `samples` (x, y) with rising x, at least one, constant outside.
    #[must_use]
    pub fn held(samples: &[(f64, f64)]) -> Self {
        let flat = |&(x, y): &(f64, f64)| Piece::new(x, y, 0.0);
        let lines = samples.windows(2).map(|w| Piece::between(w[0], w[1]));
        let pieces = samples.first().map(flat).into_iter().chain(lines);
        Self::of(pieces.chain(samples.last().map(flat)).collect())
    }

    /// The same curve, higher by `offset` everywhere.
    #[must_use]
    pub fn raised(mut self, offset: f64) -> Self {
        for piece in &mut self.pieces {
            piece.value += offset;
        }
        Self::of(self.pieces)
    }

    /// The part of the curve that has the sign of `sign`, zero elsewhere.
    #[must_use]
    pub fn clipped(&self, sign: f64) -> Self {
        let mut pieces = Vec::with_capacity(2 * self.pieces.len());
        let keep = |piece: Piece, wanted: bool| {
            if wanted {
                piece
            } else {
                Piece::new(piece.start, 0.0, 0.0)
            }
        };
        for (k, piece) in self.pieces.iter().enumerate() {
            let (from, to) = self.span(k);
            let root = piece.start - piece.value / piece.slope;
            if from < root && root < to {
                // Before its root a line has the sign opposite to its slope.
                let before = if k == 0 { root } else { piece.start };
                let left = Piece::new(before, piece.value_at(before), piece.slope);
                pieces.push(keep(left, sign * piece.slope < 0.0));
                let right = Piece::new(root, 0.0, piece.slope);
                pieces.push(keep(right, sign * piece.slope > 0.0));
            } else {
                let value = piece.value_at(inner_point(from, to));
                pieces.push(keep(*piece, sign * value > 0.0));
            }
        }
        Self::of(pieces)
    }

    /// The function's value at `x`.
    #[must_use]
    pub fn value(&self, x: f64) -> f64 {
        self.pieces[self.find(x)].value_at(x)
    }

    /// Value at `x` and slope to the right of it.
    #[must_use]
    pub fn value_and_slope(&self, x: f64) -> (f64, f64) {
        let piece = &self.pieces[self.find(x)];
        (piece.value_at(x), piece.slope)
    }

    /// Integral from 0 to `x`.
    #[must_use]
    pub fn integral(&self, x: f64) -> f64 {
        self.pieces[self.find(x)].integral_at(x)
    }

    /// Zero everywhere.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.pieces.iter().all(|p| p.value == 0.0 && p.slope == 0.0)
    }

    /// Index of the piece that counts at `x`.
    fn find(&self, x: f64) -> usize {
        self.pieces
            .partition_point(|p| p.start <= x)
            .saturating_sub(1)
    }

    /// Where the piece `k` counts.
    fn span(&self, k: usize) -> (f64, f64) {
        let from = if k == 0 {
            f64::NEG_INFINITY
        } else {
            self.pieces[k].start
        };
        let to = self.pieces.get(k + 1).map_or(f64::INFINITY, |p| p.start);
        (from, to)
    }

    /// Fill in the integrals: first from the first start, then shifted so that the integral to 0 is 0.
    fn of(mut pieces: Vec<Piece>) -> Self {
        pieces[0].integral = 0.0;
        for k in 1..pieces.len() {
            pieces[k].integral = pieces[k - 1].integral_at(pieces[k].start);
        }
        let mut curve = Self { pieces };
        let offset = curve.integral(0.0);
        for piece in &mut curve.pieces {
            piece.integral -= offset;
        }
        curve
    }
}

/// Some point inside an interval that may be unbounded.
fn inner_point(from: f64, to: f64) -> f64 {
    match (from.is_finite(), to.is_finite()) {
        (true, true) => 0.5 * (from + to),
        (true, false) => from + 1.0,
        (false, true) => to - 1.0,
        (false, false) => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SAMPLES: [(f64, f64); 4] = [(-1.0, -3.0), (0.5, 1.0), (2.0, 1.5), (3.0, -1.0)];

    /// Trapezoids on a fine grid: an integral by other means.
    fn quadrature(curve: &Curve, to: f64) -> f64 {
        let n = 40_000;
        let h = to / f64::from(n);
        let ends = 0.5 * (curve.value(0.0) + curve.value(to));
        h * (ends + (1..n).map(|k| curve.value(h * f64::from(k))).sum::<f64>())
    }

    #[test]
    fn outside_the_samples_a_curve_goes_on_or_stays() {
        let (extended, held) = (Curve::extended(&SAMPLES), Curve::held(&SAMPLES));
        for (x, on, stays) in [(-2.5, -7.0, -3.0), (4.0, -3.5, -1.0), (0.5, 1.0, 1.0)] {
            assert!((extended.value(x) - on).abs() < 1e-14, "{x}");
            assert!((held.value(x) - stays).abs() < 1e-14, "{x}");
        }
        assert!((Curve::held(&[(1.0, 4.0)]).value(-9.0) - 4.0).abs() < 1e-15);
        assert!((Curve::extended(&[(1.0, 4.0)]).value(9.0) - 4.0).abs() < 1e-15);
    }

    #[test]
    fn integrals_agree_with_trapezoids() {
        let curves = [
            Curve::extended(&SAMPLES),
            Curve::held(&SAMPLES),
            Curve::extended(&SAMPLES).raised(0.75),
            Curve::line(0.3, -2.0),
            Curve::extended(&SAMPLES).clipped(1.0),
            Curve::extended(&SAMPLES).clipped(-1.0),
        ];
        for curve in &curves {
            for x in [-4.0, -0.7, 0.0, 0.2, 1.0, 2.5, 6.0] {
                let error = curve.integral(x) - quadrature(curve, x);
                assert!(error.abs() < 1e-6, "{x} {error}"); // measured 1.3e-8, the trapezoids' own
            }
        }
    }

    #[test]
    fn clipping_keeps_one_sign() {
        let curves = [
            Curve::extended(&SAMPLES),
            Curve::held(&SAMPLES),
            Curve::line(-1.0, 0.5),
            Curve::line(0.0, 2.0),
            Curve::line(3.0, 0.0),
        ];
        for curve in &curves {
            for x in (-80..80).map(|k| 0.1 * f64::from(k) + 0.013) {
                let y = curve.value(x);
                assert!((curve.clipped(1.0).value(x) - y.max(0.0)).abs() < 1e-14);
                assert!((curve.clipped(-1.0).value(x) - y.min(0.0)).abs() < 1e-14);
            }
        }
        assert!(Curve::line(3.0, 0.0).clipped(-1.0).is_zero());
    }

    #[test]
    fn at_a_jump_the_later_piece_counts() {
        let jump = Curve::held(&[(0.0, 0.0), (1.0, 0.0), (1.0, 5.0), (2.0, 5.0)]);
        assert!(jump.value(1.0 - 1e-12).abs() < 1e-15);
        assert!((jump.value(1.0) - 5.0).abs() < 1e-15);
        assert!((jump.integral(2.0) - 5.0).abs() < 1e-15);
    }
}
