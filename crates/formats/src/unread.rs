//! Formats that are recognized but not read: their names, and what to send instead.

use super::freesurfer;
use super::text::{has_root, real, without_preamble, words};

const LABELS: &str = "convert the label volume to NIfTI (mnc2nii, or mri_convert)";
const MODEL: &str = "export the surface as PLY, STL or OBJ";
const PACKED: &str = "unpack it and send one file of it, or compress that with gzip";
const IMAGE: &str = "send the surface or label volume itself, not a picture of it";

/// Formats by their first bytes: name, and what to send instead.
const BY_MAGIC: [(&[u8], &str, &str); 44] = [
    (b"\x89HDF\r\n\x1a\n", "an HDF5 file (MINC 2, VTKHDF or others)", LABELS),
    (b"CDF\x01", "a NetCDF file (MINC 1)", LABELS),
    (b"CDF\x02", "a NetCDF file (MINC 1)", LABELS),
    (b"Kaydara FBX Binary", "FBX", MODEL),
    (b"; FBX", "FBX", MODEL),
    (b"glTF", "glTF", "export the surface as PLY, STL or OBJ in millimeters: glTF is in meters"),
    (b"BLENDER", "a file of Blender", MODEL),
    (b"PXR-USDC", "USD", MODEL),
    (b"#usda", "USD", MODEL),
    (b"ISO-10303-21", "STEP", MODEL),
    (b"#VRML", "a scene (COLLADA, X3D or VRML)", MODEL),
    (b"#X3D", "a scene (COLLADA, X3D or VRML)", MODEL),
    (b"#Inventor", "a scene of Open Inventor", MODEL),
    (b"rply", "a file of another program that looks like PLY", MODEL),
    (b"PK\x03\x04", "a zip archive", "unpack it and send one file of it"),
    (b"BZh", "a file compressed with bzip2", PACKED),
    (b"\xfd7zXZ\x00", "a file compressed with xz", PACKED),
    (b"\x28\xb5\x2f\xfd", "a file compressed with zstd", PACKED),
    (b"7z\xbc\xaf\x27\x1c", "a 7z archive", PACKED),
    (b"Rar!", "a RAR archive", PACKED),
    (b"\xff\xff\xff\xff", "a FreeSurfer patch", "it is cut open; send the whole surface, such as lh.pial or lh.white"),
    (b"binar", "a BrainVISA .mesh surface", "convert it to GIFTI (AimsFileConvert)"),
    (b"mrtrix image", "an image of MRtrix (.mif)", "convert it to NIfTI (mrconvert)"),
    (b"mrtrix tracks", "tracks of MRtrix", "send a surface or a label volume"),
    (b"TRACK", "tracks of TrackVis", "send a surface or a label volume"),
    (b"!INTERFILE", "Interfile", "convert the label volume to NIfTI"),
    (b"\x93NUMPY", "an array of NumPy", "save the labels as NIfTI, with their affine (nibabel)"),
    (
        b"MATLAB 5.0 MAT-file",
        "a file of MATLAB",
        "save the labels as NIfTI (niftiwrite), or the surface as STL (stlwrite)",
    ),
    (b"\x89PNG\r\n\x1a\n", "a PNG picture", IMAGE),
    (b"\xff\xd8\xff", "a JPEG picture", IMAGE),
    (b"GIF8", "a GIF picture", IMAGE),
    (b"II*\x00", "a TIFF picture", "convert a stack of labels to NIfTI or NRRD, with its voxel sizes"),
    (b"MM\x00*", "a TIFF picture", "convert a stack of labels to NIfTI or NRRD, with its voxel sizes"),
    (b"II+\x00", "a TIFF picture", "convert a stack of labels to NIfTI or NRRD, with its voxel sizes"),
    (b"%PDF", "a PDF document", IMAGE),
    (b"version https://git-lfs", "a pointer of Git LFS, and not the file itself", "fetch the file (git lfs pull)"),
    (b"/annex/objects/", "a pointer of git-annex, and not the file itself", "fetch the file (git annex get)"),
    (b"../.git/annex/", "a pointer of git-annex, and not the file itself", "fetch the file (git annex get)"),
    (b"<!DOCTYPE html", "an HTML page, as of a download that failed", "download the file again"),
    (b"<!doctype html", "an HTML page, as of a download that failed", "download the file again"),
    (b"<html", "an HTML page, as of a download that failed", "download the file again"),
    (b"\xff\xfe", "text in UTF-16", "save it as UTF-8 or ASCII"),
    (b"\xfe\xff", "text in UTF-16", "save it as UTF-8 or ASCII"),
    (b"SIMPLE  =", "a FITS image", "convert the label volume to NIfTI"),
];

