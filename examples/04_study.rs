//! A study of a group: a template made from it, a shape model, the effect of a covariate at every vertex, and a report. Stopped and
//! started again, it goes on where it was.
//!
//! Usage: `04_study TABLE.csv EFFECT OUT`; docs/studies.md describes the table.
#![allow(clippy::print_stdout, reason = "an example")]

use homolog_contract::parameters::{Method, preset};
use homolog_study::cohort::Cohort;
use homolog_study::findings::find;
use homolog_study::folder::Folder;
use homolog_study::matching::StudyObserver;
use homolog_study::output::write;
use homolog_study::plan::Study;
use homolog_study::settings::{
    Analysis, Correspondence, MadeTemplate, Measure, Rivals, Settings, Size, TemplateChoice, Visits,
};
use std::path::Path;

struct Printer;

impl StudyObserver for Printer {
    fn progress(&self, what: &str, done: usize, of: usize) {
        println!("{what}: {done} of {of}");
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [table, effect, out] = arguments.as_slice() else { return Err("usage: 04_study TABLE.csv EFFECT OUT".into()) };
    let beside = Path::new(table).parent().unwrap_or(Path::new(""));
    let cohort = Cohort::from_csv(&std::fs::read(table)?, beside)?;
    let settings = Settings {
        template: TemplateChoice::Made(MadeTemplate { subjects: 4, max_rounds: 2, ..MadeTemplate::default() }),
        template_side: None,
        size: Size::Kept,
        correspondence: Correspondence::Pairs,
        visits: Visits::GroupTemplate,
        rivals: Rivals::Decide,
        analysis: Analysis {
            effect: Some(effect.clone()),
            measures: vec![Measure::NormalDisplacement],
            permutations: 100,
            ..Analysis::default()
        },
        cycle_subjects: 0,
        cycle_ring: Vec::new(),
        parameters: preset(Method::Balanced),
    };
    let folder = Folder::create(Path::new(out))?;
    let mut study = Study::open(cohort, settings, &[], &folder, &Printer)?;
    let matched = study.match_all(&folder, 2, &Printer)?;
    let found = find(&study, &matched, &folder, &[], &Printer)?;
    write(&study, &found, &[], &folder, "unknown", &Printer)?;
    println!("{} of {} subjects are in the shape model", found.members.len(), found.subjects.len());
    println!("begin with {out}/report.html");
    Ok(())
}
