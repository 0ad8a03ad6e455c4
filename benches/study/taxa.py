"""Taxa of molars told apart by distances of shapes: the nearest neighbor's genus and family, each specimen left out once, by maps of
`homolog study` (pairs and joint) and by the landmarks of experts on the same specimens (Boyer et al., PNAS 2011).

Usage: taxa.py --binary homolog --data DIR --out DIR [--direct]. DIR/landmarked has molar/*.npz (V, F, L) and molar_taxa.csv. Specimens
of the other side are mirrored; which side a tooth is of follows from its landmarks. Size is no part of shape. Writes OUT/taxa.md.

Where a tooth was cut off is no part of its shape, so a band along the rim can be left out. Its width is chosen for each specimen by the
other ones: the width with which most of them are right, as if this one were not there. The result of each width is written as well.

Besides the distance over the area of the mean: over the areas of both specimens (continuous Procrustes distance; Al-Aifari,
Daubechies, Lipman 2013); in units of the standard deviation of each mode (Mahalanobis distance of a study); and, with --direct, over maps
between specimens in both directions, for the four nearest ones by the maps of each kind (254 matches)."""
import argparse
import csv
import shutil
import sys
from collections import Counter
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).parent.parent / "accuracy"))
from geometry import vertex_areas
from landmarked import Specimens, moved_onto, quality
from running import model_figures, run
from surfaces import write_ply

arguments = argparse.ArgumentParser()
for name in ("--binary", "--data", "--out"):
    arguments.add_argument(name, required=True)
arguments.add_argument("--direct", action="store_true", help="match specimens with each other too")
arguments = arguments.parse_args()
place, out = Path(arguments.data, "landmarked"), Path(arguments.out)
FEWEST = 3
"""Specimens that a taxon needs to be told apart."""
BANDS = (0, 0.05, 0.1, 0.15, 0.2)
"""Widths of the band along the rim that may be left out, in square roots of the area of the mean."""


def distances(shapes, weights):
    """Squared distances; `weights(i, j)` are those of the vertices."""
    n = len(shapes)
    found = np.full((n, n), np.inf)
    for i in range(n):
        for j in range(i):
            found[i, j] = found[j, i] = moved_onto(shapes[i], shapes[j], weights(i, j))
    return found


def shares(vertices, faces):
    areas = vertex_areas(vertices, faces)
    return areas / areas.sum()


def from_rim(vertices, faces):
    """Distances of the vertices from the nearest vertex of the rim, in square roots of the area."""
    edges = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    edges, number = np.unique(edges, axis=0, return_counts=True)
    rim = vertices[np.unique(edges[number == 1])]
    nearest = np.array([np.linalg.norm(rim - vertex, axis=1).min() for vertex in vertices])
    return nearest / np.sqrt(vertex_areas(vertices, faces).sum())


def chosen_by_others(by_width, taxa):
    """Distances with, in each row, the width with which fewest other specimens are wrong, of genera and families together; of equal
    ones the narrowest. `by_width`: squared distances, the narrowest first; `taxa`: the names of each kind."""
    found = by_width[0].copy()
    for k in range(len(found)):
        def errors(distances):
            without = distances.copy()
            without[:, k] = np.inf
            return sum(i != k for names in taxa for i, _ in wrong(without, names))
        found[k] = min(by_width, key=errors)[k]
    return found


