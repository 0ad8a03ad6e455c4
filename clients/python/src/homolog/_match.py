"""Answers: a match, a mesh, and a study of many matches."""

from __future__ import annotations

import io
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pandas as pd

from ._client.api.results import download_file, get_result
from ._client.models import JobDocument
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
    def transform(self) -> Floats:
        """The rigid transform from source to target, 4 × 4, mm."""
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
        """The source bent onto the target, with the deformation at each vertex."""
        return self.mesh("warped")

    def mesh(self, name: str) -> Mesh:
        """``source``, ``target``, ``aligned`` (the source moved rigidly), ``warped`` or ``warped-inverse``."""
        return Mesh(*read_ply(self.file(f"{name}.ply")))

    def file(self, name: str) -> bytes:
        """A part of the result in a format, such as ``warped.vtk`` or ``correspondences.parquet``."""
        return bytes(self.service.call(download_file, id=self.id, name=name).payload.read())

    def save(self, folder: str | Path, *names: str) -> list[Path]:
        """Writes files into a folder, which is made if it is missing; by default what most people open next."""
        Path(folder).mkdir(parents=True, exist_ok=True)
        written = []
        for name in names or ("warped.ply", "correspondences.csv", "transform.tfm", "report.html"):
            written.append(Path(folder) / name)
            written[-1].write_bytes(self.file(name))
        return written


class Study:
    """The matches of a study in the order of its subjects; that of a job that failed is ``None``."""

    def __init__(self, service: Service, names: list[str], jobs: list[JobDocument]) -> None:
        self.names, self.jobs = names, jobs
        self.matches = [Match(service, job) if job.state.value == "succeeded" else None for job in jobs]

    def __len__(self) -> int:
        return len(self.matches)

    def __iter__(self) -> Iterator[Match | None]:
        return iter(self.matches)

    def __getitem__(self, which: int | str) -> Match | None:
        return self.matches[self.names.index(which) if isinstance(which, str) else which]

    @cached_property
    def table(self) -> pd.DataFrame:
        """A row for each subject: its state, whether the answer is reliable and why not, distance between the surfaces, mm."""
        rows = []
        for name, job in zip(self.names, self.jobs):
            distance = job.surface_distance.to_dict() if job.surface_distance else {}
            reasons = ", ".join(reason.value for reason in job.unreliable_reasons or [])
            error = HomologError.of(job.error.to_dict()) if job.error else ""
            rows.append({"subject": name, "job": job.id, "state": job.state.value, "reliable": job.reliable,
                         "reasons": reasons, **distance, "error": str(error)})
        return pd.DataFrame(rows).set_index("subject")

    @cached_property
    def points(self) -> Floats:
        """Corresponding points of all subjects, mm: subjects × vertices of the template × 3; NaN for a subject that failed.

        For studies with the template as source, where the rows of every answer are the vertices of the template.
        """
        found = [None if match is None else match.warped.vertices for match in self.matches]
        sizes = {len(points) for points in found if points is not None}
        if len(sizes) != 1:
            raise HomologError("the answers have different vertices; pass template_as='source', which makes them comparable")
        (n,) = sizes
        return np.stack([np.full((n, 3), np.nan) if points is None else points for points in found])
