//! `homolog study TABLE|FOLDER|study.json`: computes a shape model, maps of statistics and a report from a group of
//! subjects.

use super::error::CliError;
use super::files::{OutputFolder, file_name};
use super::output::{note, print};
use super::parameters::ParameterArgs;
use super::study_run::{Display, document, said, threads};
use super::study_score::{self, ScoreArgs};
use clap::builder::PossibleValuesParser;
use clap::{Args, Subcommand};
use homolog_contract::input::BodySide;
use homolog_study::StudyError;
use homolog_study::cohort::Cohort;
use homolog_study::findings::Findings;
use homolog_study::folder::{Decision, Folder, read_decisions};
use homolog_study::output::write;
use homolog_study::settings::{
    Analysis, Correspondence, MadeTemplate, Measure, Rivals, Settings, Size, TemplateChoice, Visits,
};
use homolog_study::sides::template_side;
use homolog_study::structures::GroupStudy;
use homolog_study::subjects::SubjectOutcome;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Study a group of subjects: template, shape model, statistics at every vertex, quality control, report
///
/// A given template, or one made from the group, is matched to every subject. The matches are kept in the folder: the
/// same command continues after an interruption, and a subject that is added later costs one match.
#[derive(Debug, Clone, Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub(super) struct StudyArgs {
    #[command(subcommand)]
    command: Option<StudyCommand>,
    /// A table of subjects (CSV with the column file and, optionally, id, subject, role, side, label, structure and covariates), a
    /// folder of their files, or the study.json of a study to compute again
    #[arg(value_name = "TABLE.csv|FOLDER|study.json", required = true)]
    cohort: Option<PathBuf>,
    /// Folder for the results: study.json, report.html, tables, the mean, modes, maps, and the template deformed onto
    /// every subject
    #[arg(long, value_name = "DIR", required = true)]
    out: Option<PathBuf>,
    /// Template: a surface or a label volume; default: made from the group. Where the table has a column structure, that of one
    /// structure, such as amygdala=FILE; may be repeated
    #[arg(long, value_name = "FILE|STRUCTURE=FILE")]
    template: Vec<String>,
    /// Side of the body on which the template lies, where the table has a column side: subjects of the other side are
    /// mirrored; default: the side of the subject from which the template is made, or of most subjects
    #[arg(long, value_name = "left|right", value_parser = PossibleValuesParser::new(["left", "right"]))]
    template_side: Option<String>,
    /// Subject from whose surface the template is made; default: the subject of median volume
    #[arg(long, value_name = "ID", conflicts_with = "template")]
    start: Option<String>,
    /// Maximum number of subjects from which the template is made, spread over the table; 0: all
    #[arg(long, value_name = "N", default_value_t = MadeTemplate::default().subjects, conflicts_with = "template")]
    template_subjects: usize,
    /// Maximum number of rounds of matching and averaging
    #[arg(long, value_name = "N", default_value_t = MadeTemplate::default().max_rounds, conflicts_with = "template")]
    template_rounds: usize,
    /// Covariate whose effect is tested: the difference between its levels, or its slope
    #[arg(long, value_name = "COVARIATE")]
    effect: Option<String>,
    /// Covariates to adjust for
    #[arg(long, value_name = "COVARIATE", value_delimiter = ',')]
    adjust: Vec<String>,
    /// Level with which the other levels of a covariate are compared; may be repeated; default: the first in
    /// alphabetical order
    #[arg(long, value_name = "COVARIATE=LEVEL")]
    reference: Vec<String>,
    /// A further contrast: its name and a sum of columns of the design, such as "ends=group:severe - group:mild"; may
    /// be repeated
    #[arg(long, value_name = "NAME=SUM")]
    contrast: Vec<String>,
    /// Measure to test at every vertex: normal_displacement (mm), log_area (no unit), thickness (mm); may be repeated;
    /// default: all. p-values are not corrected over measures
    #[arg(long, value_name = "MEASURE", value_delimiter = ',', value_parser = PossibleValuesParser::new(Measure::ALL.map(Measure::name)))]
    measure: Vec<String>,
    /// Permutations of each test
    #[arg(long, value_name = "N", default_value_t = Analysis::default().permutations, value_parser = clap::builder::RangedU64ValueParser::<usize>::new().range(1..=1_000_000))]
    permutations: usize,
    /// Scale all subjects to one size, which removes global atrophy; to correct for head size, adjust for a covariate
    #[arg(long)]
    without_size: bool,
    /// How correspondence is found: by each subject's own match with the template (pairs), or by these matches revised
    /// together under a model of the group (joint)
    #[arg(long, value_name = "pairs|joint", default_value = Correspondence::ALL[0].name(), value_parser = PossibleValuesParser::new(Correspondence::ALL.map(Correspondence::name)))]
    correspondence: String,
    /// How visits of one person are matched: each with the template of the group (group-template), or through a template of
    /// the person that is made from its visits, which takes out of its changes the error of matching two persons (own-template)
    #[arg(long, value_name = "group-template|own-template", default_value = Visits::ALL[0].option(), value_parser = PossibleValuesParser::new(Visits::ALL.map(Visits::option)))]
    visits: String,
    /// What becomes of subjects whose only doubt is their pose (ambiguous_pose): each is also matched in its other poses, and the
    /// group decides between them where it can (decide), or they are left out (leave-out)
    #[arg(long, value_name = "decide|leave-out", default_value = Rivals::ALL[0].option(), value_parser = PossibleValuesParser::new(Rivals::ALL.map(Rivals::option)))]
    rivals: String,
    /// Number of subjects among which the consistency of maps is measured, at three matches each; 0: not measured
    #[arg(long, value_name = "N", default_value_t = 0)]
    cycles: usize,
    /// Table of decisions: id, decision (kept or dropped), reason; default: decisions.csv in the folder
    #[arg(long, value_name = "FILE.csv")]
    decisions: Option<PathBuf>,
    /// Threads; default: all cores. The answer does not depend on it
    #[arg(long, value_name = "N")]
    threads: Option<std::num::NonZeroUsize>,
    #[command(flatten)]
    parameters: ParameterArgs,
}

