//! `homolog phantom`: writes a pair of synthetic shapes with their ground truth.

use super::error::CliError;
use super::files::OutputFolder;
use super::output::print;
use clap::{Args, ValueEnum};
use homolog_formats::nifti::write_nifti_gz;
use homolog_formats::ply::write_ply;
use homolog_laboratory::phantom::{
    DEFAULT_EDGE_MM, MAX_RMS_SHARE, PairRecipe, PhantomError, PhantomPair, PhantomVolume,
};
use nalgebra::Point3;
use serde_json::json;
use std::fmt::Write;
use std::path::PathBuf;

/// Write a pair of synthetic hippocampus-like shapes with their ground truth
#[derive(Debug, Clone, Args)]
pub(super) struct PhantomArgs {
    /// Seed of the subject
    #[arg(long, default_value_t = 1)]
    pub(super) subject: u64,
    /// Seed of the target's subject, if it differs; then there is no pointwise ground truth
    #[arg(long, value_name = "SUBJECT")]
    pub(super) target_subject: Option<u64>,
    /// Write label volumes (.nii.gz; 1 anterior, 2 posterior) or surfaces (.ply)
    #[arg(long, value_enum, default_value_t = Kind::Volume)]
    pub(super) kind: Kind,
    /// Voxel spacing of volumes, mm
    #[arg(long, value_name = "MM", default_value_t = 1.0)]
    pub(super) spacing: f64,
    /// Edge length of surfaces, mm
    #[arg(long, value_name = "MM", default_value_t = DEFAULT_EDGE_MM)]
    pub(super) edge: f64,
    #[arg(long, value_name = "SHARE", default_value_t = 0.0, help = format!(
        "RMS displacement of a smooth deformation of the target, as a share of the diagonal (0 to {MAX_RMS_SHARE})"
    ))]
    pub(super) deform: f64,
    /// Seed of the deformation
    #[arg(long, value_name = "SEED", default_value_t = 0)]
    pub(super) deform_seed: u64,
    /// Rotate and translate the target at random with this seed
    #[arg(long, value_name = "SEED")]
    pub(super) rotate_seed: Option<u64>,
    /// Shuffle the vertices of the target surface; the seed is 0 if none is given
    #[arg(long, value_name = "SEED", num_args = 0..=1, default_missing_value = "0")]
    pub(super) permute: Option<u64>,
    /// Folder for source, target, truth.json and truth.csv
    #[arg(long, value_name = "DIR", default_value = "phantom")]
    pub(super) out: PathBuf,
}

/// Kind of the files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Kind {
    /// Label volumes.
    Volume,
    /// Triangle surfaces.
    Surface,
}

/// Runs the command.
///
/// # Errors
/// [`CliError`].
pub(super) fn run(args: &PhantomArgs) -> Result<(), CliError> {
    if args.permute.is_some() && args.kind == Kind::Volume {
        return Err(CliError::BadInput(
            "--permute shuffles vertices, which only surfaces have; add --kind surface".to_owned(),
        ));
    }
    let recipe = PairRecipe {
        subject: args.subject,
        target_subject: args.target_subject.unwrap_or(args.subject),
        deform_share: args.deform,
        deform_seed: args.deform_seed,
        pose_seed: args.rotate_seed,
        permute_seed: args.permute,
    };
    let written = write_pair(&recipe, args.kind, args.spacing, args.edge, &OutputFolder::create(&args.out)?)?;
    let lines: Vec<_> = written.iter().map(|path| path.display().to_string()).collect();
    print(&lines.join("\n"))
}

/// Writes a pair and its ground truth; returns the paths, source and target first.
pub(super) fn write_pair(
    recipe: &PairRecipe,
    kind: Kind,
    spacing_mm: f64,
    edge_mm: f64,
    folder: &OutputFolder,
) -> Result<Vec<PathBuf>, CliError> {
    let bad = |error: PhantomError| CliError::BadInput(error.to_string());
    let pair = PhantomPair::new(recipe.clone()).map_err(bad)?;
    let mut truth = Truth::default();
    let mut written = Vec::new();
    let names = match kind {
        Kind::Volume => ["source.nii.gz", "target.nii.gz"],
        Kind::Surface => ["source.ply", "target.ply"],
    };
    match kind {
        Kind::Volume => {
            written.push(folder.write(names[0], &volume_file(pair.source_volume(spacing_mm).map_err(bad)?)?)?);
            written.push(folder.write(names[1], &volume_file(pair.target_volume(spacing_mm).map_err(bad)?)?)?);
            // A volume has no vertices, so points spread over the true surface serve as ground truth.
            let points = pair.source_surface(DEFAULT_EDGE_MM).map_err(bad)?;
            for p in points.mesh.vertices() {
                truth.add(None, p, &pair.place(p));
            }
        }
        Kind::Surface => {
            let source = pair.source_surface(edge_mm).map_err(bad)?;
            let (target, correspondent) = pair.target_surface(edge_mm).map_err(bad)?;
            written.push(folder.write(names[0], &write_ply(&source.mesh))?);
            written.push(folder.write(names[1], &write_ply(&target.mesh))?);
            if pair.is_one_subject() {
                for (i, p) in source.mesh.vertices().iter().enumerate() {
                    truth.add(Some((i, correspondent[i])), p, &pair.place(p));
                }
            }
        }
    }
    let pose = pair.pose().to_homogeneous();
    let matrix: Vec<Vec<f64>> = (0..4).map(|r| (0..4).map(|c| pose[(r, c)]).collect()).collect();
    let document = json!({
        "version": env!("CARGO_PKG_VERSION"),
        "source": { "file": names[0], "subject": recipe.subject },
        "target": { "file": names[1], "subject": recipe.target_subject },
        "one_subject": pair.is_one_subject(),
        "spacing_mm": (kind == Kind::Volume).then_some(spacing_mm),
        "edge_mm": (kind == Kind::Surface).then_some(edge_mm),
        // target = pose(deformation(source)) for one subject; for two subjects, the rotation of the target's frame.
        "pose": { "seed": recipe.pose_seed, "matrix": matrix },
        "deformation": pair.deformation().map(|d| json!({
            "seed": recipe.deform_seed,
            "rms_share": recipe.deform_share,
            "rms_mm": d.rms_mm(),
            "width_mm": d.width_mm(),
        })),
        "permute_seed": recipe.permute_seed,
        "correspondence": pair.is_one_subject().then_some("truth.csv"),
    });
    written.push(folder.write_json("truth.json", &document)?);
    if pair.is_one_subject() {
        written.push(folder.write("truth.csv", truth.text.as_bytes())?);
    }
    Ok(written)
}

/// The table of known correspondents.
struct Truth {
    text: String,
}

impl Default for Truth {
    fn default() -> Self {
        let header = "source,target,source_x_mm,source_y_mm,source_z_mm,target_x_mm,target_y_mm,target_z_mm\n";
        Truth { text: header.to_owned() }
    }
}

impl Truth {
    fn add(&mut self, vertices: Option<(usize, u32)>, source: &Point3<f64>, target: &Point3<f64>) {
        let (i, j) = vertices.map_or_else(Default::default, |(i, j)| (i.to_string(), j.to_string()));
        let _ = writeln!(
            self.text,
            "{i},{j},{},{},{},{},{},{}",
            source.x, source.y, source.z, target.x, target.y, target.z
        );
    }
}

/// The volume as compressed NIfTI-1.
fn volume_file(volume: PhantomVolume) -> Result<Vec<u8>, CliError> {
    let volume = volume.into_label_volume().map_err(|e| CliError::Failed(e.to_string()))?;
    Ok(write_nifti_gz(&volume))
}
