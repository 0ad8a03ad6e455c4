"""The pairs of surfaces, each named `set/index`.

Real pairs come from the unmodified generator in EVAL. The others are made here, from its re-sampled copies and from
synthetic beans. In all, the source is `V1, F1`, the target `V2, F2`, and `R, t` take the source onto the target.
"""

import glob
import os
import pickle
import sys

import numpy as np
from scipy.spatial.transform import Rotation

import analytic
import bodies
import capsules
import coarse
import geometry
import landmarked
import parts
import people
import scaled
import solids
import structures
import symmetries
import warped

FAMILIES = [
    *[scaled, warped, capsules, bodies, people, solids, symmetries, analytic],
    *[structures, coarse, parts, landmarked],
]
"""Modules of further sets: `KINDS`, `names(cases, kind, n)`, `make(cases, kind, index)`, and `KEPT`: whether cases are
kept on disk."""
FAMILY = {kind: family for family in FAMILIES for kind in family.KINDS}
REAL = ["real_warp4", "real_warp8", "real_cross", "real_resample"]
"""Spoiled copies: the changes to the target. Warps are part of making the surface."""
SPOILS = ["noise", "cut", "half"]
ROBUSTNESS = [f"{origin}_{spoil}" for origin in ("resample", "bean") for spoil in SPOILS] + ["bean_warp8"]
UNLIKE = ["mirrored", "ellipsoid", "anterior_part"]
NOISE_SHARE = 0.02
CUT_SHARE = 0.2


class Cases:
    """Makes cases and keeps the real ones in `cache`."""

    def __init__(self, data, evaluation, cache):
        sys.path.insert(0, evaluation)
        import real_cases

        self.real = real_cases
        self.data, self.labels, self.cache = data, os.path.join(data, "hippocampus"), cache
        self.files = sorted(glob.glob(os.path.join(self.labels, "*.nii.gz")))

    def score(self, case, transform, vertex_map):
        return self.real.score(case, transform, vertex_map)

    def load(self, name):
        kind, index = name.split("/")
        if kind in FAMILY and not FAMILY[kind].KEPT:
            return FAMILY[kind].make(self, kind, index)
        index = int(index)
        if kind.startswith("real_"):
            return self.real.load_case(kind, index, self.labels, self.cache)
        if kind.startswith("swapped_"):
            return geometry.swapped(self.load(f"{kind.removeprefix('swapped_')}/{index}"))
        path = os.path.join(self.cache, f"made_{kind}_{index}.pkl")
        if not os.path.exists(path):
            os.makedirs(self.cache, exist_ok=True)
            case = self._make(kind, index)
            with open(path + ".tmp", "wb") as file:
                pickle.dump(case, file)
            os.replace(path + ".tmp", path)
        with open(path, "rb") as file:
            return pickle.load(file)

    def first(self, kind, n):
        """Names of the first `n` cases of a set, fewer if the set is smaller."""
        return FAMILY[kind].names(self, kind, n) if kind in FAMILY else self.first_of_genus_0(kind, n)

    def first_of_genus_0(self, kind, n, is_wanted=lambda index: True):
        """Names of the first `n` wanted cases whose surfaces are of genus 0: the pairs of earlier records.

        Real volumes have tunnels, so indices are skipped, the same ones in all sets that begin with one subject.
        """
        names, index = [], 0
        while len(names) < n and index < 20 * n:
            name = f"{kind}/{index}"
            if is_wanted(index) and self.load(name)["genus0"]:
                names.append(name)
            index += 1
        return names

    def _make(self, kind, index):
        if kind in FAMILY:
            return FAMILY[kind].make(self, kind, index)
        if kind in UNLIKE:
            return self._unlike(kind, index)
        origin, how = kind.split("_")
        if origin == "bean":
            case = bean_case(self.real, index, 0.08 if how == "warp8" else 0.0)
        else:
            case = self.load(f"real_resample/{index}")
        if how in SPOILS:
            case = spoiled(case, how, index)
        return case

    def _unlike(self, kind, index):
        case = dict(self.load(f"real_resample/{index}"))
        for truth in ("gtpos", "gt", "la", "lb"):
            case.pop(truth, None)
        if kind == "mirrored":
            case["V2"], case["F2"] = case["V2"] * [-1, 1, 1], np.ascontiguousarray(case["F2"][:, ::-1])
        elif kind == "ellipsoid":
            case["V2"], case["F2"] = ellipsoid_like(case["V2"], case["F2"], self.real)
        else:
            case["V2"], case["F2"], closed = self._anterior_part(index)
            case["genus0"] = case["genus0"] and closed
        case["edge"] = geometry.mean_edge(case["V2"], case["F2"])
        return case

    def _anterior_part(self, index):
        """Label 1 of another volume than the source's, in an arbitrary pose."""
        other = self.files[(index * 37 + 11) % len(self.files)]
        mask = np.pad(self.real.read(other), 4) == 1
        pieces, n = self.real.components(mask)
        if n > 1:
            mask = pieces == np.bincount(pieces.ravel())[1:].argmax() + 1
        vertices, faces = self.real.surface(mask.astype(float))
        turned = vertices @ Rotation.random(random_state=500 + index).as_matrix().T
        return turned, np.ascontiguousarray(faces, np.int32), self.real.genus0(vertices, faces)