/// What is done with a study.
#[derive(Debug, Clone, Subcommand)]
enum StudyCommand {
    Score(ScoreArgs),
}

/// Runs the command.
///
/// # Errors
/// [`CliError`].
pub(super) fn run(args: &StudyArgs) -> Result<(), CliError> {
    if let Some(StudyCommand::Score(args)) = &args.command {
        return study_score::run(args);
    }
    let (Some(cohort), Some(out)) = (&args.cohort, &args.out) else {
        return Err(CliError::BadInput("a study needs subjects and --out".to_owned()));
    };
    let asked = asked(args, cohort)?;
    let out = OutputFolder::create(out)?;
    let (threads, pool) = threads(args.threads)?;
    let watcher = Display::new();
    let done = pool.install(|| -> Result<Findings, StudyError> {
        let folder = Folder::create(out.path())?;
        let decisions = decisions(args, &asked, &folder)?;
        let mut study = GroupStudy::open(asked.cohort, asked.settings, &asked.hashes, &folder, &watcher)?;
        let matched = study.match_all(&folder, threads, &watcher)?;
        let (study, found) = study.find(&matched, &folder, &decisions, &watcher)?;
        write(&study, &found, &decisions, &folder, env!("HOMOLOG_COMMIT"), &watcher)?;
        Ok(found)
    });
    drop(watcher);
    let found = done.map_err(said)?;
    print(&summary(&found))?;
    note(&format!("written to {}, begin with report.html", out.path().display()));
    let (failed, n) =
        (found.subjects.iter().filter(|subject| subject.place == SubjectOutcome::Failed).count(), found.subjects.len());
    match failed {
        0 => Ok(()),
        failed => Err(CliError::Failed(format!("{failed} of {n} subjects have no match; quality.csv says why"))),
    }
}

/// A requested study.
struct Asked {
    cohort: Cohort,
    settings: Settings,
    hashes: Vec<String>,
    /// Decisions of a study that is computed again.
    decisions: Option<Vec<Decision>>,
}

