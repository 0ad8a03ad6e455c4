//! Real files of every format, as their programs wrote them.

use crate::real_data::{real, real_files};
use homolog_formats::{FileContent, FormatError, InputFormat, MeshFile, ReadLimits, read};
use homolog_mesh::repair::{largest_component, weld};
use homolog_mesh::topology::{TopologyReport, topology_report};

fn read_real(path: &str) -> Option<Result<(InputFormat, FileContent), FormatError>> {
    let bytes = std::fs::read(real(path)?).unwrap();
    Some(read(&bytes, None, &ReadLimits::default()))
}

fn mesh(path: &str) -> Option<(InputFormat, MeshFile, TopologyReport)> {
    match read_real(path)?.unwrap_or_else(|e| panic!("{path}: {e}")) {
        (format, FileContent::Mesh(file)) => {
            let report = topology_report(&file.mesh);
            Some((format, file, report))
        }
        _ => panic!("{path} is a mesh"),
    }
}

/// Format, vertices, faces, genus.
fn check(path: &str, format: InputFormat, n_vertices: u32, n_faces: u32, genus: Option<u32>) {
    let Some((found, _, report)) = mesh(path) else { return };
    assert_eq!(
        (found, report.n_vertices, report.n_faces, report.genus),
        (format, n_vertices, n_faces, genus),
        "{path}: {report:?}"
    );
}

#[test]
fn ply_files() {
    // This cube's faces disagree in orientation, in all three formats.
    check("formats/ply/cube.ply", InputFormat::Ply, 8, 12, None);
    check("formats/ply/invMotor.ply", InputFormat::Ply, 696, 1380, Some(0));
}

#[test]
fn stl_files() {
    check("formats/stl/cube.stl", InputFormat::Stl, 8, 12, None);
    check("formats/stl/cube_bin.stl", InputFormat::Stl, 8, 12, Some(0));
    check("formats/stl/42400-IDGH.stl", InputFormat::Stl, 5500, 11036, Some(10));
}

#[test]
fn vtk_files() {
    check("formats/vtk/cube.vtk", InputFormat::Vtk, 8, 12, None);
    check("formats/vtk/cubeTria.vtk", InputFormat::Vtk, 2402, 4800, Some(0));
    check("formats/vtk/fran_cut.vtk", InputFormat::Vtk, 2205, 4224, None);
    if let Some(faults) = read_real("formats/vtk/faults.vtk") {
        assert!(matches!(faults, Err(FormatError::Mesh(_))), "only lines");
    }
}

#[test]
fn nifti_files() {
    let Some(atlas) = read_real("formats/nifti/aal.nii.gz") else { return };
    let (format, FileContent::Labels(volume)) = atlas.unwrap() else { panic!("a volume is expected") };
    assert_eq!((format, volume.dims()), (InputFormat::Nifti, [181, 217, 181]));
    let counts = volume.label_counts();
    assert!(counts.contains_key(&37) && counts.contains_key(&38) && counts.len() >= 116, "{counts:?}");
    // Left hippocampus lies left of the midline in world coordinates.
    let center = |label| {
        let mask = volume.mask(Some(&[label])).unwrap();
        homolog_mesh::volume::voxel_surface(&mask).unwrap().centroid()
    };
    let (left, right) = (center(37), center(38));
    assert!(left.x < -15.0 && right.x > 15.0 && (left.y - right.y).abs() < 5.0, "{left} {right}");
}

#[test]
fn structures_are_closed_after_welding() {
    for path in real_files("structures") {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let (_, file, before) = mesh(&format!("structures/{name}")).unwrap();
        let welded = weld(&file.mesh).unwrap().mesh;
        let report = topology_report(&largest_component(&welded).mesh);
        let genus = if name.contains("right_amygdala") {
            1
        } else if name.contains("right_caudate") {
            3
        } else {
            0
        };
        println!(
            "{name}: {} vertices, {} boundary edges before; {report:?}",
            before.n_vertices, before.n_boundary_edges
        );
        assert_eq!(report.genus, Some(genus), "{name}: {report:?}");
    }
}
