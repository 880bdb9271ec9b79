//! Pictures: from arrays to pixels; see the crate `painter`.

use glam::{DMat3, DVec3, Vec3};
use numpy::{IntoPyArray, PyArray3, PyArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use super::guarded;
use super::input::{floats, integers, Input};
use physsim_painter::{Camera, Finish, Light, Mesh, Picture, Plane, Thing, MOST_SAMPLES};

/// Pixels along a side, at most.
const LARGEST: usize = 16384;
/// Texels along a side of a light's map, at most.
const FINEST: usize = 8192;

/// The picture as sRGB, (height, width, 3) uint8, from the top left.
#[pyfunction]
#[pyo3(signature = (picture, threads = 1))]
pub(super) fn draw<'py>(
    py: Python<'py>,
    picture: &Bound<'py, PyDict>,
    threads: usize,
) -> PyResult<Bound<'py, PyArray3<u8>>> {
    let picture = read_picture(&Input(picture))?;
    let (width, height) = (picture.camera.width, picture.camera.height);
    let bytes = py.detach(|| guarded(|| picture.draw(threads)))?;
    bytes.into_pyarray(py).reshape([height, width, 3])
}

fn read_picture(input: &Input<'_>) -> PyResult<Picture> {
    let meshes = read_meshes(input)?;
    let samples = whole(input, "samples", MOST_SAMPLES)?;
    Ok(Picture {
        things: read_things(input, &meshes)?,
        meshes,
        planes: read_planes(input)?,
        camera: read_camera(input)?,
        lights: read_lights(input)?,
        stage: (
            one(&input.vectors("stage_middle")?, "stage_middle")?,
            input.float("stage_radius")?,
        ),
        background: colours(input, "background")?
            .try_into()
            .map_err(|_| wrong("background"))?,
        samples,
    })
}

fn read_meshes(input: &Input<'_>) -> PyResult<Vec<Mesh>> {
    let mut meshes = Vec::new();
    for item in input.list("meshes")? {
        let parts = item.cast_into::<PyTuple>()?;
        let vectors = |k: usize, name: &str| -> PyResult<Vec<Vec3>> {
            Ok(small(&floats(&parts.get_item(k)?, name, 3)?))
        };
        let mesh = Mesh {
            vertices: vectors(0, "vertices")?,
            normals: vectors(1, "normals")?,
            triangles: corners(&integers(&parts.get_item(2)?, "triangles", 3)?)?,
        };
        let inside = |t: &[u32; 3]| t.iter().all(|&k| (k as usize) < mesh.vertices.len());
        if mesh.normals.len() != mesh.vertices.len() || !mesh.triangles.iter().all(inside) {
            return Err(wrong("meshes"));
        }
        meshes.push(mesh);
    }
    Ok(meshes)
}

fn corners(flat: &[i32]) -> PyResult<Vec<[u32; 3]>> {
    flat.chunks_exact(3)
        .map(|t| Ok([index(t[0])?, index(t[1])?, index(t[2])?]))
        .collect()
}

fn index(value: i32) -> PyResult<u32> {
    u32::try_from(value).map_err(|_| wrong("triangles"))
}

fn read_things(input: &Input<'_>, meshes: &[Mesh]) -> PyResult<Vec<Thing>> {
    let (mesh, finish) = (input.integers("mesh", 1)?, input.integers("finish", 1)?);
    let (closed, colour) = (input.integers("closed", 1)?, colours(input, "colour")?);
    let (matrix, position) = (input.floats("matrix", 9)?, input.vectors("position")?);
    let count = mesh.len();
    if [
        finish.len(),
        closed.len(),
        colour.len(),
        position.len(),
        matrix.len() / 9,
    ] != [count; 5]
    {
        return Err(wrong("things"));
    }
    (0..count)
        .map(|k| {
            Ok(Thing {
                mesh: usize::try_from(mesh[k])
                    .ok()
                    .filter(|&m| m < meshes.len())
                    .ok_or_else(|| wrong("mesh"))?,
                matrix: DMat3::from_cols_slice(&matrix[9 * k..9 * k + 9]).transpose(),
                position: position[k],
                colour: colour[k],
                finish: finish_of(finish[k])?,
                closed: closed[k] != 0,
            })
        })
        .collect()
}