def spoiled(case, how, index):
    """The case with noise on its target, an end of its target cut away, or half of its target's vertices."""
    new = {key: case[key] for key in ("V1", "F1", "V2", "F2", "R", "t", "genus0")}
    if how == "noise":
        draws = np.random.default_rng(100 + index)
        new["V2"] = new["V2"] + draws.normal(0, NOISE_SHARE * case["diag"], new["V2"].shape)
    elif how == "cut":
        new["V2"], new["F2"] = geometry.cut_end(new["V2"], new["F2"], CUT_SHARE, index % 2 == 0)
    else:
        new["V2"], new["F2"] = geometry.decimated(new["V2"], new["F2"], len(new["V2"]) // 2)
    return geometry.finished(new)


def bean(seed):
    """A bent, twisted, tapering tube: a function for the distance of a point from it, mm, positive outside, and its
    spine."""
    draws = np.random.default_rng(4000 + seed)
    s = np.linspace(0, 1, 60)
    length, bend, twist = draws.uniform(30, 38), draws.uniform(5, 9), draws.uniform(1, 3)
    spine = np.stack([length * (s - 0.5), bend * (1 - (2 * s - 1) ** 2), twist * np.sin(2 * np.pi * s)], 1)
    head, tail = draws.uniform(6, 7.5), draws.uniform(3, 4)
    radius = tail + (head - tail) * np.exp(-(((s - 0.15) / 0.3) ** 2)) + 0.6 * np.sin(9 * s + draws.uniform(0, 6))

    def outside(points):
        return np.concatenate(
            [
                (np.linalg.norm(part[:, None] - spine, axis=2) - radius).min(1)
                for part in np.array_split(points, len(points) // 20000 + 1)
            ]
        )

    return outside, spine


def grid(half_width):
    ticks = np.arange(-half_width, half_width + 1.0)
    return np.stack(np.meshgrid(ticks, ticks, ticks, indexing="ij"), -1).reshape(-1, 3), len(ticks)


def bean_case(real, index, warp_share):
    """A bean and its copy in an arbitrary pose, each sampled on its own grid of 1 mm voxels; warped on request."""
    outside, spine = bean(index)
    points, side = grid(34)
    source = (outside(points) < 0).reshape((side,) * 3)
    vertices, faces = real.surface(source.astype(float))
    vertices = vertices - 34.0
    warp = real.Warp(warp_share, vertices, index) if warp_share else None
    turn = Rotation.random(random_state=700 + index).as_matrix()
    shift = np.random.default_rng(index).normal(size=3) * 20
    center = vertices.mean(0)
    pulled = points @ turn + center
    target = (outside(warp.inv(pulled) if warp else pulled) < 0).reshape((side,) * 3)
    pieces, n = real.components(target)
    if n > 1:
        target = pieces == np.bincount(pieces.ravel())[1:].argmax() + 1
    others, other_faces = real.surface(target.astype(float))
    closed = real.genus0(vertices, faces) and real.genus0(others, other_faces)
    new = dict(V1=vertices, F1=faces.astype(np.int32), V2=others - 34.0 + shift, F2=other_faces.astype(np.int32))
    new["gtpos"] = ((warp.fwd(vertices) if warp else vertices) - center) @ turn.T + shift
    new["R"], new["t"] = real.kabsch(vertices, new["gtpos"])
    new["genus0"] = bool(closed)
    return geometry.finished(new)


def ellipsoid_like(vertices, faces, real):
    """An ellipsoid with the principal axes, and the spread of area along them, of a surface."""
    areas = geometry.vertex_areas(vertices, faces)
    center = np.average(vertices, axis=0, weights=areas)
    spread, axes = np.linalg.eigh(np.cov((vertices - center).T, aweights=areas))
    # On a sphere the variance of a coordinate is a third of the squared radius.
    half_axes = np.sqrt(3 * spread)
    points, side = grid(int(np.ceil(half_axes.max())) + 5)
    field = (((points @ axes) / half_axes) ** 2).sum(1).reshape((side,) * 3) < 1
    new, new_faces = real.surface(field.astype(float))
    return new - (side - 1) / 2 + center, new_faces.astype(np.int32)
