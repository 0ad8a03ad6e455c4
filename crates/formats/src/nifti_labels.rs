//! The label table of a NIfTI volume: a Connectome Workbench extension with XML, in which `<Label Key="17"
//! …>name</Label>` names the value 17. Other extensions are ignored: names are not needed to read the voxels.

use super::FormatError;
use super::budget::Budget;
use super::element::ByteOrder;
use super::xml::{Node, Xml};
use std::collections::BTreeMap;

/// The code of extensions of Caret and Connectome Workbench.
const CODE: i32 = 30;
/// Largest number of named labels, and largest length of a name, bytes.
const MAX_LABELS: usize = 10_000;
const MAX_NAME_BYTES: usize = 256;

/// The names in `extensions`, the bytes between header and voxels; empty if there are none.
///
/// # Errors
/// `TooLarge` beyond the budget.
pub(super) fn label_names(
    mut extensions: &[u8],
    order: ByteOrder,
    budget: &Budget,
) -> Result<BTreeMap<u32, String>, FormatError> {
    let number = |bytes: &[u8]| {
        let bytes: Option<[u8; 4]> = bytes.get(..4).and_then(|four| four.try_into().ok());
        bytes.map(|bytes| match order {
            ByteOrder::Little => i32::from_le_bytes(bytes),
            ByteOrder::Big => i32::from_be_bytes(bytes),
        })
    };
    while let (Some(size), Some(code)) = (number(extensions), extensions.get(4..).and_then(number)) {
        let Some(content) = usize::try_from(size).ok().and_then(|size| extensions.get(8..size)) else { break };
        if code == CODE {
            let names = in_xml(content, budget)?;
            if !names.is_empty() {
                return Ok(names);
            }
        }
        extensions = &extensions[8 + content.len()..];
    }
    Ok(BTreeMap::new())
}

fn in_xml(content: &[u8], budget: &Budget) -> Result<BTreeMap<u32, String>, FormatError> {
    // Extensions are padded to a multiple of 16 bytes.
    let content = &content[..content.iter().position(|&byte| byte == 0).unwrap_or(content.len())];
    let mut xml = Xml::new(content, "NIfTI");
    let (mut names, mut key) = (BTreeMap::new(), None::<u32>);
    while let Ok(Some(node)) = xml.next() {
        match node {
            Node::Start(tag) => key = if tag.name == "Label" { tag.number("Key") } else { None },
            Node::Text(text) => {
                let Some(key) = key.filter(|key| *key > 0 && names.len() < MAX_LABELS) else { continue };
                let text = &text[..text.len().min(MAX_NAME_BYTES)];
                let name = String::from_utf8_lossy(text).trim().to_owned();
                if !name.is_empty() {
                    budget.charge(2 * name.len() + 64)?;
                    names.entry(key).or_insert(name);
                }
            }
            Node::End => key = None,
        }
    }
    Ok(names)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nifti::{read_nifti, write_nifti};
    use crate::{LabelVolume, ReadLimits};
    use nalgebra::Matrix4;
    use proptest::prelude::*;

    const TABLE: &str = "<?xml version=\"1.0\"?><CaretExtension><VolumeInformation Index=\"0\"><LabelTable>\
        <Label Key=\"0\" Red=\"1\">???</Label><Label Key=\"17\" Red=\"0.9\"><![CDATA[Left Hippocampus]]></Label>\
        <Label Key=\"53\">Right &amp; wrong</Label></LabelTable></VolumeInformation></CaretExtension>";

    /// A volume of one voxel with an extension.
    fn with_extension(content: &[u8], size: i32, code: i32) -> Vec<u8> {
        let volume = LabelVolume::new([1, 1, 1], vec![17], Matrix4::identity()).unwrap();
        let plain = write_nifti(&volume);
        let mut file = plain[..352].to_vec();
        file[348] = 1;
        file.extend(size.to_le_bytes());
        file.extend(code.to_le_bytes());
        file.extend(content);
        let offset = file.len().div_ceil(16) * 16;
        file.resize(offset, 0);
        file[108..112].copy_from_slice(&(offset as f32).to_le_bytes());
        file.extend(&plain[352..]);
        file
    }

    #[test]
    fn names_of_a_label_table_are_read() {
        let padded = (8 + TABLE.len()).div_ceil(16) * 16;
        let mut content = TABLE.as_bytes().to_vec();
        content.resize(padded - 8, 0);
        let read = read_nifti(&with_extension(&content, padded as i32, CODE), &ReadLimits::default()).unwrap();
        assert_eq!(read.names[&17], "Left Hippocampus");
        assert_eq!(read.names.len(), 2);
        let other = read_nifti(&with_extension(&content, padded as i32, 4), &ReadLimits::default()).unwrap();
        assert!(other.names.is_empty(), "an extension of another program");
    }

    proptest! {
        /// The voxels are read regardless of the bytes between header and voxels.
        #[test]
        fn any_extension_leaves_the_voxels_alone(
            content in prop::collection::vec(any::<u8>(), 0..200),
            cut in 0..=TABLE.len(),
            size in any::<i32>(),
        ) {
            for content in [&content[..], &TABLE.as_bytes()[..cut]] {
                for size in [size, 8 + content.len() as i32] {
                    let read = read_nifti(&with_extension(content, size, CODE), &ReadLimits::default()).unwrap();
                    prop_assert_eq!(read.volume.labels(), [17]);
                }
            }
        }
    }
}
