//! Box, hull, triangle and rod in one form for the separating-axis test.

use super::Posed;
use crate::shape::{Edge, Face, Pose, Shape};
use glam::DVec3;

/// Vertices, faces and edges in the shape's frame, and where that is.
///
/// Flat shapes have faces through their edges, at right angles to each other, so that every edge has arcs of normals of
/// 90 degrees: a triangle from its normal n over the edge's outward normal m to -n, a rod four around itself.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Polytope<'a> {
    pub vertices: &'a [DVec3],
    pub faces: &'a [Face],
    pub edges: &'a [Edge],
    /// A point inside.
    pub middle: DVec3,
    /// Largest distance from the first vertex [m].
    pub size: f64,
    pub pose: Pose,
}

/// Memory for shapes that do not keep their vertices.
#[derive(Default, Debug)]
pub(crate) struct Store {
    vertices: Vec<DVec3>,
    faces: Vec<Face>,
    edges: Vec<Edge>,
}

impl Store {
    /// The posed shape, a capsule by its axis; None for shapes that are not polytopes.
    pub fn polytope<'a>(&'a mut self, a: &Posed<'a>) -> Option<Polytope<'a>> {
        self.vertices.clear();
        self.faces.clear();
        self.edges.clear();
        match a.shape {
            Shape::Hull(hull) => {
                return Some(Polytope {
                    vertices: hull.vertices(),
                    faces: hull.faces(),
                    edges: hull.edges(),
                    middle: hull.center(),
                    size: hull.size(),
                    pose: a.pose,
                })
            }
            Shape::Box { half } => self.put_box(*half),
            Shape::Triangle(corners) => self.put_triangle(*corners),
            Shape::Rod { half_length } => self.put_rod(*half_length),
            Shape::Capsule { half_height, .. } => self.put_rod(*half_height),
            _ => return None,
        }
        let first = self.vertices[0];
        let squares = self.vertices.iter().map(|v| v.distance_squared(first));
        Some(Polytope {
            vertices: &self.vertices,
            faces: &self.faces,
            edges: &self.edges,
            middle: a.shape.center(),
            size: squares.fold(0.0, f64::max).sqrt(),
            pose: a.pose,
        })
    }

    /// Vertex k has the sign + along axis i where bit i of k is set; faces 2 i and 2 i + 1 look along + and - axis i.
    fn put_box(&mut self, half: DVec3) {
        let sign = |k: u32, axis: u32| if k >> axis & 1 == 0 { -1.0 } else { 1.0 };
        let vertex = |k| half * DVec3::new(sign(k, 0), sign(k, 1), sign(k, 2));
        self.vertices.extend((0..8).map(vertex));
        for (axis, reach) in DVec3::AXES.into_iter().zip(half.to_array()) {
            self.faces.push(Face::plane(axis, reach));
            self.faces.push(Face::plane(-axis, reach));
        }
        self.edges.extend(BOX_EDGES);
    }

    fn put_triangle(&mut self, corners: [DVec3; 3]) {
        self.vertices.extend(corners);
        let [a, b, c] = corners;
        let normal = (b - a).cross(c - a).normalize_or_zero();
        self.put_face(normal, a);
        self.put_face(-normal, a);
        for (k, (p, q)) in (0..).zip([(a, b), (b, c), (c, a)]) {
            self.put_face((q - p).normalize_or_zero().cross(normal), p);
            let ends = [k, (k + 1) % 3];
            self.edges.push(edge(ends, [0, 2 + k]));
            self.edges.push(edge(ends, [2 + k, 1]));
        }
    }

    fn put_rod(&mut self, half_length: f64) {
        let end = half_length * DVec3::Z;
        self.vertices.extend([end, -end]);
        for normal in [DVec3::X, DVec3::Y, DVec3::NEG_X, DVec3::NEG_Y] {
            self.put_face(normal, DVec3::ZERO);
        }
        let around = (0..4).map(|k| edge([0, 1], [k, (k + 1) % 4]));
        self.edges.extend(around);
    }

    fn put_face(&mut self, normal: DVec3, point: DVec3) {
        self.faces.push(Face::plane(normal, normal.dot(point)));
    }
}

const fn edge(vertices: [u32; 2], faces: [u32; 2]) -> Edge {
    Edge { vertices, faces }
}

/// Four along each axis.
const BOX_EDGES: [Edge; 12] = [
    edge([6, 7], [2, 4]),
    edge([2, 3], [2, 5]),
    edge([4, 5], [3, 4]),
    edge([0, 1], [3, 5]),
    edge([5, 7], [4, 0]),
    edge([4, 6], [4, 1]),
    edge([1, 3], [5, 0]),
    edge([0, 2], [5, 1]),
    edge([3, 7], [0, 2]),
    edge([1, 5], [0, 3]),
    edge([2, 6], [1, 2]),
    edge([0, 4], [1, 3]),
];

impl Polytope<'_> {
    /// The vertex lowest over another polytope's face, the first of equals, and its height; `place` is this polytope's
    /// in the other's frame.
    pub fn lowest_over(&self, face: &Face, place: &Pose) -> (usize, f64) {
        let up = place.inverse_direction(face.normal);
        let mut lowest = (0, f64::INFINITY);
        for (k, v) in self.vertices.iter().enumerate() {
            let height = up.dot(*v);
            if height < lowest.1 {
                lowest = (k, height);
            }
        }
        (lowest.0, lowest.1 + face.height(place.position))
    }

    /// The face over which a point is highest.
    pub fn facing(&self, p: DVec3) -> &Face {
        let mut best = (0, f64::NEG_INFINITY);
        for (k, face) in self.faces.iter().enumerate() {
            let height = face.height(p);
            if height > best.1 {
                best = (k, height);
            }
        }
        &self.faces[best.0]
    }

    /// The ends of an edge.
    pub fn ends(&self, edge: &Edge) -> [DVec3; 2] {
        edge.vertices.map(|i| self.vertices[i as usize])
    }
}
