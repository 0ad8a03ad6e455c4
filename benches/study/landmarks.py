"""Landmarks of a specimen inferred from those of the others: how far from where experts placed them, by maps of `homolog study`
(pairs and joint) and by closest points and SPHARM-PDM with the same template (Goparaju et al., Medical Image Analysis 2022).

Usage: landmarks.py --binary homolog --data DIR --out DIR [--kinds femur,molar,vertebra]. DIR/landmarked has KIND/*.npz (V, F, L). Each
specimen is left out once: the landmarks of the others are carried to the mean shape, averaged there, and carried to the specimen.
The template is made without landmarks. Writes OUT/landmarks.md."""
import argparse
import shutil
import sys
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).parent.parent / "accuracy"))
from geometry import closest_on_triangles
from landmarked import Specimens, quality
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


def carried(points, source, target, faces):
    """Points from their nearest places on one surface to the same places on another with the same faces."""
    weights, squared = closest_on_triangles(points[:, None], source[faces])
    best = squared.argmin(1)
    return (weights[np.arange(len(points)), best][..., None] * target[faces[best]]).sum(1)


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
        maps = [found if row["place"] == "model" else None for row, found in zip(quality(folder, specimens.names), maps)]
        found = errors(specimens, mean, faces, maps)
        relative = found / np.array([e for e, m in zip(extents, maps) if m is not None])[:, None]
        lines.append(f"| {len(specimens.names)} of {kind} | {found.shape[1]} | {name} | {len(found)} | {np.median(found):.2f} | {found.mean():.2f} | "
                     f"{np.percentile(found, 90):.2f} | {100 * relative.mean():.1f} |")
        print(lines[-1], flush=True)
(out / "landmarks.md").write_text("\n".join(lines) + "\n")
