//! Light and air: what makes ground at a distance look distant.

/// Metres in which the air thins to 1/e, and how far one sees through the air at the ground: toward ground, and toward the dark.
const THINNING: f32 = 8_000.0;
const SIGHT: f32 = 70_000.0;
const SIGHT_UP: f32 = 25_000.0;

/// The planet's radius, for the air only.
const RADIUS: f32 = 6_371_000.0;

/// The air at the horizon, in red, green and blue.
const HAZE: [f32; 3] = [0.62, 0.74, 0.90];
const SKY: [f32; 3] = [0.30, 0.52, 0.86];

/// Ground in the sun: `light` is the cosine of the sun's angle to the terrain's normal, `day` that to the ellipsoid's, `facing` the cosine of the
/// ellipsoid's normal to the line of sight, and the eye is at a height and a distance in metres.
pub fn ground(colour: [f32; 3], light: f32, day: f32, facing: f32, height: f32, distance: f32) -> [f32; 3] {
    let day = (4.0 * day + 0.4).clamp(0.0, 1.0);
    let shade = 0.16 + day * (0.14 + 1.05 * light.max(0.0));
    let through = (THINNING * (1.0 - (-height / THINNING).exp()) / facing.max(0.01)).min(distance);
    let share = 1.0 - (-through / SIGHT).exp();
    let lit = HAZE.map(|v| v * (0.08 + 0.92 * day));
    std::array::from_fn(|k| colour[k] * shade * (1.0 - share) + lit[k] * share)
}

/// The sky, for an eye at a height in metres and a line of sight whose cosine to the vertical is `rising`.
pub fn sky(height: f32, rising: f32, background: [f32; 3]) -> [f32; 3] {
    // The lowest point of the line, and how steep the line is there at most.
    let from_centre = RADIUS + height;
    let lowest = if rising < 0.0 {
        from_centre * (1.0 - rising * rising).sqrt() - RADIUS
    } else {
        height
    };
    let grazing = (std::f32::consts::PI * RADIUS * THINNING).sqrt();
    let across = (THINNING / rising.max(1e-3)).min(grazing);
    let through = across * (-lowest.max(0.0) / THINNING).exp();
    let share = 1.0 - (-through / SIGHT_UP).exp();
    let pale = share.powi(4);
    std::array::from_fn(|k| background[k] * (1.0 - share) + (SKY[k] + (HAZE[k] - SKY[k]) * pale) * share)
}
