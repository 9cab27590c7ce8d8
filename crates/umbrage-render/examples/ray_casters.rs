//! What rays go through takes so many bytes a triangle, and so long to build: `cargo run --release -p umbrage-render --example
//! ray_casters -- WORLD …`. Triangles are those of each mesh once.

use std::time::Instant;

use umbrage_render::RayCasters;
use umbrage_scene::worlds;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("| world | triangles | bytes a triangle | seconds a million |\n|---|---|---|---|");
    for name in std::env::args().skip(1) {
        let scene = worlds::build(&name, 0).ok_or_else(|| format!("no world is called {name}"))?;
        let start = Instant::now();
        let casters = RayCasters::of(&scene);
        let seconds = start.elapsed().as_secs_f64();
        let triangles = casters.triangles() as f64;
        let bytes = casters.bytes() as f64 / triangles;
        println!("| {name} | {triangles} | {bytes:.1} | {:.2} |", seconds / triangles * 1e6);
    }
    Ok(())
}