fn asked(args: &StudyArgs, given: &Path) -> Result<Asked, CliError> {
    let unreadable = |error: std::io::Error| CliError::BadInput(format!("cannot read {}: {error}", given.display()));
    // Absolute, so that study.json is valid from any folder.
    let path = std::path::absolute(given).map_err(unreadable)?;
    if path.extension().is_some_and(|ending| ending == "json") {
        let document = document(given)?;
        let decisions = Some(document.decisions);
        return Ok(Asked { cohort: document.cohort, settings: document.settings, hashes: document.hashes, decisions });
    }
    let cohort = if path.is_dir() {
        let entries = fs::read_dir(&path).map_err(unreadable)?;
        let files = entries.collect::<Result<Vec<_>, _>>().map_err(unreadable)?.into_iter().map(|entry| entry.path());
        Cohort::from_files(files.filter(|path| path.is_file()).collect())
    } else {
        Cohort::from_csv(&fs::read(&path).map_err(unreadable)?, path.parent().unwrap_or(Path::new("")))
    };
    let cohort = cohort.map_err(|error| CliError::BadInput(format!("{}: {error}", given.display())))?;
    for subject in &cohort.subjects {
        // Checked before the first match, which may be long before this file is read.
        fs::metadata(&subject.file)
            .map_err(|error| CliError::BadInput(format!("cannot read {}: {error}", subject.file.display())))?;
    }
    let template = template(args, &cohort)?;
    let pair = |text: &String, option: &str| match text.split_once('=') {
        Some((name, value)) if !name.is_empty() && !value.is_empty() => Ok((name.to_owned(), value.to_owned())),
        _ => Err(CliError::BadInput(format!("{option} {text}: write NAME=VALUE"))),
    };
    let pairs = |all: &[String], option: &str| all.iter().map(|text| pair(text, option)).collect::<Result<Vec<_>, _>>();
    let parameters = args.parameters.resolve()?;
    let measures = Measure::ALL.into_iter();
    let analysis = Analysis {
        effect: args.effect.clone(),
        adjust: args.adjust.clone(),
        reference: pairs(&args.reference, "--reference")?,
        contrasts: pairs(&args.contrast, "--contrast")?,
        measures: measures
            .filter(|m| args.measure.is_empty() || args.measure.iter().any(|name| name == m.name()))
            .collect(),
        permutations: args.permutations,
        seed: parameters.seed,
    };
    let settings = Settings {
        template,
        template_side: args.template_side.as_deref().and_then(BodySide::of_name),
        size: if args.without_size { Size::Removed } else { Size::Kept },
        correspondence: Correspondence::of_name(&args.correspondence).unwrap_or_default(),
        visits: Visits::of_name(&args.visits).unwrap_or_default(),
        rivals: Rivals::of_name(&args.rivals).unwrap_or_default(),
        analysis,
        cycle_subjects: args.cycles,
        cycle_ring: Vec::new(),
        parameters,
    };
    template_side(&cohort, &settings).map_err(|error| CliError::BadInput(error.to_string()))?;
    // A wrong covariate is reported now, and not after the matches.
    let persons = cohort.persons();
    let all: Vec<usize> = (0..persons.subjects.len()).collect();
    if settings.analysis.effect.is_some() || !settings.analysis.contrasts.is_empty() {
        homolog_study::statistics::design::Design::new(&persons, &all, &settings.analysis)
            .map_err(CliError::BadInput)?;
    }
    Ok(Asked { cohort, settings, hashes: Vec::new(), decisions: None })
}

