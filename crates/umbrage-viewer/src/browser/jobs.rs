//! What a page gives to a worker: to build a BVH or what rays go through, and to read a file.

use umbrage_judge::{Triangles, World};
use umbrage_render::RayCasters;
use umbrage_scene::{Imported, Scene, Texture};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;
use web_sys::js_sys::{Function, Uint8Array};

use super::worker::{Unanswered, answer};
use crate::load;
use crate::said::Said;

/// Builds the BVH of triangles, both as bytes. The worker runs it.
///
/// # Errors
/// When the bytes are no triangles.
#[wasm_bindgen]
pub fn build_bvh(_name: &str, triangles: &[u8]) -> Result<Vec<u8>, String> {
    let triangles = Triangles::from_bytes(triangles).ok_or("these are no triangles")?;
    Ok(World::build(triangles).to_bytes())
}

/// Makes the casters of a scene ready for rays, both as bytes. The worker runs it.
///
/// # Errors
/// When the bytes are no scene.
#[wasm_bindgen]
pub fn build_casters(_name: &str, scene: &[u8]) -> Result<Vec<u8>, String> {
    let Imported { scene, warnings: _ } = Imported::from_bytes(scene).ok_or("these are no scene")?;
    Ok(RayCasters::of(&scene).to_bytes())
}

/// Reads the file of a world, and gives it as bytes. The worker runs it, and `tell` gets words on the way.
///
/// # Errors
/// When the file holds no world, in one line.
#[wasm_bindgen]
pub fn read_world(name: &str, bytes: &[u8], tell: &Function) -> Result<Vec<u8>, String> {
    let imported = load::of_bytes(name, bytes, &|step| {
        // Nobody may listen.
        let _ = tell.call1(&JsValue::NULL, &step.to_string().into());
    })?;
    Ok(imported.to_bytes())
}

/// Builds the BVH of triangles in a worker. Where the browser starts none, the page stands still meanwhile.
///
/// # Errors
/// When the worker dies of it, as of too many triangles: the page would, too.
pub async fn build_bvh_beside(triangles: impl Fn() -> Triangles) -> Result<World, String> {
    // Only their bytes are kept while the worker is busy.
    let bytes = Uint8Array::from(triangles().to_bytes().as_slice());
    match answer("build_bvh", "", &bytes, |_| ()).await {
        Ok(world) => World::from_bytes(&world).ok_or_else(|| "the worker's answer is no world".into()),
        Err(Unanswered::Died(words)) => Err(format!("the BVH was not built: {words}")),
        Err(Unanswered::NoWorker(why)) => {
            web_sys::console::warn_2(&"the page builds the BVH itself:".into(), &why);
            Ok(World::build(triangles()))
        }
    }
}

/// Makes the casters of a scene ready for rays in a worker. Where the browser starts none, the page stands still meanwhile.
///
/// # Errors
/// When the worker dies of it, as of too many triangles: the page would, too.
pub async fn build_casters_beside(scene: &Scene) -> Result<RayCasters, String> {
    // Only their bytes are kept while the worker is busy.
    let bytes =
        Uint8Array::from(Imported { scene: of_rays(scene), warnings: Vec::new() }.to_bytes().as_slice());
    match answer("build_casters", "", &bytes, |_| ()).await {
        Ok(casters) => RayCasters::from_bytes(scene, &casters)
            .ok_or_else(|| "the worker's answer is not what rays go through".into()),
        Err(Unanswered::Died(words)) => Err(words),
        Err(Unanswered::NoWorker(why)) => {
            web_sys::console::warn_2(&"the page builds what rays go through itself:".into(), &why);
            Ok(RayCasters::of(scene))
        }
    }
}

/// A scene without the pictures of solid surfaces, at which no ray looks.
fn of_rays(scene: &Scene) -> Scene {
    let is_looked_at = |i: usize| scene.materials.iter().any(|it| !it.is_solid() && it.texture == Some(i));
    let textures = scene.textures.iter().enumerate().map(|(i, texture)| match is_looked_at(i) {
        true => texture.clone(),
        false => Texture { name: String::new(), width: 0, height: 0, rgba: Vec::new() },
    });
    let Scene { meshes, instances, materials, rig, .. } = scene;
    Scene {
        meshes: meshes.clone(),
        instances: instances.clone(),
        materials: materials.clone(),
        textures: textures.collect(),
        rig: rig.clone(),
        ..Scene::default()
    }
}

/// Reads the file of a world in a worker. Where the browser starts none, the page stands still meanwhile.
///
/// # Errors
/// When the file holds no world, or the worker dies of it, in one line.
pub async fn read_world_beside(name: &str, bytes: &[u8], said: &Said) -> Result<Imported, String> {
    let copy = Uint8Array::from(bytes);
    let words = said.clone();
    match answer("read_world", name, &copy, move |step| words.say(step)).await {
        Ok(world) => Imported::from_bytes(&world).ok_or_else(|| "the worker's answer is no world".into()),
        Err(Unanswered::Died(words)) => Err(words),
        Err(Unanswered::NoWorker(why)) => {
            web_sys::console::warn_2(&"the page reads the file itself:".into(), &why);
            load::of_bytes(name, bytes, &|_| ())
        }
    }
}
