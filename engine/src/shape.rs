//! What can collide: shapes in their own frame, poses, boxes around them.

mod hull;
mod triangle_mesh;

pub(crate) use hull::farthest;
pub use hull::{Edge, Face, Hull};
pub use triangle_mesh::{Feature as TriangleFeature, TriangleMesh};

use glam::{DMat3, DQuat, DVec3};
use std::sync::Arc;

/// A geom's shape in its own frame; lengths in metres.
#[derive(Clone, Debug)]
pub enum Shape {
    /// Solid ball about the origin.
    Sphere {
        /// Radius [m].
        radius: f64,
    },
    /// Cylinder along z with hemispherical ends.
    Capsule {
        /// Radius [m].
        radius: f64,
        /// Half the height of the cylindrical part [m].
        half_height: f64,
    },
    /// Box about the origin, axes along x, y, z.
    Box {
        /// Half extents [m].
        half: DVec3,
    },
    /// Cylinder along z about the origin.
    Cylinder {
        /// Radius [m].
        radius: f64,
        /// Half height [m].
        half_height: f64,
    },
    /// Cone along z, the origin at its centre of mass: base at -height/4, apex at +3 height/4.
    Cone {
        /// Radius of the base [m].
        radius: f64,
        /// Height [m].
        height: f64,
    },
    /// Ellipsoid about the origin, axes along x, y, z.
    Ellipsoid {
        /// Semi-axes [m].
        radii: DVec3,
    },
    /// Segment along z without thickness.
    Rod {
        /// Half length [m].
        half_length: f64,
    },
    /// Convex polytope.
    Hull(Arc<Hull>),
    /// Everything with z <= 0.
    HalfSpace,
    /// Closed surface of triangles, taken exactly; fixed bodies only.
    Mesh(Arc<TriangleMesh>),
    /// One triangle, counter-clockwise seen from outside (a piece of a mesh while FCL is asked about it).
    Triangle([DVec3; 3]),
}

/// Where a frame is: x_world = rotation x_local + position.
#[derive(Clone, Copy, Debug)]
pub struct Pose {
    /// Origin in world axes [m].
    pub position: DVec3,
    /// Columns are the local axes in world axes.
    pub rotation: DMat3,
}

/// A box with sides along the axes.
#[derive(Clone, Copy, Debug)]
pub struct Aabb {
    /// Lower corner [m].
    pub min: DVec3,
    /// Upper corner [m].
    pub max: DVec3,
}

impl Pose {
    /// World frame.
    pub const IDENTITY: Self = Self {
        position: DVec3::ZERO,
        rotation: DMat3::IDENTITY,
    };

    /// From a position and a unit quaternion (local to world).
    pub fn new(position: DVec3, orientation: DQuat) -> Self {
        Self {
            position,
            rotation: DMat3::from_quat(orientation),
        }
    }

    /// Local point to world.
    pub fn point(&self, local: DVec3) -> DVec3 {
        self.rotation * local + self.position
    }

    /// World point to local.
    pub fn inverse_point(&self, world: DVec3) -> DVec3 {
        self.inverse_direction(world - self.position)
    }

    /// Local direction to world.
    pub fn direction(&self, local: DVec3) -> DVec3 {
        self.rotation * local
    }

    /// World direction to local (the rotation's inverse is its transpose).
    pub fn inverse_direction(&self, world: DVec3) -> DVec3 {
        let r = &self.rotation;
        DVec3::new(
            r.x_axis.dot(world),
            r.y_axis.dot(world),
            r.z_axis.dot(world),
        )
    }

    /// Pose of a frame given relative to this one.
    pub fn compose(&self, inner: &Pose) -> Self {
        Self {
            position: self.point(inner.position),
            rotation: self.rotation * inner.rotation,
        }
    }

    /// Pose of `other` as seen from this frame.
    pub fn relative(&self, other: &Pose) -> Self {
        Self {
            position: self.inverse_point(other.position),
            rotation: self.rotation.transpose() * other.rotation,
        }
    }
}

impl Aabb {
    /// Contains nothing; grows by `include`.
    pub const EMPTY: Self = Self {
        min: DVec3::INFINITY,
        max: DVec3::NEG_INFINITY,
    };

    /// Box around points.
    pub fn of(points: impl IntoIterator<Item = DVec3>) -> Self {
        points.into_iter().fold(Self::EMPTY, Self::include)
    }

    /// This box, grown to contain a point.
    pub fn include(self, p: DVec3) -> Self {
        Self {
            min: self.min.min(p),
            max: self.max.max(p),
        }
    }

