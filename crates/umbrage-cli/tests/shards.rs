//! A report in shares: the same page as from one process, and one line where shares do not make it whole.

mod common;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::thread::sleep;
use std::time::{Duration, SystemTime};
use std::{fs, io};

use common::{stdout, text, umbrage};
use tempfile::TempDir;

/// Eight runs: two cameras, two repeats, two variants. Nothing is timed, so that all is the same each time.
const EXPERIMENT: &str = r#"title = "A small experiment"
source = "this project"
worlds = ["primitives"]
cameras = ["main", "close"]
size = [96, 54]
repeats = 2
columns = ["error.mis_shadowed", "bytes"]
enlarged = { primitives = [20, 10, 40, 30] }

[[variants]]
name = "coarse"
set = { resolution = 128 }

[[variants]]
name = "fine"
"#;

/// A folder with an experiment, and what commands leave there.
struct Bench {
    folder: TempDir,
}

impl Bench {
    fn new() -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        fs::write(folder.path().join("small.toml"), EXPERIMENT).expect("written");
        Self { folder }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// The words of a report into a folder.
    fn words(&self, into: &str, more: &[&str]) -> Vec<String> {
        let (experiment, output) = (self.path("small.toml"), self.path(into));
        let words = ["report", text(&experiment), "-o", text(&output)];
        words.iter().chain(more).map(|word| (*word).to_owned()).collect()
    }

    fn report(&self, into: &str, more: &[&str]) {
        let words = self.words(into, more);
        stdout(&words.iter().map(String::as_str).collect::<Vec<_>>());
    }

    fn merge(&self, into: &str, from: &[&str]) -> Result<(), String> {
        self.refusal(&self.words(into, &["--merge"]), from)
    }

    /// The error of a command that fails, which must be one line.
    fn refusal(&self, words: &[String], folders: &[&str]) -> Result<(), String> {
        let folders: Vec<PathBuf> = folders.iter().map(|name| self.path(name)).collect();
        let words = words.iter().map(String::as_str).chain(folders.iter().map(|path| text(path)));
        let output = umbrage(&words.collect::<Vec<_>>());
        if output.status.success() {
            return Ok(());
        }
        let stderr = String::from_utf8(output.stderr).expect("text");
        let errors: Vec<&str> = stderr.lines().filter(|line| line.starts_with("error:")).collect();
        assert!(errors.len() == 1 && !stderr.contains("panicked"), "{stderr}");
        Err(errors[0].to_owned())
    }

    /// Everything that a report leaves, by its path in the folder, but for the results.
    fn left(&self, of: &str) -> Vec<(PathBuf, Vec<u8>)> {
        let mut left = Vec::new();
        let mut folders = vec![self.path(of)];
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(folder).expect("a folder") {
                let path = entry.expect("an entry").path();
                let name = path.strip_prefix(self.path(of)).expect("below it").to_owned();
                match path.is_dir() {
                    true if name == Path::new("runs") => {}
                    true => folders.push(path),
                    false => left.push((name, fs::read(path).expect("read"))),
                }
            }
        }
        left.sort();
        left
    }

    /// The files of all results, and when each was written.
    fn times(&self, of: &str) -> BTreeSet<(PathBuf, SystemTime)> {
        let files = fs::read_dir(self.path(of).join("runs")).expect("results");
        let time = |path: &Path| fs::metadata(path).and_then(|file| file.modified()).expect("a time");
        files.map(|file| file.expect("a file").path()).map(|path| (path.clone(), time(&path))).collect()
    }

    fn results(&self, of: &str) -> usize {
        let files = fs::read_dir(self.path(of).join("runs")).expect("results");
        files
            .filter(|file| file.as_ref().expect("a file").path().extension().is_some_and(|end| end == "json"))
            .count()
    }
}

/// What a program that was just written prints. Whatever else starts a program at that time holds the file open for a moment, so that
/// it cannot run yet.
fn ran(command: &mut Command) -> Output {
    for _ in 0..1000 {
        match command.output() {
            Err(error) if error.kind() == io::ErrorKind::ExecutableFileBusy => {
                sleep(Duration::from_millis(10));
            }
            output => return output.expect("it runs"),
        }
    }
    panic!("the program is still being written after ten seconds");
}

