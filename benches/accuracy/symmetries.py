"""Symmetric solids of thirteen kinds (`solid_*`) and the same solids with one bump (`bumped_*`), two samplings a pair.

The dimensions of a solid, its vertex counts and the poses of its two samplings differ between pairs. Pairs of even
index are sampled by marching cubes on rotated grids, those of odd index by random points on the surface. The symmetric
poses of a `solid_*` cannot be told apart: the verdict must have the reason `ambiguous_pose`. A bump away from all axes
of rotation leaves one pose.
"""

from dataclasses import dataclass
from typing import Callable

import numpy as np
from scipy.spatial.transform import Rotation
from scipy.special import logsumexp

import geometry
import implicit
import resampled

KEPT = True
N_VERTICES = (1000, 3000)
MEAN_RADIUS = (8.0, 14.0)
"""Range of the radius of the sphere of equal area, mm."""
ROUNDING = 0.08
"""Radius of rounded edges, in mean radii."""
BUMP_HEIGHT, BUMP_WIDTH = (0.12, 0.20), (0.14, 0.22)
"""Ranges of height and standard deviation, in mean radii."""
PLACES = 40
"""Candidate places of the bump."""


@dataclass
class Solid:
    """A surface: `outside` is negative inside and close to the distance near the surface; rays of parameters start at
    `origins`."""

    outside: Callable
    domain: object
    rays: Callable
    reach: float

    def place(self, params):
        """The points where the rays of these parameters leave the solid, by bisection."""
        origins, directions = self.rays(params)
        low, high = np.zeros(len(origins)), np.full(len(origins), self.reach)
        for _ in range(44):
            middle = (low + high) / 2
            inside = self.outside(origins + middle[:, None] * directions) < 0
            low, high = np.where(inside, middle, low), np.where(inside, high, middle)
        return origins + low[:, None] * directions


def from_center(params):
    return np.zeros_like(params), params


def near_distance(field):
    """A field over the length of its gradient, which is the distance near the surface."""

    def distance(points):
        step = 1e-4
        slope = np.stack([(field(points + step * e) - field(points - step * e)) / (2 * step) for e in np.eye(3)], 1)
        return field(points) / np.maximum(np.linalg.norm(slope, axis=1), 1e-2)

    return distance


def ellipsoid(half_axes):
    return near_distance(lambda points: np.linalg.norm(points / half_axes, axis=1) - 1)


def rounded(half_sizes):
    """A rounded solid from half sizes in each direction; its argument is the position of a point in these
    directions."""

    def outside(along):
        beyond = along - (np.array(half_sizes) - ROUNDING)
        return np.linalg.norm(np.maximum(beyond, 0), axis=1) + np.minimum(beyond.max(1), 0) - ROUNDING

    return outside


def about_x(points):
    """Coordinates along the x axis and the distance from it."""
    return np.stack([points[:, 0], np.linalg.norm(points[:, 1:], axis=1)], 1)


def half_spaces(normals, offsets, coordinates=lambda points: points):
    """A convex solid whose edges are rounded by a smooth maximum."""
    return lambda points: ROUNDING / 2 * logsumexp((coordinates(points) @ normals.T - offsets) / (ROUNDING / 2), axis=1)


def prolate(draws):
    return ellipsoid([draws.uniform(1.6, 2.6), 1.0, 1.0])


def oblate(draws):
    return ellipsoid([draws.uniform(0.4, 0.65), 1.0, 1.0])


def triaxial(draws):
    return ellipsoid([draws.uniform(1.9, 2.5), draws.uniform(1.35, 1.6), 1.0])


def cube(draws):
    box = rounded([0.8, 0.8, 0.8])
    return lambda points: box(np.abs(points))


def three_edges(draws):
    box = rounded([draws.uniform(1.2, 1.6), draws.uniform(0.8, 1.0), draws.uniform(0.5, 0.65)])
    return lambda points: box(np.abs(points))


def cylinder(draws):
    # The length differs clearly from the width.
    profile = rounded([draws.choice([draws.uniform(0.3, 0.6), draws.uniform(1.4, 2.2)]), 0.8])
    return lambda points: profile(np.abs(about_x(points)))