fn finish_of(number: i32) -> PyResult<Finish> {
    match number {
        0 => Ok(Finish::Plain),
        1 => Ok(Finish::Quartered),
        2 => Ok(Finish::Sign),
        _ => Err(wrong("finish")),
    }
}

fn read_planes(input: &Input<'_>) -> PyResult<Vec<Plane>> {
    let (middle, axes) = (
        input.vectors("plane_middle")?,
        input.floats("plane_axes", 9)?,
    );
    let (colour, line) = (
        colours(input, "plane_colour")?,
        colours(input, "plane_line")?,
    );
    let size = input.floats("plane_size", 2)?;
    let count = middle.len();
    if [axes.len() / 9, colour.len(), line.len(), size.len() / 2] != [count; 4] {
        return Err(wrong("planes"));
    }
    Ok((0..count)
        .map(|k| Plane {
            middle: middle[k],
            axes: three(&small(&axes[9 * k..9 * k + 9])),
            colour: colour[k],
            line: line[k],
            spacing: short(size[2 * k]),
            radius: short(size[2 * k + 1]),
        })
        .collect())
}

fn read_camera(input: &Input<'_>) -> PyResult<Camera> {
    Ok(Camera {
        eye: one(&input.vectors("eye")?, "eye")?,
        axes: small(&input.floats("camera_axes", 3)?)
            .try_into()
            .map_err(|_| wrong("camera_axes"))?,
        focus: short(input.float("focus")?),
        width: whole(input, "width", LARGEST)?,
        height: whole(input, "height", LARGEST)?,
        near: short(input.float("near")?),
    })
}

fn read_lights(input: &Input<'_>) -> PyResult<Vec<Light>> {
    let (direction, strength) = (
        colours(input, "light_direction")?,
        colours(input, "light_strength")?,
    );
    let (map, gloss) = (
        input.integers("light_map", 2)?,
        input.floats("light_gloss", 1)?,
    );
    let count = direction.len();
    if [strength.len(), map.len() / 2, gloss.len()] != [count; 3] {
        return Err(wrong("lights"));
    }
    (0..count)
        .map(|k| {
            let size = |value: i32| usize::try_from(value).ok().filter(|&v| v <= FINEST);
            let (texels, softness) = (size(map[2 * k]), size(map[2 * k + 1]));
            let (Some(texels), Some(softness)) = (texels, softness) else {
                return Err(wrong("light_map"));
            };
            if texels > 0 && (softness == 0 || softness + 1 >= texels) {
                return Err(wrong("light_map"));
            }
            Ok(Light {
                direction: direction[k],
                strength: strength[k],
                texels,
                softness,
                gloss: short(gloss[k]),
            })
        })
        .collect()
}

/// A whole number from 1 to `most`.
fn whole(input: &Input<'_>, name: &str, most: usize) -> PyResult<usize> {
    let value: usize = input.item(name)?.extract()?;
    if (1..=most).contains(&value) {
        Ok(value)
    } else {
        Err(PyValueError::new_err(format!(
            "{name} must be from 1 to {most}, got {value}"
        )))
    }
}

fn colours(input: &Input<'_>, name: &str) -> PyResult<Vec<Vec3>> {
    Ok(small(&input.floats(name, 3)?))
}

fn small(flat: &[f64]) -> Vec<Vec3> {
    flat.chunks_exact(3)
        .map(|v| DVec3::from_slice(v).as_vec3())
        .collect()
}

fn three(rows: &[Vec3]) -> [Vec3; 3] {
    [rows[0], rows[1], rows[2]]
}

fn one(rows: &[DVec3], name: &str) -> PyResult<DVec3> {
    rows.first().copied().ok_or_else(|| wrong(name))
}

#[allow(clippy::cast_possible_truncation)]
fn short(value: f64) -> f32 {
    value as f32
}

fn wrong(name: &str) -> PyErr {
    PyValueError::new_err(format!("{name}: sizes or numbers do not fit"))
}
