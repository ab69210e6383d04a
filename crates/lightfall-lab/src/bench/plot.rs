//! The plot of error against run time: both axes logarithmic, one line per method.

use super::labels::place_labels;
use super::measurement::Measurement;
use super::pareto::is_on_front;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

const SIZE: (u32, u32) = (860, 520);

/// Width of a label's character and height of its line, in pixels.
const LETTER: [i32; 2] = [6, 10];
/// The rectangle of the legend: left, top, right, bottom.
const LEGEND: [i32; 4] = [716, 34, 848, 140];
/// Lengths of the dashes of the Pareto front and of the gaps between them, in pixels.
const DASHES: [i32; 2] = [5, 4];

/// One colour per line, from a set that colour-blind people can tell apart (Okabe & Ito 2008).
fn colour(method: &str) -> RGBColor {
    match method {
        "closed" => RGBColor(0, 114, 178),
        "mino" => RGBColor(0, 158, 115),
        "verlet" => RGBColor(213, 94, 0),
        _ => RGBColor(204, 121, 167),
    }
}

/// The scene's rows as SVG. `None` if there is nothing to draw. Rows whose error is infinite,
/// because of unfinished rays, are crosses at the upper edge.
///
/// # Errors
/// The message of the plotting library.
pub fn plot(scene: &str, about: &str, rows: &[Measurement]) -> Result<Option<String>, String> {
    let own = rows.iter().filter(|row| row.scene == scene).cloned();
    let marks: Vec<Measurement> = own.collect();
    let Some(ends) = ends(&marks) else {
        return Ok(None);
    };
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        draw(&area, &format!("{scene}: {about}"), &marks, ends)
            .and_then(|()| area.present())
            .map_err(|error| error.to_string())?;
    }
    Ok(Some(svg))
}

/// The ends of the axes: left, right, bottom, top. `None` if no mark can be drawn.
fn ends(marks: &[Measurement]) -> Option<[f64; 4]> {
    let least = |values: &[f64]| values.iter().copied().fold(f64::INFINITY, f64::min);
    let most = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
    let times: Vec<f64> = marks.iter().map(|mark| mark.trace_ms).collect();
    let errors = marks.iter().map(|mark| mark.backward_p99_px);
    let errors: Vec<f64> = errors
        .filter(|error| error.is_finite() && *error > 0.0)
        .collect();
    (least(&times) > 0.0 && !errors.is_empty()).then(|| {
        [
            least(&times) / 1.6,
            most(&times) * 9.0,
            least(&errors) / 2.5,
            most(&errors) * 12.0,
        ]
    })
}

type Drawn<'a> = Result<(), DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>>;

fn draw<'a>(
    area: &DrawingArea<SVGBackend<'a>, plotters::coord::Shift>,
    caption: &str,
    marks: &[Measurement],
    [left, right, bottom, top]: [f64; 4],
) -> Drawn<'a> {
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(area)
        .caption(caption, ("sans-serif", 17))
        .margin(12)
        .x_label_area_size(44)
        .y_label_area_size(76)
        .build_cartesian_2d((left..right).log_scale(), (bottom..top).log_scale())?;
    chart
        .configure_mesh()
        .light_line_style(RGBColor(238, 238, 238))
        .bold_line_style(RGBColor(215, 215, 215))
        .x_desc("time to trace the picture's rays, ms")
        .y_desc("backward error, pixels, 99th percentile")
        .x_label_formatter(&|x| decade(*x))
        .y_label_formatter(&|y| decade(*y))
        .label_style(("sans-serif", 13))
        .draw()?;
    let ceiling = top / 1.6;
    let place = |mark: &Measurement| {
        let height = if mark.backward_p99_px.is_finite() {
            mark.backward_p99_px
        } else {
            ceiling
        };
        (mark.trace_ms, height)
    };
    let mut methods: Vec<&str> = marks.iter().map(|mark| &*mark.method).collect();
    methods.dedup();
    let points: Vec<[i32; 2]> = marks
        .iter()
        .map(|mark| chart.backend_coord(&place(mark)).into())
        .collect();
    let sizes: Vec<[i32; 2]> = marks
        .iter()
        .map(|mark| [LETTER[0] * mark.setting_label().len() as i32, LETTER[1]])
        .collect();
    for (mark, corner) in marks.iter().zip(place_labels(&points, &sizes, LEGEND)) {
        let colour = colour(&mark.method);
        let style = ("sans-serif", 11)
            .into_font()
            .color(&colour)
            .pos(Pos::new(HPos::Left, VPos::Top));
        let label = corner.map(|[x, y]| {
            EmptyElement::at(place(mark)) + Text::new(mark.setting_label(), (x, y), style)
        });
        chart.draw_series(label)?;
    }
    for method in methods {
        let colour = colour(method);
        let mut points: Vec<&Measurement> =
            marks.iter().filter(|mark| mark.method == method).collect();
        points.sort_by(|a, b| a.trace_ms.total_cmp(&b.trace_ms));
        let places = points.iter().map(|mark| place(mark));
        chart
            .draw_series(LineSeries::new(places, colour.stroke_width(1)))?
            .label(method)
            .legend(move |(x, y)| Circle::new((x + 8, y), 5, colour.filled()));
        for mark in points {
            let place = place(mark);
            if mark.backward_p99_px.is_finite() {
                chart.draw_series([Circle::new(place, 5, colour.filled())])?;
            } else {
                chart.draw_series([Cross::new(place, 6, colour.stroke_width(2))])?;
            }
        }
    }
    let mut front: Vec<(f64, f64)> = marks
        .iter()
        .filter(|mark| is_on_front(marks, mark))
        .map(|mark| (mark.trace_ms, mark.backward_p99_px))
        .collect();
    front.sort_by(|a, b| a.0.total_cmp(&b.0));
    if !front.is_empty() {
        chart
            .draw_series(DashedLineSeries::new(
                front,
                DASHES[0],
                DASHES[1],
                BLACK.stroke_width(1),
            ))?
            .label("Pareto front")
            .legend(|(x, y)| {
                DashedPathElement::new([(x - 2, y), (x + 20, y)], DASHES[0], DASHES[1], BLACK)
            });
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .background_style(WHITE.mix(0.85))
        .border_style(RGBColor(200, 200, 200))
        .label_font(("sans-serif", 13))
        .draw()
}

/// A power of ten in decimal notation. All marks of the axes are powers of ten.
fn decade(x: f64) -> String {
    format!("{x:.*}", (-x.log10().round()).max(0.0) as usize)
}
