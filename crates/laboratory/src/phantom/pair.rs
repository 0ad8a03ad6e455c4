//! Two phantoms with their ground truth: the map from the source to the target.

use super::deformation::{Deformation, random_permutation, random_pose};
use super::raster::PhantomVolume;
use super::shape::Phantom;
use super::surface::PhantomSurface;
use super::{Part, PhantomError};
use homolog_mesh::SurfaceMesh;
use nalgebra::{Isometry3, Point3};

/// Recipe of a pair. The target is `pose(deformation(target subject))`.
#[derive(Debug, Clone, PartialEq)]
pub struct PairRecipe {
    /// Seed of the source's subject.
    pub subject: u64,
    /// Seed of the target's subject; the same seed gives a pair with point-to-point ground truth.
    pub target_subject: u64,
    /// RMS displacement of the deformation as a share of the diagonal; 0 for none.
    pub deform_share: f64,
    /// Seed of the deformation.
    pub deform_seed: u64,
    /// Seed of the target's pose; `None` leaves it in the frame of its subject.
    pub pose_seed: Option<u64>,
    /// Seed that shuffles the vertices of the target's surface; `None` keeps vertex `i` at vertex `i`.
    pub permute_seed: Option<u64>,
}

/// A source and a target phantom.
#[derive(Debug, Clone, PartialEq)]
pub struct PhantomPair {
    recipe: PairRecipe,
    source: Phantom,
    target: Phantom,
    deformation: Option<Deformation>,
    pose: Isometry3<f64>,
}

/// Edge length of the surface on which the strength of a deformation is measured, independent of the written surfaces,
/// mm.
const REFERENCE_EDGE_MM: f64 = 1.0;

impl PhantomPair {
    /// The pair of this recipe.
    ///
    /// # Errors
    /// The errors of [`Deformation::new`].
    pub fn new(recipe: PairRecipe) -> Result<Self, PhantomError> {
        let (source, target) = (Phantom::new(recipe.subject), Phantom::new(recipe.target_subject));
        let deformation = if recipe.deform_share == 0.0 {
            None
        } else {
            let reference = target.surface(REFERENCE_EDGE_MM)?;
            Some(Deformation::new(reference.mesh.vertices(), recipe.deform_share, recipe.deform_seed)?)
        };
        let pose = recipe.pose_seed.map_or_else(Isometry3::identity, random_pose);
        Ok(PhantomPair { recipe, source, target, deformation, pose })
    }

    /// A pair for a study: subject number `subject`, different for each number, and the template, the same for all (the
    /// subject of seed 0, posed and with its vertices shuffled).
    ///
    /// # Errors
    /// The errors of [`PhantomPair::new`].
    pub fn against_template(subject: u64) -> Result<Self, PhantomError> {
        PhantomPair::new(PairRecipe {
            // Seed 0 belongs to the template.
            subject: subject + 1,
            target_subject: 0,
            deform_share: 0.0,
            deform_seed: 0,
            pose_seed: Some(3),
            permute_seed: Some(4),
        })
    }

    /// The recipe of the pair.
    pub fn recipe(&self) -> &PairRecipe {
        &self.recipe
    }

    /// Position in the target of a point of the target's subject. If source and target are one subject this is the
    /// truth: the correspondent of every source point.
    pub fn place(&self, p: &Point3<f64>) -> Point3<f64> {
        let deformed = self.deformation.as_ref().map_or(*p, |d| d.apply(p));
        self.pose * deformed
    }

    /// The pose of the target.
    pub fn pose(&self) -> &Isometry3<f64> {
        &self.pose
    }

    /// The deformation of the target, if there is one.
    pub fn deformation(&self) -> Option<&Deformation> {
        self.deformation.as_ref()
    }

    /// Whether source and target are one subject, so that every source point has a known correspondent.
    pub fn is_one_subject(&self) -> bool {
        self.recipe.subject == self.recipe.target_subject
    }

    /// The source's surface.
    ///
    /// # Errors
    /// The errors of [`Phantom::surface`].
    pub fn source_surface(&self, edge_mm: f64) -> Result<PhantomSurface, PhantomError> {
        self.source.surface(edge_mm)
    }

    /// The target's surface, and for every vertex of the target's subject its index there (the identity unless the
    /// recipe shuffles them).
    ///
    /// # Errors
    /// The errors of [`Phantom::surface`].
    pub fn target_surface(&self, edge_mm: f64) -> Result<(PhantomSurface, Vec<u32>), PhantomError> {
        let PhantomSurface { mesh, parts } = self.target.surface(edge_mm)?;
        let n = mesh.n_vertices();
        let placed: Vec<_> = mesh.vertices().iter().map(|p| self.place(p)).collect();
        let Some(seed) = self.recipe.permute_seed else {
            let mesh = mesh.with_vertices(placed)?;
            return Ok((PhantomSurface { mesh, parts }, (0..n as u32).collect()));
        };
        let new_index = random_permutation(n, seed);
        let mut vertices = vec![Point3::origin(); n];
        let mut new_parts = vec![Part::Anterior; n];
        for (old, &new) in new_index.iter().enumerate() {
            vertices[new as usize] = placed[old];
            new_parts[new as usize] = parts[old];
        }
        let indices = mesh.indices().iter().map(|&v| new_index[v as usize]).collect();
        let mesh = SurfaceMesh::new(vertices, mesh.arity(), indices)?;
        Ok((PhantomSurface { mesh, parts: new_parts }, new_index))
    }

    /// The meshes of both surfaces, source and target.
    ///
    /// # Errors
    /// The errors of [`Phantom::surface`].
    pub fn meshes(&self, edge_mm: f64) -> Result<[SurfaceMesh; 2], PhantomError> {
        Ok([self.source_surface(edge_mm)?.mesh, self.target_surface(edge_mm)?.0.mesh])
    }

    /// The source's label volume.
    ///
    /// # Errors
    /// The errors of [`PhantomVolume::rasterize`].
    pub fn source_volume(&self, spacing_mm: f64) -> Result<PhantomVolume, PhantomError> {
        self.source.volume(spacing_mm)
    }

    /// The target's label volume, sampled from the shape itself instead of another volume.
    ///
    /// # Errors
    /// The errors of [`PhantomVolume::rasterize`].
    pub fn target_volume(&self, spacing_mm: f64) -> Result<PhantomVolume, PhantomError> {
        let extent: Vec<_> =
            self.target.surface(REFERENCE_EDGE_MM)?.mesh.vertices().iter().map(|p| self.place(p)).collect();
        let back = self.pose.inverse();
        PhantomVolume::rasterize(&extent, spacing_mm, |world| {
            let deformed = back * world;
            let p = match &self.deformation {
                None => deformed,
                Some(deformation) => deformation.invert(&deformed)?,
            };
            self.target.part_at(&p)
        })
    }
}
