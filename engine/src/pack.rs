//! Contacts four abreast: the sweeps over an island of many contacts, to the last bit as one by one.

use std::array::from_fn;

use glam::DVec3;
use pulp::{Simd, WithSimd};

use crate::cone::Cone;
use crate::conjugate::{Conjugate, Course};
use crate::islands::index;
use crate::lanes::{abreast, vectorised, Four, FourVectors, Lanes, Real, Vectors, WIDTH};
use crate::layout::{visit, Layer};
use crate::mover::{Mover, Part, Window};
use crate::point::Point;
use crate::schedule::{Bunch, Schedule};
use crate::team::{each_with, fill};
use crate::twists::{Motion, Twists};

/// Contacts that are worth being put into packs.
const MANY: usize = 32;
/// Contacts in a pack, on average, that are worth it.
const FULL: usize = 2;

/// The contacts of an island in packs, and working memory.
#[derive(Debug, Default)]
pub(crate) struct Packs {
    /// Parts as those of the island, with packs in the place of contacts. None where packs are not worth it.
    layers: Vec<Layer>,
    packs: Vec<Pack>,
    /// Which contacts are in them.
    schedule: Schedule,
    /// How the bodies move.
    motions: Vec<Motion>,
    /// Where sweeps came from.
    conjugate: Conjugate,
    /// Impulses and motions are here, those of contacts and bodies are of before.
    hold: bool,
}

impl Packs {
    /// No packs. Those that there were are written over by the next.
    pub(crate) fn clear(&mut self) {
        self.layers.clear();
    }

    /// Put the contacts of an island, with parts, into packs.
    pub(crate) fn arrange(&mut self, parts: &[Layer], points: &[Point], movers: &[Mover]) {
        self.clear();
        if points.len() < MANY {
            return;
        }
        self.schedule.begin(movers.len());
        self.part(parts, (points, 0), movers);
        let bunches = &self.schedule.bunches;
        if bunches.len() * FULL > points.len() {
            return self.layers.clear();
        }
        fill(&mut self.packs, (bunches.len(), Pack::default()), &|k| {
            Pack::of(&bunches[k], points, movers)
        });
    }

    /// Are packs worth it?
    pub(crate) fn are_used(&self) -> bool {
        !self.layers.is_empty()
    }

    /// One part, the first contact of which is the one `at` of all.
    fn part(&mut self, parts: &[Layer], (points, at): (&[Point], usize), movers: &[Mover]) {
        let (this, part) = (self.layers.len(), parts[0]);
        self.layers.push(part);
        let (a, b) = part.points;
        if part.second > 0 {
            let start = self.schedule.bunches.len();
            self.part(&parts[1..], (&points[..a], at), movers);
            let middle = self.schedule.bunches.len();
            self.part(&parts[part.second..], (&points[a..a + b], at + a), movers);
            let end = self.schedule.bunches.len();
            self.layers[this].points = (middle - start, end - middle);
        }
        self.schedule.part();
        for (slot, p) in (at + a + b..).zip(&points[a + b..]) {
            let bodies = [p.bodies.0, p.bodies.1].into_iter();
            let moved = bodies.filter(|&body| movers[body as usize].inverse_mass != 0.0);
            self.schedule.put(index(slot), moved);
        }
    }

    /// Impulses and friction from the contacts, motions from the bodies, where they are.
    fn load(&mut self, points: &[Point], movers: &[Mover]) {
        if std::mem::replace(&mut self.hold, true) {
            return;
        }
        self.conjugate.clear();
        fill(&mut self.motions, (movers.len(), Motion::default()), &|k| {
            Motion::of(&movers[k].twist)
        });
        let bunches = &self.schedule.bunches;
        each_with(&mut self.packs, bunches, &|pack, bunch| {
            for (lane, slot) in bunch.members() {
                let p = &points[slot];
                pack.cone.friction[lane] = p.cone.friction;
                for (k, impulse) in pack.impulse.iter_mut().enumerate() {
                    impulse[lane] = p.impulse[k];
                }
            }
        });
    }

    /// Impulses and motions, back to contacts and bodies.
    pub(crate) fn hand_back(&mut self, points: &mut [Point], movers: &mut [Mover]) {
        if !std::mem::replace(&mut self.hold, false) {
            return;
        }
        for (mover, motion) in movers.iter_mut().zip(&self.motions) {
            mover.twist = motion.twist();
        }
        for (pack, bunch) in self.packs.iter().zip(&self.schedule.bunches) {
            for (lane, slot) in bunch.members() {
                points[slot].impulse = pack.impulse.map(|p| p[lane]).into();
            }
        }
    }

