"""What a program does with the models that datamodel-code-generator makes of the document: bodies are built and checked with them,
answers are read with them. Usage: models.py BASE SOURCE TARGET, with the generated module `models_made` beside it."""

import sys
import time

import httpx
import models_made as m
from pydantic import ValidationError

base, *paths = sys.argv[1:]
http = httpx.Client(base_url=base, timeout=60.0)


def answer(model, response, status=200):
    assert response.status_code == status, response.text
    return model.model_validate_json(response.content)


def finished(job):
    while job.state.value in ("queued", "running"):
        job = answer(m.JobDocument, http.get(f"/v1/jobs/{job.id}", params={"wait": 20}))
    return job


# The bounds of the service are those of the models.
for wrong in [{"energy": {"alpha": -1}}, {"inference": {"damping": 1}}, {"landmarks": [{"source_mm": [0], "target_mm": [0, 0, 0]}]},
              {"energy": {"alfa": 1}}, {"seed": -1}, {"inference": {"coarse_vertices": 8}}, {"features": []}]:
    try:
        m.PartialParameters.model_validate(wrong)
        raise SystemExit(f"{wrong} was accepted")
    except ValidationError:
        pass
    files = {"source": b"", "target": b""}
    response = http.post("/v1/jobs", files={name: (name, open(path, "rb")) for name, path in zip(files, paths)},
                         data={"parameters": __import__("json").dumps(wrong)})
    problem = answer(m.ProblemDocument, response, 422)
    assert problem.errors[0].pointer.startswith("/parameters"), problem

meshes = [answer(m.MeshDocument, http.post("/v1/meshes", content=open(path, "rb").read(),
                                           headers={"content-type": "application/octet-stream"}), 201) for path in paths]
body = m.SubmissionDocument(source={"mesh_id": meshes[0].id}, target={"mesh_id": meshes[1].id},
                            parameters=m.PartialParameters(method="rigid", seed=4))
job = finished(answer(m.JobDocument, http.post("/v1/jobs", json=body.model_dump(mode="json", exclude_unset=True)), 202))
assert job.state.value == "succeeded" and job.seed == 4 and job.parameters is None
job = answer(m.JobDocument, http.get(job.links.self, params={"fields": "*"}))
assert job.parameters.seed == 4
result = answer(m.JobResultDocument, http.get(job.links.result))
assert answer(m.Correspondences, http.get(job.links.correspondences)).source
assert answer(m.TransformDocument, http.get(job.links.transform)).matrix
batch = m.BatchSubmissionDocument(template={"mesh_id": meshes[1].id}, subjects=[{"input": {"mesh_id": meshes[0].id}}], parameters={"method": "rigid"})
batch = answer(m.BatchDocument, http.post("/v1/batches", json=batch.model_dump(mode="json", exclude_unset=True)), 202)
while not batch.finished:
    time.sleep(0.1)
    batch = answer(m.BatchDocument, http.get(batch.links.self))
assert answer(m.JobListDocument, http.get(batch.links.jobs)).jobs[0].links.batch == batch.links.self
hook = {"url": "http://127.0.0.1:9/", "states": ["succeeded"]}
hook = answer(m.WebhookDocument, http.post("/v1/webhooks", json=hook), 201)
assert answer(m.DeliveryDocument, http.post(hook.links.test), 202)
assert answer(m.MethodListDocument, http.get("/v1/methods")).methods[0].defaults.method.value == "balanced"
assert answer(m.ProblemDocument, http.post(job.links.self + "/cancel"), 409).type == "/problems/job-finished"
print("all of it")
