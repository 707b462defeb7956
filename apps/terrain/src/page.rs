//! The page that shows the frames.

use terrella::cube::{CubeMap, Projection};
use terrella::terrain::lean;
use terrella::{Geodetic, LatLon};

use crate::approach::{ASPECT, aim};
use crate::cli::Options;
use crate::frame::{Contrast, Frame, LEANING, ROUNDING};
use crate::scale::{grouped, length};
use crate::{jpeg_file, png_file};

const STYLE: &str = include_str!("page.css");

/// The whole page.
pub fn html(options: &Options, map: &CubeMap<f64, Projection>, frames: &[Frame]) -> Result<String, String> {
    let rows: String = frames
        .iter()
        .enumerate()
        .map(|(index, frame)| row(options, index, frame))
        .collect();
    let contrasts = |of: fn(&Frame) -> Option<&Contrast>, names: [[&str; 2]; 3]| -> String {
        let row = |(index, frame)| Some(contrast_row(options, index, frame, of(frame)?, names));
        frames.iter().enumerate().filter_map(row).collect()
    };
    let naive = contrasts(
        |frame| frame.naive.as_ref(),
        [
            ["double", "f64"],
            ["naive", "naive f32"],
            ["naive-rounding", "difference"],
        ],
    );
    let leaning = contrasts(
        |frame| frame.leaning.as_ref(),
        [["double", "upright"], ["leaning", "leaning"], ["lean", "difference"]],
    );
    let most = |of: fn(&Frame) -> f64| frames.iter().map(of).fold(0.0, testkit::maximum);
    let near = most(|frame| frame.rounded.near);
    let naive_near = most(|frame| frame.naive.as_ref().map_or(0.0, |naive| naive.difference.near));
    let place = aim().map_err(|error| error.to_string())?;
    let leans = lean(&map.shifted(), place, 1_000.0);
    let body = format!(
        r#"<header>
<h1>An approach in single precision</h1>
<p class="lead">A graphics card computes in <code>f32</code>, whose numbers are half a metre apart at the Earth’s radius. Terrain is drawn with it to
the millimetre all the same, if only what is small is left to it.</p>
<p>From 10&nbsp;000&nbsp;km down to 200&nbsp;m above the Cumberland Mountains near Jacksboro, Tennessee. Of every tile four corners on the ground are kept in
<code>f64</code>; the eye is subtracted from them, and all the rest is <code>f32</code>: the bilinear patch between the corners, the displacement by
which the ellipsoid bulges from it, the height above that along the normal, the matrix, the light. Beside it the same frame in <code>f64</code> throughout, straight from latitude, longitude
and height.</p>
</header>
<main>
<section aria-labelledby="rounding">
<h2 id="rounding">What rounding does</h2>
<p>The third picture is the distance between the two positions of each vertex, interpolated over the triangles. The figures are of all
vertices of the tiles that are drawn. Within 1&nbsp;km of the eye they are at most <strong>{near}</strong> apart, and beyond at
most <strong>{beyond:.2}</strong> millionths of the distance. Colours are of the logarithm; what is black is sky.</p>
{rounding_scale}{rows}</section>
<section aria-labelledby="naive">
<h2 id="naive">What it does without patches</h2>
<p>The same vertices as Earth-centred coordinates in <code>f32</code>, less the eye in <code>f32</code>: each is rounded by itself to a grid of half a metre, and
terrain trembles as the eye moves. The largest error within 1&nbsp;km is <strong>{naive_near}</strong>, {times}&nbsp;times as large. The colours are those
above.</p>
{rounding_scale}{naive}</section>
<section aria-labelledby="leaning">
<h2 id="leaning">What leaning does</h2>
<p>The cube is mapped to a sphere, and the sphere to the ellipsoid by its {shift} latitude. Who reads heights along the sphere’s normal, as if there were
no ellipsoid, moves the terrain: here, by {aside} to the {side} and {down} down for each kilometre of height. (To take the Earth for a sphere of its mean radius
altogether moves this place by {moved}.) Left as it should be, then as it leans, both in <code>f64</code>; the third picture is how far the ground is from
where it should be.</p>
{leaning_scale}{leaning}</section>
</main>
<footer>
<p>Drawn by the program <code>terrain</code> of the crate <code>terrella</code>: {projection} cube, {shift} latitude, WGS84. Elevation: a piece of the
public-domain elevation data of the United States, 3″ between samples, its heights above the sea taken for heights above the ellipsoid; around it are its mirror images,
which fade within 60&nbsp;km, and the ground slopes down to the ellipsoid over 150&nbsp;km: that is made up. Imagery: NASA Blue Marble, 20&nbsp;km to a pixel; near the ground the relief has
colours of its own, by height.</p>
</footer>
"#,
        near = length(near),
        naive_near = length(naive_near),
        times = grouped((naive_near / near.max(f64::MIN_POSITIVE)).round() as usize),
        beyond = 1e6 * most(|frame| frame.rounded.beyond),
        rounding_scale = ROUNDING.html(),
        leaning_scale = LEANING.html(),
        shift = options.shift,
        projection = options.projection,
        aside = length(leans.north.abs()),
        side = if leans.north < 0.0 { "south" } else { "north" },
        down = length(-leans.up),
        moved = length(off_sphere(map, place)),
    );
    let description =
        "Real terrain on a cube-mapped ellipsoid, drawn by the crate terrella in single and in double precision.";
    Ok(draw::page::html(
        "An approach in single precision",
        description,
        STYLE,
        &body,
    ))
}

