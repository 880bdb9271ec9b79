//! A picture of solids, drawn without a display, a graphics card or any library of the system.
//!
//! Triangles go through a depth buffer (`raster.rs`), each light has a depth map of its own that tells what it reaches
//! (`light.rs`), and every visible point is shaded once per pixel (`shade.rs`); pixels on an edge are shaded once
//! for each surface that their samples see. The same picture gives the same bytes on any number of threads.

mod camera;
mod light;
mod plane;
mod raster;
mod shade;
#[cfg(test)]
mod tests;
mod tone;

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::Mutex;

use glam::{DMat3, DVec3, Mat3, Vec3};

pub use camera::Camera;
pub use light::Light;
pub use plane::Plane;
use raster::{Buffers, Face};
use shade::Shader;
pub use shade::MOST_SAMPLES;

/// Rows of pixels that are drawn in one go: their samples fit into the cache of a core.
const BAND: usize = 16;

/// A triangle mesh: unit normals, one for each vertex; triangles counter-clockwise from outside.
pub struct Mesh {
    /// Corners, in the mesh's own frame.
    pub vertices: Vec<Vec3>,
    /// Unit normals at the corners.
    pub normals: Vec<Vec3>,
    /// Indices of three corners each.
    pub triangles: Vec<[u32; 3]>,
}

/// How a thing is painted.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Finish {
    /// One colour.
    Plain,
    /// Quarters about the mesh's z axis in two tones, so that one sees it turn.
    Quartered,
    /// A sign, not a solid: no shadow, no shading to speak of, and it shines through what hides it.
    Sign,
}

/// A mesh at its place.
pub struct Thing {
    /// Index of the mesh.
    pub mesh: usize,
    /// From the mesh's frame to world axes; may stretch.
    pub matrix: DMat3,
    /// The mesh's origin in the world.
    pub position: DVec3,
    /// Linear RGB, 0 to 1.
    pub colour: Vec3,
    /// How it is painted.
    pub finish: Finish,
    /// Whether the mesh is closed, so that triangles seen from behind need not be drawn.
    pub closed: bool,
}

/// All that is in a picture.
pub struct Picture {
    /// The meshes that things share.
    pub meshes: Vec<Mesh>,
    /// What is drawn.
    pub things: Vec<Thing>,
    /// Floors and walls.
    pub planes: Vec<Plane>,
    /// From where.
    pub camera: Camera,
    /// By which light.
    pub lights: Vec<Light>,
    /// Middle and radius of the ball whose content casts shadows.
    pub stage: (DVec3, f64),
    /// Linear RGB at the upper and at the lower edge.
    pub background: [Vec3; 2],
    /// Samples along each side of a pixel.
    pub samples: usize,
}

/// The vertices of a thing in world axes, seen from the eye, and what turns normals.
struct Placed {
    vertices: Vec<Vec3>,
    turn: Mat3,
}

impl Picture {
    /// Rows of sRGB bytes from the top left, `3 * width * height` of them.
    #[must_use]
    pub fn draw(&self, threads: usize) -> Vec<u8> {
        let threads = threads.max(1);
        let placed = self.placed(threads);
        let faces = self.faces(&placed, threads);
        let maps = in_turn(self.lights.len(), threads, |k| {
            self.lights[k].map(self, &placed)
        });
        let shader = Shader::new(self, &placed, &faces, maps);
        let bins = self.bins(&faces);
        let bands = in_turn(bins.len(), threads, |band| {
            self.band(band, &bins[band], &faces, &shader)
        });
        bands.concat()
    }

    fn placed(&self, threads: usize) -> Vec<Placed> {
        in_turn(self.things.len(), threads, |k| {
            let thing = &self.things[k];
            let offset = thing.position - self.camera.eye;
            let vertices = self.meshes[thing.mesh].vertices.iter();
            Placed {
                vertices: vertices
                    .map(|v| (thing.matrix * v.as_dvec3() + offset).as_vec3())
                    .collect(),
                turn: thing.matrix.inverse().transpose().as_mat3(),
            }
        })
    }

    /// The triangles that face the camera, in pixels times samples.
    fn faces(&self, placed: &[Placed], threads: usize) -> Vec<Face> {
        let parts = in_turn(placed.len(), threads, |k| {
            let thing = &self.things[k];
            let triangles = &self.meshes[thing.mesh].triangles;
            let mut faces = Vec::new();
            self.camera.project(
                (k, thing.closed),
                &placed[k].vertices,
                triangles,
                self.samples,
                &mut faces,
            );
            faces
        });
        parts.into_iter().flatten().collect()
    }

    /// Which faces touch which band.
    fn bins(&self, faces: &[Face]) -> Vec<Vec<u32>> {
        let count = self.camera.height.div_ceil(BAND);
        let mut bins = vec![Vec::new(); count];
        let rows = BAND * self.samples;
        for (number, face) in faces.iter().enumerate() {
            let (low, high) = face.rows();
            for bin in bins.iter_mut().take(high / rows + 1).skip(low / rows) {
                #[allow(clippy::cast_possible_truncation)] // memory ends before u32 does
                bin.push(number as u32);
            }
        }
        bins
    }

    /// The bytes of one band of rows.
    fn band(&self, band: usize, bin: &[u32], faces: &[Face], shader: &Shader) -> Vec<u8> {
        let rows = band * BAND..((band + 1) * BAND).min(self.camera.height);
        let mut buffers = Buffers::new(&rows, self.camera.width, self.samples);
        for &number in bin {
            let face = &faces[number as usize];
            let sign = self.things[face.thing as usize].finish == Finish::Sign;
            buffers.draw(face, number, usize::from(sign));
        }
        let mut bytes = Vec::with_capacity(3 * rows.len() * self.camera.width);
        let mut sky = vec![None; self.camera.width.div_ceil(2)];
        for row in rows {
            if row % 2 == 0 {
                sky.fill(None);
            }
            for column in 0..self.camera.width {
                let light = shader.pixel((column, row), &buffers, &mut sky[column / 2]);
                bytes.extend(tone::bytes(light));
            }
        }
        bytes
    }
}

/// What `work` gives for 0 .. count, in that order, done by several threads.
fn in_turn<T: Send>(count: usize, threads: usize, work: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let done = Mutex::new((0..count).map(|_| None).collect::<Vec<Option<T>>>());
    std::thread::scope(|scope| {
        for _ in 0..threads.min(count) {
            scope.spawn(|| loop {
                let number = next.fetch_add(1, Ordering::Relaxed);
                if number >= count {
                    break;
                }
                let result = work(number);
                done.lock().expect("no thread panicked")[number] = Some(result);
            });
        }
    });
    let done = done.into_inner().expect("no thread panicked");
    done.into_iter()
        .map(|result| result.expect("every number was done"))
        .collect()
}
