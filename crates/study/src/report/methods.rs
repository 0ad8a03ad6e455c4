//! Description of the methods of the study for a supplement, with versions and parameters.

use super::escaped;
use crate::complex::Structure;
use crate::findings::Findings;
use crate::joint::JointFindings;
use crate::plan::Study;
use crate::rivals::GroupDecision;
use crate::settings::{Size, TemplateChoice, Visits};
use crate::subjects::SubjectFindings;
use homolog_contract::parameters::Method;

/// The section on methods.
pub(super) fn text(study: &Study, found: &Findings, commit: &str) -> String {
    let settings = &study.settings;
    let n = found.members.len();
    let mut paragraphs = Vec::new();
    let template = match &found.complex {
        None => whole_template(study, found),
        Some(complex) => of_structures(&complex.structures),
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
    if settings.visits == Visits::OwnTemplate {
        let (own, persons) = (found.matched.own.len(), study.persons.len());
        paragraphs.push(format!(
            "{own} of {persons} persons with several visits have a template of their own: the mean of the images, in all visits, of a \
             first mean of these. The template of the group was matched to it, and the map to a visit is this match, followed by \
             the map to the visit. All other visits were matched directly."
        ));
    }
    paragraphs.extend(poses(found));
    paragraphs.extend(found.joint.as_ref().map(|joint| joint_maps("all subjects", joint)));
    for structure in found.complex.iter().flat_map(|complex| &complex.structures) {
        let what = format!("the {}", escaped(&structure.name));
        paragraphs.extend(structure.joint.as_ref().map(|joint| joint_maps(&what, joint)));
    }
    if let Some(statistics) = &found.statistics {
        let columns: Vec<String> = statistics.design.columns.iter().map(|column| escaped(column)).collect();
        let contrasts: Vec<String> = statistics
            .design
            .contrasts
            .iter()
            .map(|c| format!("{} ({})", escaped(&c.name), escaped(&c.meaning)))
            .collect();
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
            let (pairs, exchanges, null) = match &statistics.pairs {
                None => (String::new(), "permutations (Freedman, Lane", "residuals are exchangeable"),
                Some(of) => {
                    let n = of.pairs.len();
                    let text = format!("Differences within {n} subjects were tested against zero ({} without a pair). ", of.single);
                    (text, "sign flips of these differences (Winkler et al. 2014", "differences are symmetric about zero")
                }
            };
            format!(
                "{pairs}Standard errors, their p and the false discovery rate are robust to unequal variances (HC3). The error over \
                 the whole surface is controlled by {} {exchanges}; seed {}) of the largest threshold-free cluster \
                 enhancement of |t| (H = 2, E = 1, area of the mean), where t is the ordinary one with pooled variance: under the \
                 null hypothesis {null}; the false discovery rate by Benjamini and Hochberg from the robust p. A vertex is \
                 significant if both are below 0.05 (intersection-union test, Berger 1982). Intervals of g \
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
        "<h2>Methods</h2>\n{body}<p>In the parameters, inference and clamping belong to the energy over curvature, which is optional: \
         none does not switch off the belief propagation over distances along the surface that begins every match.</p>\n<details><summary>All parameters of the matches</summary><pre>{0}</pre></details>\n\
         <p class=\"printed\">All parameters of the matches:</p>\n<pre class=\"printed\">{0}</pre>\n",
        escaped(&parameters)
    )
}

/// How the template of one structure was made and matched.
fn whole_template(study: &Study, found: &Findings) -> String {
    match &study.settings.template {
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
    }
}

/// How the templates of several structures were made and matched.
fn of_structures(structures: &[Structure]) -> String {
    let template = |structure: &Structure| {
        let name = escaped(&structure.name);
        match structure.rounds.last() {
            None => format!("{name}: given"),
            Some(last) => format!(
                "{name}: made from {} subjects in {} rounds, the last of which moved its surface by {:.3} of its mean edge (RMS)",
                last.subjects,
                structure.rounds.len(),
                last.moved_share
            ),
        }
    };
    let templates: Vec<String> = structures.iter().map(template).collect();
    let first = structures.first().map_or(String::new(), |first| escaped(&first.name));
    format!(
        "Each structure has a template of its own ({}), which was matched to that structure of every subject. The mapped templates of a \
         subject, in its coordinates, are one shape, so that the pose of the structures relative to one another is part of shape. Shift \
         and rotation of a structure are those that remain relative to the mean after rigid alignment of {first}. The maps are one map \
         each over all structures, and clusters do not extend over several",
        templates.join("; ")
    )
}

/// How poses that matches leave open were decided; `None` where there are none.
fn poses(found: &Findings) -> Option<String> {
    let all: Vec<&GroupDecision> =
        found.subjects.iter().flat_map(SubjectFindings::group_decisions).map(|(_, decision)| decision).collect();
    let decided = all.iter().filter(|decision| decision.decided).count();
    (!all.is_empty()).then(|| {
        format!(
            "Several poses explained {} surfaces equally well. Each was matched in all of these poses, and the pose was taken whose map \
             is consistent with those of the other subjects: shapes were taken as draws from one Gaussian distribution with the \
             variance of the reliable subjects in each independent direction, and marginal probabilities were computed by belief \
             propagation over all subjects. {decided} had a marginal of at least 0.95 and a shape within the range of the reliable subjects; \
             the others are left out unless a decision keeps them. Covariates were not used.",
            all.len()
        )
    })
}

/// How joint maps were made.
fn joint_maps(whose: &str, joint: &JointFindings) -> String {
    let slid = joint.rounds.last().map_or(0.0, |round| round.slid_mm);
    format!(
        "The maps of {whose} were then revised together in {} rounds, the last of which moved vertices along the surfaces by \
         {slid:.3} mm (RMS): each map under a Gaussian model of the other subjects ({} modes, made from {} subjects, a {} of them \
         left out in turn), with a smooth field between model and subject (stiffness {:.2}). The model has not seen covariates.",
        joint.rounds.len(),
        joint.modes,
        joint.subjects,
        if joint.subjects <= 20 { "single one" } else { "twentieth" },
        joint.stiffness
    )
}

/// The literature of what this study used, for a supplement.
pub(super) fn references(study: &Study, found: &Findings) -> String {
    let settings = &study.settings;
    let mut list = Vec::new();
    list.extend(match settings.parameters.method {
        Method::Cpd => vec![CPD],
        Method::Bcpd => vec![BCPD],
        Method::NonrigidIcp => vec![NONRIGID_ICP],
        Method::SpharmPdm => vec![SPHARM],
        Method::FunctionalMap => vec![FUNCTIONAL_MAPS],
        Method::Icp => vec![ICP],
        _ => vec![RANSAC, GAUSSIAN_PROCESSES],
    });
    list.extend([PROCRUSTES, SHAPE_MODELS, MODEL_QUALITY]);
    if settings.visits == Visits::OwnTemplate {
        list.push(OWN_TEMPLATES);
    }
    if poses(found).is_some() {
        list.extend([BELIEF_PROPAGATION, CONSISTENT_MAPS]);
    }
    if found.joint_maps().next().is_some() {
        list.extend([ENTROPY, PROBABILISTIC_COMPONENTS]);
    }
    if let Some(statistics) = &found.statistics {
        if statistics.longitudinal {
            list.push(REML);
        } else {
            list.extend([ROBUST_ERRORS, FREEDMAN_LANE, INTERSECTION_UNION, PERMUTATIONS, TFCE]);
        }
        list.push(FALSE_DISCOVERIES);
        if !statistics.whole.is_empty() {
            list.push(HEDGES);
        }
    }
    if found.labels.as_ref().is_some_and(|labels| !labels.dice.is_empty()) {
        list.push(DICE);
    }
    list.sort_unstable();
    let items: String = list.iter().map(|text| format!("<li>{}</li>", escaped(text))).collect();
    format!("<h2>References</h2>\n<ol class=\"references\">{items}</ol>\n")
}

const BCPD: &str = "Hirose, O. (2021). A Bayesian formulation of coherent point drift. IEEE Transactions on Pattern Analysis and Machine Intelligence 43(7), 2269–2286.";
const BELIEF_PROPAGATION: &str = "Pearl, J. (1988). Probabilistic Reasoning in Intelligent Systems. Morgan Kaufmann.";
const CONSISTENT_MAPS: &str = "Nguyen, A., Ben-Chen, M., Welnicka, K., Ye, Y., Guibas, L. (2011). An optimization approach to improving collections of shape maps. Computer Graphics Forum 30(5), 1481–1491.";
const CPD: &str = "Myronenko, A., Song, X. (2010). Point set registration: coherent point drift. IEEE Transactions on Pattern Analysis and Machine Intelligence 32(12), 2262–2275.";
const DICE: &str =
    "Dice, L. R. (1945). Measures of the amount of ecologic association between species. Ecology 26(3), 297–302.";
const ENTROPY: &str = "Cates, J., Fletcher, P. T., Styner, M., Shenton, M., Whitaker, R. (2007). Shape modeling and analysis with entropy-based particle systems. Information Processing in Medical Imaging, 333–345.";
const FALSE_DISCOVERIES: &str = "Benjamini, Y., Hochberg, Y. (1995). Controlling the false discovery rate: a practical and powerful approach to multiple testing. Journal of the Royal Statistical Society B 57(1), 289–300.";
const FREEDMAN_LANE: &str = "Freedman, D., Lane, D. (1983). A nonstochastic interpretation of reported significance levels. Journal of Business & Economic Statistics 1(4), 292–298.";
const FUNCTIONAL_MAPS: &str = "Ovsjanikov, M., Ben-Chen, M., Solomon, J., Butscher, A., Guibas, L. (2012). Functional maps: a flexible representation of maps between shapes. ACM Transactions on Graphics 31(4), 30.";
const GAUSSIAN_PROCESSES: &str = "Lüthi, M., Gerig, T., Jud, C., Vetter, T. (2018). Gaussian process morphable models. IEEE Transactions on Pattern Analysis and Machine Intelligence 40(8), 1860–1873.";
const HEDGES: &str = "Hedges, L. V. (1981). Distribution theory for Glass's estimator of effect size and related estimators. Journal of Educational Statistics 6(2), 107–128.";
const ICP: &str = "Besl, P. J., McKay, N. D. (1992). A method for registration of 3-D shapes. IEEE Transactions on Pattern Analysis and Machine Intelligence 14(2), 239–256.";
const INTERSECTION_UNION: &str =
    "Berger, R. L. (1982). Multiparameter hypothesis testing and acceptance sampling. Technometrics 24(4), 295–300.";
const MODEL_QUALITY: &str = "Davies, R. H., Twining, C. J., Cootes, T. F., Waterton, J. C., Taylor, C. J. (2002). A minimum description length approach to statistical shape modeling. IEEE Transactions on Medical Imaging 21(5), 525–537.";
const NONRIGID_ICP: &str = "Amberg, B., Romdhani, S., Vetter, T. (2007). Optimal step nonrigid ICP algorithms for surface registration. IEEE Conference on Computer Vision and Pattern Recognition.";
const OWN_TEMPLATES: &str = "Reuter, M., Schmansky, N. J., Rosas, H. D., Fischl, B. (2012). Within-subject template estimation for unbiased longitudinal image analysis. NeuroImage 61(4), 1402–1418.";
const PERMUTATIONS: &str = "Winkler, A. M., Ridgway, G. R., Webster, M. A., Smith, S. M., Nichols, T. E. (2014). Permutation inference for the general linear model. NeuroImage 92, 381–397.";
const PROBABILISTIC_COMPONENTS: &str = "Tipping, M. E., Bishop, C. M. (1999). Probabilistic principal component analysis. Journal of the Royal Statistical Society B 61(3), 611–622.";
const PROCRUSTES: &str = "Gower, J. C. (1975). Generalized Procrustes analysis. Psychometrika 40(1), 33–51.";
const RANSAC: &str = "Fischler, M. A., Bolles, R. C. (1981). Random sample consensus: a paradigm for model fitting with applications to image analysis and automated cartography. Communications of the ACM 24(6), 381–395.";
const REML: &str = "Patterson, H. D., Thompson, R. (1971). Recovery of inter-block information when block sizes are unequal. Biometrika 58(3), 545–554.";
const ROBUST_ERRORS: &str = "MacKinnon, J. G., White, H. (1985). Some heteroskedasticity-consistent covariance matrix estimators with improved finite sample properties. Journal of Econometrics 29(3), 305–325.";
const SHAPE_MODELS: &str = "Cootes, T. F., Taylor, C. J., Cooper, D. H., Graham, J. (1995). Active shape models: their training and application. Computer Vision and Image Understanding 61(1), 38–59.";
const SPHARM: &str = "Styner, M., Oguz, I., Xu, S., Brechbühler, C., Pantazis, D., Levitt, J. J., Shenton, M. E., Gerig, G. (2006). Framework for the statistical shape analysis of brain structures using SPHARM-PDM. Insight Journal.";
const TFCE: &str = "Smith, S. M., Nichols, T. E. (2009). Threshold-free cluster enhancement: addressing problems of smoothing, threshold dependence and localisation in cluster inference. NeuroImage 44(1), 83–98.";
