//! One-sided and bounded rows: motors that hold a speed, dry friction, limits.

use super::joints::Joints;
use super::lock::Lock;
use super::model::{DriveModel, Motor};
use super::row::Row;
use crate::body::Body;

/// A coordinate this near to its limit is there [rad or m].
const REACHED: f64 = 1e-6;
/// A coordinate this slow stands still, if nothing but rounding has moved it [rad/s or m/s].
const STILL: f64 = 1e-6;
/// A bounce slower than this is none [rad/s or m/s].
const QUIET: f64 = 1e-9;

/// The step to come.
#[derive(Clone, Copy, Debug)]
pub struct Ahead {
    /// Its start [s].
    pub time: f64,
    /// Its length [s].
    pub timestep: f64,
    /// Weight of the velocity at its end in the displacement: x' - x = ((1 - lead) v + lead v') dt.
    pub lead: f64,
}

/// What a drive row stands for, and so whose energy it moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// A motor, with the dry friction of the coordinate if there is any.
    Motor,
    /// Dry friction alone.
    Friction,
    /// A limit.
    Limit,
}

/// A row that pushes with a bounded force: within the bounds it takes dC/dt to the target, at the upper bound dC/dt may stay
/// below the target, at the lower bound above it.
#[derive(Clone, Copy, Debug)]
pub struct DriveRow {
    /// Index of the joint.
    pub joint: usize,
    /// Of a motor or friction: the coordinate. Of a limit: the way that is left, negative beyond the limit.
    pub row: Row,
    /// Least force or torque along the row [N or N m].
    pub lower: f64,
    /// Greatest; both zero where the row does nothing.
    pub upper: f64,
    /// Rate aimed at [m/s or rad/s].
    pub target: f64,
    /// What it stands for.
    pub cause: Cause,
    /// Of a limit.
    pub restitution: f64,
    /// Dry friction [N or N m] inside the bounds: of the work at the rate r it takes `friction` |r| for itself, the rest
    /// is the motor's.
    pub friction: f64,
    /// Where the coordinate is held if this row brings it to rest within its bounds.
    pub lock: Option<Lock>,
}

impl DriveRow {
    /// It does nothing.
    #[must_use]
    pub fn is_idle(&self) -> bool {
        self.lower == 0.0 && self.upper == 0.0
    }

    fn idle(joint: usize, cause: Cause) -> Self {
        Self {
            joint,
            row: Row::default(),
            lower: 0.0,
            upper: 0.0,
            target: 0.0,
            cause,
            restitution: 0.0,
            friction: 0.0,
            lock: None,
        }
    }

    /// Aim at a rate in the step to come, and not at what the row's turning with its bodies makes of it.
    fn aimed(self, ahead: Ahead) -> Self {
        Self {
            target: self.target - ahead.timestep * self.row.bias,
            ..self
        }
    }
}

/// Rate up to which a coordinate stands still: that of a row which turned while it was held by a constant force.
fn still(row: &Row, ahead: Ahead) -> f64 {
    STILL + ahead.timestep * row.bias.abs()
}

impl Ahead {
    /// The rate at the end of the step that just closes a gap, from the rate at its start; never one that parts.
    fn closing(self, gap: f64, rate: f64) -> f64 {
        if self.lead == 0.0 {
            return -gap / self.timestep; // this step's displacement is settled; the next one is to close the gap at most
        }
        ((-gap / self.timestep - (1.0 - self.lead) * rate) / self.lead).min(0.0)
    }
}

/// Bounds and target of a row.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Grip {
    lower: f64,
    upper: f64,
    target: f64,
}

impl Grip {
    fn mirrored(self) -> Self {
        Self {
            lower: -self.upper,
            upper: -self.lower,
            target: -self.target,
        }
    }
}

