"""Learns the anterior-posterior border of the hippocampus from its shape, from labels that raters drew.

    python benches/accuracy/train_border.py --data DIR --eval DIR > crates/matching/src/border/weights.rs
    python benches/accuracy/train_border.py --data DIR --eval DIR --without-pairs 34 \
        > crates/matching/src/border/weights_left_out.rs

The second leaves out both subjects of the first pairs that the generator of evaluation cases makes; accuracy is measured
with a build that uses it (feature `left-out`).

The border of each labelled volume is a plane in the frame of the surface's own principal axes, `s = p0 + p1 m + TILT h`
(`s` along the long axis towards the head, `m` and `h` along the middle and the short one, mm). `p0` and `p1` are
predicted by ridge regression from the moments of Gaussian sections; how well, for volumes left out of the training, goes
to standard error. The sections and their moments are those of `crates/matching/src/border/sections.rs`; a test there that
reads the same volumes notices if one of the two changes alone.
"""

import argparse
import glob
import os
import sys

import numpy as np
from scipy.optimize import minimize

TILT = 0.44
"""Slope of the border along the short axis: the mean over all volumes; what it varies cannot be told from the form."""
SECTIONS = np.arange(-18, 19, 1.5)
SECTION_WIDTH_MM = 1.2
LAYERS = 12
RIDGE = 100.0
FOLDS = 10
SOFTNESS_MM = 0.7


def interior_points(vertices, faces):
    """Points inside a closed surface, with the volume each stands for: layers of the tetrahedra from the mean vertex."""
    center = vertices.mean(0)
    corners = vertices[faces] - center
    volumes = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
    points, weights = [], []
    for layer in range(LAYERS):
        inner, outer = layer / LAYERS, (layer + 1) / LAYERS
        share = outer**3 - inner**3
        points.append(center + corners.mean(1) * 0.75 * (outer**4 - inner**4) / share)
        weights.append(volumes * share)
    return np.vstack(points), np.concatenate(weights)


class Frame:
    """Principal axes of the volume; signs as the scanner has them: anterior, right, superior."""

    def __init__(self, vertices, faces):
        self.points, self.weights = interior_points(vertices, faces)
        self.center = self.weights @ self.points / self.weights.sum()
        offset = self.points - self.center
        axes = np.linalg.eigh((offset * self.weights[:, None]).T @ offset)[1]
        long, middle = axes[:, 2] * np.sign(axes[1, 2]), axes[:, 1] * np.sign(axes[0, 1])
        self.axes = np.stack([long, middle, np.cross(long, middle)])

    def coordinates(self, points):
        return ((points - self.center) @ self.axes.T).T

    def profile(self):
        s, m, h = self.coordinates(self.points)
        kernel = np.exp(-((((s - TILT * h)[:, None] - SECTIONS) / SECTION_WIDTH_MM) ** 2) / 2)
        kernel *= self.weights[:, None] / (SECTION_WIDTH_MM * np.sqrt(2 * np.pi))
        area = np.maximum(kernel.sum(0), 1.0)
        mean = lambda value: (kernel * value).sum(0) / area
        m1, h1 = mean(m[:, None]), mean(h[:, None])
        dm, dh = m[:, None] - m1, h[:, None] - h1
        # The second moments of the definition are about zero, less the squared mean.
        mm, hh, mh = mean((m**2)[:, None]) - m1**2, mean((h**2)[:, None]) - h1**2, mean((h * m)[:, None]) - m1 * h1
        skew_m, skew_h = mean(dm**3) / np.maximum(mm, 1) ** 1.5, mean(dh**3) / np.maximum(hh, 1) ** 1.5
        return np.concatenate([np.log(area), m1, h1, np.log(np.maximum(mm, 0.3)), np.log(np.maximum(hh, 0.3)), mh, skew_m, skew_h])

    def border(self, vertices, anterior, areas):
        """`p0, p1` of the plane that parts the labels best."""
        s, m, h = self.coordinates(vertices)
        design, sign, weight = np.stack([np.ones_like(s), m, h], 1), np.where(anterior, 1.0, -1.0), areas / areas.sum()
        prior = np.array([0.0, -0.05, 0.45])

        def loss(plane):
            margin = sign * (s - design @ plane) / SOFTNESS_MM
            slope = -sign / (1 + np.exp(np.clip(margin, -50, 50))) / SOFTNESS_MM
            tilt = (plane - prior) * [0, 1, 1]
            return weight @ np.logaddexp(0, -margin) + 1e-4 * tilt @ tilt, -(weight * slope) @ design + 2e-4 * tilt

        return minimize(loss, [3.0, -0.05, 0.45], jac=True, method="L-BFGS-B").x[:2]


