//! DICOM Spatial Registration: the rigid transform as an object in the study of the source.
//!
//! Source: DICOM PS3.3, sections A.39 and C.20.2 (Spatial Registration), and PS3.10, section 7 (file). Hand-written, in
//! explicit little endian as read by [`super::dicom`]: a library would bring a dictionary of all attributes for forty
//! of them.
//!
//! The registered coordinate system is the frame of reference of the target. Patient and study are those of the source,
//! or of the target if the source is not a DICOM object, so that a structure matched to a template of another format
//! keeps its study. If neither is one, a study may be given. A file that is not a DICOM object has the frame of
//! reference given for it, or one named by its content, so that equal templates have equal ones. Equal inputs give an
//! object with the same UID.

use super::budget::{self, Budget};
use super::dicom::{DataSet, SOP_CLASS, SOP_INSTANCE, is_dicom, read_file};
use super::dicom_file::{
    Elements, FRAME_OF_REFERENCE, SERIES, STUDY, Study, add_study, decimal, file, frame_of_reference, uid_of,
};
use super::{FormatError, ReadLimits, archive};
use nalgebra::{Matrix4, Vector4};

const CLASS: &str = "1.2.840.10008.5.1.4.1.1.66.1";

/// The two inputs of a match, as uploaded.
#[derive(Debug, Clone, Copy)]
pub struct RegisteredFiles<'a> {
    /// The source.
    pub source: &'a [u8],
    /// The target.
    pub target: &'a [u8],
    /// UID of the study, used where neither input is a DICOM object.
    pub study_uid: Option<&'a str>,
    /// UIDs of the frames of reference of source and target, used if the input states none.
    pub frame_uids: [Option<&'a str>; 2],
    /// Largest size of an input after decompression, bytes.
    pub max_inflated_bytes: usize,
}

/// The object as a file of part 10. `created_at` is the time at which the transform was computed: `YYYYMMDDHHMMSS`,
/// UTC. `Ok(None)` if neither input is a DICOM object and no study is given. The patient of a given study is unknown:
/// its attributes are present and empty.
///
/// # Errors
/// [`FormatError`] if an input is a DICOM object that cannot be read.
pub fn write_spatial_registration(
    target_from_source: &[[f64; 4]; 4],
    files: &RegisteredFiles<'_>,
    created_at: &str,
) -> Result<Option<Vec<u8>>, FormatError> {
    let limit = files.max_inflated_bytes;
    let limits = ReadLimits { max_inflated_bytes: limit, ..ReadLimits::default() };
    let plain = [archive::dicom_or_plain(files.source, &limits)?, archive::dicom_or_plain(files.target, &limits)?];
    let mut inflated = [Vec::new(), Vec::new()];
    let [of_source, of_target] = &mut inflated;
    let source = data_set(&plain[0], of_source, &limits)?;
    let target = data_set(&plain[1], of_target, &limits)?;
    let of_input = source.as_ref().or(target.as_ref()).map(Study::Of);
    let Some(study) = of_input.or_else(|| files.study_uid.map(Study::Named)) else { return Ok(None) };
    let frames = [
        frame_of_reference(source.as_ref(), &plain[0], files.frame_uids[0]),
        frame_of_reference(target.as_ref(), &plain[1], files.frame_uids[1]),
    ];
    let matrix = in_lps(target_from_source);
    let numbers: Vec<u8> = target_from_source.iter().flatten().flat_map(|v| v.to_le_bytes()).collect();
    let of_inputs = [blake3::hash(&plain[0]), blake3::hash(&plain[1])].map(|hash| *hash.as_bytes());
    let study_uid = study.uid();
    let given = if matches!(study, Study::Named(_)) { study_uid.as_bytes() } else { &[] };
    let uid = |what: &[u8]| {
        let mut parts: Vec<&[u8]> = vec![what, &of_inputs[0], &of_inputs[1], &numbers];
        // Objects in different studies are different objects.
        parts.extend((!given.is_empty()).then_some(given));
        uid_of(&parts)
    };
    let (instance, series) = (uid(b"instance"), uid(b"series"));
    let (day, time) = created_at.split_at_checked(8).unwrap_or(("19700101", "000000"));

    let mut body = Elements::default();
    add_study(&mut body, &study);
    body.text(SOP_CLASS, b"UI", CLASS);
    body.text(SOP_INSTANCE, b"UI", &instance);
    body.text(0x0008_0023, b"DA", day);
    body.text(0x0008_0033, b"TM", time);
    body.text(0x0008_0060, b"CS", "REG");
    body.text(0x0008_0070, b"LO", "homolog");
    body.text(0x0008_103e, b"LO", "Rigid registration of surfaces");
    body.text(0x0018_1020, b"LO", env!("CARGO_PKG_VERSION"));
    body.text(SERIES, b"UI", &series);
    body.text(0x0020_0011, b"IS", "1");
    body.text(0x0020_0013, b"IS", "1");
    body.text(FRAME_OF_REFERENCE, b"UI", &frames[1]);
    // Required by the standard; the value is unknown.
    body.text(0x0020_0060, b"CS", "");
    body.text(0x0020_1040, b"LO", "");
    body.text(0x0070_0080, b"CS", "REGISTRATION");
    body.text(0x0070_0081, b"LO", "Rigid transform of the source onto the target");
    body.text(0x0070_0084, b"PN", "");
    let identity = Matrix4::identity();
    body.items(
        0x0070_0308,
        &[registration(&frames[1], target.as_ref(), &identity), registration(&frames[0], source.as_ref(), &matrix)],
    );
    references(&mut body, &study_uid, [source.as_ref(), target.as_ref()]);
    Ok(Some(file(CLASS, &instance, &body)))
}

