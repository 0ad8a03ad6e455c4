"""Taxa of molars told apart by distances of shapes: the nearest neighbor's genus and family, each specimen left out once, by maps of
`homolog study` (pairs and joint) and by the landmarks of experts on the same specimens (Boyer et al., PNAS 2011).

Usage: taxa.py --binary homolog --data DIR --out DIR. DIR/landmarked has molar/*.npz (V, F, L) and molar_taxa.csv. Specimens of
the other side are mirrored; which side a tooth is of follows from its landmarks. Size is no part of shape. Writes OUT/taxa.md."""
import argparse
import csv
from collections import Counter
from pathlib import Path

import numpy as np

from running import run, table
from surfaces import gifti, write_ply

arguments = argparse.ArgumentParser()
for name in ("--binary", "--data", "--out"):
    arguments.add_argument(name, required=True)
arguments = arguments.parse_args()
place, out = Path(arguments.data, "landmarked"), Path(arguments.out)
(out / "molars").mkdir(parents=True, exist_ok=True)
FEWEST = 3
"""Specimens that a taxon needs to be told apart."""


def moved_onto(source, target, weights, reflected=False):
    """The source without its size, rotated onto the target without its size; the remaining distance."""
    def plain(points):
        points = points - weights @ points
        return points / np.sqrt(weights @ (points**2).sum(1))
    source, target = plain(source), plain(target)
    u, singular, v = np.linalg.svd((source * weights[:, None]).T @ target)
    signs = np.ones(3)
    signs[2] = np.sign(np.linalg.det(u @ v)) * (-1 if reflected else 1)
    return 2 - 2 * float(singular @ signs)


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


specimens = {row["specimen"]: row for row in csv.DictReader(open(place / "molar_taxa.csv"))}
landmarks, rows = {}, []
for name in sorted(specimens):
    path = place / "molar" / f"{name}.npz"
    if not path.exists():
        continue
    data = np.load(path)
    vertices, faces, marks = (data[key] for key in "VFL")
    equal = np.full(len(marks), 1 / len(marks))
    first = next(iter(landmarks.values()), marks)
    # Of the two, the side whose landmarks fit those of the first specimen.
    same, other = (moved_onto(marks, first, equal, reflected) for reflected in (False, True))
    landmarks[name] = marks * [1, 1, 1] if same <= other else marks * [-1, 1, 1]
    write_ply(out / "molars" / f"{name}.ply", vertices.astype(float), faces)
    rows.append({"id": name, "file": (out / "molars" / f"{name}.ply").resolve(), "side": "left" if same <= other else "right"})
names = [row["id"] for row in rows]
taxa = {kind: [specimens[name][kind] for name in names] for kind in ("genus", "family")}
shapes = {"landmarks of experts": ([landmarks[name] for name in names], np.full(len(first), 1 / len(first)))}
for maps in ("pairs", "joint"):
    folder = out / "study"
    run([arguments.binary, "study", table(out / "molars.csv", rows), "--out", folder, "--without-size", "--correspondence", maps])
    _, faces = gifti(folder / "template/template.surf.gii")
    mean, _ = gifti(folder / "mean.surf.gii")
    a, b, c = (mean[faces[:, k]] for k in range(3))
    areas = np.zeros(len(mean))
    for k in range(3):
        np.add.at(areas, faces[:, k], np.linalg.norm(np.cross(b - a, c - a), axis=1))
    sides = [np.array([1 if row["side"] == "left" else -1, 1, 1]) for row in rows]
    # Surfaces are in the coordinates of their files: those of the other side are mirrored again.
    own = [gifti(folder / f"subjects/{name}.surf.gii")[0].astype(float) * side for name, side in zip(names, sides)]
    shapes[f"maps, {maps}"] = own, areas / areas.sum()
lines = [f"{len(names)} second lower molars; taxa with at least {FEWEST} specimens. Right: the nearest neighbor is of the same taxon.", "",
         "| distances of | genus right | family right |", "|---|---|---|"]
for name, (points, weights) in shapes.items():
    found = distances(points, weights)
    genus, family = (right(found, taxa[kind]) for kind in ("genus", "family"))
    lines.append(f"| {name} | {genus[0]} of {genus[1]} | {family[0]} of {family[1]} |")
(out / "taxa.md").write_text("\n".join(lines) + "\n")
print("\n".join(lines))
