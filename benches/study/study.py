"""Measures studies: on real hippocampi, on simulated atrophy and asymmetry, on splits without an effect, killed, timed, and large.

Usage: study.py --binary homolog --data DIR --out DIR [--parts hippocampi,joint,starts,atrophy,asymmetry,null,killed,time,memory,large] [--subjects N]
DIR/hippocampus has label volumes (*.nii.gz). Everything is kept in --out, so that what is there is not computed again. Figures go
to OUT/figures.json and to the standard output, those of asymmetry also to OUT/asymmetry-supplement.md. Needs numpy, scipy, scikit-image, nibabel
and matplotlib."""
import argparse
import csv
import os
import shutil
import signal
import subprocess

import numpy as np

import supplement
from running import Bench, document, model_figures, stem, table
from surfaces import deformation, found_in_patch, gifti, maps, patch, surface, thinned, write_ply

arguments = argparse.ArgumentParser()
arguments.add_argument("--binary", required=True)
arguments.add_argument("--data", required=True)
arguments.add_argument("--out", required=True)
arguments.add_argument("--parts", default="time,hippocampi,joint,starts,atrophy,asymmetry,null,killed,memory,large")
arguments.add_argument("--subjects", type=int, default=60)
arguments.add_argument("--examples", help="folder of the examples null_splits, templates_apart and large_group of homolog-study")
arguments.add_argument("--splits", type=int, default=200)
arguments = arguments.parse_args()
bench = Bench(arguments.binary, arguments.data, arguments.out)
out, files, say, study, spread = bench.out, bench.files, bench.say, bench.study, bench.spread
bench.begin()
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
        say(f"hippocampi {name}", **model_figures(folder), rounds=document(folder)["rounds"], seconds=round(seconds, 1),
            processor_seconds=round(processor, 1), memory_mib=round(memory))

if "joint" in parts:
    # All subjects and two halves of them: the same template and matches, with and without joint maps.
    for name, some in (("all", files), ("even", files[::2]), ("odd", files[1::2])):
        cohort = table(out / f"joint-{name}.csv", [{"id": stem(f), "file": f} for f in some])
        for how in ("pairs", "joint"):
            folder = out / f"joint-{name}-{how}"
            if how == "joint":
                for part in ("matches", "template"):
                    shutil.copytree(out / f"joint-{name}-pairs" / part, folder / part, dirs_exist_ok=True)
            seconds, processor, memory = study(cohort, folder, "--cycles", 8, "--correspondence", how)
            found = list(csv.DictReader(open(folder / "quality.csv")))
            mean = lambda key: round(float(np.mean([float(row[key]) for row in found if row[key]])), 5)
            say(f"joint {name} {how}", **model_figures(folder), residual_mm=mean("residual_mm"), folded=mean("folded"),
                joint=document(folder)["found"]["joint"], seconds=round(seconds, 1), processor_seconds=round(processor, 1),
                memory_mib=round(memory))

if "starts" in parts:
    # Two starts: the subjects of least and of greatest volume among those that the template is made from.
    made = document(out / "hippocampi-made")
    rows = {row["id"]: row for row in csv.DictReader(open(out / "hippocampi-made/subjects.csv"))}
    makers = made["settings"]["template"]["made"]["from"]
    by_volume = sorted(makers, key=lambda name: float(rows[name]["volume_mm3"]))
    folders = []
    for which, start in (("least", by_volume[0]), ("greatest", by_volume[-1])):
        folder = out / f"start-{start}"
        study(table(out / "makers.csv", [{"id": name, "file": next(f for f in files if stem(f) == name)} for name in makers]),
              folder, "--start", start, "--template-subjects", 0)
        folders.append(folder)
        say("starts", **{f"from {which} volume": document(folder)["rounds"]})
    said = subprocess.run([f"{arguments.examples}/templates_apart", *folders], capture_output=True, text=True, check=True)
    say("starts", apart=said.stdout.splitlines())

PATCH_MM, DEPTH_MM = 7.0, 0.3

if "atrophy" in parts:
    folder = out / "atrophy-subjects"
    folder.mkdir(exist_ok=True)
    rows = []
    for file, group in zip(spread(n), groups):
        vertices, faces = surface(file)
        if group == "patient":
            vertices = thinned(vertices, faces, PATCH_MM, DEPTH_MM)
        write_ply(folder / f"{stem(file)}.ply", vertices, faces)
        rows.append({"id": stem(file), "file": folder / f"{stem(file)}.ply", "group": group})
    cohort = table(out / "atrophy.csv", rows)
    repairs = ["--set", 'input.repair=["weld","orient","fill"]']
    for name, options in [("made", []), ("icp", ["--method", "icp"])]:
        result = out / f"atrophy-{name}"
        if name == "icp":
            options += ["--template", out / "atrophy-made/template/template.ply"]
        study(cohort, result, "--effect", "group", "--reference", "group=control", "--permutations", 2000, *repairs, *options)
        for measure in ("normal_displacement", "thickness", "log_area"):
            for kind, found in found_in_patch(result, measure, PATCH_MM).items():
                say(f"atrophy {name} {measure} {kind}", **found)

