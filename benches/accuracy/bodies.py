"""The sets `bodies_*`: articulated bodies, sampled twice, with known correspondence.

One surface is near the rest pose, the other far from it. `bodies_posed`: a person; `bodies_animals`: a four-legged
animal; `bodies_build`: two individuals, persons and animals in turn, of which the second has other lengths and
thicknesses of all parts; `bodies_unlike`: as `bodies_build`, with factors as between species. The solids and joints are
in `anatomy.py`.

A surface is sampled by marching cubes on its own grid around the rest pose, posed by linear blend skinning, and reduced
to about 5,000 vertices of equal spacing in its pose. Weights depend only on the position in the rest pose, so both
surfaces are images of one rest surface: a source vertex corresponds to the point of the target with the closest
position in the rest pose.
"""

import numpy as np
from scipy.sparse import coo_matrix
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation
from skimage.measure import marching_cubes

import anatomy
import geometry

KINDS = ["bodies_posed", "bodies_animals", "bodies_build", "bodies_unlike"]
KEPT = True
N_VERTICES = 5000
FACTORS = {"bodies_build": (0.75, 1.3), "bodies_unlike": (0.55, 1.8)}
"""Ranges of the factors on lengths and thicknesses of the parts of another individual."""
N_POSES_TRIED = 60
LEAST_COSINE = 0.2
"""Least cosine between the normals of the surface and of its triangles."""
MOST_HELD = 8
"""Most repetitions of putting vertices back in a round of `relaxed`: holding one can turn a face of its neighbors."""
SHARPEST_FOLD = -0.6
"""Cosine between the normals of neighboring triangles below which a surface counts as folded."""


def names(cases, kind, n):
    return cases.first_of_genus_0(kind, n)


def make(cases, kind, index):
    draws = np.random.default_rng([2600 + KINDS.index(kind), int(index)])
    is_person = kind == "bodies_posed" or (kind in FACTORS and int(index) % 2 == 0)
    body = (anatomy.person if is_person else anatomy.animal)(draws)
    poses = (anatomy.PERSON_REST, anatomy.PERSON_FAR) if is_person else (anatomy.ANIMAL_REST, anatomy.ANIMAL_FAR)
    builds = None, other_build(body, draws, FACTORS[kind]) if kind in FACTORS else None
    turns = [Rotation.random(random_state=draws.integers(2**31)).as_matrix() for _ in range(4)]
    rest = [sampled(body, turns[k], draws.uniform(0, 1, 3)) for k in (0, 1)]
    posed = [posed_surface(body, *rest[k], poses[k], draws, builds[k]) for k in (0, 1)]
    if None in posed:
        # `first_of_genus_0` continues with the next index.
        return {"genus0": False}
    (first, faces, vertices), (second, other_faces, others) = posed
    shifts = draws.normal(size=(2, 3)) * 300
    new = dict(V1=vertices @ turns[2].T + shifts[0], F1=faces, V2=others @ turns[3].T + shifts[1], F2=other_faces)
    triangles, weights = geometry.closest_points(first, second, other_faces)
    new["gtpos"] = np.einsum("ik,ikd->id", weights, new["V2"][other_faces[triangles]])
    new["la"], new["lb"] = (body.weights(points).argmax(1) for points in (first, second))
    new["R"], new["t"] = cases.real.kabsch(new["V1"], new["gtpos"])
    new["genus0"] = bool(all(cases.real.genus0(new[f"V{k}"], new[f"F{k}"]) for k in (1, 2)))
    return geometry.finished(new)


def other_build(body, draws, factors):
    """Factors along and across each bone, the same on the left and on the right."""
    of_group = {bone.group: draws.uniform(*factors, 2) for bone in body.bones}
    return [of_group[bone.group] for bone in body.bones]


def sampled(body, turn, offset):
    """The surface in the rest pose, finely sampled, with vertices on edges of a grid rotated by `turn`."""
    ends = np.vstack([np.vstack([s.a, s.b]) for s in body.solids])
    reach = max(s.radii.max() for s in body.solids)
    low, high = (ends @ turn).min(0) - reach, (ends @ turn).max(0) + reach
    step, coarse = body.spacing, 4
    n_blocks = np.ceil((high - low) / (coarse * step)).astype(int) + 1
    origin = low + (offset - 1) * step
    at = lambda index: (origin + step * index) @ turn.T
    # The value at the center of a block shows whether the block can contain the surface.
    middles = np.stack(np.meshgrid(*[np.arange(n) for n in n_blocks], indexing="ij"), -1) * coarse + (coarse - 1) / 2
    values = body.outside(at(middles.reshape(-1, 3))).reshape(n_blocks)
    for axis in range(3):
        values = values.repeat(coarse, axis)
    near = np.argwhere(np.abs(values) < 2 * np.sqrt(3) * coarse / 2 * step)
    found = body.outside(at(near))
    # A corner at exactly zero would make triangles without area.
    values[tuple(near.T)] = np.where(np.abs(found) < 1e-6, 1e-6, found)
    vertices, faces, _, _ = marching_cubes(values, 0.0)
    vertices = at(vertices.astype(float))
    if geometry.volume(vertices, faces) < 0:
        faces = faces[:, ::-1]
    return vertices, np.ascontiguousarray(faces, np.int32)


