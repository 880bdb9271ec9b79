//! Coordinates that a limit or dry friction holds still for a step.
//!
//! A force that is constant over a step lets a rope grow by v^2 dt^2 / (2 L) in each, and a held coordinate creep. So what
//! holds a coordinate still in the solve becomes a row like those of the joint itself for the rest of the step: the
//! integrator keeps it as exactly as the joint, and finds its force anew.

use std::ops::Range;

use super::joints::Joints;
use super::row::Course;

/// Where a coordinate is held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lock {
    /// [rad or m]
    pub place: f64,
    /// It comes to the place within the step; else what it is off by is taken back like an error of the joint.
    pub arrives: bool,
    /// By a limit; else by friction.
    pub by_limit: bool,
}

impl Joints {
    /// Coordinates are free again.
    pub fn release(&mut self) {
        self.locks.fill(None);
    }

    /// From here on drive row `k` holds its coordinate still.
    pub fn lock(&mut self, k: usize, lock: Lock) {
        self.locks[k / 2] = Some(lock);
    }

    /// Drive row `k` holds its coordinate still, so that it is no force of its own.
    #[must_use]
    pub fn is_locked(&self, k: usize) -> bool {
        self.locks[k / 2].is_some_and(|lock| lock.by_limit == (k % 2 == 1))
    }

    /// Some coordinate is held by a limit, or else by friction.
    #[must_use]
    pub fn any_locked(&self, by_limit: bool) -> bool {
        let such = |lock: &Lock| lock.by_limit == by_limit;
        self.locks.iter().flatten().any(such)
    }

    /// Change of each row's rate [m/s or rad/s] that brings held coordinates to rest.
    pub fn arrest(&self, rows: &[Course], by_limit: bool, missing: &mut Vec<f64>) {
        missing.clear();
        missing.resize(rows.len(), 0.0);
        for (r, lock) in self.lock_rows() {
            if lock.by_limit == by_limit {
                missing[r] = -rows[r].rate;
            }
        }
    }

    /// Of the values of all rows, as they were when the step began, leave what is to be left when it ends: errors less a
    /// part `beta` of them. Returns what no change exceeds.
    pub fn take_back(&self, beta: f64, values: &mut [f64]) -> f64 {
        let largest = values.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
        values.iter_mut().for_each(|c| *c *= 1.0 - beta);
        let mut share = beta;
        for (r, lock) in self.lock_rows() {
            if lock.arrives {
                values[r] = 0.0;
                share = 1.0;
            }
        }
        share * largest
    }

    /// Rows of coordinates that are held, among those of `rows`.
    fn lock_rows(&self) -> impl Iterator<Item = (usize, Lock)> + '_ {
        (0..self.len()).flat_map(move |j| {
            let slots = self.lock_slots(j).zip(self.joints[j].lockable());
            slots.filter_map(|(r, &k)| self.locks[k].map(|lock| (r, lock)))
        })
    }

    fn lock_slots(&self, j: usize) -> Range<usize> {
        let all = self.rows_of(j);
        all.end - self.joints[j].lockable().len()..all.end
    }
}