/// How far a place is from where it would be on the sphere of the mean radius.
fn off_sphere(map: &CubeMap<f64, Projection>, place: LatLon<f64>) -> f64 {
    let earth = map.shifted().ellipsoid();
    let right = earth.to_ecef(Geodetic::from(place)).to_array();
    let wrong = place.to_direction().to_array().map(|v| v * earth.mean_radius());
    (0..3).map(|k| (right[k] - wrong[k]).powi(2)).sum::<f64>().sqrt()
}

fn row(options: &Options, index: usize, frame: &Frame) -> String {
    let height = length(frame.height);
    let [coarsest, finest] = frame.levels;
    let levels = if coarsest == finest {
        format!("level {finest}")
    } else {
        format!("levels {coarsest} to {finest}")
    };
    figure(
        options,
        [
            (jpeg_file(index, "single"), "f32"),
            (jpeg_file(index, "double"), "f64"),
            (png_file(index, "rounding"), "difference"),
        ],
        &height,
        &format!(
            "{} tiles, {levels}; largest difference {}, median {}; {} of {} pixels are not of the same colour",
            frame.tiles,
            length(frame.rounded.largest()),
            length(frame.rounded.median()),
            grouped(frame.unlike),
            grouped(frame.single.pixels().len()),
        ),
    )
}

/// A frame as it should be, as it should not, and the difference: the files' kinds and what they are called.
fn contrast_row(options: &Options, index: usize, frame: &Frame, contrast: &Contrast, names: [[&str; 2]; 3]) -> String {
    let [[right, upright], [wrong, amiss], [apart, difference]] = names;
    figure(
        options,
        [
            (jpeg_file(index, right), upright),
            (jpeg_file(index, wrong), amiss),
            (png_file(index, apart), difference),
        ],
        &length(frame.height),
        &format!(
            "largest difference {}, median {}; {} of {} pixels are not of the same colour",
            length(contrast.difference.largest()),
            length(contrast.difference.median()),
            grouped(contrast.unlike),
            grouped(contrast.picture.pixels().len()),
        ),
    )
}

fn figure(options: &Options, pictures: [(String, &str); 3], height: &str, figures: &str) -> String {
    let (width, tall) = (options.size, options.size * ASPECT[1] / ASPECT[0]);
    let pictures: String = pictures
        .iter()
        .map(|(file, name)| {
            format!(
                "<a href=\"{file}\"><img src=\"{file}\" width=\"{width}\" height=\"{tall}\" alt=\"{name}, {height} above ground\" \
                 loading=\"lazy\"><span>{name}</span></a>\n"
            )
        })
        .collect();
    format!(
        "<figure>\n<div class=\"pictures\">\n{pictures}</div>\n<figcaption><strong>{height}</strong> above ground: {figures}</figcaption>\n</figure>\n"
    )
}
