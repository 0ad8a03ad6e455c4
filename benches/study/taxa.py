"""Taxa of molars told apart by distances of shapes: the nearest neighbor's genus and family, each specimen left out once, by maps of
`homolog study` (pairs and joint) and by the landmarks of experts on the same specimens (Boyer et al., PNAS 2011).

Usage: taxa.py --binary homolog --data DIR --out DIR. DIR/landmarked has molar/*.npz (V, F, L) and molar_taxa.csv. Specimens of
the other side are mirrored; which side a tooth is of follows from its landmarks. Size is no part of shape. Writes OUT/taxa.md."""
import argparse
import csv
import sys
from collections import Counter
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).parent.parent / "accuracy"))
from geometry import vertex_areas
from landmarked import Specimens, moved_onto, quality
from running import model_figures

arguments = argparse.ArgumentParser()
for name in ("--binary", "--data", "--out"):
    arguments.add_argument(name, required=True)
arguments = arguments.parse_args()
place, out = Path(arguments.data, "landmarked"), Path(arguments.out)
FEWEST = 3
"""Specimens that a taxon needs to be told apart."""


def distances(shapes, weights):
    n = len(shapes)
    found = np.full((n, n), np.inf)
    for i in range(n):
        for j in range(i):
            found[i, j] = found[j, i] = moved_onto(shapes[i], shapes[j], weights)
    return found


def right(found, taxa):
    """How many specimens of sufficiently frequent taxa have a nearest neighbor of their own taxon, and of how many."""
    counts = Counter(taxon for taxon in taxa if taxon)
    asked = [k for k, taxon in enumerate(taxa) if counts[taxon] >= FEWEST]
    return sum(taxa[int(np.argmin(found[k]))] == taxa[k] for k in asked), len(asked)


molars = Specimens(place, "molar", out)
taxon_of = {row["specimen"]: row for row in csv.DictReader(open(place / "molar_taxa.csv"))}
taxa = {kind: [taxon_of.get(name, {}).get(kind) for name in molars.names] for kind in ("genus", "family")}
marks = molars.landmarks
models = {}
shapes = {"landmarks of experts": (marks, np.full(len(marks[0]), 1 / len(marks[0])))}
for maps in ("pairs", "joint"):
    mean, faces, found = molars.study(arguments.binary, out / "study", "--without-size", "--correspondence", maps)
    areas = vertex_areas(mean, faces)
    shapes[f"maps, {maps}"] = found, areas / areas.sum()
    residuals = [float(row["residual_mm"]) for row in quality(out / "study", molars.names) if row["place"] == "model"]
    models[maps] = model_figures(out / "study") | {"residual_mm": np.mean(residuals)}
lines = [f"{len(molars.names)} second lower molars; taxa with at least {FEWEST} specimens. Right: the nearest neighbor is of the same taxon.", "",
         "| distances of | genus right | family right |", "|---|---|---|"]
for name, (points, weights) in shapes.items():
    found = distances(points, weights)
    genus, family = (right(found, taxa[kind]) for kind in ("genus", "family"))
    lines.append(f"| {name} | {genus[0]} of {genus[1]} | {family[0]} of {family[1]} |")
lines += ["", "The shape models of the maps, 10 modes, all teeth scaled to their mean size, mm of that size (residuals: of their own).",
          "Specimens whose match is not reliable are not in the model:", "",
          "| maps | in the model | compactness | generalization, mm | specificity, mm | residual, mean, mm |", "|---|---|---|---|---|---|"]
for maps, of in models.items():
    figures = (f"{of[key]['10']:.3f}" for key in ("compactness", "generalization_mm", "specificity_mm"))
    lines.append(f"| {maps} | {of['subjects']['model']} | {' | '.join(figures)} | {of['residual_mm']:.3f} |")
(out / "taxa.md").write_text("\n".join(lines) + "\n")
print("\n".join(lines))
