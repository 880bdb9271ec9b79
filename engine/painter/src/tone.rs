//! From light to bytes.

use std::sync::OnceLock;

use glam::Vec3;

const STEPS: usize = 4096;

/// sRGB bytes of linear light; IEC 61966-2-1.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss
)]
pub(super) fn bytes(light: Vec3) -> [u8; 3] {
    static TABLE: OnceLock<Vec<u8>> = OnceLock::new();
    let table = TABLE.get_or_init(|| {
        (0..=STEPS)
            .map(|k| encoded(k as f64 / STEPS as f64))
            .collect()
    });
    light
        .to_array()
        .map(|part| table[(part.clamp(0.0, 1.0) * STEPS as f32 + 0.5) as usize])
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn encoded(part: f64) -> u8 {
    let bent = if part <= 0.003_130_8 {
        12.92 * part
    } else {
        1.055 * libm::pow(part, 1.0 / 2.4) - 0.055
    };
    (bent * 255.0).round() as u8
}
