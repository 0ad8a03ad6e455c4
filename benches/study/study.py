"""Measures studies: on real hippocampi, on simulated atrophy, on splits without an effect, killed, timed, and large.

Usage: study.py --binary homolog --data DIR --out DIR [--parts hippocampi,starts,atrophy,null,killed,time,memory] [--subjects N]
DIR/hippocampus has label volumes (*.nii.gz). Everything is kept in --out, so that what is there is not computed again. Figures go
to OUT/figures.json and to the standard output. Needs numpy, scipy, scikit-image and nibabel."""
import argparse
import csv
import json
import os
import platform
import resource
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import nibabel as nib
import numpy as np
from scipy.ndimage import gaussian_filter, label
from scipy.spatial import cKDTree
from skimage.measure import marching_cubes

arguments = argparse.ArgumentParser()
arguments.add_argument("--binary", required=True)
arguments.add_argument("--data", required=True)
arguments.add_argument("--out", required=True)
arguments.add_argument("--parts", default="time,hippocampi,starts,atrophy,null,killed,memory")
arguments.add_argument("--subjects", type=int, default=60)
arguments.add_argument("--null-splits", help="the example null_splits of homolog-study")
arguments.add_argument("--splits", type=int, default=200)
arguments = arguments.parse_args()
out = Path(arguments.out)
out.mkdir(parents=True, exist_ok=True)
files = sorted(Path(arguments.data, "hippocampus").glob("*.nii.gz"))
figures_at = out / "figures.json"
figures = json.loads(figures_at.read_text()) if figures_at.exists() else {}


def say(part, **values):
    figures.setdefault(part, {}).update(values)
    figures_at.write_text(json.dumps(figures, indent=1))
    print(part, json.dumps(values), flush=True)


def study(cohort, folder, *options, check=True):
    """Seconds, seconds of processors, and the largest memory, MiB, of one run."""
    before = time.monotonic()
    process = subprocess.Popen([arguments.binary, "study", str(cohort), "--out", str(folder), *map(str, options)],
                               stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    errors = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if check and process.returncode:
        sys.exit(f"study failed: {errors[-2000:]}")
    return time.monotonic() - before, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def table(path, rows):
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0])
        writer.writeheader()
        writer.writerows(rows)
    return path


def document(folder):
    return json.loads((folder / "study.json").read_text())


