//! Threads of a world, and how its work is divided among them.
//!
//! Work is cut into parts by its size alone, and what comes of the parts is put together in their order. So the same
//! bits come out on any number of threads. Inside a pool (rayon's) idle threads take parts; outside of one the caller does
//! them all, one after the other. Nobody waits for a part that nobody has begun: who comes to it first does it.

use std::hint::spin_loop;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::Arc;
use std::time::{Duration, Instant};

use rayon::{ThreadPool, ThreadPoolBuilder, Yield};

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
    if rayon::current_thread_index().is_none() {
        return (a(), b());
    }
    let done = AtomicBool::new(false);
    let first = || {
        let a = a();
        help_until(&done);
        a
    };
    let second = || {
        let b = b();
        done.store(true, Ordering::Release);
        b
    };
    rayon::join(first, second)
}

/// Do `work` while the other threads of the pool stay awake: its parts then find somebody within a microsecond, where it
/// takes tens of them to wake a thread.
pub(crate) fn awake<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    if rayon::current_thread_index().is_none() {
        return work();
    }
    let others = rayon::current_num_threads() - 1;
    awake_with(others, &AtomicBool::new(false), work)
}

fn awake_with<T: Send>(others: usize, over: &AtomicBool, work: impl FnOnce() -> T + Send) -> T {
    if others == 0 {
        let result = work();
        over.store(true, Ordering::Release);
        return result;
    }
    let this = || awake_with(others - 1, over, work);
    rayon::join(this, || help_until(over)).0
}

/// How long a thread that waits reacts at once, and how long it waits before it sleeps.
const ALERT: Duration = Duration::from_micros(50);
const PATIENCE: Duration = Duration::from_millis(1);

/// Do what others have left to be done until this is, or until there was nothing for a while: nobody sleeps through the
/// short parts of a step, and nobody burns a core through the long ones. Whoever comes back early is called by rayon.
fn help_until(done: &AtomicBool) {
    let mut idle_since = None;
    while !done.load(Ordering::Acquire) {
        if rayon::yield_now() == Some(Yield::Executed) {
            idle_since = None;
            continue;
        }
        let idle = idle_since.get_or_insert_with(Instant::now).elapsed();
        if idle < ALERT {
            spin_loop();
        } else if idle < PATIENCE {
            std::thread::yield_now();
        } else {
            return;
        }
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
    use std::sync::mpsc::channel;

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
    fn a_partner_that_never_comes_is_not_waited_for() {
        let pool = Team::new(2).pool().expect("threads can be had");
        let (begin, begun) = channel();
        let (wake, woken) = channel();
        pool.spawn(move || {
            begin.send(()).expect("it is waited for");
            woken.recv().expect("it is woken");
        });
        begun.recv().expect("it begins");
        let sum = || both(|| both(|| 1, || 2), || both(|| 3, || 4));
        assert_eq!(pool.install(|| awake(sum)), ((1, 2), (3, 4)));
        wake.send(()).expect("it sleeps");
    }

    #[test]
    fn nobody_waits_for_ever() {
        let pool = Team::new(3).pool().expect("threads can be had");
        let never = AtomicBool::new(false);
        pool.install(|| both(|| help_until(&never), || help_until(&never)));
    }

    #[test]
    fn outside_of_a_pool_the_caller_does_it_all() {
        let this = std::thread::current().id();
        let who = || std::thread::current().id();
        assert_eq!(awake(|| both(who, who)), (this, this));
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
