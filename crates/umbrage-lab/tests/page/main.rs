//! Pages, CSV and JSON of rows that no GPU has drawn.

mod fabricate;

use fabricate::{claim, experiment, plot, rows, small};
use umbrage_lab::page::report;
use umbrage_lab::page::verdict::{Verdict, checks};
use umbrage_lab::tabulate::groups;
use umbrage_lab::{Experiment, Plot, Row};

fn page(experiment: &Experiment, rows: &[Row]) -> String {
    report(experiment, "experiments/pssm.toml", rows).unwrap().html
}

/// Fails where tags do not close in the order they open.
fn assert_balanced(html: &str) {
    const VOID: [&str; 4] = ["!DOCTYPE", "meta", "img", "br"];
    let mut open: Vec<&str> = Vec::new();
    for tag in html.split('<').skip(1) {
        let tag = tag.split('>').next().unwrap();
        let name = tag.trim_start_matches('/').split([' ', '\n', '/']).next().unwrap();
        if tag.starts_with('/') {
            assert_eq!(open.pop(), Some(name), "</{name}> closes another");
        } else if !VOID.contains(&name) && !tag.ends_with('/') {
            open.push(name);
        }
    }
    assert!(open.is_empty(), "{open:?} stay open");
}

/// Leaves both pages in the build's temporary folder, to look at.
#[test]
fn pages_and_odd_pages_are_whole() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"));
    let odd = odd();
    let mut odd_rows = rows(&odd);
    for row in odd_rows.iter_mut().filter(|row| row.run.camera == "above") {
        row.outcome.measurement.error = None;
        row.outcome.measurement.flip = None;
    }
    let experiment = experiment();
    for (name, text) in
        [("page.html", page(&experiment, &rows(&experiment))), ("odd.html", page(&odd, &odd_rows))]
    {
        assert!(text.contains("<svg") && text.ends_with("</html>\n"), "{name} is whole");
        std::fs::write(folder.join(name), text).unwrap();
    }
}

/// One repeat, a sweep from 0 on a logarithmic axis, and one of names.
fn odd() -> Experiment {
    let mut odd = Experiment { repeats: 1, ..experiment() };
    odd.worlds.truncate(2);
    let values = [0.0, 0.25, 0.5, 1.0, 2.0, 4.0].map(toml::Value::Float).to_vec();
    odd.variants[3].sweep = Some(umbrage_lab::Sweep { key: "bias.normal".to_owned(), values });
    odd.plots = vec![
        plot("sweep", "error.mis_shadowed", true, false, false),
        plot("truth.pixels", "error.bias", false, true, false),
        plot("sweep", "flicker.flips", false, false, false),
    ];
    odd
}

#[test]
fn bars_stand_over_worlds_one_for_each_variant_that_is_shown() {
    let mut experiment = Experiment { pictures: false, ..experiment() };
    let shown: Vec<String> = experiment.variants[..2].iter().map(|variant| variant.name.clone()).collect();
    experiment.plots = vec![Plot { variants: shown.clone(), ..plot("world", "bytes", false, false, false) }];
    let rows = rows(&experiment);
    let report = report(&experiment, "bars", &rows).unwrap();
    let [svg] = &report.plots[..] else { panic!("one plot") };
    let rectangles = |fill: &str| svg.matches(&format!("fill=\"{fill}\" stroke=\"none\"")).count();
    // A bar for each world, and the square beside the name.
    assert_eq!([rectangles("#0072B2"), rectangles("#D55E00")], [experiment.worlds.len() + 1; 2], "{svg}");
    assert!(experiment.worlds.iter().all(|world| svg.contains(world.as_str())), "{svg}");
    for variant in &experiment.variants {
        assert_eq!(svg.contains(&variant.name), shown.contains(&variant.name), "{svg}");
    }
    assert_balanced(&report.html);
    // A world without the figure has no bars, and what has none anywhere is said.
    experiment.plots[0].y = "flicker.flips".to_owned();
    assert!(page(&experiment, &rows).contains("nothing to plot"));
}

