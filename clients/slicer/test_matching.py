"""The module without its window, against a service. Usage: test_matching.py BASE, with VTK."""

import sys
from pathlib import Path

import vtk

sys.path.insert(0, str(Path(__file__).parent / "Homolog"))
from HomologLib.matching import Matcher, MatchingError, from_vtp, to_bytes  # noqa: E402

matcher = Matcher(sys.argv[1])


def shape(moved=None):
    """A closed surface without symmetry: an ellipsoid with a bulge."""
    sphere = vtk.vtkSphereSource()
    sphere.SetRadius(1)
    sphere.SetThetaResolution(40)
    sphere.SetPhiResolution(30)
    sphere.SetOutputPointsPrecision(vtk.vtkAlgorithm.DOUBLE_PRECISION)
    sphere.Update()
    surface = sphere.GetOutput()
    for k in range(surface.GetNumberOfPoints()):
        x, y, z = surface.GetPoint(k)
        bulge = 1 + 0.5 * max(0.0, x) * max(0.0, y) + 0.3 * max(0.0, -z) ** 2
        surface.GetPoints().SetPoint(k, 20 * x * bulge, 12 * y * bulge, 8 * z * bulge)
    if moved is None:
        return surface
    move = vtk.vtkTransformPolyDataFilter()
    move.SetInputData(surface)
    move.SetTransform(moved)
    move.Update()
    return move.GetOutput()


pose = vtk.vtkTransform()
pose.Translate(5, -3, 8)
pose.RotateWXYZ(25, 1, 2, 3)
source, target = shape(), shape(pose)
assert to_bytes(source).startswith(b"# vtk DataFile Version 4.2")

told = []
job = matcher.wait(matcher.submit(source, target)["id"], tell=lambda job: told.append(job["state"]))
answer = matcher.answer(job)
assert told[-1] == "succeeded" and answer.verdict() == "The answer is reliable.", (told, answer.verdict())

# The transform is that of the target, in the coordinates of the scene.
found, true = answer.transform(), pose.GetMatrix()
for i in range(3):
    for k in range(4):
        assert abs(found.GetElement(i, k) - true.GetElement(i, k)) < (0.5 if k == 3 else 0.02), (i, k)

# The warped source lies on the target, vertex by vertex of the source.
warped = answer.warped()
assert warped.GetNumberOfPoints() == source.GetNumberOfPoints() and warped.GetNumberOfPolys() == source.GetNumberOfPolys()
distance = vtk.vtkImplicitPolyDataDistance()
distance.SetInput(target)
assert max(abs(distance.EvaluateFunction(warped.GetPoint(k))) for k in range(warped.GetNumberOfPoints())) < 0.5
overlays = answer.overlays(warped)
assert set(overlays) == {"displacement_normal_mm", "residual_mm", "area_ratio", "confidence", "spread_mm"}, overlays
assert 0 <= overlays["confidence"][0] <= overlays["confidence"][1] <= 1 and overlays["residual_mm"][1] < 5
assert answer.source().GetPointData().GetArray("target") is not None
assert from_vtp(matcher.file(job["id"], "aligned.vtp")).GetNumberOfPoints() == source.GetNumberOfPoints()

# Cancelling, and errors in words.
slow = matcher.submit(source, target, {"method": "metropolis", "inference": {"max_iterations": 100000}})
ended = matcher.wait(slow["id"], tell=lambda job: job["state"] != "running")
assert ended["state"] == "cancelled"
for wrong, word in [
    (lambda: matcher.answer(ended), "cancelled"),
    (lambda: matcher.submit(source, target, {"energy": {"alpha": -1}}), "must be from 0"),
    (lambda: matcher.submit(vtk.vtkPolyData(), target), "no faces"),
    (lambda: Matcher("http://127.0.0.1:9").job("x"), "cannot be reached"),
]:
    try:
        wrong()
        raise SystemExit(f"no error: {word}")
    except MatchingError as error:
        assert word in str(error), error
# The window is at least Python.
compile((Path(__file__).parent / "Homolog" / "Homolog.py").read_text(), "Homolog.py", "exec")
print("all of it")
