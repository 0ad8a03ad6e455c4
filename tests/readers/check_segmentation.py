"""Checks a DICOM segmentation that homolog wrote with highdicom, and an input with pynrrd.

Usage: check_segmentation.py WARPED.dcm WARPED.ply TARGET_SEG.dcm TARGET.nii.gz TARGET.nrrd

The segmentation must lie on the grid of the target, in its study and frame of reference, and enclose what the surface
encloses. TARGET.nrrd is written here, with the voxels of TARGET.nii.gz, for homolog to read.
"""

import sys

import highdicom
import nibabel
import nrrd
import numpy as np
import pydicom
import trimesh

warped, surface, target, volume, twin = sys.argv[1:]
found, grid, image = highdicom.seg.segread(warped), pydicom.dcmread(target), nibabel.load(volume)
for name in ("PatientName", "PatientID", "StudyInstanceUID", "FrameOfReferenceUID"):
    assert getattr(found, name) == getattr(grid, name), name
assert found.SeriesInstanceUID != grid.SeriesInstanceUID
assert [d.segment_label for d in map(found.get_segment_description, found.segment_numbers)] == ["source deformed onto target"]
mine = found.get_volume(combine_segments=True)
between = np.linalg.inv(np.diag([-1, -1, 1, 1]) @ image.affine) @ mine.affine
assert abs(abs(np.linalg.det(between)) - 1) < 1e-4, between
assert np.allclose(between, np.round(between), atol=1e-4), "the same lattice"
# A voxel is in the segment if the surface winds around its center (in RAS): the sum of the solid angles of all triangles.
at = np.argwhere(mine.array == 1)
box = np.argwhere(np.ones(at.max(0) - at.min(0) + 5, bool)) + at.min(0) - 2
centers = (np.c_[box, np.ones(len(box))] @ mine.affine.T)[:, :3] * [-1, -1, 1]
triangles = trimesh.load(surface, process=False).triangles
winding = np.zeros(len(box))
for few in np.array_split(np.arange(len(box)), max(1, len(box) // 400)):
    a, b, c = (triangles[None, :, k] - centers[few, None] for k in range(3))
    la, lb, lc = (np.linalg.norm(v, axis=2) for v in (a, b, c))
    volume_of = (a * np.cross(b, c)).sum(2)
    flat = la * lb * lc + (a * b).sum(2) * lc + (b * c).sum(2) * la + (c * a).sum(2) * lb
    winding[few] = 2 * np.arctan2(volume_of, flat).sum(1) / (4 * np.pi)
segment = set(map(tuple, at))
in_segment = np.array([tuple(voxel) in segment for voxel in box])
assert len(at) > 300 and not np.any(in_segment != (winding > 0.5)), np.count_nonzero(in_segment != (winding > 0.5))

header = {
    "space": "right-anterior-superior",
    "space directions": image.affine[:3, :3].T,
    "space origin": image.affine[:3, 3],
    "encoding": "gzip",
}
nrrd.write(twin, np.asarray(image.dataobj).astype(np.uint8), header)
print("the segmentation is as it should be")
