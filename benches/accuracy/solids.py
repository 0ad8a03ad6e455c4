"""The sets `symmetric_*`: two independent samplings of a symmetric solid, each in an arbitrary pose.

Symmetric poses cannot be told apart: the verdict must have the reason `ambiguous_pose`.
"""

import numpy as np
from scipy.spatial.transform import Rotation

import geometry
import implicit

ROUNDING = 1.0
"""Radius of the edges of cubes and cylinders, mm: the smallest that a grid of 1 mm can sample."""


def cube(points):
    return rounded_box(np.abs(points) - (8.0 - ROUNDING))


def cylinder(points):
    across = np.linalg.norm(points[:, 1:], axis=1)
    return rounded_box(np.stack([np.abs(points[:, 0]) - (15.0 - ROUNDING), across - (6.0 - ROUNDING)], 1))


def rounded_box(beyond):
    """Signed distance, from the distances of a point beyond the faces in each direction."""
    return np.linalg.norm(np.maximum(beyond, 0), axis=1) + np.minimum(beyond.max(1), 0) - ROUNDING


def prolate(points):
    return spheroid(points, [16.0, 7.0, 7.0])


def oblate(points):
    return spheroid(points, [6.0, 12.0, 12.0])


def spheroid(points, half_axes):
    return (np.linalg.norm(points / half_axes, axis=1) - 1) * min(half_axes)


SOLIDS = {"cube": cube, "cylinder": cylinder, "prolate": prolate, "oblate": oblate}
KINDS = [f"symmetric_{name}" for name in SOLIDS]
KEPT = True


def names(cases, kind, n):
    return cases.first_of_genus_0(kind, n)


def make(cases, kind, index):
    name = kind.removeprefix("symmetric_")
    draws = np.random.default_rng([list(SOLIDS).index(name), int(index)])
    turns = [Rotation.random(random_state=draws.integers(2**31)).as_matrix() for _ in range(4)]
    new = {}
    for k in (1, 2):
        vertices, faces = implicit.surface(SOLIDS[name], 20.0, 1.0, turns[k - 1], draws.uniform(0, 1, 3))
        new[f"V{k}"], new[f"F{k}"] = vertices @ turns[k + 1].T + draws.normal(size=3) * 20, faces
    new["genus0"] = bool(all(cases.real.genus0(new[f"V{k}"], new[f"F{k}"]) for k in (1, 2)))
    return geometry.finished(new)
