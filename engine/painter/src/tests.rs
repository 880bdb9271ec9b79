use glam::{DMat3, DVec3, Vec3};

use super::raster::{spans, Corner};
use super::*;

const WHITE: Vec3 = Vec3::ONE;

fn square() -> Mesh {
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    Mesh {
        vertices: corners.iter().map(|&(x, y)| Vec3::new(x, y, 0.0)).collect(),
        normals: vec![Vec3::Z; 4],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
    }
}

/// A square of half width `size` at a height, seen from above.
fn flat(size: f64, height: f64, colour: Vec3, finish: Finish) -> Thing {
    Thing {
        mesh: 0,
        matrix: DMat3::from_diagonal(DVec3::splat(size)),
        position: DVec3::new(0.0, 0.0, height),
        colour,
        finish,
        closed: true,
    }
}

/// 40 x 30 pixels from 10 above the origin, y up in the picture; a pixel of the plane z = 0 is 0.1 wide.
fn from_above(things: Vec<Thing>) -> Picture {
    Picture {
        meshes: vec![square()],
        things,
        planes: Vec::new(),
        camera: Camera {
            eye: DVec3::new(0.0, 0.0, 10.0),
            axes: [Vec3::X, Vec3::Y, -Vec3::Z],
            focus: 100.0 / 15.0,
            width: 40,
            height: 30,
            near: 0.1,
        },
        lights: vec![Light {
            direction: Vec3::Z,
            strength: WHITE,
            texels: 0,
            softness: 0,
            gloss: 0.0,
        }],
        stage: (DVec3::ZERO, 4.0),
        background: [Vec3::ZERO; 2],
        samples: 2,
    }
}

fn pixel(bytes: &[u8], column: usize, row: usize) -> [u8; 3] {
    let k = 3 * (40 * row + column);
    [bytes[k], bytes[k + 1], bytes[k + 2]]
}

#[test]
fn a_square_covers_the_pixels_that_the_pinhole_predicts() {
    let bytes = from_above(vec![flat(0.5, 0.0, WHITE, Finish::Plain)]).draw(1);
    for row in 0..30 {
        for column in 0..40 {
            let inside = (15..25).contains(&column) && (10..20).contains(&row);
            let expected = if inside { [255; 3] } else { [0; 3] };
            assert_eq!(pixel(&bytes, column, row), expected, "{column}, {row}");
        }
    }
}

#[test]
fn a_pixel_on_the_rim_is_the_mean_of_its_samples() {
    let bytes = from_above(vec![flat(0.55, 0.0, WHITE, Finish::Plain)]).draw(1);
    assert_eq!(
        pixel(&bytes, 14, 15),
        [188; 3],
        "half of the light: 0.5 in sRGB"
    );
    assert_eq!(pixel(&bytes, 14, 9), [137; 3], "a quarter: 0.25");
}

#[test]
fn the_nearer_of_two_is_seen_in_any_order() {
    let (red, blue) = (Vec3::X, Vec3::Z);
    let near = || flat(0.3, 1.0, red, Finish::Plain);
    let far = || flat(1.0, 0.0, blue, Finish::Plain);
    for things in [vec![near(), far()], vec![far(), near()]] {
        let bytes = from_above(things).draw(1);
        assert_eq!(pixel(&bytes, 20, 15), [255, 0, 0]);
        assert_eq!(pixel(&bytes, 12, 15), [0, 0, 255]);
    }
}

#[test]
fn a_closed_thing_is_not_drawn_from_behind_and_an_open_one_is() {
    let mut thing = flat(1.0, 0.0, WHITE, Finish::Plain);
    thing.matrix = DMat3::from_diagonal(DVec3::new(1.0, -1.0, -1.0));
    thing.closed = false;
    let mut picture = from_above(vec![thing]);
    assert_eq!(pixel(&picture.draw(1), 20, 15), [255; 3]);
    picture.things[0].closed = true;
    assert_eq!(pixel(&picture.draw(1), 20, 15), [0; 3]);
}

#[test]
fn a_sign_shines_through_what_hides_it() {
    let sign = flat(0.5, -1.0, Vec3::X, Finish::Sign);
    let bytes = from_above(vec![flat(1.0, 0.0, Vec3::Z, Finish::Plain), sign]).draw(1);
    let [red, _, blue] = pixel(&bytes, 20, 15);
    assert!(red > 100 && blue > 100, "{red} {blue}");
    assert_eq!(pixel(&bytes, 12, 15), [0, 0, 255]);
}

#[test]
fn a_plane_lies_in_the_shadow_of_what_stands_in_the_light() {
    let mut picture = from_above(vec![flat(0.5, 1.0, WHITE, Finish::Plain)]);
    picture.lights[0].direction = Vec3::new(1.0, 0.0, 1.0).normalize();
    (picture.lights[0].texels, picture.lights[0].softness) = (512, 1);
    picture.planes.push(Plane {
        middle: DVec3::ZERO,
        axes: [Vec3::X, Vec3::Y, Vec3::Z],
        colour: WHITE,
        line: WHITE,
        spacing: 0.0,
        radius: 1e3,
    });
    let bytes = picture.draw(1);
    // light comes from +x at 45 degrees: the shadow is moved by -1
    assert_eq!(pixel(&bytes, 11, 15), [0; 3]);
    let [lit, ..] = pixel(&bytes, 29, 15);
    assert_eq!(f64::from(lit), 219.0, "cos 45 degrees of white in sRGB");
}

#[test]
fn what_is_behind_the_eye_is_cut_off() {
    let mut thing = flat(30.0, 0.0, WHITE, Finish::Plain);
    thing.matrix = DMat3::from_rotation_x(1.4) * DMat3::from_diagonal(DVec3::splat(30.0));
    let bytes = from_above(vec![thing]).draw(1);
    // z = y tan 1.4 meets every ray through the upper half in front of the eye
    assert!((0..15).all(|row| pixel(&bytes, 20, row)[0] > 0));
}

#[test]
fn any_number_of_threads_draws_the_same() {
    let things = || {
        (0..20)
            .map(|k| {
                flat(
                    0.2 + 0.05 * f64::from(k),
                    -f64::from(k),
                    WHITE / (1.0 + k as f32),
                    Finish::Quartered,
                )
            })
            .collect()
    };
    let one = from_above(things()).draw(1);
    for threads in 2..6 {
        assert_eq!(from_above(things()).draw(threads), one);
    }
}

#[test]
fn triangles_around_a_point_leave_no_gap_between_them() {
    let corner = |x: f32, y: f32| Corner { x, y, near: 1.0 };
    let rim: Vec<Corner> = (0..37u8)
        .map(|k| f32::from(k) * std::f32::consts::TAU / 37.0)
        .map(|angle| corner(50.3 + 90.0 * angle.cos(), 49.7 + 90.0 * angle.sin()))
        .collect();
    let mut hits = vec![0; 100 * 100];
    for k in 0..37 {
        let triangle = [corner(50.3, 49.7), rim[k], rim[(k + 1) % 37]];
        spans(&triangle, &(0..100), 100, |row, columns, _, _| {
            for hit in &mut hits[100 * row + columns.start..100 * row + columns.end] {
                *hit += 1;
            }
        });
    }
    assert!(hits.iter().all(|&count| count >= 1));
}