#[test]
fn the_same_rows_give_the_same_page_in_whatever_order_they_come() {
    let experiment = Experiment { pictures: false, ..experiment() };
    let rows = rows(&experiment);
    let reversed: Vec<Row> = rows.iter().rev().cloned().collect();
    let first = page(&experiment, &rows);
    assert!(first == page(&experiment, &rows), "twice");
    assert!(first == page(&experiment, &reversed), "backwards");
}

#[test]
fn a_page_needs_no_network_and_no_script_and_is_well_formed() {
    let experiment = Experiment { size: [64, 36], repeats: 2, ..experiment() };
    let page = page(&experiment, &rows(&experiment));
    let without_namespaces = page.replace("xmlns=\"http://www.w3.org/2000/svg\"", "");
    for word in ["http://", "https://", "<script", "<link", "@import", "url("] {
        assert!(!without_namespaces.contains(word), "{word}");
    }
    assert!(page.contains("data:image/jpeg;base64,") && page.contains("data:image/png;base64,"), "pictures");
    assert!(page.contains("<svg ") && page.contains("Pareto front"), "plots");
    assert!(
        page.contains("llvmpipe") && page.contains("6294189") && page.contains("resolution = 1024"),
        "origin"
    );
    assert_balanced(&page);
}

#[test]
fn names_from_outside_are_escaped() {
    let evil = "</title><script>alert('x')</script>\"&";
    let mut experiment = experiment();
    experiment.size = [16, 9];
    experiment.repeats = 2;
    experiment.title = evil.to_owned();
    experiment.source = evil.to_owned();
    experiment.reported = evil.to_owned();
    experiment.worlds = vec![evil.to_owned()];
    experiment.cameras = vec![evil.to_owned()];
    experiment.variants[0].name = evil.to_owned();
    experiment.variants[1].reported.insert(evil.to_owned(), evil.to_owned());
    experiment.variants[3].sweep.as_mut().unwrap().key = evil.to_owned();
    experiment.columns.push(evil.to_owned());
    experiment.plots.push(plot(evil, "flip", false, false, true));
    experiment.claims.push(claim(evil, evil, 1.0));
    let rows = rows(&experiment);
    let page = report(&experiment, evil, &rows).unwrap().html;
    assert!(!page.contains("<script") && !page.contains("alert('"), "escaped everywhere");
    assert_balanced(&page);
}

#[test]
fn claims_hold_do_not_hold_or_are_not_decided() {
    let mut experiment = small();
    experiment.claims.retain(|claim| claim.variant == "four splits");
    experiment.claims[1].times = 0.0105 / 0.052;
    experiment.claims.push(claim("A tenth.", "four splits", 0.1));
    let rows = rows(&experiment);
    let groups = groups(&experiment, &rows);
    let verdicts: Vec<Verdict> =
        experiment.claims.iter().map(|claim| checks(&experiment, claim, &groups)[0].verdict).collect();
    assert_eq!(verdicts, [Verdict::Holds, Verdict::NotDecided, Verdict::DoesNotHold], "0.202 on average");
    let page = page(&experiment, &rows);
    assert!(page.contains("1 of 3 claims hold"), "the sum");
    for words in [">holds<", ">not decided<", ">does not hold<"] {
        assert!(page.contains(words), "{words}");
    }
    assert!(!page.contains("one sample"), "there are sixteen");
}

#[test]
fn a_claim_measured_once_says_so() {
    let experiment = Experiment { repeats: 1, ..small() };
    let page = page(&experiment, &rows(&experiment));
    assert!(page.contains("one sample") && !page.contains('±'), "no interval of one");
    assert!(!page.contains("<td class=\"number\"><b>"), "and nothing is best for sure");
}