/// The data set of a DICOM file; `None` for other files.
fn data_set<'a>(
    bytes: &'a [u8],
    inflated: &'a mut Vec<u8>,
    limits: &ReadLimits,
) -> Result<Option<DataSet<'a>>, FormatError> {
    let budget = Budget::new(budget::for_file(bytes.len()));
    if is_dicom(bytes) { read_file(bytes, inflated, limits, &budget).map(|(set, _)| Some(set)) } else { Ok(None) }
}

/// `F · M · F` with `F = diag(−1, −1, 1, 1)`: the same transform in LPS.
fn in_lps(target_from_source: &[[f64; 4]; 4]) -> Matrix4<f64> {
    let flip = Matrix4::from_diagonal(&Vector4::new(-1.0, -1.0, 1.0, 1.0));
    flip * Matrix4::from_fn(|r, c| target_from_source[r][c]) * flip
}

/// Rigid, unless the transform mirrors: rigid transforms of DICOM do not.
fn kind(matrix: &Matrix4<f64>) -> &'static str {
    if matrix.fixed_view::<3, 3>(0, 0).determinant() > 0.0 { "RIGID" } else { "AFFINE" }
}

/// An item of the registration sequence: the map from a frame of reference, and from `input` in it, to the frame of the
/// object.
fn registration(frame: &str, input: Option<&DataSet<'_>>, matrix: &Matrix4<f64>) -> Elements {
    let numbers: Vec<String> = (0..16).map(|k| decimal(matrix[(k / 4, k % 4)])).collect();
    let mut one = Elements::default();
    one.text(0x0070_030c, b"CS", kind(matrix));
    one.text(0x3006_00c6, b"DS", &numbers.join("\\"));
    let mut matrices = Elements::default();
    matrices.items(0x0070_030a, &[one]);
    matrices.items(0x0070_030d, &[]);
    let mut item = Elements::default();
    item.text(FRAME_OF_REFERENCE, b"UI", frame);
    if let Some(input) = input {
        item.items(0x0008_1140, &[instance_of(input)]);
    }
    item.items(0x0070_0309, &[matrices]);
    item
}

/// A reference to an instance.
fn instance_of(set: &DataSet<'_>) -> Elements {
    let mut instance = Elements::default();
    instance.text(0x0008_1150, b"UI", &set.text(SOP_CLASS));
    instance.text(0x0008_1155, b"UI", &set.text(SOP_INSTANCE));
    instance
}

