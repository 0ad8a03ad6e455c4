//! Left and right: subjects of the other side than the template are mirrored.
//!
//! A match of a mirrored subject is stated in the subject's own coordinates. Its record has the points mirrored in `x =
//! 0`, so that all shapes of a study have the handedness of the template. Outputs for a subject are mirrored back.

use crate::cohort::Cohort;
use crate::error::StudyError;
use crate::plan::Study;
use crate::settings::{Settings, TemplateChoice};
use homolog_contract::input::BodySide;

/// The side of the template, if subjects have sides: the requested side, or the side of the subject from which a
/// template is made, or of most subjects of the model; left in a tie.
///
/// # Errors
/// [`StudyError::Settings`] in three cases: a given template has no side although subjects have; a side is given but
/// subjects have none; the parameters of matches mirror, which sides control here.
pub fn template_side(cohort: &Cohort, settings: &Settings) -> Result<Option<BodySide>, StudyError> {
    let input = &settings.parameters.input;
    if input.source.mirror || input.target.mirror {
        let why = "a study mirrors by subject: leave input.source.mirror and input.target.mirror out, and state the side of \
                   each subject (column side of the table, member side in JSON)";
        return Err(StudyError::Settings(why.to_owned()));
    }
    let mut sides = cohort.subjects.iter().filter_map(|subject| subject.side).peekable();
    match (settings.template_side, sides.peek()) {
        (None, None) => return Ok(None),
        (Some(_), None) => {
            let why = "the template has a side, and no subject has: state the side of each subject (column side of the table, \
                       member side in JSON)";
            return Err(StudyError::Settings(why.to_owned()));
        }
        (Some(side), Some(_)) => return Ok(Some(side)),
        (None, Some(_)) => {}
    }
    let TemplateChoice::Made(how) = &settings.template else {
        let why = "subjects have sides: say on which side the template lies (--template-side left or right, template_side in JSON)";
        return Err(StudyError::Settings(why.to_owned()));
    };
    let start = how.start.as_ref().and_then(|id| cohort.subjects.iter().find(|subject| subject.id == *id));
    if let Some(side) = start.and_then(|subject| subject.side) {
        return Ok(Some(side));
    }
    let (left, right): (Vec<BodySide>, Vec<BodySide>) = sides.partition(|side| *side == BodySide::Left);
    Ok(Some(if right.len() > left.len() { BodySide::Right } else { BodySide::Left }))
}

/// Whether a subject on this side is mirrored.
pub fn is_mirrored(side: Option<BodySide>, template_side: Option<BodySide>) -> bool {
    side.is_some() && side != template_side
}

impl Study {
    /// Whether a subject lies on the other side than the template.
    pub fn is_mirrored(&self, subject: usize) -> bool {
        let side = self.cohort.subjects.get(subject).and_then(|subject| subject.side);
        is_mirrored(side, self.settings.template_side)
    }
}
