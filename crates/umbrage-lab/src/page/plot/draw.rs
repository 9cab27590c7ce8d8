//! A chart as SVG.
//!
//! It is drawn at twice the size that it is shown at, as the library rounds to whole pixels.

use plotters::coord::Shift;
use plotters::element::DashedPathElement;
use plotters::prelude::*;

use crate::LabError;
use crate::tabulate::Mean;

use super::axis::{Axis, Direction, Scale};
use super::labels::{Box4, place, text_width};
use super::mark::{CIRCLE_RADIUS, Mark};
use super::series::{Chart, Point, Series, Shape};

/// The width and height of the SVG, in its own pixels.
const SIZE_PX: (u32, u32) = (1240, 760);

/// The size of the letters, pixels of the SVG.
const TEXT_PX: i32 = 26;

/// The library divides font sizes by this before it writes them.
const FONT_DIVISOR: f64 = 1.24;

/// Axes and letters. The style sheet turns both greys around on dark screens, by these values.
const INK: RGBColor = RGBColor(0x33, 0x33, 0x33);

/// Lines behind the data.
const GRID: RGBColor = RGBColor(0xdd, 0xdd, 0xdd);

/// The Pareto front.
const FRONT: RGBColor = RGBColor(0x99, 0x99, 0x99);

/// Half the ends of an error bar.
const BAR_END_PX: i32 = 7;

/// From one line of names above the plane to the next.
const KEY_LINE_PX: i32 = 40;

/// How much of the way from one world to the next its bars take.
const BARS: f64 = 0.8;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn = Result<(), DrawingAreaErrorKind<std::io::Error>>;

/// Draws a chart.
pub(super) fn svg(chart: &Chart) -> Result<String, LabError> {
    let mut text = String::new();
    let root = SVGBackend::with_string(&mut text, SIZE_PX).into_drawing_area();
    draw(chart, &root).map_err(|error| LabError::Plot(error.to_string()))?;
    drop(root);
    Ok(text)
}

fn draw(chart: &Chart, root: &Area) -> Drawn {
    let (x, y) = axes(chart);
    let keys = keys(chart);
    let key_lines = keys.last().map_or(0, |(_, [_, top])| top / KEY_LINE_PX + 1);
    let letters = y.ticks.iter().map(|(_, text)| text.chars().count()).max().unwrap_or(1);
    let mut context = ChartBuilder::on(root)
        .margin(20)
        .margin_top(20 + key_lines * KEY_LINE_PX)
        .margin_right(50)
        .x_label_area_size(90)
        .y_label_area_size(76 + 15 * letters.min(12) as u32)
        .build_cartesian_2d(x, y)?;
    context
        .configure_mesh()
        .x_desc(&chart.x_heading)
        .y_desc(&chart.y_heading)
        .label_style(font())
        .axis_desc_style(font())
        .axis_style(INK.stroke_width(2))
        .bold_line_style(GRID.stroke_width(2))
        .light_line_style(TRANSPARENT)
        .set_all_tick_mark_size(10)
        .draw()?;
    let pixel = |across: f64, up: f64| <[i32; 2]>::from(context.backend_coord(&(across, up)));
    let (across, up) = context.plotting_area().get_pixel_range();
    let plane = Box4([across.start, up.start, across.end, up.end]);
    front(chart, root, &pixel)?;
    for series in &chart.series {
        lines(series, root, &pixel, &plane)?;
    }
    for (i, series) in chart.series.iter().enumerate() {
        points(series, root, &pixel)?;
        bars(chart, i, root, &pixel)?;
    }
    for (series, [left, top]) in keys {
        let corners = [(left, top), (left + TEXT_PX, top + TEXT_PX)];
        root.draw(&Rectangle::new(corners, bar_colour(series).filled()))?;
        let name = chart.series.get(series).map(|series| series.name.clone()).unwrap_or_default();
        root.draw(&Text::new(name, (left + TEXT_PX + 10, top), font()))?;
    }
    names(chart, root, &pixel, &plane)
}

