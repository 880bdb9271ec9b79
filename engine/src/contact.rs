//! One contact point: its geometry, its effective mass, its coefficients and the impulses that act in it.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::body::Body;
use crate::math::length;
use crate::model::{Coefficients, Geom};
use crate::mover::Moving;
use crate::narrowphase::ContactPoint;
use crate::response::{response, Principal};
use crate::roll::Roll;

/// Friction of a contact in the solve at hand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Friction {
    /// Holds up to mu_s times the normal impulse.
    #[default]
    Static,
    /// At most (while it still slides: exactly) mu_k times the normal impulse.
    Kinetic,
}

/// A contact point between bodies A and B; all vectors in world axes, the normal from B to A.
#[derive(Clone, Debug, Default)]
pub struct Contact {
    /// Geoms in contact.
    pub geoms: (u32, u32),
    /// Bodies in contact.
    pub bodies: (usize, usize),
    /// Midway between the surfaces [m].
    pub position: DVec3,
    /// From B to A.
    pub normal: DVec3,
    /// First tangent; the two tangents are the axes in which the tangential effective mass is diagonal.
    pub tangent_1: DVec3,
    /// Second tangent.
    pub tangent_2: DVec3,
    /// Gap at the start of the step along the bodies' paths without impulses [m]; negative where they overlap.
    pub gap: f64,
    /// What the last contact solve may have left of its bodies' velocities [m/s].
    pub noise: f64,
    /// What the bodies' surfaces move by themselves (conveyors), A against B, along normal and tangents [m/s].
    pub surface: DVec3,
    /// What turning adds to the tangential velocity until it counts, see [`Contact::turning_ahead`] [m/s].
    pub ahead: DVec3,
    /// Instant within the step at which position and normal hold [s].
    pub instant: f64,
    /// Arms from the centres of mass [m].
    pub arms: (DVec3, DVec3),
    /// K of the normal [1/kg].
    pub k_normal: f64,
    /// By how much the contact gives way to its normal impulse [1/kg]; 0 but for one that joints hold rigid.
    pub give: f64,
    /// What a normal impulse does to the two tangential velocities [1/kg].
    pub k_coupling: (f64, f64),
    /// K of the tangents [1/kg].
    pub k_tangent: (f64, f64),
    /// Of the two materials.
    pub coefficients: Coefficients,
    /// Friction in the solve at hand.
    pub friction: Friction,
    /// Normal velocity that the solve at hand aims at [m/s].
    pub target: f64,
    /// Impulse of the solve at hand: normal, tangent 1, tangent 2 [N s].
    pub impulse: DVec3,
    /// Impulse of this step's impacts, in world axes [N s].
    pub impact_impulse: DVec3,
    /// Rolling and spinning friction, where the materials have any.
    pub roll: Option<Box<Roll>>,
    /// Relative velocity at the start of the step [m/s].
    pub velocity_before: DVec3,
    /// Relative velocity at the end of the step [m/s].
    pub velocity_after: DVec3,
    /// The contact slid at the end of the step.
    pub sliding: bool,
}

/// Relative velocity v_A + omega_A x r_A - v_B - omega_B x r_B [m/s].
#[inline]
#[must_use]
pub fn relative_velocity(
    moving: &[impl Moving],
    pair: (usize, usize),
    arms: (DVec3, DVec3),
) -> DVec3 {
    moving[pair.0].twist().at(arms.0) - moving[pair.1].twist().at(arms.1)
}

/// Two geoms that meet: what all their contact points share.
pub struct Meeting<'a> {
    geoms: (u32, u32),
    indices: (usize, usize),
    bodies: (&'a Body, &'a Body),
    centres: (DVec3, DVec3),
    coefficients: Coefficients,
    /// What A's surface moves against B's by itself, in world axes [m/s].
    belt: DVec3,
}

impl<'a> Meeting<'a> {
    /// Of two geoms on two of the bodies, which are at `centres` when they touch.
    #[must_use]
    pub fn new(
        geoms: (u32, u32),
        (a, b): (&Geom, &Geom),
        bodies: &'a [Body],
        centres: (DVec3, DVec3),
        coefficients: Coefficients,
    ) -> Self {
        let both = (&bodies[a.body], &bodies[b.body]);
        let own = |body: &Body| body.rotation * body.surface_velocity;
        Self {
            geoms,
            indices: (a.body, b.body),
            bodies: both,
            centres,
            coefficients,
            belt: own(both.0) - own(both.1),
        }
    }

