//! `homolog study score DIR SUBJECT`: one new subject against the group of a study.

use super::error::CliError;
use super::output::{note, print};
use super::study_run::{Display, document, said, threads};
use clap::Args;
use clap::builder::PossibleValuesParser;
use homolog_contract::input::BodySide;
use homolog_contract::parameters::LabelChoice;
use homolog_study::StudyError;
use homolog_study::adjustment::Adjustment;
use homolog_study::folder::{Folder, read_decisions};
use homolog_study::plan::Study;
use homolog_study::score::{NewSubject, Reference, ScoreSummary, Subgroup, SubjectScore, add, score};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Score a new subject against the group of a study
///
/// The subject costs one match. Its score at every vertex is its deviation from the mean of the group in standard deviations, as a
/// member of the group that was left out would be scored. Regions beyond what such a member reaches anywhere are listed.
#[derive(Debug, Clone, Args)]
pub(super) struct ScoreArgs {
    /// Folder of the study, which contains study.json
    #[arg(value_name = "DIR")]
    study: PathBuf,
    /// The subject: a surface or a label volume
    #[arg(value_name = "SUBJECT")]
    subject: PathBuf,
    /// Folder for the score: score.json and surfaces with the score at every vertex; default: scores/SUBJECT in the folder of the
    /// study
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// The group: members with this level of a covariate, such as group=control; default: all
    #[arg(long, value_name = "COVARIATE=LEVEL")]
    group: Option<String>,
    /// Covariates of the study to adjust for: the subject is compared with the prediction at its own values
    #[arg(long, value_name = "COVARIATE", value_delimiter = ',')]
    adjust: Vec<String>,
    /// The value of the subject of a covariate to adjust for, such as age=71.5; once for each
    #[arg(long, value_name = "COVARIATE=VALUE")]
    covariate: Vec<String>,
    /// Side of the body of the subject, if the study has sides
    #[arg(long, value_name = "left|right", value_parser = PossibleValuesParser::new(["left", "right"]))]
    side: Option<String>,
    /// Label of its volume that belongs to the structure, by number or name; may be repeated; default: those of the study
    #[arg(long, value_name = "NUMBER|NAME")]
    label: Vec<String>,
    /// Threads; default: all cores. The answer does not depend on it
    #[arg(long, value_name = "N")]
    threads: Option<std::num::NonZeroUsize>,
}

/// Runs the command.
///
/// # Errors
/// [`CliError`].
pub(super) fn run(args: &ScoreArgs) -> Result<(), CliError> {
    let within = args.group.as_ref().map(|text| {
        Subgroup::read(text).ok_or_else(|| CliError::BadInput(format!("--group {text}: write COVARIATE=LEVEL")))
    });
    let reference = Reference { within: within.transpose()?, adjustment: adjustment(args)? };
    let document = document(&args.study.join("study.json"))?;
    let (mut cohort, mut settings) = (document.cohort, document.settings);
    reference.adjustment.check(&cohort).map_err(said)?;
    let unreadable =
        |error: std::io::Error| CliError::BadInput(format!("cannot read {}: {error}", args.subject.display()));
    let file = std::path::absolute(&args.subject).map_err(unreadable)?;
    std::fs::metadata(&file).map_err(unreadable)?;
    let label = |text: &String| text.parse().map_or_else(|_| LabelChoice::Name(text.clone()), LabelChoice::Number);
    let new = NewSubject {
        file,
        side: args.side.as_deref().and_then(BodySide::of_name),
        labels: (!args.label.is_empty()).then(|| args.label.iter().map(label).collect()),
    };
    let known: BTreeSet<String> = cohort.subjects.iter().map(|subject| subject.id.clone()).collect();
    let k = add(&mut cohort, &mut settings, new).map_err(said)?;
    let (threads, pool) = threads(args.threads)?;
    let watcher = Display::new();
    let done = pool.install(|| -> Result<SubjectScore, StudyError> {
        let folder = Folder::create(&args.study)?;
        let decisions = match folder.read("decisions.csv")? {
            Some(text) => {
                let ids = known.iter().map(String::as_str).collect();
                read_decisions(&text, &ids).map_err(StudyError::Settings)?
            }
            None => document.decisions,
        };
        let mut study = Study::open(cohort, settings, &document.hashes, &folder, &watcher)?;
        let matched = study.match_all(&folder, threads, &watcher)?;
        score(&study, &matched, &folder, &decisions, (k, &reference), &watcher)
    });
    drop(watcher);
    let found = done.map_err(said)?;
    let out = args.out.clone().unwrap_or_else(|| args.study.join("scores").join(stem(&args.subject)));
    write(&found, &out)?;
    print(&summary(&found.summary))?;
    note(&format!("written to {}", out.display()));
    Ok(())
}

/// The covariates to adjust for, with the values of the subject.
fn adjustment(args: &ScoreArgs) -> Result<Adjustment, CliError> {
    let mut values = BTreeMap::new();
    for text in &args.covariate {
        let Some((name, value)) = text.split_once('=').filter(|(name, value)| !name.is_empty() && !value.is_empty())
        else {
            return Err(CliError::BadInput(format!("--covariate {text}: write COVARIATE=VALUE")));
        };
        if values.insert(name.to_owned(), value.to_owned()).is_some() {
            return Err(CliError::BadInput(format!("--covariate {name} is given twice; give it once")));
        }
    }
    Ok(Adjustment { covariates: args.adjust.clone(), values })
}

/// The file's name up to its first dot.
fn stem(path: &Path) -> String {
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    name.split('.').next().filter(|stem| !stem.is_empty()).unwrap_or("subject").to_owned()
}

fn write(found: &SubjectScore, out: &Path) -> Result<(), CliError> {
    let failed = |path: &Path, source| CliError::Write { path: path.to_owned(), source };
    std::fs::create_dir_all(out).map_err(|error| failed(out, error))?;
    for (name, bytes) in found.files(env!("HOMOLOG_COMMIT")) {
        let path = out.join(name);
        std::fs::write(&path, bytes).map_err(|error| failed(&path, error))?;
    }
    Ok(())
}

/// The score, in a few lines.
fn summary(found: &ScoreSummary) -> String {
    let of = found.within.as_ref().map_or(String::new(), |of| format!(" with {} {}", of.covariate, of.level));
    let mut lines = vec![
        format!("against {} members{of}", found.members),
        format!("unusual shape: p {:.4}", found.unusual_p),
        format!(
            "largest score {:.2}, p {:.4}; bound {:.2} at {}",
            found.largest_score, found.largest_score_p, found.bound.score, found.bound.level
        ),
        format!(
            "scores of left-out members: mean {:.3}, RMS {:.3}, {:.1} % beyond 1.96",
            found.calibration.mean,
            found.calibration.rms,
            100.0 * found.calibration.beyond_1_96
        ),
    ];
    if let Some(of) = &found.adjusted {
        let values = of.covariates.iter().map(|(name, value)| format!("{name} {value}")).collect::<Vec<_>>().join(", ");
        lines.insert(1, format!("adjusted to {values}; {} degrees of freedom", of.degrees));
        lines.extend(of.warnings.iter().map(|warning| format!("warning: {warning}")));
    }
    for region in &found.regions {
        let [x, y, z] = region.peak_mm;
        lines.push(format!(
            "region of {:.1} mm², score {:.2}, {:+.2} mm at ({x:.1}, {y:.1}, {z:.1})",
            region.area_mm2, region.score, region.deviation_mm
        ));
    }
    if found.reliable == Some(false) {
        lines.push(format!("the match is not reliable: {}", found.reasons.join("; ")));
    }
    lines.join("\n")
}
