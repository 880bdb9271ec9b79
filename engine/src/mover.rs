//! What the solvers read and write: bodies as they move while impulses are still being found.

use std::ops::{Index, IndexMut};

use glam::{DMat3, DVec3};

use crate::body::Body;

/// What is solved for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    /// Normal impulses, with friction held.
    Normals,
    /// Normal impulses and friction.
    All,
}

/// Linear and angular velocity of a body, or a change of them, or their rates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Twist {
    /// Of the centre of mass [m/s].
    pub velocity: DVec3,
    /// World axes [rad/s].
    pub angular_velocity: DVec3,
}

impl Twist {
    /// v + omega x r
    #[must_use]
    pub fn at(&self, r: DVec3) -> DVec3 {
        self.velocity + self.angular_velocity.cross(r)
    }

    /// self += other * factor
    pub fn add_scaled(&mut self, other: &Twist, factor: f64) {
        self.velocity += other.velocity * factor;
        self.angular_velocity += other.angular_velocity * factor;
    }
}

/// Something that moves with a twist.
pub trait Moving {
    /// Linear and angular velocity.
    fn twist(&self) -> Twist;
}

/// Something whose twist is being found.
pub(crate) trait Yielding: Moving {
    fn twist_mut(&mut self) -> &mut Twist;
}

impl Moving for Body {
    fn twist(&self) -> Twist {
        Twist {
            velocity: self.state.velocity,
            angular_velocity: self.angular_velocity,
        }
    }
}

impl Moving for Twist {
    fn twist(&self) -> Twist {
        *self
    }
}

impl Yielding for Twist {
    fn twist_mut(&mut self) -> &mut Twist {
        self
    }
}

impl Moving for Mover {
    fn twist(&self) -> Twist {
        self.twist
    }
}

impl Yielding for Mover {
    fn twist_mut(&mut self) -> &mut Twist {
        &mut self.twist
    }
}

/// What the sweeps read and write of a body, close together in memory.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mover {
    pub(crate) twist: Twist,
    pub(crate) inverse_mass: f64,
    pub(crate) inverse_inertia: DMat3,
}

impl Mover {
    /// As the body moves now.
    pub(crate) fn of(body: &Body) -> Self {
        Self {
            twist: body.twist(),
            inverse_mass: body.mass.inverse_mass,
            inverse_inertia: body.inverse_inertia,
        }
    }

    /// What an impulse `p` at the arm `r` does to the twist.
    pub(crate) fn response(&self, p: DVec3, r: DVec3) -> Twist {
        Twist {
            velocity: p * self.inverse_mass,
            angular_velocity: self.inverse_inertia * r.cross(p),
        }
    }

    /// Angular impulse `q`.
    pub(crate) fn turn(&mut self, q: DVec3) {
        self.twist.angular_velocity += self.inverse_inertia * q;
    }

    /// Impulse `p` at the arm `r`.
    pub(crate) fn push(&mut self, p: DVec3, r: DVec3) {
        let change = self.response(p, r);
        self.twist.velocity += change.velocity;
        self.twist.angular_velocity += change.angular_velocity;
    }
}

/// Movers by their index.
pub(crate) trait Movers: IndexMut<usize, Output = Mover> {}

impl<T: IndexMut<usize, Output = Mover> + ?Sized> Movers for T {}

/// Some of the bodies that are solved together, by their index among them all.
pub(crate) struct Window<'a, T = Mover> {
    first: usize,
    bodies: &'a mut [T],
}

impl<'a, T> Window<'a, T> {
    pub(crate) fn new(bodies: &'a mut [T]) -> Self {
        Self { first: 0, bodies }
    }

    /// The first so many of them, and the others.
    pub(crate) fn halves(&mut self, middle: usize) -> (Window<'_, T>, Window<'_, T>) {
        let (a, b) = self.bodies.split_at_mut(middle);
        let window = |first, bodies| Window { first, bodies };
        (window(self.first, a), window(self.first + middle, b))
    }
}

impl<T> Index<usize> for Window<'_, T> {
    type Output = T;

    #[inline(always)]
    fn index(&self, index: usize) -> &T {
        &self.bodies[index - self.first]
    }
}

impl<T> IndexMut<usize> for Window<'_, T> {
    #[inline(always)]
    fn index_mut(&mut self, index: usize) -> &mut T {
        &mut self.bodies[index - self.first]
    }
}
