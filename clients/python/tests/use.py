"""What the package takes and gives, in a folder with source.nii.gz, target.nii.gz and template.nii.gz."""

import asyncio
import os
import signal
import subprocess
import sys
import warnings
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
assert homolog.match((source.vertices, source.faces), target, parameters=rigid, tags={"a": "b"}).job.tags["a"] == "b"
box = np.array([[x, y, z] for x in (0, 10) for y in (0, 20) for z in (0, 30)], float)
quads = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
with warnings.catch_warnings(record=True) as said:
    warnings.simplefilter("always")
    former = homolog.match((source.vertices, source.faces), target, parameters=rigid, labels={"a": "c"})
assert former.job.tags["a"] == "c" and "tags=" in str([warning.message for warning in said]), said
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

# Pictures, with pyvista where it is installed.
try:
    import pyvista
except ImportError:
    pass
else:
    colored = source.to_pyvista()
    assert (colored.n_points, colored.n_cells) == (len(source.vertices), len(source.faces))
    plotter = match.plot(show=False, off_screen=True)
    left, right = (mesh for renderer in plotter.renderers for mesh in [next(iter(renderer.actors.values())).mapper.dataset])
    assert np.allclose(left.points, match.mesh("aligned").vertices) and np.allclose(right.points, target.vertices)
    # Corresponding points have one color: that of the nearest target vertex, within what an edge spans.
    pairs = match.correspondences
    colors = [next(array for array in mesh.point_data.values() if array.ndim == 2 and array.dtype == np.uint8) for mesh in (left, right)]
    apart = colors[0][pairs["source"]].astype(int) - colors[1][pairs["target"]].astype(int)
    assert np.abs(apart).mean() < 10, np.abs(apart).mean()
    plotter.close()
    plotter = match.plot("confidence", show=False, off_screen=True)
    shown = next(iter(plotter.renderers[0].actors.values())).mapper.dataset
    assert any(np.allclose(array, warped.values["confidence"]) for array in shown.point_data.values() if array.ndim == 1)
    picture = plotter.screenshot(return_img=True)
    assert picture.std() > 5, "something is drawn"
    plotter.close()
    try:
        match.plot("none", show=False, off_screen=True)
        raise SystemExit("it was drawn")
    except ValueError as error:
        assert "confidence" in str(error), error

# Arguments for what is asked most, the energy and its trace.
other = homolog.match("source.nii.gz", "target.nii.gz", method="thesis", label={"source": 1, "target": [1]})
assert other.result["provenance"]["parameters"]["method"] == "thesis"
assert other.result["provenance"]["parameters"]["input"]["target"]["labels"] == [1]
last = match.trace.iloc[-1]
assert last["chosen"] and last["energy"] == match.energy["final"] and set(match.trace["quantity"]) >= {"field_energy"}
flipped = source.vertices * [-1, 1, 1]
mirrored = homolog.match((flipped, source.faces[:, ::-1]), target, mirror="source")
assert np.linalg.det(mirrored.transform[:3, :3]) < 0 and mirrored.result["transform"]["mirrored"]
for shown in (match, service, source):
    assert repr(shown).startswith("<homolog.") and len(repr(shown)) < 300, repr(shown)
try:
    homolog.match("source.nii.gz", "target.nii.gz", method="metropolis", timeout=1,
                  parameters={"inference": {"max_iterations": 100_000}})
    raise SystemExit("it waited")
except homolog.HomologError as error:
    assert "more than 1 s" in str(error), error

# A wrong address is said within seconds, and errors say things once.
import time  # noqa: E402

for address in ("http://127.0.0.1:9", "http://no-such-host.invalid", "127.0.0.1:9"):
    begun = time.monotonic()
    try:
        homolog.match("source.nii.gz", "target.nii.gz", service=homolog.Service(address))
        raise SystemExit(f"{address} answered")
    except homolog.HomologError as error:
        assert "cannot be reached" in str(error) and time.monotonic() - begun < 30, error
try:
    homolog.match("source.nii.gz", "target.nii.gz", label="hipocampus")
    raise SystemExit("it was found")
except homolog.HomologError as error:
    assert str(error).count("hipocampus") == 1, error

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
    task = asyncio.create_task(homolog.match_async("source.nii.gz", "target.nii.gz", parameters=slow, tags={"task": "slow"}))
    await asyncio.sleep(1.5)
    task.cancel()
    try:
        await task
        raise SystemExit("it was cancelled")
    except asyncio.CancelledError:
        pass


asyncio.run(several())
from homolog._client.api.jobs import list_jobs  # noqa: E402

(cancelled,) = service.call(list_jobs, tag="task:slow").jobs
assert cancelled.cancel_requested, cancelled

# A template as source: row i is vertex i of the template. A subject that is refused is a row with its error.
nothing = {"nothing": b"nothing", "open": (np.eye(3), np.array([[0, 1, 2]]))}
matches = homolog.match_many("template.nii.gz", {"a": "source.nii.gz", **nothing, "b": "target.nii.gz"}, progress=False,
                             parameters={"input": {"allow_boundary": False}})
assert matches["b"].job.source.hash_ == matches["a"].job.source.hash_ and matches.points.shape[0] == 4
assert matches.points.shape[1] == len(matches["a"].mesh("source").vertices) and np.isnan(matches.points[1:3]).all()
assert list(matches.table.index) == ["a", "nothing", "open", "b"]
assert list(matches.table["state"]) == ["succeeded", "refused", "refused", "succeeded"]
assert "not recognized" in matches.table["error"]["nothing"] and "is open" in matches.table["error"]["open"]
assert "4 subjects, 2 matched" in repr(matches)

# A study of a group, with the sides of its subjects.
left = {f"l{k}": (source.vertices * [1 + 0.02 * k, 1, 1], source.faces) for k in range(3)}
right = {f"r{k}": (source.vertices * [-1 - 0.02 * k, 1, 1], source.faces[:, ::-1]) for k in range(3)}
covariates = {name: {"side": "left" if name[0] == "l" else "right", "age": 60.0 + int(name[1]), "label": 17}
              for name in [*left, *right]}
study = homolog.study({**left, **right, "nothing": b"nothing"}, {**covariates, "nothing": {}}, effect="side", permutations=20,
                      template_rounds=1, method="balanced", progress=False)
assert set(study.refused) == {"nothing"} and "not recognized" in study.table["error"]["nothing"]
assert list(study.table["label"][:6]) == [17] * 6, "of volumes; the same surfaces have none"
assert list(study.table["side"][:6]) == ["left"] * 3 + ["right"] * 3 and (study.table["place"][:6] == "model").all()
assert "<!doctype html>" in study.report.lower() and len(study.effects) > 0 and "6 subjects, 1 refused" in repr(study)

# The service ends with the process, also when that is killed.
child = subprocess.Popen(
    [sys.executable, "-c", "import homolog, time; s = homolog.default_service(); print(s.url, flush=True); time.sleep(60)"],
    stdout=subprocess.PIPE, text=True)
url = child.stdout.readline().strip()
homolog.Service(url).call(list_jobs)
os.kill(child.pid, signal.SIGKILL)
child.wait()

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
