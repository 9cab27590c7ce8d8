//! A scene as bytes, and back: for another instance of the same program, such as a worker of a browser, with which nothing
//! else can be shared. No file has them, and another version of the program does not know them.
//!
//! Numbers are little-endian, lists begin with their length, and what is one of several kinds with the kind's number.

mod numbers;
mod parts;

use crate::Imported;

/// What can be written as bytes and read again.
trait Bytes: Sized {
    fn write(&self, out: &mut Vec<u8>);

    /// Reads from where the bytes begin, and leaves what follows. `None` where they end early or say nothing known.
    fn read(from: &mut &[u8]) -> Option<Self>;

    fn write_all(list: &[Self], out: &mut Vec<u8>) {
        list.iter().for_each(|one| one.write(out));
    }

    fn read_all(count: usize, from: &mut &[u8]) -> Option<Vec<Self>> {
        // Grows with what is there, whatever the count says.
        (0..count).map(|_| Self::read(from)).collect()
    }
}

impl Imported {
    /// Returns the scene and the warnings as bytes, which the same version of this program can read.
    pub fn to_bytes(&self) -> Vec<u8> {
        let Self { scene, warnings } = self;
        let mut out = Vec::new();
        scene.write(&mut out);
        warnings.write(&mut out);
        out
    }

    /// Reads what [`Self::to_bytes`] has written; `None` where the bytes are something else.
    pub fn from_bytes(mut bytes: &[u8]) -> Option<Self> {
        let (scene, warnings) = <(_, _)>::read(&mut bytes)?;
        bytes.is_empty().then_some(Self { scene, warnings })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::worlds;

    fn text(imported: &Imported) -> String {
        format!("{imported:?}")
    }

    #[test]
    fn every_world_comes_back_as_it_was() {
        for world in worlds::ALL {
            // The large ones hold nothing that the small ones do not.
            let scene = worlds::build(world.name, 0).expect("it is built in");
            if scene.meshes.iter().map(|mesh| mesh.positions.len()).sum::<usize>() > 100_000 {
                continue;
            }
            let imported = Imported { scene, warnings: vec!["a warning: this".to_owned()] };
            let again = Imported::from_bytes(&imported.to_bytes()).expect("the same");
            assert_eq!(text(&again), text(&imported), "{}", world.name);
        }
    }

    #[test]
    fn bytes_that_are_cut_or_go_on_are_no_scene() {
        let imported =
            Imported { scene: worlds::build("primitives", 0).expect("it is built in"), warnings: Vec::new() };
        let bytes = imported.to_bytes();
        for cut in (0..bytes.len()).step_by(bytes.len() / 500 + 1) {
            assert!(Imported::from_bytes(&bytes[..cut]).is_none(), "{cut} bytes");
        }
        assert!(Imported::from_bytes(&[&bytes[..], &[0]].concat()).is_none());
        // A list that says it has no end.
        assert!(Imported::from_bytes(&[0xff; 64]).is_none());
    }
}