def capsule(draws):
    half, radius = draws.uniform(0.8, 1.8), 0.7

    def outside(points):
        ends = np.clip(points[:, 0], -half, half)
        return np.linalg.norm(np.column_stack([points[:, 0] - ends, points[:, 1:]]), axis=1) - radius

    return outside


def frustum(draws):
    half, wide, narrow = draws.uniform(0.7, 1.2), 1.0, draws.uniform(0.4, 0.65)
    side = np.array([wide - narrow, 2 * half]) / np.hypot(wide - narrow, 2 * half)
    normals = np.array([[1.0, 0.0], [-1.0, 0.0], side])
    return half_spaces(normals, np.array([half, half, side[1] * (wide + narrow) / 2]), about_x)


def prism(draws):
    angles = np.arange(6) * np.pi / 3
    sides = np.stack([np.zeros(6), np.cos(angles), np.sin(angles)], 1)
    ends = np.array([[1.0, 0, 0], [-1.0, 0, 0]])
    half = draws.choice([draws.uniform(0.35, 0.6), draws.uniform(1.4, 2.0)])
    return half_spaces(np.vstack([sides, ends]), np.array([0.8] * 6 + [half] * 2))


def tetrahedron(draws):
    normals = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]) / np.sqrt(3)
    return half_spaces(normals, np.full(4, draws.uniform(0.55, 0.75)))


def egg(draws):
    half, pointed = draws.uniform(1.2, 1.6), draws.uniform(0.2, 0.35)

    def field(points):
        along, away = about_x(points).T
        return np.hypot(along / half, away * np.exp(pointed * np.clip(along / half, -2, 2))) - 1

    return near_distance(field)


def lobed(draws):
    depth, flat = draws.uniform(0.15, 0.3), draws.uniform(0.6, 0.85)

    def field(points):
        x, y, z = (points / [flat, 1.0, 1.0]).T
        length = np.maximum(np.sqrt(x**2 + y**2 + z**2), 1e-9)
        return length - 1 - depth * ((y + 1j * z) ** 3).real / length**3

    return near_distance(field)


def torus(draws):
    hole, tube = 1.0, draws.uniform(0.3, 0.5)
    return lambda points: np.hypot(np.linalg.norm(points[:, 1:], axis=1) - hole, points[:, 0]) - tube


def rays_of_torus(params):
    """Rays from the circle in the middle of the tube."""
    outward = np.stack([np.zeros(len(params)), np.cos(params[:, 0]), np.sin(params[:, 0])], 1)
    return outward, np.cos(params[:, 1:]) * outward + np.sin(params[:, 1:]) * [1.0, 0, 0]


def rotations(*vectors):
    """The group generated by these rotations, as rotation vectors in turns, without the identity."""
    generators = [Rotation.from_rotvec(2 * np.pi * np.array(v, float)).as_matrix() for v in vectors]
    group = [np.eye(3)]
    for element in group:
        for new in (element @ g for g in generators):
            if not any(np.allclose(new, old, atol=1e-6) for old in group):
                group.append(new)
    return np.array(group[1:])


def about(n):
    return [1 / n, 0, 0]


FLIP = [0, 1 / 2, 0]
DIAGONAL = np.ones(3) / (3 * np.sqrt(3))
ANY = 8
"""A rotation by any angle is represented by eighths of a turn."""
KINDS_OF_SOLID = {
    # The function and its rotations.
    "prolate": (prolate, rotations(about(ANY), FLIP)),
    "cube": (cube, rotations(about(4), DIAGONAL)),
    "cylinder": (cylinder, rotations(about(ANY), FLIP)),
    "torus": (torus, rotations(about(ANY), FLIP)),
    "box": (three_edges, rotations(about(2), FLIP)),
    "capsule": (capsule, rotations(about(ANY), FLIP)),
    "oblate": (oblate, rotations(about(ANY), FLIP)),
    "frustum": (frustum, rotations(about(ANY))),
    "ellipsoid": (triaxial, rotations(about(2), FLIP)),
    "prism": (prism, rotations(about(6), FLIP)),
    "egg": (egg, rotations(about(ANY))),
    "tetrahedron": (tetrahedron, rotations(about(2), DIAGONAL)),
    "lobed": (lobed, rotations(about(3), FLIP)),
}
GROUPS = {
    "a": ["prolate", "cube", "cylinder"],
    "b": ["torus", "box", "capsule", "oblate"],
    "c": ["frustum", "ellipsoid", "prism", "egg", "tetrahedron", "lobed"],
}
"""Verdicts may be tuned on the first group only."""
SYMMETRIC = [f"solid_{name}" for group in GROUPS.values() for name in group]
BUMPED = [kind.replace("solid_", "bumped_") for kind in SYMMETRIC]
KINDS = [*SYMMETRIC, *BUMPED]
BY_GROUP = {
    f"{groups}_{letter}": [f"{first}_{name}" for name in kinds]
    for groups, first in {"solids": "solid", "bumped": "bumped"}.items()
    for letter, kinds in GROUPS.items()
}
"""Groups of sets."""


