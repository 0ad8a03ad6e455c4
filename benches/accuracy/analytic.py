"""The sets `analytic_*`: smooth closed surfaces given by formulas, and their smoothly warped copies, without noise.

A surface is the image of the unit sphere. Each side is sampled independently with all vertices exactly on its surface,
and the true image of a source vertex is the warped vertex. Warps are flows of `warped.Flow`. Shape and warp of a pair
depend only on its index: they are the same at every number of vertices, and for both sizes of warp except for the scale
of the velocity.
"""

import functools

import numpy as np
from scipy.spatial.transform import Rotation
from scipy.special import sph_harm_y

import geometry
import resampled
from warped import Flow

KEPT = True
WARPS_PCT = [5, 10]
"""Root mean square of the displacement about its mean, percent of the source's diagonal."""
N_VERTICES = [1000, 3000, 10000]
WIDTHS = [0.15, 0.25, 0.4, 0.6]
"""Standard deviations of the kernels, as a share of the diagonal; indices take turns."""
MEAN_RADIUS = (12.0, 18.0)
"""Range of the radius of the sphere of equal area, mm."""

LEAST_VARIATION = 0.22
"""Least relative variation of the radius of a blob: the pose of a warped round blob cannot be determined."""


def star(draws):
    """A radius whose logarithm is a sum of spherical harmonics of degree 2 to 5."""
    terms = [(degree, order) for degree in range(2, 6) for order in range(-degree, degree + 1)]
    weights = draws.normal(size=len(terms)) / np.array([degree for degree, _ in terms])

    def height(directions):
        polar, angle = np.arccos(np.clip(directions[:, 2], -1, 1)), np.arctan2(directions[:, 1], directions[:, 0])
        total = np.zeros(len(directions))
        for weight, (degree, order) in zip(weights, terms):
            value = sph_harm_y(degree, abs(order), polar, angle)
            total += weight * (value.real if order >= 0 else value.imag)
        return total

    scale = draws.uniform(0.18, 0.28) / height(resampled.Sphere().grid(2000, draws)[0]).std()
    return lambda directions: np.exp(scale * height(directions))[:, None] * directions


def bent(draws):
    """An ellipsoid that tapers, is twisted about its long axis and is bent along an arc."""
    half_axes = np.array([1.0, draws.uniform(0.42, 0.55), draws.uniform(0.28, 0.38)])
    taper, twist, turn = draws.uniform(0.25, 0.45), draws.uniform(0.6, 1.4), draws.uniform(1.2, 2.2)
    radius, tilt = 2 / turn, draws.uniform(0, 2 * np.pi)

    def place(directions):
        x, y, z = (directions * half_axes).T
        across = (y + 1j * z) * np.exp(taper * x + 1j * (twist * x + tilt))
        y, z, angle = across.real, across.imag, x / radius
        return np.stack([(radius - y) * np.sin(angle), radius - (radius - y) * np.cos(angle), z], 1)

    return place


def blob(draws):
    """Level set of a sum of Gaussians; drawn again until rays from the center leave it once and it is far from
    round."""
    while True:
        centers = draws.normal(size=(7, 3))
        centers *= draws.uniform(0.3, 1.0, 7)[:, None] / np.linalg.norm(centers, axis=1, keepdims=True)
        widths, level = draws.uniform(0.25, 0.45, 7), 0.5

        def value(points):
            away = ((points[:, None] - centers) ** 2).sum(2)
            return np.exp(-away / (2 * widths**2)).sum(1)

        directions, _ = resampled.Sphere().grid(1000, draws)
        radii = np.linspace(0, 2.5, 60)[1:]
        inside = np.array([value(r * directions) > level for r in radii])
        is_star = inside[0].all() and not inside[-1].any() and not (inside[1:] & ~inside[:-1]).any()
        if is_star and inside.sum(0).std() > LEAST_VARIATION * inside.sum(0).mean():
            break

    def place(directions):
        low, high = np.zeros(len(directions)), np.full(len(directions), 2.5)
        for _ in range(44):
            middle = (low + high) / 2
            is_inside = value(middle[:, None] * directions) > level
            low, high = np.where(is_inside, middle, low), np.where(is_inside, high, middle)
        return low[:, None] * directions

    return place


SHAPES = {"star": [star], "": [bent, blob]}
"""Shapes of each part of a set's name; their indices take turns, so that eight indices have every width with every
shape."""
KINDS = [
    "_".join(filter(None, ["analytic", shape, str(warp), str(n)]))
    for shape in SHAPES
    for warp in WARPS_PCT
    for n in N_VERTICES
]
STAR = [kind for kind in KINDS if "star" in kind]
OTHER = [kind for kind in KINDS if kind not in STAR]


def names(cases, kind, n):
    return [f"{kind}/{index}" for index in range(n)]


def parts_of(kind):
    """Shapes, warp in percent and number of vertices of a set."""
    *shape, warp, n = kind.removeprefix("analytic_").split("_")
    return "".join(shape), int(warp), int(n)


def title(kind):
    shape, warp, n = parts_of(kind)
    return f"{'star' if shape else 'bent ellipsoid or blob'}, warp {warp} %, {n:,} vertices"


def width_of(index):
    return WIDTHS[index % len(WIDTHS)]


@functools.lru_cache(4)
def surface_and_warp(shape, warp, index):
    """The function from unit vectors to the surface, in mm, and the warp."""
    draws = np.random.default_rng([83, list(SHAPES).index(shape), index])
    functions = SHAPES[shape]
    form = functions[(index + index // len(WIDTHS)) % len(functions)](draws)
    vertices, faces, _ = resampled.sampled(resampled.Sphere(), form, 1000, draws)
    area = geometry.face_areas(vertices, faces).sum()
    scale = draws.uniform(*MEAN_RADIUS) / np.sqrt(area / (4 * np.pi))
    diagonal = scale * geometry.diagonal(vertices)
    flow = Flow(warp / 100 * diagonal, scale * vertices, [89, index], width_of(index) * diagonal)
    return lambda directions: scale * form(directions), flow


def make(cases, kind, index):
    index = int(index)
    shape, warp, n = parts_of(kind)
    place, flow = surface_and_warp(shape, warp, index)
    draws = np.random.default_rng([97, KINDS.index(kind), index])
    sphere, new = resampled.Sphere(), {}
    for k, function in ((1, place), (2, lambda directions: flow.forward(place(directions)))):
        while True:
            new[f"V{k}"], new[f"F{k}"], _ = resampled.sampled(sphere, function, n, draws)
            if resampled.is_closed(new[f"V{k}"], new[f"F{k}"], sphere.euler):
                break
    turns = [Rotation.random(random_state=draws.integers(2**31)).as_matrix() for _ in range(2)]
    shifts = draws.normal(size=(2, 3)) * 20
    new["gtpos"] = flow.forward(new["V1"]) @ turns[1].T + shifts[1]
    new["V1"] = new["V1"] @ turns[0].T + shifts[0]
    new["V2"] = new["V2"] @ turns[1].T + shifts[1]
    new["R"], new["t"] = cases.real.kabsch(new["V1"], new["gtpos"])
    new["genus0"] = True
    return geometry.finished(new)