    /// Before each pair of sweeps: carry on what those before were about (see `conjugate.rs`).
    pub(crate) fn carry_on(&mut self, points: &[Point], movers: &[Mover]) {
        self.load(points, movers);
        let conjugate = &mut self.conjugate;
        if conjugate.motions.is_empty() {
            let impulses = self.packs.iter().map(|pack| Course::of(pack.impulse));
            conjugate.impulses.extend(impulses);
            let motions = self.motions.iter().map(|motion| Course::of(motion.0));
            conjugate.motions.extend(motions);
        } else {
            vectorised(CarryOn(self));
        }
    }

    /// One sweep; returns the greatest change of a relative velocity [m/s]. Impulses and motions are then here until they
    /// are handed back.
    pub(crate) fn sweep(
        &mut self,
        (points, movers): (&[Point], &[Mover]),
        part: Part,
        backwards: bool,
    ) -> f64 {
        self.load(points, movers);
        let motions = Window::new(&mut self.motions);
        let (layers, packs) = (&self.layers, &mut self.packs);
        visit(layers, packs, motions, backwards, &|packs, motions| {
            vectorised(Sweep {
                packs,
                motions,
                part,
                backwards,
            })
        })
    }
}

/// Packs one after the other.
struct Sweep<'a, 'b> {
    packs: &'a mut [Pack],
    motions: &'a mut Window<'b, Motion>,
    part: Part,
    backwards: bool,
}

impl WithSimd for Sweep<'_, '_> {
    /// Greatest change of a relative velocity [m/s].
    type Output = f64;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> f64 {
        let mut worst = Lanes::load(simd, [0.0; WIDTH]);
        let count = self.packs.len();
        for k in 0..count {
            let place = if self.backwards { count - 1 - k } else { k };
            worst = worst.max(self.packs[place].solve(simd, self.motions, self.part));
        }
        worst.store().into_iter().fold(0.0, f64::max)
    }
}

/// Impulses and motions after a pair of sweeps carried on.
struct CarryOn<'a>(&'a mut Packs);

impl WithSimd for CarryOn<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Packs {
            packs,
            motions,
            conjugate,
            ..
        } = self.0;
        let mut square = Lanes::load(simd, [0.0; WIDTH]);
        for (course, pack) in conjugate.impulses.iter().zip(&*packs) {
            square = square + course.square(simd, &pack.impulse, &pack.cone.k);
        }
        let beta = conjugate.beta(square.store().iter().sum());
        for (course, pack) in conjugate.impulses.iter_mut().zip(packs) {
            course.carry_on(simd, &mut pack.impulse, beta);
        }
        for (course, motion) in conjugate.motions.iter_mut().zip(motions) {
            course.carry_on(simd, &mut motion.0, beta);
        }
    }
}

/// Four contacts, no two of which have a moving body in common. Lanes without a contact repeat the bodies of the first,
/// with nothing to do.
#[derive(Clone, Copy, Debug, Default)]
#[repr(align(64))]
struct Pack {
    sides: [Side; 2],
    axes: [FourVectors; 3],
    offset: FourVectors,
    cone: Cone<Four>,
    impulse: FourVectors,
}

/// What meets in these contacts, from one side.
#[derive(Clone, Copy, Debug, Default)]
struct Side {
    bodies: [u32; WIDTH],
    arms: FourVectors,
    inverse_mass: Four,
    /// It is symmetric: xx, yy, zz, yz, zx, xy.
    inverse_inertia: [Four; 6],
}

impl Pack {
    /// Of some contacts; impulses and friction are loaded later.
    fn of(bunch: &Bunch, points: &[Point], movers: &[Mover]) -> Self {
        let (held, points) = (bunch.held(), bunch.filled().map(|k| &points[k]));
        let side = |bodies, arms| Side::of(bodies, arms, movers);
        let mut cone = Cone {
            k: from_fn(|row| points.map(|p| p.cone.k[row])),
            inverse: from_fn(|row| points.map(|p| p.cone.inverse[row])),
            k_coupling: (
                points.map(|p| p.cone.k_coupling.0),
                points.map(|p| p.cone.k_coupling.1),
            ),
            give: points.map(|p| p.cone.give),
            friction: [0.0; WIDTH],
        };
        for row in &mut cone.inverse {
            *row = from_fn(|lane| if held[lane] { row[lane] } else { 0.0 });
        }
        Self {
            sides: [
                side(points.map(|p| p.bodies.0), points.map(|p| p.arms.0)),
                side(points.map(|p| p.bodies.1), points.map(|p| p.arms.1)),
            ],
            axes: from_fn(|axis| abreast(points.map(|p| p.axes[axis]))),
            offset: abreast(points.map(|p| p.offset)),
            cone,
            impulse: [[0.0; WIDTH]; 3],
        }
    }