/// The format of a file that is recognized but not read, if any. `extension` is the extension of its name.
pub(super) fn named(bytes: &[u8], extension: &str) -> Option<(&'static str, &'static str)> {
    let text = without_preamble(bytes.get(..4096).unwrap_or(bytes));
    // A polygonal surface: material, number of points, then one point per line.
    let mni = text.starts_with(b"P ") && words(&text[2..]).take(5).all(|word| real(word).is_some());
    if mni || extension == "obj" && bytes.starts_with(b"p") && text.contains(&0) {
        let advice = "convert it to GIFTI or PLY, for example with ConvertSurface of AFNI or with Surf Ice";
        return Some(("an MNI .obj surface, which is no Wavefront OBJ", advice));
    }
    if freesurfer::is_label(text) {
        return Some((
            "a FreeSurfer label",
            "it lists vertices of a surface; send the surface, such as lh.pial or lh.white",
        ));
    }
    let found = BY_MAGIC.iter().find(|(magic, ..)| bytes.starts_with(magic) || text.starts_with(magic));
    if let Some(&(_, what, advice)) = found {
        return Some((what, advice));
    }
    let has = |word: &[u8]| text.windows(word.len()).any(|w| w == word);
    if text.starts_with(b"{") && has(b"\"asset\"") {
        return Some(("glTF", "export the surface as PLY, STL or OBJ in millimeters: glTF is in meters"));
    }
    if text.starts_with(b"ascii") && extension == "mesh" {
        return Some(("a BrainVISA .mesh surface", "convert it to GIFTI (AimsFileConvert)"));
    }
    if has_root(bytes, b"<COLLADA") || has_root(bytes, b"<X3D") {
        return Some(("a scene (COLLADA, X3D or VRML)", MODEL));
    }
    if has_root(bytes, b"<html") || has_root(bytes, b"<HTML") {
        return Some(("an HTML page, as of a download that failed", "download the file again"));
    }
    if has_root(bytes, b"<amf") || has_root(bytes, b"<model") {
        return Some(("AMF, or the model of a 3MF archive", MODEL));
    }
    if bytes.get(257..262) == Some(b"ustar") {
        return Some(("a tar archive", PACKED));
    }
    if text.starts_with(b"type") && has(b"string-attribute") {
        return Some(("the header of an AFNI volume (.HEAD)", "convert it to NIfTI (3dAFNItoNIFTI)"));
    }
    Some(match extension {
        "mnc" => ("MINC", LABELS),
        "img" | "hdr" => ("ANALYZE, or a NIfTI volume in two files", "save it as one .nii or .nii.gz file"),
        "nhdr" | "mhd" => {
            ("a header whose voxels are in another file", "save header and voxels in one .nrrd or .mha file")
        }
        "raw" | "zraw" => ("an array of voxels without its header", "save header and voxels in one .nrrd or .mha file"),
        "head" | "brik" => ("an AFNI volume in two files", "convert it to NIfTI (3dAFNItoNIFTI)"),
        "srf" | "vmr" => ("BrainVoyager", "export the surface as PLY, STL or OBJ, or the labels as NIfTI"),
        "annot" => ("a FreeSurfer annotation", "send the surface to which it belongs, such as lh.pial or lh.white"),
        "curv" | "thickness" | "sulc" | "area" | "volume" => (
            "a FreeSurfer file of per-vertex values",
            "send the surface to which they belong, such as lh.pial or lh.white",
        ),
        "3ds" | "dxf" | "iges" | "igs" | "step" | "stp" | "dae" | "wrl" | "x3d" | "3dm" | "skp" | "usdz" => {
            ("a format of computer-aided design", MODEL)
        }
        _ => return None,
    })
}
