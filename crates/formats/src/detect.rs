//! Which format a file has, by its content; its name decides only where the content does not.

use super::{FormatError, InputFormat, dicom, freesurfer, metaimage, mgh, mz3, nifti, nrrd, obj, off, stl};

/// How much of a file is looked at for the root of an XML document.
const XML_HEAD_BYTES: usize = 1 << 16;

/// The format of a file (not compressed): by its bytes, else by its name.
///
/// # Errors
/// `Unsupported` for a format that is known but not read; `UnknownFormat`.
pub(super) fn detect(bytes: &[u8], file_name: Option<&str>) -> Result<InputFormat, FormatError> {
    if let Some(format) = by_content(bytes) {
        return Ok(format);
    }
    let known = unread(bytes, file_name);
    if let Some((what, advice)) = known {
        return Err(FormatError::Unsupported { what, advice });
    }
    file_name.and_then(by_name).ok_or(FormatError::UnknownFormat)
}

fn by_content(bytes: &[u8]) -> Option<InputFormat> {
    let starts = |magic: &str| bytes.get(..magic.len()).is_some_and(|head| head.eq_ignore_ascii_case(magic.as_bytes()));
    let formats = [
        (nifti::is_nifti(bytes), InputFormat::Nifti),
        (dicom::is_dicom(bytes), InputFormat::DicomSeg),
        (starts("ply\n") || starts("ply\r"), InputFormat::Ply),
        (starts("# vtk DataFile"), InputFormat::Vtk),
        (freesurfer::is_freesurfer(bytes), InputFormat::Freesurfer),
        (mz3::is_mz3(bytes), InputFormat::Mz3),
        (nrrd::is_nrrd(bytes), InputFormat::Nrrd),
        (has_root(bytes, b"<GIFTI"), InputFormat::Gifti),
        (has_root(bytes, b"<VTKFile"), InputFormat::Vtp),
        (stl::is_stl(bytes), InputFormat::Stl),
        (mgh::is_mgh(bytes), InputFormat::Mgh),
        (off::is_off(bytes), InputFormat::Off),
        (metaimage::is_metaimage(bytes), InputFormat::MetaImage),
        (obj::is_obj(bytes), InputFormat::Obj),
    ];
    formats.into_iter().find_map(|(is, format)| is.then_some(format))
}

/// Whether this is XML whose root element begins so.
fn has_root(bytes: &[u8], root: &[u8]) -> bool {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
    let head = &bytes[..bytes.len().min(XML_HEAD_BYTES)];
    head.starts_with(b"<") && head.windows(root.len()).any(|w| w == root)
}

/// Formats that are recognized and not read: what they are, and what to send instead.
fn unread(bytes: &[u8], file_name: Option<&str>) -> Option<(&'static str, &'static str)> {
    const LABELS: &str = "convert the label volume to NIfTI (mnc2nii, or mri_convert)";
    const MODEL: &str = "export the surface as PLY, STL or OBJ";
    let starts = |magic: &[u8]| bytes.starts_with(magic);
    let text = bytes.get(..4096).unwrap_or(bytes).trim_ascii_start();
    let named = |ending: &str| file_name.is_some_and(|name| extension(name) == ending);
    if starts(b"\x89HDF\r\n\x1a\n") {
        return Some(("an HDF5 file (MINC 2, VTKHDF or others)", LABELS));
    }
    if starts(b"CDF\x01") || starts(b"CDF\x02") {
        return Some(("a NetCDF file (MINC 1)", LABELS));
    }
    // A polygonal surface: material, number of points, then a point to a line.
    let mni = text.starts_with(b"P ") && text[2..].split(u8::is_ascii_whitespace).take(5).all(is_number);
    if mni || named("obj") && starts(b"p") && text.contains(&0) {
        let advice = "convert it to GIFTI or PLY, for example with ConvertSurface of AFNI or with Surf Ice";
        return Some(("an MNI .obj surface, which is no Wavefront OBJ", advice));
    }
    if starts(b"Kaydara FBX Binary") || text.starts_with(b"; FBX") {
        return Some(("FBX", MODEL));
    }
    let has = |word: &[u8]| text.windows(word.len()).any(|w| w == word);
    if starts(b"glTF") || text.starts_with(b"{") && has(b"\"asset\"") {
        return Some(("glTF", MODEL));
    }
    if starts(b"PK\x03\x04") {
        return Some(("a zip archive", "unpack it and send one file of it"));
    }
    if starts(b"\xff\xff\xff\xff") {
        return Some(("a FreeSurfer patch", "it is cut open; send the whole surface, such as lh.pial or lh.white"));
    }
    if starts(b"binar") || text.starts_with(b"ascii") && named("mesh") {
        return Some(("a BrainVISA .mesh surface", "convert it to GIFTI (AimsFileConvert)"));
    }
    if has_root(bytes, b"<COLLADA") || has_root(bytes, b"<X3D") || text.starts_with(b"#VRML") {
        return Some(("a scene (COLLADA, X3D or VRML)", MODEL));
    }
    match file_name.map(extension).unwrap_or_default().as_str() {
        "mnc" => Some(("MINC", LABELS)),
        "img" | "hdr" => Some(("ANALYZE, or a NIfTI volume in two files", "save it as one .nii or .nii.gz file")),
        "srf" | "vmr" => Some(("BrainVoyager", "export the surface as PLY, STL or OBJ, or the labels as NIfTI")),
        _ => None,
    }
}

fn is_number(word: &[u8]) -> bool {
    std::str::from_utf8(word).is_ok_and(|word| word.parse::<f64>().is_ok())
}

/// What follows the last point of a name, without `.gz`, in lower case.
fn extension(name: &str) -> String {
    let name = name.to_ascii_lowercase();
    let name = name.strip_suffix(".gz").unwrap_or(&name);
    name.rsplit_once('.').map_or("", |(_, extension)| extension).to_owned()
}

/// The format that a name promises.
pub(super) fn by_name(name: &str) -> Option<InputFormat> {
    match extension(name).as_str() {
        "nii" => Some(InputFormat::Nifti),
        "mgh" | "mgz" => Some(InputFormat::Mgh),
        "nrrd" | "nhdr" => Some(InputFormat::Nrrd),
        "mha" | "mhd" => Some(InputFormat::MetaImage),
        "dcm" => Some(InputFormat::DicomSeg),
        "pial" | "white" | "inflated" | "orig" | "asc" => Some(InputFormat::Freesurfer),
        "gii" => Some(InputFormat::Gifti),
        "ply" => Some(InputFormat::Ply),
        "stl" => Some(InputFormat::Stl),
        "vtk" => Some(InputFormat::Vtk),
        "vtp" => Some(InputFormat::Vtp),
        "obj" => Some(InputFormat::Obj),
        "off" => Some(InputFormat::Off),
        "mz3" => Some(InputFormat::Mz3),
        _ => None,
    }
}

/// What a report says of a file whose name promises another format than it has.
pub(super) fn misnamed(format: InputFormat, file_name: Option<&str>) -> Option<String> {
    let promised = by_name(file_name?).filter(|&promised| promised != format)?;
    Some(format!("the name promises {}, but the content is {}, and was read as that", promised.title(), format.title()))
}
