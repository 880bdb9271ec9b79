//! Projection of a point onto a convex solid: nearest surface point, outward normal, signed distance.

use crate::shape::{Hull, Shape};
use glam::{DVec2, DVec3};

/// Below this share of the solid's size the direction to the nearest point is rounding, and a face's normal is taken.
const ROUNDING: f64 = 1e-10;

/// Where the surface is nearest to a point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Closest {
    /// Unit, out of the solid.
    pub normal: DVec3,
    /// Negative inside [m].
    pub distance: f64,
}

/// Nearest surface of a solid, all in its frame. None for shapes without a closed form (ellipsoid, exact mesh).
pub(crate) fn closest(shape: &Shape, p: DVec3) -> Option<Closest> {
    match shape {
        Shape::Sphere { radius } => Some(ball(p, *radius, DVec3::Z)),
        Shape::Capsule {
            radius,
            half_height,
        } => Some(ball(p - on_axis(p, *half_height), *radius, DVec3::X)),
        Shape::Rod { half_length } => Some(ball(p - on_axis(p, *half_length), 0.0, DVec3::X)),
        Shape::Box { half } => Some(from_box(*half, p)),
        Shape::Cylinder {
            radius,
            half_height,
        } => Some(from_cylinder(*radius, *half_height, p)),
        Shape::Cone { radius, height } => Some(from_cone(*radius, *height, p)),
        Shape::Hull(hull) => Some(from_hull(hull, p)),
        Shape::Triangle(corners) => Some(from_triangle(corners, p)),
        Shape::HalfSpace => Some(Closest {
            normal: DVec3::Z,
            distance: p.z,
        }),
        Shape::Ellipsoid { .. } | Shape::Mesh(_) => None,
    }
}

fn on_axis(p: DVec3, half: f64) -> DVec3 {
    DVec3::new(0.0, 0.0, p.z.max(-half).min(half))
}

/// From the centre of a ball; straight on it any normal is as good as `otherwise`.
fn ball(p: DVec3, radius: f64, otherwise: DVec3) -> Closest {
    Closest {
        normal: p.try_normalize().unwrap_or(otherwise),
        distance: p.length() - radius,
    }
}

/// Outside: clamp every coordinate (Ericson 2005, section 5.1.3). Inside: out through the nearest face.
fn from_box(half: DVec3, p: DVec3) -> Closest {
    let outside = p - p.max(-half).min(half);
    if let Some(normal) = outside.try_normalize() {
        return Closest {
            normal,
            distance: outside.length(),
        };
    }
    let depth = half - p.abs();
    let axis = depth.min_position();
    let mut normal = DVec3::ZERO;
    normal[axis] = 1f64.copysign(p[axis]);
    Closest {
        normal,
        distance: -depth[axis],
    }
}

/// In the half-plane (radial, z) the solid is a rectangle.
fn from_cylinder(radius: f64, half_height: f64, p: DVec3) -> Closest {
    let rho = (p.x * p.x + p.y * p.y).sqrt();
    let side = rho - radius;
    let cap = p.z.abs() - half_height;
    let profile = match (side > 0.0, cap > 0.0) {
        (true, true) => DVec2::new(side, cap),
        (true, false) => DVec2::X,
        (false, true) => DVec2::Y,
        (false, false) if side >= cap => DVec2::X,
        (false, false) => DVec2::Y,
    };
    let outside = DVec2::new(side.max(0.0), cap.max(0.0)).length();
    let distance = if outside > 0.0 {
        outside
    } else {
        side.max(cap)
    };
    let profile = profile.normalize_or_zero();
    Closest {
        normal: turned(DVec2::new(profile.x, profile.y.copysign(p.z)), p),
        distance,
    }
}

/// In the half-plane (radial, z) the solid is a triangle: axis, base, slanted side with outward normal
/// (H, R) / sqrt(H^2 + R^2).
fn from_cone(radius: f64, height: f64, p: DVec3) -> Closest {
    let point = DVec2::new((p.x * p.x + p.y * p.y).sqrt(), p.z);
    let apex = DVec2::new(0.0, 0.75 * height);
    let rim = DVec2::new(radius, -0.25 * height);
    let slant = DVec2::new(height, radius).normalize_or_zero();
    let side = slant.dot(point - apex);
    let base = rim.y - point.y;
    if side <= 0.0 && base <= 0.0 {
        let (normal, distance) = if side >= base {
            (slant, side)
        } else {
            (DVec2::NEG_Y, base)
        };
        return Closest {
            normal: turned(normal, p),
            distance,
        };
    }
    let on_side = point - on_segment_2d(point, apex, rim);
    let on_base = point - DVec2::new(point.x.min(radius), rim.y);
    let nearer = if on_side.length_squared() <= on_base.length_squared() {
        on_side
    } else {
        on_base
    };
    let face = if side >= base { slant } else { DVec2::NEG_Y };
    let (normal, distance) = outward(nearer.extend(0.0), face.extend(0.0), height + radius);
    Closest {
        normal: turned(normal.truncate(), p),
        distance,
    }
}