def whitened(shapes, mean, weights):
    """Squared Mahalanobis distances. The modes explain 90 % of the variance, at most a quarter as many as shapes; all other
    directions have the mean of their variances."""
    def plain(points):
        points = points - weights @ points
        return points / np.sqrt(weights @ (points**2).sum(1))
    aligned, mean = [plain(shape) for shape in shapes], plain(mean)
    for _ in range(6):
        for k, shape in enumerate(aligned):
            u, _, v = np.linalg.svd((shape * weights[:, None]).T @ mean)
            aligned[k] = shape @ u @ np.diag([1, 1, np.linalg.det(u @ v)]) @ v
        mean = plain(np.mean(aligned, axis=0))
    n = len(aligned)
    centered = ((aligned - np.mean(aligned, axis=0)) * np.sqrt(weights)[:, None]).reshape(n, -1)
    variances, scores = np.linalg.eigh(centered @ centered.T)
    # The last one is 0: shapes are centered.
    variances, scores = np.maximum(variances[::-1], 0)[: n - 1], scores[:, ::-1][:, : n - 1]
    modes = min(int(np.searchsorted(np.cumsum(variances) / variances.sum(), 0.9)) + 1, n // 4)
    scores = scores * np.sqrt(variances / np.r_[variances[:modes], np.full(n - 1 - modes, variances[modes:].mean())])
    found = ((scores[:, None] - scores[None]) ** 2).sum(2)
    np.fill_diagonal(found, np.inf)
    return found


def asked(taxa):
    """The specimens of sufficiently frequent taxa."""
    counts = Counter(taxon for taxon in taxa if taxon)
    return [k for k, taxon in enumerate(taxa) if counts[taxon] >= FEWEST]


def wrong(found, taxa):
    """Those whose nearest neighbor is not of their own taxon, with this neighbor."""
    nearest = found.argmin(1)
    return [(k, int(nearest[k])) for k in asked(taxa) if taxa[nearest[k]] != taxa[k]]


def direct(found, families):
    """Squared distances between specimens by their own maps, of those asked to their nearest ones by each of the distances `found`."""
    place, answer = out / "direct", out / "direct/answer"
    place.mkdir(exist_ok=True)
    surfaces = []
    for row in molars.rows:
        data = np.load(Path(arguments.data, "landmarked/molar", f"{row['id']}.npz"))
        is_mirrored = row.get("side") == "right"
        vertices, faces = data["V"].astype(float) * [-1 if is_mirrored else 1, 1, 1], data["F"].astype(int)
        surfaces.append((vertices, faces[:, ::-1] if is_mirrored else faces))
        write_ply(place / f"{row['id']}.ply", *surfaces[-1])
    def mapped(i, j):
        shutil.rmtree(answer, ignore_errors=True)
        run([arguments.binary, "match", *(place / f"{molars.names[k]}.ply" for k in (i, j)), "--out", answer])
        image = np.loadtxt(answer / "warped.csv", delimiter=",", skiprows=1, usecols=(1, 2, 3))
        vertices, faces = surfaces[i]
        return moved_onto(vertices, image, (shares(vertices, faces) + shares(image, faces)) / 2)
    pairs = {(k, int(near)) for k in asked(families) for each in found for near in each[k].argsort()[:4]}
    one_way = {pair: mapped(*pair) for pair in sorted(pairs | {(j, i) for i, j in pairs})}
    both = np.full(found[0].shape, np.inf)
    for i, j in pairs:
        both[i, j] = (one_way[i, j] + one_way[j, i]) / 2
    return both


molars = Specimens(place, "molar", out)
taxon_of = {row["specimen"]: row for row in csv.DictReader(open(place / "molar_taxa.csv"))}
taxa = {kind: [taxon_of.get(name, {}).get(kind) for name in molars.names] for kind in ("genus", "family")}
marks = molars.landmarks
models = {}
by = {"landmarks of experts": distances(marks, lambda i, j: np.full(len(marks[0]), 1 / len(marks[0])))}
for maps in ("pairs", "joint"):
    mean, faces, found = molars.study(arguments.binary, out / "study", "--without-size", "--correspondence", maps)
    weights, own = shares(mean, faces), [shares(shape, faces) for shape in found]
    # The first band has no width.
    depth = from_rim(mean, faces)
    inner = [weights * (depth >= width) for width in BANDS]
    by_width = [distances(found, lambda i, j: each / each.sum()) for each in inner]
    by[f"maps, {maps}"] = by_width[0]
    by[f"maps, {maps}, without a band along the rim, its width chosen by the others"] = chosen_by_others(by_width, list(taxa.values()))
    by |= {f"maps, {maps}, without a band of {width} roots of the area": each for width, each in zip(BANDS[1:], by_width[1:])}
    by[f"maps, {maps}, over the areas of both specimens"] = distances(found, lambda i, j: (own[i] + own[j]) / 2)
    by[f"maps, {maps}, in standard deviations"] = whitened(found, mean, weights)
    residuals = [float(row["residual_mm"]) for row in quality(out / "study", molars.names) if row["place"] == "model"]
    models[maps] = model_figures(out / "study") | {"residual_mm": np.mean(residuals)}
if arguments.direct:
    by["maps between specimens"] = direct([by["maps, pairs"], by["maps, joint"]], taxa["family"])
lines = [f"{len(molars.names)} second lower molars; taxa with at least {FEWEST} specimens. Right: the nearest neighbor is of the same taxon.", "",
         "| distances of | genus right | family right | another family is nearest to |", "|---|---|---|---|"]
for name, found in by.items():
    errors = {kind: wrong(found, taxa[kind]) for kind in taxa}
    genus, family = (f"{len(asked(taxa[kind])) - len(errors[kind])} of {len(asked(taxa[kind]))}" for kind in ("genus", "family"))
    names = [f"{molars.names[k]} ({taxa['family'][k]}): {molars.names[near]} ({taxa['family'][near]})" for k, near in errors["family"]]
    lines.append(f"| {name} | {genus} | {family} | {'; '.join(names)} |")
lines += ["", "The shape models of the maps, 10 modes, all teeth scaled to their mean size, mm of that size (residuals: of their own).",
          "Specimens whose match is not reliable are not in the model:", "",
          "| maps | in the model | compactness | generalization, mm | specificity, mm | residual, mean, mm |", "|---|---|---|---|---|---|"]
for maps, of in models.items():
    figures = (f"{of[key]['10']:.3f}" for key in ("compactness", "generalization_mm", "specificity_mm"))
    lines.append(f"| {maps} | {of['subjects']['model']} | {' | '.join(figures)} | {of['residual_mm']:.3f} |")
(out / "taxa.md").write_text("\n".join(lines) + "\n")
print("\n".join(lines))
