#!/usr/bin/env python3
"""Matches every segmentation that arrives in Orthanc to a template, and puts the answer back into its study.

For each new DICOM SEG instance, the bridge submits a job to homolog (source: the instance, target: the template). When the
job has succeeded it stores the DICOM Spatial Registration in Orthanc, in the study of the segmentation, with the HTML report
attached to it. What becomes of a segmentation is also in its metadata in Orthanc, under the number --metadata.

Either side may be restarted at any time, and so may the bridge. It follows Orthanc's list of changes from a position that it
keeps in --state; a job is submitted with an idempotency key made of the instance and the template, so that it exists once;
the registration of equal inputs has the same UID, so that it is stored once. Nothing but Python 3.8 or later is needed.

Passwords come from the environment: ORTHANC_USER and ORTHANC_PASSWORD, BRIDGE_API_KEY.
"""

import argparse
import base64
import hashlib
import json
import os
import signal
import sys
import time
import urllib.error
import urllib.request
import uuid
from pathlib import Path

SEGMENTATIONS = {"1.2.840.10008.5.1.4.1.1.66.4", "1.2.840.10008.5.1.4.1.1.66.7"}
ENDED = {"failed", "cancelled", "expired", "dead"}


class Refused(Exception):
    """An answer of 4xx: repeating the request does not help."""

    def __init__(self, status, body):
        super().__init__(f"status {status}")
        self.status = status
        try:
            self.problem = json.loads(body)
        except ValueError:
            self.problem = {}


class Server:
    def __init__(self, url, headers, timeout_s):
        self.url, self.headers, self.timeout_s = url.rstrip("/"), headers, timeout_s

    def send(self, method, path, body=None, headers=None):
        request = urllib.request.Request(self.url + path, body, {**self.headers, **(headers or {})}, method=method)
        try:
            with urllib.request.urlopen(request, timeout=self.timeout_s) as answer:
                return answer.read()
        except urllib.error.HTTPError as error:
            body = error.read()
            # Timeouts, a busy idempotency key and too many requests are temporary, so these requests are repeated.
            if 400 <= error.code < 500 and error.code not in (408, 409, 425, 429):
                raise Refused(error.code, body) from None
            raise OSError(f"{method} {path.split('?')[0]}: status {error.code}") from None

    def json(self, path):
        return json.loads(self.send("GET", path))


class State:
    """What must survive a restart, in one file that is replaced as a whole."""

    def __init__(self, path):
        self.path = path
        self.since, self.waiting, self.running = 0, [], {}
        if path.exists():
            stored = json.loads(path.read_text())
            self.since, self.waiting, self.running = stored["since"], stored["waiting"], stored["running"]

    def save(self):
        text = json.dumps({"since": self.since, "waiting": self.waiting, "running": self.running})
        unfinished = self.path.with_name(self.path.name + ".tmp")
        with open(unfinished, "w") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        os.replace(unfinished, self.path)


