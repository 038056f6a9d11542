"""Wheels and source distributions, as the build backend makes them."""

from __future__ import annotations

import base64
import csv
import hashlib
import io
import os
import re
import subprocess
import sys
import tarfile
import zipfile
from email.parser import Parser
from pathlib import Path

import pytest
from conftest import ROOT

sys.path.insert(0, str(ROOT / "bindings/python/build_backend"))
import backend  # noqa: E402


@pytest.fixture(scope="module")
def wheel(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("wheel")
    return folder / backend.build_wheel(str(folder), {"build-dir": os.environ["MUSTER_BUILD_DIR"]})


def test_the_wheels_name_and_tags(wheel: Path) -> None:
    version = f"cp{sys.version_info.major}{sys.version_info.minor}"
    assert wheel.name == f"muster-{backend.project()['version']}-{version}-{version}-linux_{os.uname().machine}.whl"
    with zipfile.ZipFile(wheel) as packed:
        text = packed.read(f"{backend.wheel_file.info_folder(backend.project())}/WHEEL").decode()
    assert f"Tag: {version}-{version}-linux_{os.uname().machine}" in text and "Root-Is-Purelib: false" in text


def test_the_record_holds_every_file(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as packed:
        assert packed.testzip() is None
        [record] = [name for name in packed.namelist() if name.endswith(".dist-info/RECORD")]
        rows = {path: (hash, size) for path, hash, size in csv.reader(io.StringIO(packed.read(record).decode()))}
        assert set(rows) == set(packed.namelist()) and rows[record] == ("", "")
        for name in set(rows) - {record}:
            content = packed.read(name)
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            assert rows[name] == (f"sha256={digest}", str(len(content))), name


def test_what_the_wheel_holds(wheel: Path, measured) -> None:
    with zipfile.ZipFile(wheel) as packed:
        names = set(packed.namelist())
        info = backend.wheel_file.info_folder(backend.project())
        metadata = Parser().parsestr(packed.read(f"{info}/METADATA").decode())
        notices = packed.read(f"{info}/THIRD-PARTY-NOTICES.txt").decode()
        licence = packed.read(f"{info}/LICENSE").decode()
    assert {"muster/__init__.py", "muster/_types.py", "muster/_core.pyi", "muster/py.typed"} <= names
    assert any(name.startswith("muster/_core.") and name.endswith(".so") for name in names)
    assert not any("__pycache__" in name for name in names)
    assert metadata["Metadata-Version"] == "2.1" and metadata["Name"] == "muster" and metadata.get_all("Requires-Dist")[0] == "numpy"
    assert "MIT License" in licence
    for other in ("Eigen", "Niels Lohmann", "Wenzel Jakob", "Boost Software License"):
        assert other in notices
    measured(f"the wheel has {wheel.stat().st_size / 1e6:.1f} MB")


def test_the_same_sources_give_the_same_bytes(wheel: Path, tmp_path) -> None:
    again = tmp_path / backend.build_wheel(str(tmp_path), {"build-dir": os.environ["MUSTER_BUILD_DIR"]})
    assert again.read_bytes() == wheel.read_bytes()


def test_an_editable_wheel_points_to_the_build_folder(tmp_path) -> None:
    name = backend.build_editable(str(tmp_path), {"build-dir": os.environ["MUSTER_BUILD_DIR"]})
    with zipfile.ZipFile(tmp_path / name) as packed:
        place = Path(packed.read("muster.pth").decode().strip())
    done = subprocess.run([sys.executable, "-c", "import muster; print(muster.__file__)"], env={**os.environ, "PYTHONPATH": str(place)}, capture_output=True, text=True)
    assert done.stdout.strip() == str(place / "muster/__init__.py")


def test_a_source_distribution_holds_all_that_is_compiled(tmp_path) -> None:
    name = backend.build_sdist(str(tmp_path))
    with tarfile.open(tmp_path / name) as packed:
        names = packed.getnames()
        packed.extractall(tmp_path)
    top = tmp_path / name.removesuffix(".tar.gz")
    assert all(entry.startswith(f"{top.name}/") for entry in names)
    build = Path(os.environ["MUSTER_BUILD_DIR"])
    inputs = subprocess.run(["ninja", "-C", build, "-t", "inputs", "muster_python"], capture_output=True, text=True, check=True).stdout
    lines = inputs.splitlines()
    # Sources that are compiled together are included by a file of the build.
    for together in [build / line for line in lines if line.endswith("_cxx.cxx")]:
        lines += re.findall(r'#include "(.+)"', together.read_text())
    sources = {Path(line).relative_to(ROOT) for line in lines if line.startswith(f"{ROOT}/") and not line.startswith(str(build))}
    assert len(sources) > 200
    assert [str(path) for path in sources if not (top / path).exists()] == []
    settings = backend.ENGINE_ONLY + ["-DMUSTER_BUILD_PYTHON=ON", f"-DPython_EXECUTABLE={backend.interpreter()}"]
    subprocess.run(["cmake", "-S", top, "-B", tmp_path / "build", "-G", "Ninja", *settings], check=True, capture_output=True)
    # A header that is missing would be found by the compiler only: every header of the tree is there.
    headers = [path.relative_to(ROOT) for part in ("include", "src") for path in (ROOT / part).rglob("*.h")]
    assert all((top / header).exists() for header in headers)
    assert 'backend-path = ["bindings/python/build_backend"]' in (top / "pyproject.toml").read_text()