def posed_surface(body, rest, faces, ranges, draws, scales=None):
    """Positions in the rest pose, faces and posed positions, in the first drawn pose without folds or
    self-intersection.

    `None` if all poses fold: parts of some individuals are too thick for their joints.
    """
    # Most unusable poses already fold on vertices that are chosen once, in the rest pose.
    left, few = reduced(rest, faces)
    even = relaxed(body, rest[left], few)
    for tried in range(N_POSES_TRIED):
        turns = drawn_pose(body, ranges, draws, 0.98**tried)
        if is_unnatural(even, body.posed(even, turns, scales), few):
            continue
        left, new = reduced(body.posed(rest, turns, scales), faces)
        found = relaxed(body, rest[left], new)
        posed = body.posed(found, turns, scales)
        if not is_unnatural(found, posed, new):
            return found, new, posed
    return None


def reduced(vertices, faces):
    return geometry.decimation(vertices, faces, N_VERTICES, LEAST_COSINE)


def is_unnatural(rest, posed, faces):
    return is_folded(posed, faces) or meets_itself(rest, posed, faces)


def drawn_pose(body, ranges, draws, share):
    """A rotation for each bone, with angles from `share` of their ranges, more often near the ends of these.

    The angles of the right side are mirrored.
    """
    turns = []
    for bone in body.bones:
        name = bone.name.replace("right_", "left_")
        angles = share * np.array([between(*ends, draws) for ends in ranges.get(name, [(0, 0)] * 3)])
        if name != bone.name:
            angles[1:] *= -1
        turns.append(Rotation.from_euler("xyz", angles, degrees=True).as_matrix())
    return turns


def between(low, high, draws):
    return low + (high - low) * (1 - np.cos(np.pi * draws.uniform())) / 2


def relaxed(body, vertices, faces, n_rounds=6):
    """The vertices moved half of the way to the mean of their neighbors and back onto the surface, a few times.

    A vertex is held if its move would turn one of its faces away from the surface.
    """
    pairs = geometry.edges(faces)
    ends = np.vstack([pairs, pairs[:, ::-1]])
    around = coo_matrix((np.ones(len(ends)), (ends[:, 0], ends[:, 1])), (len(vertices),) * 2).tocsr()
    n_around = np.asarray(around.sum(1)).reshape(-1, 1)
    kept = units(body.normals(vertices))
    for _ in range(n_rounds):
        moved, normals = onto_surface(body, vertices + 0.5 * (around @ vertices / n_around - vertices))
        for _ in range(MOST_HELD):
            along = np.einsum("ikd,id->ik", normals[faces], geometry.unit_normals(moved, faces))
            held = np.unique(faces[(along < LEAST_COSINE).any(1)])
            moved[held], normals[held] = vertices[held], kept[held]
        vertices, kept = moved, normals
    return vertices


def onto_surface(body, vertices):
    """The vertices projected onto the surface, and unit normals there."""
    for _ in range(2):
        normals = body.normals(vertices)
        vertices = vertices - (body.outside(vertices) / (normals**2).sum(1))[:, None] * normals
    return vertices, units(normals)


def units(vectors):
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)


def is_folded(vertices, faces):
    """Whether two triangles at an edge face nearly opposite directions."""
    sides = np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    order = np.lexsort(np.sort(sides, 1).T)
    owner = np.tile(np.arange(len(faces)), 3)[order].reshape(-1, 2)
    normals = geometry.unit_normals(vertices, faces)
    return bool(((normals[owner[:, 0]] * normals[owner[:, 1]]).sum(1) < SHARPEST_FOLD).any())


def meets_itself(rest, posed, faces):
    """Whether triangles without a common corner cross, or parts that are far apart in the rest pose come within an edge
    of each other."""
    edge = geometry.mean_edge(posed, faces)
    pairs = cKDTree(posed).query_pairs(edge, output_type="ndarray")
    if (np.linalg.norm(rest[pairs[:, 0]] - rest[pairs[:, 1]], axis=1) > 10 * edge).any():
        return True
    corners = posed[faces]
    centers = corners.mean(1)
    reach = np.linalg.norm(corners - centers[:, None], axis=2).max(1)
    pairs = cKDTree(centers).query_pairs(2 * reach.max(), output_type="ndarray")
    between = np.linalg.norm(centers[pairs[:, 0]] - centers[pairs[:, 1]], axis=1)
    pairs = pairs[between < reach[pairs[:, 0]] + reach[pairs[:, 1]]]
    apart = (faces[pairs[:, 0]][:, :, None] != faces[pairs[:, 1]][:, None, :]).all((1, 2))
    pairs = pairs[apart]
    return any(crosses(corners[one], corners[other]).any() for one, other in (pairs.T, pairs.T[::-1]))


def crosses(triangles, others):
    """Whether an edge of each triangle passes through the other triangle of the pair."""
    a, b, c = (others[:, k] for k in range(3))
    normal = np.cross(b - a, c - a)
    found = np.zeros(len(triangles), bool)
    for k in range(3):
        begin, end = triangles[:, k], triangles[:, (k + 1) % 3]
        before, after = (((p - a) * normal).sum(1) for p in (begin, end))
        inside = before * after < 0
        share = before / np.where(inside, before - after, 1.0)
        point = begin + share[:, None] * (end - begin)
        for u, v in ((a, b), (b, c), (c, a)):
            inside &= (np.cross(v - u, point - u) * normal).sum(1) >= 0
        found |= inside
    return found
