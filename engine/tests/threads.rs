//! The same bits on any number of threads.

mod common;

use _engine::body::MassProperties;
use _engine::collide::NoOracle;
use _engine::integrator::Integrator;
use _engine::joint::{JointModel, Kind};
use _engine::model::{Coefficients, Model, PairTable};
use _engine::shape::Shape;
use _engine::world::World;
use common::empty_model;
use glam::{DMat3, DQuat, DVec3};

/// A body turned a little, each in its own way, so that nothing falls symmetrically.
fn add(model: &mut Model, shape: Shape, position: DVec3, mass: MassProperties) -> usize {
    let body = common::add(model, shape, position, mass);
    let angle = 0.1 * (body as f64 * 0.7).sin();
    model.bodies[body].1.orientation =
        DQuat::from_rotation_x(angle) * DQuat::from_rotation_y(0.3 * angle);
    body
}

fn moving() -> MassProperties {
    MassProperties::new(1.0, DMat3::from_diagonal(DVec3::splat(4e-3)))
}

fn floor(model: &mut Model) {
    let still = MassProperties::fixed();
    add(model, Shape::HalfSpace, DVec3::ZERO, still);
    model.bodies[0].1.orientation = DQuat::IDENTITY;
}

fn ball() -> Shape {
    Shape::Sphere { radius: 0.1 }
}

fn cube() -> Shape {
    Shape::Box {
        half: DVec3::splat(0.1),
    }
}

fn capsule() -> Shape {
    Shape::Capsule {
        radius: 0.07,
        half_height: 0.06,
    }
}

/// A heap that falls: `shapes` in turn on a lattice.
fn heap(shapes: &[Shape]) -> Model {
    let mut model = empty_model(1.0 / 240.0, 0.2, 0.5);
    floor(&mut model);
    for k in 0..500 {
        let (x, y, z) = (k % 7, k / 7 % 8, k / 56);
        let place = DVec3::new(f64::from(x), f64::from(y), f64::from(z)) * 0.203;
        let shape = shapes[k as usize % shapes.len()].clone();
        add(&mut model, shape, place + DVec3::Z * 0.11, moving());
    }
    model
}

fn columns() -> Model {
    let mut model = empty_model(1.0 / 240.0, 0.0, 0.5);
    floor(&mut model);
    for k in 0..160 {
        let (column, row) = (f64::from(k / 4), f64::from(k % 4));
        let place = DVec3::new(0.5 * column, 0.0, 0.1 + 0.2 * row);
        add(&mut model, cube(), place, moving());
    }
    model
}

/// Balls that hit the floor, each at an instant of its own.
fn rain() -> Model {
    let mut model = empty_model(1.0 / 240.0, 0.5, 0.5);
    floor(&mut model);
    for k in 0..150 {
        let (x, y) = (f64::from(k % 15), f64::from(k / 15));
        let height = 0.1001 + 0.0005 * (1.7 * f64::from(k)).sin().abs();
        let place = DVec3::new(0.3 * x, 0.3 * y, height);
        add(&mut model, ball(), place, moving());
    }
    model
}

/// A heap, on which a net of linked balls falls.
fn chains_on_a_heap() -> Model {
    let mut model = heap(&[ball()]);
    model.bodies.truncate(300);
    model.geoms.truncate(300);
    for chain in 0..4 {
        let mut last = None;
        for link in 0..12 {
            let place = DVec3::new(0.15 * f64::from(link), 0.3 * f64::from(chain), 1.6);
            let body = add(&mut model, ball(), place, moving());
            if let Some(last) = last {
                model.no_contact.push((last, body));
                model.joints.push(link_between(&model, last, body));
            }
            last = Some(body);
        }
    }
    model
}

fn link_between(model: &Model, a: usize, b: usize) -> JointModel {
    let state = |k: usize| &model.bodies[k].1;
    let anchor = 0.5 * (state(a).position + state(b).position);
    let local = |k: usize| state(k).orientation.inverse() * (anchor - state(k).position);
    JointModel {
        kind: Kind::Ball,
        bodies: [a, b],
        anchors: [local(a), local(b)],
        frames: [a, b].map(|k| state(k).orientation.inverse()),
        damping: 0.0,
        break_force: f64::INFINITY,
        break_torque: f64::INFINITY,
    }
}

fn with_rolling_friction(mut model: Model) -> Model {
    let coefficients = Coefficients {
        rolling_friction: 0.002,
        spinning_friction: 0.001,
        ..model.pairs.get(0, 0)
    };
    model.pairs = PairTable::new(1, vec![coefficients]);
    model
}

fn located(mut model: Model) -> Model {
    model.settings.located = true;
    model.settings.integrator = Integrator::VelocityVerlet;
    model
}

/// Every bit of the states, and of the ledger.
fn bits(world: &World) -> Vec<u64> {
    let of = |b: &_engine::body::Body| {
        let s = b.state;
        let vectors = [s.position, s.velocity, s.angular_momentum];
        let numbers = vectors.iter().flat_map(|v| v.to_array());
        let all: Vec<u64> = numbers
            .chain(s.orientation.to_array())
            .map(f64::to_bits)
            .collect();
        all
    };
    let books = world.energies();
    let mut out: Vec<u64> = world.bodies().iter().flat_map(of).collect();
    out.extend([books.total(), books.residual()].map(f64::to_bits));
    out
}

fn same_bits(name: &str, steps: usize, model: impl Fn() -> Model) {
    let run = |threads: usize| {
        let mut world = World::new(model());
        world.set_threads(threads);
        for _ in 0..steps {
            world.step(&mut NoOracle).expect("no step fails");
        }
        bits(&world)
    };
    let alone = run(1);
    for threads in 2..=3 {
        assert!(run(threads) == alone, "{name} on {threads} threads");
    }
}

#[test]
fn heaps_have_the_same_bits() {
    same_bits("balls", 60, || heap(&[ball()]));
    same_bits("cubes", 40, || heap(&[cube()]));
    same_bits("mixed", 60, || heap(&[ball(), cube(), capsule()]));
}

#[test]
fn islands_have_the_same_bits() {
    same_bits("columns", 60, columns);
}

#[test]
fn joints_and_rolling_friction_have_the_same_bits() {
    same_bits("chains", 60, chains_on_a_heap);
    same_bits("rolling", 40, || with_rolling_friction(heap(&[ball()])));
}

#[test]
fn located_impacts_have_the_same_bits() {
    same_bits("located", 12, || located(rain()));
}

#[test]
fn a_snapshot_goes_on_with_another_number_of_threads() {
    let model = || heap(&[ball(), cube()]);
    let mut first = World::new(model());
    let steps = |world: &mut World| {
        (0..30).for_each(|_| world.step(&mut NoOracle).expect("no step fails"));
    };
    steps(&mut first);
    let kept = first.save().expect("it can be written");
    steps(&mut first);
    let mut second = World::new(model());
    second.set_threads(2);
    second.restore(&kept).expect("it can be read");
    steps(&mut second);
    assert!(bits(&first) == bits(&second));
}
