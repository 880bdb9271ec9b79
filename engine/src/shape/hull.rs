//! Convex polytopes: vertices, polygonal faces, edges with their two faces.

use glam::DVec3;
use std::collections::BTreeMap;

/// A vertex may stand above a face plane by this share of the hull's size (faces merged from nearly coplanar triangles).
const CONVEXITY_TOLERANCE: f64 = 1e-4;
/// Up to this many vertices a full search for the farthest is faster than a climb.
const SMALL: usize = 32;

/// A convex polygon of a hull; its corners are `Hull::corners(face)`.
#[derive(Clone, Copy, Debug)]
pub struct Face {
    /// Outward unit normal.
    pub normal: DVec3,
    /// Plane: normal . x = offset; no corner of the face lies above it.
    pub offset: f64,
    first: usize,
    end: usize,
}

impl Face {
    /// A plane without corners.
    pub(crate) fn plane(normal: DVec3, offset: f64) -> Self {
        Self {
            normal,
            offset,
            first: 0,
            end: 0,
        }
    }

    /// Height of a point above the plane [m].
    pub fn height(&self, p: DVec3) -> f64 {
        self.normal.dot(p) - self.offset
    }
}

/// An edge and the two faces that meet in it.
#[derive(Clone, Copy, Debug)]
pub struct Edge {
    /// Vertex indices, in the direction in which `faces[0]` runs.
    pub vertices: [u32; 2],
    /// Face indices.
    pub faces: [u32; 2],
}

/// A closed convex polytope.
#[derive(Clone, Debug)]
pub struct Hull {
    vertices: Vec<DVec3>,
    faces: Vec<Face>,
    corners: Vec<u32>,
    edges: Vec<Edge>,
    neighbours: Vec<u32>,
    neighbours_start: Vec<usize>,
    /// Vertices farthest along the axes: where the search for a support starts in a large hull.
    seeds: [usize; 6],
    center: DVec3,
    size: f64,
    bounding_radius: f64,
}

impl Hull {
    /// Builds the hull from vertices [m] and convex faces (vertex indices, counter-clockwise seen from outside).
    ///
    /// # Errors
    /// A sentence for the user when numbers are not finite, an index is out of range, a face is degenerate, the
    /// surface is not closed, or it is not convex (beyond 1e-4 of its size).
    pub fn new(vertices: Vec<DVec3>, faces: &[Vec<u32>]) -> Result<Self, String> {
        check_vertices(&vertices)?;
        check_indices(vertices.len(), faces)?;
        let center = vertices.iter().sum::<DVec3>() / vertices.len() as f64;
        let (planes, corners) = planes(&vertices, faces)?;
        let edges = edges(faces)?;
        let (neighbours_start, neighbours) =
            adjacency(vertices.len(), edges.iter().map(|e| e.vertices));
        let seeds = seeds(&vertices);
        let bounding_radius = vertices.iter().map(|v| v.length()).fold(0.0, f64::max);
        let squares = vertices.iter().map(|v| v.distance_squared(vertices[0]));
        let size = squares.fold(0.0, f64::max).sqrt();
        let hull = Self {
            vertices,
            faces: planes,
            corners,
            edges,
            neighbours,
            neighbours_start,
            seeds,
            center,
            size,
            bounding_radius,
        };
        hull.check_convex()?;
        Ok(hull)
    }

    /// Vertices in the geom's frame [m].
    pub fn vertices(&self) -> &[DVec3] {
        &self.vertices
    }

    /// Faces.
    pub fn faces(&self) -> &[Face] {
        &self.faces
    }

    /// Edges, each once.
    pub fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// Vertex indices of a face, counter-clockwise seen from outside.
    pub fn corners(&self, face: &Face) -> &[u32] {
        self.corners.get(face.first..face.end).unwrap_or(&[])
    }

    /// Vertices joined to this one by an edge.
    pub fn neighbours(&self, vertex: usize) -> &[u32] {
        row(&self.neighbours_start, &self.neighbours, vertex)
    }

    /// Mean of the vertices, a point inside [m].
    pub fn center(&self) -> DVec3 {
        self.center
    }

    /// Largest distance of a vertex from the first one [m].
    pub fn size(&self) -> f64 {
        self.size
    }

