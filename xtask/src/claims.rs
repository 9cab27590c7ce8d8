//! `docs/claims.md`: which of the papers' claims hold here, as the pages of `umbrage report` have it.

use std::fmt::Write as _;
use std::path::Path;

use anyhow::Context as _;

use crate::command::{root, umbrage};

/// The experiments whose claims are told, in order, each with what it comes to.
const EXPERIMENTS: [(&str, &str); 3] = [
    ("zhang-table-1", include_str!("claims/zhang-table-1.md")),
    ("dueling-frusta", include_str!("claims/dueling-frusta.md")),
    ("zhang-figure-8", include_str!("claims/zhang-figure-8.md")),
];
const FOLDER: &str = "target/report";

/// Runs the experiments, unless `pages` is a folder that has their pages already, and writes the document.
pub fn write(adapter: Option<&str>, pages: Option<&Path>) -> anyhow::Result<()> {
    if pages.is_none() {
        for (name, _) in EXPERIMENTS {
            let experiment = format!("experiments/{name}.toml");
            let mut args = vec!["report", &experiment, "-o", FOLDER];
            args.extend(adapter.iter().flat_map(|adapter| ["--adapter", adapter]));
            umbrage(&args)?;
        }
    }
    let folder = root().join(pages.unwrap_or(Path::new(FOLDER)));
    let mut text = "# Which claims hold here\n\n\
        Written by `cargo xtask claims`; do not edit. `umbrage report experiments/NAME.toml -o DIR` makes each page with \
        its pictures.\n\n\
        A ratio is the mean over jittered cameras, both ways drawn from the same one, with half its 95 % interval. \
        A claim holds where the whole interval is at most what is claimed.\n"
        .to_owned();
    for (name, found) in EXPERIMENTS {
        let page = std::fs::read_to_string(folder.join(format!("{name}.html")))
            .with_context(|| format!("no page {name}.html in {}", folder.display()))?;
        text += &chapter(name, found, &page).with_context(|| format!("the page of {name} lacks a part"))?;
    }
    let path = root().join("docs/claims.md");
    let draft = path.with_extension("md.new");
    std::fs::write(&draft, text)?;
    std::fs::rename(draft, path)?;
    Ok(())
}

/// One experiment: its claims, its figures, and what it was made with.
fn chapter(name: &str, found: &str, page: &str) -> Option<String> {
    let title = plain(between(page, "<h1>", "</h1>")?);
    let mut text = format!("\n## {title}\n\n`experiments/{name}.toml`\n\n{}\n", found.trim());
    text += &said(page)?;
    text += "\n### Figures\n\n";
    text += &table(section(page, "table")?);
    text += "\n### Made with\n\n";
    text += &table(section(page, "machines")?);
    Some(text)
}

/// The claims of a page, each with whether it holds and the table of its figures.
pub fn said(page: &str) -> Option<String> {
    let mut text = String::new();
    for article in section(page, "claims")?.split("<article").skip(1) {
        let heading = between(article, "<h3>", "</h3>")?;
        let (badge, says) = heading.split_once("</span>")?;
        let _ = write!(text, "\n**{}** — {}\n\n", plain(says), plain(badge));
        text += &table(article);
    }
    Some(text)
}

fn section<'a>(page: &'a str, id: &str) -> Option<&'a str> {
    between(page, &format!("<section id=\"{id}\">"), "</section>")
}

fn between<'a>(text: &'a str, start: &str, end: &str) -> Option<&'a str> {
    let from = text.find(start)? + start.len();
    Some(&text[from..from + text[from..].find(end)?])
}

/// The first table of some HTML as Markdown; empty where there is none. A cell over many columns is bold.
fn table(html: &str) -> String {
    let Some(table) = between(html, "<table>", "</table>") else { return String::new() };
    let rows: Vec<Vec<String>> = table.split("<tr").skip(1).map(cells).collect();
    let columns = rows.first().map_or(0, Vec::len);
    let mut text = String::new();
    for (i, row) in rows.iter().enumerate() {
        let row = match row.as_slice() {
            [place] if columns > 1 => format!("**{place}**{}", " |".repeat(columns - 1)),
            cells => cells.join(" | "),
        };
        let _ = writeln!(text, "| {row} |");
        if i == 0 {
            let _ = writeln!(text, "|{}", "---|".repeat(columns));
        }
    }
    text
}

fn cells(row: &str) -> Vec<String> {
    let row = row.split("</tr>").next().unwrap_or_default();
    let starts =
        row.match_indices("<t").filter(|(i, _)| matches!(row.as_bytes().get(i + 2), Some(b'd' | b'h')));
    let starts: Vec<usize> = starts.map(|(i, _)| i).collect();
    let ends = starts.iter().skip(1).copied().chain([row.len()]);
    starts.iter().zip(ends).map(|(start, end)| plain(&row[*start..end])).collect()
}

/// The words of some HTML, without its tags.
fn plain(html: &str) -> String {
    let mut text = String::new();
    let mut is_tag = false;
    for letter in html.chars() {
        match letter {
            '<' => {
                is_tag = true;
                text.push(' ');
            }
            '>' => is_tag = false,
            letter if !is_tag => text.push(letter),
            _ => {}
        }
    }
    // A heading may begin in the middle of a tag.
    let text = match (html.find('>'), html.find('<')) {
        (Some(end), start) if start.is_none_or(|start| end < start) => plain(&html[end + 1..]),
        _ => text,
    };
    let words: Vec<&str> = text.split_whitespace().collect();
    let mut text = words.join(" ");
    // An ampersand last: what it begins is no entity.
    for (entity, letter) in
        [("&#8239;", " "), ("&#39;", "'"), ("&quot;", "\""), ("&lt;", "<"), ("&gt;", ">"), ("&amp;", "&")]
    {
        text = text.replace(entity, letter);
    }
    text.replace('|', "\\|")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_of_a_page_becomes_markdown() {
        let html = "<p>x</p><table>\n<thead><tr><th>way</th><th class=\"n\">error<br><small>px</small></th></tr></thead>\
                    <tbody><tr class=\"place\"><th colspan=\"2\">a <span>from b</span></th></tr>\
                    <tr><td>one</td><td class=\"n\">1.5 <small>± 0.1</small></td></tr></tbody></table>";
        assert_eq!(table(html), "| way | error px |\n|---|---|\n| **a from b** | |\n| one | 1.5 ± 0.1 |\n");
        assert_eq!(table("<p>none</p>"), "");
    }

    #[test]
    fn a_chapter_says_of_each_claim_whether_it_holds() {
        let page = "<h1>Four &amp; one</h1><section id=\"claims\"><article class=\"claim\"><h3><span class=\"badge\">holds\
                    </span> Four are better.</h3><table><tr><th>world</th></tr></table></article></section>\
                    <section id=\"table\"><table></table></section><section id=\"machines\"></section>";
        let text = chapter("zhang-table-1", "Four are.", page).unwrap_or_default();
        assert!(
            text.contains("## Four & one")
                && text.contains("Four are.")
                && text.contains("**Four are better.** — holds"),
            "{text}"
        );
        assert_eq!(chapter("x", "", "<h1>only a title</h1>"), None);
    }
}
