//! Converts the polygons of a file to a triangle or quad mesh.

use super::budget::Budget;
use super::units::Unit;
use super::{FormatError, ReadLimits};
use homolog_contract::input::InputSpace;
use homolog_mesh::{FaceArity, MeshError, SurfaceMesh};
use nalgebra::Point3;

/// Largest number of faces per vertex; a closed surface of triangles has two.
const FACES_PER_VERTEX: u64 = 8;
/// Largest size of a file per vertex, and in addition, bytes.
const BYTES_PER_VERTEX: u64 = 512;
/// Largest length of a list of coordinates or corners, per vertex.
const NUMBERS_PER_VERTEX: usize = 64;
const BYTES_ALWAYS: u64 = 1 << 20;

/// The mesh of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshFile {
    /// The mesh, without degenerate faces; vertices as in the file.
    pub mesh: SurfaceMesh,
    /// The first face that uses a vertex twice, and that vertex.
    pub first_degenerate: Option<(usize, u32)>,
    /// Number of degenerate faces that were left out.
    pub n_degenerate: usize,
    /// Whether the vertices were welded on reading, because the format has no shared vertices.
    pub welded: bool,
    /// The coordinate space declared by the file.
    pub space: InputSpace,
    /// Changes of the coordinates, and remarks on them: a sentence each, without text of the file.
    pub notes: Vec<String>,
}

impl MeshFile {
    /// Converts the coordinates from this unit to millimeters, with a note.
    ///
    /// # Errors
    /// [`MeshError`] if a coordinate overflows.
    pub(super) fn scale(&mut self, unit: Unit) -> Result<(), FormatError> {
        let Some(note) = unit.note() else { return Ok(()) };
        let vertices = self.mesh.vertices().iter().map(|p| p * unit.mm).collect();
        self.mesh = SurfaceMesh::new(vertices, self.mesh.arity(), self.mesh.indices().to_vec())?;
        self.notes.push(note);
        Ok(())
    }
}

/// Vertices and polygons of any number of corners.
#[derive(Debug)]
pub(super) struct Polygons<'b> {
    pub(super) vertices: Vec<Point3<f64>>,
    corners: Vec<u32>,
    ends: Vec<usize>,
    budget: &'b Budget,
}

/// Vertices from a flat list of coordinates.
pub(super) fn points_of(numbers: &[f64], budget: &Budget) -> Result<Vec<Point3<f64>>, FormatError> {
    budget.charge_of::<f64>(numbers.len())?;
    Ok(numbers.chunks_exact(3).map(|p| Point3::new(p[0], p[1], p[2])).collect())
}

impl<'b> Polygons<'b> {
    /// An empty set of vertices and polygons.
    pub(super) fn new(budget: &'b Budget) -> Self {
        Polygons::of(Vec::new(), budget)
    }

    /// These vertices without polygons.
    pub(super) fn of(vertices: Vec<Point3<f64>>, budget: &'b Budget) -> Self {
        Polygons { vertices, corners: Vec::new(), ends: Vec::new(), budget }
    }

    /// Adds a vertex.
    ///
    /// # Errors
    /// `TooLarge` beyond the budget.
    pub(super) fn vertex(&mut self, place: Point3<f64>) -> Result<(), FormatError> {
        self.budget.push(&mut self.vertices, place)
    }

    /// Rejects more vertices than the limit, before they are read.
    pub(super) fn check_count(found: u64, limits: &ReadLimits) -> Result<(), FormatError> {
        let limit = limits.max_vertices as u64;
        if found > limit { Err(FormatError::TooLarge { what: "vertices", found, limit }) } else { Ok(()) }
    }

    /// Rejects more faces than the vertices need, before they are read.
    pub(super) fn check_faces(found: u64, limits: &ReadLimits) -> Result<(), FormatError> {
        let limit = FACES_PER_VERTEX.saturating_mul(limits.max_vertices as u64);
        if found > limit { Err(FormatError::TooLarge { what: "faces", found, limit }) } else { Ok(()) }
    }

    /// The longest list of numbers needed by a surface within the limits.
    pub(super) fn most_numbers(limits: &ReadLimits) -> usize {
        NUMBERS_PER_VERTEX.saturating_mul(limits.max_vertices).max(BYTES_ALWAYS as usize)
    }

    /// Rejects a longer list of numbers.
    pub(super) fn check_numbers(found: u64, limits: &ReadLimits) -> Result<(), FormatError> {
        let limit = Polygons::most_numbers(limits) as u64;
        if found > limit { Err(FormatError::TooLarge { what: "numbers in a list", found, limit }) } else { Ok(()) }
    }

    /// Rejects a file larger than the largest surface: a small compressed file may inflate to any size, and the
    /// structures made from it take several times as much.
    pub(super) fn check_bytes(found: u64, limits: &ReadLimits) -> Result<(), FormatError> {
        let limit = BYTES_PER_VERTEX.saturating_mul(limits.max_vertices as u64).max(BYTES_ALWAYS);
        if found > limit { Err(FormatError::TooLarge { what: "bytes of a surface", found, limit }) } else { Ok(()) }
    }

