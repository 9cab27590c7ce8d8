//! Any bytes, taken for a glTF file, are a scene that can be posed and written again, or one line that says why not.

#![no_main]

mod container;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| container::import(bytes));