    /// Largest distance of a vertex from the geom's origin [m].
    pub fn bounding_radius(&self) -> f64 {
        self.bounding_radius
    }

    /// Vertex farthest along a direction.
    ///
    /// Large hulls are climbed from neighbour to neighbour: a vertex of a convex polytope that no neighbour tops is the
    /// farthest.
    pub fn support(&self, direction: DVec3) -> DVec3 {
        if self.vertices.len() <= SMALL {
            return farthest(&self.vertices, direction);
        }
        let height = |i: usize| self.vertices[i].dot(direction);
        let higher = |best: usize, i: usize| if height(i) > height(best) { i } else { best };
        let mut top = self.seeds.into_iter().reduce(higher).unwrap_or(0);
        loop {
            let next = self
                .neighbours(top)
                .iter()
                .map(|&i| i as usize)
                .fold(top, higher);
            if next == top {
                return self.vertices[top];
            }
            top = next;
        }
    }

    fn check_convex(&self) -> Result<(), String> {
        let size = self
            .vertices
            .iter()
            .map(|v| v.distance(self.center))
            .fold(0.0, f64::max);
        for (i, face) in self.faces.iter().enumerate() {
            let above = face.normal.dot(farthest(&self.vertices, face.normal)) - face.offset;
            if above > CONVEXITY_TOLERANCE * size {
                return Err(format!(
                    "not convex: a vertex stands {above:.3e} m outside face {i}"
                ));
            }
            if face.normal.dot(self.center) >= face.offset {
                return Err(format!("face {i} is inside out or the hull is flat"));
            }
        }
        Ok(())
    }
}

/// The point farthest along a direction, the first of equals; the origin for an empty list.
pub(crate) fn farthest(points: &[DVec3], direction: DVec3) -> DVec3 {
    let mut best = points.first().copied().unwrap_or(DVec3::ZERO);
    let mut height = best.dot(direction);
    for p in points {
        let h = p.dot(direction);
        if h > height {
            height = h;
            best = *p;
        }
    }
    best
}

fn seeds(vertices: &[DVec3]) -> [usize; 6] {
    let [x, y, z] = DVec3::AXES;
    [x, -x, y, -y, z, -z].map(|axis| {
        let top = farthest(vertices, axis);
        vertices.iter().position(|v| *v == top).unwrap_or(0)
    })
}

/// Row `index` of a compressed list of lists.
pub(crate) fn row<'a>(starts: &[usize], items: &'a [u32], index: usize) -> &'a [u32] {
    match (starts.get(index), starts.get(index + 1)) {
        (Some(&first), Some(&end)) => items.get(first..end).unwrap_or(&[]),
        _ => &[],
    }
}

/// Compressed list of neighbours per vertex; each pair is given once.
pub(crate) fn adjacency(
    count: usize,
    pairs: impl Iterator<Item = [u32; 2]>,
) -> (Vec<usize>, Vec<u32>) {
    let mut lists = vec![Vec::new(); count];
    for [i, j] in pairs {
        lists[i as usize].push(j);
        lists[j as usize].push(i);
    }
    let mut starts = vec![0];
    let mut items = Vec::new();
    for list in lists {
        items.extend(list);
        starts.push(items.len());
    }
    (starts, items)
}

/// Every coordinate must be finite, and indices must fit 32 bits.
pub(crate) fn check_vertices(vertices: &[DVec3]) -> Result<(), String> {
    if let Some(i) = vertices.iter().position(|v| !v.is_finite()) {
        return Err(format!("vertex {i} is not finite"));
    }
    if vertices.len() >= u32::MAX as usize {
        return Err("too many vertices".into());
    }
    Ok(())
}

fn check_indices(count: usize, faces: &[Vec<u32>]) -> Result<(), String> {
    if count < 4 || faces.len() < 4 {
        return Err(format!(
            "a hull needs at least 4 vertices and 4 faces, got {count} and {}",
            faces.len()
        ));
    }
    for (i, face) in faces.iter().enumerate() {
        if face.len() < 3 {
            return Err(format!("face {i} has {} corners", face.len()));
        }
        if face.iter().any(|&v| v as usize >= count) {
            return Err(format!("face {i} names a vertex that does not exist"));
        }
    }
    Ok(())
}

