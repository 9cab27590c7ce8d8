//! Cameras that someone saved under a name. A bookmark is a link to one place of one world.
//!
//! They are kept for the next time (`keep.rs`).

use serde::{Deserialize, Serialize};

use crate::keep;

/// The name that they are kept under.
const FILE: &str = "bookmarks.toml";

/// A place under a name.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Bookmark {
    /// The name.
    pub name: String,
    /// The name of the world, or of the file that it came from.
    pub world: String,
    /// The camera, as the query of a link.
    pub camera: String,
}

/// All of them, in the order in which they were saved.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Bookmarks {
    #[serde(default)]
    bookmark: Vec<Bookmark>,
}

impl Bookmarks {
    /// Reads those that are kept.
    ///
    /// # Errors
    /// In one line, when what is kept is not theirs.
    pub fn read() -> Result<Self, String> {
        keep::read(FILE)?.map_or(Ok(Self::default()), |text| Self::parse(&text))
    }

    /// Keeps them.
    ///
    /// # Errors
    /// In one line, when they cannot be written.
    pub fn write(&self) -> Result<(), String> {
        keep::write(FILE, &self.text())
            .map_err(|why| format!("the bookmarks are not kept for the next time: {why}"))
    }

    fn parse(text: &str) -> Result<Self, String> {
        toml::from_str(text).map_err(|why| {
            let why = why.message().replace('\n', " ");
            format!("the saved bookmarks cannot be read, and the next one that is saved replaces them: {why}")
        })
    }

    fn text(&self) -> String {
        // A table of texts can always be written.
        toml::to_string(self).unwrap_or_default()
    }

    /// Saves a place; one of the same world and name is replaced.
    pub fn save(&mut self, bookmark: Bookmark) {
        match self.bookmark.iter_mut().find(|old| old.name == bookmark.name && old.world == bookmark.world) {
            Some(old) => *old = bookmark,
            None => self.bookmark.push(bookmark),
        }
    }

    /// Deletes a place.
    pub fn delete(&mut self, bookmark: &Bookmark) {
        self.bookmark.retain(|other| other != bookmark);
    }

    /// Returns the places of a world.
    pub fn of<'s>(&'s self, world: &'s str) -> impl Iterator<Item = &'s Bookmark> {
        self.bookmark.iter().filter(move |bookmark| bookmark.world == world)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bookmark(name: &str, world: &str, camera: &str) -> Bookmark {
        Bookmark { name: name.to_owned(), world: world.to_owned(), camera: camera.to_owned() }
    }

    #[test]
    fn what_is_saved_is_read_again_world_by_world() {
        let mut bookmarks = Bookmarks::default();
        bookmarks.save(bookmark("door \"1\"", "knights", "?eye=1,2,3&target=0,0,0"));
        bookmarks.save(bookmark("tree", "grove", "?camera=1"));
        bookmarks.save(bookmark("tree", "grove", "?camera=2"));
        let mut read = Bookmarks::parse(&bookmarks.text()).expect("bookmarks");
        assert_eq!(read, bookmarks);
        let grove: Vec<&Bookmark> = read.of("grove").collect();
        assert_eq!(grove, [&bookmark("tree", "grove", "?camera=2")], "the second replaced the first");
        read.delete(&bookmark("tree", "grove", "?camera=2"));
        assert_eq!((read.of("grove").count(), read.of("knights").count()), (0, 1));
    }

    #[test]
    fn what_is_not_theirs_is_said_in_a_line() {
        let why = Bookmarks::parse("bookmark = 3").expect_err("no bookmarks");
        assert!(why.contains("bookmarks cannot be read") && !why.contains('\n'), "{why}");
    }
}