#[test]
fn a_claim_holds_though_one_view_has_nothing_to_judge() {
    let mut experiment = Experiment { cameras: vec!["ground".to_owned(), "above".to_owned()], ..small() };
    experiment.claims.truncate(1);
    let mut rows = rows(&experiment);
    for row in rows.iter_mut().filter(|row| row.run.camera == "above") {
        row.outcome.measurement.error = None;
    }
    let page = page(&experiment, &rows);
    assert!(
        page.contains("1 of 1 claim holds") && page.contains("It holds in 1 of 1. No ratio in 1."),
        "{page}"
    );
}

#[test]
fn the_mean_error_stands_beside_mis_shadowed_pixels_and_nowhere_twice() {
    let table = |columns: &[&str]| {
        let columns = columns.iter().map(|column| (*column).to_owned()).collect();
        let experiment = Experiment { columns, claims: vec![], plots: vec![], ..small() };
        page(&experiment, &rows(&experiment))
    };
    let heads = |page: &str| page.matches("<th class=\"number\">mean error</th>").count();
    for (columns, shown) in [
        (&["error.mis_shadowed", "bytes"][..], 1),
        (&["error.mae", "error.mis_shadowed"], 1),
        (&["error.mis_shadowed", "error.mae"], 1),
        (&["error.false_light", "bytes"], 0),
    ] {
        assert_eq!(heads(&table(columns)), shown, "{columns:?}");
    }
    let beside = "mis-shadowed<br><small>%</small></th><th class=\"number\">mean error</th>";
    assert!(table(&["bytes", "error.mis_shadowed", "flip"]).contains(beside), "next to it");
    let claims = page(&small(), &rows(&small()));
    assert!(claims.contains("<small>mean error 0."), "beside the means of a claim: {claims}");
}

#[test]
fn the_best_is_bold_where_it_is_sure() {
    let experiment = small();
    let mut rows = rows(&experiment);
    let bold = |page: &str| page.matches("<td class=\"number\"><b>").count();
    assert_eq!(bold(&page(&experiment, &rows)), 7, "every column of repeats; times are of one");
    for row in &mut rows {
        row.outcome.measurement.error = Some(fabricate::error(0.01));
    }
    assert_eq!(bold(&page(&experiment, &rows)), 2, "what is equal has no best: FLIP and bytes are left");
}

#[test]
fn what_cannot_be_judged_says_so_and_nothing_is_divided_by_zero() {
    let experiment = Experiment { pictures: true, size: [16, 9], ..small() };
    let mut rows = rows(&experiment);
    for row in &mut rows {
        row.outcome.measurement.error = None;
        row.outcome.measurement.flip = None;
        row.outcome.measurement.truth.pixels = 0;
    }
    let page = page(&experiment, &rows);
    assert!(page.contains("colspan=\"6\">no pixels to judge"), "the table");
    assert!(page.contains("<span class=\"none\">no pixels to judge</span></figcaption>"), "the pictures");
    assert!(page.contains("<td class=\"number\">no pixels to judge</td>"), "the claims");
    assert!(page.contains("0 of 3 claims hold") && page.contains("No ratio in 1."), "and their sum");
    assert!(!page.contains("NaN") && !page.contains(">inf"), "numbers only");
    assert_balanced(&page);
}

#[test]
fn empty_and_odd_experiments_make_whole_pages() {
    assert_balanced(&page(&experiment(), &[]));

    let mut odd = small();
    odd.plots = vec![
        plot("sweep", "flip", true, true, true),
        plot("bytes", "error.bias", true, true, false),
        plot("truth.pixels", "bytes", false, false, false),
        plot("sweep", "flicker.flips", true, false, false),
        plot("world", "error.bias", false, false, false),
    ];
    odd.repeats = 1;
    for values in [
        vec![],
        vec![toml::Value::Integer(0)],
        vec![toml::Value::Float(-1.0), toml::Value::Float(f64::NAN), toml::Value::Float(1e300)],
        vec![toml::Value::from("hard"), toml::Value::from(true), toml::Value::from(vec![1, 2])],
    ] {
        odd.variants[0].sweep = Some(umbrage_lab::Sweep { key: "filter".to_owned(), values });
        let mut rows = rows(&odd);
        assert_balanced(&page(&odd, &rows));
        for row in &mut rows {
            row.variant += 1;
            row.outcome.measurement.flip = Some(f64::NAN);
            row.run.world = "elsewhere".to_owned();
        }
        assert_balanced(&page(&odd, &rows));
    }
}