    /// The exact answer of each contact, all others held; returns the changes of their velocities [m/s].
    #[inline(always)]
    fn solve<S: Simd>(&mut self, simd: S, motions: &mut Window<Motion>, part: Part) -> Lanes<S> {
        let number = |numbers| Lanes::load(simd, numbers);
        let [a, b] = &self.sides;
        let twists = [a, b].map(|side| Twists::load(simd, motions, side.bodies));
        let arms = [a.arms, b.arms].map(|arms| Vectors::load(simd, arms));
        let axes = self.axes.map(|axis| Vectors::load(simd, axis));
        let cone = self.cone.map(number);
        let (old, offset) = (self.impulse.map(number), self.offset.map(number));
        let u = twists[0].at(arms[0]) - twists[1].at(arms[1]);
        let u = from_fn(|k| u.dot(axes[k]) + offset[k]);
        let new = cone.answer(u, old, part);
        let change: [_; 3] = from_fn(|k| new[k] - old[k]);
        self.impulse = new.map(Lanes::store);
        let p = axes[0] * change[0] + axes[1] * change[1] + axes[2] * change[2];
        a.push(motions, twists[0], (p, arms[0].cross(p)));
        b.push(motions, twists[1], (-p, arms[1].cross(-p)));
        let speeds: [_; 3] = from_fn(|k| (change[k] * cone.k[k]).abs());
        speeds[0].max(speeds[1]).max(speeds[2])
    }
}

impl Side {
    fn of(bodies: [u32; WIDTH], arms: [DVec3; WIDTH], movers: &[Mover]) -> Self {
        let movers = bodies.map(|k| &movers[k as usize]);
        let [x, y, z] = [0, 1, 2].map(|k| abreast(movers.map(|m| m.inverse_inertia.col(k))));
        Self {
            bodies,
            arms: abreast(arms),
            inverse_mass: movers.map(|m| m.inverse_mass),
            inverse_inertia: [x[0], y[1], z[2], z[1], x[2], y[0]],
        }
    }

