//! The arguments of `homolog match`.

use super::parameters::{LimitArgs, ParameterArgs};
use crate::jobs::{GivenUids, Uid};
use clap::Args;
use std::path::PathBuf;

/// Match surfaces: compute the dense correspondence and the rigid transform
///
/// With one target, the verdict and the numbers of the pair are printed. With several targets, the source, such as a
/// template, is matched to each target, so the rows of all answers are the vertices of the source; a table with a line
/// for each target is printed.
#[derive(Debug, Clone, Args)]
pub(super) struct MatchArgs {
    /// Source: the surface that is moved; a surface (GIFTI, FreeSurfer, PLY, STL, VTK, VTP, OBJ, OFF, MZ3) or a label volume
    /// (NIfTI, MGZ, NRRD, MetaImage, DICOM SEG)
    pub(super) source: PathBuf,
    /// Target: the surface that stays in place; with several targets, the source is matched to each of them
    #[arg(required = true, value_name = "TARGET")]
    pub(super) targets: Vec<PathBuf>,
    #[command(flatten)]
    pub(super) parameters: ParameterArgs,
    #[command(flatten)]
    pub(super) limits: LimitArgs,
    /// Folder for result.json, correspondences.csv, source.ply, target.ply, aligned.ply (moved rigidly), warped.ply, .vtp,
    /// .surf.gii and .csv (the source deformed onto the target), transform.tfm, .lta and, for DICOM inputs,
    /// transform.dcm and warped.dcm, and trace.jsonl; with several targets, for a folder with these and a report.html for each,
    /// and summary.csv
    #[arg(long, value_name = "DIR")]
    pub(super) out: Option<PathBuf>,
    /// UID of the DICOM study for transform.dcm and warped.dcm, if neither input is a DICOM object
    #[arg(long, value_name = "UID", requires = "out")]
    pub(super) study_uid: Option<Uid>,
    /// UID of the frame of reference of the source, if it is not a DICOM object
    #[arg(long, value_name = "UID", requires = "out")]
    pub(super) source_frame_uid: Option<Uid>,
    /// UID of the frame of reference of the target, if it is not a DICOM object
    #[arg(long, value_name = "UID", requires = "out")]
    pub(super) target_frame_uid: Option<Uid>,
    /// File for a page with the verdict, both surfaces to rotate with the mouse, and all numbers; it contains no file
    /// names
    #[arg(long, value_name = "PAGE.html")]
    pub(super) html: Option<PathBuf>,
    /// Print the result document, and nothing else, as JSON; with several targets a line for each: target, result or error
    #[arg(long)]
    pub(super) json: bool,
}

impl MatchArgs {
    pub(super) fn uids(&self) -> GivenUids {
        let (study, source_frame) = (self.study_uid.clone(), self.source_frame_uid.clone());
        GivenUids { study, source_frame, target_frame: self.target_frame_uid.clone() }
    }
}
