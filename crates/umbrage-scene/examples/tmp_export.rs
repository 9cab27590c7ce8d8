fn main() {
    let t = std::time::Instant::now();
    let mut s = umbrage_scene::worlds::build("survey", 0).unwrap();
    println!(
        "{:?} {} triangles {} instances {} lights",
        t.elapsed(),
        s.triangles(),
        s.instances.len(),
        s.lights.len()
    );
    for m in &s.meshes {
        println!("{} {}", m.name, m.triangles());
    }
    std::fs::write("/tmp/survey/survey.glb", umbrage_scene::to_glb(&s).unwrap()).unwrap();
    let m = glam::Mat4::from_translation(-s.lights[1].position());
    for i in &mut s.instances {
        i.world_from_mesh = m * i.world_from_mesh;
    }
    for i in &mut s.cameras {
        i.world_from_camera = m * i.world_from_camera;
    }
    for i in &mut s.lights {
        i.world_from_light = m * i.world_from_light;
    }
    std::fs::write("/tmp/survey/local.glb", umbrage_scene::to_glb(&s).unwrap()).unwrap();
}
#[allow(dead_code)]
fn unused() {}
