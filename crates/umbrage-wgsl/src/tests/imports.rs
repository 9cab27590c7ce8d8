//! A text is one module to others' module systems.

use naga_oil::compose::{ComposableModuleDescriptor, Composer, NagaModuleDescriptor};
use umbrage_core::{Filter, Pcss, Settings, Variance};

use crate::{ShaderKey, TextureSupport, receiver};

#[test]
fn a_receivers_text_is_imported_through_naga_oil() {
    let main = "
        #import umbrage::{umbrage_visibility, umbrage_shade}

        @fragment
        fn main(@location(0) position: vec3f, @location(1) normal: vec3f, @builtin(position) pixel: vec4f)
            -> @location(0) vec4f
        {
            let visibility = umbrage_visibility(position, normal, pixel.xy);
            return vec4f(umbrage_shade(vec3f(0.1), vec3f(0.9), visibility), 1.0);
        }";
    let filters =
        [Settings::default().filter, Filter::Pcss(Pcss::default()), Filter::Vsm(Variance::default())];
    for filter in filters {
        let key = ShaderKey::new(&Settings { filter, ..Settings::default() }, TextureSupport::ALL);
        let text = receiver(&key, 2);
        let mut composer = Composer::default();
        let added = composer.add_composable_module(ComposableModuleDescriptor {
            source: &text,
            file_path: "umbrage.wgsl",
            as_name: Some("umbrage".to_owned()),
            ..Default::default()
        });
        added.unwrap_or_else(|error| panic!("{filter:?}: {error:?}"));
        let module = composer.make_naga_module(NagaModuleDescriptor {
            source: main,
            file_path: "main.wgsl",
            ..Default::default()
        });
        let module = module.unwrap_or_else(|error| panic!("{filter:?}: {error:?}"));
        let groups: Vec<u32> =
            module.global_variables.iter().filter_map(|(_, v)| Some(v.binding.as_ref()?.group)).collect();
        assert!(groups.len() >= 2 && groups.iter().all(|group| *group == 2), "{filter:?}: {groups:?}");
    }
}
