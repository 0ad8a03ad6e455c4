"""The functions that people call."""

from __future__ import annotations

import asyncio
import os
import re
import threading
import time
import uuid
import warnings
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, Literal, TypeAlias

from ._client.api.batches import get_batch, list_batch_jobs, submit_batch
from ._client.api.jobs import cancel_job, get_job, submit_job
from ._client.api.meshes import upload_mesh
from ._client.api.studies import get_study, submit_study
from ._client.models import BatchSubmissionDocument, JobDocument, MeshForm, StudySubmissionDocument
from ._client.models import SubjectDocument, SubmissionForm, SubmittedInputDocument, TemplateSide
from ._client.types import UNSET
from ._inputs import Surface, read
from ._match import Match, Matches, Study
from ._service import HomologError, Service, form

Side: TypeAlias = Literal["source", "target"]
Label: TypeAlias = Any
"""A number or a name, a list of these, or a mapping from ``source`` and ``target`` to them."""

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


def match(source: Surface, target: Surface, *, method: str | None = None, label: Label | None = None,
          mirror: Side | None = None, parameters: Mapping[str, Any] | None = None, tags: Mapping[str, str] | None = None,
          timeout: float | None = None, service: Service | None = None, labels: Mapping[str, str] | None = None) -> Match:
    """Matches two surfaces: for each vertex of the source the corresponding point of the target.

    ``source`` and ``target``: paths, ``(vertices, faces)``, nibabel images, or meshes of trimesh, pyvista or meshio.
    ``method``: a preset, such as ``"rigid"``. ``label``: the structure in label volumes, by number or name, as
    ``"hippocampus-left"``, or several; or one for each, ``{"source": 17, "target": 53}``. ``mirror``: the input that is
    mirrored, as to compare left with right. ``parameters``: others that differ from the default. ``tags``: words by which
    the job is found again (``labels`` up to 0.1). ``timeout``: the longest wait for the answer, s; then the job is cancelled.

    Raises HomologError if an input is refused, the job fails, or the time is over.
    """
    service = service or default_service()
    job = _submit(service, source, target, _asked(parameters, method, label, mirror), _tags(tags, labels))
    return _finish(service, job, timeout)


async def match_async(source: Surface, target: Surface, *, method: str | None = None, label: Label | None = None,
                      mirror: Side | None = None, parameters: Mapping[str, Any] | None = None,
                      tags: Mapping[str, str] | None = None, timeout: float | None = None,
                      service: Service | None = None, labels: Mapping[str, str] | None = None) -> Match:
    """The same as :func:`match` for ``async`` programs; cancelling the task cancels the job."""
    own = await asyncio.to_thread(default_service) if service is None else service
    asked = _asked(parameters, method, label, mirror)
    submitted = asyncio.ensure_future(asyncio.to_thread(_submit, own, source, target, asked, _tags(tags, labels)))
    try:
        return await asyncio.to_thread(_finish, own, await asyncio.shield(submitted), timeout)
    except asyncio.CancelledError:
        await asyncio.to_thread(_cancel, own, await submitted)
        raise


def match_many(template: Surface, subjects: Mapping[str, Surface] | Iterable[Surface], *, template_as: Side = "source",
               method: str | None = None, label: Label | None = None, mirror: Side | None = None,
               parameters: Mapping[str, Any] | None = None, tags: Mapping[str, str] | None = None, progress: bool = True,
               service: Service | None = None, labels: Mapping[str, str] | None = None) -> Matches:
    """Matches a template with many subjects: files by name, or a mapping from names to surfaces.

    With the template as source, the default, row i of every answer is vertex i of the template. Shows a progress bar if the
    package tqdm is installed. A subject that is refused, or whose job fails, does not end the others; see ``table``.
    """
    service = service or default_service()
    named = dict(subjects) if isinstance(subjects, Mapping) else _named(subjects)
    bar = _bar(2 * len(named), progress)
    ids, refused = _uploads(service, named, bar)
    own = _upload(service, template, None)
    asked, words = _members(_asked(parameters, method, label, mirror)), _tags(tags, labels)
    batch: Any = None
    while ids and batch is None:
        body = BatchSubmissionDocument(
            template=SubmittedInputDocument(mesh_id=own), template_as=TemplateSide(template_as), parameters=asked, tags=_members(words),
            subjects=[SubjectDocument(input_=SubmittedInputDocument(mesh_id=mesh), external_ref=name[:200])
                      for name, mesh in ids.items()])
        try:
            batch = service.call(submit_batch, body=body, idempotency_key=str(uuid.uuid4()))
        except HomologError as error:
            _leave_out(ids, refused, error, r"/subjects/(\d+)/input")
    jobs: list[JobDocument] = []
    if batch is not None:
        done = 0
        while True:
            over = sum(n for state, n in batch.counts.additional_properties.items() if state not in ("queued", "running"))
            bar.update(over - done)
            done = over
            if batch.finished:
                break
            batch = service.call(get_batch, id=batch.id, wait=WAIT_S)
        token: Any = UNSET
        while len(jobs) < len(ids):
            page = service.call(list_batch_jobs, id=batch.id, page_size=500, page_token=token)
            jobs += page.jobs
            token = page.next_page_token
            if not token:
                break
    bar.close()
    answers: dict[str, JobDocument | HomologError] = {**dict(zip(ids, jobs)), **refused}
    return Matches(service, list(named), [answers[name] for name in named])