/// The origin of the template, or of those of all structures.
fn template(args: &StudyArgs, cohort: &Cohort) -> Result<TemplateChoice, CliError> {
    let absolute = |file: &str| {
        std::path::absolute(file).map_err(|error| {
            CliError::BadInput(format!("cannot read {}: {error}", file_name(Path::new(file)).unwrap_or_default()))
        })
    };
    let structures = cohort.structures();
    let made = MadeTemplate {
        start: args.start.clone(),
        subjects: args.template_subjects,
        max_rounds: args.template_rounds,
        ..MadeTemplate::default()
    };
    if structures.is_empty() {
        return match args.template.as_slice() {
            [] => Ok(TemplateChoice::Made(made)),
            [file] => Ok(TemplateChoice::Given { file: absolute(file)? }),
            _ => Err(CliError::BadInput(
                "--template is given more than once, and the table has no structures".to_owned(),
            )),
        };
    }
    let mut given = BTreeMap::new();
    for text in &args.template {
        let known = text.split_once('=').filter(|(name, _)| structures.iter().any(|structure| structure == name));
        let Some((name, file)) = known else {
            let structures = structures.join(", ");
            return Err(CliError::BadInput(format!(
                "--template {text}: write STRUCTURE=FILE, with a structure of the table: {structures}"
            )));
        };
        if given.insert(name.to_owned(), absolute(file)?).is_some() {
            return Err(CliError::BadInput(format!("--template is given twice for {name}")));
        }
    }
    Ok(TemplateChoice::Made(MadeTemplate { given, ..made }))
}

/// The decisions of the option, or else of the folder, or else of the study that is computed again.
fn decisions(args: &StudyArgs, asked: &Asked, folder: &Folder) -> Result<Vec<Decision>, StudyError> {
    let text = match &args.decisions {
        Some(path) => {
            Some(fs::read(path).map_err(|source| StudyError::File { what: "read", path: path.clone(), source })?)
        }
        None => folder.read("decisions.csv")?,
    };
    let Some(text) = text else { return Ok(asked.decisions.clone().unwrap_or_default()) };
    let persons = asked.cohort.persons();
    let subjects = asked.cohort.subjects.iter().chain(&persons.subjects);
    let ids: BTreeSet<&str> = subjects.map(|subject| subject.id.as_str()).collect();
    let read = read_decisions(&text, &ids).map_err(StudyError::Settings)?;
    // An empty table of decisions in the folder does not override the decisions of the study that is computed again.
    Ok(if read.is_empty() { asked.decisions.clone().unwrap_or_default() } else { read })
}

/// The findings, in a few lines.
fn summary(found: &Findings) -> String {
    let flagged = found.subjects.iter().filter(|subject| !subject.flags.is_empty()).count();
    let mut lines = vec![format!(
        "{} subjects, {} in the shape model, {flagged} to look at",
        found.subjects.len(),
        found.members.len()
    )];
    let rounds = &found.matched.making.rounds;
    if let Some(last) = rounds.last() {
        lines.push(format!(
            "template made in {} rounds from {} subjects; the last moved its surface by {:.3} of its mean edge",
            rounds.len(),
            last.subjects,
            last.moved_share
        ));
    }
    for structure in found.complex.iter().flat_map(|complex| &complex.structures) {
        let template = match structure.rounds.last() {
            Some(last) => format!("made in {} rounds from {} subjects", structure.rounds.len(), last.subjects),
            None => "given".to_owned(),
        };
        lines.push(format!("{}: {} vertices, template {template}", structure.name, structure.vertices.len()));
    }
    let quality = &found.model.quality;
    if let Some(k) = quality.compactness.iter().position(|share| *share >= 0.9) {
        lines.push(format!(
            "{} modes explain 90 % of the variance; generalization {:.3} mm, specificity {:.3} mm",
            k + 1,
            quality.generalization_mm[k],
            quality.specificity_mm[k]
        ));
    }
    for map in found.statistics.iter().flat_map(|statistics| &statistics.maps) {
        let p = map.p_corrected().iter().copied().fold(1.0, f64::min);
        let contrast = found.statistics.as_ref().map_or("", |s| s.design.contrasts[map.contrast].name.as_str());
        let word = if map.mixed.is_some() { "q (FDR)" } else { "p (corrected over vertices)" };
        lines.push(format!("{contrast}, {}: smallest {word} {p:.4}", map.measure.name()));
    }
    lines.join("\n")
}
