"""Answers: a match, a mesh, many matches, and a study of a group."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pandas as pd

from ._client.api.jobs import get_trace
from ._client.api.results import download_file, get_result
from ._client.api.studies import get_study_archive
from ._client.models import JobDocument, StudyDocument
from ._inputs import Floats, Integers, read_ply
from ._service import HomologError, Service

_OUTLIERS = ["none", "residual", "neighborhood", "both", "no_counterpart"]


@dataclass(frozen=True)
class Mesh:
    """A triangle mesh, mm."""

    vertices: Floats
    faces: Integers
    values: Mapping[str, npt.NDArray[Any]] = field(default_factory=dict)
    """Further numbers at each vertex, by name."""

    def __repr__(self) -> str:
        values = f", values {', '.join(self.values)}" if self.values else ""
        return f"<homolog.Mesh {len(self.vertices)} vertices, {len(self.faces)} triangles{values}>"

    def to_pyvista(self) -> Any:
        """The same as a ``pyvista.PolyData``, with the values as arrays of its points."""
        import pyvista

        mesh = pyvista.PolyData.from_regular_faces(self.vertices, self.faces)
        for name, values in self.values.items():
            mesh.point_data[name] = values
        return mesh

    def to_trimesh(self) -> Any:
        """The same as a ``trimesh.Trimesh``, with the same order of vertices."""
        import trimesh

        return trimesh.Trimesh(self.vertices, self.faces, process=False, vertex_attributes=dict(self.values))


class Match:
    """A succeeded match. Everything is read from the service when it is first asked for."""

    def __init__(self, service: Service, job: JobDocument) -> None:
        self.service = service
        self.job = job
        self.id = job.id
        if job.state.value != "succeeded":
            error = job.error.to_dict() if job.error else {"title": f"the job ended as {job.state.value}"}
            raise HomologError.of(error)

    def __repr__(self) -> str:
        verdict = {True: "reliable", False: "not reliable: " + ", ".join(self.reasons), None: "no verdict"}[self.reliable]
        return f"<homolog.Match {self.id}, {verdict}>"

    @property
    def reliable(self) -> bool | None:
        """Whether the answer can be relied on; ``None`` for methods that give no verdict."""
        return self.job.reliable if isinstance(self.job.reliable, bool) else None

    @property
    def reasons(self) -> list[str]:
        """Why it cannot be relied on."""
        return [reason.value for reason in self.job.unreliable_reasons or []]

    @cached_property
    def result(self) -> dict[str, Any]:
        """The result document, without the correspondences."""
        return dict(self.service.call(get_result, id=self.id, correspondences=False).to_dict())

    @property
    def energy(self) -> dict[str, float] | None:
        """The energies of the answer, ``final`` and ``per_variable`` among them; ``None`` for methods that minimize none."""
        return self.result.get("energy")

    @cached_property
    def trace(self) -> pd.DataFrame:
        """The energy trace, a row for each point: ``quantity``, ``phase``, ``round``, ``start``, ``iteration``, ``energy``, ``chosen``.

        Only points of equal quantity, round and start are one series."""
        rows: list[dict[str, Any]] = []
        after = 0
        while True:
            page = self.service.call(get_trace, id=self.id, after_seq=after, limit=10_000).to_dict()
            rows += page["points"]
            if page["complete"] and page["next_after_seq"] == after:
                return pd.DataFrame(rows)
            after = page["next_after_seq"]

    @property
    def transform(self) -> Floats:
        """The rigid transform from source to target, 4 × 4, mm; with a reflection if an input was mirrored."""
        return np.loadtxt(io.BytesIO(self.file("transform.text"))).reshape(4, 4)

    @cached_property
    def correspondences(self) -> pd.DataFrame:
        """A row for each corresponding pair: ``source`` and ``target`` vertex, ``confidence``, the point between vertices."""
        columns: dict[str, Any] = {}
        with np.load(io.BytesIO(self.file("correspondences.npz"))) as arrays:
            for name, values in arrays.items():
                columns.update({name: values} if values.ndim == 1 else {f"{name}_{k}": v for k, v in enumerate(values.T)})
        columns["outlier"] = pd.Categorical.from_codes(columns["outlier"], categories=_OUTLIERS)
        return pd.DataFrame(columns)

    def table(self) -> Any:
        """The correspondences as a ``pyarrow.Table``."""
        import pyarrow

        with pyarrow.ipc.open_file(self.file("correspondences.arrow")) as reader:
            return reader.read_all()

    @cached_property
    def warped(self) -> Mesh:
        """The source deformed onto the target, with the deformation at each vertex."""
        return self.mesh("warped")

    def mesh(self, name: str) -> Mesh:
        """``source``, ``target``, ``aligned`` (the source moved rigidly), ``warped`` or ``warped-inverse``."""
        return Mesh(*read_ply(self.file(f"{name}.ply")))

    def file(self, name: str) -> bytes:
        """A part of the result in a format, such as ``warped.vtk`` or ``correspondences.parquet``."""
        return bytes(self.service.call(download_file, id=self.id, name=name).payload.read())

    def plot(self, color: str = "correspondence", *, show: bool = True, **options: Any) -> Any:
        """Both surfaces side by side, turned together, with pyvista: the source moved rigidly onto the target, and the target.

        ``color``: ``"correspondence"`` (corresponding points have one color), or a member of ``warped.values``, such as ``"confidence"``.
        ``show``: opens the window, or draws in a notebook. ``options`` go to ``pyvista.Plotter``, such as ``off_screen=True``.
        """
        import pyvista

        source, target, warped = self.mesh("aligned"), self.mesh("target"), self.warped
        if color != "correspondence" and color not in warped.values:
            raise ValueError(f"color must be correspondence or one of {', '.join(warped.values)}, not {color!r}")
        plotter = pyvista.Plotter(shape=(1, 2), **options)
        verdict = {True: "reliable", False: "not reliable: " + ", ".join(self.reasons), None: "no verdict"}[self.reliable]
        if color == "correspondence":
            low, high = target.vertices.min(axis=0), target.vertices.max(axis=0)
            scale = np.where(high > low, high - low, 1.0)
            sides = [(source, np.clip((warped.vertices - low) / scale, 0, 1)), (target, (target.vertices - low) / scale)]
            drawn: list[tuple[Any, dict[str, Any]]] = [
                (mesh.to_pyvista(), {"scalars": np.round(255 * values).astype(np.uint8), "rgb": True}) for mesh, values in sides]
        else:
            drawn = [(source.to_pyvista(), {"scalars": warped.values[color], "scalar_bar_args": {"title": color}}),
                     (target.to_pyvista(), {"color": "lightgray"})]
        for side, (title, (mesh, look)) in enumerate(zip(("source, moved rigidly", "target"), drawn)):
            plotter.subplot(0, side)
            plotter.add_mesh(mesh, **look)
            plotter.add_text(f"{title}\n{verdict}" if side == 0 else title, font_size=9)
        plotter.link_views()
        if show:
            plotter.show()
        return plotter

    def save(self, folder: str | Path, *names: str) -> list[Path]:
        """Writes files into a folder, which is made if it is missing; by default what most people open next."""
        Path(folder).mkdir(parents=True, exist_ok=True)
        written = []
        for name in names or ("warped.ply", "correspondences.csv", "transform.tfm", "report.html"):
            written.append(Path(folder) / name)
            written[-1].write_bytes(self.file(name))
        return written


class Matches:
    """The matches of a template with many subjects, in their order; that of a subject without one is ``None``."""

    def __init__(self, service: Service, names: list[str], jobs: list[JobDocument | HomologError]) -> None:
        self.names, self.jobs = names, jobs
        self.matches = [
            Match(service, job) if isinstance(job, JobDocument) and job.state.value == "succeeded" else None for job in jobs]

    def __repr__(self) -> str:
        matched = [match for match in self.matches if match is not None]
        reliable = sum(match.reliable is True for match in matched)
        return f"<homolog.Matches of {len(self)} subjects, {len(matched)} matched, {reliable} reliable>"

    def __len__(self) -> int:
        return len(self.matches)

    def __iter__(self) -> Iterator[Match | None]:
        return iter(self.matches)

    def __getitem__(self, which: int | str) -> Match | None:
        return self.matches[self.names.index(which) if isinstance(which, str) else which]

    @cached_property
    def table(self) -> pd.DataFrame:
        """A row for each subject: its state, whether the answer is reliable and why not, distance between the surfaces, mm, and the
        error of one that was refused or failed."""
        rows: list[dict[str, Any]] = []
        for name, job in zip(self.names, self.jobs):
            if isinstance(job, HomologError):
                rows.append({"subject": name, "state": "refused", "error": str(job)})
                continue
            distance = job.surface_distance.to_dict() if job.surface_distance else {}
            reasons = ", ".join(reason.value for reason in job.unreliable_reasons or [])
            error = HomologError.of(job.error.to_dict()) if job.error else ""
            rows.append({"subject": name, "job": job.id, "state": job.state.value, "reliable": job.reliable,
                         "reasons": reasons, **distance, "error": str(error)})
        return pd.DataFrame(rows).set_index("subject")

    @cached_property
    def points(self) -> Floats:
        """Corresponding points of all subjects, mm: subjects × vertices of the template × 3; NaN for a subject that failed.

        For a template as source, where the rows of every answer are the vertices of the template.
        """
        found = [None if match is None else match.warped.vertices for match in self.matches]
        sizes = {len(points) for points in found if points is not None}
        if len(sizes) != 1:
            raise HomologError("the answers have different vertices; pass template_as='source', which makes them comparable")
        (n,) = sizes
        return np.stack([np.full((n, 3), np.nan) if points is None else points for points in found])


class Study:
    """A study of a group that is finished: figures, tables, the report and every file of its archive."""

    def __init__(self, service: Service, document: StudyDocument, refused: Mapping[str, HomologError]) -> None:
        self.service, self.document, self.id = service, document, document.id
        self.refused = dict(refused)
        """Subjects whose files were refused, which are no part of it, with the reason."""
        if document.state.value != "finished":
            error = document.error.to_dict() if document.error else {"title": f"the study ended as {document.state.value}"}
            raise HomologError.of(error)

    def __repr__(self) -> str:
        left_out = f", {len(self.refused)} refused" if self.refused else ""
        return f"<homolog.Study {self.id}, {self.document.n_subjects} subjects{left_out}>"

    @cached_property
    def archive(self) -> zipfile.ZipFile:
        """Everything that was found, as files."""
        return zipfile.ZipFile(io.BytesIO(self.service.call(get_study_archive, id=self.id).payload.read()))

    @cached_property
    def table(self) -> pd.DataFrame:
        """A row for each subject: covariates, volume, area, residual, distance from the group, scores; refused ones with ``error``."""
        table = self._csv("subjects.csv").set_index("id")
        if self.refused:
            errors = pd.Series({name: str(error) for name, error in self.refused.items()}, name="error")
            table = table.reindex([*table.index, *errors.index]).join(errors)
        return table

    @cached_property
    def effects(self) -> pd.DataFrame:
        """Effects in volume, area, size and labels, with intervals."""
        return self._csv("effects.csv")

    @cached_property
    def quality(self) -> pd.DataFrame:
        """What is to be looked at first, and why."""
        return self._csv("quality.csv")

    @property
    def report(self) -> str:
        """The report, one HTML page that loads nothing."""
        return self.archive.read("report.html").decode()

    def save(self, folder: str | Path) -> Path:
        """Writes everything that was found into a folder; begin with ``report.html``."""
        self.archive.extractall(folder)
        return Path(folder)

    def _csv(self, name: str) -> pd.DataFrame:
        return pd.read_csv(io.BytesIO(self.archive.read(name)))