# Pairs that are made up: both sides are a real structure, sampled twice and deformed at random. The right ones are thinned in a patch,
# and once more are not. Both samplings interpolate the volume equally, because interpolation alone makes a structure thinner.
ASYMMETRY_PATCH_MM, ASYMMETRY_DEPTHS_MM, OWN_WIDTH_MM, OWN_DEVIATION_MM = 12.0, {"known": 0.5, "none": 0.0}, 12.0, 0.3

if "asymmetry" in parts:
    folder, rng = out / "asymmetry-subjects", np.random.default_rng(11)
    folder.mkdir(exist_ok=True)
    rows = {name: [] for name in ASYMMETRY_DEPTHS_MM}
    for k, file in enumerate(spread(n)):
        for side, offset in (("left", -0.25), ("right", 0.25)):
            vertices, faces = surface(file, offset)
            vertices = vertices + deformation(rng, OWN_WIDTH_MM, OWN_DEVIATION_MM)(vertices)
            for name, depth_mm in ASYMMETRY_DEPTHS_MM.items():
                path = folder / (f"p{k:02}-left.ply" if side == "left" else f"p{k:02}-right-{name}.ply")
                rows[name].append({"id": f"p{k:02}-{side}", "file": path, "subject": f"p{k:02}", "side": side})
                if side == "left":
                    write_ply(path, vertices, faces)
                else:
                    write_ply(path, thinned(vertices, faces, ASYMMETRY_PATCH_MM, depth_mm) * [-1, 1, 1], faces[:, ::-1])
    for name, depth_mm in ASYMMETRY_DEPTHS_MM.items():
        result = out / f"asymmetry-{name}"
        options = ["--template", out / "asymmetry-known/template/template.ply"] if name == "none" else []
        seconds, processor, _ = study(table(out / f"asymmetry-{name}.csv", rows[name]), result, "--effect", "side", "--template-side", "left",
                                      "--permutations", 2000, *options)
        vertices = gifti(result / "mean.surf.gii")[0].astype(float)
        weight = patch(vertices, ASYMMETRY_PATCH_MM)
        say(f"asymmetry {name}", pairs=n, put_in_patch_mm=round(-depth_mm * float(weight[weight > 0.5].mean()), 3), seconds=round(seconds, 1),
            processor_seconds=round(processor, 1))
        for measure in ("normal_displacement", "thickness", "log_area"):
            arrays = maps(result, f"{measure}.right-left")
            largest = np.argmax(np.abs(arrays["t"]))
            distance = np.linalg.norm(vertices[largest] - vertices[np.argmax(weight)])
            say(f"asymmetry {name} {measure}", **found_in_patch(result, measure, ASYMMETRY_PATCH_MM, "right-left")["significant"],
                smallest_p_tfce=round(float(arrays["p_tfce_fwe"].min()), 4), median_se=round(float(np.median(arrays["robust_se"][weight > 0.5])), 3),
                largest_t_from_middle_mm=round(float(distance), 1))
    supplement.main(out, out / "asymmetry-supplement")


def begun(folder):
    """A folder with the template and the matches of the timed study."""
    if not folder.exists():
        for part in ("matches", "template"):
            shutil.copytree(out / "time" / part, folder / part)
    return folder


if "null" in parts:
    # Random splits of the subjects of the timed study; the example computes nothing but statistics.
    said = subprocess.run([f"{arguments.examples}/null_splits", out / "time", str(arguments.splits), "400"], capture_output=True, text=True, check=True)
    say("null", said=said.stdout.splitlines())

if "killed" in parts:
    cohort = table(out / "killed.csv", [{"id": stem(f), "file": f, "group": g} for f, g in zip(spread(n), groups)])
    whole, killed = out / "not-killed", out / "killed"
    for folder in (whole, killed):
        shutil.rmtree(folder, ignore_errors=True)
    rng, kills = np.random.default_rng(3), 0
    options = ["--effect", "group", "--correspondence", "joint", "--threads", "2"]
    study(cohort, whole, *options)
    command = [arguments.binary, "study", str(cohort), "--out", str(killed), *options]
    while kills < 20:
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            process.wait(rng.uniform(1, 5))
            break
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGKILL)
            process.wait()
            kills += 1
    study(cohort, killed, *options)
    content = lambda folder: {p.relative_to(folder): p.read_bytes() for p in folder.rglob("*") if p.is_file()}
    say("killed", kills=kills, equal_bytes=content(whole) == content(killed))

if "memory" in parts:
    # A thousand rows of sixty files: their matches are there, so that this is the memory of all that follows.
    rows = [{"id": f"{stem(f)}-{copy}", "subject": f"{stem(f)}-{copy}", "file": f, "group": ("patient", "control")[(k + copy) % 2]}
            for copy in range(17) for k, f in enumerate(spread(60))][:1000]
    seconds, processor, memory = study(table(out / "thousand.csv", rows), begun(out / "thousand"), "--effect", "group", "--permutations", 500)
    say("memory", subjects=len(rows), seconds=round(seconds, 1), processor_seconds=round(processor, 1), memory_mib=round(memory))

if "large" in parts:
    folder = out / "large"
    shutil.rmtree(folder, ignore_errors=True)
    said = subprocess.run([f"{arguments.examples}/large_group", "10000", folder], capture_output=True, text=True, check=True)
    say("large", said=said.stdout.splitlines())
    shutil.rmtree(folder)
