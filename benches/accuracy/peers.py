"""The peers: each takes a case and answers a transform, a vertex map, or both. One core, imports not counted.

What a peer leaves to its user is set here, once for all cases: radii and thresholds in mean edge lengths, as their own
examples recommend. Settings of the dense ones were chosen among a few on real pairs, as README.md says.
"""

from types import SimpleNamespace

import numpy as np
from scipy.spatial import cKDTree

import geometry

RIGID_STEPS = 100
TRIM = 0.9
MOST_POINTS = 5000
"""The multi-start ICP and BCPD work on a sample of so many vertices where a surface has more."""
N_CARRIERS = 4


def with_matrix(turn, shift):
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = turn, shift
    return matrix


def rigid_fit(points, images):
    """Absolute orientation by SVD."""
    center, other = points.mean(0), images.mean(0)
    left, _, right = np.linalg.svd((points - center).T @ (images - other))
    flip = np.diag([1, 1, np.sign(np.linalg.det(right.T @ left.T))])
    turn = right.T @ flip @ left.T
    return turn, other - turn @ center


def icp(points, tree, turn, shift, steps):
    """Trimmed, point to point; the transform and its mean distance."""
    for _ in range(steps):
        distance, j = tree.query(points @ turn.T + shift)
        near = distance <= np.quantile(distance, TRIM)
        new_turn, new_shift = rigid_fit(points[near], tree.data[j[near]])
        still = np.abs(new_turn - turn).max() < 1e-7 and np.abs(new_shift - shift).max() < 1e-6
        turn, shift = new_turn, new_shift
        if still:
            break
    return turn, shift, tree.query(points @ turn.T + shift)[0].mean()


def principal_axes(vertices, faces):
    areas = geometry.vertex_areas(vertices, faces)
    center = np.average(vertices, axis=0, weights=areas)
    axes = np.linalg.eigh(np.cov((vertices - center).T, aweights=areas))[1]
    axes[:, 0] *= np.sign(np.linalg.det(axes))
    return center, axes


def sample(vertices):
    """Indices of at most `MOST_POINTS` vertices, in order."""
    n = len(vertices)
    if n <= MOST_POINTS:
        return np.arange(n)
    return np.sort(np.random.default_rng(0).choice(n, MOST_POINTS, replace=False))


def multi_start(case):
    """ICP from the principal axes with their four flips; the closest wins."""
    (center, axes), (other, others) = principal_axes(case.V1, case.F1), principal_axes(case.V2, case.F2)
    points, tree = case.V1[sample(case.V1)], cKDTree(case.V2[sample(case.V2)])
    best = None
    for signs in ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)):
        turn = others @ np.diag(signs) @ axes.T
        found = icp(points, tree, turn, other - turn @ center, RIGID_STEPS)
        if best is None or found[2] < best[2]:
            best = found
    return best[0], best[1]


def carried(points, moved, others):
    """Where `others` go when `points` go to `moved`: displacements weighted by the inverse distance."""
    if len(points) == len(others):
        return moved
    distance, near = cKDTree(points).query(others, k=N_CARRIERS)
    weight = 1 / np.maximum(distance, 1e-9)
    weight /= weight.sum(1, keepdims=True)
    return others + np.einsum("ik,ikd->id", weight, (moved - points)[near])


def rigid_answer(case, turn, shift, refine=True):
    tree = cKDTree(case.V2)
    if refine:
        turn, shift, _ = icp(case.V1, tree, turn, shift, RIGID_STEPS)
    return {"matrix": with_matrix(turn, shift), "map": tree.query(case.V1 @ turn.T + shift)[1]}


def dense_answer(case, turn, shift, moved):
    return {"matrix": with_matrix(turn, shift), "map": cKDTree(case.V2).query(moved)[1], "points": moved}


def run_icp(case):
    turn, shift = multi_start(case)
    return rigid_answer(case, turn, shift, refine=False)


def fpfh(vertices, faces, edge):
    import open3d

    cloud = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(vertices))
    cloud.normals = open3d.utility.Vector3dVector(geometry.vertex_normals(vertices, faces))
    radius = open3d.geometry.KDTreeSearchParamHybrid(radius=5 * edge, max_nn=100)
    return cloud, open3d.pipelines.registration.compute_fpfh_feature(cloud, radius)


def run_fgr(case):
    from open3d.pipelines import registration

    source, target = fpfh(case.V1, case.F1, case.edge), fpfh(case.V2, case.F2, case.edge)
    option = registration.FastGlobalRegistrationOption(maximum_correspondence_distance=1.5 * case.edge)
    found = registration.registration_fgr_based_on_feature_matching(
        source[0], target[0], source[1], target[1], option
    ).transformation
    return rigid_answer(case, found[:3, :3], found[:3, 3])