class Bridge:
    def __init__(self, orthanc, homolog, template, parameters, metadata, state):
        self.orthanc, self.homolog, self.state = orthanc, homolog, state
        self.template, self.parameters, self.metadata = template, parameters, metadata
        parts = hashlib.sha256(template.read_bytes() + b"\0" + json.dumps(parameters, sort_keys=True).encode())
        self.key = parts.hexdigest()[:32]

    def step(self):
        """One round. Returns whether there is more to do at once."""
        more = self.find()
        # An instance that fails again and again does not delay the others.
        for instance in list(self.state.waiting):
            self.attempt(self.submit, instance)
        for instance, job in list(self.state.running.items()):
            self.attempt(self.collect, instance, job)
        return more

    def attempt(self, work, *arguments):
        try:
            work(*arguments)
        except (OSError, ValueError, Refused) as error:
            complain(error)

    def find(self):
        """New segmentations, from where the last round ended."""
        if self.orthanc.json("/changes?last")["Last"] < self.state.since:
            # Orthanc has another database, whose changes are numbered from the start.
            self.state.since = 0
        page = self.orthanc.json(f"/changes?since={self.state.since}&limit=100")
        known = {*self.state.waiting, *self.state.running}
        for change in page["Changes"]:
            if change["ChangeType"] != "NewInstance" or change["ID"] in known:
                continue
            try:
                kind = self.orthanc.send("GET", f"/instances/{change['ID']}/metadata/SopClassUid").decode().strip()
            except Refused:
                continue  # deleted in the meantime
            if kind in SEGMENTATIONS:
                self.state.waiting.append(change["ID"])
        self.state.since = page["Last"]
        self.state.save()
        return not page["Done"]

    def submit(self, instance):
        try:
            segmentation = self.orthanc.send("GET", f"/instances/{instance}/file")
        except Refused:
            return self.forget(instance)
        boundary = uuid.uuid4().hex
        parts = [
            ("source", "source.dcm", "application/octet-stream", segmentation),
            ("target", "template" + "".join(self.template.suffixes[-2:]), "application/octet-stream", self.template.read_bytes()),
            ("parameters", None, "application/json", json.dumps(self.parameters).encode()),
            ("external_ref", None, "text/plain", instance.encode()),
        ]
        body = b"".join(
            b"--%s\r\nContent-Disposition: form-data; name=\"%s\"%s\r\nContent-Type: %s\r\n\r\n%s\r\n"
            % (
                boundary.encode(),
                name.encode(),
                b'; filename="%s"' % file_name.encode() if file_name else b"",
                kind.encode(),
                content,
            )
            for name, file_name, kind, content in parts
        )
        headers = {
            "Content-Type": f"multipart/form-data; boundary={boundary}",
            "Idempotency-Key": f"orthanc-{self.key}-{instance}",
        }
        try:
            job = json.loads(self.homolog.send("POST", "/v1/jobs", body + f"--{boundary}--\r\n".encode(), headers))
        except Refused as refused:
            if refused.status in (401, 403):
                raise OSError("homolog does not accept the API key") from None
            self.note(instance, f"refused by homolog: {refused.problem.get('detail') or refused.problem.get('title')}")
            return self.forget(instance)
        self.state.waiting.remove(instance)
        self.state.running[instance] = job["id"]
        self.state.save()
        say(f"job {job['id']} submitted")

    def collect(self, instance, job):
        try:
            document = self.homolog.json(f"/v1/jobs/{job}")
        except Refused:
            # The job no longer exists, for example because its database was lost, so it is submitted again.
            del self.state.running[instance]
            self.state.waiting.append(instance)
            return self.state.save()
        if document["state"] in ENDED:
            problem = document.get("error") or {}
            self.note(instance, f"homolog: the job is {document['state']}: {problem.get('detail') or problem.get('title')}")
            return self.forget(instance)
        if document["state"] != "succeeded":
            return
        try:
            registration = self.homolog.send("GET", f"/v1/jobs/{job}/transform?format=dicom")
            report = self.homolog.send("GET", f"/v1/jobs/{job}/report")
        except Refused as refused:
            self.note(instance, f"homolog: {refused.problem.get('detail') or refused.problem.get('title')}")
            return self.forget(instance)
        stored = json.loads(self.orthanc.send("POST", "/instances", registration))
        self.orthanc.send("PUT", f"/instances/{stored['ID']}/attachments/{self.metadata}", report)
        verdict = {True: "reliable", False: "not reliable"}.get(document.get("reliable"), "reliability not checked")
        reasons = ", ".join(document.get("unreliable_reasons") or [])
        self.note(instance, f"homolog: {verdict}{': ' + reasons if reasons else ''}; registration {stored['ID']}")
        self.forget(instance)
        say(f"job {job} is back in Orthanc")

    def note(self, instance, text):
        try:
            self.orthanc.send("PUT", f"/instances/{instance}/metadata/{self.metadata}", text.encode())
        except Refused:
            pass  # deleted in the meantime

    def forget(self, instance):
        self.state.running.pop(instance, None)
        if instance in self.state.waiting:
            self.state.waiting.remove(instance)
        self.state.save()


def complain(error, told=set()):
    """Says an error once a minute: while a side is away, every round has the same."""
    text = f"{error}; trying again"
    if (text, int(time.monotonic() / 60)) not in told:
        told.clear()
        told.add((text, int(time.monotonic() / 60)))
        say(text)


def say(text):
    print(f"homolog_bridge: {text}", file=sys.stderr, flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--orthanc", default="http://127.0.0.1:8042")
    parser.add_argument("--homolog", default="http://127.0.0.1:8080")
    parser.add_argument("--template", type=Path, required=True, help="target of every match: any file that homolog reads")
    parser.add_argument("--parameters", type=Path, help="JSON file with the parameters of the jobs")
    parser.add_argument("--state", type=Path, default=Path("homolog_bridge.json"), help="file that survives restarts")
    parser.add_argument("--metadata", type=int, default=1024, help="number of the metadata and of the attachment in Orthanc")
    parser.add_argument("--every-s", type=float, default=2.0, help="pause between rounds")
    parser.add_argument("--timeout-s", type=float, default=60.0, help="of one request")
    options = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(0))

    user, key = os.environ.get("ORTHANC_USER"), os.environ.get("BRIDGE_API_KEY")
    credentials = f"{user}:{os.environ.get('ORTHANC_PASSWORD', '')}".encode()
    orthanc = Server(
        options.orthanc,
        {"Authorization": "Basic " + base64.b64encode(credentials).decode()} if user else {},
        options.timeout_s,
    )
    homolog = Server(options.homolog, {"Authorization": f"Bearer {key}"} if key else {}, options.timeout_s)
    parameters = json.loads(options.parameters.read_text()) if options.parameters else {}
    bridge = Bridge(orthanc, homolog, options.template, parameters, options.metadata, State(options.state))
    while True:
        more = False
        try:
            more = bridge.step()
        except (OSError, ValueError, Refused) as error:
            # Orthanc or homolog does not answer, for example during a restart.
            complain(error)
        if not more:
            time.sleep(options.every_s)


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        pass