async def match_many_async(template: Surface, subjects: Mapping[str, Surface] | Iterable[Surface], **options: Any) -> Matches:
    """The same as :func:`match_many` for ``async`` programs."""
    return await asyncio.to_thread(match_many, template, subjects, **options)


def study(subjects: Mapping[str, Surface] | Iterable[Surface], covariates: Any = None, *, effect: str | None = None,
          adjust: Iterable[str] = (), template: Surface | None = None, method: str | None = None, label: Label | None = None,
          parameters: Mapping[str, Any] | None = None, tags: Mapping[str, str] | None = None, progress: bool = True,
          service: Service | None = None, labels: Mapping[str, str] | None = None, **options: Any) -> Study:
    """A study of a group: a template, a shape model, statistics at every vertex, quality control and a report.

    ``subjects``: files by name, or a mapping from ids to surfaces. ``covariates``: a pandas ``DataFrame`` indexed by id, or a
    mapping from ids to mappings; of its columns ``side`` (left or right: the other side than the template is mirrored), ``label``
    (of its volume), ``subject`` (who it is, of several visits) and ``role`` have a meaning of their own. ``effect``: the covariate
    that is tested, ``adjust``: those that are adjusted for. Without ``template`` one is made from the group. ``options``: others, as ``permutations``, ``reference``, ``contrasts``, ``template_side``, ``cycles``. A subject that is refused is left out; see
    ``refused``.

    Raises HomologError if what is asked is refused, or the study fails.
    """
    service = service or default_service()
    named = {_stem(name): surface for name, surface in
             (subjects if isinstance(subjects, Mapping) else _named(subjects)).items()}
    rows = covariates.to_dict("index") if hasattr(covariates, "to_dict") and hasattr(covariates, "columns") else covariates or {}
    if unknown := [str(name) for name in named if rows and name not in rows]:
        raise ValueError(f"there are no covariates of {', '.join(unknown)}; their index has the ids of the subjects")
    bar = _bar(len(named), progress)
    ids, refused = _uploads(service, named, bar)
    bar.close()
    asked: dict[str, Any] = {**options, "parameters": _asked(parameters, method, label, None)}
    asked |= {name: value for name, value in [("effect", effect), ("adjust", list(adjust)), ("tags", _tags(tags, labels))] if value}
    if template is not None:
        asked["template"] = {"mesh_id": _upload(service, template, None)}
    document: Any = None
    while document is None:
        asked["subjects"] = [_subject(name, mesh, rows.get(name, {})) for name, mesh in ids.items()]
        try:
            document = service.call(submit_study, body=_StudyMembers(asked), idempotency_key=str(uuid.uuid4()))
        except HomologError as error:
            _leave_out(ids, refused, error, r"/subjects/(\d+)/input")
    while document.state.value not in ("finished", "failed", "cancelled"):
        document = service.call(get_study, id=document.id, wait=WAIT_S)
    return Study(service, document, refused)


async def study_async(subjects: Mapping[str, Surface] | Iterable[Surface], covariates: Any = None, **options: Any) -> Study:
    """The same as :func:`study` for ``async`` programs."""
    return await asyncio.to_thread(study, subjects, covariates, **options)


