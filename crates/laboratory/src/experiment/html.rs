//! The report as a self-contained HTML page: style and plots inline, no scripts, no external resources.

use super::document::{Cell, Column, ReportDocument, Section, Table};
use homolog_run::page::escaped;
use std::fmt::Write;

const STYLE: &str = "
:root { color-scheme: light; }
body { font: 16px/1.5 system-ui, sans-serif; color: #1d1d1f; background: #fff; margin: 0 auto; max-width: 72rem;
  padding: 2rem 1.25rem 4rem; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .5rem; }
h2 { font-size: 1.35rem; margin: 0 0 .5rem; }
section { border-top: 1px solid #d8d8dc; margin-top: 2.5rem; padding-top: 1.5rem; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .15rem 1rem; margin: .75rem 0; }
dt { color: #63636b; } dd { margin: 0; }
.finding { background: #eef5fb; border-left: 4px solid #0072b2; padding: .6rem 1rem; margin: 1rem 0; }
.note { color: #63636b; margin: .4rem 0; }
.scroll { overflow-x: auto; margin: 1rem 0; }
table { border-collapse: collapse; font-size: .82rem; font-variant-numeric: tabular-nums; min-width: 50%; }
caption { text-align: left; font-weight: 600; padding-bottom: .35rem; }
th, td { padding: .28rem .55rem; text-align: right; border-bottom: 1px solid #e6e6ea; white-space: nowrap; }
th { color: #63636b; font-weight: 600; border-bottom: 1px solid #a8a8b0; vertical-align: bottom; white-space: normal; }
th:first-child, td:first-child, td.words { text-align: left; }
td small { color: #63636b; }
figure { margin: 1.25rem 0; } figcaption { font-weight: 600; font-size: .88rem; margin-bottom: .25rem; }
svg { width: 100%; height: auto; max-width: 45rem; }
svg text { font: 12px system-ui, sans-serif; fill: #3c3c43; }
code { background: #f4f4f6; padding: .1rem .35rem; border-radius: 3px; font-size: .88rem; }
nav ol { padding-left: 1.4rem; } nav li { margin: .25rem 0; } nav small { color: #63636b; display: block; }
a { color: #00609a; }
@media print { section { break-inside: avoid-page; } nav { break-after: page; } }
";

/// The whole page.
pub(super) fn page(report: &ReportDocument) -> String {
    let mut out = String::new();
    // Writing to a string cannot fail, here and below.
    let _ = write!(
        out,
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>homolog: evaluation</title>\n<style>{STYLE}</style>\n</head>\n<body>\n<header>\n\
         <h1>Evaluation of surface matching and registration</h1>\n"
    );
    let extent = if report.quick { "quick (coarse surfaces, few pairs)" } else { "full" };
    let made = &report.provenance;
    out.push_str("<dl>\n");
    for (name, value) in
        [("Version", &made.version), ("Commit", &made.commit), ("Date", &made.date), ("Machine", &made.machine)]
    {
        term(&mut out, name, value);
    }
    term(&mut out, "Scope", extent);
    out.push_str(
        "</dl>\n<p>Dense correspondence between two surfaces is found by minimizing the energy of a Markov random field, and \
         a rigid transform is estimated from the corresponding points by RANSAC. Energies have no unit; lower is better. \
         Values with ± are mean ± standard deviation over pairs; the CSV files beside this page also hold the number of \
         pairs, medians and quartiles.</p>\n</header>\n",
    );
    out.push_str("<nav>\n<h2>Findings</h2>\n<ol>\n");
    for s in &report.sections {
        let (id, title, finding) = (escaped(&s.id), escaped(&s.title), escaped(&s.finding));
        let _ = writeln!(out, "<li><a href=\"#{id}\">{title}</a><small>{finding}</small></li>");
    }
    out.push_str("</ol>\n</nav>\n<main>\n");
    for s in &report.sections {
        section(&mut out, s);
    }
    out.push_str("<section id=\"budget\">\n<h2>Computing time</h2>\n");
    table(&mut out, &report.budget);
    out.push_str("</section>\n</main>\n</body>\n</html>\n");
    out
}

fn term(out: &mut String, name: &str, value: &str) {
    let _ = writeln!(out, "<dt>{name}</dt><dd>{}</dd>", escaped(value));
}

fn section(out: &mut String, s: &Section) {
    let _ = writeln!(out, "<section id=\"{}\">\n<h2>{}</h2>", escaped(&s.id), escaped(&s.title));
    let _ = writeln!(out, "<p>{}</p>\n<p class=\"finding\">{}</p>\n<dl>", escaped(&s.question), escaped(&s.finding));
    term(out, "Design", &s.varied);
    term(out, "Sample", &s.pairs);
    let _ = writeln!(out, "<dt>Reproduce with</dt><dd><code>{}</code></dd>\n</dl>", escaped(&s.command));
    for note in &s.notes {
        let _ = writeln!(out, "<p class=\"note\">{}</p>", escaped(note));
    }
    for plot in &s.plots {
        if let Some(drawing) = plot.svg() {
            let _ = writeln!(out, "<figure>\n<figcaption>{}</figcaption>\n{drawing}</figure>", escaped(&plot.title));
        }
    }
    for t in &s.tables {
        table(out, t);
    }
    out.push_str("</section>\n");
}

fn table(out: &mut String, t: &Table) {
    let _ = writeln!(out, "<div class=\"scroll\">\n<table>\n<caption>{}</caption>\n<thead><tr>", escaped(&t.title));
    for column in &t.columns {
        let _ = write!(out, "<th scope=\"col\">{}</th>", escaped(&column.heading()));
    }
    out.push_str("</tr></thead>\n<tbody>\n");
    for row in &t.rows {
        out.push_str("<tr>");
        for (cell, column) in row.iter().zip(&t.columns) {
            let class = if matches!(cell, Cell::Text(_)) { " class=\"words\"" } else { "" };
            let _ = write!(out, "<td{class}>{}</td>", shown(cell, column));
        }
        out.push_str("</tr>\n");
    }
    out.push_str("</tbody>\n</table>\n</div>\n");
}

/// A cell as it is printed.
fn shown(cell: &Cell, column: &Column) -> String {
    match cell {
        Cell::Count(n) => n.to_string(),
        Cell::Number(value) => rounded(*value, column.digits),
        Cell::Spread(s) => {
            let digits = column.digits;
            format!("{} <small>± {:.digits$}</small>", rounded(s.mean, digits), s.sd)
        }
        Cell::Text(words) => escaped(words),
        Cell::Missing(()) => "–".to_owned(),
    }
}

/// A number with `digits` decimals, or in scientific notation where all of these would be 0.
fn rounded(value: f64, digits: usize) -> String {
    let smallest = 0.5 * 10f64.powi(-(digits as i32));
    if value != 0.0 && value.abs() < smallest { format!("{value:.1e}") } else { format!("{value:.digits$}") }
}
