"""A connection to the service, running elsewhere or started from the program in this package."""

from __future__ import annotations

import atexit
import io
import os
import random
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import httpx

from ._client import AuthenticatedClient, Client
from ._client.models import ProblemDocument
from ._client.types import File, Response

PATIENCE_S = 300.0
"""How long a request is repeated while the service is busy, or cannot be reached although it was before, s."""
FIRST_PATIENCE_S = 5.0
"""How long a service that has not answered yet may be out of reach, s: a wrong address is said soon."""
_AGAIN = {429, 502, 503, 504}
# Ends the service when this process ends, however it does: the standard input of the shell closes with it.
_GUARD = '"$@" </dev/null & service=$!; exec >&-; cat >/dev/null; kill "$service" 2>/dev/null; wait "$service"'


class HomologError(Exception):
    """An answer that says what is wrong and what to do about it; ``problem`` has all that the service said."""

    def __init__(self, message: str, problem: dict[str, Any] | None = None) -> None:
        super().__init__(message)
        self.problem = problem or {}

    @property
    def code(self) -> str:
        """The stable name of the problem, such as ``invalid-parameters``."""
        return str(self.problem.get("type", "")).rsplit("/", 1)[-1]

    @staticmethod
    def of(problem: dict[str, Any]) -> HomologError:
        errors = problem.get("errors") or []
        faults = [f"{error.get('pointer', '')}: {error.get('detail', '')}" for error in errors]
        # Each thing once: the faults repeat what is the only one.
        detail = None if any(error.get("detail") == problem.get("detail") for error in errors) else problem.get("detail")
        return HomologError("; ".join(str(text) for text in [problem.get("title"), detail, *faults] if text), problem)


def program() -> str:
    """The path of the program: that of ``HOMOLOG_PROGRAM``, of this package, or on the ``PATH``."""
    name = "homolog.exe" if sys.platform == "win32" else "homolog"
    packaged = Path(__file__).parent / "bin" / name
    found = os.environ.get("HOMOLOG_PROGRAM") or (str(packaged) if packaged.exists() else shutil.which("homolog"))
    if not found:
        raise HomologError("this package holds no program for this machine; give HOMOLOG_URL of a running service")
    return found


class Service:
    """A connection to a service.

    ``Service("https://host", key="hml_…")`` connects to a running one. ``Service()`` starts one on a port of its own of this
    machine, for this process alone. Its files are temporary unless ``data_dir`` names a folder; ``settings`` are further
    options of ``homolog serve``, such as ``["--workers", "2"]``. ``timeout`` is the longest wait for one answer, s; a service that
    cannot be reached at all is an error after 5 s.
    """

    def __init__(self, url: str | None = None, key: str | None = None, *, data_dir: str | os.PathLike[str] | None = None,
                 settings: list[str] | None = None, timeout: float = 120.0) -> None:
        self._process: subprocess.Popen[str] | None = None
        self._folder: str | None = None
        self._answered = False
        if url is None:
            url = self._start(data_dir, settings or [])
        self.url = url.rstrip("/")
        limits = httpx.Timeout(timeout, connect=min(timeout, FIRST_PATIENCE_S))
        # A proxy of the environment is for other machines.
        trust: dict[str, Any] = {} if self._process is None else {"trust_env": False}
        self.client: Client | AuthenticatedClient = (
            AuthenticatedClient(self.url, key, timeout=limits, httpx_args=trust) if key
            else Client(self.url, timeout=limits, httpx_args=trust))

    def _start(self, data_dir: str | os.PathLike[str] | None, settings: list[str]) -> str:
        if data_dir is None:
            data_dir = self._folder = tempfile.mkdtemp(prefix="homolog-")
        command = [program(), "serve", "--listen", "127.0.0.1:0", "--data-dir", str(data_dir), "--log", "error", *settings]
        guard = ["/bin/sh", "-c", _GUARD, "homolog"] if os.name == "posix" else []
        environment = {name: value for name, value in os.environ.items() if not name.startswith("HOMOLOG_")}
        log = tempfile.TemporaryFile("w+")
        self._process = subprocess.Popen([*guard, *command], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=log,
                                         env=environment, text=True)
        atexit.register(self.close)
        assert self._process.stdout is not None
        for line in self._process.stdout:
            for word in line.split():
                if word.startswith("http://"):
                    return word
        log.seek(0)
        said = log.read().strip()[-1000:]
        self.close()
        raise HomologError(f"the service did not start: {said}")

    def close(self) -> None:
        """Ends the service if this object has started it."""
        process, self._process = self._process, None
        if process is not None:
            for pipe in (process.stdin, process.stdout):
                if pipe is not None:
                    pipe.close()
            if os.name != "posix":
                process.terminate()
            try:
                process.wait(30)
            except subprocess.TimeoutExpired:
                process.kill()
        if self._folder is not None:
            shutil.rmtree(self._folder, ignore_errors=True)
        atexit.unregister(self.close)

    def __repr__(self) -> str:
        return f"<homolog.Service {self.url}{', started by this process' if self._process else ''}>"

    def __enter__(self) -> Service:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def call(self, operation: Any, **arguments: Any) -> Any:
        """The parsed answer of a generated operation (a module of ``homolog._client.api``).

        Repeats it while the service is busy or cannot be reached. What creates something carries an idempotency key, so that
        a repetition creates nothing twice. An argument that can be read only once is given as a function that makes it.

        Raises HomologError with the problem that the service answers.
        """
        begun, pause = time.monotonic(), 0.5
        while True:
            made = {name: value.make() if isinstance(value, _Anew) else value for name, value in arguments.items()}
            try:
                response: Response[Any] = operation.sync_detailed(client=self.client, **made)
            except httpx.InvalidURL as error:
                raise HomologError(f"{self.url} is no address of a service: {error}") from error
            except (ValueError, KeyError, TypeError) as error:
                raise HomologError(f"what answers at {self.url} is no service of homolog: {error}") from error
            except httpx.TransportError as error:
                patience = PATIENCE_S if self._answered else FIRST_PATIENCE_S
                has_ended = self._process is not None and self._process.poll() is not None
                unsupported = isinstance(error, httpx.UnsupportedProtocol)
                if unsupported or has_ended or time.monotonic() + pause > begun + patience:
                    raise HomologError(f"the service at {self.url} cannot be reached: {error}") from error
                wait = pause
            else:
                self._answered = True
                status = int(response.status_code)
                if status < 400:
                    return response.parsed
                problem = response.parsed.to_dict() if isinstance(response.parsed, ProblemDocument) else {"status": status}
                if status not in _AGAIN or time.monotonic() > begun + PATIENCE_S:
                    raise HomologError.of(problem)
                wait = float(response.headers.get("retry-after", pause))
            time.sleep(wait * random.uniform(0.8, 1.2))
            pause = min(pause * 2, 10.0)


class _Anew:
    """Makes an argument anew for each attempt."""

    def __init__(self, make: Callable[[], Any]) -> None:
        self.make = make


def form(make: Callable[..., Any], files: dict[str, tuple[str, bytes]], **fields: Any) -> _Anew:
    """A form with these files, which is read anew for each attempt."""
    return _Anew(lambda: make(
        **{name: File(io.BytesIO(data), file_name, "application/octet-stream") for name, (file_name, data) in files.items()},
        **fields))
