//! What the variants look like, and where they are wrong.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use maud::{Markup, html};

use super::escape::Text;
use super::results::place;
use super::table::parts;
use crate::figures::Figure;
use crate::heat::{FALSE_LIGHT, FALSE_SHADOW};
use crate::tabulate::Group;
use crate::{Experiment, Measurement, Pictures};

/// The section; empty where no picture was kept.
pub(super) fn section(experiment: &Experiment, groups: &[Group]) -> Markup {
    let rows: Vec<Markup> =
        groups.chunk_by(|a, b| a.stands_beside(b)).filter_map(|beside| row(experiment, beside)).collect();
    if rows.is_empty() {
        return html! {};
    }
    html! {
        section id="pictures" { "\n"
            h2 { "Pictures" } "\n"
            p {
                (if experiment.enlarged.is_empty() { "Above, " } else { "Above, a part enlarged; then " })
                "the picture; beneath, where it is wrong: " (swatch("false shadow", FALSE_SHADOW))
                " where light should be, " (swatch("false light", FALSE_LIGHT))
                " where shadow should be. Grey is right; what is darkest is not judged."
            } "\n"
            @for row in &rows { (row) }
        }
    }
}

/// The pictures of one world, camera and motion; `None` where none was kept.
fn row(experiment: &Experiment, beside: &[Group]) -> Option<Markup> {
    let place = place(beside.first()?);
    let mut figures: Vec<Markup> = beside.iter().filter_map(|group| figure(experiment, group)).collect();
    figures.extend(beside.iter().find_map(|group| exact(experiment, group)));
    (!figures.is_empty()).then(|| {
        html! {
            h3.place { (parts(&place)) } "\n"
            div.pictures { "\n" @for figure in &figures { (figure) "\n" } } "\n"
        }
    })
}

fn swatch(name: &str, [red, green, blue]: [u8; 3]) -> Markup {
    html! { b.swatch { i style={ "background:rgb(" (red) "," (green) "," (blue) ")" } {} " " (name) } }
}

/// The pictures of the first repeat that has some, and the figures of that very picture.
fn figure(experiment: &Experiment, group: &Group) -> Option<Markup> {
    let (pictures, measurement) = group.rows.iter().find_map(|row| {
        let outcome = &row.outcome;
        outcome.pictures.as_ref().map(|pictures| (pictures, &outcome.measurement))
    })?;
    let Pictures { shaded, error, exact: _ } = pictures;
    let name = group.name(experiment);
    let part = experiment.enlarged.get(&group.rows.first()?.run.world);
    let enlarged = part.and_then(|part| enlarged(shaded, *part)).unwrap_or_default();
    Some(html! {
        figure {
            (image("png", &enlarged, &format!("{name}: a part of it, enlarged"), measurement))
            (image("jpeg", shaded, &format!("{name}: the picture"), measurement))
            (image("png", error, &format!("{name}: where its shadows are wrong"), measurement))
            figcaption { b { (Text(&name)) } br; (caption(measurement)) }
        }
    })
}

/// The picture with exact shadows that a group's first picture was judged by.
fn exact(experiment: &Experiment, group: &Group) -> Option<Markup> {
    let row = group.rows.iter().find(|row| row.outcome.pictures.is_some())?;
    let (exact, measurement) = (&row.outcome.pictures.as_ref()?.exact, &row.outcome.measurement);
    let part = experiment.enlarged.get(&row.run.world);
    let enlarged = part.and_then(|part| enlarged(exact, *part)).unwrap_or_default();
    Some(html! {
        figure {
            (image("png", &enlarged, "exact: a part of it, enlarged", measurement))
            (image("jpeg", exact, "exact: the picture", measurement))
            figcaption { b { "exact" } br; "traced, one ray a pixel and light" }
        }
    })
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

fn caption(measurement: &Measurement) -> Markup {
    let Some(error) = &measurement.error else {
        return html! { span.none { "no pixels to judge" } };
    };
    let text = |key: &str, value: f64| Figure::named(key).map_or_else(String::new, |f| f.text(value));
    html! {
        (text("error.mis_shadowed", error.mis_shadowed)) " mis-shadowed, mean error "
        (text("error.mae", error.mae)) ": "
        (text("error.false_shadow", error.false_shadow)) " false shadow, "
        (text("error.false_light", error.false_light)) " false light"
    }
}

/// The picture within the page; nothing of an empty file.
fn image(kind: &str, file: &[u8], alt: &str, measurement: &Measurement) -> Markup {
    let Measurement { width, height, .. } = measurement;
    html! {
        @if !file.is_empty() {
            img alt=(Text(alt)) width=(width) height=(height)
                src={ "data:image/" (kind) ";base64," (STANDARD.encode(file)) };
        }
    }
}