def names(cases, kind, n):
    return [f"{kind}/{index}" for index in range(n)]


def sampling_of(index):
    return "iso-surface" if index % 2 == 0 else "random points"


def solid_of(name, draws, has_bump):
    """The solid, in mm, and its area."""
    function, group = KINDS_OF_SOLID[name]
    shape = function(draws)
    if name == "torus":
        # Not beyond the axis, so that no ray enters the tube again.
        solid = Solid(shape, resampled.Torus(2.5), rays_of_torus, 1.0)
    else:
        solid = Solid(shape, resampled.Sphere(), from_center, 4.0)
    vertices, faces, _ = resampled.sampled(solid.domain, solid.place, 2000, draws)
    area = geometry.face_areas(vertices, faces).sum()
    mean_radius = np.sqrt(area / (4 * np.pi))
    if has_bump:
        places = vertices[draws.choice(len(vertices), PLACES, replace=False)]
        moved = np.linalg.norm(np.einsum("gij,pj->gpi", group, places) - places, axis=2).min(0)
        # One of the quarter of the places that every rotation moves most.
        center = places[draws.choice(np.argsort(-moved)[: PLACES // 4])]
        height, width = (mean_radius * draws.uniform(*span) for span in (BUMP_HEIGHT, BUMP_WIDTH))
        solid.outside = lambda points: shape(points) - height * np.exp(-((points - center) ** 2).sum(1) / (2 * width**2))
    scale = draws.uniform(*MEAN_RADIUS) / mean_radius
    half_width = 1.05 * np.linalg.norm(vertices, axis=1).max() + (height if has_bump else 0)
    return solid, area, half_width, scale


def make(cases, kind, index):
    index = int(index)
    first, name = kind.split("_")
    has_bump = first == "bumped"
    draws = np.random.default_rng([71, list(KINDS_OF_SOLID).index(name), int(has_bump), index])
    solid, area, half_width, scale = solid_of(name, draws, has_bump)
    new, turns, shifts = {}, [], []
    for k in (1, 2):
        n = int(draws.integers(*N_VERTICES, endpoint=True))
        while True:
            if sampling_of(index) == "iso-surface":
                # A grid crosses a surface of any direction 1.5 times per square of its spacing.
                step = np.sqrt(1.5 * area / n)
                turn = Rotation.random(random_state=draws.integers(2**31)).as_matrix()
                shift = draws.uniform(0, step, 3)
                vertices, faces = implicit.surface(solid.outside, half_width + 2 * step, step, turn, shift)
            else:
                vertices, faces, _ = resampled.sampled(solid.domain, solid.place, n, draws)
            if resampled.is_closed(vertices, faces, solid.domain.euler):
                break
        turns.append(Rotation.random(random_state=draws.integers(2**31)).as_matrix())
        shifts.append(draws.normal(size=3) * 20)
        new[f"V{k}"], new[f"F{k}"] = scale * vertices @ turns[-1].T + shifts[-1], faces
    new["genus0"] = solid.domain.euler == 2
    if has_bump:
        new["R"] = turns[1] @ turns[0].T
        new["t"] = shifts[1] - new["R"] @ shifts[0]
        new["gtpos"] = new["V1"] @ new["R"].T + new["t"]
    return geometry.finished(new)
