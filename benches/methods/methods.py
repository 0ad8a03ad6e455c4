"""Published methods here and in other programs of the same methods, on the same pairs from the same pose.

Usage: methods.py --binary homolog --data DIR --eval DIR --out DIR [--cases variant:index,...] [--only name,...]
DIR/hippocampus has label volumes (*.nii.gz); --eval has real_cases.py, which makes pairs with a known truth. The pose is that of
`--method rigid`, from which the methods here begin; the source is moved there for the others. What is answered in --out is not
computed again. Prints a table in Markdown: mean error in percent of the diagonal of the target, of each pair and of each set,
and median seconds: of the whole command here, of the call alone for the others. Points that a peer leaves beside the target are
put on it, as they are here."""
import argparse
import csv
import json
import shutil
import subprocess
import sys
import time
from pathlib import Path
from types import SimpleNamespace

import numpy as np
from scipy.spatial import cKDTree

sys.path.append(str(Path(__file__).parent.parent / "accuracy"))
from geometry import write_ply  # noqa: E402

OURS = ("rigid", "balanced", "cpd", "bcpd", "nonrigid_icp", "functional_map", "spharm_pdm", "medial", "diffeomorphic")
SETS = ("real_warp4", "real_warp8", "real_narrow2")
HELD_BACK = range(2, 6)
"""Settings of the methods here were chosen on pairs 0 and 1."""
MOST_POINTS = 1500
"""Coherent point drift works on a sample of so many vertices, as the square of their number is what it costs."""


def sampled(points, moved, whole):
    """`whole` moved by the displacement of the nearest sampled points."""
    distance, near = cKDTree(points).query(whole, k=4)
    weight = 1 / np.maximum(distance, 1e-9)
    weight /= weight.sum(1, keepdims=True)
    return whole + np.einsum("ik,ikd->id", weight, (moved - points)[near])


def samples(pair):
    random = np.random.default_rng(0)
    pick = lambda v: np.sort(random.choice(len(v), min(len(v), MOST_POINTS), replace=False))  # noqa: E731
    return pair.source[pick(pair.source)], pair.target[pick(pair.target)]


def scaled(pair):
    """Samples of both, centered on the target and of root mean square 1, with the way back."""
    points, onto = samples(pair)
    center = onto.mean(0)
    scale = np.sqrt(((onto - center) ** 2).sum(1).mean())
    return points, (points - center) / scale, (onto - center) / scale, lambda p: p * scale + center


def pycpd(pair):
    from pycpd import DeformableRegistration

    points, moving, fixed, back = scaled(pair)
    moved, _ = DeformableRegistration(X=fixed, Y=moving, low_rank=True, num_eig=100, max_iterations=150).register()
    return sampled(points, back(moved), pair.source)


def probreg_bcpd(pair):
    from probreg import bcpd

    points, moving, fixed, back = scaled(pair)
    found = bcpd.registration_bcpd(moving, fixed)
    return sampled(points, back(found.transform(moving)), pair.source)


def trimesh_nricp(pair):
    import trimesh
    from trimesh.registration import nricp_amberg

    mesh = lambda v, f: trimesh.Trimesh(v, f, process=False)  # noqa: E731
    return np.asarray(nricp_amberg(mesh(pair.source, pair.source_faces), mesh(pair.target, pair.target_faces), use_faces=True))


def pyfmaps(pair):
    from pyFM.mesh import TriMesh
    from pyFM.refine.zoomout import mesh_zoomout_refine_p2p

    source, target = TriMesh(pair.source, pair.source_faces), TriMesh(pair.target, pair.target_faces)
    source.process(k=120)
    target.process(k=120)
    nearest = cKDTree(pair.target).query(pair.source)[1]
    _, image = mesh_zoomout_refine_p2p(nearest, target, source, 40, nit=5, step=4, return_p2p=True)
    return pair.target[image]


PEERS = {"pycpd": pycpd, "probreg bcpd": probreg_bcpd, "trimesh nricp": trimesh_nricp, "pyfmaps": pyfmaps}


def load(arguments, case):
    import real_cases

    variant, index = case.split(":")
    found = real_cases.load_case(variant, int(index), str(Path(arguments.data, "hippocampus")), str(arguments.out / "cases"))
    return SimpleNamespace(
        name=f"{variant}_{index}", source=found["V1"], source_faces=found["F1"], target=found["V2"], target_faces=found["F2"],
        truth=found["gtpos"], diagonal=np.linalg.norm(np.ptp(found["V2"], 0)),
    )