fn planes(vertices: &[DVec3], faces: &[Vec<u32>]) -> Result<(Vec<Face>, Vec<u32>), String> {
    let mut planes = Vec::with_capacity(faces.len());
    let mut corners = Vec::new();
    for (i, face) in faces.iter().enumerate() {
        let normal = newell(vertices, face);
        let normal = normal
            .try_normalize()
            .ok_or_else(|| format!("face {i} has no area"))?;
        let offset = face
            .iter()
            .map(|&v| normal.dot(vertices[v as usize]))
            .fold(f64::NEG_INFINITY, f64::max);
        let first = corners.len();
        corners.extend_from_slice(face);
        planes.push(Face {
            normal,
            offset,
            first,
            end: corners.len(),
        });
    }
    Ok((planes, corners))
}

/// Twice the area vector of a polygon, sum of (p_i - p_0) x (p_i+1 - p_0): robust for slightly bent polygons
/// (Newell's method; Sutherland, Sproull and Schumacker 1974).
fn newell(vertices: &[DVec3], face: &[u32]) -> DVec3 {
    let origin = vertices[face[0] as usize];
    face.windows(2)
        .map(|w| (vertices[w[0] as usize] - origin).cross(vertices[w[1] as usize] - origin))
        .sum()
}

fn edges(faces: &[Vec<u32>]) -> Result<Vec<Edge>, String> {
    let mut directed = BTreeMap::new();
    for (f, face) in faces.iter().enumerate() {
        for (k, &i) in face.iter().enumerate() {
            let j = face[(k + 1) % face.len()];
            if i == j || directed.insert((i, j), f as u32).is_some() {
                return Err(format!(
                    "edge {i}-{j} of face {f} occurs twice in the same direction"
                ));
            }
        }
    }
    let mut edges = Vec::with_capacity(directed.len() / 2);
    for (&(i, j), &face) in &directed {
        let Some(&twin) = directed.get(&(j, i)) else {
            return Err(format!("not closed: edge {i}-{j} has one face only"));
        };
        if i < j {
            edges.push(Edge {
                vertices: [i, j],
                faces: [face, twin],
            });
        }
    }
    Ok(edges)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tetrahedron() -> (Vec<DVec3>, Vec<Vec<u32>>) {
        let vertices = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        (
            vertices,
            vec![vec![0, 2, 1], vec![0, 1, 3], vec![0, 3, 2], vec![1, 2, 3]],
        )
    }

    #[test]
    fn topology_of_a_tetrahedron() {
        let (vertices, faces) = tetrahedron();
        let hull = Hull::new(vertices, &faces).unwrap();
        assert_eq!(
            (
                hull.vertices().len(),
                hull.edges().len(),
                hull.faces().len()
            ),
            (4, 6, 4)
        );
        assert!((0..4).all(|v| hull.neighbours(v).len() == 3));
        let slanted = &hull.faces()[3];
        assert!((slanted.normal - DVec3::ONE.normalize()).length() < 1e-15);
        assert!((slanted.offset - 1.0 / 3f64.sqrt()).abs() < 1e-15);
        assert_eq!(hull.support(DVec3::new(0.1, 0.2, 0.9)), DVec3::Z);
    }

    #[test]
    fn bad_input_is_refused_with_a_sentence() {
        let (vertices, faces) = tetrahedron();
        let broken =
            |vertices: Vec<DVec3>, faces: Vec<Vec<u32>>| Hull::new(vertices, &faces).unwrap_err();
        assert!(broken(vertices.clone(), faces[..3].to_vec()).contains("at least 4"));
        assert!(broken(vec![DVec3::NAN; 4], faces.clone()).contains("not finite"));
        let mut open = faces.clone();
        open[3] = vec![0, 1, 2];
        assert!(broken(vertices.clone(), open).contains("edge"));
        let inside_out = faces
            .iter()
            .map(|f| f.iter().rev().copied().collect())
            .collect();
        assert!(broken(vertices.clone(), inside_out).contains("not convex"));
        let mut out_of_range = faces;
        out_of_range[0][0] = 9;
        assert!(broken(vertices, out_of_range).contains("does not exist"));
    }
}