    /// Smallest box around both.
    pub fn union(self, other: Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    /// Larger by a margin on every side.
    pub fn expanded(self, margin: f64) -> Self {
        Self {
            min: self.min - DVec3::splat(margin),
            max: self.max + DVec3::splat(margin),
        }
    }

    /// Whether the boxes share a point (false with NaN).
    pub fn overlaps(&self, other: &Self) -> bool {
        self.min.cmple(other.max).all() && other.min.cmple(self.max).all()
    }

    /// Whether the other box lies within this one (false with NaN).
    pub fn contains(&self, other: &Self) -> bool {
        self.min.cmple(other.min).all() && other.max.cmple(self.max).all()
    }

    /// Middle of the box.
    pub fn center(&self) -> DVec3 {
        (self.min + self.max) * 0.5
    }

    /// Extents along the axes.
    pub fn extent(&self) -> DVec3 {
        self.max - self.min
    }
}

impl Shape {
    /// A point of the shape farthest along a direction (need not be unit), both in the geom's frame.
    ///
    /// Ericson, Real-Time Collision Detection (2005), section 3.3.
    pub fn support(&self, direction: DVec3) -> DVec3 {
        let d = direction;
        match self {
            Shape::Sphere { radius } => *radius * d.normalize_or_zero(),
            Shape::Capsule {
                radius,
                half_height,
            } => along_z(*half_height, d) + *radius * d.normalize_or_zero(),
            Shape::Box { half } => DVec3::new(
                signed(half.x, d.x),
                signed(half.y, d.y),
                signed(half.z, d.z),
            ),
            Shape::Cylinder {
                radius,
                half_height,
            } => along_z(*half_height, d) + rim(*radius, d),
            Shape::Cone { radius, height } => cone_support(*radius, *height, d),
            Shape::Ellipsoid { radii } => *radii * (*radii * d).normalize_or_zero(),
            Shape::Rod { half_length } => along_z(*half_length, d),
            Shape::Hull(hull) => hull.support(d),
            Shape::HalfSpace => halfspace_support(d),
            Shape::Mesh(mesh) => farthest(mesh.vertices(), d),
            Shape::Triangle(corners) => farthest(corners, d),
        }
    }

    /// How the support point of a unit direction moves when that turns, by its change at right angles to it; zero where it
    /// rests in a corner.
    ///
    /// An ellipsoid's support is p = E^2 d / |E d|, with E = diag(radii), hence dp = (E^2 - p p^T) dd / |E d|; a rim's,
    /// radius r, is r e with e along d's part in its plane, f, and dp = (1 - e e^T) r df / |f|.
    pub(crate) fn support_turn(&self, direction: DVec3, change: DVec3) -> DVec3 {
        let d = direction;
        let rim = |radius: f64| {
            let reach = (d.x * d.x + d.y * d.y).sqrt();
            if reach > 0.0 {
                let across = DVec3::new(-d.y, d.x, 0.0) / reach;
                radius / reach * across.dot(change) * across
            } else {
                DVec3::ZERO
            }
        };
        match self {
            Shape::Sphere { radius } | Shape::Capsule { radius, .. } => *radius * change,
            Shape::Cylinder { radius, .. } => rim(*radius),
            Shape::Cone { radius, height } if cone_support(*radius, *height, d).z < 0.0 => {
                rim(*radius)
            }
            Shape::Ellipsoid { radii } => {
                let reach = (*radii * d).length();
                let p = *radii * *radii * d / reach;
                (*radii * *radii * change - p * p.dot(change)) / reach
            }
            _ => DVec3::ZERO,
        }
    }

    /// Smallest box with sides along the world axes around the posed shape.
    pub fn aabb(&self, pose: &Pose) -> Aabb {
        let rows = pose.rotation.transpose();
        let reach = |axis: DVec3| axis.dot(self.support(axis));
        let up = DVec3::new(reach(rows.x_axis), reach(rows.y_axis), reach(rows.z_axis));
        let down = if self.is_centrally_symmetric() {
            up
        } else {
            DVec3::new(
                reach(-rows.x_axis),
                reach(-rows.y_axis),
                reach(-rows.z_axis),
            )
        };
        Aabb {
            min: pose.position - down,
            max: pose.position + up,
        }
    }

    /// Largest distance of a point from the geom's origin [m]; infinite for a half-space.
    pub fn bounding_radius(&self) -> f64 {
        match self {
            Shape::Sphere { radius } => *radius,
            Shape::Capsule {
                radius,
                half_height,
            } => radius + half_height,
            Shape::Box { half } => half.length(),
            Shape::Cylinder {
                radius,
                half_height,
            } => (radius * radius + half_height * half_height).sqrt(),
            Shape::Cone { radius, height } => {
                (0.75 * height).max((radius * radius + height * height / 16.0).sqrt())
            }
            Shape::Ellipsoid { radii } => radii.max_element(),
            Shape::Rod { half_length } => *half_length,
            Shape::Hull(hull) => hull.bounding_radius(),
            Shape::HalfSpace => f64::INFINITY,
            Shape::Mesh(mesh) => mesh.bounding_radius(),
            Shape::Triangle(corners) => corners.iter().map(|c| c.length()).fold(0.0, f64::max),
        }
    }

    /// Whether the shape is convex: all but exact meshes.
    pub fn is_convex(&self) -> bool {
        !matches!(self, Shape::Mesh(_))
    }