#[test]
fn shards_and_a_merge_are_the_page_of_one_process() {
    let bench = Bench::new();
    bench.report("whole", &[]);
    bench.report("a", &["--shard", "1/3"]);
    bench.report("b", &["--shard", "2/3"]);
    assert_eq!([bench.results("a"), bench.results("b")], [2, 3]);
    assert!(bench.left("a").is_empty(), "a shard writes no page");

    let why = bench.merge("merged", &["a", "b"]).expect_err("a third is missing");
    let wanted = "error: 3 of 8 runs are in none of the stores: `fine` in primitives from close, repeat 0; \
                  `coarse` in primitives from close, repeat 1; `fine` in primitives from close, repeat 1; what there is lies in";
    assert!(why.starts_with(wanted) && why.contains("`umbrage report"), "{why}");
    assert!(bench.left("merged").is_empty(), "no page of a part");
    assert_eq!(bench.results("merged"), 5, "what there is was taken");

    // What is missing is added, and what was taken before is still there, as it was.
    let before = bench.times("merged");
    bench.report("c", &["--shard", "3/3"]);
    bench.merge("merged", &["a", "c"]).expect("it is whole now");
    let after = bench.times("merged");
    assert!(before.iter().all(|file| after.contains(file)), "nothing that was there is written again");
    assert!(bench.left("merged") == bench.left("whole"), "the same page, figures, sheet and tables");

    // Or by the words of the error.
    bench.merge("mended", &["a", "b"]).expect_err("a third is missing");
    bench.report("mended", &[]);
    assert!(bench.left("mended") == bench.left("whole"));
}

#[test]
fn shards_may_share_a_folder() {
    let bench = Bench::new();
    for shard in ["1/2", "2/2"] {
        bench.report("shared", &["--shard", shard]);
    }
    assert_eq!(bench.results("shared"), 8);
    let before = bench.times("shared");
    bench.report("shared", &[]);
    assert_eq!(bench.times("shared"), before, "nothing is measured again");
    assert!(bench.path("shared").join("small.html").is_file());
}

#[test]
fn words_that_name_no_shard_are_refused() {
    let bench = Bench::new();
    for wrong in ["0/3", "4/3", "a/b", "3"] {
        let why = bench.refusal(&bench.words("out", &["--shard", wrong]), &[]).expect_err(wrong);
        assert!(why.contains("as 2/8 for the second of eight"), "{why}");
    }
    let both = bench.words("out", &["--shard", "1/2", "--merge"]);
    assert!(bench.refusal(&both, &["a"]).expect_err("both").contains("cannot be used with"));
    assert!(!bench.path("out").exists());
}

#[test]
fn stores_of_other_experiments_programs_and_adapters_are_refused_with_what_to_do() {
    let bench = Bench::new();
    bench.report("a", &["--shard", "1/2"]);
    let none = bench.merge("out", &["nowhere"]).expect_err("no folder");
    assert!(
        none.contains("no results to merge: give the folder that a shard was written to")
            && none.contains("nowhere"),
        "{none}"
    );

    // Another build: the same program with a byte behind its end, which nobody reads.
    let other = bench.path("other-build");
    let own = fs::read(env!("CARGO_BIN_EXE_umbrage")).expect("the program");
    fs::write(&other, [&own[..], b"\n"].concat()).expect("written");
    fs::set_permissions(&other, fs::metadata(env!("CARGO_BIN_EXE_umbrage")).expect("there").permissions())
        .expect("set");
    let words = bench.words("b", &["--shard", "2/2"]);
    let output = ran(Command::new(&other).args(&words));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let why = bench.merge("out", &["b"]).expect_err("another program's");
    assert!(
        why.contains("4 results of this experiment were made by another program, and none by this one"),
        "{why}"
    );
    let why = bench.merge("out", &["a", "b"]).expect_err("half of it is another program's");
    assert!(
        why.contains("4 of 8 runs") && why.contains("4 results there were made by another program"),
        "{why}"
    );

    let why = bench
        .refusal(&bench.words("out", &["--adapter", "Voodoo", "--merge"]), &["a"])
        .expect_err("no such adapter");
    assert!(why.contains("--adapter") && why.contains("`voodoo`; they are by "), "{why}");

    // GL's driver and Vulkan's are two adapters, whatever draws.
    bench.report("gl", &["--adapter", "gl", "--shard", "2/2"]);
    let why = bench.merge("out", &["a", "gl"]).expect_err("two adapters");
    assert!(
        why.contains("--adapter: results are by 2 adapters") && why.contains("name one of them"),
        "{why}"
    );
    // What another adapter left in the output is no reason not to merge.
    let why = bench.merge("gl", &["a"]).expect_err("half of it is missing");
    assert!(why.contains("4 of 8 runs are in none of the stores"), "{why}");

    fs::write(bench.path("small.toml"), EXPERIMENT.replace("[96, 54]", "[97, 54]")).expect("written");
    let why = bench.merge("elsewhere", &["a", "b"]).expect_err("another experiment's");
    assert!(why.contains("none of 8 results is of this experiment as it is written now"), "{why}");
}
