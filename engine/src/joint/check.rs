//! What must be so before joints can be built: joints and drives that fit together.

use super::measure::Measure;
use super::model::{DriveModel, JointModel, Kind, Motor};

impl Kind {
    /// Number of coordinates that it leaves.
    #[must_use]
    pub fn coordinate_count(self) -> usize {
        self.layout().coordinates.len()
    }

    /// One of its coordinates counts turns, so that it can carry a gear.
    #[must_use]
    pub fn has_angle(self) -> bool {
        self.layout()
            .coordinates
            .iter()
            .any(|c: &Measure| c.wraps())
    }
}

/// Whether joints can be built of these models.
///
/// # Errors
/// Says which joint or drive cannot be, and why.
pub fn check(models: &[JointModel], drives: &[DriveModel]) -> Result<(), String> {
    for (j, model) in models.iter().enumerate() {
        model.check(models).map_err(|e| format!("joint {j}: {e}"))?;
    }
    for (k, drive) in drives.iter().enumerate() {
        drive.check(models).map_err(|e| format!("drive {k}: {e}"))?;
    }
    Ok(())
}

fn require(holds: bool, message: &str) -> Result<(), String> {
    if holds {
        Ok(())
    } else {
        Err(message.into())
    }
}

impl JointModel {
    fn check(&self, all: &[Self]) -> Result<(), String> {
        if let Kind::Gear { joints, .. } = self.kind {
            let carries = |&k: &usize| all.get(k).is_some_and(|other| other.kind.has_angle());
            require(
                joints.iter().all(carries),
                "a gear needs two joints with an angle",
            )?;
            require(joints[0] != joints[1], "a gear needs two different joints")?;
        } else {
            require(
                self.bodies[0] != self.bodies[1],
                "a body cannot be joined to itself",
            )?;
        }
        let placed = self.anchors.iter().all(|a| a.is_finite());
        let turned = self
            .frames
            .iter()
            .all(|q| q.is_finite() && q.length_squared() > 0.0);
        require(placed && turned, "anchors and frames must be finite")?;
        require(self.kind.is_finite(), "parameters must be finite")?;
        require(
            is_amount(self.damping),
            "damping must be finite, not negative",
        )?;
        // Infinite means never, so only what is not a number is refused here.
        require(
            self.break_force >= 0.0 && self.break_torque >= 0.0,
            "breaking force and torque must not be negative",
        )
    }
}

impl Kind {
    fn is_finite(self) -> bool {
        match self {
            Self::Distance { length } => length.is_finite(),
            Self::Cone {
                max_angle,
                restitution,
            } => max_angle.is_finite() && restitution.is_finite(),
            Self::Screw { pitch } => pitch.is_finite(),
            Self::Gear { ratio, .. } => ratio.is_finite(),
            _ => true,
        }
    }
}

impl DriveModel {
    fn check(&self, joints: &[JointModel]) -> Result<(), String> {
        let joint = joints.get(self.joint).ok_or("there is no such joint")?;
        let count = joint.kind.coordinate_count();
        require(self.coordinate < count, "its joint has no such coordinate")?;
        let [low, high] = self.limits;
        require(low <= high, "limits must rise")?;
        require(
            (0.0..=1.0).contains(&self.restitution),
            "restitution must be 0 to 1",
        )?;
        let amounts = [self.friction, self.damping, self.stiffness];
        require(
            amounts.into_iter().all(is_amount) && self.rest.is_finite(),
            "friction, damping and spring must be finite, not negative",
        )?;
        self.motor.map_or(Ok(()), Motor::check)
    }
}

impl Motor {
    fn check(self) -> Result<(), String> {
        let (holds, max) = match self {
            Self::Speed { speed, max } => (speed.is_finite(), max),
            Self::Servo {
                target,
                stiffness,
                damping,
                max,
            } => (
                target.is_finite() && is_amount(stiffness) && is_amount(damping),
                max,
            ),
        };
        // The greatest force may be infinite.
        require(
            holds && max >= 0.0,
            "motor: numbers must be finite, its strength not negative",
        )
    }
}

fn is_amount(x: f64) -> bool {
    x.is_finite() && x >= 0.0
}

#[cfg(test)]
mod tests {
    use glam::{DQuat, DVec3};

    use super::*;

    fn joint(kind: Kind) -> JointModel {
        JointModel {
            kind,
            bodies: [0, 1],
            anchors: [DVec3::ZERO; 2],
            frames: [DQuat::IDENTITY; 2],
            damping: 0.0,
            break_force: f64::INFINITY,
            break_torque: f64::INFINITY,
        }
    }

    fn refused(models: &[JointModel], drives: &[DriveModel], word: &str) {
        let error = check(models, drives).unwrap_err();
        assert!(error.contains(word), "{error}");
    }

    #[test]
    fn gears_need_joints_with_angles() {
        let gear = |joints| joint(Kind::Gear { ratio: 2.0, joints });
        let hinges = || vec![joint(Kind::Hinge), joint(Kind::Screw { pitch: 0.1 })];
        let with = |mut models: Vec<JointModel>, joints| {
            models.push(gear(joints));
            models
        };
        assert_eq!(check(&with(hinges(), [0, 1]), &[]), Ok(()));
        refused(&with(hinges(), [0, 0]), &[], "different");
        refused(&with(hinges(), [0, 2]), &[], "with an angle");
        refused(&with(hinges(), [0, 9]), &[], "with an angle");
        refused(&[joint(Kind::Ball), gear([0, 0])], &[], "with an angle");
    }

    #[test]
    fn drives_need_their_coordinate() {
        let hinge = [joint(Kind::Hinge)];
        assert_eq!(check(&hinge, &[DriveModel::free(0, 0)]), Ok(()));
        refused(&hinge, &[DriveModel::free(0, 1)], "coordinate");
        refused(&hinge, &[DriveModel::free(1, 0)], "no such joint");
    }

    #[test]
    fn numbers_are_looked_at() {
        let mut loose = joint(Kind::Ball);
        loose.damping = -1.0;
        refused(&[loose], &[], "damping");
        let mut alone = joint(Kind::Ball);
        alone.bodies = [1, 1];
        refused(&[alone], &[], "itself");
        let endless = Kind::Distance { length: f64::NAN };
        refused(&[joint(endless)], &[], "finite");
        let hinge = [joint(Kind::Hinge)];
        let mut drive = DriveModel::free(0, 0);
        drive.limits = [1.0, f64::NAN];
        refused(&hinge, &[drive.clone()], "limits");
        drive.limits = [-1.0, 1.0];
        drive.motor = Some(Motor::Servo {
            target: 0.0,
            stiffness: 1.0,
            damping: 1.0,
            max: -1.0,
        });
        refused(&hinge, &[drive], "strength");
    }
}
