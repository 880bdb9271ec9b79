//! Threads of a world, and how its work is divided among them.
//!
//! Work is cut into parts by its size alone, and what comes of the parts is put together in their order. So the same
//! bits come out on any number of threads. Inside a pool (rayon's) idle threads take parts; outside of one the caller does
//! them all, one after the other.

use std::ops::Range;
use std::sync::Arc;

use rayon::{ThreadPool, ThreadPoolBuilder};

/// The threads that a world steps on.
#[derive(Clone, Debug)]
pub struct Team {
    threads: usize,
    /// Made when it is first asked for, and made anew in a forked process, which does not have the threads.
    pool: Option<(u32, Arc<ThreadPool>)>,
}

impl Team {
    /// Of so many threads, at least one.
    #[must_use]
    pub fn new(threads: usize) -> Self {
        Self {
            threads,
            pool: None,
        }
    }

    /// The pool, None where the caller is enough or threads cannot be had.
    pub fn pool(&mut self) -> Option<Arc<ThreadPool>> {
        if self.threads < 2 {
            return None;
        }
        let process = std::process::id();
        if let Some((owner, pool)) = self.pool.take() {
            if owner == process {
                self.pool = Some((owner, pool.clone()));
                return Some(pool);
            }
            // Its threads are in the parent process: nothing here can end them.
            std::mem::forget(pool);
        }
        let made = ThreadPoolBuilder::new().num_threads(self.threads).build();
        self.pool = made.ok().map(|pool| (process, Arc::new(pool)));
        self.pool.as_ref().map(|(_, pool)| pool.clone())
    }
}

/// Both, at once where there is a thread for each.
pub(crate) fn both<A: Send, B: Send>(
    a: impl FnOnce() -> A + Send,
    b: impl FnOnce() -> B + Send,
) -> (A, B) {
    if rayon::current_thread_index().is_some() {
        rayon::join(a, b)
    } else {
        (a(), b())
    }
}

/// Do `work` on parts of `size` elements, the last of which may be shorter.
pub(crate) fn divide<P: Parts>(whole: P, size: usize, work: &(impl Fn(P) + Sync)) {
    gather(whole, size, work, &|(), ()| ());
}

/// The same, with a result of each part; `join` puts those of neighbours together.
pub(crate) fn gather<P: Parts, R: Send>(
    whole: P,
    size: usize,
    work: &(impl Fn(P) -> R + Sync),
    join: &(impl Fn(R, R) -> R + Sync),
) -> R {
    let parts = whole.length().div_ceil(size);
    if parts < 2 {
        return work(whole);
    }
    let (a, b) = whole.cut(parts / 2 * size);
    let (a, b) = both(
        || gather(a, size, work, join),
        || gather(b, size, work, join),
    );
    join(a, b)
}

/// Elements that are worth handing to another thread.
pub(crate) const HANDFUL: usize = 256;

/// `work` on every element.
pub(crate) fn each<T: Send>(list: &mut [T], work: &(impl Fn(&mut T) + Sync)) {
    divide(list, HANDFUL, &|part: &mut [T]| {
        part.iter_mut().for_each(work)
    });
}

/// `work` on every element and its companion in another list.
pub(crate) fn each_with<T: Send, U: Sync>(
    list: &mut [T],
    other: &[U],
    work: &(impl Fn(&mut T, &U) + Sync),
) {
    divide((list, other), HANDFUL, &|(list, other): (
        &mut [T],
        &[U],
    )| {
        list.iter_mut().zip(other).for_each(|(x, y)| work(x, y));
    });
}

/// A list of `count` elements, each made from its index; `blank` stands where none was before.
pub(crate) fn fill<T: Send + Clone>(
    list: &mut Vec<T>,
    (count, blank): (usize, T),
    make: &(impl Fn(usize) -> T + Sync),
) {
    list.resize(count, blank);
    divide((&mut list[..], 0..count), HANDFUL, &|(part, range): (
        &mut [T],
        Range<usize>,
    )| {
        part.iter_mut().zip(range).for_each(|(x, k)| *x = make(k));
    });
}

/// What can be cut in two: slices, ranges, and several of them side by side, of which the first tells the length.
pub(crate) trait Parts: Send + Sized {
    fn length(&self) -> usize;
    fn cut(self, at: usize) -> (Self, Self);
}

impl<T: Sync> Parts for &[T] {
    fn length(&self) -> usize {
        self.len()
    }

    fn cut(self, at: usize) -> (Self, Self) {
        self.split_at(at)
    }
}

impl<T: Send> Parts for &mut [T] {
    fn length(&self) -> usize {
        self.len()
    }

    fn cut(self, at: usize) -> (Self, Self) {
        self.split_at_mut(at)
    }
}

impl Parts for Range<usize> {
    fn length(&self) -> usize {
        self.len()
    }

    fn cut(self, at: usize) -> (Self, Self) {
        let middle = self.start + at;
        (self.start..middle, middle..self.end)
    }
}

impl<A: Parts, B: Parts> Parts for (A, B) {
    fn length(&self) -> usize {
        self.0.length()
    }

    fn cut(self, at: usize) -> (Self, Self) {
        let ((a, later_a), (b, later_b)) = (self.0.cut(at), self.1.cut(at));
        ((a, b), (later_a, later_b))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_whole_and_in_order() {
        let whole: Vec<usize> = (0..1003).collect();
        let lengths = gather(
            &whole[..],
            100,
            &|part: &[usize]| vec![(part[0], part.len())],
            &|a, b| [a, b].concat(),
        );
        let expected: Vec<_> = (0..11)
            .map(|k| (100 * k, if k == 10 { 3 } else { 100 }))
            .collect();
        assert_eq!(lengths, expected);
    }

    #[test]
    fn sums_have_the_same_bits_on_any_number_of_threads() {
        let terms: Vec<f64> = (1..5000).map(|k| 1.0 / f64::from(k)).collect();
        let sum = || {
            gather(
                &terms[..],
                64,
                &|part: &[f64]| part.iter().sum(),
                &|a: f64, b| a + b,
            )
        };
        let alone = sum();
        for threads in 2..5 {
            let pool = Team::new(threads).pool().expect("threads can be had");
            assert_eq!(pool.install(sum).to_bits(), alone.to_bits());
        }
    }
}
