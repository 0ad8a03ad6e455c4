//! How far the templates of two studies are from each other, as surfaces: made from other starts, they should be one. The first is
//! moved rigidly onto the second; they lie roughly on each other, as surfaces of one scanner's axes do once they are centered.
//! `make study` runs it.
//!
//! Usage: `templates_apart FOLDER FOLDER`.
#![allow(clippy::print_stdout)]

use homolog_formats::ReadLimits;
use homolog_formats::ply::read_ply;
use homolog_mesh::SurfaceMesh;
use homolog_study::average::{surface_distance, triangle_quality};
use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().collect();
    let [_, first, second] = arguments.as_slice() else {
        return Err("usage: templates_apart FOLDER FOLDER".into());
    };
    let read = |folder: &String| -> Result<SurfaceMesh, Box<dyn Error>> {
        let bytes = std::fs::read(Path::new(folder).join("template/template.ply"))?;
        Ok(read_ply(&bytes, &ReadLimits::default())?.mesh)
    };
    let (a, b) = (read(first)?, read(second)?);
    let shift = b.centroid() - a.centroid();
    let a = a.with_vertices(a.vertices().iter().map(|p| p + shift).collect())?;
    let found = surface_distance(&a, &b)?;
    let (edge, quality) = (a.mean_edge_length(), [triangle_quality(&a), triangle_quality(&b)]);
    println!("{:.4} mm RMS, {:.4} mm mean, {:.3} mm at most", found.rms_mm, found.mean_mm, found.largest_mm);
    println!("{:.3} of the mean edge of {edge:.3} mm, RMS; triangle quality {quality:.3?}", found.rms_mm / edge);
    Ok(())
}
