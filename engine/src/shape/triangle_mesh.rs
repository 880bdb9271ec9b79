//! Closed surfaces of triangles with a tree of boxes over them.

use super::hull::{adjacency, check_vertices, row};
use super::Aabb;
use glam::DVec3;
use std::collections::{BTreeMap, BTreeSet};

/// Triangles in a leaf of the tree.
const LEAF: usize = 4;
/// Deep enough for 2^60 triangles: the tree halves its list at every level.
const STACK: usize = 64;
/// Sine of the angle by which a neighbour may rise above a supporting plane and still count as below it.
const SUPPORT_TOLERANCE: f64 = 1e-6;

/// Part of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Feature {
    /// The whole face.
    Face,
    /// The edge from corner i to corner i + 1.
    Edge(usize),
    /// Corner i.
    Corner(usize),
}

#[derive(Clone, Debug)]
struct Node {
    aabb: Aabb,
    /// First child for an inner node (the second follows it), first entry of `order` for a leaf.
    first: u32,
    /// Triangles of a leaf; 0 for an inner node.
    count: u32,
}

/// A surface of triangles, counter-clockwise seen from outside.
#[derive(Clone, Debug)]
pub struct TriangleMesh {
    vertices: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    normals: Vec<DVec3>,
    /// Far corner of the triangle across each edge; None at a border.
    opposite: Vec<[Option<u32>; 3]>,
    convex: Vec<bool>,
    neighbours: Vec<u32>,
    neighbours_start: Vec<usize>,
    /// Equal positions have one name here, so that unmerged files know their neighbours too.
    canonical: Vec<u32>,
    nodes: Vec<Node>,
    order: Vec<u32>,
    bounding_radius: f64,
}

