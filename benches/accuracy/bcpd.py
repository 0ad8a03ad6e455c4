"""Bayesian coherent point drift, in NumPy, with a kernel of low rank.

O. Hirose, "A Bayesian formulation of coherent point drift", IEEE PAMI 43(7), 2021: algorithm 1 and the normalization of
its section on implementation. Mixing weights are kept equal (the limit of a large kappa), as its author's program does.
"""

import numpy as np


def low_rank_kernel(points, width, rank):
    """Leading eigenpairs of the Gaussian kernel over `points`, by Nystroem's method from twice `rank` of them."""
    chosen = np.random.default_rng(0).permutation(len(points))[: 2 * rank]
    squared = (points**2).sum(1)
    distance = squared[:, None] + squared[chosen] - 2 * points @ points[chosen].T
    near = np.exp(-np.maximum(distance, 0) / (2 * width**2))
    values, vectors = np.linalg.eigh(near[chosen])
    kept = np.argsort(values)[::-1][:rank]
    kept = kept[values[kept] > 1e-9 * values.max()]
    # Factor L with L L' close to the kernel; its singular vectors are orthonormal, as the update needs them.
    vectors, roots, _ = np.linalg.svd(near @ (vectors[:, kept] / np.sqrt(values[kept])), full_matrices=False)
    kept = roots**2 > 1e-9 * roots[0] ** 2
    return roots[kept] ** 2, vectors[:, kept]


def register(target, source, width=2.0, stiffness=50.0, outlier_share=0.1, rank=150, n_iterations=60, tolerance=1e-3):
    """Positions of the source's points on the target.

    `width` (beta) is in units of the point sets' RMS extent, `stiffness` is lambda, `outlier_share` omega.
    """
    center, extent = target.mean(0), np.sqrt(target.var(0).mean())
    own_center, own_extent = source.mean(0), np.sqrt(source.var(0).mean())
    x, y = (target - center) / extent, (source - own_center) / own_extent
    (n, dim), m = x.shape, len(y)
    eigenvalues, basis = low_rank_kernel(y, width, rank)
    volume = np.prod(np.ptp(x, axis=0)) * 1.1**dim
    # The first guess keeps the pose that the two sets came in.
    scale, turn, shift = own_extent / extent, np.eye(dim), (own_center - center) / extent
    moved, deviation = scale * y + shift, np.ones(m)
    variance = ((x[:, None] - moved) ** 2).sum(2).mean() / dim
    for _ in range(n_iterations):
        # Single precision and one buffer: half of the time goes here.
        left = np.hstack([moved, (moved**2).sum(1)[:, None], np.ones((m, 1))]) / variance
        right = np.hstack([x, np.full((n, 1), -0.5), -0.5 * (x**2).sum(1)[:, None]])
        share = left.astype(np.float32) @ right.astype(np.float32).T
        np.exp(share, out=share)
        own_weight = np.exp(-(scale**2) * dim * deviation / (2 * variance))
        share *= own_weight.astype(np.float32)[:, None]
        known = (1 - outlier_share) / m * (2 * np.pi * variance) ** (-dim / 2)
        share /= share.sum(0) + np.float32(outlier_share / volume / known)
        mass, heard = share.sum(1), share.sum(0)
        total = mass.sum()
        mean = (share @ x) / np.maximum(mass, 1e-12)[:, None]
        # Posterior of the displacements in the kernel's eigenvectors: (lambda / e + Q' W Q), W = s^2 mass / variance.
        precision = scale**2 / variance * mass
        inner = np.linalg.inv(np.diag(stiffness / eigenvalues) + basis.T @ (precision[:, None] * basis))
        back = (mean - shift) @ turn / scale - y
        displacement = basis @ (inner @ (basis.T @ (precision[:, None] * back)))
        deviation = np.einsum("ik,kl,il->i", basis, inner, basis)
        shape = y + displacement
        middle, own_middle = mass @ mean / total, mass @ shape / total
        spread = (mass @ deviation) / total
        cross = (mean - middle).T @ (mass[:, None] * (shape - own_middle)) / total
        own = (shape - own_middle).T @ (mass[:, None] * (shape - own_middle)) / total + spread * np.eye(dim)
        left, _, right = np.linalg.svd(cross)
        turn = left @ np.diag([1] * (dim - 1) + [np.linalg.det(left @ right)]) @ right
        scale = np.trace(turn.T @ cross) / np.trace(own)
        shift = middle - scale * turn @ own_middle
        moved = scale * shape @ turn.T + shift
        before = variance
        residual = heard @ (x**2).sum(1) - 2 * (mass[:, None] * mean * moved).sum() + mass @ (moved**2).sum(1)
        variance = max(residual / (total * dim) + scale**2 * spread, 1e-8)
        if abs(before - variance) < tolerance * before:
            break
    return moved * extent + center
