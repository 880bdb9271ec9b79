//! What is measured of the engine: pairs of shapes through the narrow phase, and whole steps of small worlds, each
//! prepared once and then run as often as one likes.

mod pairs;
mod worlds;

/// A name, and what makes it ready to run.
pub type Kernel = (&'static str, fn() -> Box<dyn FnMut()>);

/// All of them.
pub fn all() -> Vec<Kernel> {
    [pairs::ALL, worlds::ALL].concat()
}

/// The one of this name, ready to run.
pub fn ready(name: &str) -> Option<Box<dyn FnMut()>> {
    let (_, make) = all().into_iter().find(|(known, _)| *known == name)?;
    Some(make())
}

/// Linear congruential generator (Knuth's MMIX constants), the same numbers everywhere.
pub struct Random(pub u64);

impl Random {
    /// Uniform in [-1, 1).
    #[allow(clippy::cast_precision_loss)]
    pub fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// A point in the cube of half width 1.
    pub fn point(&mut self) -> glam::DVec3 {
        glam::DVec3::new(self.next(), self.next(), self.next())
    }

    /// Turned anyhow.
    pub fn rotation(&mut self) -> glam::DQuat {
        let [x, y, z, w] = [self.next(), self.next(), self.next(), self.next()];
        glam::DQuat::from_xyzw(x, y, z, w).normalize()
    }
}
