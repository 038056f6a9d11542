"""The build backend of the package (PEP 517, PEP 660), with nothing but the standard library.

It builds the engine by CMake and packs wheels. Settings (`pip install -C NAME=VALUE`), or variables of the environment:

    build-dir    MUSTER_BUILD_DIR    a build folder of CMake, which is kept and used again; without it build/python in the tree
    jobs         MUSTER_BUILD_JOBS   compilers at the same time; without it one per core
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import Any

import wheel_file

HERE = Path(__file__).resolve().parent.parent
ROOT = HERE.parent.parent
Settings = dict[str, Any] | None

# What a wheel needs of the engine, and nothing else.
ENGINE_ONLY = [
    "-DCMAKE_BUILD_TYPE=Release",
    "-DMUSTER_COMPONENTS=core;motion;io",
    *(f"-DMUSTER_BUILD_{part}=OFF" for part in ("SHARED", "ARCHIVE", "APPS", "TESTS", "HASHES", "ENGINE", "SCALE")),
]
# What the engine is built from, for source distributions.
SOURCES = ["CMakeLists.txt", "LICENSE", "cmake", "include", "src", "bindings/c", "bindings/python"]


class BuildError(SystemExit):
    """A build that cannot be done; one sentence."""


def get_requires_for_build_wheel(config_settings: Settings = None) -> list[str]:
    return []


def get_requires_for_build_editable(config_settings: Settings = None) -> list[str]:
    return []


def get_requires_for_build_sdist(config_settings: Settings = None) -> list[str]:
    return []


def prepare_metadata_for_build_wheel(metadata_directory: str, config_settings: Settings = None) -> str:
    info = wheel_file.info_folder(project())
    folder = Path(metadata_directory) / info
    folder.mkdir(parents=True)
    for name, content in metadata_files().items():
        folder.joinpath(name).parent.mkdir(parents=True, exist_ok=True)
        folder.joinpath(name).write_bytes(content)
    return info


prepare_metadata_for_build_editable = prepare_metadata_for_build_wheel


def build_wheel(wheel_directory: str, config_settings: Settings = None, metadata_directory: str | None = None) -> str:
    package = compile_module(build_folder(config_settings), config_settings)
    files = {f"muster/{path.name}": path.read_bytes() for path in sorted(package.iterdir()) if path.is_file()}
    return write_wheel(wheel_directory, files)


def build_editable(wheel_directory: str, config_settings: Settings = None, metadata_directory: str | None = None) -> str:
    """A wheel that points to the build folder, where the Python files are links to those of the tree."""
    package = compile_module(build_folder(config_settings), config_settings)
    return write_wheel(wheel_directory, {"muster.pth": f"{package.parent}\n".encode()})


def build_sdist(sdist_directory: str, config_settings: Settings = None) -> str:
    files = [path for part in SOURCES for path in source_files(ROOT / part)]
    return wheel_file.write_sdist(Path(sdist_directory), project(), ROOT, files, root_pyproject(), metadata())


def setting(settings: Settings, name: str, variable: str) -> str | None:
    """A setting of pip's, else the variable of the environment, else none."""
    found = (settings or {}).get(name) or os.environ.get(variable)
    return str(found) if found else None


def build_folder(settings: Settings) -> Path:
    """The build folder. pip works in the folder of the package, but names count from where pip was called."""
    name = setting(settings, "build-dir", "MUSTER_BUILD_DIR")
    return Path(os.environ.get("PWD", "."), name).resolve() if name else ROOT / "build/python"


def compile_module(folder: Path, settings: Settings) -> Path:
    """Builds the module and gives the folder of the package. A build folder that is there keeps its other settings."""
    there = (folder / "CMakeCache.txt").exists()
    configure = ["cmake", "-S", str(ROOT), "-B", str(folder), "-DMUSTER_BUILD_PYTHON=ON", f"-DPython_EXECUTABLE={interpreter()}"]
    if not there:
        configure += ENGINE_ONLY
        if run_quietly(["ninja", "--version"]):
            configure += ["-G", "Ninja"]
    run(configure)
    jobs = setting(settings, "jobs", "MUSTER_BUILD_JOBS") or str(os.cpu_count() or 1)
    run(["cmake", "--build", str(folder), "--target", "muster_python", "--parallel", jobs])
    return folder / "bindings/python/package/muster"


def interpreter() -> str:
    """The interpreter itself, and not that of a virtual environment, which may be gone when the folder is used again."""
    return str(getattr(sys, "_base_executable", None) or sys.executable)


def run(command: list[str]) -> None:
    try:
        subprocess.run(command, check=True)
    except FileNotFoundError:
        raise BuildError(f"{command[0]}: found no such program, expected CMake 3.25 or newer and a C++20 compiler") from None
    except subprocess.CalledProcessError as error:
        raise BuildError(f"{command[0]} ended with {error.returncode}; its lines are above") from None


def run_quietly(command: list[str]) -> bool:
    try:
        return subprocess.run(command, capture_output=True).returncode == 0
    except FileNotFoundError:
        return False


def project() -> dict[str, Any]:
    """The table [project], with the version of the engine."""
    table: dict[str, Any] = tomllib.loads((HERE / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    version = re.search(r"project\(muster VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))
    if not version:
        raise BuildError("CMakeLists.txt: found no version, expected project(muster VERSION ...)")
    return {**table, "version": version[1]}


def root_pyproject() -> str:
    """The pyproject.toml of source distributions, which lies two folders farther up."""
    text = (HERE / "pyproject.toml").read_text(encoding="utf-8")
    return text.replace('["build_backend"]', '["bindings/python/build_backend"]').replace('"README.md"', '"bindings/python/README.md"')


def metadata() -> str:
    return wheel_file.metadata(project(), (HERE / "README.md").read_text(encoding="utf-8"))


def metadata_files() -> dict[str, bytes]:
    """The files of the .dist-info folder, but RECORD."""
    return {
        "METADATA": metadata().encode(),
        "WHEEL": wheel_file.wheel_text().encode(),
        "LICENSE": (ROOT / "LICENSE").read_bytes(),
        "THIRD-PARTY-NOTICES.txt": (HERE / "THIRD-PARTY-NOTICES.txt").read_bytes(),
    }


def write_wheel(directory: str, files: dict[str, bytes]) -> str:
    info = wheel_file.info_folder(project())
    return wheel_file.write_wheel(Path(directory), project(), files | {f"{info}/{n}": c for n, c in metadata_files().items()})


def source_files(place: Path) -> list[Path]:
    if place.is_file():
        return [place]
    return sorted(p for p in place.rglob("*") if p.is_file() and "__pycache__" not in p.parts and not p.name.endswith(".pyc"))
