"""Independent samplings of images of a sphere or of a torus: blue noise, all vertices exactly on the surface."""

import numpy as np
from scipy.spatial import ConvexHull, Delaunay, cKDTree
from scipy.spatial.transform import Rotation

import geometry

CANDIDATES = 12
"""Points drawn for each vertex that is kept."""
LLOYD_STEPS = 3
"""Steps of Lloyd's algorithm, few enough that triangles stay irregular."""
MOST_PASSES = 100


class Sphere:
    """Parameters are unit vectors."""

    euler = 2

    def grid(self, n, draws):
        """About `n` parameters, evenly spread with a random rotation, and the triangles between them."""
        k = np.arange(n) + 0.5
        z, angle = 1 - 2 * k / n, np.pi * (1 + 5**0.5) * k
        across = np.sqrt(1 - z**2)
        directions = np.stack([across * np.cos(angle), across * np.sin(angle), z], 1)
        params = directions @ Rotation.random(random_state=draws.integers(2**31)).as_matrix().T
        return params, self.triangles(params)

    def between(self, corners, weights):
        points = np.einsum("nk,nkd->nd", weights, corners)
        return points / np.linalg.norm(points, axis=1, keepdims=True)

    def triangles(self, params):
        faces = ConvexHull(params).simplices
        a, b, c = (params[faces[:, k]] for k in range(3))
        inward = np.einsum("ij,ij->i", a, np.cross(b, c)) < 0
        faces[inward] = faces[inward][:, ::-1]
        return faces.astype(np.int32)


class Torus:
    """Parameters are two angles, around the hole and around the tube; `ratio` is the ratio of the two radii."""

    euler = 0

    def __init__(self, ratio):
        self.ratio = ratio

    def grid(self, n, draws):
        rows = int(np.sqrt(n / self.ratio))
        shape = (int(rows * self.ratio), rows)
        ticks = [2 * np.pi * (np.arange(k) + draws.uniform()) / k for k in shape]
        params = np.stack(np.meshgrid(*ticks, indexing="ij"), -1).reshape(-1, 2) % (2 * np.pi)
        return params, self.triangles(params + draws.normal(0, 1e-4, params.shape))

    def between(self, corners, weights):
        # Moves corners on the two sides of the cut to one side.
        near = corners[:, :1] + (corners - corners[:, :1] + np.pi) % (2 * np.pi) - np.pi
        return np.einsum("nk,nkd->nd", weights, near) % (2 * np.pi)

    def triangles(self, params):
        """Of nine copies of the plane, the triangles whose center is in the central one."""
        n = len(params)
        tiles = np.array([(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1)]) * 2 * np.pi
        flat = (params % (2 * np.pi) + tiles[:, None]).reshape(-1, 2) * [self.ratio, 1]
        faces = Delaunay(flat).simplices
        center = flat[faces].mean(1) / [self.ratio, 1]
        faces = faces[((center >= 0) & (center < 2 * np.pi)).all(1)]
        (ax, ay), (bx, by) = ((flat[faces[:, k]] - flat[faces[:, 0]]).T for k in (1, 2))
        clockwise = ax * by - ay * bx < 0
        faces[clockwise] = faces[clockwise][:, ::-1]
        return (faces % n).astype(np.int32)


def sampled(domain, place, n, draws):
    """`n` vertices and the triangles of a surface, with the parameters of the vertices; `place` maps parameters of
    `domain` to the surface.

    Points are drawn with equal probability for equal areas and thinned by Lloyd's algorithm. Triangles are those of the
    parameters after edge flips to the Delaunay triangulation of the surface.
    """
    params, faces = domain.grid(max(n, 4000), draws)
    vertices = place(params)
    areas = geometry.face_areas(vertices, faces)
    faces = faces[draws.choice(len(faces), CANDIDATES * n, p=areas / areas.sum())]
    weights = draws.dirichlet([1.0, 1.0, 1.0], len(faces))
    kept = thinned(np.einsum("nk,nkd->nd", weights, vertices[faces]), n, draws)
    params = domain.between(params[faces[kept]], weights[kept])
    vertices, faces = place(params), domain.triangles(params)
    if geometry.volume(vertices, faces) < 0:
        faces = np.ascontiguousarray(faces[:, ::-1])
    return vertices, flipped(vertices, faces), params


def thinned(points, n, draws):
    """Indices of `n` points, each the nearest one to the mean of its cell."""
    kept = draws.choice(len(points), n, replace=False)
    for _ in range(LLOYD_STEPS):
        owner = cKDTree(points[kept]).query(points)[1]
        size = np.bincount(owner, minlength=n)[:, None]
        means = np.stack([np.bincount(owner, points[:, k], n) for k in range(3)], 1) / size
        order = np.lexsort([((points - means[owner]) ** 2).sum(1), owner])
        kept = order[np.searchsorted(owner[order], np.arange(n))]
    return kept


def flipped(vertices, faces):
    """The triangles after flips of edges whose opposite angles sum to more than 180 degrees."""
    faces = faces.copy()
    n = len(vertices)
    for _ in range(MOST_PASSES):
        # Half-edges a -> b of every face, with the opposite corner; sorting brings the two of an edge side by side.
        a, b, c = (np.roll(faces, -k, axis=1).ravel() for k in range(3))
        order = np.argsort(np.minimum(a, b).astype(np.int64) * n + np.maximum(a, b), kind="stable")
        one, two = order[::2], order[1::2]
        a, b, c, d = a[one], b[one], c[one], c[two]
        sums = angle(vertices, a, c, b) + angle(vertices, a, d, b)
        existing = np.minimum(a, b).astype(np.int64) * n + np.maximum(a, b)
        wanted = np.minimum(c, d).astype(np.int64) * n + np.maximum(c, d)
        bad = (sums > np.pi + 1e-9) & ~np.isin(wanted, existing) & (c != d)
        old = normals(vertices, a, b, c) + normals(vertices, b, a, d)
        for new in (normals(vertices, a, d, c), normals(vertices, d, b, c)):
            bad &= (new * old).sum(1) > 0
        bad = np.flatnonzero(bad)
        if not len(bad):
            break
        # At most one flip per face and per new edge, the worst edges first.
        bad = bad[np.argsort(-sums[bad], kind="stable")]
        bad = bad[np.sort(np.unique(wanted[bad], return_index=True)[1])]
        rank = np.arange(len(bad))
        first = np.full(len(faces), len(bad))
        f, g = one[bad] // 3, two[bad] // 3
        np.minimum.at(first, f, rank)
        np.minimum.at(first, g, rank)
        chosen = (first[f] == rank) & (first[g] == rank)
        f, g, k = f[chosen], g[chosen], bad[chosen]
        faces[f] = np.stack([a[k], d[k], c[k]], 1)
        faces[g] = np.stack([d[k], b[k], c[k]], 1)
    return faces


def angle(vertices, a, at, b):
    u, v = vertices[a] - vertices[at], vertices[b] - vertices[at]
    return np.arctan2(np.linalg.norm(np.cross(u, v), axis=1), (u * v).sum(1))


def normals(vertices, a, b, c):
    return np.cross(vertices[b] - vertices[a], vertices[c] - vertices[a])


def is_closed(vertices, faces, euler):
    """Whether every edge has two faces with opposite directions, and the Euler characteristic is `euler`."""
    half = np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    if len(np.unique(half, axis=0)) != len(half) or len(np.unique(faces)) != len(vertices):
        return False
    edges = np.unique(np.sort(half, 1), axis=0)
    return 2 * len(edges) == len(half) and len(vertices) - len(edges) + len(faces) == euler
