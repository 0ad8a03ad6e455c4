//! A closed surface as a DICOM segmentation (SEG): the voxels whose centers it encloses, in the study and on the grid
//! of an input.
//!
//! Source: DICOM PS3.3, sections A.51 (Segmentation) and C.8.20, C.7.6.16 (functional groups) and C.7.6.17 (dimensions).

use super::budget::{self, Budget};
use super::dicom::{SOP_CLASS, SOP_INSTANCE, is_dicom, read_file};
use super::dicom_file::{
    Elements, FRAME_OF_REFERENCE, SERIES, Study, add_study, decimal, file, frame_of_reference, uid_of,
};
use super::{FileContent, FormatError, ReadLimits, archive, lps, read};
use homolog_mesh::SurfaceMesh;
use nalgebra::{Matrix4, Point3, Vector3, Vector4};

const CLASS: &str = "1.2.840.10008.5.1.4.1.1.66.4";
/// Voxels along the longest side of a structure if no input has a grid.
const VOXELS_ALONG: f64 = 128.0;
/// Largest number of voxels of all written frames.
const MAX_VOXELS: f64 = 1e9;

/// The inputs of a match, as uploaded.
#[derive(Debug, Clone, Copy)]
pub struct SegmentedFiles<'a> {
    /// The input in whose space the surface lies. Its grid, if it is a label volume, and its frame of reference are
    /// used.
    pub own: &'a [u8],
    /// The other input: its patient and study are used if the first input is not a DICOM object.
    pub other: &'a [u8],
    /// UID of the study, used where neither input is a DICOM object.
    pub study_uid: Option<&'a str>,
    /// UID of the frame of reference of the first input, used if that input states none.
    pub frame_uid: Option<&'a str>,
    /// Largest size of an input after decompression, bytes.
    pub max_inflated_bytes: usize,
}