/// A speed motor of strength M >= 0 towards the speed s, and dry friction F >= 0, as one row.
///
/// For s > 0 motor and friction together push with, as a function of the rate r,
///
/// | r < 0 | r = 0          | 0 < r < s | r = s           | r > s  |
/// |-------|----------------|-----------|-----------------|--------|
/// | M + F | M - F .. M + F | M - F     | -M - F .. M - F | -M - F |
///
/// which falls in two steps, while a row with bounds has one: its bounds are the ends of one step, its target the place. The
/// step that the rate is heading for is taken: from above s the one at s; from below s the one at 0 if friction is the
/// stronger (the coordinate comes to rest), and if the motor is the stronger the one at 0 as long as the motor by itself
/// cannot reach s within the step (so that a load it cannot move stands still), else the one at s, with friction helping
/// the motor while the coordinate still runs backwards. Where both steps are passed within one timestep the rate is off by
/// at most what 2 F does in that time, and the next step puts it right.
///
/// `gain` is the change of the rate that a unit force makes within the step on bodies that nothing else holds.
fn grip(strength: f64, friction: f64, speed: f64, rate: f64, gain: f64) -> Grip {
    if speed < 0.0 {
        return grip(strength, friction, -speed, -rate, gain).mirrored();
    }
    let most = strength + friction;
    if friction == 0.0 || speed == 0.0 {
        return Grip {
            lower: -most,
            upper: most,
            target: speed,
        };
    }
    let at_rest = Grip {
        lower: strength - friction,
        upper: most,
        target: 0.0,
    };
    let at_speed = Grip {
        lower: -most,
        upper: strength - friction,
        target: speed,
    };
    let stays_below = rate.max(0.0) + (strength - friction) * gain <= speed;
    if rate <= speed && (strength <= friction || stays_below) {
        at_rest
    } else if rate < 0.0 {
        Grip {
            upper: most,
            ..at_speed
        }
    } else {
        at_speed
    }
}

impl Joints {
    /// Two rows for each drive: motor with dry friction, then the nearer limit.
    ///
    /// Targets are rates of the end of the step, of the rows as they are in `bodies`: J(x') v' = J(x) v' + dt (dJ/dt) v.
    pub fn drive_rows(&self, bodies: &[Body], ahead: Ahead, out: &mut Vec<DriveRow>) {
        out.clear();
        for drive in &self.drives {
            if self.is_broken(drive.joint) || !drive.can_lock() {
                out.push(DriveRow::idle(drive.joint, drive.cause()));
                out.push(DriveRow::idle(drive.joint, Cause::Limit));
                continue;
            }
            let row = self.coordinate_row(drive.joint, drive.coordinate, bodies);
            out.push(drive.motor_row(row, bodies, ahead).aimed(ahead));
            out.push(drive.limit_row(row, bodies, ahead).aimed(ahead));
        }
    }
}

impl DriveModel {
    /// It has a speed motor or dry friction.
    fn grips(&self) -> bool {
        self.friction > 0.0 || self.cause() == Cause::Motor
    }

    fn is_limited(&self) -> bool {
        self.limits.iter().any(|limit| limit.is_finite())
    }

    /// It may hold its coordinate still.
    pub(super) fn can_lock(&self) -> bool {
        self.grips() || self.is_limited()
    }

    fn cause(&self) -> Cause {
        match self.motor {
            Some(Motor::Speed { .. }) => Cause::Motor,
            Some(Motor::Servo { .. }) | None => Cause::Friction,
        }
    }

    fn motor_row(&self, row: Row, bodies: &[Body], ahead: Ahead) -> DriveRow {
        let end = ahead.time + ahead.timestep;
        let (speed, strength) = match self.motor {
            Some(Motor::Speed { speed, max }) => (speed * self.factor(end).0, max),
            Some(Motor::Servo { .. }) | None => (0.0, 0.0),
        };
        let (gain, rate) = (ahead.timestep * row.mobility(bodies), row.rate(bodies));
        let grip = grip(strength, self.friction, speed, rate, gain);
        let stands = grip.target == 0.0 && rate.abs() <= still(&row, ahead);
        DriveRow {
            row,
            lower: grip.lower,
            upper: grip.upper,
            target: grip.target,
            friction: self.friction,
            lock: stands.then_some(Lock {
                place: row.value,
                arrives: false,
                by_limit: false,
            }),
            ..DriveRow::idle(self.joint, self.cause())
        }
    }

