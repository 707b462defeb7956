//! The texture filter's formulas at their limits.

use terrella::distortion::texture::{anisotropic, corrected, level};

#[test]
fn a_pixel_on_a_texel_is_at_level_0() {
    assert_eq!(level([1.0_f64, 0.0], [0.0, 1.0]), 0.0);
    assert_eq!(level([0.0_f32, 8.0], [1.0, 0.0]), 3.0);
    assert_eq!(level([0.0_f64; 2], [0.0; 2]), f64::NEG_INFINITY);
}

#[test]
fn an_anisotropic_filter_takes_whole_samples() {
    let of = |longer: f64, shorter: f64, most| {
        let filter = anisotropic([longer, 0.0], [0.0, shorter], most);
        (filter.samples, filter.level)
    };
    assert_eq!(of(1.0, 1.0, 16.0), (1.0, 0.0));
    assert_eq!(of(1.0, 0.999, 16.0).0, 2.0);
    assert_eq!(of(6.0, 2.0, 16.0), (3.0, 1.0));
    assert_eq!(of(6.1, 2.0, 16.0).0, 4.0);
    assert_eq!(of(64.0, 0.0, 16.0), (16.0, 2.0));
    assert_eq!(of(0.0, 0.0, 16.0), (16.0, f64::NEG_INFINITY));
    assert_eq!(of(8.0, 1.0, 1.0), (1.0, 3.0));
}

#[test]
fn smaller_texels_ask_for_a_higher_level() {
    assert_eq!(corrected(2.0_f64, 1.0), 2.0);
    // A texel half as wide and half as high: one level more.
    assert_eq!(corrected(2.0_f64, 0.25), 3.0);
    assert_eq!(corrected(2.0_f32, 4.0), 1.0);
}