/// Reasons why a surface cannot be written as a segmentation.
#[derive(Debug, thiserror::Error)]
pub enum SegmentationError {
    /// Neither input is a DICOM object, and no study is given.
    #[error("neither input is a DICOM object, and no study is given")]
    NotDicom,
    /// The surface encloses nothing.
    #[error("the surface is open, so that it encloses no voxels")]
    Open,
    /// The grid of the input is far too fine for the surface.
    #[error("the surface would take more than a billion voxels on this grid")]
    TooLarge,
    /// An input cannot be read.
    #[error(transparent)]
    Input(#[from] FormatError),
}

/// The object as a file of part 10: one segment, `label`, with only the frames in which it has voxels. `surface` is in
/// RAS, mm; `created_at` is the time of its computation, `YYYYMMDDHHMMSS`, UTC. Equal inputs give equal bytes.
///
/// Frames have the size of the input's frames, or a larger one if the surface reaches beyond them. Without a grid,
/// voxels are cubes, [128 along](VOXELS_ALONG) the longest side of the surface.
///
/// # Errors
/// [`SegmentationError`].
pub fn write_segmentation(
    surface: &SurfaceMesh,
    label: &str,
    files: &SegmentedFiles<'_>,
    created_at: &str,
) -> Result<Vec<u8>, SegmentationError> {
    let limits = ReadLimits { max_inflated_bytes: files.max_inflated_bytes, ..ReadLimits::default() };
    let plain = [archive::dicom_or_plain(files.own, &limits)?, archive::dicom_or_plain(files.other, &limits)?];
    let (mut first, mut second) = (Vec::new(), Vec::new());
    let mut sets = [None, None];
    for ((set, bytes), inflated) in sets.iter_mut().zip(&plain).zip([&mut first, &mut second]) {
        if is_dicom(bytes) {
            let budget = Budget::new(budget::for_file(bytes.len()));
            *set = Some(read_file(bytes, inflated, &limits, &budget)?.0);
        }
    }
    let [own, other] = &sets;
    let of_input = own.as_ref().or(other.as_ref()).map(Study::Of);
    let study = of_input.or_else(|| files.study_uid.map(Study::Named)).ok_or(SegmentationError::NotDicom)?;
    if surface.boundary_vertices().is_some() {
        return Err(SegmentationError::Open);
    }
    let frame = frame_of_reference(own.as_ref(), &plain[0], files.frame_uid);
    let grid = Grid::of(surface, files.own, &limits)?;
    let voxels = grid.voxels(surface)?;

    let places: Vec<u8> = surface.vertices().iter().flat_map(|p| [p.x, p.y, p.z]).flat_map(f64::to_le_bytes).collect();
    let uid = |what: &[u8]| {
        let hashes = [&plain[0], &plain[1]].map(|bytes| *blake3::hash(bytes).as_bytes());
        let mut parts: Vec<&[u8]> = vec![b"segmentation", what, &hashes[0], &hashes[1], &places, label.as_bytes()];
        // Objects in different studies are different objects.
        if let Study::Named(uid) = study {
            parts.push(uid.as_bytes());
        }
        uid_of(&parts)
    };
    let instance = uid(b"instance");
    let mut body = Elements::default();
    add_study(&mut body, &study);
    let (day, time) = created_at.split_at_checked(8).unwrap_or(("19700101", "000000"));
    let texts: [(u32, &[u8; 2], &str); 25] = [
        (0x0008_0008, b"CS", "DERIVED\\PRIMARY"),
        (SOP_CLASS, b"UI", CLASS),
        (SOP_INSTANCE, b"UI", &instance),
        (0x0008_0023, b"DA", day),
        (0x0008_0033, b"TM", time),
        (0x0008_0060, b"CS", "SEG"),
        (0x0008_0070, b"LO", "homolog"),
        (0x0008_103e, b"LO", "Surface bent by homolog"),
        (0x0008_1090, b"LO", "homolog"),
        (0x0018_1000, b"LO", "1"),
        (0x0018_1020, b"LO", env!("CARGO_PKG_VERSION")),
        (SERIES, b"UI", &uid(b"series")),
        (0x0020_0011, b"IS", "1"),
        (0x0020_0013, b"IS", "1"),
        (FRAME_OF_REFERENCE, b"UI", &frame),
        // Required by the standard; the value is unknown.
        (0x0020_1040, b"LO", ""),
        (0x0020_9311, b"CS", "3D"),
        (0x0028_0004, b"CS", "MONOCHROME2"),
        (0x0028_0008, b"IS", &voxels.n_frames.to_string()),
        (0x0028_2110, b"CS", "00"),
        (0x0062_0001, b"CS", "BINARY"),
        (0x0062_0013, b"CS", "NO"),
        (0x0070_0080, b"CS", "SEGMENTATION"),
        (0x0070_0081, b"LO", "Surface deformed onto another"),
        (0x0070_0084, b"PN", ""),
    ];
    for (tag, representation, value) in texts {
        body.text(tag, representation, value);
    }
    let shorts = [
        (0x0028_0002, 1),
        (0x0028_0010, voxels.rows),
        (0x0028_0011, voxels.columns),
        (0x0028_0100, 1),
        (0x0028_0101, 1),
        (0x0028_0102, 0),
        (0x0028_0103, 0),
    ];
    for (tag, value) in shorts {
        body.add(tag, b"US", &(value as u16).to_le_bytes());
    }
    body.items(0x0062_0002, &[segment(label)]);
    dimensions(&mut body, &uid(b"dimensions"));
    body.items(0x5200_9229, &[grid.shared()]);
    let frames: Vec<Elements> = (0..voxels.n_frames).map(|k| grid.frame(voxels.origin, k)).collect();
    body.items(0x5200_9230, &frames);
    body.add(0x7fe0_0010, b"OB", &voxels.packed);
    Ok(file(CLASS, &instance, &body))
}

fn code(value: &str, scheme: &str, meaning: &str) -> Elements {
    let mut code = Elements::default();
    code.text(0x0008_0100, b"SH", value);
    code.text(0x0008_0102, b"SH", scheme);
    code.text(0x0008_0104, b"LO", meaning);
    code
}

fn segment(label: &str) -> Elements {
    let mut segment = Elements::default();
    segment.add(0x0062_0004, b"US", &1u16.to_le_bytes());
    segment.text(0x0062_0005, b"LO", label);
    segment.text(0x0062_0008, b"CS", "AUTOMATIC");
    segment.text(0x0062_0009, b"LO", "homolog");
    segment.items(0x0062_0003, &[code("123037004", "SCT", "Anatomical Structure")]);
    segment.items(0x0062_000f, &[code("123037004", "SCT", "Anatomical Structure")]);
    segment
}

/// Frames are distinguished by their segment and their position.
fn dimensions(body: &mut Elements, uid: &str) {
    let mut organization = Elements::default();
    organization.text(0x0020_9164, b"UI", uid);
    body.items(0x0020_9221, &[organization]);
    let pointer = |tag: u32| [((tag >> 16) as u16).to_le_bytes(), (tag as u16).to_le_bytes()].concat();
    let index = |what: u32, group: u32, name: &str| {
        let mut index = Elements::default();
        index.text(0x0020_9164, b"UI", uid);
        index.add(0x0020_9165, b"AT", &pointer(what));
        index.add(0x0020_9167, b"AT", &pointer(group));
        index.text(0x0020_9421, b"LO", name);
        index
    };
    let segment = index(0x0062_000b, 0x0062_000a, "Segment Number");
    body.items(0x0020_9222, &[segment, index(0x0020_0032, 0x0020_9113, "Image Position Patient")]);
}

/// A lattice of voxels.
struct Grid {
    /// Voxel index to RAS, mm.
    affine: Matrix4<f64>,
    /// Columns and rows of the input's frames; 0 if it has none.
    size: [i64; 2],
}

/// Voxels of the nonempty frames.
struct Voxels {
    columns: usize,
    rows: usize,
    n_frames: usize,
    /// Index of the first voxel on the lattice.
    origin: [i64; 3],
    /// One bit per voxel, the lowest first, frames one after the other.
    packed: Vec<u8>,
}

impl Grid {
    fn of(surface: &SurfaceMesh, own: &[u8], limits: &ReadLimits) -> Result<Self, SegmentationError> {
        if let Ok(read) = read(own, None, limits)
            && let FileContent::Labels(volume) = read.content
        {
            let [columns, rows, _] = volume.dims().map(|d| d as i64);
            let affine = *volume.affine();
            let axes: [Vector3<f64>; 2] = [0, 1].map(|k| affine.fixed_view::<3, 1>(0, k).normalize());
            // DICOM frames have right angles; slices may be shifted against each other.
            if axes[0].dot(&axes[1]).abs() < 1e-4 {
                return Ok(Grid { affine, size: [columns, rows] });
            }
        }
        let (low, high) = surface.bounding_box();
        let spacing = ((high - low).max() / VOXELS_ALONG).max(f64::MIN_POSITIVE);
        // Columns run to the left and rows to the back, as in most images.
        let mut affine = Matrix4::from_diagonal(&Vector4::new(-spacing, -spacing, spacing, 1.0));
        affine.set_column(3, &Vector4::new(high.x, high.y, low.z, 1.0));
        Ok(Grid { affine, size: [0, 0] })
    }