def spread(n):
    return [files[k * len(files) // n] for k in range(n)]


def stem(path):
    return path.name.split(".")[0]


def write_ply(path, vertices, faces):
    with open(path, "wb") as file:
        file.write((f"ply\nformat binary_little_endian 1.0\nelement vertex {len(vertices)}\nproperty double x\nproperty double y\n"
                    f"property double z\nelement face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n").encode())
        file.write(vertices.astype("<f8").tobytes())
        rows = np.empty(len(faces), dtype=[("n", "u1"), ("v", "<i4", 3)])
        rows["n"], rows["v"] = 3, faces
        file.write(rows.tobytes())


def surface(path):
    image = nib.load(path)
    data = np.asarray(image.dataobj) > 0
    parts, n = label(data)
    if n > 1:
        data = parts == np.bincount(parts.ravel())[1:].argmax() + 1
    vertices, faces, _, _ = marching_cubes(gaussian_filter(np.pad(data, 4).astype(float), 0.7), 0.5)
    vertices = nib.affines.apply_affine(image.affine, vertices - 4)
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return vertices, faces if np.einsum("ij,ij->", a, np.cross(b, c)) > 0 else faces[:, ::-1]


def normals(vertices, faces):
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    each, sums = np.cross(b - a, c - a), np.zeros_like(vertices)
    for k in range(3):
        np.add.at(sums, faces[:, k], each)
    return sums / np.linalg.norm(sums, axis=1, keepdims=True)


PATCH_MM = 7.0


def patch(vertices):
    """Weight of each vertex in a patch that is defined without any correspondence: around the highest point of the middle of the
    structure from front to back, in the scanner's axes."""
    y = vertices[:, 1]
    share = (y - y.min()) / (y.max() - y.min())
    middle = np.where(np.abs(share - 0.5) < 0.04)[0]
    top = vertices[middle[np.argmax(vertices[middle, 2])]]
    distance = np.linalg.norm(vertices - top, axis=1)
    return np.where(distance < PATCH_MM, 0.5 * (1 + np.cos(np.pi * np.minimum(distance, PATCH_MM) / PATCH_MM)), 0.0)


def gifti(path):
    image = nib.load(path)
    return image.agg_data("pointset"), image.agg_data("triangle")


def maps(folder, name):
    image = nib.load(folder / "maps" / f"{name}.shape.gii")
    return {array.meta["Name"]: array.data for array in image.darrays}


def machine():
    with open("/proc/cpuinfo") as info:
        model = next((line.split(":")[1].strip() for line in info if line.startswith("model name")), platform.machine())
    return f"{model}, {os.cpu_count()} cores"


version = subprocess.run([arguments.binary, "--version"], capture_output=True, text=True).stdout.strip()
say("run", machine=machine(), version=version, load=os.getloadavg()[0])
parts = arguments.parts.split(",")
n = arguments.subjects
groups = [("patient", "control")[k % 2] for k in range(n)]

if "time" in parts:
    folder = out / "time"
    shutil.rmtree(folder, ignore_errors=True)
    cohort = table(out / "time.csv", [{"id": stem(f), "file": f, "group": g} for f, g in zip(spread(n), groups)])
    load = os.getloadavg()[0]
    seconds, processor, memory = study(cohort, folder, "--effect", "group", "--threads", 2)
    found = document(folder)
    vertices = np.mean([len(gifti(p)[0]) for p in (folder / "subjects").glob("*.surf.gii")])
    say("time", subjects=n, seconds=round(seconds, 1), processor_seconds=round(processor, 1), memory_mib=round(memory), load_before=load, template_vertices=int(vertices),
        template_rounds=len(found["rounds"]), permutations=found["settings"]["analysis"]["permutations"])

if "hippocampi" in parts:
    rows = [{"id": stem(f), "file": f} for f in files]
    cohort = table(out / "all.csv", rows)
    for name, options in [("made", ["--cycles", 8]), ("icp", ["--cycles", 8, "--method", "icp"])]:
        folder = out / f"hippocampi-{name}"
        if name == "icp":
            # The same template, so that correspondence is all that differs.
            options += ["--template", out / "hippocampi-made/template/template.ply"]
        seconds, processor, memory = study(cohort, folder, *options)
        found = document(folder)["found"]
        model = found["model"]
        at = lambda key: {str(m): round(model[key][m - 1], 4) for m in (1, 5, 10, 20) if m <= len(model[key])}
        say(f"hippocampi {name}", subjects=found["subjects"], compactness=at("compactness"),
            total_variance_mm2=round(sum(model["variances_mm2"]), 4), generalization_mm=at("generalization_mm"),
            specificity_mm=at("specificity_mm"), consistency=found["consistency"], dice=found["dice"],
            rounds=document(folder)["rounds"], seconds=round(seconds, 1), processor_seconds=round(processor, 1), memory_mib=round(memory))

if "starts" in parts:
    # Two starts: the subjects of least and of greatest volume among those that the template is made from.
    made = document(out / "hippocampi-made")
    rows = {row["id"]: row for row in csv.DictReader(open(out / "hippocampi-made/subjects.csv"))}
    makers = made["settings"]["template"]["made"]["from"]
    by_volume = sorted(makers, key=lambda name: float(rows[name]["volume_mm3"]))
    means, starts = [], []
    for start in (by_volume[0], by_volume[-1]):
        folder = out / f"start-{start}"
        study(table(out / "makers.csv", [{"id": name, "file": next(f for f in files if stem(f) == name)} for name in makers]),
              folder, "--start", start, "--template-rounds", 8, "--template-subjects", 0)
        means.append(gifti(folder / "mean.surf.gii"))
        starts.append(surface(next(f for f in files if stem(f) == start)))
        rounds = document(folder)["rounds"]
        say("starts", **{f"rounds from {('least', 'greatest')[len(means) - 1]} volume":
            [round(r["moved_share"], 3) for r in rounds]})

    def apart(a, b):
        tree, moved = cKDTree(b), a.copy()
        for _ in range(200):
            _, nearest = tree.query(moved)
            p, q = moved.mean(0), b[nearest].mean(0)
            u, _, vt = np.linalg.svd((moved - p).T @ (b[nearest] - q))
            turn = (u @ np.diag([1, 1, np.sign(np.linalg.det(u @ vt))]) @ vt).T
            moved = (moved - p) @ turn.T + q
        return moved

    def distance(a, b):
        """Mean symmetric distance of two surfaces after rigid alignment, mm, from dense points of both."""
        def dense(v, f):
            weights = np.array([(i, j, 6 - i - j) for i in range(7) for j in range(7 - i)]) / 6
            return np.einsum("wk,fkc->fwc", weights, v[f]).reshape(-1, 3)
        a, b = dense(*a), dense(*b)
        moved = apart(a, b)
        return 0.5 * (cKDTree(b).query(moved)[0].mean() + cKDTree(moved).query(b)[0].mean())
    v, f = means[0]
    edge = float(np.mean([np.linalg.norm(v[f[:, k]] - v[f[:, (k + 1) % 3]], axis=1).mean() for k in range(3)]))
    say("starts", means_apart_mm=round(distance(*means), 3), starts_apart_mm=round(distance(*starts), 3), mean_edge_mm=round(edge, 3))

if "atrophy" in parts:
    folder = out / "atrophy-subjects"
    folder.mkdir(exist_ok=True)
    rows = []
    for file, group in zip(spread(n), groups):
        vertices, faces = surface(file)
        if group == "patient":
            vertices = vertices - 0.3 * patch(vertices)[:, None] * normals(vertices, faces)
        write_ply(folder / f"{stem(file)}.ply", vertices, faces)
        rows.append({"id": stem(file), "file": folder / f"{stem(file)}.ply", "group": group})
    cohort = table(out / "atrophy.csv", rows)
    repairs = ["--set", 'input.repair=["weld","orient","fill"]']
    for name, options in [("made", []), ("icp", ["--method", "icp"])]:
        result = out / f"atrophy-{name}"
        if name == "icp":
            options += ["--template", out / "atrophy-made/template/template.ply"]
        study(cohort, result, "--effect", "group", "--reference", "group=control", "--permutations", 2000, *repairs, *options)
        vertices, faces = gifti(result / "mean.surf.gii")
        weight = patch(vertices.astype(float))
        truth, outside = weight > 0.5, weight == 0
        for measure in ("normal_displacement", "thickness", "log_area"):
            found = maps(result, f"{measure}.patient-control")
            for kind, p in (("tfce_fwe", found["p_tfce_fwe"]), ("fdr", found["q_fdr"]), ("uncorrected", found["robust_p"])):
                hit = p < 0.05
                say(f"atrophy {name} {measure} {kind}", sensitivity=round(float(hit[truth].mean()), 3),
                    false_discoveries=round(float((hit & outside).sum() / max(hit.sum(), 1)), 3), vertices_found=int(hit.sum()),
                    effect_in_patch_mm=round(float(found["effect"][truth].mean()), 3), vertices_in_patch=int(truth.sum()))

def begun(folder):
    """A folder with the template and the matches of the timed study."""
    if not folder.exists():
        for part in ("matches", "template"):
            shutil.copytree(out / "time" / part, folder / part)
    return folder


if "null" in parts:
    # Random splits of the subjects of the timed study; the example computes nothing but statistics.
    said = subprocess.run([arguments.null_splits, out / "time", str(arguments.splits), "400"], capture_output=True, text=True, check=True)
    say("null", said=said.stdout.splitlines())

if "killed" in parts:
    cohort = out / "time.csv"
    whole, killed = out / "time", out / "killed"
    shutil.rmtree(killed, ignore_errors=True)
    rng, kills = np.random.default_rng(3), 0
    command = [arguments.binary, "study", str(cohort), "--out", str(killed), "--effect", "group", "--threads", "2"]
    while kills < 10:
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            process.wait(rng.uniform(1, 5))
            break
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGKILL)
            process.wait()
            kills += 1
    study(cohort, killed, "--effect", "group", "--threads", 2)
    content = lambda folder: {p.relative_to(folder): p.read_bytes() for p in folder.rglob("*") if p.is_file()}
    say("killed", kills=kills, equal_bytes=content(whole) == content(killed))

if "memory" in parts:
    # A thousand rows of sixty files: their matches are there, so that this is the memory of all that follows.
    rows = [{"id": f"{stem(f)}-{copy}", "subject": f"{stem(f)}-{copy}", "file": f, "group": ("patient", "control")[(k + copy) % 2]}
            for copy in range(17) for k, f in enumerate(spread(60))][:1000]
    seconds, processor, memory = study(table(out / "thousand.csv", rows), begun(out / "thousand"), "--effect", "group", "--permutations", 500)
    say("memory", subjects=len(rows), seconds=round(seconds, 1), processor_seconds=round(processor, 1), memory_mib=round(memory))
