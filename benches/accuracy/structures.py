"""The sets `unlike_*`: two different structures. The verdict must have the reason `unlike_shape`.

Hippocampi and putamina of one subject are in DATA/structures, femurs and vertebrae in DATA/landmarked.
"""

import os

import numpy as np
from scipy.spatial.transform import Rotation

import geometry
import landmarked

FILES = {
    "hippocampus": ["Model_17_left_hippocampus.vtk", "Model_53_right_hippocampus.vtk"],
    "putamen": ["Model_12_left_putamen.vtk", "Model_51_right_putamen.vtk"],
}
KINDS = ["unlike_hippocampus_putamen", "unlike_femur_vertebra"]
KEPT = False
N_PAIRS = 8
"""Two sides of each structure, with both assignments of the roles."""


def names(cases, kind, n):
    if kind == "unlike_femur_vertebra":
        most = 2 * min(landmarked.count(cases, "femur"), landmarked.count(cases, "vertebra"))
    else:
        most = N_PAIRS if os.path.isdir(folder(cases)) else 0
    return [f"{kind}/{k}" for k in range(min(n, most))]


def make(cases, kind, index):
    """Pairs of structures; roles are exchanged in every second pair."""
    index = int(index)
    one, other = kind.split("_")[1:]
    surfaces = [of_structure(cases, one, index // 2), of_structure(cases, other, index // 4 + index // 2)]
    if index % 2:
        surfaces.reverse()
    (vertices, faces), (others, other_faces) = surfaces
    turn = Rotation.random(random_state=7700 + index).as_matrix()
    vertices = (vertices - vertices.mean(0)) @ turn.T
    return geometry.finished(dict(V1=vertices, F1=faces, V2=others, F2=other_faces))


def of_structure(cases, name, k):
    if name in FILES:
        with open(os.path.join(folder(cases), FILES[name][k % 2]), "rb") as file:
            return geometry.largest_piece(*geometry.welded(*read_vtk_strips(file.read())))
    pair = landmarked.generator().load_pairs(name, landmarked.folder(cases))
    vertices, faces, _ = landmarked.generator().read(landmarked.folder(cases), name, pair[k % len(pair)][0])
    return vertices, faces


def folder(cases):
    return os.path.join(cases.data, "structures")


def read_vtk_strips(data):
    """Positions and triangles of a legacy VTK file, binary, whose faces are triangle strips."""
    rows = lambda keyword: data[data.index(keyword) :].split(b"\n", 1)
    header, rest = rows(b"POINTS ")
    n = int(header.split()[1])
    vertices = np.frombuffer(rest, ">f4", 3 * n).reshape(-1, 3).astype(float)
    header, rest = rows(b"TRIANGLE_STRIPS ")
    numbers = np.frombuffer(rest, ">i4", int(header.split()[2])).astype(np.int64)
    faces, at = [], 0
    while at < len(numbers):
        strip = numbers[at + 1 : at + 1 + numbers[at]]
        for k in range(len(strip) - 2):
            a, b, c = strip[k : k + 3]
            faces.append((a, b, c) if k % 2 == 0 else (b, a, c))
        at += 1 + numbers[at]
    return vertices, np.array(faces, np.int32)
