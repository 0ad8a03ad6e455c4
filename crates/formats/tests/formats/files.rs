//! Files as programs write them: the fixtures of the repository, and real files of every format.

use crate::fixtures::fixture;
use homolog_formats::{FileContent, FormatError, GzipFault, InputFormat, MeshFile, ReadLimits, read};
use homolog_mesh::repair::{largest_component, weld};
use homolog_mesh::topology::{TopologyReport, topology_report};
use homolog_mesh::volume::{LabelVolume, voxel_surface};

fn read_bytes(bytes: &[u8]) -> Result<(InputFormat, FileContent), FormatError> {
    read(bytes, None, &ReadLimits::default()).map(|file| (file.format, file.content))
}

fn mesh(name: &str, bytes: &[u8]) -> (InputFormat, MeshFile, TopologyReport) {
    match read_bytes(bytes).unwrap_or_else(|e| panic!("{name}: {e}")) {
        (format, FileContent::Mesh(file)) => {
            let report = topology_report(&file.mesh);
            (format, file, report)
        }
        _ => panic!("{name} is a mesh"),
    }
}

fn volume(name: &str, bytes: &[u8]) -> LabelVolume {
    match read_bytes(bytes).unwrap_or_else(|e| panic!("{name}: {e}")) {
        (InputFormat::Nifti, FileContent::Labels(volume)) => volume,
        _ => panic!("{name} is a label volume"),
    }
}

/// Format, vertices, faces, genus.
fn check(name: &str, bytes: &[u8], format: InputFormat, n_vertices: u32, n_faces: u32, genus: Option<u32>) {
    let (found, _, report) = mesh(name, bytes);
    assert_eq!(
        (found, report.n_vertices, report.n_faces, report.genus),
        (format, n_vertices, n_faces, genus),
        "{name}: {report:?}"
    );
}

/// Genus of the largest component after welding.
fn genus_after_welding(file: &MeshFile) -> Option<u32> {
    topology_report(&largest_component(&weld(&file.mesh).unwrap().mesh).mesh).genus
}

#[test]
fn one_surface_reads_the_same_from_every_mesh_format() {
    let [(_, ply, report), (_, stl, _), (_, vtk, _)] =
        ["ply", "stl", "vtk"].map(|e| format!("surface-1.{e}")).map(|name| mesh(&name, &fixture(&name)));
    let (n_vertices, n_faces) = (report.n_vertices, report.n_faces);
    assert!(n_faces == 2 * n_vertices - 4 && n_vertices > 100, "{report:?}");
    for (name, format) in [("ply", InputFormat::Ply), ("stl", InputFormat::Stl), ("vtk", InputFormat::Vtk)] {
        let name = format!("surface-1.{name}");
        check(&name, &fixture(&name), format, n_vertices, n_faces, Some(0));
    }
    assert_eq!(ply.mesh, vtk.mesh);
    // STL has single precision and an order of vertices of its own.
    assert!(stl.welded && (stl.mesh.signed_volume() / ply.mesh.signed_volume() - 1.0).abs() < 1e-6);
}

#[test]
fn an_unwelded_surface_is_closed_after_welding() {
    let (_, file, before) = mesh("unwelded-1.vtk", &fixture("unwelded-1.vtk"));
    assert!(before.genus.is_none() && before.n_boundary_edges > 0, "{before:?}");
    assert_eq!(genus_after_welding(&file), Some(0));
}

#[test]
fn label_volumes_keep_labels_and_place() {
    for name in ["subject-1.nii.gz", "subject-2.nii.gz"] {
        let volume = volume(name, &fixture(name));
        let counts = volume.label_counts();
        assert_eq!(counts.keys().copied().filter(|label| *label > 0).collect::<Vec<_>>(), [1, 2], "{name}");
        assert!(counts[&1] > 500 && counts[&2] > 500, "{name}: {counts:?}");
        // The anterior part lies in front of the posterior one in world coordinates.
        let [front, back] =
            [1, 2].map(|label| voxel_surface(&volume.mask(Some(&[label])).unwrap()).unwrap().centroid());
        assert!(front.y > back.y + 5.0, "{name}: {front} {back}");
    }
}