#[test]
fn a_report_leaves_its_verdicts_tables_and_plots_beside_the_page() {
    let experiment = Experiment { size: [16, 9], repeats: 2, ..experiment() };
    let report = report(&experiment, "experiments/pssm.toml", &rows(&experiment)).unwrap();
    let folder = tempfile::tempdir().unwrap();
    report.write(folder.path(), "pssm").unwrap();
    let read = |file: &str| std::fs::read_to_string(folder.path().join(file)).expect(file);
    assert_eq!(read("pssm.html"), report.html);
    let verdicts: serde_json::Value = serde_json::from_str(&read("pssm/verdicts.json")).unwrap();
    assert_eq!(verdicts["title"], experiment.title.as_str());
    let claims = verdicts["claims"].as_array().unwrap();
    assert_eq!(claims.len(), 3);
    for (claim, said) in claims.iter().zip(&experiment.claims) {
        assert_eq!(
            (&claim["says"], &claim["figure"]),
            (&said.says.as_str().into(), &said.figure.as_str().into())
        );
        assert_eq!(claim["checks"].as_array().unwrap().len(), 4 * 2, "every world and camera");
        let table = read(&format!("pssm/tables/{}.md", claim["table"].as_str().unwrap()));
        assert_eq!(table.lines().count(), 2 + 4 * 2);
        assert!(table.starts_with("| world | camera |"), "{table}");
    }
    let figures = read("pssm/tables/figures.md");
    assert!(
        figures.contains("| **forest from ground** | |") && figures.contains("| one map, 1024² | "),
        "{figures}"
    );
    assert!(
        read("pssm/tables/machines.md").contains("| the wall clock |")
            || read("pssm/tables/machines.md").contains("| timestamps of the device |")
    );
    // Three plots over all worlds, and one of each of the four.
    for i in 1..=7 {
        let svg = read(&format!("pssm/plots/{i}.svg"));
        assert!(svg.starts_with("<svg role=\"img\" aria-label=") && svg.ends_with("</svg>\n"), "{svg}");
        assert!(svg.contains("><rect width=\"100%\" height=\"100%\" fill=\"white\"/>"), "on white");
    }
    assert!(!folder.path().join("pssm/plots/8.svg").exists());
}

#[test]
fn csv_has_a_line_for_each_row_and_quotes_what_needs_it() {
    let mut experiment = small();
    experiment.variants[0].name = "one \"map\",\nsmall".to_owned();
    let rows = rows(&experiment);
    let csv = umbrage_lab::csv::csv(&experiment, &rows);
    let mut lines = csv.split('\n');
    let heading: Vec<&str> = lines.next().unwrap().split(',').collect();
    assert!(
        heading.starts_with(&["variant", "swept_key"]) && heading.contains(&"error.mis_shadowed"),
        "{heading:?}"
    );
    assert!(csv.contains("\"one \"\"map\"\",\nsmall\",,,forest,ground,,0,"), "quoted");
    assert_eq!(csv.matches(",forest,").count(), rows.len(), "repeats included");
}

#[test]
fn json_holds_everything_that_was_measured() {
    let experiment = experiment();
    let experiment = Experiment { pictures: false, repeats: 1, ..experiment };
    let rows = rows(&experiment);
    let json = umbrage_lab::csv::json(&experiment, &rows).unwrap();
    assert_eq!(json["rows"].as_array().unwrap().len(), rows.len());
    assert_eq!(json["rows"][4]["swept"], 0.125, "the second value of the sweep");
    let bias = rows[0].outcome.measurement.error.as_ref().unwrap().bias;
    assert_eq!(json["rows"][0]["measurement"]["error"]["bias"], bias);
    assert_eq!(json["rows"][0]["machine"]["commit"], "6294189");
    assert_eq!(json["experiment"]["title"], experiment.title);
}
