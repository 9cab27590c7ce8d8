//! What the ways look like, and where they are wrong.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

use crate::figures::Figure;
use crate::heat::{FALSE_LIGHT, FALSE_SHADOW};
use crate::page::escape::escaped;
use crate::page::table::place;
use crate::tabulate::Group;
use crate::{Experiment, Measurement, Pictures};

/// The section; empty where no picture was kept.
pub(super) fn section(experiment: &Experiment, groups: &[Group]) -> String {
    let rows: String = groups
        .chunk_by(|a, b| a.stands_beside(b))
        .filter_map(|beside| {
            let figures: String = beside.iter().filter_map(|group| figure(experiment, group)).collect();
            let place = place(beside.first()?);
            let row =
                format!("<h3 class=\"place\">{place}</h3>\n<div class=\"pictures\">\n{figures}</div>\n");
            (!figures.is_empty()).then_some(row)
        })
        .collect();
    if rows.is_empty() {
        return String::new();
    }
    format!(
        "<section id=\"pictures\">\n<h2>Pictures</h2>\n<p>{}the picture; beneath, where it is wrong: \
         {} where light should be, {} where shadow should be. \
         Grey is right; what is darkest is not judged.</p>\n{rows}</section>\n",
        if experiment.enlarged.is_empty() { "Above, " } else { "Above, a part enlarged; then " },
        swatch("false shadow", FALSE_SHADOW),
        swatch("false light", FALSE_LIGHT),
    )
}

fn swatch(name: &str, [red, green, blue]: [u8; 3]) -> String {
    format!("<b class=\"swatch\"><i style=\"background:rgb({red},{green},{blue})\"></i> {name}</b>")
}

/// The pictures of the first repeat that has some, and the figures of that very picture.
fn figure(experiment: &Experiment, group: &Group) -> Option<String> {
    let (pictures, measurement) = group.rows.iter().find_map(|row| {
        let outcome = &row.outcome;
        outcome.pictures.as_ref().map(|pictures| (pictures, &outcome.measurement))
    })?;
    let Pictures { shaded, error } = pictures;
    let name = escaped(&group.name(experiment));
    let part = experiment.enlarged.get(&group.rows.first()?.cell.world);
    let enlarged = part.and_then(|part| enlarged(shaded, *part)).unwrap_or_default();
    let enlarged = image("png", &enlarged, &format!("{name}: a part of it, enlarged"), measurement);
    let shaded = image("jpeg", shaded, &format!("{name}: the picture"), measurement);
    let error = image("png", error, &format!("{name}: where its shadows are wrong"), measurement);
    let caption = caption(measurement);
    Some(format!(
        "<figure>{enlarged}{shaded}{error}<figcaption><b>{name}</b><br>{caption}</figcaption></figure>\n"
    ))
}

/// A part of a picture, its pixels made large, as PNG; `None` where the file is no picture.
fn enlarged(shaded: &[u8], [left, top, width, height]: [u32; 4]) -> Option<Vec<u8>> {
    const TIMES: u32 = 4;
    let part = image::load_from_memory(shaded).ok()?.crop_imm(left, top, width, height);
    let large = part.resize_exact(width * TIMES, height * TIMES, image::imageops::FilterType::Nearest);
    let mut png = std::io::Cursor::new(Vec::new());
    large.write_to(&mut png, image::ImageFormat::Png).ok()?;
    Some(png.into_inner())
}

fn caption(measurement: &Measurement) -> String {
    let Some(error) = &measurement.error else {
        return "<span class=\"none\">no pixels to judge</span>".to_owned();
    };
    let text = |key: &str, value: f64| Figure::named(key).map_or_else(String::new, |f| f.text(value));
    format!(
        "{} mis-shadowed: {} false shadow, {} false light",
        text("error.mis_shadowed", error.mis_shadowed),
        text("error.false_shadow", error.false_shadow),
        text("error.false_light", error.false_light),
    )
}

/// The picture within the page; nothing of an empty file.
fn image(kind: &str, file: &[u8], alt: &str, measurement: &Measurement) -> String {
    if file.is_empty() {
        return String::new();
    }
    let Measurement { width, height, .. } = measurement;
    let data = STANDARD.encode(file);
    format!(
        "<img alt=\"{alt}\" width=\"{width}\" height=\"{height}\" src=\"data:image/{kind};base64,{data}\">"
    )
}
