"""Studies beside correspondences of other methods, on the same subjects, template and statistics: spherical harmonics (SPHARM, degree
12, from the example `other_matches` of homolog-study), ICP (`--method icp`) and Bayesian coherent point drift (`benches/accuracy/bcpd.py`).

Usage: others.py --binary homolog --examples DIR --data DIR --out DIR [--parts model,cycles,atrophy] [--subjects N]
DIR/hippocampus has label volumes (*.nii.gz). What is there in --out is not computed again; figures go to OUT/figures.json and to the
standard output. Needs what study.py needs.

- model: generalization, specificity, compactness, and Dice of labels that half of the subjects vote for, over all subjects.
- cycles: how far points come back from where they began, over a ring of subjects, with each method's own maps.
- atrophy: surfaces of every other subject thinned in a patch: how much of the patch is found, and how much beside it."""
import argparse
import csv
import sys
import time
from pathlib import Path

import numpy as np

from running import Bench, document, model_figures, run, stem, table
from surfaces import found_in_patch, read_ply, surface, thinned, write_ply

sys.path.append(str(Path(__file__).parent.parent / "accuracy"))
import bcpd  # noqa: E402
from scipy.spatial import cKDTree  # noqa: E402

RING = 8
PATCHES_MM = (7.0, 12.0)
DEPTHS_MM = (0.3, 1.0)
MEASURES = ("normal_displacement", "thickness")
MOST_POINTS = 1500
"""Coherent point drift works on a sample of so many vertices, as the square of their number is what it costs."""
N_CARRIERS = 4

arguments = argparse.ArgumentParser()
for name in ("--binary", "--examples", "--data", "--out"):
    arguments.add_argument(name, required=True)
arguments.add_argument("--parts", default="model,cycles,atrophy")
arguments.add_argument("--subjects", type=int, default=60)
arguments.add_argument("--permutations", type=int, default=1000)
arguments = arguments.parse_args()
bench = Bench(arguments.binary, arguments.data, arguments.out)
bench.begin()
out, parts = bench.out, arguments.parts.split(",")


def once(folder, work):
    """Does what makes a study, unless it is there."""
    if not (folder / "study.json").exists():
        seconds, processor, _ = work()
        bench.say(f"time {folder.relative_to(out)}", seconds=round(seconds, 1), processor_seconds=round(processor, 1))
    return folder


def other(mode, study, folder):
    return run([Path(arguments.examples, "other_matches"), mode, study, folder])


def sample(vertices):
    if len(vertices) <= MOST_POINTS:
        return np.arange(len(vertices))
    return np.sort(np.random.default_rng(0).choice(len(vertices), MOST_POINTS, replace=False))


def drifted(source, target):
    """Where the vertices of `source` come to lie on `target`. Surfaces lie in their scanner's axes, so that their centers are
    all that has to be aligned before."""
    aligned = source + target.mean(0) - source.mean(0)
    points = aligned[sample(aligned)]
    moved = bcpd.register(target[sample(target)], points)
    distance, near = cKDTree(points).query(aligned, k=N_CARRIERS)
    weight = 1 / np.maximum(distance, 1e-9)
    weight /= weight.sum(1, keepdims=True)
    return aligned + np.einsum("ik,ikd->id", weight, (moved - points)[near])


def by_drift(study, folder):
    begun, own = time.monotonic(), time.process_time()
    _, before, _ = other("tasks", study, folder)
    place = folder / "tasks"
    vertices = {path.stem: read_ply(path)[0] for path in place.glob("*.ply")}
    for row in csv.DictReader(open(place / "tasks.csv")):
        images = place / f"{row['key']}.f32"
        if not images.exists():
            drifted(vertices[row["source"]], vertices[row["target"]]).astype("<f4").tofile(images)
    _, after, _ = other("images", study, folder)
    return time.monotonic() - begun, before + after + time.process_time() - own, 0


made = once(out / "hippocampi-made", lambda: bench.study(
    table(out / "all.csv", [{"id": stem(f), "file": f} for f in bench.files]), out / "hippocampi-made", "--cycles", RING))
template = made / "template/template.ply"

if "model" in parts:
    spharm = once(out / "hippocampi-spharm", lambda: other("spharm", made, out / "hippocampi-spharm"))
    bench.say("model homolog", **model_figures(made), rounds=document(made)["rounds"])
    bench.say("model spharm", **model_figures(spharm))

if "cycles" in parts:
    ring = table(out / "ring.csv", [{"id": stem(f), "file": f} for f in bench.spread(RING)])
    own = once(out / "ring-made", lambda: bench.study(ring, out / "ring-made", "--cycles", RING, "--template", template))
    spharm = once(out / "ring-spharm", lambda: other("spharm", own, out / "ring-spharm"))
    drift = once(out / "ring-bcpd", lambda: by_drift(own, out / "ring-bcpd"))
    for name, folder in (("homolog", own), ("spharm", spharm), ("bcpd", drift)):
        bench.say(f"cycles {name}", **document(folder)["found"]["consistency"])

if "atrophy" in parts:
    surfaces = {file: surface(file) for file in bench.spread(arguments.subjects)}
    for radius in PATCHES_MM:
        for depth in DEPTHS_MM:
            place = out / f"thinned-{radius:g}-{depth:g}"
            place.mkdir(exist_ok=True)
            rows = []
            for k, (file, (vertices, faces)) in enumerate(surfaces.items()):
                is_patient = k % 2 == 0
                path = place / f"{stem(file)}.ply"
                write_ply(path, thinned(vertices, faces, radius, depth) if is_patient else vertices, faces)
                rows.append({"id": stem(file), "file": path, "group": "patient" if is_patient else "control"})
            cohort = table(place / "subjects.csv", rows)
            options = ["--template", template, "--effect", "group", "--reference", "group=control", "--permutations",
                       arguments.permutations, "--set", 'input.repair=["weld","orient","fill"]']
            for name, work in (
                ("homolog", lambda to: bench.study(cohort, to, *options)),
                ("icp", lambda to: bench.study(cohort, to, *options, "--method", "icp")),
                ("spharm", lambda to: other("spharm", place / "homolog", to)),
            ):
                folder = once(place / name, lambda: work(place / name))
                for measure in MEASURES:
                    found = found_in_patch(folder, measure, radius)
                    bench.say(f"atrophy {radius:g} mm wide, {depth:g} mm deep, {name}, {measure}",
                              subjects=document(folder)["found"]["subjects"], **found)
