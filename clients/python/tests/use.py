"""What the package takes and gives, in a folder with source.nii.gz, target.nii.gz and template.nii.gz."""

import asyncio
import os
import signal
import subprocess
import sys
from pathlib import Path

import homolog
import numpy as np

service = homolog.default_service()
match = homolog.match("source.nii.gz", "target.nii.gz")
repeated = homolog.match(Path("source.nii.gz"), Path("target.nii.gz"))
assert repeated.job.cached, "an equal match is not computed again"

# Tables and meshes.
table = match.correspondences
assert {"source", "target", "confidence", "inlier", "outlier", "triangle_0", "barycentric_2"} <= set(table.columns)
assert set(table["outlier"].cat.categories) == {"none", "residual", "neighborhood", "both", "no_counterpart"}
source, target, warped = match.mesh("source"), match.mesh("target"), match.warped
assert len(table) == len(source.vertices) == len(warped.vertices) and (source.faces == warped.faces).all()
assert {"displacement_x_mm", "residual_mm", "confidence"} <= set(warped.values)
assert match.transform.shape == (4, 4) and np.isclose(np.linalg.det(match.transform[:3, :3]), 1)
moved = source.vertices @ match.transform[:3, :3].T + match.transform[:3, 3]
assert np.abs(moved - match.mesh("aligned").vertices).max() < 1e-4
corners = target.vertices[table[["triangle_0", "triangle_1", "triangle_2"]].to_numpy()]
points = (corners * table[["barycentric_0", "barycentric_1", "barycentric_2"]].to_numpy()[:, :, None]).sum(1)
assert np.isfinite(points).all() and match.result["surface_distance"]["mean_mm"] < 2
assert [path.name for path in match.save("out")] == ["warped.ply", "correspondences.csv", "transform.tfm", "report.html"]

# Arrays, triangles and quads; and a mesh of another package, of which only the attributes matter.
rigid = {"method": "rigid"}
assert homolog.match((source.vertices, source.faces), target, parameters=rigid, labels={"a": "b"}).job.labels["a"] == "b"
box = np.array([[x, y, z] for x in (0, 10) for y in (0, 20) for z in (0, 30)], float)
quads = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
cube = homolog.match((box, quads), (box + 5, quads), parameters=rigid)
assert len(cube.mesh("source").faces) == 12
for package in ("nibabel", "trimesh", "meshio", "pyarrow"):
    try:
        module = __import__(package)
    except ImportError:
        print(f"without {package}")
        continue
    if package == "nibabel":
        homolog.match(module.load("source.nii.gz"), module.load("target.nii.gz"), parameters=rigid)
    elif package == "trimesh":
        homolog.match(source.to_trimesh(), target.to_trimesh(), parameters=rigid)
    elif package == "meshio":
        mesh = module.Mesh(source.vertices, [("triangle", source.faces)])
        homolog.match(mesh, target, parameters=rigid)
    else:
        assert match.table().num_rows == len(table)

# Errors say what is wrong.
for surfaces, parameters, code in [
    (("source.nii.gz", b"nothing"), {}, "unknown-format"),
    (("source.nii.gz", "target.nii.gz"), {"energy": {"alfa": 1}}, "invalid-parameters"),
]:
    try:
        homolog.match(*surfaces, parameters=parameters)
        raise SystemExit(f"{code} was accepted")
    except homolog.HomologError as error:
        assert error.code == code, error
for wrong in (object(), (np.zeros((3, 2)), np.zeros((1, 3), int)), (np.zeros((3, 3)), np.zeros((1, 3)))):
    try:
        homolog.match(wrong, "target.nii.gz")
        raise SystemExit("accepted")
    except (TypeError, ValueError) as error:
        assert "must be" in str(error) or "cannot match" in str(error)

# Async: several at once; cancelling a task cancels its job.
slow = {"method": "metropolis", "inference": {"max_iterations": 100_000}}


async def several() -> None:
    one, two = await asyncio.gather(*(homolog.match_async("source.nii.gz", "target.nii.gz", parameters=rigid) for _ in range(2)))
    assert (one.transform == two.transform).all()
    task = asyncio.create_task(homolog.match_async("source.nii.gz", "target.nii.gz", parameters=slow, labels={"task": "slow"}))
    await asyncio.sleep(1.5)
    task.cancel()
    try:
        await task
        raise SystemExit("it was cancelled")
    except asyncio.CancelledError:
        pass


asyncio.run(several())
from homolog._client.api.jobs import list_jobs  # noqa: E402

(cancelled,) = service.call(list_jobs, label="task:slow").jobs
assert cancelled.cancel_requested, cancelled

# A study with the template as source: row i is vertex i of the template.
study = homolog.study("template.nii.gz", {"a": "source.nii.gz", "b": "target.nii.gz"}, progress=False)
assert study["b"].job.source.hash_ == study["a"].job.source.hash_ and study.points.shape[0] == 2
assert study.points.shape[1] == len(study["a"].mesh("source").vertices)
assert list(study.table.index) == ["a", "b"] and set(study.table["state"]) == {"succeeded"}

# The service ends with the process, also when that is killed.
child = subprocess.Popen(
    [sys.executable, "-c", "import homolog, time; s = homolog.default_service(); print(s.url, flush=True); time.sleep(60)"],
    stdout=subprocess.PIPE, text=True)
url = child.stdout.readline().strip()
homolog.Service(url).call(list_jobs)
os.kill(child.pid, signal.SIGKILL)
child.wait()
import time  # noqa: E402

import httpx  # noqa: E402

for _ in range(100):
    try:
        httpx.get(url + "/healthz")
        time.sleep(0.1)
    except httpx.TransportError:
        break
else:
    raise SystemExit("the service of a killed process goes on")
print("all of it")
