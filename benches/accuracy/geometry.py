"""Triangle surfaces as (n, 3) positions in mm and (m, 3) indices: functions for the cases and the figures."""

import heapq

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree


def write_ply(path, vertices, faces):
    """Binary PLY with doubles, which stores positions without loss."""
    header = (
        "ply\nformat binary_little_endian 1.0\n"
        f"element vertex {len(vertices)}\nproperty double x\nproperty double y\nproperty double z\n"
        f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    rows = np.zeros(len(faces), dtype=[("n", "u1"), ("corners", "<i4", 3)])
    rows["n"], rows["corners"] = 3, faces
    with open(path, "wb") as out:
        out.write(header.encode())
        out.write(np.ascontiguousarray(vertices, "<f8").tobytes())
        out.write(rows.tobytes())


def edges(faces):
    """Each undirected edge once, (k, 2)."""
    pairs = np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    return np.unique(np.sort(pairs, 1), axis=0)


def mean_edge(vertices, faces):
    pairs = edges(faces)
    return float(np.linalg.norm(vertices[pairs[:, 0]] - vertices[pairs[:, 1]], axis=1).mean())


def face_areas(vertices, faces):
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)


def unit_normals(vertices, faces):
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)


def vertex_areas(vertices, faces):
    return np.bincount(faces.ravel(), np.repeat(face_areas(vertices, faces) / 3, 3), len(vertices))


def vertex_normals(vertices, faces):
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    normals = np.zeros_like(vertices)
    for k in range(3):
        np.add.at(normals, faces[:, k], np.cross(b - a, c - a))
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)


def diagonal(vertices):
    return float(np.linalg.norm(np.ptp(vertices, axis=0)))


def cut_end(vertices, faces, share, at_far_end):
    """The largest piece of the surface after removal of the `share` of its area that is farthest along the first
    principal axis."""
    areas = vertex_areas(vertices, faces)
    center = np.average(vertices, axis=0, weights=areas)
    axis = np.linalg.svd((vertices - center) * np.sqrt(areas)[:, None], full_matrices=False)[2][0]
    along = (vertices - center) @ axis * (1 if at_far_end else -1)
    order = np.argsort(along)
    kept = np.zeros(len(vertices), bool)
    kept[order[np.cumsum(areas[order]) <= (1 - share) * areas.sum()]] = True
    faces = faces[kept[faces].all(1)]
    return largest_piece(vertices, faces)


def decimated(vertices, faces, goal):
    """The surface with `goal` vertices, by repeated collapse of the shortest edge to one of its ends; the genus is
    kept."""
    left, new = decimation(vertices, faces, goal)
    return vertices[left], new


def decimation(vertices, faces, goal, least_cosine=None):
    """The vertices that `decimated` keeps, and the faces between them.

    A collapse is allowed if the two ends have exactly two neighbors in common (the link condition) and, on request, if
    the cosine between the new normal of every face and the surface's normals at its corners is at least `least_cosine`.
    """
    around = [set() for _ in vertices]
    star = [set() for _ in vertices]
    corners = [tuple(face) for face in faces.tolist()]
    for k, (a, b, c) in enumerate(corners):
        for u, v, w in ((a, b, c), (b, c, a), (c, a, b)):
            around[u].update((v, w))
            star[u].add(k)
    length = lambda u, v: float(np.linalg.norm(vertices[u] - vertices[v]))
    places = vertices.tolist()
    normals = None if least_cosine is None else vertex_normals(vertices, faces).tolist()
    queue = [(length(u, v), u, v) for u, v in edges(faces).tolist()]
    heapq.heapify(queue)
    gone, n_left = set(), len(vertices)
    while n_left > goal and queue:
        _, stays, goes = heapq.heappop(queue)
        if stays in gone or goes in gone or goes not in around[stays] or len(around[stays] & around[goes]) != 2:
            continue
        if normals is not None and turns_a_face(places, normals, corners, star[goes], stays, goes, least_cosine):
            continue
        for k in star[goes]:
            if stays in corners[k]:
                for u in corners[k]:
                    if u != goes:
                        star[u].discard(k)
                corners[k] = None
            else:
                corners[k] = tuple(stays if u == goes else u for u in corners[k])
                star[stays].add(k)
        for u in around[goes] - {stays}:
            around[u].discard(goes)
            around[u].add(stays)
            around[stays].add(u)
            heapq.heappush(queue, (length(stays, u), stays, u))
        around[stays].discard(goes)
        gone.add(goes)
        n_left -= 1
    left = np.array([i for i in range(len(vertices)) if i not in gone])
    new = np.array([c for c in corners if c is not None])
    return left, np.searchsorted(left, new).astype(np.int32)


