"""What the module does, without its window: surfaces to the service, answers back as VTK objects. Needs VTK and the standard library.

Surfaces are vtkPolyData in the coordinates of the scene (RAS, mm), and so are the answers.
"""

import json
import time
import urllib.error
import urllib.request
import uuid

import vtk

FINAL = {"succeeded", "failed", "cancelled", "expired", "dead"}
# Further numbers at each vertex of the warped source, for which a color map is of use.
OVERLAYS = ["displacement_normal_mm", "residual_mm", "area_ratio", "confidence", "spread_mm"]


class MatchingError(Exception):
    """What the service says is wrong, for people."""


def to_bytes(surface):
    """A surface as a legacy VTK file: triangles, points in double precision, no other data."""
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputData(surface)
    triangles.PassLinesOff()
    triangles.PassVertsOff()
    triangles.Update()
    bare = vtk.vtkPolyData()
    bare.SetPoints(triangles.GetOutput().GetPoints())
    bare.SetPolys(triangles.GetOutput().GetPolys())
    if bare.GetNumberOfPolys() == 0:
        raise MatchingError("the surface has no faces; show the segment in 3D, or choose another model")
    writer = vtk.vtkPolyDataWriter()
    writer.SetInputData(bare)
    writer.SetFileTypeToBinary()
    # The newest version of the format is not read by older programs.
    writer.SetFileVersion(42)
    writer.WriteToOutputStringOn()
    writer.Write()
    return bytes(writer.GetOutputStdString(), "latin-1") if isinstance(writer.GetOutputStdString(), str) else bytes(
        writer.GetOutputStdString())


def from_vtp(data):
    """The surface of a VTP file with its values."""
    reader = vtk.vtkXMLPolyDataReader()
    reader.ReadFromInputStringOn()
    reader.SetInputString(data.decode("latin-1"))
    reader.Update()
    return reader.GetOutput()


class Matcher:
    """A service, and what is asked of it."""

    def __init__(self, url, key=""):
        self.url = url.rstrip("/")
        self.headers = {"Authorization": f"Bearer {key}"} if key else {}

    def _call(self, path, body=None, headers=None, timeout_s=60.0, method=None):
        headers = {**self.headers, **(headers or {})}
        request = urllib.request.Request(self.url + path, data=body, headers=headers, method=method)
        try:
            with urllib.request.urlopen(request, timeout=timeout_s) as answer:
                return answer.read()
        except urllib.error.HTTPError as error:
            try:
                problem = json.loads(error.read())
            except ValueError:
                problem = {}
            faults = [fault["detail"] for fault in problem.get("errors") or []]
            said = [problem.get("title", f"the service answered {error.code}"), problem.get("detail"), *faults]
            raise MatchingError("; ".join(text for text in said if text)) from None
        except OSError as error:
            raise MatchingError(f"the service at {self.url} cannot be reached: {error}") from None

    def submit(self, source, target, parameters=None):
        """Submits two surfaces; the job. A request whose answer was lost is sent again and creates nothing twice."""
        boundary = uuid.uuid4().hex
        parts = []
        for name, data in (("source", to_bytes(source)), ("target", to_bytes(target))):
            parts.append(f'--{boundary}\r\nContent-Disposition: form-data; name="{name}"; filename="{name}.vtk"\r\n\r\n'.encode())
            parts += [data, b"\r\n"]
        text = json.dumps(parameters or {})
        parts.append(f'--{boundary}\r\nContent-Disposition: form-data; name="parameters"\r\n\r\n{text}\r\n'.encode())
        parts.append(f"--{boundary}--\r\n".encode())
        headers = {"Content-Type": f"multipart/form-data; boundary={boundary}", "Idempotency-Key": str(uuid.uuid4())}
        for attempt in (1, 2, 3):
            try:
                return json.loads(self._call("/v1/jobs", b"".join(parts), headers))
            except MatchingError as error:
                if attempt == 3 or "cannot be reached" not in str(error):
                    raise
                time.sleep(attempt)

    def job(self, job_id):
        """The job as it is now."""
        return json.loads(self._call(f"/v1/jobs/{job_id}"))

    def wait(self, job_id, tell=None, pause_s=0.5):
        """The job once it has finished; ``tell`` is called with it meanwhile, and stops the job by returning False."""
        while True:
            job = self.job(job_id)
            goes_on = tell is None or tell(job) is not False
            if job["state"] in FINAL:
                return job
            if not goes_on:
                self.cancel(job_id)
                tell = None
            time.sleep(pause_s)

    def cancel(self, job_id):
        """Cancels a job; nothing if it has finished."""
        try:
            self._call(f"/v1/jobs/{job_id}/cancel", b"", method="POST")
        except MatchingError:
            pass

    def answer(self, job):
        """The answer of a succeeded job."""
        if job["state"] != "succeeded":
            error = job.get("error") or {}
            raise MatchingError(error.get("detail") or error.get("title") or f"the job ended as {job['state']}")
        return Answer(self, job)

    def file(self, job_id, name):
        """A part of a result in a format."""
        return self._call(f"/v1/jobs/{job_id}/files/{name}")


class Answer:
    """What the scene shows of a match."""

    def __init__(self, matcher, job):
        self.job, self._matcher = job, matcher

    def verdict(self):
        """One sentence."""
        if self.job["reliable"] is None:
            return "This method gives no verdict."
        reasons = ", ".join(self.job.get("unreliable_reasons") or [])
        return "The answer is reliable." if self.job["reliable"] else f"The answer is not reliable: {reasons}."

    def transform(self):
        """The rigid transform from source to target, vtkMatrix4x4 in RAS."""
        rows = json.loads(self._matcher.file(self.job["id"], "transform.json"))["matrix"]
        matrix = vtk.vtkMatrix4x4()
        for i, row in enumerate(rows):
            for k, value in enumerate(row):
                matrix.SetElement(i, k, value)
        return matrix

    def warped(self):
        """The source deformed onto the target, with the deformation at each point."""
        return from_vtp(self._matcher.file(self.job["id"], "warped.vtp"))

    def source(self):
        """The source with the correspondences at each point."""
        return from_vtp(self._matcher.file(self.job["id"], "correspondences.vtp"))

    @staticmethod
    def overlays(surface):
        """Names and ranges of the values of a surface that can be shown in color."""
        found = {}
        for name in OVERLAYS:
            values = surface.GetPointData().GetArray(name)
            if values is not None:
                found[name] = values.GetRange()
        return found
