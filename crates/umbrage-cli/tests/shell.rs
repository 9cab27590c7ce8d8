//! What a shell and a manual read: completions that load, and a page for each command.

mod common;

use std::process::Command;

use common::{stdout, text};

#[test]
fn bash_loads_its_completions_and_completes_commands_and_flags() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("umbrage.bash");
    std::fs::write(&path, stdout(&["completions", "bash"])).expect("written");
    // What bash offers after `umbrage WORDS`, when the last of them is being written.
    let offered = |words: &str| {
        let words: Vec<&str> = std::iter::once("umbrage").chain(words.split(' ')).collect();
        let last = words.len() - 1;
        let script = format!(
            "source {}; COMP_WORDS=({}); COMP_CWORD={last}; _umbrage umbrage '{}' '{}'; echo \"${{COMPREPLY[@]}}\"",
            path.display(),
            words.join(" "),
            words[last],
            words[last - 1],
        );
        let output = Command::new("bash").args(["--norc", "-c", &script]).output().expect("bash runs");
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && stderr.is_empty(), "{words:?}: {stderr}");
        String::from_utf8(output.stdout)
            .expect("text")
            .split_whitespace()
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    assert_eq!(offered("rend"), ["render"]);
    assert_eq!(offered("measure --se"), ["--seed", "--set"]);
    assert_eq!(offered("measure --truth s"), ["sub-pixel", "soft"]);
}

#[test]
fn every_shell_has_completions() {
    for (shell, says) in [
        ("zsh", "#compdef umbrage"),
        ("fish", "complete -c umbrage"),
        ("powershell", "Register-ArgumentCompleter"),
        ("elvish", "edit:completion:arg-completer[umbrage]"),
    ] {
        let text = stdout(&["completions", shell]);
        assert!(text.contains(says) && text.contains("measure") && text.contains("preset"), "{shell}");
    }
}

#[test]
fn every_command_has_a_page_that_says_what_its_words_are() {
    let folder = tempfile::tempdir().expect("a folder");
    stdout(&["man", "-o", text(folder.path())]);
    let page = |name: &str| {
        std::fs::read_to_string(folder.path().join(name)).unwrap_or_else(|why| panic!("{name}: {why}"))
    };
    for command in ["render", "measure", "report", "worlds", "worlds-export", "completions"] {
        let page = page(&format!("umbrage-{command}.1"));
        assert!(page.contains(&format!(".TH umbrage-{command} 1")), "{command}: {page}");
        let sections: Vec<&str> = page.lines().filter_map(|line| line.strip_prefix(".SH ")).collect();
        assert!(sections.starts_with(&["NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS"]), "{sections:?}");
        assert!(
            page.lines().all(|line| line.is_ascii() || !line.starts_with('.')),
            "{command}: macros are plain"
        );
    }
    assert!(page("umbrage-measure.1").contains("\\-\\-set"), "a flag with its dashes");
    assert_eq!(page("umbrage.1"), stdout(&["man"]), "the same page, printed");
    assert!(page("umbrage.1").contains("umbrage\\-render(1)"), "it points at the others");
    let below_a_file = folder.path().join("umbrage.1").join("pages");
    assert_eq!(common::umbrage(&["man", "-o", text(&below_a_file)]).status.code(), Some(1));
}