    /// The voxels whose centers the surface winds around.
    fn voxels(&self, surface: &SurfaceMesh) -> Result<Voxels, SegmentationError> {
        let to_voxel = self.affine.try_inverse().ok_or(SegmentationError::TooLarge)?;
        // A surface on the lattice would pass through centers; this small shift prevents it.
        let apart = Vector3::new(1.37e-7, 2.11e-7, 0.0);
        let places: Vec<Point3<f64>> = surface.vertices().iter().map(|p| to_voxel.transform_point(p) + apart).collect();
        let first = places[0];
        let (low, high) = places.iter().fold((first, first), |(low, high), p| (low.inf(p), high.sup(p)));
        let least = |k: usize| low[k].floor() as i64;
        let most = |k: usize| high[k].ceil() as i64;
        let origin = [least(0).min(0), least(1).min(0), least(2)];
        let ends = [most(0).max(self.size[0] - 1), most(1).max(self.size[1] - 1), most(2)];
        let sizes = [0, 1, 2].map(|k| (ends[k] - origin[k] + 1) as f64);
        if sizes.iter().product::<f64>() > MAX_VOXELS || sizes[0].max(sizes[1]) > f64::from(u16::MAX) {
            return Err(SegmentationError::TooLarge);
        }
        let [columns, rows, depth] = sizes.map(|n| n as usize);
        let mut crossings: Vec<Vec<(f64, i8)>> = vec![Vec::new(); columns * rows];
        for t in surface.triangles() {
            let [a, b, c] = t.map(|v| places[v as usize]);
            let area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
            if area == 0.0 {
                continue;
            }
            let range = |k: usize| {
                let (low, high) = (a[k].min(b[k]).min(c[k]), a[k].max(b[k]).max(c[k]));
                low.ceil() as i64..=high.floor() as i64
            };
            for y in range(1) {
                for x in range(0) {
                    let (px, py) = (x as f64, y as f64);
                    let part = |p: Point3<f64>, q: Point3<f64>| (p.x - px) * (q.y - py) - (q.x - px) * (p.y - py);
                    // A line along an edge belongs to only one of its two triangles: the one in which the edge runs
                    // upwards.
                    let within = |value: f64, p: Point3<f64>, q: Point3<f64>| {
                        let value = value * area.signum();
                        value > 0.0 || value == 0.0 && ((p.y, p.x) < (q.y, q.x)) == (area > 0.0)
                    };
                    let parts = [part(b, c), part(c, a), part(a, b)];
                    if within(parts[0], b, c) && within(parts[1], c, a) && within(parts[2], a, b) {
                        let z = (parts[0] * a.z + parts[1] * b.z + parts[2] * c.z) / area;
                        let column = (y - origin[1]) as usize * columns + (x - origin[0]) as usize;
                        crossings[column].push((z, if area > 0.0 { 1 } else { -1 }));
                    }
                }
            }
        }
        let mut inside = vec![false; columns * rows * depth];
        for (column, found) in crossings.iter_mut().enumerate() {
            found.sort_by(|a, b| a.0.total_cmp(&b.0));
            let mut around = 0i32;
            for pair in found.windows(2) {
                around += i32::from(pair[0].1);
                if around != 0 {
                    for z in (pair[0].0.ceil() as i64).max(origin[2])..=(pair[1].0.floor() as i64).min(ends[2]) {
                        inside[(z - origin[2]) as usize * columns * rows + column] = true;
                    }
                }
            }
        }
        // Empty frames at both ends are left out; those in between stay, so that the stack has no gap.
        let has_any = |z: &usize| inside[z * columns * rows..][..columns * rows].contains(&true);
        let (bottom, top) = ((0..depth).find(has_any).unwrap_or(0), (0..depth).rfind(has_any).unwrap_or(0));
        let kept = &inside[bottom * columns * rows..(top + 1) * columns * rows];
        let packed = kept.chunks(8).map(|bits| bits.iter().rev().fold(0u8, |sum, &bit| sum << 1 | u8::from(bit)));
        let origin = [origin[0], origin[1], origin[2] + bottom as i64];
        Ok(Voxels { columns, rows, n_frames: top + 1 - bottom, origin, packed: packed.collect() })
    }

