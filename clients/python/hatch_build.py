"""Adds to the wheel what is not in this folder: the client that is generated from the OpenAPI document, and the program.

HOMOLOG_PROGRAM names the program; without it the wheel holds none, runs anywhere, and needs a running service.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import sysconfig
import tempfile
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

GENERATOR = "openapi_python_client"


def platform_tag(program: bytes) -> str:
    """The tag of the platforms on which a program runs: on Linux those with the C library whose symbols it names."""
    if not program.startswith(b"\x7fELF"):
        return re.sub(r"[^a-z0-9]", "_", sysconfig.get_platform().lower())
    machine = {62: "x86_64", 183: "aarch64"}[int.from_bytes(program[18:20], "little")]
    versions = [(int(major), int(minor)) for major, minor in re.findall(rb"GLIBC_(\d+)\.(\d+)", program)]
    if not versions:
        raise SystemExit("the program names no symbols of the GNU C library; only programs for glibc can be packaged")
    major, minor = max(versions)
    return f"manylinux_{major}_{minor}_{machine}"


class Hook(BuildHookInterface):  # type: ignore[type-arg]
    """The build hook of hatchling."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Generates the client, and adds it and the program."""
        document = next(path for path in (Path(self.root, "openapi.json"), Path(self.root, "../../api/openapi.json"))
                        if path.exists())
        self.folder = tempfile.TemporaryDirectory()
        client = Path(self.folder.name, "_client")
        subprocess.run(
            [sys.executable, "-m", GENERATOR, "generate", "--path", str(document), "--meta", "none", "--output-path",
             str(client), "--config", str(Path(self.root, "generator.yaml"))],
            check=True, stdout=subprocess.DEVNULL)
        build_data["force_include"][str(client)] = "homolog/_client"
        program = os.environ.get("HOMOLOG_PROGRAM")
        if program:
            data = Path(program).read_bytes()
            name = "homolog.exe" if data.startswith(b"MZ") else "homolog"
            build_data["force_include"][program] = f"homolog/bin/{name}"
            build_data["pure_python"] = False
            build_data["tag"] = f"py3-none-{platform_tag(data)}"

    def finalize(self, version: str, build_data: dict[str, Any], artifact_path: str) -> None:
        """Removes the generated client."""
        self.folder.cleanup()
