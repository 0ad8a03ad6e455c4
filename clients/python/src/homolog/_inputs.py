"""What can be matched: files, arrays, and the images and meshes of other packages, as bytes that the service reads."""

from __future__ import annotations

import io
import os
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

Surface: TypeAlias = Any
"""A path, ``bytes``, ``(vertices, faces)``, a nibabel image, or a mesh of trimesh, pyvista or meshio."""

Floats: TypeAlias = npt.NDArray[np.float64]
Integers: TypeAlias = npt.NDArray[np.int32]


def read(surface: Surface) -> tuple[str, bytes]:
    """The file name (of which the service keeps the extension alone) and the bytes of a surface or a label volume."""
    if isinstance(surface, (str, os.PathLike)):
        path = Path(surface)
        return path.name, path.read_bytes()
    if isinstance(surface, (bytes, bytearray, memoryview)):
        return "surface", bytes(surface)
    if isinstance(surface, (tuple, list)) and len(surface) == 2:
        return "surface.ply", ply(*surface)
    if hasattr(surface, "to_bytes") and hasattr(surface, "files_types"):  # nibabel
        return "surface" + surface.files_types[0][1], _image(surface)
    if hasattr(surface, "cells_dict"):  # meshio
        blocks = [surface.cells_dict[kind] for kind in ("triangle", "quad") if kind in surface.cells_dict]
        return "surface.ply", ply(surface.points, *blocks)
    if hasattr(surface, "points") and hasattr(surface, "triangulate"):  # pyvista
        return "surface.ply", ply(surface.points, np.asarray(surface.triangulate().faces).reshape(-1, 4)[:, 1:])
    if hasattr(surface, "vertices") and hasattr(surface, "faces"):  # trimesh, and the Mesh of this package
        return "surface.ply", ply(surface.vertices, surface.faces)
    raise TypeError(f"cannot match a {type(surface).__name__}: give a path, bytes, (vertices, faces), a nibabel image, "
                    "or a mesh of trimesh, pyvista or meshio")


def _image(image: Any) -> bytes:
    # The bytes of a single file: a pair of .hdr and .img has none.
    try:
        return bytes(image.to_bytes())
    except NotImplementedError:
        import nibabel

        return bytes(nibabel.Nifti1Image.from_image(image).to_bytes())


def ply(vertices: npt.ArrayLike, *faces: npt.ArrayLike) -> bytes:
    """A binary PLY file. Vertices: n × 3, mm; faces: m × 3 or m × 4 vertex indices from 0 on."""
    points = np.ascontiguousarray(vertices, dtype="<f8")
    blocks = [np.asarray(block) for block in faces]
    if points.ndim != 2 or points.shape[1] != 3:
        raise ValueError(f"vertices must be n × 3 numbers, not {' × '.join(map(str, points.shape))}")
    for block in blocks:
        if block.ndim != 2 or block.shape[1] not in (3, 4) or not np.issubdtype(block.dtype, np.integer):
            raise ValueError("faces must be m × 3 or m × 4 whole numbers: the indices of their vertices, from 0 on")
    header = (
        f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\nproperty double x\nproperty double y\n"
        f"property double z\nelement face {sum(map(len, blocks))}\nproperty list uchar int vertex_indices\nend_header\n")
    parts = [header.encode(), points.tobytes()]
    for block in blocks:
        rows = np.empty(len(block), dtype=[("n", "u1"), ("corners", "<i4", (block.shape[1],))])
        rows["n"], rows["corners"] = block.shape[1], block
        parts.append(rows.tobytes())
    return b"".join(parts)


_TYPES = {"char": "i1", "uchar": "u1", "short": "<i2", "ushort": "<u2", "int": "<i4", "uint": "<u4", "float": "<f4",
          "double": "<f8", "int8": "i1", "uint8": "u1", "int16": "<i2", "uint16": "<u2", "int32": "<i4", "uint32": "<u4",
          "float32": "<f4", "float64": "<f8"}


def read_ply(data: bytes) -> tuple[Floats, Integers, dict[str, npt.NDArray[Any]]]:
    """Vertices, triangles (a polygon becomes a fan) and further values at each vertex of a binary PLY file of the service."""
    header, body = data.split(b"end_header\n", 1)
    elements: list[tuple[str, int, list[list[str]]]] = []
    for line in header.decode("ascii").splitlines():
        words = line.split()
        if words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), []))
        elif words[:1] == ["property"]:
            elements[-1][2].append(words[1:])
    stream = io.BytesIO(body)
    values: dict[str, npt.NDArray[Any]] = {}
    triangles: list[npt.NDArray[Any]] = []
    for name, n, properties in elements:
        if name == "vertex":
            kind = np.dtype([(words[-1], _TYPES[words[0]]) for words in properties])
            rows = np.frombuffer(stream.read(n * kind.itemsize), dtype=kind)
            values = {key: rows[key] for key in kind.names or ()}
        elif name == "face":
            count, index = (np.dtype(_TYPES[word]) for word in properties[0][1:3])
            rest, at = stream.read(), 0
            while n > 0:  # runs of polygons with equally many corners
                corners = int(np.frombuffer(rest, count, 1, at)[0])
                row = np.dtype([("n", count), ("corners", index, (corners,))])
                rows = np.frombuffer(rest, row, min(n, (len(rest) - at) // row.itemsize), at)
                others = np.flatnonzero(rows["n"] != corners)
                rows = rows[: others[0]] if len(others) else rows
                polygons = rows["corners"]
                triangles += [polygons[:, [0, k, k + 1]] for k in range(1, corners - 1)]
                at, n = at + len(rows) * row.itemsize, n - len(rows)
    vertices = np.stack([np.asarray(values.pop(axis), dtype=np.float64) for axis in "xyz"], axis=1)
    faces = np.concatenate(triangles).astype(np.int32) if triangles else np.empty((0, 3), np.int32)
    return vertices, faces, values
