"""Surfaces of shapes given by a function: negative inside, zero on the surface."""

import numpy as np
from skimage.measure import marching_cubes

import geometry


def surface(field, half_width, step, turn, offset):
    """Triangles where `field` is zero, by marching cubes on a grid that is rotated by `turn` and shifted by `offset`.

    The grid reaches `half_width` from the origin in each of its directions and has the spacing `step`. Vertices are on
    edges of the grid, so two grids give two independent samplings of one shape.
    """
    ticks = np.arange(-half_width, half_width + step, step)
    points = np.stack(np.meshgrid(ticks, ticks, ticks, indexing="ij"), -1).reshape(-1, 3) @ turn.T + offset
    values = field(points)
    # A corner at exactly zero would make triangles without area.
    values = np.where(np.abs(values) < 1e-6, 1e-6, values).reshape((len(ticks),) * 3)
    vertices, faces, _, _ = marching_cubes(values, 0.0)
    vertices = (ticks[0] + step * vertices.astype(float)) @ turn.T + offset
    if geometry.volume(vertices, faces) < 0:
        faces = faces[:, ::-1]
    return vertices, np.ascontiguousarray(faces, np.int32)
