//! The window that says why a pixel's shadow is as it is.

use eframe::egui;
use umbrage_judge::Pixel;

use crate::pick::{Answer, Pick};
use crate::why::{MapSays, Why};

/// Shows the window; `lights` are the names of those that shine. Returns the question that is asked from now on, which may be
/// none.
pub fn show(context: &egui::Context, pick: Pick, lights: &[String]) -> Option<Pick> {
    let (mut is_open, mut light) = (true, pick.light);
    egui::Window::new("Why?").open(&mut is_open).default_width(360.0).default_pos([300.0, 72.0]).show(
        context,
        |ui| {
            let [x, y] = pick.pixel;
            ui.weak(format!("pixel {x}, {y} of the {} side", if pick.side == 0 { "left" } else { "right" }));
            if lights.len() > 1 {
                menu(ui, lights, &mut light);
            }
            match pick.answer() {
                None => drop(ui.horizontal(|ui| {
                    ui.spinner();
                    ui.label("reading maps and tracing rays");
                })),
                Some(Answer::Why(why)) => answer(ui, why),
                Some(none) => drop(ui.label(none.to_string())),
            }
        },
    );
    if !is_open {
        return None;
    }
    Some(if light == pick.light { pick } else { pick.of_light(light) })
}

fn menu(ui: &mut egui::Ui, lights: &[String], light: &mut usize) {
    let name = lights.get(*light).map_or("", String::as_str);
    let menu = egui::ComboBox::from_id_salt("why light").selected_text(name).show_ui(ui, |ui| {
        for (i, name) in lights.iter().enumerate() {
            ui.selectable_value(light, i, name);
        }
    });
    menu.response.on_hover_text("The light whose shadow is asked about.");
}

fn answer(ui: &mut egui::Ui, why: &Why) {
    let colour = if why.verdict.is_wrong() { ui.visuals().warn_fg_color } else { ui.visuals().text_color() };
    ui.add(egui::Label::new(egui::RichText::new(why.cause.to_string()).color(colour)).wrap());
    ui.separator();
    egui::Grid::new("why").num_columns(2).striped(true).show(ui, |ui| {
        for (name, value, help) in rows(why) {
            ui.label(name).on_hover_text(help);
            ui.add(egui::Label::new(egui::RichText::new(value).monospace()).wrap());
            ui.end_row();
        }
    });
}

/// The figures: name, value and help.
fn rows(why: &Why) -> Vec<(&'static str, String, &'static str)> {
    let metres = |blocker: Option<f64>| {
        blocker.map_or("nothing in the way".to_owned(), |metres| format!("blocked {metres:.3} m away"))
    };
    let truth = match why.truth {
        Pixel::Partial(share) => format!("{:.0} % lit, {}", share * 100.0, metres(why.blocker)),
        _ => metres(why.blocker),
    };
    let shown = format!("{:.0} % lit", why.shown * 100.0);
    let mut rows = vec![
        ("picture", shown, "How much of the light the picture lets through here."),
        ("truth", truth, "What a ray from here to the light meets."),
    ];
    match &why.map {
        Some(map) => rows.extend(map_rows(map)),
        None => rows.push(("view", "none".to_owned(), "No shadow map serves this place.")),
    }
    rows
}

fn map_rows(map: &MapSays) -> Vec<(&'static str, String, &'static str)> {
    let MapSays { view, texel, side, texel_metres, stored, compare, asked, bias, blocker, is_flattened } =
        map;
    let stored = stored.map_or("not read".to_owned(), |stored| format!("{stored:.6}"));
    let blocker = match blocker {
        Some(metres) if *is_flattened => {
            format!("{metres:.3} m in front or farther: it is flattened onto the near plane")
        }
        Some(metres) if *metres > 0.0 => format!("{metres:.3} m in front"),
        Some(metres) => format!("{:.3} m behind", -metres),
        None => "nothing".to_owned(),
    };
    let stands_off = format!(
        "{bias:.4} m (asked: {:.4} m along the normal, {:.4} m toward the light)",
        asked.along_normal, asked.toward_light
    );
    vec![
        ("view", view.clone(), "The view whose map serves this place."),
        (
            "texel",
            format!(
                "{:.2}, {:.2} of {side}, {:.4} m × {:.4} m",
                texel.x, texel.y, texel_metres.x, texel_metres.y
            ),
            "The place in the map, and the sides of a texel across the light.",
        ),
        ("stored depth", stored, "The depth in the texel: 1 near the light, 0 far."),
        (
            "compare depth",
            format!("{compare:.6}"),
            "The depth of this place, moved by the bias: shadow where the stored one is larger.",
        ),
        (
            "bias",
            stands_off,
            "How far the lookup is offset from the surface in all, rounding included, toward the light.",
        ),
        ("map's blocker", blocker, "What the texel holds, measured from the surface along the light."),
    ]
}