#[test]
fn a_fixture_with_a_flipped_bit_of_its_trailer_is_refused() {
    for name in ["subject-1.nii.gz", "ring.nii.gz"] {
        let mut bytes = fixture(name);
        let at = bytes.len() - 6;
        bytes[at] ^= 1;
        assert!(matches!(read_bytes(&bytes), Err(FormatError::Gzip { fault: GzipFault::Checksum, .. })), "{name}");
    }
}

/// Files of other programs and scanners, which are not part of the repository.
mod real_data {
    use super::*;
    use crate::fixtures::{real, real_files};

    fn bytes(path: &str) -> Vec<u8> {
        std::fs::read(real(path)).unwrap()
    }

    fn check(path: &str, format: InputFormat, n_vertices: u32, n_faces: u32, genus: Option<u32>) {
        super::check(path, &bytes(path), format, n_vertices, n_faces, genus);
    }

    #[test]
    #[ignore = "needs real data (formats/ply)"]
    fn ply_files() {
        // This cube's faces disagree in orientation, in all three formats.
        check("formats/ply/cube.ply", InputFormat::Ply, 8, 12, None);
        check("formats/ply/invMotor.ply", InputFormat::Ply, 696, 1380, Some(0));
    }

    #[test]
    #[ignore = "needs real data (formats/stl)"]
    fn stl_files() {
        check("formats/stl/cube.stl", InputFormat::Stl, 8, 12, None);
        check("formats/stl/cube_bin.stl", InputFormat::Stl, 8, 12, Some(0));
        check("formats/stl/42400-IDGH.stl", InputFormat::Stl, 5500, 11036, Some(10));
    }

    #[test]
    #[ignore = "needs real data (formats/vtk)"]
    fn vtk_files() {
        check("formats/vtk/cube.vtk", InputFormat::Vtk, 8, 12, None);
        check("formats/vtk/cubeTria.vtk", InputFormat::Vtk, 2402, 4800, Some(0));
        check("formats/vtk/fran_cut.vtk", InputFormat::Vtk, 2205, 4224, None);
        let faults = read_bytes(&bytes("formats/vtk/faults.vtk"));
        assert!(matches!(faults, Err(FormatError::Mesh(_))), "only lines");
    }

    #[test]
    #[ignore = "needs real data (formats/nifti)"]
    fn nifti_files() {
        let atlas = volume("aal.nii.gz", &bytes("formats/nifti/aal.nii.gz"));
        assert_eq!(atlas.dims(), [181, 217, 181]);
        let counts = atlas.label_counts();
        assert!(counts.contains_key(&37) && counts.contains_key(&38) && counts.len() >= 116, "{counts:?}");
        // The left hippocampus lies left of the midline in world coordinates.
        let center = |label| voxel_surface(&atlas.mask(Some(&[label])).unwrap()).unwrap().centroid();
        let (left, right) = (center(37), center(38));
        assert!(left.x < -15.0 && right.x > 15.0 && (left.y - right.y).abs() < 5.0, "{left} {right}");
    }

    #[test]
    #[ignore = "needs real data (hippocampus, structures)"]
    fn no_real_file_is_taken_for_damaged() {
        let files: Vec<_> = ["hippocampus", "structures"].into_iter().flat_map(real_files).collect();
        for path in &files {
            let bytes = std::fs::read(path).unwrap();
            read_bytes(&bytes).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        }
        println!("{} files read", files.len());
    }

    #[test]
    #[ignore = "needs real data (structures)"]
    fn structures_are_closed_after_welding() {
        for path in real_files("structures") {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            let (_, file, before) = mesh(&name, &std::fs::read(&path).unwrap());
            let genus = if name.contains("right_amygdala") {
                1
            } else if name.contains("right_caudate") {
                3
            } else {
                0
            };
            println!("{name}: {} vertices, {} boundary edges before", before.n_vertices, before.n_boundary_edges);
            assert_eq!(genus_after_welding(&file), Some(genus), "{name}");
        }
    }
}
