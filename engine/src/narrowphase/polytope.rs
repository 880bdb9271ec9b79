//! Box, hull, triangle and rod in one form for the separating-axis test, in world axes.

use super::Posed;
use crate::shape::{Hull, Pose, Shape};
use glam::DVec3;

/// A supporting plane: no point of the polytope has normal . x > offset, and some point has equality.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane {
    pub normal: DVec3,
    pub offset: f64,
}

/// An edge with the arc of normals (at most 90 to 180 degrees, between two faces) in which it supports the polytope.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Arc {
    /// Ends of the edge.
    pub ends: [DVec3; 2],
    /// Unit vector along the edge, on the side of normals[1] x normals[0].
    pub along: DVec3,
    /// Ends of the arc.
    pub normals: [DVec3; 2],
}

/// Vertices, planes and edges.
#[derive(Default, Debug)]
pub(crate) struct Polytope {
    pub vertices: Vec<DVec3>,
    pub planes: Vec<Plane>,
    pub arcs: Vec<Arc>,
    /// Largest distance from the first vertex [m].
    pub size: f64,
}

impl Polytope {
    /// Becomes the posed shape; false for shapes that are not polytopes.
    ///
    /// Flat shapes get planes through their edges, at right angles to each other, so that every edge has arcs of 90
    /// degrees: a triangle from its normal n over the edge's outward normal m to -n, a rod four around itself.
    pub fn load(&mut self, a: &Posed) -> bool {
        self.clear();
        match a.shape {
            Shape::Box { half } => self.load_box(*half, &a.pose),
            Shape::Hull(hull) => self.load_hull(hull, &a.pose),
            Shape::Triangle(corners) => self.load_triangle(corners.map(|c| a.pose.point(c))),
            Shape::Rod { half_length }
            | Shape::Capsule {
                half_height: half_length,
                ..
            } => {
                self.load_rod(*half_length, &a.pose);
            }
            _ => return false,
        }
        let first = self.vertices.first().copied().unwrap_or(DVec3::ZERO);
        self.size = self
            .vertices
            .iter()
            .map(|v| v.distance(first))
            .fold(0.0, f64::max);
        true
    }

    /// Height of the vertex farthest along a direction.
    pub fn reach(&self, direction: DVec3) -> f64 {
        self.vertices
            .iter()
            .map(|v| v.dot(direction))
            .fold(f64::NEG_INFINITY, f64::max)
    }

    fn clear(&mut self) {
        self.vertices.clear();
        self.planes.clear();
        self.arcs.clear();
    }

    fn add_plane(&mut self, normal: DVec3, point: DVec3) {
        self.planes.push(Plane {
            normal,
            offset: normal.dot(point),
        });
    }

    fn add_arc(&mut self, ends: [DVec3; 2], along: DVec3, from: DVec3, to: DVec3) {
        let along = if to.cross(from).dot(along) < 0.0 {
            -along
        } else {
            along
        };
        self.arcs.push(Arc {
            ends,
            along,
            normals: [from, to],
        });
    }

    fn load_box(&mut self, half: DVec3, pose: &Pose) {
        let axes = [
            pose.rotation.x_axis,
            pose.rotation.y_axis,
            pose.rotation.z_axis,
        ];
        let arms = [axes[0] * half.x, axes[1] * half.y, axes[2] * half.z];
        for signs in 0..8 {
            let sign = |k: usize| if signs >> k & 1 == 0 { -1.0 } else { 1.0 };
            self.vertices
                .push(pose.position + sign(0) * arms[0] + sign(1) * arms[1] + sign(2) * arms[2]);
        }
        for (k, axis) in axes.into_iter().enumerate() {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            for (si, sj) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
                let middle = pose.position + si * arms[i] + sj * arms[j];
                self.add_arc(
                    [middle - arms[k], middle + arms[k]],
                    axis,
                    si * axes[i],
                    sj * axes[j],
                );
            }
            self.add_plane(axis, pose.position + arms[k]);
            self.add_plane(-axis, pose.position - arms[k]);
        }
    }

    fn load_hull(&mut self, hull: &Hull, pose: &Pose) {
        self.vertices
            .extend(hull.vertices().iter().map(|v| pose.point(*v)));
        for face in hull.faces() {
            let normal = pose.direction(face.normal);
            self.planes.push(Plane {
                normal,
                offset: face.offset + normal.dot(pose.position),
            });
        }
        for edge in hull.edges() {
            let [p, q] = edge.vertices.map(|i| self.vertices[i as usize]);
            let [f, g] = edge.faces.map(|i| self.planes[i as usize].normal);
            self.add_arc([p, q], (q - p).normalize_or_zero(), f, g);
        }
    }

    fn load_triangle(&mut self, corners: [DVec3; 3]) {
        self.vertices.extend(corners);
        let [a, b, c] = corners;
        let normal = (b - a).cross(c - a).normalize_or_zero();
        self.add_plane(normal, a);
        self.add_plane(-normal, a);
        for (p, q) in [(a, b), (b, c), (c, a)] {
            let along = (q - p).normalize_or_zero();
            let outward = along.cross(normal);
            self.add_plane(outward, p);
            self.add_arc([p, q], along, normal, outward);
            self.add_arc([p, q], along, outward, -normal);
        }
    }

    fn load_rod(&mut self, half_length: f64, pose: &Pose) {
        let (x, y, z) = (
            pose.rotation.x_axis,
            pose.rotation.y_axis,
            pose.rotation.z_axis,
        );
        let ends = [
            pose.position + half_length * z,
            pose.position - half_length * z,
        ];
        self.vertices.extend(ends);
        for (from, to) in [(x, y), (y, -x), (-x, -y), (-y, x)] {
            self.add_plane(from, pose.position);
            self.add_arc(ends, z, from, to);
        }
    }
}
