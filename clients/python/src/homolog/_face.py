"""The functions that people call."""

from __future__ import annotations

import asyncio
import os
import threading
import uuid
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, Literal

from ._client.api.batches import get_batch, list_batch_jobs, submit_batch
from ._client.api.jobs import cancel_job, get_job, submit_job
from ._client.api.meshes import upload_mesh
from ._client.models import (
    BatchSubmissionDocument, JobDocument, MeshForm, SubjectDocument, SubmissionForm, TemplateSide,
)
from ._client.types import UNSET
from ._inputs import Surface, read
from ._match import Match, Study
from ._service import HomologError, Service, form

WAIT_S = 20
_default: Service | None = None
_lock = threading.Lock()


def default_service() -> Service:
    """The service of ``HOMOLOG_URL`` with the key ``HOMOLOG_KEY``, else one that is started now and ends with the process."""
    global _default
    with _lock:
        if _default is None:
            _default = Service(os.environ.get("HOMOLOG_URL") or None, os.environ.get("HOMOLOG_KEY") or None)
        return _default


def match(source: Surface, target: Surface, *, parameters: Mapping[str, Any] | None = None,
          labels: Mapping[str, str] | None = None, service: Service | None = None) -> Match:
    """Matches two surfaces: for each vertex of the source the corresponding point of the target.

    ``source`` and ``target``: paths, ``(vertices, faces)``, nibabel images, or meshes of trimesh, pyvista or meshio.
    ``parameters``: those that differ from the default, such as ``{"method": "rigid"}``.

    Raises HomologError if an input is refused or the job fails.
    """
    service = service or default_service()
    job = _submit(service, source, target, parameters, labels)
    return _finish(service, job)


async def match_async(source: Surface, target: Surface, *, parameters: Mapping[str, Any] | None = None,
                      labels: Mapping[str, str] | None = None, service: Service | None = None) -> Match:
    """The same as :func:`match` for ``async`` programs; cancelling the task cancels the job."""
    own = await asyncio.to_thread(default_service) if service is None else service
    submitted = asyncio.ensure_future(asyncio.to_thread(_submit, own, source, target, parameters, labels))
    try:
        return await asyncio.to_thread(_finish, own, await asyncio.shield(submitted))
    except asyncio.CancelledError:
        await asyncio.to_thread(_cancel, own, await submitted)
        raise


def study(template: Surface, subjects: Mapping[str, Surface] | Iterable[Surface], *,
          template_as: Literal["source", "target"] = "source", parameters: Mapping[str, Any] | None = None,
          labels: Mapping[str, str] | None = None, progress: bool = True, service: Service | None = None) -> Study:
    """Matches a template with many subjects: files by name, or a mapping from names to surfaces.

    With the template as source, the default, row i of every answer is vertex i of the template. Shows a progress bar if the
    package tqdm is installed. A subject whose job fails does not end the study; see ``table``.
    """
    service = service or default_service()
    named = dict(subjects) if isinstance(subjects, Mapping) else _named(subjects)
    bar = _bar(2 * len(named), progress)
    ids = {name: _upload(service, surface, bar) for name, surface in named.items()}
    body = BatchSubmissionDocument(
        template=_upload(service, template, None), template_as=TemplateSide(template_as), parameters=_members(parameters),
        labels=_members(labels), subjects=[SubjectDocument(mesh_id=mesh, external_ref=name[:200]) for name, mesh in ids.items()])
    batch = service.call(submit_batch, body=body, idempotency_key=str(uuid.uuid4()))
    done = 0
    while True:
        over = sum(n for state, n in batch.counts.additional_properties.items() if state not in ("queued", "running"))
        bar.update(over - done)
        done = over
        if batch.finished:
            break
        batch = service.call(get_batch, id=batch.id, wait=WAIT_S)
    bar.close()
    jobs: list[JobDocument] = []
    token: Any = UNSET
    while len(jobs) < len(named):
        page = service.call(list_batch_jobs, id=batch.id, page_size=500, page_token=token)
        jobs += page.jobs
        token = page.next_page_token
        if not token:
            break
    return Study(service, list(named), jobs)


async def study_async(template: Surface, subjects: Mapping[str, Surface] | Iterable[Surface], **options: Any) -> Study:
    """The same as :func:`study` for ``async`` programs."""
    return await asyncio.to_thread(study, template, subjects, **options)


def _submit(service: Service, source: Surface, target: Surface, parameters: Mapping[str, Any] | None,
            labels: Mapping[str, str] | None) -> JobDocument:
    files = {"source": read(source), "target": read(target)}
    body = form(SubmissionForm, files, parameters=_members(parameters), labels=_members(labels))
    job = service.call(submit_job, body=body, idempotency_key=str(uuid.uuid4()))
    assert isinstance(job, JobDocument)
    return job


def _finish(service: Service, job: JobDocument) -> Match:
    while job.state.value in ("queued", "running"):
        job = service.call(get_job, id=job.id, wait=WAIT_S)
    return Match(service, job)


def _cancel(service: Service, job: JobDocument) -> None:
    try:
        service.call(cancel_job, id=job.id)
    except HomologError:
        pass  # it has finished


def _upload(service: Service, surface: Surface, bar: Any) -> str:
    mesh = service.call(upload_mesh, body=form(MeshForm, {"file": read(surface)}))
    if bar is not None:
        bar.update(1)
    return str(mesh.id)


class _Members:
    """JSON members as they are: the generated classes would leave out unknown ones, which the service names instead."""

    def __init__(self, members: Mapping[str, Any]) -> None:
        self.members = dict(members)

    def to_dict(self) -> dict[str, Any]:
        return self.members


def _members(members: Mapping[str, Any] | None) -> Any:
    return _Members(members) if members else UNSET


def _named(surfaces: Iterable[Surface]) -> dict[str, Surface]:
    """Files under their names, anything else under its number."""
    named: dict[str, Surface] = {}
    for k, surface in enumerate(surfaces):
        name = Path(surface).name if isinstance(surface, (str, os.PathLike)) else f"subject-{k}"
        named[name if name not in named else f"{name}-{k}"] = surface
    return named


class _Silent:
    def update(self, n: int) -> None: ...
    def close(self) -> None: ...


def _bar(total: int, progress: bool) -> Any:
    if progress:
        try:
            from tqdm.auto import tqdm
        except ImportError:
            return _Silent()
        return tqdm(total=total, unit="step", desc="homolog")
    return _Silent()
