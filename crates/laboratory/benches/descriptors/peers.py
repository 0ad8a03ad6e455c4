"""FPFH of Open3D and signatures of pyfmaps, beside ours.rs: nearest neighbors within two edges of the truth.

Arguments are pairs as ours.rs takes them. Needs numpy, scipy, and open3d or pyfmaps, whichever is installed.
"""

import sys
import time

import numpy as np
from scipy.spatial import cKDTree

SUPPORT = 0.25


def surface(path):
    words = open(path).read().split()
    n, f = int(words[0]), int(words[1])
    vertices = np.array(words[2 : 2 + 3 * n], float).reshape(n, 3)
    return vertices, np.array(words[2 + 3 * n : 2 + 3 * (n + f)], int).reshape(f, 3)


def area(vertices, triangles):
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    return 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()


def open3d_fpfh(vertices, triangles, radius):
    import open3d

    mesh = open3d.geometry.TriangleMesh(
        open3d.utility.Vector3dVector(vertices), open3d.utility.Vector3iVector(triangles)
    )
    mesh.compute_vertex_normals()
    cloud = open3d.geometry.PointCloud(mesh.vertices)
    cloud.normals = mesh.vertex_normals
    search = open3d.geometry.KDTreeSearchParamRadius(radius)
    return np.asarray(open3d.pipelines.registration.compute_fpfh_feature(cloud, search).data).T


def pyfmaps_signature(kind):
    def of(vertices, triangles, radius):
        from pyFM.mesh import TriMesh
        from pyFM.signatures import mesh_HKS, mesh_WKS

        mesh = TriMesh(vertices / np.sqrt(area(vertices, triangles)), triangles)
        mesh.process(k=80, intrinsic=False)
        return mesh_HKS(mesh, 32) if kind == "HKS" else mesh_WKS(mesh, 32)

    return of


for pair in sys.argv[1:]:
    source, target = surface(f"{pair}_s.txt"), surface(f"{pair}_t.txt")
    truth = np.loadtxt(f"{pair}_g.txt")
    edges = np.concatenate([target[1][:, [0, 1]], target[1][:, [1, 2]], target[1][:, [2, 0]]])
    edges = np.unique(np.sort(edges, 1), axis=0)
    near = 2 * np.linalg.norm(target[0][edges[:, 0]] - target[0][edges[:, 1]], axis=1).mean()
    radius = SUPPORT * np.sqrt(area(*target))
    peers = {
        "Open3D fpfh": open3d_fpfh,
        "pyfmaps HKS": pyfmaps_signature("HKS"),
        "pyfmaps WKS": pyfmaps_signature("WKS"),
    }
    for name, measure in peers.items():
        begin = time.time()
        try:
            one, other = measure(*source, radius), measure(*target, radius)
        except ImportError as error:
            print(f"{pair}, {name}, absent: {error}")
            continue
        seconds = time.time() - begin
        _, nearest = cKDTree(other).query(one)
        share = (np.linalg.norm(target[0][nearest] - truth, axis=1) <= near).mean()
        print(f"{pair}, {name}, {100 * share:.1f}, {seconds:.2f}")
