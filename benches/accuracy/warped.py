"""Warps with narrow kernels (`narrow4`) and warps of one size whose kernel width varies (`width_*`)."""

import numpy as np
from scipy.ndimage import gaussian_filter, map_coordinates
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

import geometry

WIDTHS = [0.05, 0.08, 0.12, 0.2, 0.3, 0.45, 0.6]
"""Standard deviation of the Gaussian kernels, as a share of the diagonal of the source."""
WIDTH_KINDS = [f"width_{width:g}" for width in WIDTHS]
KINDS = ["narrow4", *WIDTH_KINDS]
KEPT = True
RMS_SHARE = 0.04
N_BUMPS = 60
NARROW = (0.06, 0.09)
LEAST_VOLUME_RATIO = 0.1
"""Least ratio of volumes: a warp of `narrow4` that compresses volume by more than a factor of ten somewhere is left
out."""
N_STEPS = 16


def names(cases, kind, n):
    if kind != "narrow4":
        return cases.first_of_genus_0(kind, n)
    # The generator makes any size of warp from the name, but does not check that larger warps are invertible.
    return cases.first_of_genus_0(kind, n, lambda index: is_invertible(cases, index))


def make(cases, kind, index):
    if kind == "narrow4":
        return cases.real.load_case("real_narrow4", int(index), cases.labels, cases.cache)
    return flow_case(cases, float(kind.removeprefix("width_")), int(index))


def is_invertible(cases, index):
    """Whether the generator's narrow warp of 4 % has no fold on the structure, so that its fixed point is its
    inverse."""
    mask = structure(cases, index)
    vertices, _ = cases.real.surface(mask)
    warp = cases.real.Warp(RMS_SHARE, vertices, index, N_BUMPS, NARROW)
    points = np.vstack([vertices, np.argwhere(mask > 0).astype(float)])
    off = np.abs(warp.inv(warp.fwd(points)) - points).max()
    return off < 1e-3 and volume_ratios(warp, points).min() > LEAST_VOLUME_RATIO


def volume_ratios(warp, points):
    """Determinant of the derivative of a warp of the generator at each point."""
    away = points[:, None] - warp.c
    weight = warp.k * np.exp(-(away**2).sum(2) / (2 * warp.s**2)) / warp.s**2
    return np.linalg.det(np.eye(3) - np.einsum("pb,bi,pbj->pij", weight, warp.a, away))


def structure(cases, index):
    return np.pad(cases.real.read(cases.files[index % len(cases.files)]) > 0, 4).astype(float)


class Flow:
    """The flow of a stationary velocity field, a sum of Gaussian bumps, for unit time.

    Unlike a single large displacement, a flow never folds, even with narrow kernels; its inverse is the reverse flow.
    The velocity is scaled so that the displacement of `points` about its mean has the given RMS.
    """

    def __init__(self, rms, points, seed, width):
        draws = np.random.default_rng(seed)
        # The same centers and directions for every width.
        self.centers = points[draws.integers(len(points), size=N_BUMPS)]
        self.speeds = draws.normal(size=(N_BUMPS, 3))
        self.width, self.drift, self.scale = width, np.zeros(3), 1.0
        self.drift = self.velocity(points).mean(0)
        velocity = self.velocity(points)
        self.scale = rms / np.sqrt((velocity**2).sum(1).mean())
        for _ in range(8):
            moved = self.forward(points) - points
            self.scale *= rms / np.sqrt(((moved - moved.mean(0)) ** 2).sum(1).mean())

    def velocity(self, points):
        squared = (points**2).sum(1)[:, None] + (self.centers**2).sum(1) - 2 * points @ self.centers.T
        return self.scale * (np.exp(-squared / (2 * self.width**2)) @ self.speeds - self.drift)

    def forward(self, points):
        return self._integrate(points, 1 / N_STEPS)

    def back(self, points):
        return self._integrate(points, -1 / N_STEPS)

    def _integrate(self, points, step):
        """Runge-Kutta integration of fourth order."""
        for _ in range(N_STEPS):
            a = self.velocity(points)
            b = self.velocity(points + step / 2 * a)
            c = self.velocity(points + step / 2 * b)
            d = self.velocity(points + step * c)
            points = points + step / 6 * (a + 2 * b + 2 * c + d)
        return points


def flow_case(cases, width, index):
    """A hippocampus and its warped copy in an arbitrary pose, re-sampled by 1 mm voxels, as the generator does it."""
    real, mask = cases.real, structure(cases, index)
    vertices, faces = real.surface(mask)
    diagonal = geometry.diagonal(vertices)
    flow = Flow(RMS_SHARE * diagonal, vertices.astype(float), 6000 + index, width * diagonal)
    moved = flow.forward(vertices.astype(float))
    turn = Rotation.random(random_state=9500 + index).as_matrix()
    shift = np.random.default_rng(6500 + index).normal(size=3) * 20
    center = moved.mean(0)
    ticks = np.arange(np.ceil(np.linalg.norm(moved - center, axis=1).max()) + 5)
    ticks = np.concatenate([-ticks[:0:-1], ticks])
    grid = np.stack(np.meshgrid(ticks, ticks, ticks, indexing="ij"), -1).reshape(-1, 3)
    pulled = grid @ turn + center
    # Only points near the structure can be inside it.
    known = cKDTree(np.vstack([moved, flow.forward(np.argwhere(mask > 0).astype(float))]))
    near = np.flatnonzero(known.query(pulled, distance_upper_bound=5.0)[0] < 5.0)
    blurred = gaussian_filter(mask, 0.5)
    inside = np.zeros(len(grid))
    inside[near] = map_coordinates(blurred, flow.back(pulled[near]).T, order=1) > 0.5
    pieces, n = real.components(inside.reshape((len(ticks),) * 3))
    if n > 1:
        pieces = pieces == np.bincount(pieces.ravel())[1:].argmax() + 1
    others, other_faces = real.surface((pieces > 0).astype(float))
    new = dict(V1=vertices, F1=faces.astype(np.int32), V2=others + ticks[0] + shift, F2=other_faces.astype(np.int32))
    new["gtpos"] = (moved - center) @ turn.T + shift
    new["R"], new["t"] = real.kabsch(vertices, new["gtpos"])
    new["genus0"] = bool(real.genus0(vertices, faces) and real.genus0(others, other_faces))
    return geometry.finished(new)