    /// A contact becomes the one at a point found by the narrow phase. Every field is written in its place: building the
    /// contact elsewhere and copying it would wait for its own last stores.
    #[inline]
    pub fn put(&self, point: &ContactPoint, c: &mut Contact) {
        let (a, b) = self.bodies;
        let arms = (
            point.position - self.centres.0,
            point.position - self.centres.1,
        );
        let Principal { axes, k, coupling } = Principal::of(&response(a, b, arms), point.normal);
        let (tangent_1, tangent_2) = (axes.y_axis, axes.z_axis);
        let surface = DVec3::new(0.0, self.belt.dot(tangent_1), self.belt.dot(tangent_2));
        c.geoms = self.geoms;
        c.bodies = self.indices;
        c.position = point.position;
        c.normal = point.normal;
        c.tangent_1 = tangent_1;
        c.tangent_2 = tangent_2;
        c.gap = -point.depth;
        c.noise = 0.0;
        c.surface = surface;
        c.ahead = DVec3::ZERO;
        c.instant = 0.0;
        c.arms = arms;
        c.k_normal = k.x;
        c.give = 0.0;
        c.k_coupling = coupling;
        c.k_tangent = (k.y, k.z);
        c.coefficients = self.coefficients;
        c.friction = Friction::Static;
        c.target = 0.0;
        c.impulse = DVec3::ZERO;
        c.impact_impulse = DVec3::ZERO;
        c.roll = Roll::new(&self.coefficients, a, b, point.normal);
        c.velocity_before = a.velocity_at(arms.0) - b.velocity_at(arms.1)
            + tangent_1 * surface.y
            + tangent_2 * surface.z;
        c.velocity_after = DVec3::ZERO;
        c.sliding = false;
    }

    /// The contact at a point found by the narrow phase.
    #[must_use]
    pub fn contact(&self, point: &ContactPoint) -> Contact {
        let mut c = Contact::default();
        self.put(point, &mut c);
        c
    }
}

impl Contact {
    /// World vector of an impulse given along normal and tangents.
    #[must_use]
    pub fn to_world(&self, impulse: DVec3) -> DVec3 {
        self.normal * impulse.x + self.tangent_1 * impulse.y + self.tangent_2 * impulse.z
    }

    /// Components of a world vector along normal and tangents.
    #[must_use]
    pub fn to_local(&self, vector: DVec3) -> DVec3 {
        DVec3::new(
            vector.dot(self.normal),
            vector.dot(self.tangent_1),
            vector.dot(self.tangent_2),
        )
    }

    /// Relative velocity of the bodies' material points, along normal and tangents [m/s].
    pub(crate) fn material_velocity(&self, moving: &[impl Moving]) -> DVec3 {
        self.to_local(relative_velocity(moving, self.bodies, self.arms))
    }

    /// Relative velocity of the surfaces now, along normal and tangents [m/s].
    #[must_use]
    pub fn velocity(&self, moving: &[impl Moving]) -> DVec3 {
        self.material_velocity(moving) + self.surface
    }

    /// The same at the end of the step that is being solved.
    pub(crate) fn velocity_ahead(&self, moving: &[impl Moving]) -> DVec3 {
        self.velocity(moving) + self.ahead
    }

    /// What the tangential velocity gains in a time `t` because the place of contact moves on over turning bodies.
    ///
    /// With the arms of now and the velocities of then, the relative velocity misses how the arms changed: the place x
    /// moves at w, so d(v + omega x r)/dt has the part omega x (w - v) on each body, and
    /// u gains t [omega_A x (w - v_A) - omega_B x (w - v_B)]. A ball takes the place along with its centre, a corner with
    /// itself. Without this a body that sticks to a turntable creeps outwards by r omega^2 dt / 2 in unit time.
    #[must_use]
    pub fn turning_ahead(&self, bodies: &[Body], centres: [Option<DVec3>; 2], t: f64) -> DVec3 {
        let (a, b) = (&bodies[self.bodies.0], &bodies[self.bodies.1]);
        let w = match centres {
            [Some(arm), None] => a.velocity_at(arm),
            [None, Some(arm)] => b.velocity_at(arm),
            [None, None] => 0.5 * (a.velocity_at(self.arms.0) + b.velocity_at(self.arms.1)),
            [Some(_), Some(_)] => return DVec3::ZERO,
        };
        let turning = |body: &Body| body.angular_velocity.cross(w - body.state.velocity);
        let gained = self.to_local(turning(a) - turning(b)) * t;
        DVec3::new(0.0, gained.y, gained.z)
    }

