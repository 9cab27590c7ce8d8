//! The pictures of the documents.

use crate::command::{root, umbrage};

/// World, camera and file of every single picture.
const PICTURES: &[(&str, &str, &str)] = &[
    ("mining-terrain", "main", "mining-terrain"),
    ("survey", "main", "survey"),
    ("grove", "main", "grove"),
    ("village-fair", "main", "village-fair"),
    ("atrium", "main", "atrium"),
    ("knights", "main", "knights"),
    ("huge-chessboard", "main", "huge-chessboard"),
    ("robot-war", "main", "robot-war"),
    ("brick-ground", "main", "brick-ground"),
    ("primitives", "main", "primitives"),
    ("bunny", "main", "bunny"),
    ("dragon", "main", "dragon"),
    ("orbit", "main", "orbit"),
    ("tutorial-room", "main", "tutorial-room"),
    ("closed-room", "main", "closed-room"),
    ("night-chessboard", "main", "night-chessboard"),
    ("bias-court", "main", "bias-court"),
];

pub fn draw() -> anyhow::Result<()> {
    std::fs::create_dir_all(root().join("docs/pictures"))?;
    umbrage(&["demo", "--no-window", "-o", "docs/pictures/demo.png"])?;
    for (world, camera, file) in PICTURES {
        let output = format!("docs/pictures/{file}.png");
        let size = if *file == "mining-terrain" { "1280x720" } else { "640x360" };
        umbrage(&["render", world, "--camera", camera, "--size", size, "-o", &output])?;
    }
    let aliasing = "docs/pictures/aliasing.png";
    umbrage(&["render", "mining-terrain", "--size", "640x360", "--aliasing", aliasing])?;
    Ok(())
}
