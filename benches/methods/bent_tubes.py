"""Medial coordinates on tubes that are bent further and further: mean error in percent of the target's diagonal.

Usage: bent_tubes.py BINARY. A flattened, tapering tube whose axis is an arc of 10 degrees is matched to the same tube with an arc of
30 to 150 degrees; vertices correspond by their numbers."""
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from methods import corresponding

from geometry import write_ply  # of benches/accuracy, which `methods` adds to the path

METHODS = ("medial", "balanced", "cpd", "spharm_pdm", "rigid")
LENGTH_MM = 36.0
AROUND, ALONG = 40, 80


def tube():
    """Vertices and triangles, straight, facing outwards."""
    polar = np.linspace(0, np.pi, ALONG + 1)[1:-1]
    azimuth = 2 * np.pi * np.arange(AROUND) / AROUND
    rings = [[18 * np.cos(u), 4 * np.sin(u) * np.cos(a), 3 * np.sin(u) * np.sin(a)] for u in polar for a in azimuth]
    vertices = np.array([[18.0, 0, 0], *rings, [-18.0, 0, 0]])
    at = lambda ring, k: 1 + ring * AROUND + k % AROUND  # noqa: E731
    faces = []
    for k in range(AROUND):
        faces.append((0, at(0, k), at(0, k + 1)))
        faces.append((len(vertices) - 1, at(ALONG - 2, k + 1), at(ALONG - 2, k)))
        for ring in range(ALONG - 2):
            faces += [(at(ring, k), at(ring + 1, k), at(ring + 1, k + 1)), (at(ring, k), at(ring + 1, k + 1), at(ring, k + 1))]
    wide = 1 + 0.02 * vertices[:, 0]
    bumped = vertices[:, 1] * wide + 0.5 * np.sin(0.2 * vertices[:, 0])
    return np.column_stack([vertices[:, 0], bumped, vertices[:, 2] * wide]), np.array(faces)


def bent(points, degrees):
    radius = LENGTH_MM / np.radians(degrees)
    at, away = points[:, 0] / radius, radius - points[:, 1]
    return np.column_stack([away * np.sin(at), radius - away * np.cos(at), points[:, 2]])


straight, faces = tube()
print("| bent by |", " | ".join(METHODS), "|")
with tempfile.TemporaryDirectory() as folder:
    source, target = Path(folder, "source.ply"), Path(folder, "target.ply")
    write_ply(source, bent(straight, 10), faces)
    for degrees in (30, 60, 90, 120, 150):
        truth = bent(straight, degrees)
        write_ply(target, truth, faces)
        errors = []
        for method in METHODS:
            out = Path(folder, f"{method}-{degrees}")
            subprocess.run([sys.argv[1], "match", source, target, "--method", method, "--out", out], check=True, capture_output=True)
            away = np.linalg.norm(corresponding(out, truth) - truth, axis=1).mean()
            errors.append(100 * away / np.linalg.norm(np.ptp(truth, 0)))
        print(f"| {degrees}° |", " | ".join(f"{error:.2f}" for error in errors), "|", flush=True)