def vertex_areas(vertices, faces):
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    thirds = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 6
    return np.bincount(faces.ravel(), np.repeat(thirds, 3), len(vertices))


def ridge(profiles, planes):
    """Mean, inverse deviation and weights of the profile, and the intercept."""
    mean, inverse, center = profiles.mean(0), 1 / profiles.std(0), planes.mean(0)
    z = (profiles - mean) * inverse
    dual = np.linalg.solve(z @ z.T + RIDGE * np.eye(len(z)), planes - center)
    return mean, inverse, z.T @ dual, center


def predict(model, profiles):
    mean, inverse, weights, center = model
    return center + (profiles - mean) * inverse @ weights


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--data", required=True, help="folder with hippocampus/*.nii.gz, labels 1 anterior, 2 posterior")
    parser.add_argument("--eval", required=True, help="folder of real_cases.py, which makes the surfaces")
    parser.add_argument("--without-pairs", type=int, default=0, help="leave out the subjects of so many pairs")
    arguments = parser.parse_args()
    sys.path.insert(0, arguments.eval)
    import real_cases

    files = sorted(glob.glob(os.path.join(arguments.data, "hippocampus", "*.nii.gz")))
    n = len(files)
    # As the generator pairs them.
    left = {k for i in range(arguments.without_pairs) for k in (i % n, (i * 37 + 11) % n)}
    files = [file for k, file in enumerate(files) if k not in left]
    profiles, planes = [], []
    for file in files:
        labels = np.pad(real_cases.read(file), 4)
        vertices, faces = real_cases.surface((labels > 0).astype(float))
        frame = Frame(vertices, faces)
        profiles.append(frame.profile())
        anterior = real_cases.vertex_labels(labels, vertices) == 1
        planes.append(frame.border(vertices, anterior, vertex_areas(vertices, faces)))
    profiles, planes = np.array(profiles), np.array(planes)

    fold = np.random.default_rng(1).permutation(len(files)) % FOLDS
    left_out = np.zeros_like(planes)
    for k in range(FOLDS):
        left_out[fold == k] = predict(ridge(profiles[fold != k], planes[fold != k]), profiles[fold == k])
    explained = 1 - ((left_out - planes) ** 2).mean(0) / planes.var(0)
    model = ridge(profiles, planes)
    distance = np.sqrt((((profiles - model[0]) * model[1]) ** 2).mean(1))
    print(
        f"{len(files)} volumes; border sd {planes.std(0).round(3)}, explained when left out {explained.round(3)}; "
        f"distance from the mean: median {np.median(distance):.2f}, largest {distance.max():.2f}",
        file=sys.stderr,
    )
    write(model, len(files), n)


def write(model, n_files, n_given):
    mean, inverse, weights, center = model
    print(
        f"""//! What [`super`] has learned: written by `benches/accuracy/train_border.py`, not by hand.
//!
//! From {n_files} of the {n_given} given label volumes of hippocampi of the Medical Segmentation Decathlon (task 4; Antonelli et al., Nature
//! Communications 13, 2022; CC BY-SA 4.0). Ridge regression, penalty {RIDGE:g}.

use super::sections::N_FEATURES;

/// Slope of the border along the short axis.
pub(super) const TILT: f64 = {TILT};
/// Where the border crosses the long axis, mm from the center of the volume towards the head, and its slope along the
/// middle axis: means over the volumes.
pub(super) const MEAN_BORDER: [f64; 2] = [{center[0]:.5f}, {center[1]:.5f}];
/// For each feature of [`super::sections::Sections::profile`]: mean, inverse standard deviation, and by how much one
/// standard deviation moves the two numbers of the border.
#[rustfmt::skip]
pub(super) const FEATURES: [[f64; 4]; N_FEATURES] = ["""
    )
    for row in zip(mean, inverse, weights[:, 0], weights[:, 1]):
        print("    [{:.4f}, {:.4f}, {:.5f}, {:.6f}],".format(*row))
    print("];")


if __name__ == "__main__":
    main()
