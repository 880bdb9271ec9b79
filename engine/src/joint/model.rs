//! What a joint is and what drives it, as plain values.

use std::sync::Arc;

use glam::{DQuat, DVec3};

use crate::profile::Profile;

/// Kinds of joints with what is particular to each. What a kind holds and which coordinates it leaves is in `layout.rs`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// The anchors stay at a distance.
    Distance {
        /// [m]
        length: f64,
    },
    /// The anchors stay together.
    Ball,
    /// The anchors and the z axes stay together.
    Hinge,
    /// B travels along the z axis of A and does not turn.
    Slider,
    /// Nothing moves.
    Fixed,
    /// A ball joint whose z axes stay within an angle of each other.
    Cone {
        /// [rad]
        max_angle: f64,
        /// Of the rim, 0 ..= 1.
        restitution: f64,
    },
    /// The anchors stay together, z of A and x of B perpendicular (Cardan's joint).
    Universal,
    /// B travels along the z axis of A and turns about it.
    Cylindrical,
    /// B stays in the plane through the anchor of A across its z axis, and turns about z.
    Planar,
    /// A cylindrical joint with travel = pitch * angle.
    Screw {
        /// [m/rad]
        pitch: f64,
    },
    /// angle_2 = ratio * angle_1 of two other joints.
    Gear {
        /// Without unit.
        ratio: f64,
        /// Their indices; each has an angle.
        joints: [usize; 2],
    },
    /// Holds nothing; its distance can be limited.
    Stops,
}

/// A joint between bodies A and B.
#[derive(Clone, Debug)]
pub struct JointModel {
    /// What it holds.
    pub kind: Kind,
    /// A and B. Of a gear: the bodies B of its two joints, the wheels.
    pub bodies: [usize; 2],
    /// Anchors from the centres of mass [m], body axes.
    pub anchors: [DVec3; 2],
    /// Joint frames -> body axes. Coordinates are zero where both frames coincide.
    pub frames: [DQuat; 2],
    /// c of the torque -c (omega_B - omega_A) on B [N m s/rad].
    pub damping: f64,
    /// Force [N] that breaks it, infinite for never.
    pub break_force: f64,
    /// Torque [N m] about its anchor that breaks it, infinite for never.
    pub break_torque: f64,
}

/// What moves a coordinate by itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Motor {
    /// Holds a speed as long as its strength lasts.
    Speed {
        /// [rad/s or m/s]
        speed: f64,
        /// Greatest torque or force [N m or N].
        max: f64,
    },
    /// Pulls the coordinate q to a target: stiffness (target - q) + damping d(target - q)/dt, cut off at `max`.
    Servo {
        /// [rad or m]
        target: f64,
        /// [N m/rad or N/m]
        stiffness: f64,
        /// [N m s/rad or N s/m]
        damping: f64,
        /// [N m or N]
        max: f64,
    },
}

/// What limits, brakes, pulls and moves one coordinate of a joint. Units of an angle are given, those of a travel
/// have m for rad and N for N m.
#[derive(Clone, Debug)]
pub struct DriveModel {
    /// Index of the joint.
    pub joint: usize,
    /// Which of its coordinates.
    pub coordinate: usize,
    /// Lowest and highest value [rad], infinite where there is no limit.
    pub limits: [f64; 2],
    /// Of the limits, 0 ..= 1.
    pub restitution: f64,
    /// Dry friction [N m].
    pub friction: f64,
    /// [N m s/rad]
    pub damping: f64,
    /// Of the spring back to `rest` [N m/rad].
    pub stiffness: f64,
    /// [rad]
    pub rest: f64,
    /// What moves it.
    pub motor: Option<Motor>,
    /// Factor over time of the motor's speed or target; none for 1.
    pub profile: Option<Arc<Profile>>,
}

impl DriveModel {
    /// One that does nothing.
    #[must_use]
    pub fn free(joint: usize, coordinate: usize) -> Self {
        Self {
            joint,
            coordinate,
            limits: [f64::NEG_INFINITY, f64::INFINITY],
            restitution: 0.0,
            friction: 0.0,
            damping: 0.0,
            stiffness: 0.0,
            rest: 0.0,
            motor: None,
            profile: None,
        }
    }
}
