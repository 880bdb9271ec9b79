//! The bytes of numbers in planes: all first bytes, then all second ones. Bytes that are alike then lie side by side, and
//! pack better.

use crate::lanes::{vectorised, WIDTH};
use pulp::{Simd, WithSimd};

/// Bytes of the numbers that there is a fast way for, and numbers that are turned together.
const EIGHT: usize = 8;
/// Numbers in a block of squares abreast.
const BLOCK: usize = EIGHT * WIDTH;

/// Columns of bytes become rows: byte `k` of number `i` is byte `i` of plane `k`. What is over of the last number, if
/// `bytes` end within it, stays behind the planes as it is.
///
/// # Panics
/// When `size`, of a number in bytes, is 0.
#[must_use]
pub fn shuffled(bytes: &[u8], size: usize) -> Vec<u8> {
    let (whole, over) = bytes.split_at(bytes.len() - bytes.len() % size);
    let mut planes = vec![0; bytes.len()];
    let (turned, rest) = planes.split_at_mut(whole.len());
    rest.copy_from_slice(over);
    if !turned.is_empty() {
        vectorised(Shuffle {
            numbers: whole,
            size,
            planes: turned,
        });
    }
    planes
}

struct Shuffle<'a> {
    numbers: &'a [u8],
    size: usize,
    planes: &'a mut [u8],
}

impl WithSimd for Shuffle<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let (size, count) = (self.size, self.numbers.len() / self.size);
        let blocks = if size == EIGHT { count / BLOCK } else { 0 };
        let squares = self.numbers.chunks_exact(BLOCK * EIGHT).take(blocks);
        for (at, block) in squares.enumerate() {
            let rows = turned(words(block));
            for (plane, row) in self.planes.chunks_exact_mut(count).zip(rows) {
                let place = &mut plane[at * BLOCK..][..BLOCK];
                for (bytes, word) in place.chunks_exact_mut(EIGHT).zip(row) {
                    bytes.copy_from_slice(&word.to_le_bytes());
                }
            }
        }
        for (k, plane) in self.planes.chunks_exact_mut(count).enumerate() {
            let last = self.numbers.iter().skip(blocks * BLOCK * size + k);
            for (place, &byte) in plane[blocks * BLOCK..].iter_mut().zip(last.step_by(size)) {
                *place = byte;
            }
        }
    }
}

/// Squares of eight numbers, beside each other: number `i` of square `s` is `words[i][s]`.
#[inline(always)]
fn words(block: &[u8]) -> [[u64; WIDTH]; EIGHT] {
    let mut words = [[0; WIDTH]; EIGHT];
    for (k, bytes) in block.chunks_exact(EIGHT).enumerate() {
        let mut word = [0; EIGHT];
        word.copy_from_slice(bytes);
        words[k % EIGHT][k / EIGHT] = u64::from_le_bytes(word);
    }
    words
}

/// Squares of 8 x 8 bytes transposed: quarters of 4 x 4 bytes across the diagonal change places, then those of 2 x 2 in
/// each, then single bytes.
#[allow(clippy::needless_range_loop)]
#[inline(always)]
fn turned(mut words: [[u64; WIDTH]; EIGHT]) -> [[u64; WIDTH]; EIGHT] {
    for (apart, low) in [
        (4, 0x0000_0000_ffff_ffff_u64),
        (2, 0x0000_ffff_0000_ffff),
        (1, 0x00ff_00ff_00ff_00ff),
    ] {
        for upper in (0..EIGHT).filter(|k| k & apart == 0) {
            let lower = upper + apart;
            for s in 0..WIDTH {
                let (a, b) = (words[upper][s], words[lower][s]);
                words[upper][s] = (a & low) | ((b & low) << (8 * apart));
                words[lower][s] = ((a >> (8 * apart)) & low) | (b & !low);
            }
        }
    }
    words
}

#[cfg(test)]
mod tests {
    use super::shuffled;

    #[test]
    fn bytes_of_each_place_lie_side_by_side() {
        for size in [1, 3, 4, 8, 16] {
            for count in [0, 1, 7, 31, 32, 33, 100] {
                #[allow(clippy::cast_possible_truncation)]
                let bytes: Vec<u8> = (0..size * count)
                    .map(|k| (k * k / 3 + 7 * k) as u8)
                    .collect();
                let planes = shuffled(&bytes, size);
                for (k, &byte) in bytes.iter().enumerate() {
                    assert_eq!(planes[k % size * count + k / size], byte);
                }
            }
        }
    }

    #[test]
    fn what_is_over_stays_at_the_end() {
        assert_eq!(shuffled(&[1, 2, 3, 4, 5], 2), [1, 3, 2, 4, 5]);
    }
}
