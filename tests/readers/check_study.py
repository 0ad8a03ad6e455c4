"""Opens what `homolog study` wrote with other programs, and compares the files with each other.

Usage: check_study.py FOLDER"""
import csv
import json
import sys
from pathlib import Path

import nibabel
import numpy as np
import pyarrow.parquet
import vtk
from vtk.util.numpy_support import vtk_to_numpy

folder = Path(sys.argv[1])
SINGLE = 2e-6  # relative error of single precision, with room


def of_vtk(path):
    reader = vtk.vtkPolyDataReader()
    reader.SetFileName(str(path))
    reader.ReadAllScalarsOn()
    reader.Update()
    data = reader.GetOutput()
    values = data.GetPointData()
    arrays = {values.GetArrayName(k): vtk_to_numpy(values.GetArray(k)) for k in range(values.GetNumberOfArrays())}
    return vtk_to_numpy(data.GetPoints().GetData()), arrays


def close(a, b):
    np.testing.assert_allclose(np.asarray(a, float), np.asarray(b, float), rtol=SINGLE, atol=1e-5)


surfaces = [folder / "mean.surf.gii", folder / "template/template.surf.gii", *folder.glob("modes/*.gii"), *folder.glob("subjects/*.gii")]
assert len(surfaces) > 5
for path in surfaces:
    image = nibabel.load(path)
    points, faces = image.agg_data("pointset"), image.agg_data("triangle")
    others, arrays = of_vtk(path.with_name(path.name.replace(".surf.gii", ".vtk")))
    close(points, others)
    assert faces.max() == len(points) - 1
    for array in image.darrays[2:]:
        close(array.data, arrays[array.meta["Name"]])
mean = nibabel.load(folder / "mean.surf.gii").agg_data("pointset")
maps = list(folder.glob("maps/*.shape.gii"))
assert maps
for path in maps:
    image = nibabel.load(path)
    points, arrays = of_vtk(path.with_name(path.name.replace(".shape.gii", ".vtk")))
    close(points, mean)
    assert {array.meta["Name"] for array in image.darrays} == set(arrays)
    for array in image.darrays:
        assert array.intent == nibabel.nifti1.intent_codes["NIFTI_INTENT_SHAPE"] and len(array.data) == len(mean)
        close(array.data, arrays[array.meta["Name"]])
rows = list(csv.DictReader(open(folder / "subjects.csv")))
table = pyarrow.parquet.read_table(folder / "subjects.parquet").to_pydict()
assert list(rows[0]) == list(table)
for name, column in table.items():
    for row, value in zip(rows, column, strict=True):
        if isinstance(value, str):
            assert row[name] == value
        else:
            assert row[name] == "" if np.isnan(value) else float(row[name]) == value
study = json.loads((folder / "study.json").read_text())
assert [subject["id"] for subject in study["cohort"]["subjects"]] == table["id"]
