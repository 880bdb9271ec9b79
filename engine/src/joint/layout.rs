//! What each kind of joint holds and which coordinates it leaves: the one table of the kinds.

use super::measure::Measure;
use super::model::Kind;

/// One bilateral row of a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Equation {
    /// The measure is zero.
    Zero(Measure),
    /// The distance of the anchors is the joint's length.
    Length,
    /// travel - pitch * angle = 0
    Thread,
    /// angle_2 - ratio * angle_1 = 0
    Gear,
}

impl Equation {
    /// Its value is an angle.
    pub(super) const fn is_angular(self) -> bool {
        match self {
            Self::Zero(measure) => measure.is_angular(),
            Self::Length | Self::Thread => false,
            Self::Gear => true,
        }
    }
}

/// Rows and coordinates of a kind.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layout {
    pub(super) equations: &'static [Equation],
    pub(super) coordinates: &'static [Measure],
}

const X: Equation = Equation::Zero(Measure::Gap(0));
const Y: Equation = Equation::Zero(Measure::Gap(1));
const Z: Equation = Equation::Zero(Measure::Gap(2));
const TURN_X: Equation = Equation::Zero(Measure::Turn(0));
const TURN_Y: Equation = Equation::Zero(Measure::Turn(1));
const TURN_Z: Equation = Equation::Zero(Measure::Turn(2));
const LEAN_X: Equation = Equation::Zero(Measure::Lean(0));
const LEAN_Y: Equation = Equation::Zero(Measure::Lean(1));
const SQUARE: Equation = Equation::Zero(Measure::Square);
const TRAVEL: Measure = Measure::Gap(2);

impl Kind {
    /// Of this kind; the numbers of `coordinates` are those that drives name.
    pub(super) const fn layout(self) -> Layout {
        let (equations, coordinates): (&'static [Equation], &'static [Measure]) = match self {
            Self::Distance { .. } => (&[Equation::Length], &[Measure::Length]),
            Self::Ball => (&[X, Y, Z], &[]),
            Self::Hinge => (&[X, Y, Z, LEAN_X, LEAN_Y], &[Measure::Twist]),
            Self::Slider => (&[X, Y, TURN_X, TURN_Y, TURN_Z], &[TRAVEL]),
            Self::Fixed => (&[X, Y, Z, TURN_X, TURN_Y, TURN_Z], &[]),
            Self::Cone { .. } => (&[X, Y, Z], &[Measure::Tilt]),
            Self::Universal => (&[X, Y, Z, SQUARE], &[Measure::Twist, Measure::Bend]),
            Self::Cylindrical => (&[X, Y, LEAN_X, LEAN_Y], &[TRAVEL, Measure::Twist]),
            Self::Planar => (
                &[Z, LEAN_X, LEAN_Y],
                &[Measure::Gap(0), Measure::Gap(1), Measure::Twist],
            ),
            Self::Screw { .. } => (&[X, Y, LEAN_X, LEAN_Y, Equation::Thread], &[Measure::Twist]),
            Self::Gear { .. } => (&[Equation::Gear], &[]),
            Self::Stops => (&[], &[Measure::Length]),
        };
        Layout {
            equations,
            coordinates,
        }
    }
}
