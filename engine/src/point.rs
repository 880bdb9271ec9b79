//! A contact as the solver sweeps over it: what a pass reads and writes, and nothing else, side by side in memory.

use std::ops::Index;

use glam::{DMat3, DVec3};

use crate::cone::Cone;
use crate::contact::{Contact, Friction};
use crate::math::length;
use crate::mover::{Movers, Moving, Part, Twist};
use crate::roll::Roll;

/// A contact in the solve at hand.
#[derive(Clone, Debug, Default)]
pub(crate) struct Point {
    pub(crate) bodies: (u32, u32),
    kinetic: bool,
    /// It touches at no more than the speed up to which friction counts as static.
    pub(crate) quiet: bool,
    /// Normal and tangents.
    pub(crate) axes: [DVec3; 3],
    pub(crate) arms: (DVec3, DVec3),
    /// What the bodies' relative velocity lacks of the one asked about: belts and turning on, less the target.
    pub(crate) offset: DVec3,
    pub(crate) cone: Cone<f64>,
    kinetic_friction: f64,
    /// Normal, tangent 1, tangent 2 [N s].
    pub(crate) impulse: DVec3,
    pub(crate) roll: Option<Box<Roll>>,
}

impl Point {
    /// Of a contact between movers of these indices, but for its rolling friction.
    pub(crate) fn of(c: &Contact, bodies: (u32, u32), quiet_speed: f64) -> Self {
        let k = c.stiffness();
        Self {
            bodies,
            kinetic: c.friction == Friction::Kinetic,
            quiet: c.velocity_before.length() <= quiet_speed,
            axes: [c.normal, c.tangent_1, c.tangent_2],
            arms: c.arms,
            offset: c.surface + c.ahead - DVec3::X * c.target,
            cone: Cone {
                k: k.to_array(),
                inverse: (1.0 / (k + DVec3::X * c.give)).to_array(),
                k_coupling: c.k_coupling,
                give: c.give,
                friction: c.friction_coefficient(),
            },
            kinetic_friction: c.coefficients.kinetic_friction,
            impulse: c.impulse,
            roll: None,
        }
    }

    /// The results, to the contact that this is of.
    pub(crate) fn tell(&self, c: &mut Contact) {
        c.impulse = self.impulse;
        if self.kinetic {
            c.friction = Friction::Kinetic;
        }
    }

    pub(crate) fn a(&self) -> usize {
        self.bodies.0 as usize
    }

    pub(crate) fn b(&self) -> usize {
        self.bodies.1 as usize
    }

    pub(crate) fn to_world(&self, local: DVec3) -> DVec3 {
        let [normal, tangent_1, tangent_2] = self.axes;
        normal * local.x + tangent_1 * local.y + tangent_2 * local.z
    }

    /// Relative velocity of two twists along normal and tangents [m/s].
    pub(crate) fn relative(&self, a: &Twist, b: &Twist) -> DVec3 {
        let u = a.at(self.arms.0) - b.at(self.arms.1);
        DVec3::from_array(self.axes.map(|axis| u.dot(axis)))
    }

    /// What the velocity is beyond the target, along the normal, and the slip along the tangents [m/s].
    pub(crate) fn velocity(&self, movers: &(impl Movers + ?Sized)) -> DVec3 {
        self.relative(&movers[self.a()].twist, &movers[self.b()].twist) + self.offset
    }

    /// What the velocity lacks of the target and of standing still, with what the contact gives way [m/s].
    pub(crate) fn missing(&self, movers: &(impl Movers + ?Sized)) -> DVec3 {
        -DVec3::X * (self.cone.give * self.impulse.x) - self.velocity(movers)
    }

    /// Relative angular velocity, in world axes [rad/s].
    pub(crate) fn turning<M: Moving>(
        &self,
        moving: &(impl Index<usize, Output = M> + ?Sized),
    ) -> DVec3 {
        let (a, b) = (moving[self.a()].twist(), moving[self.b()].twist());
        a.angular_velocity - b.angular_velocity
    }

    /// The bodies get an impulse, given along normal and tangents.
    pub(crate) fn push(&self, movers: &mut (impl Movers + ?Sized), impulse: DVec3) {
        if impulse == DVec3::ZERO {
            return;
        }
        let p = self.to_world(impulse);
        movers[self.a()].push(p, self.arms.0);
        movers[self.b()].push(-p, self.arms.1);
    }

    /// What an impulse along normal and tangents does to the two bodies.
    pub(crate) fn responses(&self, movers: &(impl Movers + ?Sized), impulse: DVec3) -> [Twist; 2] {
        let p = self.to_world(impulse);
        [
            movers[self.a()].response(p, self.arms.0),
            movers[self.b()].response(-p, self.arms.1),
        ]
    }