    /// Relative angular velocity omega_A - omega_B now, in world axes [rad/s].
    #[must_use]
    pub fn turning(&self, moving: &[impl Moving]) -> DVec3 {
        let (a, b) = (moving[self.bodies.0].twist(), moving[self.bodies.1].twist());
        a.angular_velocity - b.angular_velocity
    }

    /// The part of it that fixed bodies on a path have [rad/s].
    #[must_use]
    pub fn driven_turning(&self, bodies: &[Body]) -> DVec3 {
        let of = |body: &Body| {
            if body.is_fixed() {
                body.angular_velocity
            } else {
                DVec3::ZERO
            }
        };
        of(&bodies[self.bodies.0]) - of(&bodies[self.bodies.1])
    }

    /// Angular impulse of the solve at hand, in world axes [N m s].
    #[must_use]
    pub fn turn(&self) -> DVec3 {
        self.roll
            .as_ref()
            .map_or(DVec3::ZERO, |roll| roll.to_world(roll.impulse))
    }

    /// No impulses yet in the solve at hand.
    pub fn clear_impulse(&mut self) {
        self.impulse = DVec3::ZERO;
        if let Some(roll) = &mut self.roll {
            roll.impulse = DVec3::ZERO;
        }
    }

    /// The part of the relative velocity that is driven from outside, by conveyors and by fixed bodies on a path [m/s].
    #[must_use]
    pub fn driven(&self, bodies: &[Body]) -> DVec3 {
        let of = |body: usize, arm: DVec3| {
            if bodies[body].is_fixed() {
                bodies[body].velocity_at(arm)
            } else {
                DVec3::ZERO
            }
        };
        of(self.bodies.0, self.arms.0) - of(self.bodies.1, self.arms.1)
            + self.to_world(self.surface)
    }

    /// Tangential part of all impulses of the step, in world axes [N s].
    #[must_use]
    pub fn tangential_impulse(&self) -> DVec3 {
        let total = self.to_world(self.impulse) + self.impact_impulse;
        total - self.normal * total.dot(self.normal)
    }

    /// Diagonal of K: normal, tangent 1, tangent 2 [1/kg].
    #[must_use]
    pub fn stiffness(&self) -> DVec3 {
        DVec3::new(self.k_normal, self.k_tangent.0, self.k_tangent.1)
    }

    /// mu of the solve at hand.
    #[must_use]
    pub fn friction_coefficient(&self) -> f64 {
        match self.friction {
            Friction::Static => self.coefficients.static_friction,
            Friction::Kinetic => self.coefficients.kinetic_friction,
        }
    }

    /// Choose the friction of the next solve by the slip at its start.
    pub fn choose_friction(&mut self, velocity: DVec3, slip_speed: f64) {
        let slip = length(velocity.y, velocity.z);
        self.friction = if slip < slip_speed {
            Friction::Static
        } else {
            Friction::Kinetic
        };
    }

    /// Apply an impulse, given along normal and tangents, to both bodies.
    pub fn apply(&self, bodies: &mut [Body], impulse: DVec3) {
        let p = self.to_world(impulse);
        bodies[self.bodies.0].apply_impulse(p, self.arms.0);
        bodies[self.bodies.1].apply_impulse(-p, self.arms.1);
    }
}

/// What a contact leaves to the next step: where it was on body A, and its force and torque.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub struct Remembered {
    geoms: (u32, u32),
    place: DVec3,
    force: DVec3,
    torque: Option<DVec3>,
}

/// Contacts of the last step, for the warm start. Sorted by geoms, as contacts are.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Memory {
    points: Vec<Remembered>,
}

impl Memory {
    /// What was remembered, for contacts of the next step of `h` [s] in their order. Points farther apart than `radius`
    /// of a geom pair are strangers.
    pub fn recall<'a>(&'a mut self, radius: &'a [f64], h: f64) -> Recall<'a> {
        Recall {
            points: &mut self.points,
            radius,
            h,
        }
    }

