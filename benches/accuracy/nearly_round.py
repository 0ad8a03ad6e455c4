"""Whether the pose of a bean with an 8 % warp can be determined by an observer who knows the distribution of the warps.

A bean is a bent tube with round sections. The observer's prior is a Gaussian process with the variance of the warps and
the autocorrelation of their mean width. The data are the heights of the source over the planes of the target's
vertices, as a surface shows nothing else. Gauss-Newton steps find the most probable deformation from the true one, and
from the true pose after rotations about the long axis. If wrong poses end with energies as low as the true pose, no
energy can distinguish them.

Usage: nearly_round.py --data DATA --eval EVAL [--cases 10]; DATA and EVAL as for the accuracy table.
"""

import argparse
import os

import numpy as np
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

import cases
import geometry

KIND = "bean_warp8"
WARP = 0.08
"""Root mean square displacement of the warps, in diagonals."""
WIDTH = 0.24 * np.sqrt(2)
"""Width of the autocorrelation, in diagonals, of bumps that are 0.18 to 0.3 diagonals wide."""
NOISE = 0.16
"""Standard deviation of a height, in edges: the residual of the fits."""
N_POINTS, N_INDUCING, N_STEPS = 700, 120, 25
ANGLES = range(-180, 180, 15)


class Observer:
    def __init__(self, case):
        self.target, self.edge = case["V2"], case["edge"]
        source = case["V1"]
        diagonal = np.linalg.norm(np.ptp(source, axis=0))
        self.noise = NOISE * self.edge
        self.picked = farthest(source, N_POINTS)
        self.points, self.center = source[self.picked], source.mean(0)
        inducing = source[farthest(source, N_INDUCING)]
        kernel = lambda a, b: np.exp(-((a[:, None] - b) ** 2).sum(2) / (2 * (WIDTH * diagonal) ** 2))
        values, vectors = np.linalg.eigh(kernel(inducing, inducing))
        kept = values > 1e-5 * values.max()
        scale = WARP / np.sqrt(3) * diagonal / np.sqrt(values[kept])
        self.functions = kernel(self.points, inducing) @ vectors[:, kept] * scale
        self.normals = geometry.vertex_normals(case["V2"], case["F2"])
        self.nearest = cKDTree(self.target)

    def heights(self, moved):
        """Heights of points over the target's planes, the normals of the planes, and Cauchy's weights, as far points
        have no plane."""
        distance, at = self.nearest.query(moved)
        normals = self.normals[at]
        return ((self.target[at] - moved) * normals).sum(1), normals, 1 / (1 + (distance / (3 * self.edge)) ** 2)

    def fit(self, turn, shift, moved=None):
        """The energy of the most probable deformation near a start, and the points that it moves."""
        base = self.points @ turn.T + shift
        moved = base if moved is None else moved
        n_functions = self.functions.shape[1]
        # Rotation and translation have no prior.
        precisions = np.r_[np.ones(3 * n_functions), np.full(6, 1e-8)]
        for _ in range(N_STEPS):
            heights, normals, weights = self.heights(moved)
            arms = base - base.mean(0)
            design = np.hstack(
                [np.einsum("ik,ia->iak", normals, self.functions).reshape(len(base), -1), np.cross(arms, normals), normals]
            )
            weights = weights / self.noise**2
            wanted = ((moved - base) * normals).sum(1) + heights
            normal_equations = (design * weights[:, None]).T @ design + np.diag(precisions)
            found = np.linalg.solve(normal_equations, (design * weights[:, None]).T @ wanted)
            coefficients, rotation, translation = found[:-6].reshape(n_functions, 3), found[-6:-3], found[-3:]
            before = moved
            rotation *= min(1, 0.15 / max(np.linalg.norm(rotation), 1e-9))
            base = Rotation.from_rotvec(rotation).apply(arms) + base.mean(0) + translation
            moved = base + self.functions @ coefficients
            if np.abs(moved - before).max() < 1e-3 * self.edge:
                break
        heights, _, weights = self.heights(moved)
        return 0.5 * (weights * (heights / self.noise) ** 2).sum() + 0.5 * (coefficients**2).sum(), moved


def farthest(points, n):
    """Indices of `n` points in farthest-point order."""
    found, squared = [0], ((points - points[0]) ** 2).sum(1)
    while len(found) < n:
        found.append(int(squared.argmax()))
        squared = np.minimum(squared, ((points - points[found[-1]]) ** 2).sum(1))
    return np.array(found)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", default="data")
    parser.add_argument("--eval", default="eval")
    parser.add_argument("--work", default="target/accuracy")
    parser.add_argument("--cases", type=int, default=10)
    given = parser.parse_args()
    made = cases.Cases(given.data, given.eval, os.path.join(given.work, "cases"))
    print(f"{'':14} energy from the truth  lowest of all starts  its rotation error  wrong starts (over 10°) as low as the truth")
    rights = []
    for name in made.first(KIND, given.cases):
        case = made.load(name)
        observer = Observer(case)
        error = lambda moved: degrees(made.real.kabsch(observer.points, moved)[0] @ case["R"].T)
        truth, reached = observer.fit(case["R"], case["t"], case["gtpos"][observer.picked])
        axis = np.linalg.eigh(np.cov(case["V1"].T))[1][:, 2]
        fits = [(truth, error(reached))]
        for angle in ANGLES:
            turn = case["R"] @ Rotation.from_rotvec(np.radians(angle) * axis).as_matrix()
            shift = case["R"] @ observer.center + case["t"] - turn @ observer.center
            energy, moved = observer.fit(turn, shift)
            fits.append((energy, error(moved)))
        lowest = min(fits)
        n_wrong = sum(energy <= truth and wrong > 10 for energy, wrong in fits)
        rights.append(lowest[1] <= 10)
        print(f"{name:14} {truth:21.0f} {lowest[0]:21.0f} {lowest[1]:18.0f}° {n_wrong:6}", flush=True)
    print(f"the lowest energy has the right pose (within 10°) in {sum(rights)} of {len(rights)}")


def degrees(turn):
    return float(np.degrees(Rotation.from_matrix(turn).magnitude()))


if __name__ == "__main__":
    main()