def matched(arguments, pair, method):
    """Images of the source vertices, the transform, and the seconds of the whole command."""
    place = arguments.out / pair.name
    place.mkdir(parents=True, exist_ok=True)
    source, target, out = place / "source.ply", place / "target.ply", place / method
    write_ply(source, pair.source, pair.source_faces)
    write_ply(target, pair.target, pair.target_faces)
    shutil.rmtree(out, ignore_errors=True)
    begin = time.monotonic()
    subprocess.run([arguments.binary, "match", source, target, "--method", method, "--out", out],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    seconds = time.monotonic() - begin
    transform = json.loads((out / "result.json").read_text())["transform"]
    return corresponding(out, pair.target), transform, seconds


def corresponding(out, target):
    """The point of the surface with the vertices `target` that each source vertex corresponds to, of the answer in a folder."""
    with open(out / "correspondences.csv") as file:
        rows = list(csv.DictReader(file))
    corners = np.array([[int(row[f"triangle_{k}"]) for k in range(3)] for row in rows])
    weights = np.array([[float(row[f"barycentric_{k}"]) for k in range(3)] for row in rows])
    return np.einsum("ik,ikd->id", weights, target[corners])


def onto(pair, points):
    """The closest points of the target, as the methods here answer with points of the target as well."""
    import trimesh

    return trimesh.proximity.closest_point(trimesh.Trimesh(pair.target, pair.target_faces, process=False), points)[0]


def error(pair, images):
    return 100 * np.linalg.norm(images - pair.truth, axis=1).mean() / pair.diagonal


def measured(arguments, pair, names, store):
    posed = None
    for name in names:
        key = f"{name} {pair.name}"
        if key in store:
            continue
        if name in OURS:
            images, _, seconds = matched(arguments, pair, name)
        else:
            if posed is None:
                _, transform, _ = matched(arguments, pair, "rigid")
                matrix = np.array(transform["matrix"]).reshape(4, 4)
                posed = SimpleNamespace(**{**vars(pair), "source": pair.source @ matrix[:3, :3].T + matrix[:3, 3]})
            begin = time.monotonic()
            try:
                images = onto(pair, PEERS[name](posed))
            except Exception as failure:  # noqa: BLE001 - what a peer raises is its row
                store[key] = {"failed": repr(failure)[:200]}
                continue
            seconds = time.monotonic() - begin
        store[key] = {"error": float(error(pair, images)), "seconds": seconds}
        print(key, store[key], file=sys.stderr, flush=True)
        (arguments.out / "figures.json").write_text(json.dumps(store, indent=1))


def printed(names, cases, store):
    """A row for each method: the mean error of every set with that of each pair, and seconds."""
    sets = list(dict.fromkeys(case.split(":")[0] for case in cases))
    print("| |", " | ".join(f"`{one}`" for one in sets), "| mean | seconds |")
    print("|---" * (len(sets) + 3) + "|")
    for name in names:
        found = {case: store.get(f"{name} {case.replace(':', '_')}", {}) for case in cases}
        answered = [one for one in found.values() if "error" in one]
        cells = []
        for one in sets:
            errors = [found[case].get("error") for case in cases if case.startswith(f"{one}:")]
            every = ", ".join("failed" if e is None else f"{e:.2f}" for e in errors)
            cells.append("failed" if None in errors else f"**{np.mean(errors):.2f}** ({every})")
        if answered:
            cells.append(f"{np.mean([one['error'] for one in answered]):.2f}")
            cells.append(f"{np.median([one['seconds'] for one in answered]):.1f}")
        print(f"| {name} |", " | ".join(cells), "|")


def main():
    parser = argparse.ArgumentParser()
    for name in ("--binary", "--data", "--eval", "--out"):
        parser.add_argument(name, required=True, type=Path)
    parser.add_argument("--cases", default=",".join(f"{variant}:{k}" for variant in SETS for k in HELD_BACK))
    parser.add_argument("--only", default=",".join([*OURS, *PEERS]))
    arguments = parser.parse_args()
    sys.path.insert(0, str(arguments.eval))
    arguments.out.mkdir(parents=True, exist_ok=True)
    kept = arguments.out / "figures.json"
    store = json.loads(kept.read_text()) if kept.exists() else {}
    cases, names = arguments.cases.split(","), arguments.only.split(",")
    for case in cases:
        measured(arguments, load(arguments, case), names, store)
    printed(names, cases, store)


if __name__ == "__main__":
    main()