    /// Normal and tangents.
    pub(crate) fn frame(&self) -> DMat3 {
        let [normal, tangent_1, tangent_2] = self.axes;
        DMat3::from_cols(normal, tangent_1, tangent_2)
    }

    /// An impulse along normal and tangents, and its angular impulse, on both bodies.
    pub(crate) fn wrenches(&self, impulse: DVec3) -> [[f64; 6]; 2] {
        let p = self.to_world(impulse);
        [
            coordinates(p, self.arms.0.cross(p)),
            coordinates(-p, self.arms.1.cross(-p)),
        ]
    }

    /// Relative velocity of two twists in coordinates.
    pub(crate) fn relative_of(&self, a: &[f64; 6], b: &[f64; 6]) -> DVec3 {
        let twist = |t: &[f64; 6]| Twist {
            velocity: DVec3::new(t[0], t[1], t[2]),
            angular_velocity: DVec3::new(t[3], t[4], t[5]),
        };
        self.relative(&twist(a), &twist(b))
    }

    /// The exact answer of the contact, all others held; returns the greatest change of its velocity [m/s].
    pub(crate) fn solve(&mut self, movers: &mut (impl Movers + ?Sized), part: Part) -> f64 {
        let u = self.velocity(movers);
        let old = self.impulse;
        let new = self.cone.answer(u.to_array(), old.to_array(), part);
        self.impulse = DVec3::from_array(new);
        let change = self.impulse - old;
        self.push(movers, change);
        (change * self.k()).abs().max_element()
    }

    /// Diagonal of K: normal, tangent 1, tangent 2 [1/kg].
    pub(crate) fn k(&self) -> DVec3 {
        DVec3::from_array(self.cone.k)
    }

    /// What of an impulse is allowed: no pull, and friction within the cone where it is solved for.
    pub(crate) fn allowed(&self, impulse: DVec3, part: Part) -> DVec3 {
        match part {
            Part::Normals => DVec3::new(impulse.x.max(0.0), impulse.y, impulse.z),
            Part::All => self.in_cone(impulse),
        }
    }

    /// The impulse brought into Coulomb's cone: no pull, friction shortened to mu times the normal impulse.
    fn in_cone(&self, impulse: DVec3) -> DVec3 {
        let normal = impulse.x.max(0.0);
        let (limit, length) = (self.cone.friction * normal, length(impulse.y, impulse.z));
        let scale = if length > limit { limit / length } else { 1.0 };
        DVec3::new(normal, impulse.y * scale, impulse.z * scale)
    }

    /// Static and on the rim of the disc, but slips faster than `noticeable`: kinetic from now on.
    pub(crate) fn release(&mut self, movers: &(impl Movers + ?Sized), noticeable: f64) -> bool {
        let full = self.cone.friction * self.impulse.x;
        let held = length(self.impulse.y, self.impulse.z) < full * (1.0 - 1e-9);
        if self.kinetic || held || self.impulse.x == 0.0 {
            return false;
        }
        let u = self.velocity(movers);
        if length(u.y, u.z) <= noticeable {
            return false;
        }
        self.kinetic = true;
        self.cone.friction = self.kinetic_friction;
        true
    }

    /// The exact answer of rolling and spinning friction, all else held; returns the change as a speed [m/s].
    pub(crate) fn solve_roll(&mut self, movers: &mut (impl Movers + ?Sized)) -> f64 {
        if self.roll.is_none() {
            return 0.0;
        }
        let (w, normal) = (self.turning(movers), self.impulse.x);
        self.set_turn(movers, |roll| roll.answer(roll.to_local(w), normal))
    }

    /// Change the angular impulse, where there is any; returns the change as a speed [m/s].
    pub(crate) fn set_turn(
        &mut self,
        movers: &mut (impl Movers + ?Sized),
        new: impl FnOnce(&Roll) -> DVec3,
    ) -> f64 {
        let Some(roll) = &mut self.roll else {
            return 0.0;
        };
        let new = new(roll);
        let change = new - roll.impulse;
        roll.impulse = new;
        let (q, speed) = (roll.to_world(change), roll.speed_of(change, self.cone.k[0]));
        self.turn(movers, q);
        speed
    }

    /// The bodies get an angular impulse, in world axes.
    pub(crate) fn turn(&self, movers: &mut (impl Movers + ?Sized), q: DVec3) {
        if q != DVec3::ZERO {
            movers[self.a()].turn(q);
            movers[self.b()].turn(-q);
        }
    }
}

fn coordinates(linear: DVec3, angular: DVec3) -> [f64; 6] {
    [
        linear.x, linear.y, linear.z, angular.x, angular.y, angular.z,
    ]
}
