"""Writes the voxels of a NIfTI label volume as a binary DICOM SEG, with pydicom.

Usage: make_seg.py VOLUME.nii.gz OUT.dcm STUDY_UID
"""

import sys

import nibabel
import numpy as np
from pydicom.dataset import Dataset, FileMetaDataset
from pydicom.pixels import pack_bits
from pydicom.sequence import Sequence
from pydicom.uid import ExplicitVRLittleEndian, generate_uid

volume, out, study = sys.argv[1:]
image = nibabel.load(volume)
voxels = np.asarray(image.dataobj) > 0
to_lps = np.diag([-1.0, -1.0, 1.0, 1.0]) @ image.affine
spacing = np.linalg.norm(to_lps[:3, :3], axis=0)
along = to_lps[:3, :3] / spacing


def item(**values):
    found = Dataset()
    for name, value in values.items():
        setattr(found, name, Sequence(value) if isinstance(value, list) and value and isinstance(value[0], Dataset) else value)
    return found


def code(value, scheme, meaning):
    return item(CodeValue=value, CodingSchemeDesignator=scheme, CodeMeaning=meaning)


seg = Dataset()
seg.file_meta = FileMetaDataset()
seg.file_meta.TransferSyntaxUID = ExplicitVRLittleEndian
seg.file_meta.MediaStorageSOPClassUID = seg.SOPClassUID = "1.2.840.10008.5.1.4.1.1.66.4"
seg.file_meta.MediaStorageSOPInstanceUID = seg.SOPInstanceUID = generate_uid(entropy_srcs=[volume, study])
seg.StudyInstanceUID, seg.SeriesInstanceUID = study, generate_uid(entropy_srcs=["series", study])
seg.FrameOfReferenceUID = generate_uid(entropy_srcs=["frame", study])
seg.PatientName, seg.PatientID, seg.PatientBirthDate, seg.PatientSex = "Doe^Jane", "4711", "19500101", "F"
seg.StudyDate, seg.StudyTime, seg.StudyID, seg.AccessionNumber = "20260102", "030405", "1", "A1"
seg.ReferringPhysicianName, seg.Modality, seg.SeriesNumber, seg.InstanceNumber = "Roe^Richard", "SEG", 5, 1
seg.ContentDate, seg.ContentTime = "20260102", "030405"
seg.SegmentationType, seg.ImageType = "BINARY", ["DERIVED", "PRIMARY"]
seg.SamplesPerPixel, seg.PhotometricInterpretation = 1, "MONOCHROME2"
seg.BitsAllocated, seg.BitsStored, seg.HighBit, seg.PixelRepresentation = 1, 1, 0, 0
# Columns run along the first axis of the volume, rows along the second.
seg.Columns, seg.Rows, seg.NumberOfFrames = voxels.shape
structure = code("123037004", "SCT", "Anatomical Structure")
seg.SegmentSequence = Sequence([
    item(
        SegmentNumber=1,
        SegmentLabel="Left Hippocampus",
        SegmentAlgorithmType="MANUAL",
        SegmentedPropertyCategoryCodeSequence=[structure],
        SegmentedPropertyTypeCodeSequence=[structure],
    )
])
seg.SharedFunctionalGroupsSequence = Sequence([
    item(
        PixelMeasuresSequence=[item(PixelSpacing=[spacing[1], spacing[0]], SliceThickness=spacing[2], SpacingBetweenSlices=spacing[2])],
        PlaneOrientationSequence=[item(ImageOrientationPatient=[*along[:, 0], *along[:, 1]])],
    )
])
seg.PerFrameFunctionalGroupsSequence = Sequence([
    item(
        PlanePositionSequence=[item(ImagePositionPatient=[float(x) for x in (to_lps @ [0, 0, k, 1])[:3]])],
        SegmentIdentificationSequence=[item(ReferencedSegmentNumber=1)],
    )
    for k in range(voxels.shape[2])
])
seg.PixelData = pack_bits(voxels.transpose(2, 1, 0).astype(np.uint8).ravel())
seg.save_as(out, enforce_file_format=True)