    /// Places for so many contacts, to be written over.
    pub fn renew(&mut self, contacts: usize) -> &mut [Remembered] {
        self.points.resize(contacts, Remembered::default());
        &mut self.points
    }
}

impl Remembered {
    /// Of a contact that passed on the impulse `p`, in world axes, over the step of `h` [s].
    #[must_use]
    pub fn of(c: &Contact, p: DVec3, bodies: &[Body], h: f64) -> Self {
        Self {
            geoms: c.geoms,
            place: place_on_a(c, bodies),
            force: p / h,
            torque: c.roll.as_ref().map(|_| c.turn() / h),
        }
    }
}

/// Where a contact is on body A, in its axes [m].
fn place_on_a(c: &Contact, bodies: &[Body]) -> DVec3 {
    bodies[c.bodies.0].rotation.transpose() * c.arms.0
}

/// Memories of contacts that come in their order.
pub struct Recall<'a> {
    /// Those of the contacts that are still to come.
    points: &'a mut [Remembered],
    radius: &'a [f64],
    h: f64,
}

impl Recall<'_> {
    /// Those of the contacts before a pair of geoms, and the others.
    #[must_use]
    pub fn split_at(self, pair: (u32, u32)) -> (Self, Self) {
        let border = self.points.partition_point(|p| p.geoms < pair);
        let (before, after) = self.points.split_at_mut(border);
        let of = |points| Self { points, ..self };
        (of(before), of(after))
    }

    /// Start a contact from the force of the nearest point of the same geoms in the step before, each point used once.
    pub fn start(&mut self, c: &mut Contact, bodies: &[Body]) {
        let past = self.points.iter().take_while(|p| p.geoms < c.geoms);
        let past = past.count();
        self.points = &mut std::mem::take(&mut self.points)[past..];
        let place = place_on_a(c, bodies);
        let limit = self.radius[c.geoms.0 as usize].min(self.radius[c.geoms.1 as usize]);
        let mut best = (limit * limit, None);
        for point in self.points.iter_mut().take_while(|p| p.geoms == c.geoms) {
            let distance = (point.place - place).length_squared();
            if distance < best.0 {
                best = (distance, Some(point));
            }
        }
        if let Some(point) = best.1 {
            c.impulse = c.to_local(point.force * self.h);
            c.impulse.x = c.impulse.x.max(0.0);
            if let (Some(roll), Some(torque)) = (&mut c.roll, point.torque) {
                roll.impulse = roll.to_local(torque * self.h);
            }
            point.place = DVec3::INFINITY;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::{MassProperties, State};
    use crate::shape::Shape;
    use glam::DMat3;

    #[test]
    fn nothing_of_a_used_place_stays() {
        let mass = MassProperties::new(2.0, DMat3::from_diagonal(DVec3::new(0.3, 0.4, 0.5)));
        let bodies = [0.0, 1.0].map(|x| {
            let position = DVec3::new(x, 0.0, 0.0);
            Body::new(
                mass.clone(),
                State {
                    position,
                    ..State::default()
                },
            )
        });
        let geom = |body| Geom {
            body,
            shape: Shape::Sphere { radius: 0.5 },
            position: DVec3::ZERO,
            rotation: DMat3::IDENTITY,
            material: 0,
        };
        let meeting = |rolling_friction| {
            let coefficients = Coefficients {
                rolling_friction,
                ..Coefficients::default()
            };
            let centres = (bodies[0].state.position, bodies[1].state.position);
            Meeting::new((0, 1), (&geom(0), &geom(1)), &bodies, centres, coefficients)
        };
        let point = ContactPoint {
            position: DVec3::new(0.5, 0.0, 0.0),
            normal: DVec3::NEG_X,
            depth: 1e-3,
        };
        let mut used = Contact {
            noise: 1.0,
            ahead: DVec3::ONE,
            instant: 1.0,
            give: 1.0,
            friction: Friction::Kinetic,
            target: 1.0,
            impulse: DVec3::ONE,
            impact_impulse: DVec3::ONE,
            velocity_after: DVec3::ONE,
            sliding: true,
            ..meeting(0.1).contact(&point)
        };
        meeting(0.0).put(&point, &mut used);
        let new = meeting(0.0).contact(&point);
        assert_eq!(format!("{used:?}"), format!("{new:?}"));
    }
}