    /// The limit that would be passed first; pushes away from it only.
    ///
    /// With restitution e a coordinate that arrives within the step is thrown back: -e rate. Without, or where it is there
    /// already, it comes to rest and is held. A coordinate that is still under way may come to the limit within the step
    /// and no further.
    fn limit_row(&self, coordinate: Row, bodies: &[Body], ahead: Ahead) -> DriveRow {
        let idle = DriveRow::idle(self.joint, Cause::Limit);
        let side = |row: Row, gap: f64| Row { value: gap, ..row };
        let [low, high] = self.limits;
        let to_low = side(coordinate, coordinate.value - low);
        let to_high = side(coordinate.scaled(-1.0), high - coordinate.value);
        let (rate, h) = (coordinate.rate(bodies), ahead.timestep);
        let low_is_next = to_low.value + h * rate <= to_high.value - h * rate;
        let (row, rate, place) = if low_is_next {
            (to_low, rate, low)
        } else {
            (to_high, -rate, high)
        };
        if !row.value.is_finite() {
            return idle;
        }
        let arrives = rate < 0.0 && row.value + h * rate <= 0.0;
        let bounces = arrives && -self.restitution * rate > QUIET;
        let there = row.value <= REACHED && rate <= still(&row, ahead);
        let lock = (!bounces && (arrives || there)).then_some(Lock {
            place,
            arrives: row.value > 0.0,
            by_limit: true,
        });
        let target = if bounces {
            -self.restitution * rate
        } else if lock.is_some() {
            0.0
        } else {
            ahead.closing(row.value.max(0.0), rate)
        };
        DriveRow {
            row,
            upper: f64::INFINITY,
            target,
            restitution: self.restitution,
            lock,
            ..idle
        }
    }

