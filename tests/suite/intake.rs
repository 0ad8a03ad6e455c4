//! From files to closed surfaces of genus 0, or refusals that say where and why.

use crate::real_data::real_files;
use homolog::intake::{IntakeLimits, prepare_surface};
use homolog::matching::parameters::{InputParameters, Method, Repair, SurfaceKind, preset};
use homolog::mesh::topology::analyze;

fn defaults() -> InputParameters {
    preset(Method::Balanced).input
}

#[test]
fn every_real_hippocampus_becomes_a_closed_surface_of_genus_0() {
    for surface in [SurfaceKind::Smooth, SurfaceKind::Voxel] {
        let parameters = InputParameters { surface, ..defaults() };
        let mut changed = Vec::new();
        let mut vertices = Vec::new();
        let mut faults = 0;
        for path in real_files("hippocampus") {
            let bytes = std::fs::read(&path).unwrap();
            let prepared = prepare_surface(&bytes, None, &parameters, &IntakeLimits::default())
                .unwrap_or_else(|e| panic!("{}: {e}", path.display()));
            assert_eq!(analyze(&prepared.mesh).fault, None, "{}", path.display());
            faults += usize::from(prepared.report.topology.genus != Some(0));
            vertices.push(prepared.mesh.n_vertices());
            let numbers = |detail: &str| -> usize {
                detail.rsplit(';').next().unwrap().split(' ').filter_map(|w| w.parse::<usize>().ok()).sum()
            };
            let fills = prepared.report.repairs.iter().filter(|r| r.repair == Repair::Fill);
            changed.push(fills.map(|r| numbers(&r.detail)).sum::<usize>());
        }
        if changed.is_empty() {
            return;
        }
        changed.sort_unstable();
        vertices.sort_unstable();
        let n = changed.len();
        println!(
            "{surface:?}: {n} files, {faults} faulty before repair, {} filled; voxels changed median {} max {}; \
             vertices {} to {}, median {}",
            changed.iter().filter(|&&c| c > 0).count(),
            changed[n / 2],
            changed[n - 1],
            vertices[0],
            vertices[n - 1],
            vertices[n / 2]
        );
    }
}