def turns_a_face(vertices, normals, corners, star, stays, goes, least_cosine):
    """Whether the collapse of `goes` to `stays` turns a remaining face too far from the normals at its corners."""
    for k in star:
        if stays in corners[k]:
            continue
        a, b, c = (stays if u == goes else u for u in corners[k])
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = vertices[a], vertices[b], vertices[c]
        ux, uy, uz, vx, vy, vz = bx - ax, by - ay, bz - az, cx - ax, cy - ay, cz - az
        x, y, z = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
        least = least_cosine * (x * x + y * y + z * z) ** 0.5
        if any(x * nx + y * ny + z * nz <= least for nx, ny, nz in (normals[a], normals[b], normals[c])):
            return True
    return False


LENGTHS = ["V1", "V2", "t", "gtpos", "edge", "diag"]
"""Entries of a case that scale with both surfaces."""


def finished(case):
    """The case with the sizes that scores are relative to."""
    case["edge"] = mean_edge(case["V2"], case["F2"])
    case["diag"] = diagonal(case["V1"])
    case["area"] = float(face_areas(case["V1"], case["F1"]).sum())
    return case


def swapped(case):
    """The same pair with the roles exchanged; only the transform of the truth is kept."""
    turn, shift = case["R"].T, -case["R"].T @ case["t"]
    new = dict(V1=case["V2"], F1=case["F2"], V2=case["V1"], F2=case["F1"], R=turn, t=shift, genus0=case["genus0"])
    return finished(new)


def without_missing_positions(vertices, faces):
    """The surface without the vertices whose position is not a number, and without their faces."""
    there = np.isfinite(vertices).all(1)
    if there.all():
        return vertices, faces
    faces = faces[there[faces].all(1)]
    return vertices[there], (np.cumsum(there) - 1)[faces].astype(np.int32)


def closest_on_triangles(points, corners):
    """Barycentric coordinates of the closest point of each triangle, (..., 3) points and (..., 3, 3) corners."""
    a, b, c = (corners[..., k, :] for k in range(3))
    dot = lambda u, v: (u * v).sum(-1)
    ab, ac, ap = b - a, c - a, points - a
    d00, d01, d11, d20, d21 = dot(ab, ab), dot(ab, ac), dot(ac, ac), dot(ap, ab), dot(ap, ac)
    area = np.maximum(d00 * d11 - d01 * d01, 1e-300)
    v, w = (d11 * d20 - d01 * d21) / area, (d00 * d21 - d01 * d20) / area
    best = np.stack([1 - v - w, v, w], -1)
    found = np.where((best >= 0).all(-1), squared_distance(best, corners, points), np.inf)
    for i, j in ((0, 1), (1, 2), (2, 0)):
        along = corners[..., j, :] - corners[..., i, :]
        t = np.clip(dot(points - corners[..., i, :], along) / np.maximum(dot(along, along), 1e-300), 0, 1)
        weights = np.zeros_like(best)
        weights[..., i], weights[..., j] = 1 - t, t
        off = squared_distance(weights, corners, points)
        best = np.where((off < found)[..., None], weights, best)
        found = np.minimum(off, found)
    return best, found


def squared_distance(weights, corners, points):
    """Squared distances between points and the points of triangles at the given weights."""
    return (((weights[..., None] * corners).sum(-2) - points) ** 2).sum(-1)


def closest_points(points, vertices, faces, n_tried=32):
    """For each point the closest triangle, among those with the nearest centers, and the barycentric coordinates in
    it."""
    corners = vertices[faces]
    tried = cKDTree(corners.mean(1)).query(points, n_tried)[1]
    weights, off = closest_on_triangles(points[:, None], corners[tried])
    best = off.argmin(1)
    row = np.arange(len(points))
    return tried[row, best], weights[row, best]


def volume(vertices, faces):
    """Enclosed volume, positive if the faces are counterclockwise seen from outside."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def welded(vertices, faces):
    """Merges vertices of equal position; faces that lose a corner are removed."""
    vertices, index = np.unique(vertices, axis=0, return_inverse=True)
    faces = index.reshape(-1)[faces].astype(np.int32)
    distinct = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])
    return vertices, faces[distinct]


def largest_piece(vertices, faces):
    """The connected piece with most faces, without unused vertices."""
    faces = largest_piece_faces(faces)
    left = np.unique(faces)
    return vertices[left], np.searchsorted(left, faces).astype(np.int32)


def largest_piece_faces(faces):
    """The faces of the connected piece with most faces."""
    pairs = edges(faces)
    graph = coo_matrix((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), (faces.max() + 1,) * 2)
    piece = connected_components(graph, directed=False)[1]
    return faces[piece[faces[:, 0]] == np.bincount(piece[faces[:, 0]]).argmax()]