    /// Factor of the motor at `time` [s] and its rate [1/s].
    pub(super) fn factor(&self, time: f64) -> (f64, f64) {
        self.profile
            .as_ref()
            .map_or((1.0, 0.0), |profile| profile.value_and_rate(time))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const INFINITE: f64 = f64::INFINITY;

    fn is(grip: Grip, lower: f64, upper: f64, target: f64) {
        assert_eq!(
            grip,
            Grip {
                lower,
                upper,
                target
            }
        );
    }

    #[test]
    fn friction_alone_holds_still() {
        for rate in [-1.0, 0.0, 1.0] {
            is(grip(0.0, 3.0, 0.0, rate, 0.1), -3.0, 3.0, 0.0);
        }
    }

    #[test]
    fn motor_alone_holds_its_speed() {
        for rate in [-1.0, 0.0, 9.0] {
            is(grip(5.0, 0.0, 2.0, rate, 0.1), -5.0, 5.0, 2.0);
        }
        is(grip(INFINITE, 0.0, 2.0, 0.0, 0.1), -INFINITE, INFINITE, 2.0);
    }

    #[test]
    fn motor_of_speed_zero_brakes_with_friction() {
        is(grip(5.0, 3.0, 0.0, 1.0, 0.1), -8.0, 8.0, 0.0);
    }

    #[test]
    fn stronger_motor() {
        // Cannot reach the speed within the step: 2 * 0.1 < 2.
        is(grip(5.0, 3.0, 2.0, -1.0, 0.1), 2.0, 8.0, 0.0);
        is(grip(5.0, 3.0, 2.0, 0.0, 0.1), 2.0, 8.0, 0.0);
        is(grip(5.0, 3.0, 2.0, 1.0, 0.1), 2.0, 8.0, 0.0);
        // Nearly there, there, and too fast.
        is(grip(5.0, 3.0, 2.0, 1.9, 0.1), -8.0, 2.0, 2.0);
        is(grip(5.0, 3.0, 2.0, 2.0, 0.1), -8.0, 2.0, 2.0);
        is(grip(5.0, 3.0, 2.0, 3.0, 0.1), -8.0, 2.0, 2.0);
        // Reaches it within the step from anywhere.
        is(grip(5.0, 3.0, 2.0, 0.0, 10.0), -8.0, 2.0, 2.0);
        is(grip(5.0, 3.0, 2.0, -1.0, 10.0), -8.0, 8.0, 2.0);
    }

    #[test]
    fn motor_without_bound_holds_its_speed_in_spite_of_friction() {
        for rate in [-1.0, 0.0, 5.0] {
            is(
                grip(INFINITE, 3.0, 2.0, rate, 0.1),
                -INFINITE,
                INFINITE,
                2.0,
            );
        }
    }

    #[test]
    fn weaker_motor_lets_the_coordinate_stop() {
        is(grip(2.0, 3.0, 2.0, -1.0, 0.1), -1.0, 5.0, 0.0);
        is(grip(2.0, 3.0, 2.0, 0.0, 0.1), -1.0, 5.0, 0.0);
        is(grip(2.0, 3.0, 2.0, 1.0, 0.1), -1.0, 5.0, 0.0);
        is(grip(2.0, 3.0, 2.0, 2.5, 0.1), -5.0, -1.0, 2.0);
    }

    #[test]
    fn backwards_is_the_mirror_image() {
        is(grip(5.0, 3.0, -2.0, -1.0, 0.1), -8.0, -2.0, 0.0);
        is(grip(5.0, 3.0, -2.0, -2.0, 0.1), -2.0, 8.0, -2.0);
        is(grip(2.0, 3.0, -2.0, 0.0, 0.1), -5.0, 1.0, 0.0);
    }

    /// A mass under a constant load, pushed by the row alone: exact solution of the one-row problem, many steps.
    fn driven(strength: f64, friction: f64, speed: f64, load: f64, timestep: f64) -> Vec<f64> {
        let mut rate = 0.0;
        let step = |_| {
            let grip = grip(strength, friction, speed, rate, timestep);
            let wanted = (grip.target - rate) / timestep - load;
            rate += timestep * (load + wanted.clamp(grip.lower, grip.upper));
            rate
        };
        (0..4000).map(step).collect()
    }

    #[test]
    fn a_driven_mass_ends_where_statics_says() {
        let last = |m, f, s, load| *driven(m, f, s, load, 1e-3).last().unwrap();
        // A free mass reaches the speed; a load between M - F and M + F stalls it for good.
        assert!((last(5.0, 3.0, 2.0, 0.0) - 2.0).abs() < 1e-12);
        assert!((last(5.0, 3.0, 2.0, -1.9) - 0.1 * 4.0).abs() < 1e-12);
        assert!(driven(5.0, 3.0, 2.0, -4.0, 1e-3)
            .iter()
            .all(|r| r.abs() < 1e-15));
        // A greater load drives it back, a helping load does not make it faster.
        assert!(last(5.0, 3.0, 2.0, -9.0) < -3.9);
        assert!((last(5.0, 3.0, 2.0, 4.0) - 2.0).abs() < 1e-12);
        // A weak motor alone stands still, and with a helping load of more than F - M moves at its speed.
        assert!(last(2.0, 3.0, 2.0, 0.0).abs() < 1e-15);
        assert!((last(2.0, 3.0, 2.0, 1.5) - 2.0).abs() < 1e-12);
    }

    /// The speed is so low that it is reached within a step: the stall may then swing by what 2 F does in a step.
    #[test]
    fn a_stalled_fast_motor_swings_by_no_more_than_a_step() {
        let timestep = 1e-3;
        let rates = driven(5.0, 3.0, 1e-4, -4.0, timestep);
        assert!(rates.iter().all(|r| r.abs() <= 6.0 * timestep));
    }
}