/// Where the names of variants with bars stand above the plane, in as many lines as they need: the place of each variant's
/// colour, by its index.
fn keys(chart: &Chart) -> Vec<(usize, [i32; 2])> {
    let bars = chart.series.iter().enumerate().filter(|(_, series)| matches!(series.shape, Shape::Bars(_)));
    let (first, last) = (100, SIZE_PX.0 as i32 - 50);
    let (mut left, mut top) = (first, 14);
    let mut keys = Vec::new();
    for (index, series) in bars {
        let width = TEXT_PX + 10 + text_width(&series.name, TEXT_PX);
        if left > first && left + width > last {
            (left, top) = (first, top + KEY_LINE_PX);
        }
        keys.push((index, [left, top]));
        left += width + 40;
    }
    keys
}

/// Axes that hold everything.
fn axes(chart: &Chart) -> (Axis, Axis) {
    let ends = |mean: &Mean| [mean.low, mean.value, mean.high];
    let points = || chart.series.iter().flat_map(Series::points);
    let across: Vec<f64> = points().flat_map(|point| ends(&point.x)).collect();
    let mut up: Vec<f64> = points().flat_map(|point| ends(&point.y)).collect();
    for series in &chart.series {
        match &series.shape {
            Shape::Level(mean) => up.extend(ends(mean)),
            // They begin at 0.
            Shape::Bars(bars) => up.extend(bars.iter().flat_map(|(_, mean)| ends(mean)).chain([0.0])),
            Shape::Point(_) | Shape::Line(_) => {}
        }
    }
    let mut swept: Vec<f64> =
        points().filter(|point| point.x.low == point.x.high).map(|p| p.x.value).collect();
    swept.sort_by(f64::total_cmp);
    swept.dedup();
    let y = Axis::of(&up, &[], &Scale::Linear, Direction::Up);
    (Axis::of(&across, &swept, &chart.x_scale, Direction::Across), y)
}

fn font() -> TextStyle<'static> {
    let size = f64::from(TEXT_PX) * FONT_DIVISOR;
    TextStyle::from((FontFamily::SansSerif, size)).color(&INK)
}

fn colour(series: &Series) -> RGBColor {
    let [red, green, blue] = Mark::of(series.variant).colour;
    RGBColor(red, green, blue)
}

/// The colour of bars by their index in the plot: few variants are shown as bars, and each has a colour of its own.
fn bar_colour(index: usize) -> RGBColor {
    let [red, green, blue] = Mark::of(index).colour;
    RGBColor(red, green, blue)
}

fn front(chart: &Chart, root: &Area, pixel: &impl Fn(f64, f64) -> [i32; 2]) -> Drawn {
    let points: Vec<(i32, i32)> = chart.front.iter().map(|[x, y]| pixel(*x, *y).into()).collect();
    root.draw(&PathElement::new(points, FRONT.stroke_width(5)))
}

/// What lies behind the points: a line through them, or a dashed one at the level of a variant that does not sweep.
fn lines(series: &Series, root: &Area, pixel: &impl Fn(f64, f64) -> [i32; 2], plane: &Box4) -> Drawn {
    let style = colour(series).stroke_width(4);
    match &series.shape {
        Shape::Point(_) | Shape::Bars(_) => Ok(()),
        Shape::Line(points) => {
            let path: Vec<(i32, i32)> = points.iter().map(|p| pixel(p.x.value, p.y.value).into()).collect();
            root.draw(&PathElement::new(path, style))
        }
        Shape::Level(mean) => {
            let [_, top] = pixel(0.0, mean.value);
            let Box4([left, _, right, _]) = *plane;
            root.draw(&DashedPathElement::new([(left, top), (right, top)], 16, 10, style))
        }
    }
}

