//! Triangles into depth buffers, row by row.

use std::ops::Range;

/// No face.
pub(super) const NOTHING: u32 = u32::MAX;

/// A corner of a triangle on a grid of samples; `near` is greater the nearer it is, and linear on the grid.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub(super) x: f32,
    pub(super) y: f32,
    pub(super) near: f32,
}

/// A triangle of a thing, on the grid of samples.
pub(super) struct Face {
    pub(super) corners: [Corner; 3],
    pub(super) thing: u32,
    pub(super) triangle: u32,
}

impl Face {
    /// The first and last row of samples that it may touch; what is above the picture counts as row 0.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    pub(super) fn rows(&self) -> (usize, usize) {
        let [a, b, c] = self.corners.map(|corner| corner.y);
        (a.min(b).min(c) as usize, a.max(b).max(c) as usize)
    }

    /// Whether it may touch a grid of this many columns and rows.
    #[allow(clippy::cast_precision_loss)]
    pub(super) fn within(&self, (columns, rows): (usize, usize)) -> bool {
        let x = self.corners.map(|corner| corner.x);
        let y = self.corners.map(|corner| corner.y);
        let overlap = |[a, b, c]: [f32; 3], end: usize| {
            a.max(b).max(c) >= 0.0 && a.min(b).min(c) <= end as f32
        };
        overlap(x, columns) && overlap(y, rows)
    }
}

/// Hands out the samples that a triangle covers: row, columns, `near` at the first of them, its growth per column.
///
/// A sample is covered where all three edge functions E = (p - a) x (b - a) have one sign, the rim included. Two
/// triangles that share an edge compute the same bound from it, so that no gap opens between them.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss
)]
pub(super) fn spans(
    corners: &[Corner; 3],
    rows: &Range<usize>,
    columns: usize,
    mut span: impl FnMut(usize, Range<usize>, f32, f32),
) {
    let [a, b, c] = corners.map(|p| [f64::from(p.x), f64::from(p.y), f64::from(p.near)]);
    let twice_area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if twice_area == 0.0 || !twice_area.is_finite() {
        return;
    }
    let (ab, ac) = (b[2] - a[2], c[2] - a[2]);
    let per_column = (ab * (c[1] - a[1]) - ac * (b[1] - a[1])) / twice_area;
    let per_row = (ac * (b[0] - a[0]) - ab * (c[0] - a[0])) / twice_area;
    let low = a[1].min(b[1]).min(c[1]);
    let high = a[1].max(b[1]).max(c[1]);
    let first = ((low - 0.5).ceil().max(0.0) as usize).max(rows.start);
    let end = ((high - 0.5).floor() + 1.0).clamp(0.0, rows.end as f64) as usize;
    for row in first..end {
        let y = row as f64 + 0.5;
        let (left, right) = bounds([a, b, c], twice_area > 0.0, y);
        let from = (left - 0.5).ceil().max(0.0) as usize;
        let to = ((right - 0.5).floor() + 1.0).clamp(0.0, columns as f64) as usize;
        if from < to {
            let near = a[2] + (from as f64 + 0.5 - a[0]) * per_column + (y - a[1]) * per_row;
            span(row, from..to, near as f32, per_column as f32);
        }
    }
}

/// Where the line at height y enters and leaves a triangle.
fn bounds(corners: [[f64; 3]; 3], counter_clockwise: bool, y: f64) -> (f64, f64) {
    let (mut left, mut right) = (f64::NEG_INFINITY, f64::INFINITY);
    for k in 0..3 {
        let (p, q) = (corners[k], corners[(k + 1) % 3]);
        let rise = q[1] - p[1];
        if rise == 0.0 {
            continue; // the rows end there
        }
        // from the lower end, whichever triangle asks
        let (from, to) = if rise > 0.0 { (p, q) } else { (q, p) };
        let x = from[0] + (to[0] - from[0]) * ((y - from[1]) / (to[1] - from[1]));
        if (rise > 0.0) == counter_clockwise {
            right = right.min(x);
        } else {
            left = left.max(x);
        }
    }
    (left, right)
}

/// Depths and faces of a band of rows: solids in layer 0, signs in layer 1.
pub(super) struct Buffers {
    rows: Range<usize>,
    columns: usize,
    layers: [Layer; 2],
}

struct Layer {
    near: Vec<f32>,
    face: Vec<u32>,
}

impl Buffers {
    /// Empty buffers for rows of pixels.
    pub(super) fn new(rows: &Range<usize>, width: usize, samples: usize) -> Self {
        let (rows, columns) = (rows.start * samples..rows.end * samples, width * samples);
        let layer = |size| Layer {
            near: vec![0.0; size],
            face: vec![NOTHING; size],
        };
        Self {
            layers: [layer(rows.len() * columns), layer(0)],
            rows,
            columns,
        }
    }

    /// Draws a face into a layer; the second is made when first needed.
    pub(super) fn draw(&mut self, face: &Face, number: u32, layer: usize) {
        let size = self.rows.len() * self.columns;
        let Layer { near, face: faces } = &mut self.layers[layer];
        if near.is_empty() {
            near.resize(size, 0.0);
            faces.resize(size, NOTHING);
        }
        spans(
            &face.corners,
            &self.rows,
            self.columns,
            |row, columns, mut depth, per_column| {
                let start = (row - self.rows.start) * self.columns;
                let range = start + columns.start..start + columns.end;
                for (old, who) in near[range.clone()].iter_mut().zip(&mut faces[range]) {
                    if depth > *old {
                        *old = depth;
                        *who = number;
                    }
                    depth += per_column;
                }
            },
        );
    }

    /// What all samples of a pixel see, when that is one and the same; of signs this does not know.
    pub(super) fn only(&self, column: usize, row: usize, samples: usize) -> Option<Seen> {
        let [solids, signs] = &self.layers;
        let first = (row - self.rows.start) * self.columns + column;
        let solid = solids.face[first];
        let one = (0..samples).all(|k| {
            let start = first + k * self.columns;
            let line = start..start + samples;
            solids.face[line.clone()].iter().all(|&face| face == solid)
                && (signs.face.is_empty() || signs.face[line].iter().all(|&face| face == NOTHING))
        });
        one.then_some(Seen {
            solid,
            sign: NOTHING,
            hidden: false,
        })
    }

    /// What the sample sees: the faces in both layers, and whether the second lies behind the first.
    pub(super) fn sample(&self, column: usize, row: usize) -> Seen {
        let k = (row - self.rows.start) * self.columns + column;
        let [solids, signs] = &self.layers;
        if signs.face.is_empty() || signs.face[k] == NOTHING {
            return Seen {
                solid: solids.face[k],
                sign: NOTHING,
                hidden: false,
            };
        }
        Seen {
            solid: solids.face[k],
            sign: signs.face[k],
            hidden: signs.near[k] < solids.near[k],
        }
    }
}

/// What a sample sees.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct Seen {
    /// A face, or `NOTHING`.
    pub(super) solid: u32,
    /// A face, or `NOTHING`.
    pub(super) sign: u32,
    /// Whether the sign lies behind the solid.
    pub(super) hidden: bool,
}