impl TriangleMesh {
    /// Builds the surface from vertices [m] and vertex indices.
    ///
    /// Triangles without area keep their number but never collide.
    ///
    /// # Errors
    /// A sentence for the user when there is no triangle, a number is not finite or an index is out of range.
    pub fn new(vertices: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Result<Self, String> {
        check_vertices(&vertices)?;
        check_triangles(vertices.len(), &triangles)?;
        let canonical = canonical(&vertices);
        let normals: Vec<DVec3> = triangles
            .iter()
            .map(|t| normal(&corners(&vertices, t)))
            .collect();
        if normals.iter().all(|n| *n == DVec3::ZERO) {
            return Err("no triangle has an area".into());
        }
        let opposite = opposite(&canonical, &triangles);
        let convex = convex(&vertices, &triangles, &normals, &opposite);
        let pairs = edge_set(&canonical, &triangles);
        let (neighbours_start, neighbours) = adjacency(vertices.len(), pairs.into_iter());
        let bounding_radius = vertices.iter().map(|v| v.length()).fold(0.0, f64::max);
        let (nodes, order) = build_tree(&vertices, &triangles, &normals);
        Ok(Self {
            vertices,
            triangles,
            normals,
            opposite,
            convex,
            neighbours,
            neighbours_start,
            canonical,
            nodes,
            order,
            bounding_radius,
        })
    }

    /// Vertices in the geom's frame [m].
    pub fn vertices(&self) -> &[DVec3] {
        &self.vertices
    }

    /// Number of triangles.
    pub fn len(&self) -> usize {
        self.triangles.len()
    }

    /// Whether there is no triangle (never, once built).
    pub fn is_empty(&self) -> bool {
        self.triangles.is_empty()
    }

    /// Corners of a triangle [m]; all at the origin for a number out of range.
    pub fn corners(&self, triangle: u32) -> [DVec3; 3] {
        self.triangles
            .get(triangle as usize)
            .map_or([DVec3::ZERO; 3], |t| corners(&self.vertices, t))
    }

    /// Outward unit normal of a triangle; zero when it has no area.
    pub fn normal(&self, triangle: u32) -> DVec3 {
        self.normals
            .get(triangle as usize)
            .copied()
            .unwrap_or(DVec3::ZERO)
    }

    /// Largest distance of a vertex from the geom's origin [m].
    pub fn bounding_radius(&self) -> f64 {
        self.bounding_radius
    }

    /// Appends the triangles (with an area) whose boxes reach into a box in the mesh's frame.
    pub fn overlapping(&self, aabb: &Aabb, out: &mut Vec<u32>) {
        let mut stack = [0u32; STACK];
        let mut height = 1;
        while height > 0 {
            height -= 1;
            let Some(node) = self.nodes.get(stack[height] as usize) else {
                continue;
            };
            if !node.aabb.overlaps(aabb) {
                continue;
            }
            if node.count > 0 {
                self.leaf_overlapping(node, aabb, out);
            } else if height + 2 <= STACK {
                stack[height] = node.first + 1;
                stack[height + 1] = node.first;
                height += 2;
            }
        }
    }

    fn leaf_overlapping(&self, node: &Node, aabb: &Aabb, out: &mut Vec<u32>) {
        let first = node.first as usize;
        let leaf = self
            .order
            .get(first..first + node.count as usize)
            .unwrap_or(&[]);
        out.extend(
            leaf.iter()
                .filter(|&&t| Aabb::of(self.corners(t)).overlaps(aabb)),
        );
    }

    /// Whether the surface bends down, or ends, at an edge of the triangle.
    pub fn has_convex_edge(&self, triangle: u32) -> bool {
        self.convex.get(triangle as usize).copied().unwrap_or(true)
    }

    /// Whether a plane with this normal, laid on the feature, leaves the surface around it below: only then can a
    /// convex body touch the surface there with this normal. Inner edges of flat or concave regions fail.
    pub fn is_supporting(&self, triangle: u32, feature: Feature, normal: DVec3) -> bool {
        let (Some(index), Some(far)) = (
            self.triangles.get(triangle as usize),
            self.opposite.get(triangle as usize),
        ) else {
            return false;
        };
        let corner = |i: u32| {
            self.vertices
                .get(i as usize)
                .copied()
                .unwrap_or(DVec3::ZERO)
        };
        let below =
            |from: DVec3, to: DVec3| normal.dot(to - from) <= SUPPORT_TOLERANCE * to.distance(from);
        match feature {
            Feature::Face => normal.dot(self.normal(triangle)) > 0.0,
            Feature::Edge(i) => far[i % 3].is_none_or(|f| below(corner(index[i % 3]), corner(f))),
            Feature::Corner(i) => {
                let center = self.canonical[index[i % 3] as usize];
                let around = row(&self.neighbours_start, &self.neighbours, center as usize);
                around
                    .iter()
                    .all(|&other| below(corner(center), corner(other)))
            }
        }
    }
}

fn check_triangles(count: usize, triangles: &[[u32; 3]]) -> Result<(), String> {
    if triangles.is_empty() {
        return Err("a mesh needs at least one triangle".into());
    }
    if triangles.len() >= u32::MAX as usize / 2 {
        return Err("too many triangles".into());
    }
    match triangles
        .iter()
        .position(|t| t.iter().any(|&v| v as usize >= count))
    {
        Some(i) => Err(format!("triangle {i} names a vertex that does not exist")),
        None => Ok(()),
    }
}

fn corners(vertices: &[DVec3], triangle: &[u32; 3]) -> [DVec3; 3] {
    triangle.map(|i| vertices[i as usize])
}

fn normal([a, b, c]: &[DVec3; 3]) -> DVec3 {
    (*b - *a).cross(*c - *a).normalize_or_zero()
}

/// First vertex with the same coordinates, for every vertex.
fn canonical(vertices: &[DVec3]) -> Vec<u32> {
    let mut first = BTreeMap::new();
    let key = |v: &DVec3| (*v + DVec3::ZERO).to_array().map(f64::to_bits); // + 0 turns -0 into 0
    vertices
        .iter()
        .enumerate()
        .map(|(i, v)| *first.entry(key(v)).or_insert(i as u32))
        .collect()
}

fn directed_edges(canonical: &[u32], triangle: &[u32; 3]) -> [(u32, u32); 3] {
    let [a, b, c] = triangle.map(|i| canonical[i as usize]);
    [(a, b), (b, c), (c, a)]
}

fn edge_set(canonical: &[u32], triangles: &[[u32; 3]]) -> BTreeSet<[u32; 2]> {
    let edges = triangles.iter().flat_map(|t| directed_edges(canonical, t));
    edges
        .filter(|(i, j)| i != j)
        .map(|(i, j)| [i.min(j), i.max(j)])
        .collect()
}

fn opposite(canonical: &[u32], triangles: &[[u32; 3]]) -> Vec<[Option<u32>; 3]> {
    let mut far = BTreeMap::new();
    for t in triangles {
        for (k, edge) in directed_edges(canonical, t).into_iter().enumerate() {
            far.insert(edge, t[(k + 2) % 3]);
        }
    }
    triangles
        .iter()
        .map(|t| directed_edges(canonical, t).map(|(i, j)| far.get(&(j, i)).copied()))
        .collect()
}

fn convex(
    vertices: &[DVec3],
    triangles: &[[u32; 3]],
    normals: &[DVec3],
    opposite: &[[Option<u32>; 3]],
) -> Vec<bool> {
    let bends = |t: usize, corner: u32, far: Option<u32>| {
        let Some(far) = far else { return true };
        let d = vertices[far as usize] - vertices[corner as usize];
        normals[t].dot(d) < -SUPPORT_TOLERANCE * d.length()
    };
    let any = |t: usize| (0..3).any(|k| bends(t, triangles[t][k], opposite[t][k]));
    (0..triangles.len()).map(any).collect()
}

/// Tree of boxes, halved at the median centre along the longest side (Ericson 2005, section 6.2).
fn build_tree(
    vertices: &[DVec3],
    triangles: &[[u32; 3]],
    normals: &[DVec3],
) -> (Vec<Node>, Vec<u32>) {
    let boxes: Vec<Aabb> = triangles
        .iter()
        .map(|t| Aabb::of(corners(vertices, t)))
        .collect();
    let mut order: Vec<u32> = (0..triangles.len() as u32)
        .filter(|&t| normals[t as usize] != DVec3::ZERO)
        .collect();
    let mut nodes = vec![Node {
        aabb: Aabb::EMPTY,
        first: 0,
        count: 0,
    }];
    let mut open = vec![(0usize, 0usize, order.len())];
    while let Some((node, first, end)) = open.pop() {
        let part = &mut order[first..end];
        let aabb = part
            .iter()
            .fold(Aabb::EMPTY, |sum, &t| sum.union(boxes[t as usize]));
        if part.len() <= LEAF {
            nodes[node] = Node {
                aabb,
                first: first as u32,
                count: part.len() as u32,
            };
            continue;
        }
        let middle = split(part, &boxes);
        let child = nodes.len();
        nodes[node] = Node {
            aabb,
            first: child as u32,
            count: 0,
        };
        nodes.extend([
            Node {
                aabb,
                first: 0,
                count: 0,
            },
            Node {
                aabb,
                first: 0,
                count: 0,
            },
        ]);
        open.push((child, first, first + middle));
        open.push((child + 1, first + middle, end));
    }
    (nodes, order)
}

/// Brings the half with the smaller centres to the front; the number breaks ties.
fn split(part: &mut [u32], boxes: &[Aabb]) -> usize {
    let extent = Aabb::of(part.iter().map(|&t| boxes[t as usize].center())).extent();
    let axis = extent.max_position();
    let middle = part.len() / 2;
    part.select_nth_unstable_by(middle, |&i, &j| {
        let key = |t: u32| boxes[t as usize].center()[axis];
        key(i).total_cmp(&key(j)).then(i.cmp(&j))
    });
    middle
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A 10 x 10 grid of squares with a ridge along x = 5 (height 1) and flat valleys beside it.
    fn ridge() -> TriangleMesh {
        let height = |x: f64| 1.0 - (x - 5.0).abs().min(1.0);
        let vertices = (0..121).map(|k| {
            let (x, y) = ((k % 11) as f64, (k / 11) as f64);
            DVec3::new(x, y, height(x))
        });
        let squares = (0..100u32).map(|k| k % 10 + k / 10 * 11);
        let triangles = squares.flat_map(|i| [[i, i + 1, i + 12], [i, i + 12, i + 11]]);
        TriangleMesh::new(vertices.collect(), triangles.collect()).unwrap()
    }

    #[test]
    fn tree_finds_what_a_full_search_finds() {
        let mesh = ridge();
        for k in 0..50 {
            let low = DVec3::new((k * 7 % 10) as f64 + 0.3, (k * 3 % 10) as f64 - 0.2, -0.5);
            let aabb = Aabb {
                min: low,
                max: low + DVec3::new(1.5, 2.5, 1.0),
            };
            let mut found = Vec::new();
            mesh.overlapping(&aabb, &mut found);
            found.sort_unstable();
            let all = (0..mesh.len() as u32).filter(|&t| Aabb::of(mesh.corners(t)).overlaps(&aabb));
            assert_eq!(found, all.collect::<Vec<_>>());
        }
    }

    #[test]
    fn only_convex_edges_support_a_slanted_normal() {
        let mesh = ridge();
        let find = |x0: f64, x1: f64| {
            (0..mesh.len() as u32)
                .flat_map(|t| (0..3).map(move |e| (t, e)))
                .find(|&(t, e)| {
                    let c = mesh.corners(t);
                    let (p, q) = (c[e], c[(e + 1) % 3]);
                    p.x == x0 && q.x == x1 && p.y != q.y && p.y > 2.0 && q.y > 2.0
                })
                .unwrap()
        };
        let (crest, crest_edge) = find(5.0, 5.0);
        assert!(mesh.is_supporting(crest, Feature::Edge(crest_edge), DVec3::Z));
        assert!(!mesh.is_supporting(crest, Feature::Edge(crest_edge), DVec3::X));
        let (valley, valley_edge) = find(4.0, 4.0);
        assert!(!mesh.is_supporting(valley, Feature::Edge(valley_edge), DVec3::Z));
        let (flat, flat_edge) = find(2.0, 2.0);
        assert!(mesh.is_supporting(flat, Feature::Edge(flat_edge), DVec3::Z));
        assert!(!mesh.is_supporting(flat, Feature::Edge(flat_edge), DVec3::new(0.6, 0.0, 0.8)));
    }

    #[test]
    fn unmerged_vertices_know_their_neighbours() {
        let v = |x: f64, y: f64| DVec3::new(x, y, 0.0);
        let vertices = vec![
            v(0.0, 0.0),
            v(1.0, 0.0),
            v(0.0, 1.0),
            v(1.0, 0.0),
            v(1.0, 1.0),
            v(-0.0, 1.0),
        ];
        let mesh = TriangleMesh::new(vertices, vec![[0, 1, 2], [3, 4, 5]]).unwrap();
        let slanted = DVec3::new(0.48, 0.36, 0.8);
        assert!(!mesh.is_supporting(0, Feature::Edge(1), slanted));
        assert!(mesh.is_supporting(0, Feature::Edge(0), slanted));
    }

    #[test]
    fn bad_input_is_refused_with_a_sentence() {
        assert!(TriangleMesh::new(vec![], vec![])
            .unwrap_err()
            .contains("at least one"));
        assert!(TriangleMesh::new(vec![DVec3::ZERO], vec![[0, 0, 1]])
            .unwrap_err()
            .contains("does not exist"));
        assert!(TriangleMesh::new(vec![DVec3::ZERO], vec![[0, 0, 0]])
            .unwrap_err()
            .contains("area"));
        assert!(TriangleMesh::new(vec![DVec3::NAN], vec![[0, 0, 0]])
            .unwrap_err()
            .contains("finite"));
    }
}
