//! One surface of a match at one level, with all values that do not depend on the other surface.

use super::form::BendingInvariantForm;
use super::light_smoothing::lightly_smoothed;
use super::sites::Sites;
use super::surface_index::SurfaceIndex;
use homolog_geometry::curvature::{default_radius_mm, vertex_areas};
use homolog_geometry::hierarchy::{CoarseSurface, coarsen_observed};
use homolog_mesh::{CanonicalMesh, Numbering, SurfaceMesh, canonicalize};
use homolog_primitives::observe::{Cancelled, Observer};
use nalgebra::Vector3;
use std::mem::size_of;
use std::sync::{Arc, OnceLock};

/// Scale of the positions that poses and displacement fields are fitted to, in roots of the area. It removes voxel
/// steps.
pub(crate) const POSITION_SCALE: f64 = 0.0175;

/// Length of a rim above which a surface is open, in roots of the area. Cuts through an end of a structure are longer;
/// holes of a segmentation or scan are shorter, and nothing is missing there.
const OPEN: f64 = 0.2;

/// One surface at one level. Immutable: the parts that are computed on first use depend only on this surface. They are
/// computed on one thread, so that a thread that waits for them never waits for work that it has queued itself.
pub(crate) struct SurfaceLevel {
    /// In canonical numbering, with the map back to the numbering of the outcome.
    pub surface: CanonicalMesh,
    /// Unit normals of its vertices.
    pub normals: Vec<Vector3<f64>>,
    /// Square root of the area of the surface with all its vertices, mm.
    pub root_mm: f64,
    /// Whether the surface with all its vertices is open, so that a region of it may be missing.
    pub is_open: bool,
    /// The finer surface on which features are measured instead, and its vertex at each vertex of this one: curvature
    /// on a coarse level would depend on its triangles.
    measured_on: Option<(Arc<SurfaceLevel>, Vec<u32>)>,
    closest: OnceLock<SurfaceIndex>,
    light: OnceLock<LightSide>,
    form: OnceLock<Option<BendingInvariantForm>>,
    sites: OnceLock<Sites>,
}

/// A surface smoothed at [`POSITION_SCALE`].
pub(crate) struct LightSide {
    pub mesh: SurfaceMesh,
    /// Areas of its vertices, mm².
    pub areas: Vec<f64>,
    /// Closest points of the smoothed surface.
    pub closest: SurfaceIndex,
}

impl SurfaceLevel {
    pub(crate) fn new(mesh: &SurfaceMesh) -> Self {
        SurfaceLevel::numbered(mesh, &Numbering::identity(mesh.n_vertices()))
    }

    /// The side of `mesh`, whose vertices the outcome names by their originals in `numbering`.
    pub(crate) fn numbered(mesh: &SurfaceMesh, numbering: &Numbering) -> Self {
        let CanonicalMesh { mesh, numbering: canonical } = canonicalize(mesh);
        let surface = CanonicalMesh { mesh, numbering: canonical.over(numbering) };
        let normals = surface.mesh.vertex_normals();
        let root_mm = surface.mesh.area().sqrt();
        let is_open = surface.mesh.rim_lengths().first().is_some_and(|longest| *longest > OPEN * root_mm);
        SurfaceLevel {
            surface,
            normals,
            root_mm,
            is_open,
            measured_on: None,
            closest: OnceLock::new(),
            light: OnceLock::new(),
            form: OnceLock::new(),
            sites: OnceLock::new(),
        }
    }

    /// A coarser level of `finer` of about `n_sites` vertices, and for every vertex of `finer` the one it belongs to.
    /// `None` where `finer` is that coarse already. If `inherits`, features are measured on `finer`.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub(crate) fn coarser(
        finer: &Arc<SurfaceLevel>,
        n_sites: usize,
        inherits: bool,
        observer: &dyn Observer,
    ) -> Result<Option<(SurfaceLevel, Vec<u32>)>, Cancelled> {
        let Some(coarse) = coarsen_observed(finer.mesh(), n_sites, observer)? else { return Ok(None) };
        let CoarseSurface { mesh, sites, cells } = coarse;
        let numbering = finer.surface.numbering.select(&sites);
        let normals = mesh.vertex_normals();
        let measured_on = inherits.then(|| (Arc::clone(finer), sites));
        let surface = CanonicalMesh { mesh, numbering };
        let (root_mm, is_open) = (finer.root_mm, finer.is_open);
        Ok(Some((
            SurfaceLevel {
                surface,
                normals,
                root_mm,
                is_open,
                measured_on,
                closest: OnceLock::new(),
                light: OnceLock::new(),
                form: OnceLock::new(),
                sites: OnceLock::new(),
            },
            cells,
        )))
    }

    pub(crate) fn mesh(&self) -> &SurfaceMesh {
        &self.surface.mesh
    }

    /// The finer surface on which features are measured, if any, and its vertex at each vertex of this one.
    pub(crate) fn measured_on(&self) -> Option<(&SurfaceLevel, &[u32])> {
        self.measured_on.as_ref().map(|(finer, sites)| (finer.as_ref(), sites.as_slice()))
    }

    /// Default radius of curvature estimators, mm.
    pub(crate) fn feature_radius_mm(&self) -> f64 {
        self.measured_on().map_or_else(|| default_radius_mm(self.mesh()), |(finer, _)| finer.feature_radius_mm())
    }

    /// Closest points of the surface.
    pub(crate) fn closest(&self) -> &SurfaceIndex {
        self.closest.get_or_init(|| SurfaceIndex::with_normals(self.mesh(), self.normals.clone()))
    }

    /// The bending-invariant form of the lightly smoothed surface.
    pub(crate) fn form(&self) -> Option<&BendingInvariantForm> {
        self.form.get_or_init(|| BendingInvariantForm::new(&self.light().mesh, self.sites())).as_ref()
    }

    /// The sites of the energy of near isometries, on the lightly smoothed surface.
    pub(crate) fn sites(&self) -> &Sites {
        self.sites.get_or_init(|| Sites::new(&self.light().mesh))
    }

    /// The lightly smoothed surface.
    pub(crate) fn light(&self) -> &LightSide {
        self.light.get_or_init(|| {
            let mesh = lightly_smoothed(self.mesh(), POSITION_SCALE * self.root_mm);
            LightSide { closest: SurfaceIndex::new(&mesh), areas: vertex_areas(&mesh), mesh }
        })
    }

    /// Memory of this level, bytes, including all parts that are computed on first use except its form and its
    /// [`Sites`]. A finer surface on which features are measured is not counted.
    pub(crate) fn heap_bytes(&self) -> usize {
        let (n, mesh) = (self.mesh().n_vertices(), self.mesh().heap_bytes());
        let own = mesh + n * (size_of::<u32>() + size_of::<Vector3<f64>>());
        let sites = self.measured_on().map_or(0, |(_, sites)| size_of_val(sites));
        let index = SurfaceIndex::heap_bytes_over(self.mesh());
        let light = mesh + n * size_of::<f64>() + index;
        own + sites + index + light
    }
}
