//! Detects the format of a file by its content. The name decides only where the content does not, and only between
//! formats without a magic word.

use super::text::{has_root, without_preamble};
use super::{FormatError, InputFormat, dicom, freesurfer, metaimage, mgh, mz3, nifti, nrrd, obj, off, stl, unread};

/// The format of an uncompressed file, and its bytes from where it begins: a byte order mark or blanks may precede
/// text.
///
/// # Errors
/// `Unsupported` for a format that is known but not read; `NotAsNamed`; `UnknownFormat`.
pub(super) fn detect<'a>(bytes: &'a [u8], file_name: Option<&str>) -> Result<(InputFormat, &'a [u8]), FormatError> {
    let text = without_preamble(bytes);
    for begin in [bytes, text] {
        if let Some(format) = by_content(begin) {
            return Ok((format, begin));
        }
    }
    let extension = file_name.map(extension).unwrap_or_default();
    if let Some((what, advice)) = unread::named(bytes, &extension) {
        return Err(FormatError::Unsupported { what, advice });
    }
    let promised = file_name.and_then(by_name);
    match promised {
        Some(InputFormat::Stl) if stl::may_be_stl(bytes, true) => Ok((InputFormat::Stl, bytes)),
        // The content does not contradict the name.
        Some(format @ (InputFormat::Off | InputFormat::Obj | InputFormat::Freesurfer)) if is_numbers(text) => {
            Ok((format, text))
        }
        Some(format) => Err(FormatError::NotAsNamed { promised: format.title() }),
        None if stl::may_be_stl(bytes, false) => Ok((InputFormat::Stl, bytes)),
        None => Err(FormatError::UnknownFormat),
    }
}

/// The format by content alone.
pub(super) fn by_content(bytes: &[u8]) -> Option<InputFormat> {
    let starts = |magic: &str| bytes.get(..magic.len()).is_some_and(|head| head.eq_ignore_ascii_case(magic.as_bytes()));
    let is_ply = starts("ply") && bytes.get(3).is_some_and(u8::is_ascii_whitespace);
    let formats = [
        (nifti::is_nifti(bytes), InputFormat::Nifti),
        (is_ply, InputFormat::Ply),
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
        (dicom::is_dicom(bytes), InputFormat::DicomSeg),
    ];
    formats.into_iter().find_map(|(is, format)| is.then_some(format))
}

/// Whether a text begins with a line of numbers, after comments.
fn is_numbers(text: &[u8]) -> bool {
    let mut lines = text.split(|&byte| byte == b'\n').map(|line| line.trim_ascii());
    let first = lines.find(|line| !line.is_empty() && !line.starts_with(b"#")).unwrap_or_default();
    let mut words = super::text::words(first).peekable();
    words.peek().is_some() && words.all(|word| super::text::real(word).is_some())
}

/// The extension of a name, without `.gz`, in lower case.
fn extension(name: &str) -> String {
    let name = name.to_ascii_lowercase();
    let name = name.strip_suffix(".gz").unwrap_or(&name);
    name.rsplit_once('.').map_or("", |(_, extension)| extension).to_owned()
}

/// The format that a name indicates.
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

/// Note of a report on a file whose name indicates another format than it has.
pub(super) fn misnamed(format: InputFormat, file_name: Option<&str>) -> Option<String> {
    let promised = by_name(file_name?).filter(|&promised| promised != format)?;
    Some(format!("the name promises {}, but the content is {}, and was read as that", promised.title(), format.title()))
}