/// References to the inputs: those in the study, and the others.
fn references(body: &mut Elements, study_uid: &str, inputs: [Option<&DataSet<'_>>; 2]) {
    let series = |set: &DataSet<'_>| {
        let mut series = Elements::default();
        series.items(0x0008_114a, &[instance_of(set)]);
        series.text(SERIES, b"UI", &set.text(SERIES));
        series
    };
    let (mut here, mut elsewhere, mut seen) = (Vec::new(), Vec::new(), Vec::new());
    for set in inputs.into_iter().flatten() {
        // A file matched with itself is referenced once.
        let instance = set.text(SOP_INSTANCE);
        if seen.contains(&instance) {
            continue;
        }
        seen.push(instance);
        if set.text(STUDY) == study_uid {
            here.push(series(set));
        } else {
            let mut other = Elements::default();
            other.items(0x0008_1115, &[series(set)]);
            other.text(STUDY, b"UI", &set.text(STUDY));
            elsewhere.push(other);
        }
    }
    if !here.is_empty() {
        body.items(0x0008_1115, &here);
    }
    if !elsewhere.is_empty() {
        body.items(0x0008_1200, &elsewhere);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MOVED: [[f64; 4]; 4] =
        [[0.0, -1.0, 0.0, 10.0], [1.0, 0.0, 0.0, -20.5], [0.0, 0.0, 1.0, 3.0], [0.0, 0.0, 0.0, 1.0]];

    /// A data set of a patient, in a study, with a frame of reference.
    fn input(patient: &str, study: &str, frame: &str, instance: &str) -> Vec<u8> {
        let mut set = Elements::default();
        set.text(SOP_CLASS, b"UI", "1.2.840.10008.5.1.4.1.1.66.4");
        set.text(SOP_INSTANCE, b"UI", instance);
        set.text(0x0010_0010, b"PN", patient);
        set.text(STUDY, b"UI", study);
        set.text(SERIES, b"UI", "1.2.9");
        set.text(FRAME_OF_REFERENCE, b"UI", frame);
        file(CLASS, instance, &set)
    }

    fn written(source: &[u8], target: &[u8]) -> Option<Vec<u8>> {
        named(source, target, None, [None, None])
    }

    fn named(source: &[u8], target: &[u8], study_uid: Option<&str>, frame_uids: [Option<&str>; 2]) -> Option<Vec<u8>> {
        let files = RegisteredFiles { source, target, study_uid, frame_uids, max_inflated_bytes: 1 << 20 };
        write_spatial_registration(&MOVED, &files, "20261122201500").unwrap()
    }

    fn matrix(item: &DataSet<'_>) -> Vec<f64> {
        let one = item.item(0x0070_0309).unwrap().item(0x0070_030a).unwrap();
        assert_eq!(one.text(0x0070_030c), "RIGID");
        one.numbers(0x3006_00c6)
    }

    #[test]
    fn the_object_belongs_to_the_study_of_the_source_and_maps_to_the_target_in_lps() {
        let [source, target] = [("Doe^Jane", "1.2.3", "1.2.5", "1.2.7"), ("Template", "1.2.4", "1.2.6", "1.2.8")]
            .map(|(patient, study, frame, instance)| input(patient, study, frame, instance));
        let bytes = written(&source, &target).unwrap();
        assert_eq!(written(&source, &target).unwrap(), bytes, "equal inputs give equal bytes");
        let mut inflated = Vec::new();
        let set = read_file(&bytes, &mut inflated, &ReadLimits::default(), &Budget::new(1 << 20)).unwrap().0;
        assert_eq!((set.text(0x0010_0010).as_str(), set.text(STUDY).as_str()), ("Doe^Jane", "1.2.3"));
        assert_eq!((set.text(SOP_CLASS).as_str(), set.text(FRAME_OF_REFERENCE).as_str()), (CLASS, "1.2.6"));
        assert_eq!((set.text(0x0008_0023).as_str(), set.text(0x0008_0033).as_str()), ("20261122", "201500"));
        let items = set.items(0x0070_0308);
        assert_eq!([0, 1].map(|k| items[k].text(FRAME_OF_REFERENCE)), ["1.2.6", "1.2.5"]);
        let expected = [0.0, -1.0, 0.0, -10.0, 1.0, 0.0, 0.0, 20.5, 0.0, 0.0, 1.0, 3.0, 0.0, 0.0, 0.0, 1.0];
        assert_eq!(matrix(&items[1]), expected);
        assert_eq!(matrix(&items[0]), Matrix4::<f64>::identity().as_slice());
        let here = set.item(0x0008_1115).unwrap().item(0x0008_114a).unwrap();
        let other = set.item(0x0008_1200).unwrap();
        assert_eq!((here.text(0x0008_1155).as_str(), other.text(STUDY).as_str()), ("1.2.7", "1.2.4"));
    }

    #[test]
    fn a_template_that_is_no_dicom_object_has_a_frame_of_reference_of_its_own() {
        let source = input("Doe^Jane", "1.2.3", "1.2.5", "1.2.7");
        let frame = |template: &[u8]| {
            let bytes = written(&source, template).unwrap();
            let mut inflated = Vec::new();
            read_file(&bytes, &mut inflated, &ReadLimits::default(), &Budget::new(1 << 20))
                .unwrap()
                .0
                .text(FRAME_OF_REFERENCE)
        };
        assert_eq!(frame(b"ply one"), frame(b"ply one"));
        assert_ne!(frame(b"ply one"), frame(b"ply two"));
        assert!(frame(b"ply one").starts_with("2.25.") && frame(b"ply one").len() <= 64);
        assert_eq!(written(b"ply one", b"ply two"), None, "no patient, no study");
    }

    #[test]
    fn given_uids_name_the_study_and_frames_of_files_that_have_none() {
        let texts = |bytes: Option<Vec<u8>>| {
            let (bytes, mut inflated) = (bytes.unwrap(), Vec::new());
            let set = read_file(&bytes, &mut inflated, &ReadLimits::default(), &Budget::new(1 << 20)).unwrap().0;
            let frames = [0, 1].map(|k| set.items(0x0070_0308)[k].text(FRAME_OF_REFERENCE));
            ([0x0010_0010, STUDY, SOP_INSTANCE].map(|tag| set.text(tag)), frames)
        };
        let given = |study| texts(named(b"ply one", b"ply two", Some(study), [Some("1.2.5"), Some("1.2.6")]));
        let ([patient, study, instance], frames) = given("1.2.3");
        assert_eq!((patient.as_str(), study.as_str(), frames), ("", "1.2.3", ["1.2.6".to_owned(), "1.2.5".to_owned()]));
        assert_ne!(given("1.2.4").0[2], instance, "another study, another object");
        // Identifiers stated by an input take precedence.
        let source = input("Doe^Jane", "1.2.3", "1.2.5", "1.2.7");
        let ([patient, study, _], frames) =
            texts(named(&source, b"ply", Some("1.9.1"), [Some("1.9.2"), Some("1.9.3")]));
        assert_eq!((patient.as_str(), study.as_str()), ("Doe^Jane", "1.2.3"));
        assert_eq!(frames, ["1.9.3", "1.2.5"]);
    }

    #[test]
    fn decimal_strings_have_at_most_sixteen_characters() {
        for (value, text) in [(0.0, "0.00000000000000"), (-0.0, "0.00000000000000"), (-123.456, "-123.45600000000")] {
            assert_eq!(decimal(value), text);
        }
        for value in [1.0 / 3.0, -1e9 / 7.0, 1e20, -1.0 / 3e5, 123_456_789.123] {
            let text = decimal(value);
            assert!(text.len() <= 16, "{text}");
            assert!((text.parse::<f64>().unwrap() / value - 1.0).abs() < 1e-8, "{text}");
        }
    }
}
