"""Landmarks of a specimen inferred from those of the others: how far from where experts placed them, by maps of `homolog study`
(pairs and joint) and by closest points and SPHARM-PDM with the same template (Goparaju et al., Medical Image Analysis 2022).

Usage: landmarks.py --binary homolog --data DIR --out DIR [--kinds femur,molar,vertebra]. DIR/landmarked has KIND/*.npz (V, F, L). Each
specimen is left out once: the landmarks of the others are carried to the mean shape, averaged there, and carried to the specimen.
The template is made without landmarks. Writes OUT/landmarks.md."""
import argparse
import shutil
from pathlib import Path

import numpy as np

from landmarked import Specimens
from running import document

arguments = argparse.ArgumentParser()
for name in ("--binary", "--data", "--out"):
    arguments.add_argument(name, required=True)
arguments.add_argument("--kinds", default="femur,molar,vertebra")
arguments = arguments.parse_args()
place, out = Path(arguments.data, "landmarked"), Path(arguments.out)
METHODS = {
    "pairs": [],
    "joint": ["--correspondence", "joint"],
    "closest points (ICP)": ["--method", "icp"],
    "SPHARM-PDM": ["--method", "spharm_pdm"],
}


def nearest(point, vertices, faces):
    """The face with the nearest point of a surface, and that point's barycentric coordinates."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    ab, ac, ap = b - a, c - a, point - a
    dot = lambda u, v: np.einsum("ij,ij->i", u, v)
    d00, d01, d11, d20, d21 = dot(ab, ab), dot(ab, ac), dot(ac, ac), dot(ap, ab), dot(ap, ac)
    area = np.maximum(d00 * d11 - d01 * d01, 1e-300)
    v, w = (d11 * d20 - d01 * d21) / area, (d00 * d21 - d01 * d20) / area
    inside = np.stack([1 - v - w, v, w], axis=1)
    candidates = [np.where((inside >= 0).all(1)[:, None], inside, np.nan)]
    for i, j in ((0, 1), (0, 2), (1, 2)):
        corners = (a, b, c)
        along = corners[j] - corners[i]
        share = np.clip(dot(point - corners[i], along) / np.maximum(dot(along, along), 1e-300), 0, 1)
        edge = np.zeros_like(inside)
        edge[:, i], edge[:, j] = 1 - share, share
        candidates.append(edge)
    best = None
    for weights in candidates:
        at = weights[:, :1] * a + weights[:, 1:2] * b + weights[:, 2:] * c
        distance = np.linalg.norm(at - point, axis=1)
        if np.isnan(distance).all():
            continue
        face = int(np.nanargmin(distance))
        if best is None or distance[face] < best[0]:
            best = distance[face], face, weights[face]
    return best[1], best[2]


def carried(points, source, target, faces):
    """Points from their nearest places on one surface to the same places on another with the same faces."""
    places = (nearest(point, source, faces) for point in points)
    return np.array([weights @ target[faces[face]] for face, weights in places])


def errors(specimens, mean, faces, maps):
    """Distances of inferred landmarks from those of the experts, a row for each specimen with a map."""
    here = [k for k, found in enumerate(maps) if found is not None]
    on_mean = {k: carried(specimens.landmarks[k], maps[k], mean, faces) for k in here}
    found = []
    for k in here:
        others = np.mean([on_mean[j] for j in here if j != k], axis=0)
        found.append(np.linalg.norm(carried(others, mean, maps[k], faces) - specimens.landmarks[k], axis=1))
    return np.array(found)


lines = ["Landmarks of each specimen from those of all others: distance from where experts placed them, mm, and in percent of the largest extent of the",
         "specimen's landmarks. In the model: specimens whose match is not unreliable; only these are counted.", "",
         "| specimens | landmarks | maps | in the model | median, mm | mean, mm | 90th percentile, mm | mean, % of extent |", "|---|---|---|---|---|---|---|---|"]
for kind in arguments.kinds.split(","):
    specimens = Specimens(place, kind, out / kind)
    extents = [np.ptp(marks, axis=0).max() for marks in specimens.landmarks]
    first = out / kind / "pairs"
    for name, options in METHODS.items():
        folder = out / kind / name.split()[0].lower()
        if name == "joint":
            for part in ("matches", "template"):
                shutil.copytree(first / part, folder / part, dirs_exist_ok=True)
        elif name != "pairs":
            options = [*options, "--template", first / "template/template.ply"]
            if side := document(first)["settings"].get("template_side"):
                options += ["--template-side", side]
        try:
            mean, faces, maps = specimens.study(arguments.binary, folder, *options)
        except SystemExit as failure:
            lines.append(f"| {len(specimens.names)} of {kind} | | {name} | none: {str(failure).strip().splitlines()[-1][:120]} | | | | |")
            continue
        places = specimens.places(folder)
        maps = [found if places[name] == "model" else None for name, found in zip(specimens.names, maps)]
        found = errors(specimens, mean, faces, maps)
        relative = found / np.array([e for e, m in zip(extents, maps) if m is not None])[:, None]
        lines.append(f"| {len(specimens.names)} of {kind} | {found.shape[1]} | {name} | {len(found)} | {np.median(found):.2f} | {found.mean():.2f} | "
                     f"{np.percentile(found, 90):.2f} | {100 * relative.mean():.1f} |")
        print(lines[-1], flush=True)
(out / "landmarks.md").write_text("\n".join(lines) + "\n")
