//! Description of the methods of the study for a supplement, with versions and parameters.

use super::escaped;
use crate::findings::Findings;
use crate::plan::Study;
use crate::settings::{Size, TemplateChoice};

/// The section on methods.
pub(super) fn text(study: &Study, found: &Findings, commit: &str) -> String {
    let settings = &study.settings;
    let n = found.members.len();
    let mut paragraphs = Vec::new();
    let template = match &settings.template {
        TemplateChoice::Given { .. } => "A given template was matched to every subject".to_owned(),
        TemplateChoice::Made(how) => {
            let rounds = &found.matched.making.rounds;
            let last = rounds.last().map_or(0.0, |round| round.moved_share);
            format!(
                "A template was made from {} subjects in {} rounds: the surface of {} was matched to each of them, their \
                 images were averaged after Procrustes alignment, and the mean, with vertices where those of the template before lie on it, \
                 became the next template, until the surface moved by {last:.3} of its mean edge (RMS; stop below {} or after {} \
                 rounds). It was matched to every subject",
                how.from.len(),
                rounds.len(),
                how.start
                    .as_ref()
                    .map_or("the subject of median size".to_owned(), |id| format!("subject {}", escaped(id))),
                how.tolerance,
                how.max_rounds
            )
        }
    };
    paragraphs.push(format!(
        "{template} (method {}, seed {}). All shapes have the {} vertices of the template.",
        settings.parameters.method.name(),
        settings.parameters.seed,
        found.mean.n_vertices()
    ));
    paragraphs.push(format!(
        "Shapes were aligned by generalized Procrustes analysis, {}; a vertex weighs its share of the area. {n} subjects entered a \
         principal component analysis; generalization and the distances of quality control leave out {}.",
        match settings.size {
            Size::Kept => "by rotation and translation, so that size is part of shape",
            Size::Removed => "by rotation, translation and scale, so that size is not part of shape",
        },
        if n <= 200 { "one subject at a time" } else { "a twentieth of the subjects at a time" }
    ));
    if let Some(statistics) = &found.statistics {
        let columns: Vec<String> = statistics.design.columns.iter().map(|column| escaped(column)).collect();
        let contrasts: Vec<String> =
            statistics.design.contrasts.iter().map(|contrast| escaped(&contrast.meaning)).collect();
        paragraphs.push(format!(
            "At every vertex a linear model of {} rows with the columns {} was fitted; contrasts: {}.",
            statistics.design.rows.len(),
            columns.join(", "),
            contrasts.join("; ")
        ));
        paragraphs.push(if statistics.longitudinal {
            "Subjects have several visits: a random intercept for each subject was estimated by restricted maximum likelihood, with \
             Wald tests, and the false discovery rate was controlled over vertices (Benjamini, Hochberg)."
                .to_owned()
        } else {
            format!(
                "Standard errors are robust to unequal variances (HC3). The error over the whole surface is controlled by {} \
                 permutations (Freedman, Lane; seed {}) of the largest threshold-free cluster enhancement of |t| (H = 2, E = 1, \
                 area of the mean); the false discovery rate by Benjamini and Hochberg from the robust p. Intervals of g \
                 are exact under normal residuals of equal variance. {} measures were tested; p-values are not corrected for that.",
                settings.analysis.permutations,
                settings.analysis.seed,
                settings.analysis.measures.len() - statistics.left_out.len()
            )
        });
    }
    paragraphs.push(format!(
        "Computed with homolog {}, commit {}. study.json holds the subjects with the hashes of their files, all settings and decisions: \
         <code>homolog study study.json --out FOLDER</code> computes the study again.",
        env!("CARGO_PKG_VERSION"),
        escaped(commit)
    ));
    let body: String = paragraphs.iter().map(|text| format!("<p>{text}</p>\n")).collect();
    let parameters = serde_json::to_string_pretty(&settings.parameters).unwrap_or_default();
    format!(
        "<h2>Methods</h2>\n{body}<details><summary>All parameters of the matches</summary><pre>{}</pre></details>\n",
        escaped(&parameters)
    )
}
