"""Surfaces for measurements of studies: from label volumes, thinned in a patch, and as files."""

import nibabel as nib
import numpy as np
from scipy.ndimage import gaussian_filter, label, shift
from skimage.measure import marching_cubes


def surface(path, offset=0.0):
    """Vertices, mm, and faces of the largest piece of a label volume; with another offset of the grid, in voxels, another sampling of it."""
    image = nib.load(path)
    data = np.asarray(image.dataobj) > 0
    parts, n = label(data)
    if n > 1:
        data = parts == np.bincount(parts.ravel())[1:].argmax() + 1
    smooth = gaussian_filter(np.pad(data, 4).astype(float), 0.7)
    vertices, faces, _, _ = marching_cubes(shift(smooth, offset) if offset else smooth, 0.5)
    vertices = nib.affines.apply_affine(image.affine, vertices - 4 - offset)
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return vertices, faces if np.einsum("ij,ij->", a, np.cross(b, c)) > 0 else faces[:, ::-1]


def normals(vertices, faces):
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    each, sums = np.cross(b - a, c - a), np.zeros_like(vertices)
    for k in range(3):
        np.add.at(sums, faces[:, k], each)
    return sums / np.linalg.norm(sums, axis=1, keepdims=True)


def patch(vertices, radius_mm):
    """Weight of each vertex in a patch that is defined without any correspondence: around the highest point of the middle of the
    structure from front to back, in the scanner's axes."""
    y = vertices[:, 1]
    share = (y - y.min()) / (y.max() - y.min())
    middle = np.where(np.abs(share - 0.5) < 0.04)[0]
    top = vertices[middle[np.argmax(vertices[middle, 2])]]
    distance = np.linalg.norm(vertices - top, axis=1)
    return np.where(distance < radius_mm, 0.5 * (1 + np.cos(np.pi * np.minimum(distance, radius_mm) / radius_mm)), 0.0)


def thinned(vertices, faces, radius_mm, depth_mm):
    """The surface moved inwards by up to `depth_mm` in its patch."""
    return vertices - depth_mm * patch(vertices, radius_mm)[:, None] * normals(vertices, faces)


def deformation(rng, width_mm, deviation_mm, waves=400):
    """A random smooth displacement of space: a Gaussian process of this width, and standard deviation of each coordinate."""
    frequencies, phases = rng.normal(0, 1 / width_mm, (waves, 3)), rng.uniform(0, 2 * np.pi, (waves, 3))
    amplitudes = rng.normal(0, deviation_mm * np.sqrt(2 / waves), (waves, 3))
    return lambda points: np.stack([np.cos(points @ frequencies.T + phases[:, axis]) @ amplitudes[:, axis] for axis in range(3)], axis=1)


def write_ply(path, vertices, faces):
    with open(path, "wb") as file:
        file.write((f"ply\nformat binary_little_endian 1.0\nelement vertex {len(vertices)}\nproperty double x\nproperty double y\n"
                    f"property double z\nelement face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n").encode())
        file.write(vertices.astype("<f8").tobytes())
        rows = np.empty(len(faces), dtype=[("n", "u1"), ("v", "<i4", 3)])
        rows["n"], rows["v"] = 3, faces
        file.write(rows.tobytes())


def gifti(path):
    image = nib.load(path)
    return image.agg_data("pointset"), image.agg_data("triangle")


def maps(folder, name):
    """The arrays of a map of a study by their names."""
    image = nib.load(folder / "maps" / f"{name}.shape.gii")
    return {array.meta["Name"]: array.data for array in image.darrays}


def found_in_patch(folder, measure, radius_mm, contrast="patient-control"):
    """How much of the true patch a study finds, and how much of what it finds lies outside of it, for each kind of p."""
    vertices, _ = gifti(folder / "mean.surf.gii")
    weight = patch(vertices.astype(float), radius_mm)
    truth, outside = weight > 0.5, weight == 0
    arrays = maps(folder, f"{measure}.{contrast}")
    found = {}
    for kind, p in (("significant", "p_local"), ("tfce_fwe", "p_tfce_fwe"), ("fdr", "q_fdr"), ("uncorrected", "robust_p")):
        hit = arrays[p] < 0.05
        found[kind] = dict(sensitivity=round(float(hit[truth].mean()), 3),
                           false_discoveries=round(float((hit & outside).sum() / max(hit.sum(), 1)), 3),
                           vertices_found=int(hit.sum()), effect_in_patch_mm=round(float(arrays["effect"][truth].mean()), 3),
                           vertices_in_patch=int(truth.sum()))
    return found


def read_ply(path):
    """Vertices and triangles of a PLY file as this program and `write_ply` write it: binary, three numbers a vertex."""
    kinds = {"double": "<f8", "float": "<f4", "int": "<i4", "uint": "<u4", "uchar": "u1"}
    with open(path, "rb") as file:
        vertex, index, n = [], None, {}
        for line in iter(file.readline, b"end_header\n"):
            words = line.decode().split()
            if words[0] == "element":
                at, n[words[1]] = words[1], int(words[2])
            elif words[:2] == ["property", "list"]:
                index = (kinds[words[2]], kinds[words[3]])
            elif words[0] == "property" and at == "vertex":
                vertex.append((words[2], kinds[words[1]]))
        rows = np.fromfile(file, dtype=vertex, count=n["vertex"])
        faces = np.fromfile(file, dtype=[("n", index[0]), ("v", index[1], 3)], count=n["face"])
    return np.stack([rows[axis].astype(float) for axis in "xyz"], axis=1), faces["v"].astype(int)
