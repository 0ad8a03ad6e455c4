"""What a program in Python does with the service, through the client that openapi-python-client makes of its document.

Usage: roundtrip.py BASE SOURCE TARGET, with the generated package `client` beside it.
"""

import io
import sys
from pathlib import Path

from client import Client
from client.api.batches import get_batch, list_batch_jobs, submit_batch
from client.api.jobs import cancel_job, follow_job, get_job, list_changes, list_jobs, submit_job
from client.api.meshes import upload_mesh
from client.api.results import (
    download_file, get_aligned, get_correspondences, get_report, get_result, get_surface, get_transform, get_warped,
)
from client.api.webhooks import create_webhook, delete_webhook, list_webhooks, update_webhook
from client.api.webhooks import test_webhook as send_test
from client.models import (
    BatchSubmissionDocument, JobDocument, JobState, MeshForm, Method, NewWebhookDocument, PartialEnergyParameters, PartialParameters,
    ProblemDocument, SubjectDocument, SubmissionDocument, SubmissionForm, SubmissionFormTags, SubmittedInputDocument, TemplateSide,
    ValidationDocument, WebhookChangeDocument,
)
from client.types import UNSET, File

base, source, target = sys.argv[1:]
client = Client(base, timeout=60.0)


def file(path):
    return File(io.BytesIO(Path(path).read_bytes()), Path(path).name, "application/octet-stream")


def finished(job):
    assert isinstance(job, JobDocument), job
    while job.state in (JobState.QUEUED, JobState.RUNNING):
        job = get_job.sync(client=client, id=job.id, wait=20)
    return job


# The form with nothing but the files: what the generated client sends by default is accepted.
plain = submit_job.sync_detailed(client=client, body=SubmissionForm(file(source), file(target)))
assert plain.status_code == 202 and plain.parsed.method == "balanced" and plain.parsed.parameters is UNSET, plain
cancel_job.sync_detailed(client=client, id=plain.parsed.id)

# And with everything.
parameters = PartialParameters(method=Method.RIGID, seed=3, energy=PartialEnergyParameters(alpha=2.0))
whole = SubmissionForm(file(source), file(target), parameters=parameters, priority=1, external_ref="a", use_cache=True,
                       max_run_s=600, tags=SubmissionFormTags.from_dict({"study": "py"}))
job = finished(submit_job.sync(client=client, body=whole))
job = get_job.sync(client=client, id=job.id, fields="*")
assert job.state == JobState.SUCCEEDED and job.parameters.energy.alpha == 2.0 and job.external_ref == "a", job
assert job.tags.additional_properties == {"study": "py"}, job

tried = submit_job.sync(client=client, body=SubmissionForm(file(source), file(target)), validate_only=True)
assert isinstance(tried, ValidationDocument), tried

# By reference, twice with one key.
ids = [upload_mesh.sync(client=client, body=MeshForm(file(path))).id for path in (source, target)]
by_id = SubmissionDocument(*(SubmittedInputDocument(mesh_id=mesh) for mesh in ids), parameters=PartialParameters(method=Method.RIGID))
first, again = (submit_job.sync(client=client, body=by_id, idempotency_key="py-1") for _ in range(2))
assert first.id == again.id and finished(first).state == JobState.SUCCEEDED

# The result, its parts, and every file.
result = get_result.sync(client=client, id=job.id)
assert len(result.transform.matrix) == 4 and len(result.correspondences.source) > 100
columns = get_correspondences.sync(client=client, id=job.id)
assert len(columns.source) == len(columns.target) == len(columns.confidence)
assert len(get_transform.sync(client=client, id=job.id).matrix) == 4
assert get_report.sync(client=client, id=job.id).startswith("<!doctype html>")
for surface in (get_aligned.sync(client=client, id=job.id), get_surface.sync(client=client, id=job.id, which="source")):
    assert surface.payload.read().startswith(b"ply"), surface
tables = ["json", "csv", "npy", "npz", "arrow", "parquet", "ply", "vtk", "vtp", "gifti", "glb"]
names = [f"correspondences.{ending}" for ending in tables]
names += [f"transform.{ending}" for ending in ("json", "text", "tfm", "lta")]
names += [f"{part}.{ending}" for part in ("source", "target", "aligned") for ending in ("ply", "vtk", "vtp", "gifti", "stl", "glb")]
for name in names + ["report.html"]:
    answer = download_file.sync_detailed(client=client, id=job.id, name=name)
    assert answer.status_code == 200 and len(answer.parsed.payload.read()) > 50, name
assert download_file.sync(client=client, id=job.id, name="correspondences.csv").payload.read().startswith(b"source,target,")
missing = download_file.sync(client=client, id=job.id, name="correspondences.doc")
assert isinstance(missing, ProblemDocument) and missing.status == 404

# A batch, with the template as source.
subjects = [SubjectDocument(input_=SubmittedInputDocument(mesh_id=ids[1]), external_ref="subject")]
body = BatchSubmissionDocument(template=SubmittedInputDocument(mesh_id=ids[0]), template_as=TemplateSide.SOURCE, subjects=subjects,
                               parameters=PartialParameters(method=Method.RIGID, seed=9))
batch = submit_batch.sync(client=client, body=body)
while not batch.finished:
    batch = get_batch.sync(client=client, id=batch.id, wait=20)
(member,) = list_batch_jobs.sync(client=client, id=batch.id).jobs
assert (member.source.hash_, member.target.hash_) == tuple(ids) and member.state == JobState.SUCCEEDED

# Errors and cancelling.
refused = cancel_job.sync(client=client, id=job.id)
assert isinstance(refused, ProblemDocument) and refused.type_ == "/problems/job-finished"
wrong = SubmissionForm(file(source), file(target), parameters=PartialParameters(energy=PartialEnergyParameters(alpha=-1.0)))
invalid = submit_job.sync(client=client, body=wrong)
assert invalid.errors[0].pointer == "/parameters/energy/alpha", invalid
slow = PartialParameters.from_dict({"method": "metropolis", "inference": {"max_iterations": 100_000}})
slow = submit_job.sync(client=client, body=SubmissionForm(file(source), file(target), parameters=slow, use_cache=False))
assert cancel_job.sync_detailed(client=client, id=slow.id).status_code == 202
assert finished(slow).state == JobState.CANCELLED

# Lists, changes, events.
assert list_jobs.sync(client=client, page_size=2).next_page_token
assert list_changes.sync(client=client).changes
assert "event: done" in follow_job.sync(client=client, id=job.id)

# Webhooks.
hook = create_webhook.sync(client=client, body=NewWebhookDocument(url="http://127.0.0.1:9/", states=[JobState.SUCCEEDED]))
assert hook.secret
assert update_webhook.sync(client=client, id=hook.id, body=WebhookChangeDocument(enabled=True)).enabled
assert send_test.sync_detailed(client=client, id=hook.id).status_code == 202
assert hook.id in [listed.id for listed in list_webhooks.sync(client=client).webhooks]
assert delete_webhook.sync_detailed(client=client, id=hook.id).status_code == 204
print("all of it")