    /// Adds a face; its vertices must have been added before.
    ///
    /// # Errors
    /// A corner that refers to no vertex; `TooLarge` beyond the budget.
    pub(super) fn push(&mut self, face: impl IntoIterator<Item = i64>) -> Result<(), FormatError> {
        let n_vertices = self.vertices.len();
        for vertex in face {
            let face = self.ends.len();
            if vertex < 0 {
                return Err(FormatError::NegativeIndex { face, vertex });
            }
            if vertex as u64 >= n_vertices as u64 {
                return Err(MeshError::IndexOutOfRange { face, vertex: vertex as u64, n_vertices }.into());
            }
            self.budget.push(&mut self.corners, vertex as u32)?;
        }
        self.budget.push(&mut self.ends, self.corners.len())
    }

    fn faces(&self) -> impl Iterator<Item = &[u32]> {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        starts.zip(&self.ends).map(|(start, &end)| &self.corners[start..end])
    }

    /// A quad mesh if every face is a quad; otherwise triangles, with larger polygons split into fans from their first
    /// corner.
    ///
    /// # Errors
    /// [`MeshError`] if nothing is left or a coordinate is not finite; `TooLarge` beyond the budget.
    pub(super) fn into_mesh(mut self) -> Result<MeshFile, FormatError> {
        let notes: Vec<String> = self.place_unused().into_iter().collect();
        let all_quads = self.faces().all(|f| f.len() == 4);
        let arity = if all_quads { FaceArity::Quad } else { FaceArity::Triangle };
        let n_indices: usize = self.faces().map(|f| if all_quads { 4 } else { 3 * f.len().saturating_sub(2) }).sum();
        let largest = self.faces().map(<[u32]>::len).max().unwrap_or(0);
        // The faces of the mesh, and the sorted corners of the largest face.
        self.budget.charge_of::<u32>(n_indices + largest)?;
        let mut indices = Vec::with_capacity(n_indices);
        let (mut first_degenerate, mut n_degenerate) = (None, 0);
        for (at, face) in self.faces().enumerate() {
            // Fewer than three corners enclose no area: VTK writes such "polygons" for points and lines.
            if face.len() < 3 {
                continue;
            }
            if let Some(twice) = repeated(face) {
                n_degenerate += 1;
                first_degenerate = first_degenerate.or(Some((at, twice)));
            }
            match arity {
                FaceArity::Quad if repeated(face).is_none() => indices.extend(face),
                FaceArity::Quad => {}
                FaceArity::Triangle => {
                    for k in 1..face.len() - 1 {
                        let triangle = [face[0], face[k], face[k + 1]];
                        if repeated(&triangle).is_none() {
                            indices.extend(triangle);
                        }
                    }
                }
            }
        }
        self.budget.release(size_of::<u32>() * self.corners.capacity() + size_of::<usize>() * self.ends.capacity());
        drop((self.corners, self.ends));
        // A copy in other units, or in RAS.
        self.budget.charge_of::<u32>(indices.len())?;
        self.budget.charge_of::<Point3<f64>>(self.vertices.len())?;
        let mesh = SurfaceMesh::new(self.vertices, arity, indices)?;
        Ok(MeshFile { mesh, first_degenerate, n_degenerate, welded: false, space: InputSpace::Unknown, notes })
    }

    /// Moves unused vertices without finite coordinates to the place of the first used vertex, so that all vertices
    /// keep their numbers; returns a note if there are any.
    fn place_unused(&mut self) -> Option<String> {
        let is_finite = |p: &Point3<f64>| p.iter().all(|c| c.is_finite());
        if self.vertices.iter().all(is_finite) {
            return None;
        }
        let mut used = vec![false; self.vertices.len()];
        self.corners.iter().for_each(|&v| used[v as usize] = true);
        let place = *self.vertices.get(*self.corners.first()? as usize)?;
        let mut n_placed = 0;
        for (vertex, _) in self.vertices.iter_mut().zip(&used).filter(|(p, used)| !**used && !is_finite(p)) {
            *vertex = place;
            n_placed += 1;
        }
        (n_placed > 0).then(|| {
            format!("{n_placed} of the vertices that no face uses have no finite coordinates; they are ignored")
        })
    }
}

/// The triangles of a strip. Every second one has the opposite orientation; degenerate ones only join strips.
pub(super) fn strip_triangles(strip: &[i64]) -> impl Iterator<Item = [i64; 3]> {
    let triangles = strip.windows(3).enumerate();
    let triangles = triangles.map(|(k, t)| if k % 2 == 0 { [t[0], t[1], t[2]] } else { [t[1], t[0], t[2]] });
    triangles.filter(|t| t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
}

/// A vertex that occurs twice among the corners. Large polygons are sorted, which bounds the cost of malicious ones.
fn repeated(face: &[u32]) -> Option<u32> {
    if face.len() <= 8 {
        return (1..face.len()).find(|&k| face[..k].contains(&face[k])).map(|k| face[k]);
    }
    let mut sorted = face.to_vec();
    sorted.sort_unstable();
    sorted.windows(2).find(|w| w[0] == w[1]).map(|w| w[0])
}