    fn column_lps(&self, k: usize) -> Vector3<f64> {
        // The same change of axes maps LPS to RAS and back.
        lps::affine_to_ras(&self.affine).fixed_view::<3, 1>(0, k).into_owned()
    }

    /// Functional groups of all frames.
    fn shared(&self) -> Elements {
        let [across, down, up] = [0, 1, 2].map(|k| self.column_lps(k));
        let numbers = |values: &[f64]| values.iter().map(|v| decimal(*v)).collect::<Vec<_>>().join("\\");
        let between = up.dot(&across.cross(&down).normalize()).abs();
        let mut measures = Elements::default();
        measures.text(0x0018_0050, b"DS", &decimal(between));
        measures.text(0x0018_0088, b"DS", &decimal(between));
        measures.text(0x0028_0030, b"DS", &numbers(&[down.norm(), across.norm()]));
        let mut orientation = Elements::default();
        let (row, column) = (across.normalize(), down.normalize());
        orientation.text(0x0020_0037, b"DS", &numbers(&[row.x, row.y, row.z, column.x, column.y, column.z]));
        let mut shared = Elements::default();
        shared.items(0x0028_9110, &[measures]);
        shared.items(0x0020_9116, &[orientation]);
        shared
    }

    /// Functional groups of one frame.
    fn frame(&self, origin: [i64; 3], k: usize) -> Elements {
        let at = Vector4::new(origin[0] as f64, origin[1] as f64, (origin[2] + k as i64) as f64, 1.0);
        let place = lps::affine_to_ras(&self.affine) * at;
        let mut position = Elements::default();
        let numbers = [place.x, place.y, place.z].map(decimal);
        position.text(0x0020_0032, b"DS", &numbers.join("\\"));
        let mut content = Elements::default();
        content.add(0x0020_9157, b"UL", &[1u32.to_le_bytes(), (k as u32 + 1).to_le_bytes()].concat());
        // The standard allows all frames to share it, but not all programs expect that.
        let mut segment = Elements::default();
        segment.add(0x0062_000b, b"US", &1u16.to_le_bytes());
        let mut frame = Elements::default();
        frame.items(0x0020_9111, &[content]);
        frame.items(0x0020_9113, &[position]);
        frame.items(0x0062_000a, &[segment]);
        frame
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dicom_seg::read_dicom_seg;
    use homolog_mesh::shapes::{ellipsoid, torus};
    use homolog_mesh::{FaceArity, volume::LabelVolume};

    fn segmented(mesh: &SurfaceMesh, own: &[u8], other: &[u8]) -> Result<Vec<u8>, SegmentationError> {
        named(mesh, own, other, [None, None])
    }

    fn named(
        mesh: &SurfaceMesh,
        own: &[u8],
        other: &[u8],
        [study_uid, frame_uid]: [Option<&str>; 2],
    ) -> Result<Vec<u8>, SegmentationError> {
        let files = SegmentedFiles { own, other, study_uid, frame_uid, max_inflated_bytes: 1 << 30 };
        write_segmentation(mesh, "bent", &files, "20261122201500")
    }

    fn voxels(bytes: &[u8]) -> LabelVolume {
        read_dicom_seg(&[bytes], &ReadLimits::default(), &Default::default()).unwrap().volume
    }

    /// Centers of the voxels of a volume inside the segment, and of those outside.
    fn centers(volume: &LabelVolume) -> [Vec<Point3<f64>>; 2] {
        let [nx, ny, _] = volume.dims();
        let mut found = [Vec::new(), Vec::new()];
        for (k, label) in volume.labels().iter().enumerate() {
            let at = Point3::new((k % nx) as f64, (k / nx % ny) as f64, (k / nx / ny) as f64);
            found[usize::from(*label == 0)].push(volume.affine().transform_point(&at));
        }
        found
    }

    #[test]
    fn voxels_are_those_whose_centers_the_surface_encloses_on_the_grid_of_the_input() {
        let small = ellipsoid(Vector3::new(12.0, 9.0, 6.0), 5);
        let first = segmented(&small, b"ply", &patient()).unwrap();
        let cubes = voxels(&first);
        assert!((cubes.spacing_mm()[2] - 24.0 / 128.0).abs() < 1e-9);
        // On the grid of the input: a larger ball that reaches beyond it, and a ring whose hole stays open.
        let ball = ellipsoid(Vector3::repeat(10.0), 5);
        let ring = torus(8.0, 2.0, 200, 80, FaceArity::Quad);
        let radius = |p: &Point3<f64>| p.coords.norm() - 10.0;
        let around = |p: &Point3<f64>| (p.x.hypot(p.y) - 8.0).hypot(p.z) - 2.0;
        for (mesh, outside) in [(ball, &radius as &dyn Fn(&Point3<f64>) -> f64), (ring, &around)] {
            let bytes = segmented(&mesh, &first, b"ply").unwrap();
            assert_eq!(segmented(&mesh, &first, b"ply").unwrap(), bytes, "equal inputs give equal bytes");
            let volume = voxels(&bytes);
            assert!((volume.spacing_mm()[0] - cubes.spacing_mm()[0]).abs() < 1e-9);
            let [inside, beyond] = centers(&volume);
            assert!(inside.iter().all(|p| outside(p) < 0.01), "all voxels are inside");
            assert!(beyond.iter().all(|p| outside(p) > -0.03), "none is missing");
            let cell: f64 = volume.spacing_mm().iter().product();
            assert!((inside.len() as f64 * cell / mesh.signed_volume() - 1.0).abs() < 0.01);
            let shift = (volume.affine().column(3) - cubes.affine().column(3)).xyz() / cubes.spacing_mm()[0];
            assert!(shift.iter().all(|s| (s - s.round()).abs() < 1e-6), "the same lattice: {shift}");
        }
    }

    /// A segmentation of a patient, without frames.
    fn patient() -> Vec<u8> {
        let mut set = Elements::default();
        set.text(SOP_CLASS, b"UI", CLASS);
        set.text(SOP_INSTANCE, b"UI", "1.2.7");
        set.text(0x0010_0010, b"PN", "Doe^Jane");
        set.text(0x0020_000d, b"UI", "1.2.3");
        set.text(FRAME_OF_REFERENCE, b"UI", "1.2.5");
        file(CLASS, "1.2.7", &set)
    }

    #[test]
    fn the_object_has_the_patient_of_one_input_and_the_frame_of_reference_of_its_own() {
        let ball = ellipsoid(Vector3::repeat(4.0), 3);
        let read = |bytes: &[u8]| {
            let mut inflated = Vec::new();
            let (set, _) = read_file(bytes, &mut inflated, &ReadLimits::default(), &Budget::new(1 << 20)).unwrap();
            [0x0010_0010, 0x0020_000d, FRAME_OF_REFERENCE, 0x0008_0060].map(|tag| set.text(tag))
        };
        let of_own = read(&segmented(&ball, &patient(), b"ply").unwrap());
        assert_eq!(of_own, ["Doe^Jane", "1.2.3", "1.2.5", "SEG"]);
        let of_other = read(&segmented(&ball, b"ply", &patient()).unwrap());
        assert_eq!((&of_other[..2], of_other[2].starts_with("2.25.")), (&of_own[..2], true));
        assert!(matches!(segmented(&ball, b"ply", b"stl"), Err(SegmentationError::NotDicom)));
        let uids = [Some("1.9.1"), Some("1.9.2")];
        let of_none = read(&named(&ball, b"ply", b"stl", uids).unwrap());
        assert_eq!(of_none, ["", "1.9.1", "1.9.2", "SEG"]);
        // Identifiers stated by an input take precedence.
        assert_eq!(read(&named(&ball, &patient(), b"ply", uids).unwrap()), of_own);
        assert_eq!(read(&named(&ball, b"ply", &patient(), uids).unwrap()), ["Doe^Jane", "1.2.3", "1.9.2", "SEG"]);
        let open = SurfaceMesh::new(ball.vertices().to_vec(), FaceArity::Triangle, ball.indices()[3..].to_vec());
        assert!(matches!(segmented(&open.unwrap(), &patient(), b""), Err(SegmentationError::Open)));
    }
}