    /// A ball: it touches with another point whichever way it turns.
    pub fn is_round(&self) -> bool {
        matches!(self, Shape::Sphere { .. })
    }

    /// A point inside the shape, in the geom's frame.
    pub fn center(&self) -> DVec3 {
        match self {
            Shape::Hull(hull) => hull.center(),
            Shape::Triangle([a, b, c]) => (*a + *b + *c) / 3.0,
            _ => DVec3::ZERO,
        }
    }

    fn is_centrally_symmetric(&self) -> bool {
        !matches!(
            self,
            Shape::Cone { .. }
                | Shape::Hull(_)
                | Shape::HalfSpace
                | Shape::Mesh(_)
                | Shape::Triangle(_)
        )
    }
}

fn signed(length: f64, along: f64) -> f64 {
    if along < 0.0 {
        -length
    } else {
        length
    }
}

fn along_z(half: f64, d: DVec3) -> DVec3 {
    DVec3::new(0.0, 0.0, signed(half, d.z))
}

/// Farthest point of a circle in the xy plane; its centre for a direction along z.
fn rim(radius: f64, d: DVec3) -> DVec3 {
    radius * DVec3::new(d.x, d.y, 0.0).normalize_or_zero()
}

/// The farther of apex and base rim.
fn cone_support(radius: f64, height: f64, d: DVec3) -> DVec3 {
    let apex = DVec3::new(0.0, 0.0, 0.75 * height);
    let base = DVec3::new(0.0, 0.0, -0.25 * height) + rim(radius, d);
    if apex.dot(d) >= base.dot(d) {
        apex
    } else {
        base
    }
}

/// Infinitely far in every direction but straight out.
fn halfspace_support(d: DVec3) -> DVec3 {
    let far = |x: f64| {
        if x == 0.0 {
            0.0
        } else {
            f64::INFINITY.copysign(x)
        }
    };
    DVec3::new(far(d.x), far(d.y), if d.z > 0.0 { 0.0 } else { far(d.z) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn supports_reach_the_closed_form_distance() {
        let d = DVec3::new(0.6, 0.0, -0.8);
        let reach = |shape: Shape| d.dot(shape.support(d));
        assert_eq!(reach(Shape::Sphere { radius: 2.0 }), 2.0);
        assert!(
            (reach(Shape::Capsule {
                radius: 0.5,
                half_height: 1.0
            }) - 1.3)
                .abs()
                < 1e-15
        );
        assert!(
            (reach(Shape::Box {
                half: DVec3::new(1.0, 2.0, 3.0)
            }) - 3.0)
                .abs()
                < 1e-15
        );
        assert!(
            (reach(Shape::Cylinder {
                radius: 1.0,
                half_height: 2.0
            }) - 2.2)
                .abs()
                < 1e-15
        );
        assert!(
            (reach(Shape::Cone {
                radius: 1.0,
                height: 4.0
            }) - 1.4)
                .abs()
                < 1e-15
        );
        // |R d| for the ellipsoid.
        let expected = (1.2f64 * 1.2 + 2.4 * 2.4).sqrt();
        assert!(
            (reach(Shape::Ellipsoid {
                radii: DVec3::new(2.0, 1.0, 3.0)
            }) - expected)
                .abs()
                < 1e-15
        );
        assert!((reach(Shape::Rod { half_length: 1.0 }) - 0.8).abs() < 1e-15);
    }

    #[test]
    fn box_around_a_turned_box_and_a_half_space() {
        let quarter = DMat3::from_cols(DVec3::Y, DVec3::NEG_X, DVec3::Z);
        let pose = Pose {
            position: DVec3::new(1.0, 1.0, 1.0),
            rotation: quarter,
        };
        let aabb = Shape::Box {
            half: DVec3::new(1.0, 2.0, 3.0),
        }
        .aabb(&pose);
        assert_eq!(
            (aabb.min, aabb.max),
            (DVec3::new(-1.0, 0.0, -2.0), DVec3::new(3.0, 2.0, 4.0))
        );
        let ground = Shape::HalfSpace.aabb(&Pose::IDENTITY);
        assert_eq!(ground.max, DVec3::new(f64::INFINITY, f64::INFINITY, 0.0));
        assert_eq!(ground.min, DVec3::NEG_INFINITY);
    }

    #[test]
    fn relative_pose_undoes_composition() {
        let a = Pose::new(
            DVec3::new(1.0, 2.0, 3.0),
            DQuat::from_xyzw(0.5, 0.5, 0.5, 0.5),
        );
        let b = Pose::new(
            DVec3::new(-1.0, 0.5, 2.0),
            DQuat::from_xyzw(0.6, 0.0, 0.0, 0.8),
        );
        let back = a.compose(&a.relative(&b));
        assert!((back.position - b.position).length() < 1e-15);
        assert!((back.rotation.x_axis - b.rotation.x_axis).length() < 1e-15);
    }
}
