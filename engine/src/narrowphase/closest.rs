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

/// Nearest surface of a solid, all in its frame. None for an exact mesh.
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
        Shape::Ellipsoid { radii } => Some(from_ellipsoid(*radii, p)),
        Shape::Mesh(_) => None,
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

/// The point x where p - x is along the surface's normal x_i / e_i^2, with semi-axes e: p_i = x_i (1 + t / e_i^2) for
/// some t above -e_min^2, and the x_i / e_i make a unit vector (Eberly, Distance from a Point to an Ellipse, an
/// Ellipsoid, or a Hyperellipsoid, 2013). In shares of the semi-axes, z_i = |p_i| / e_i and r_i = (e_i / e_min)^2, with
/// u = 1 + t / e_min^2 > 0,
///
/// ```text
/// sum of y_i^2 = 1,  y_i = r_i z_i / (u + r_i - 1).
/// ```
///
/// The left side falls and is convex: Newton's method from below, where one y_i alone is 1, stays below. A point on a
/// plane of symmetry is taken beside it by less than rounding, so that it knows to which side to leave.
fn from_ellipsoid(radii: DVec3, p: DVec3) -> Closest {
    const ROUNDS: usize = 128;
    const BESIDE: f64 = 1e-18;
    let z = (p.abs() / radii).max(DVec3::splat(BESIDE));
    let over = radii / radii.min_element();
    let r = over * over;
    let rest = r - DVec3::ONE;
    let mut u = (r * z - rest).max_element();
    let mut y = r * z / (u + rest);
    for _ in 0..ROUNDS {
        let fall = 2.0 * (y * y / (u + rest)).element_sum();
        let next = u + (y.length_squared() - 1.0) / fall;
        if next.is_nan() || next <= u * (1.0 + f64::EPSILON) {
            break;
        }
        u = next;
        y = r * z / (u + rest);
    }
    let side = DVec3::ONE.copysign(p);
    let normal = (side * y / radii).normalize_or_zero();
    Closest {
        normal,
        distance: normal.dot(p - side * y * radii),
    }
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

#[cfg(test)]
mod tests {
    use super::super::testing::Random;
    use super::*;

    /// The point found lies on the surface, with the normal that the surface has there, and no support plane is farther
    /// away outside, or nearer inside.
    #[test]
    fn points_around_and_in_ellipsoids() {
        let mut random = Random(61);
        for radii in [
            DVec3::new(0.5, 0.3, 0.2),
            DVec3::new(1.0, 1.0, 1e-3),
            DVec3::new(1e-3, 1.0, 1e-3),
            DVec3::splat(0.4),
            DVec3::new(0.4, 0.4, 0.4 + 1e-12),
        ] {
            let shape = Shape::Ellipsoid { radii };
            for k in 0..2000 {
                let mut p = 1.5 * radii * random.unit() * random.next();
                if k % 3 == 0 {
                    p[k % 2] = 0.0;
                }
                if k % 5 == 0 {
                    p[2] = 0.0;
                }
                let found = closest(&shape, p).unwrap();
                let (n, q) = (found.normal, p - found.distance * found.normal);
                assert!((n.length() - 1.0).abs() < 1e-14);
                let scale = radii.max_element();
                assert!(
                    shape.support(n).distance(q) < 1e-9 * scale,
                    "{radii} {p} {found:?}"
                );
                assert!(((q / radii).length() - 1.0).abs() < 1e-9, "{radii} {p}");
                let separation = |n: DVec3| n.dot(p - shape.support(n));
                for _ in 0..20 {
                    let other = separation((n + 0.3 * random.unit()).normalize());
                    assert!(
                        other <= separation(n) + 1e-15,
                        "{radii} {p} {other} {found:?}"
                    );
                    let other = separation(random.unit());
                    assert!(
                        other <= separation(n) + 1e-15,
                        "{radii} {p} {other} {found:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn the_middle_of_an_ellipsoid_leaves_along_its_shortest_axis() {
        for (radii, depth) in [(DVec3::new(3.0, 2.0, 1.0), 1.0), (DVec3::splat(2.0), 2.0)] {
            let found = closest(&Shape::Ellipsoid { radii }, DVec3::ZERO).unwrap();
            assert!((found.distance + depth).abs() < 1e-15);
        }
        let outside = closest(
            &Shape::Ellipsoid {
                radii: DVec3::new(3.0, 2.0, 1.0),
            },
            DVec3::new(0.0, 7.0, 0.0),
        );
        let outside = outside.unwrap();
        assert!(
            outside.normal.distance(DVec3::Y) < 1e-15 && (outside.distance - 5.0).abs() < 1e-15
        );
    }
}