    /// The bodies, which move so, get these impulses and angular impulses.
    #[inline(always)]
    fn push<S: Simd>(
        &self,
        motions: &mut Window<Motion>,
        twists: Twists<S>,
        (p, q): (Vectors<S>, Vectors<S>),
    ) {
        let simd = p.simd();
        let inverse_mass = Lanes::load(simd, self.inverse_mass);
        let inverse_inertia = self.inverse_inertia.map(|row| Lanes::load(simd, row));
        let pushed = Twists {
            velocity: twists.velocity + p * inverse_mass,
            angular_velocity: twists.angular_velocity + q.transformed(inverse_inertia),
        };
        pushed.store(motions, self.bodies);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DMat3;
    use pulp::Scalar256b;

    use crate::contact::Contact;
    use crate::joint::testing::Numbers;
    use crate::math::tangents;
    use crate::model::Coefficients;
    use crate::mover::Twist;

    const BODIES: u32 = 60;

    fn below(n: &mut Numbers, count: u32) -> u32 {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let k = (0.5 * (n.next() + 1.0) * f64::from(count)) as u32;
        k.min(count - 1)
    }

    /// The last body is fixed.
    fn mover(n: &mut Numbers, k: u32) -> Mover {
        if k + 1 == BODIES {
            return Mover {
                twist: Twist::default(),
                inverse_mass: 0.0,
                inverse_inertia: DMat3::ZERO,
            };
        }
        let turned = DMat3::from_quat(n.rotation(1.0));
        let inertia = turned * DMat3::from_diagonal(n.vector().abs()) * turned.transpose();
        Mover {
            twist: Twist {
                velocity: n.vector(),
                angular_velocity: n.vector(),
            },
            inverse_mass: 1.0 + n.next().abs(),
            inverse_inertia: 0.5 * (inertia + inertia.transpose()),
        }
    }

    fn point(n: &mut Numbers) -> Point {
        let a = below(n, BODIES - 1);
        let b = (a + 1 + below(n, BODIES - 1)) % BODIES;
        let normal = n.vector().normalize();
        let (tangent_1, tangent_2) = tangents(normal);
        let k = n.vector().abs() + DVec3::ONE;
        let contact = Contact {
            normal,
            tangent_1,
            tangent_2,
            arms: (n.vector(), n.vector()),
            surface: 0.1 * n.vector(),
            k_normal: k.x,
            k_tangent: (k.y, k.z),
            k_coupling: (0.1 * n.next(), 0.1 * n.next()),
            coefficients: Coefficients {
                static_friction: 0.5 * n.next().abs(),
                ..Coefficients::default()
            },
            impulse: 0.1 * n.vector().abs(),
            ..Contact::default()
        };
        Point::of(&contact, (a, b), 0.0)
    }

    fn heap() -> (Vec<Point>, Vec<Mover>) {
        let mut n = Numbers(1);
        let points = (0..301).map(|_| point(&mut n)).collect();
        (points, (0..BODIES).map(|k| mover(&mut n, k)).collect())
    }

    fn one_by_one(points: &mut [Point], movers: &mut [Mover], part: Part, backwards: bool) -> f64 {
        let mut worst = 0.0_f64;
        let count = points.len();
        for k in 0..count {
            let p = &mut points[if backwards { count - 1 - k } else { k }];
            worst = worst.max(p.solve(movers, part));
        }
        worst
    }

    #[test]
    fn packs_do_what_contacts_do_one_by_one() {
        let (mut points, mut movers) = heap();
        let (mut packed, mut moved) = heap();
        let mut packs = Packs::default();
        packs.arrange(&[Layer::WHOLE], &packed, &moved);
        assert!(packs.are_used());
        for sweep in 0..12 {
            let (part, backwards) = ([Part::Normals, Part::All][sweep / 4 % 2], sweep % 2 == 1);
            let alone = one_by_one(&mut points, &mut movers, part, backwards);
            let abreast = packs.sweep((&packed, &moved), part, backwards);
            assert_eq!(abreast.to_bits(), alone.to_bits());
        }
        packs.hand_back(&mut packed, &mut moved);
        let impulses = |points: &[Point]| points.iter().map(|p| p.impulse).collect::<Vec<_>>();
        assert_eq!(impulses(&packed), impulses(&points));
        let twists = |movers: &[Mover]| movers.iter().map(|m| m.twist).collect::<Vec<_>>();
        assert_eq!(twists(&moved), twists(&movers));
    }

    /// Packs after so many sweeps, by turns forwards and backwards, and the last one's residual.
    fn swept(sweeps: usize, mut between: impl FnMut(&mut Packs)) -> (Packs, f64) {
        let (points, movers) = heap();
        let (mut packs, mut residual) = (Packs::default(), 0.0);
        packs.arrange(&[Layer::WHOLE], &points, &movers);
        packs.carry_on(&points, &movers);
        for sweep in 0..sweeps {
            if sweep > 0 && sweep % 2 == 0 {
                between(&mut packs);
            }
            residual = packs.sweep((&points, &movers), Part::All, sweep % 2 == 1);
        }
        (packs, residual)
    }

    #[test]
    fn sweeps_that_are_carried_on_converge_faster() {
        let (_, alone) = swept(40, |_| {});
        let (_, carried) = swept(40, |packs| vectorised(CarryOn(packs)));
        assert!(carried < 0.3 * alone, "{carried} {alone}");
    }

    #[test]
    fn what_is_carried_on_has_the_same_bits_without_vector_instructions() {
        let (with, _) = swept(9, |packs| vectorised(CarryOn(packs)));
        let (without, _) = swept(9, |packs| Scalar256b.vectorize(CarryOn(packs)));
        assert_eq!(with.motions, without.motions);
        for (a, b) in with.packs.iter().zip(&without.packs) {
            assert_eq!(a.impulse, b.impulse);
        }
    }

    #[test]
    fn without_vector_instructions_the_bits_are_the_same() {
        let (points, movers) = heap();
        let mut packs = Packs::default();
        packs.arrange(&[Layer::WHOLE], &points, &movers);
        packs.load(&points, &movers);
        let (mut others, mut moved) = (packs.packs.clone(), packs.motions.clone());
        fn sweep(packs: &mut [Pack], motions: &mut [Motion], vectors: bool) -> f64 {
            let sweep = Sweep {
                packs,
                motions: &mut Window::new(motions),
                part: Part::All,
                backwards: false,
            };
            if vectors {
                vectorised(sweep)
            } else {
                Scalar256b.vectorize(sweep)
            }
        }
        for _ in 0..4 {
            let with = sweep(&mut packs.packs, &mut packs.motions, true);
            let without = sweep(&mut others, &mut moved, false);
            assert_eq!(with.to_bits(), without.to_bits());
        }
        for (a, b) in packs.packs.iter().zip(&others) {
            assert_eq!(a.impulse, b.impulse);
        }
    }
}
