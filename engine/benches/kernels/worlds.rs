//! Steps of small worlds, ten at a time, once they have come to where they are measured.

use _engine::body::{MassProperties, State};
use _engine::collide::NoOracle;
use _engine::integrator::Integrator;
use _engine::model::Model;
use _engine::shape::Shape;
use _engine::world::World;
use glam::{DMat3, DVec3};

use super::{Kernel, Random};
use crate::common::{add, empty_model, tie_in_a_row};

const TIMESTEP: f64 = 1.0 / 240.0;
const STEPS: usize = 10;

pub const ALL: &[Kernel] = &[
    ("step: 1000 free boxes", || {
        steps(free(Integrator::SemiImplicitEuler), 2)
    }),
    ("step: 1000 free boxes, RK4", || {
        steps(free(Integrator::Rk4), 2)
    }),
    ("step: 10 columns of 10 boxes", || steps(columns(), 120)),
    ("step: wall of 55 boxes", || steps(wall(), 240)),
    ("step: heap of 125 balls, falling", || steps(heap(), 40)),
    ("step: heap of 125 balls, at rest", || steps(heap(), 720)),
    ("step: chain of 100", || steps(chain(), 120)),
];

/// Every run steps on from where the last one ended.
fn steps(mut world: World, before: usize) -> Box<dyn FnMut()> {
    advance(&mut world, before);
    Box::new(move || advance(&mut world, STEPS))
}

fn advance(world: &mut World, count: usize) {
    for _ in 0..count {
        world.step(&mut NoOracle).expect("no step fails");
    }
}

fn model(friction: f64) -> Model {
    empty_model(TIMESTEP, 0.0, friction)
}

fn cuboid(half: DVec3) -> (Shape, MassProperties) {
    let mass = 8000.0 * half.x * half.y * half.z;
    let square = half * half;
    let inertia = mass / 3.0 * (DVec3::splat(square.element_sum()) - square);
    let mass = MassProperties::new(mass, DMat3::from_diagonal(inertia));
    (Shape::Box { half }, mass)
}

fn ball(radius: f64) -> (Shape, MassProperties) {
    let mass = 4000.0 / 3.0 * std::f64::consts::PI * radius.powi(3);
    let inertia = DMat3::from_diagonal(DVec3::splat(0.4 * mass * radius * radius));
    (Shape::Sphere { radius }, MassProperties::new(mass, inertia))
}

fn put(model: &mut Model, (shape, mass): (Shape, MassProperties), place: DVec3) -> usize {
    add(model, shape, place, mass)
}

fn stand(model: &mut Model, shape: Shape, place: DVec3) {
    add(model, shape, place, MassProperties::fixed());
}

/// Cell k of a grid that is `across` wide and deep.
fn cell(k: u32, across: u32) -> DVec3 {
    let [x, y, z] = [k % across, k / across % across, k / across / across];
    DVec3::new(f64::from(x), f64::from(y), f64::from(z))
}

fn free(integrator: Integrator) -> World {
    let mut model = model(0.0);
    model.settings.integrator = integrator;
    model.forces.gravity = DVec3::ZERO;
    let mut random = Random(3);
    for k in 0..1000 {
        let half = DVec3::new(0.1, 0.2, 0.3);
        let body = put(&mut model, cuboid(half), 4.0 * cell(k, 10));
        let state = &mut model.bodies[body].1;
        state.angular_momentum = DVec3::Y + 0.1 * random.point();
        state.velocity = random.point();
    }
    World::new(model)
}

fn columns() -> World {
    let mut model = model(0.5);
    stand(&mut model, Shape::HalfSpace, DVec3::ZERO);
    for k in 0..100 {
        let place = DVec3::new(1.5 * f64::from(k / 10), 0.0, 0.5 + f64::from(k % 10));
        put(&mut model, cuboid(DVec3::splat(0.5)), place);
    }
    World::new(model)
}

fn wall() -> World {
    let mut model = model(0.5);
    stand(&mut model, Shape::HalfSpace, DVec3::ZERO);
    for row in 0..10 {
        for k in 0..10 - row {
            let x = 1.05 * (f64::from(k) - 0.5 * f64::from(9 - row));
            let place = DVec3::new(x, 0.0, 0.5 + f64::from(row));
            put(&mut model, cuboid(DVec3::splat(0.5)), place);
        }
    }
    World::new(model)
}

/// In a tub, five by five in five layers.
fn heap() -> World {
    let mut model = model(0.5);
    stand(&mut model, Shape::HalfSpace, DVec3::ZERO);
    for side in [-1.0, 1.0] {
        let half = DVec3::new(0.1, 1.0, 1.0);
        stand(&mut model, Shape::Box { half }, DVec3::X * (0.7 * side));
        let half = DVec3::new(1.0, 0.1, 1.0);
        stand(&mut model, Shape::Box { half }, DVec3::Y * (0.7 * side));
    }
    let mut random = Random(4);
    for k in 0..125 {
        let place = 0.22 * (cell(k, 5) - DVec3::new(2.0, 2.0, -1.0)) + 0.02 * random.point();
        put(&mut model, ball(0.1), place);
    }
    World::new(model)
}

/// Links on ball joints, let go while level, the first tied to the world.
fn chain() -> World {
    const LINKS: u32 = 100;
    const PITCH: f64 = 0.15;
    let mut model = model(0.0);
    let half = DVec3::X * (0.5 * PITCH);
    for k in 0..LINKS {
        let (_, mass) = cuboid(DVec3::new(0.5 * PITCH, 0.02, 0.02));
        let state = State {
            position: DVec3::X * (PITCH * (f64::from(k) + 0.5)),
            ..State::default()
        };
        model.bodies.push((mass, state, DVec3::ZERO));
    }
    tie_in_a_row(&mut model, half);
    World::new(model)
}
