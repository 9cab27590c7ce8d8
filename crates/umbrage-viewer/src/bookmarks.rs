//! Cameras that someone saved under a name. A bookmark is a link to one place of one world.
//!
//! They are kept for the next time (`keep.rs`).

use serde::{Deserialize, Serialize};

use crate::keep;

/// Bookmarks are kept under this name.
const FILE: &str = "bookmarks.toml";

/// A bookmark is the camera at one place of one world, under a name.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Bookmark {
    /// The bookmark's name.
    pub name: String,
    /// The name of the world, or of the file that it came from.
    pub world: String,
    /// The camera, as the query of a link.
    pub camera: String,
}

/// The bookmarks of all worlds, in the order in which they were saved.
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

    /// Makes a change of what is kept, to which another window may have added since, and takes over all of that.
    ///
    /// # Errors
    /// In one line, when what is kept cannot be read, and stays as it is, or cannot be written.
    pub fn keep(&mut self, change: impl Fn(&mut Self)) -> Result<(), String> {
        let kept = || {
            let text = keep::read(FILE)?;
            let changed = Self::changed(text.as_deref(), change)?;
            keep::write(FILE, &changed.text()).map(|()| changed)
        };
        *self = kept().map_err(|why| format!("the bookmarks are not kept for the next time: {why}"))?;
        Ok(())
    }

    /// What is kept, with a change.
    fn changed(text: Option<&str>, change: impl Fn(&mut Self)) -> Result<Self, String> {
        let mut kept = text.map_or(Ok(Self::default()), Self::parse)?;
        change(&mut kept);
        Ok(kept)
    }

    fn parse(text: &str) -> Result<Self, String> {
        toml::from_str(text).map_err(|why| {
            let why = why.message().replace('\n', " ");
            format!("the saved bookmarks cannot be read, and stay as they are: {why}: {}", keep::place(FILE))
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
        assert!(Bookmarks::changed(Some("bookmark = 3"), |all| all.bookmark.clear()).is_err(), "it stays");
    }

    #[test]
    fn what_another_window_has_saved_stays() {
        let save = |text: Option<&str>, name: &str| {
            let bookmark = bookmark(name, "grove", "?camera=1");
            Bookmarks::changed(text, |all| all.save(bookmark.clone())).expect("bookmarks")
        };
        let one = save(None, "tree").text();
        let both = save(Some(&one), "brook");
        assert_eq!(
            both.of("grove").map(|bookmark| &bookmark.name[..]).collect::<Vec<_>>(),
            ["tree", "brook"]
        );
    }
}
