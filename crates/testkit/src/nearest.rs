//! The nearest point of an ellipse, by search.

/// The distance of a point of the meridian plane from the ellipse.
pub fn searched(a: f64, b: f64, rho: f64, z: f64) -> f64 {
    let far = |beta: f64| (rho - a * beta.cos()).hypot(z - b * beta.sin());
    let steps = 512;
    let angle = |i: f64| i / f64::from(steps) * std::f64::consts::PI - std::f64::consts::FRAC_PI_2;
    let best = (0..=steps)
        .map(f64::from)
        .min_by(|&i, &j| far(angle(i)).total_cmp(&far(angle(j))))
        .unwrap();
    let (mut low, mut high) = (angle(best - 1.0), angle(best + 1.0));
    for _ in 0..80 {
        let (one, two) = (low + (high - low) * 0.382, low + (high - low) * 0.618);
        if far(one) < far(two) { high = two } else { low = one }
    }
    far(0.5 * (low + high))
}
