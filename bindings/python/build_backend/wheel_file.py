"""Writes wheels and source distributions. The same files give the same bytes."""

from __future__ import annotations

import base64
import gzip
import hashlib
import io
import sysconfig
import tarfile
import zipfile
from pathlib import Path
from typing import Any

EARLIEST = (1980, 1, 1, 0, 0, 0)  # The first date that ZIP files can hold.


def tag() -> str:
    """Interpreter, its binary interface, and the machine: cp311-cp311-linux_x86_64."""
    python = "cp" + sysconfig.get_config_var("py_version_nodot")
    machine = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    return f"{python}-{python}-{machine}"


def info_folder(project: dict[str, Any]) -> str:
    return f"{project['name']}-{project['version']}.dist-info"


def metadata(project: dict[str, Any], readme: str) -> str:
    """METADATA, version 2.1."""
    lines = ["Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {project['version']}"]
    lines += [f"Summary: {project['description']}", "License: MIT", "Classifier: License :: OSI Approved :: MIT License"]
    lines += ["Classifier: Operating System :: POSIX :: Linux", "Classifier: Typing :: Typed"]
    lines += [f"Requires-Python: {project['requires-python']}"]
    lines += [f"Requires-Dist: {needed}" for needed in project["dependencies"]]
    for extra, packages in project["optional-dependencies"].items():
        lines += [f"Provides-Extra: {extra}"]
        lines += [f'Requires-Dist: {needed}; extra == "{extra}"' for needed in packages]
    return "\n".join([*lines, "License-File: LICENSE", "License-File: THIRD-PARTY-NOTICES.txt"]) + (
        "\nDescription-Content-Type: text/markdown\n\n" + readme
    )


def wheel_text() -> str:
    """The file WHEEL."""
    return f"Wheel-Version: 1.0\nGenerator: muster build_backend\nRoot-Is-Purelib: false\nTag: {tag()}\n"


def digest(content: bytes) -> str:
    return "sha256=" + base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()


def write_wheel(directory: Path, project: dict[str, Any], files: dict[str, bytes]) -> str:
    """Packs the files and their RECORD; gives the name of the wheel."""
    name = f"{project['name']}-{project['version']}-{tag()}.whl"
    record = f"{info_folder(project)}/RECORD"
    lines = [f"{path},{digest(content)},{len(content)}" for path, content in files.items()] + [f"{record},,"]
    with zipfile.ZipFile(directory / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, content in [*files.items(), (record, ("\n".join(lines) + "\n").encode())]:
            entry = zipfile.ZipInfo(path, EARLIEST)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if path.endswith(".so") else 0o644) << 16
            wheel.writestr(entry, content)
    return name


def write_sdist(directory: Path, project: dict[str, Any], root: Path, files: list[Path], pyproject: str, info: str) -> str:
    """Packs files of the tree, a pyproject.toml of the whole and PKG-INFO; gives the name of the archive."""
    top = f"{project['name']}-{project['version']}"
    contents = {str(path.relative_to(root)): path.read_bytes() for path in files}
    contents |= {"pyproject.toml": pyproject.encode(), "PKG-INFO": info.encode()}
    with open(directory / f"{top}.tar.gz", "wb") as out, gzip.GzipFile("", "wb", fileobj=out, mtime=0) as packed:
        with tarfile.open(fileobj=packed, mode="w", format=tarfile.PAX_FORMAT) as archive:
            for path, content in sorted(contents.items()):
                entry = tarfile.TarInfo(f"{top}/{path}")
                entry.size = len(content)
                archive.addfile(entry, io.BytesIO(content))
    return f"{top}.tar.gz"
