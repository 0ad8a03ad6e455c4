"""Checks a DICOM Spatial Registration with pydicom: its study, its frames of reference and its matrix.

Usage: check_registration.py REGISTRATION.dcm SOURCE_SEG.dcm TRANSFORM.json [TARGET_SEG.dcm]
"""

import json
import sys

import numpy as np
import pydicom

registration, source = pydicom.dcmread(sys.argv[1]), pydicom.dcmread(sys.argv[2])
with open(sys.argv[3]) as file:
    matrix = np.array(json.load(file)["matrix"])
assert registration.SOPClassUID == pydicom.uid.SpatialRegistrationStorage
for name in ("PatientName", "PatientID", "StudyInstanceUID", "StudyDate", "AccessionNumber"):
    assert getattr(registration, name) == getattr(source, name), name
assert registration.SeriesInstanceUID != source.SeriesInstanceUID
target, moved = registration.RegistrationSequence
assert moved.FrameOfReferenceUID == source.FrameOfReferenceUID
assert target.FrameOfReferenceUID == registration.FrameOfReferenceUID != source.FrameOfReferenceUID
if len(sys.argv) > 4:
    assert target.FrameOfReferenceUID == pydicom.dcmread(sys.argv[4]).FrameOfReferenceUID


def of(item):
    (one,) = item.MatrixRegistrationSequence[0].MatrixSequence
    assert one.FrameOfReferenceTransformationMatrixType == "RIGID"
    return np.array(one.FrameOfReferenceTransformationMatrix, float).reshape(4, 4)


flip = np.diag([-1.0, -1.0, 1.0, 1.0])
assert np.array_equal(of(target), np.eye(4))
assert np.allclose(of(moved), flip @ matrix @ flip, atol=1e-9)
print("the registration is as it should be")