/// Marks with their error bars.
fn points(series: &Series, root: &Area, pixel: &impl Fn(f64, f64) -> [i32; 2]) -> Drawn {
    let colour = colour(series);
    for Point { x, y, label: _ } in series.points() {
        let [left, top] = pixel(x.value, y.value);
        let ends = [
            (pixel(x.low, y.value), pixel(x.high, y.value), (0, BAR_END_PX)),
            (pixel(x.value, y.low), pixel(x.value, y.high), (BAR_END_PX, 0)),
        ];
        for (from, to, across) in ends.into_iter().filter(|(from, to, _)| from != to) {
            bar(root, from, to, across, colour.stroke_width(2))?;
        }
        let Mark { colour: _, corners } = Mark::of(series.variant);
        if corners.is_empty() {
            root.draw(&Circle::new((left, top), CIRCLE_RADIUS, colour.filled()))?;
        } else {
            let corners: Vec<(i32, i32)> = corners.iter().map(|(dx, dy)| (left + dx, top + dy)).collect();
            root.draw(&Polygon::new(corners, colour.filled()))?;
        }
    }
    Ok(())
}

/// The bars of a variant, beside those of the others, with their error bars.
fn bars(chart: &Chart, index: usize, root: &Area, pixel: &impl Fn(f64, f64) -> [i32; 2]) -> Drawn {
    let Some(Shape::Bars(bars)) = chart.series.get(index).map(|series| &series.shape) else { return Ok(()) };
    let width = BARS / chart.series.len() as f64;
    for (world, mean) in bars {
        let left = *world as f64 - 0.5 * BARS + index as f64 * width;
        // A little of the plane is left between bars.
        let corners = [pixel(left + 0.05 * width, 0.0), pixel(left + 0.95 * width, mean.value)];
        root.draw(&Rectangle::new(corners.map(<(i32, i32)>::from), bar_colour(index).filled()))?;
        let ends = [mean.low, mean.high].map(|end| pixel(left + 0.5 * width, end));
        if ends[0] != ends[1] {
            bar(root, ends[0], ends[1], (BAR_END_PX, 0), INK.stroke_width(2))?;
        }
    }
    Ok(())
}

fn bar(root: &Area, from: [i32; 2], to: [i32; 2], (dx, dy): (i32, i32), style: ShapeStyle) -> Drawn {
    root.draw(&PathElement::new([from.into(), to.into()], style))?;
    for [x, y] in [from, to] {
        root.draw(&PathElement::new([(x - dx, y - dy), (x + dx, y + dy)], style))?;
    }
    Ok(())
}

/// Labels where there is room; variants that do not sweep come first, of them those of the front.
fn names(chart: &Chart, root: &Area, pixel: &impl Fn(f64, f64) -> [i32; 2], plane: &Box4) -> Drawn {
    let place_of = |point: &Point| pixel(point.x.value, point.y.value);
    let all = || chart.series.iter().flat_map(Series::points);
    let bars = |Point { x, y, label: _ }: &Point| {
        let across = [pixel(x.low, y.value), pixel(x.high, y.value)];
        let up = [pixel(x.value, y.high), pixel(x.value, y.low)];
        [across, up].map(|[[left, top], [right, bottom]]| Box4([left, top - 1, right + 1, bottom + 1]))
    };
    let mut taken: Vec<Box4> = all().map(|p| Box4::around(place_of(p), CIRCLE_RADIUS as i32)).collect();
    taken.extend(all().flat_map(bars));
    let mut series: Vec<&Series> = chart.series.iter().collect();
    let is_on_front = |point: &Point| chart.front.contains(&[point.x.value, point.y.value]);
    series.sort_by_key(|series| {
        let points = series.points();
        (points.len() > 1, !points.iter().any(is_on_front))
    });
    for point in series.into_iter().flat_map(Series::points).filter(|point| !point.label.is_empty()) {
        if let Some([left, top]) = place(place_of(point), &point.label, TEXT_PX, plane, &mut taken) {
            root.draw(&Text::new(point.label.clone(), (left, top), font()))?;
        }
    }
    Ok(())
}