fn on_segment_2d(p: DVec2, a: DVec2, b: DVec2) -> DVec2 {
    let d = b - a;
    let t = (p - a).dot(d) / d.length_squared();
    a + d * t.clamp(0.0, 1.0)
}

/// From the half-plane (radial, z) back into space, towards the side on which p lies.
fn turned(profile: DVec2, p: DVec3) -> DVec3 {
    let radial = DVec3::new(p.x, p.y, 0.0)
        .try_normalize()
        .unwrap_or(DVec3::X);
    radial * profile.x + DVec3::new(0.0, 0.0, profile.y)
}

/// Direction and length of a vector out of the surface; the face's normal where the vector is only rounding.
fn outward(from_surface: DVec3, face: DVec3, size: f64) -> (DVec3, f64) {
    let distance = from_surface.length();
    if distance > ROUNDING * size {
        (from_surface / distance, distance)
    } else {
        (face, distance)
    }
}

/// Inside: out through the nearest face. Outside: nearest of the points of all faces that p can see.
fn from_hull(hull: &Hull, p: DVec3) -> Closest {
    let above = |f: &crate::shape::Face| f.normal.dot(p) - f.offset;
    let Some(highest) = hull
        .faces()
        .iter()
        .max_by(|f, g| above(f).total_cmp(&above(g)))
    else {
        return ball(p, 0.0, DVec3::Z);
    };
    if above(highest) <= 0.0 {
        return Closest {
            normal: highest.normal,
            distance: above(highest),
        };
    }
    let mut nearest = DVec3::INFINITY;
    let mut best = f64::INFINITY;
    for face in hull.faces() {
        let height = above(face);
        if height > 0.0 && height * height < best {
            let corner = |i: u32| {
                hull.vertices()
                    .get(i as usize)
                    .copied()
                    .unwrap_or(DVec3::ZERO)
            };
            let corners = hull.corners(face).iter().map(|&i| corner(i));
            let difference = from_polygon(corners, face.normal, height, p);
            if difference.length_squared() < best {
                best = difference.length_squared();
                nearest = difference;
            }
        }
    }
    let (normal, distance) = outward(nearest, highest.normal, hull.bounding_radius());
    Closest { normal, distance }
}

/// Vector from the nearest point of a convex polygon to p, which lies `height` above it: straight down inside all
/// edges, else to the nearest edge.
fn from_polygon(
    corners: impl Iterator<Item = DVec3> + Clone,
    normal: DVec3,
    height: f64,
    p: DVec3,
) -> DVec3 {
    let next = corners.clone().cycle().skip(1);
    let mut inside = true;
    let mut nearest = DVec3::INFINITY;
    for (a, b) in corners.zip(next) {
        inside &= normal.cross(b - a).dot(p - a) >= 0.0;
        let to_edge = p - on_segment(p, a, b);
        if to_edge.length_squared() < nearest.length_squared() {
            nearest = to_edge;
        }
    }
    if inside {
        normal * height
    } else {
        nearest
    }
}

/// Nearest point of a segment (Ericson 2005, section 5.1.2).
pub(crate) fn on_segment(p: DVec3, a: DVec3, b: DVec3) -> DVec3 {
    let d = b - a;
    let length = d.length_squared();
    if length <= 0.0 {
        return a;
    }
    a + d * ((p - a).dot(d) / length).clamp(0.0, 1.0)
}

/// Both sides of a triangle count as outside.
fn from_triangle(corners: &[DVec3; 3], p: DVec3) -> Closest {
    let [a, b, c] = *corners;
    let normal = (b - a).cross(c - a).normalize_or_zero();
    let height = normal.dot(p - a);
    let facing = if height < 0.0 { -normal } else { normal };
    let difference = from_polygon(corners.iter().copied(), normal, height, p);
    let (normal, distance) = outward(difference, facing, (b - a).length() + (c - a).length());
    Closest { normal, distance }
}