def run_ransac(case):
    import open3d
    from open3d.pipelines import registration

    open3d.utility.random.seed(0)
    source, target = fpfh(case.V1, case.F1, case.edge), fpfh(case.V2, case.F2, case.edge)
    limit = 1.5 * case.edge
    found = registration.registration_ransac_based_on_feature_matching(
        source[0],
        target[0],
        source[1],
        target[1],
        True,
        limit,
        registration.TransformationEstimationPointToPoint(False),
        3,
        [
            registration.CorrespondenceCheckerBasedOnEdgeLength(0.9),
            registration.CorrespondenceCheckerBasedOnDistance(limit),
        ],
        registration.RANSACConvergenceCriteria(100000, 0.999),
    ).transformation
    return rigid_answer(case, found[:3, :3], found[:3, 3])


def run_kiss(case):
    import kiss_matcher

    matcher = kiss_matcher.KISSMatcher(kiss_matcher.KISSMatcherConfig(voxel_size=float(case.edge)))
    found = matcher.estimate(case.V1.astype(np.float32), case.V2.astype(np.float32))
    return rigid_answer(case, np.array(found.rotation, float), np.array(found.translation, float).ravel())


def run_lattice(case):
    """A lattice of 193 rotations judged by rigid CPD; a shape model without any freedom makes it rigid."""
    import rustcpd

    still = np.zeros((3 * len(case.V1), 1))
    found = rustcpd.pose_initialize(
        case.V1, case.V2, still, [1e-9], rotation_count=193, with_scale=False, parallel=False
    )
    # Its rotation acts on rows.
    return rigid_answer(case, np.array(found.rotation).T, np.array(found.translation).ravel())


def run_cpd(case):
    import rustcpd

    turn, shift = multi_start(case)
    found = rustcpd.register_deformable(
        case.V2,
        case.V1 @ turn.T + shift,
        alpha=5.0,
        beta=2.0,
        low_rank=150,
        low_rank_method="pivoted_cholesky",
        normalize=True,
        outlier_weight=0.1,
        max_iterations=100,
        parallel=False,
    )
    return dense_answer(case, turn, shift, np.array(found.points))


def run_bcpd(case):
    import bcpd

    turn, shift = multi_start(case)
    aligned = case.V1 @ turn.T + shift
    points = aligned[sample(aligned)]
    moved = bcpd.register(case.V2[sample(case.V2)], points)
    return dense_answer(case, turn, shift, carried(points, moved, aligned))


def run_functional_maps(case):
    from pyFM.functional import FunctionalMapping
    from pyFM.mesh import TriMesh

    # Its vertex map goes from the second mesh to the first.
    model = FunctionalMapping(TriMesh(case.V2, case.F2), TriMesh(case.V1, case.F1))
    model.preprocess(n_descr=100, descr_type="WKS", subsample_step=5, k_process=150)
    model.fit(K=(30, 30), w_descr=1e-1, w_lap=1e-3, w_dcomm=1, w_orient=1)
    refined = model.zoomout_refine(nit=15, step=5)
    found = np.array(model.get_p2p(FM=refined if refined is not None else None))
    turn, shift = rigid_fit(case.V1, case.V2[found])
    return {"matrix": with_matrix(turn, shift), "map": found}


PEERS = {
    "icp": SimpleNamespace(title="multi-start ICP + nearest point", run=run_icp, package=None, module=None, dense=True),
    "bcpd": SimpleNamespace(title="BCPD from multi-start ICP (our NumPy)", run=run_bcpd, package=None, module=None, dense=True),
    "cpd": SimpleNamespace(
        title="CPD (rustcpd) from multi-start ICP", run=run_cpd, package="rustcpd", module="rustcpd", dense=True
    ),
    "functional_maps": SimpleNamespace(
        title="functional maps + ZoomOut (pyFM)", run=run_functional_maps, package="pyfmaps", module="pyFM", dense=True
    ),
    "lattice": SimpleNamespace(
        title="pose lattice, rigid CPD (rustcpd), ICP",
        run=run_lattice,
        package="rustcpd",
        module="rustcpd",
        dense=False,
    ),
    "fgr": SimpleNamespace(
        title="Open3D FGR on FPFH, ICP", run=run_fgr, package="open3d", module="open3d", dense=False
    ),
    "ransac": SimpleNamespace(
        title="Open3D RANSAC on FPFH, ICP", run=run_ransac, package="open3d", module="open3d", dense=False
    ),
    "kiss": SimpleNamespace(
        title="KISS-Matcher, ICP", run=run_kiss, package="kiss_matcher", module="kiss_matcher", dense=False
    ),
    "teaser": SimpleNamespace(
        title="TEASER++", run=None, package="cmeel-teaser-plusplus", module="teaserpp_python", dense=False
    ),
    "probreg": SimpleNamespace(title="BCPD (probreg)", run=None, package="probreg", module="probreg", dense=False),
}
"""`dense` ones answer more than a rigid transform can; `run` is None where no wheel was there to write it against."""
