//! A share of an experiment's runs, for one of several processes or machines.

use std::fmt;
use std::str::FromStr;

use crate::Entry;

/// A shard is one share of a number of equal ones, written `2/8` for the second of eight.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Which share, from 1.
    index: u32,
    /// The number of shares.
    count: u32,
}

/// An error of words that name no shard.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("wanted which share of how many, as 2/8 for the second of eight, got `{0}`")]
pub struct NoShard(String);

impl Shard {
    /// Returns the runs of this share, which are neighbours, as are runs that share a truth. All shares together are all runs,
    /// and none has two more than another.
    pub fn of(self, entries: &[Entry]) -> &[Entry] {
        let end_of = |share: u32| (u64::from(share) * entries.len() as u64 / u64::from(self.count)) as usize;
        &entries[end_of(self.index - 1)..end_of(self.index)]
    }
}

impl FromStr for Shard {
    type Err = NoShard;

    fn from_str(words: &str) -> Result<Self, NoShard> {
        let number = |word: &str| word.trim().parse().ok();
        let numbers = words.split_once('/').and_then(|(index, count)| number(index).zip(number(count)));
        match numbers {
            Some((index, count)) if (1..=count).contains(&index) => Ok(Self { index, count }),
            Some(_) | None => Err(NoShard(words.to_owned())),
        }
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.count)
    }
}