def _subject(name: str, mesh: str, row: Mapping[str, Any]) -> dict[str, Any]:
    """A subject of a study; missing values of tables are none."""
    values = {str(key): value.item() if hasattr(value, "item") else value for key, value in row.items()}
    values = {key: value for key, value in values.items() if value is not None and value == value}
    document: dict[str, Any] = {"id": name, "input": {"mesh_id": mesh}, "covariates": values}
    own = {"side": "side", "subject": "subject", "role": "role", "label": "labels"}
    return document | {member: values.pop(key) for key, member in own.items() if key in values}


def _stem(name: str) -> str:
    """An id: a file name up to its first dot."""
    return name.split(".")[0] or name


def _asked(parameters: Mapping[str, Any] | None, method: str | None, label: Label | None, mirror: Side | None) -> dict[str, Any]:
    """The parameters with what has an argument of its own."""
    asked = {**(parameters or {})}
    if method is not None:
        asked["method"] = method
    inputs = {**asked.get("input", {})}
    for side in ("source", "target"):
        own = {**inputs.get(side, {})}
        if isinstance(label, Mapping) and side in label:
            own["labels"] = label[side]
        if mirror == side:
            own["mirror"] = True
        if own:
            inputs[side] = own
    if label is not None and not isinstance(label, Mapping):
        inputs["labels"] = label
    if mirror not in (None, "source", "target"):
        raise ValueError(f"mirror must be 'source' or 'target', not {mirror!r}")
    return {**asked, "input": inputs} if inputs else asked


def _tags(tags: Mapping[str, str] | None, labels: Mapping[str, str] | None) -> Mapping[str, str] | None:
    """The tags, also under their name up to 0.1."""
    if labels is not None and tags is not None:
        raise TypeError("labels is the former name of tags; give tags only")
    if labels is not None:
        warnings.warn("labels= is now tags=; the former name goes with 0.3", DeprecationWarning, stacklevel=3)
    return tags if labels is None else labels


def _submit(service: Service, source: Surface, target: Surface, parameters: Mapping[str, Any] | None,
            tags: Mapping[str, str] | None) -> JobDocument:
    files = {"source": read(source), "target": read(target)}
    body = form(SubmissionForm, files, parameters=_members(parameters), tags=_members(tags))
    job = service.call(submit_job, body=body, idempotency_key=str(uuid.uuid4()))
    assert isinstance(job, JobDocument)
    return job


def _finish(service: Service, job: JobDocument, timeout: float | None) -> Match:
    ends = None if timeout is None else time.monotonic() + timeout
    while job.state.value in ("queued", "running"):
        left = WAIT_S if ends is None else ends - time.monotonic()
        if left <= 0:
            _cancel(service, job)
            raise HomologError(f"the match took more than {timeout:g} s and was cancelled (job {job.id})")
        job = service.call(get_job, id=job.id, wait=max(1, min(WAIT_S, int(left))))
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


def _uploads(service: Service, named: Mapping[str, Surface], bar: Any) -> tuple[dict[str, str], dict[str, HomologError]]:
    """The ids of the uploads by name, and why others were refused."""
    ids: dict[str, str] = {}
    refused: dict[str, HomologError] = {}
    for name, surface in named.items():
        try:
            ids[name] = _upload(service, surface, bar)
        except HomologError as error:
            if not error.problem:  # the service, not the file
                raise
            refused[name] = error
    return ids, refused


def _leave_out(ids: dict[str, str], refused: dict[str, HomologError], error: HomologError, pointer: str) -> None:
    """Takes the subjects to whose numbers faults point out of ``ids``; raises what is no fault of a subject."""
    names = list(ids)
    faults = [(re.fullmatch(pointer, str(fault.get("pointer"))), fault) for fault in error.problem.get("errors") or []]
    if not faults or not all(found for found, _ in faults):
        raise error
    for found, fault in faults:
        name = names[int(found[1])] if found else ""
        refused[name] = HomologError(str(fault.get("detail")), {"type": fault.get("code"), "detail": fault.get("detail")})
        ids.pop(name, None)


class _Members:
    """JSON members as they are: the generated classes would leave out unknown ones, which the service names instead."""

    def __init__(self, members: Mapping[str, Any]) -> None:
        self.members = dict(members)

    def to_dict(self) -> dict[str, Any]:
        return self.members


class _StudyMembers(_Members, StudySubmissionDocument):
    """Those of a study, in the class by which the generated call knows that it sends JSON."""


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
