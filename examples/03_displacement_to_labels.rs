//! Carries the labels of one volume to another: the displacement bends the source's surface onto the target, and each voxel of the
//! target's structure gets the label of the nearest point of the bent surface.
//!
//! Usage: `03_displacement_to_labels SOURCE TARGET OUT.nii.gz`, with label volumes of the same structure.
#![allow(clippy::print_stdout, reason = "an example")]

use homolog_formats::{FileContent, ReadLimits, read, write_nifti_gz};
use homolog_matching::{Method, Silent, preset};
use homolog_mesh::volume::LabelVolume;
use homolog_run::{InputFile, intake::IntakeLimits, run_match};
use homolog_study::labels::{carried, dice, labels_at};

type Failure = Box<dyn std::error::Error>;

/// A label volume, and its labels in ascending order.
fn volume(bytes: &[u8]) -> Result<(LabelVolume, Vec<u32>), Failure> {
    let FileContent::Labels(volume) = read(bytes, None, &ReadLimits::default())?.content else {
        return Err("a label volume is needed".into());
    };
    let labels = volume.label_counts().into_keys().filter(|label| *label != 0).collect();
    Ok((volume, labels))
}

fn main() -> Result<(), Failure> {
    let paths: Vec<String> = std::env::args().skip(1).collect();
    let [source, target, out] = paths.as_slice() else {
        return Err("usage: 03_displacement_to_labels SOURCE TARGET OUT.nii.gz".into());
    };
    let (source, target) = (std::fs::read(source)?, std::fs::read(target)?);
    let files = [&source, &target].map(|bytes| InputFile { bytes, name: None });
    let found = run_match(files[0], files[1], &preset(Method::Balanced), &IntakeLimits::default(), &Silent)?;

    let ((source, labels), (target, its_labels)) = (volume(&source)?, volume(&target)?);
    let of_vertex = labels_at(&source, &labels, found.source.vertices(), &Silent)?;
    let bent = found.warped(homolog_contract::result::WarpDirection::Forward)?.mesh;
    let of_voxel = carried(&target, &its_labels, &bent, &of_vertex, &Silent)?;
    for (label, dice) in labels.iter().zip(dice(&of_voxel, target.labels(), &labels)) {
        println!("label {label}: Dice with the target's own label {:.3}", dice.unwrap_or(0.0));
    }
    std::fs::write(out, write_nifti_gz(&LabelVolume::new(target.dims(), of_voxel, *target.affine())?))?;
    Ok(())
}
