"""What the tests of the Python package share. run.sh sets MUSTER_PROGRAM and MUSTER_BUILD_DIR."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path
from typing import Any

import pytest

import muster

ROOT = Path(__file__).resolve().parent.parent.parent
measured_lines: list[str] = []


@pytest.fixture
def scenarios() -> Path:
    return ROOT / "scenarios"


@pytest.fixture
def root() -> Path:
    return ROOT


@pytest.fixture
def program():
    """Runs the native program and gives its output; with --json its value."""

    def run(*words: object) -> Any:
        done = subprocess.run([os.environ["MUSTER_PROGRAM"], *map(str, words)], capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout) if "--json" in words else done.stdout

    return run


@pytest.fixture
def measured():
    """Prints a line "measured: ..." at the end."""
    return lambda text: measured_lines.append(f"measured: {text}")


def walkers(count: int = 16, **group: Any) -> muster.WorldDef:
    """Open ground with one group in its middle."""
    return muster.WorldDef(box=((-40.0, -40.0), (40.0, 40.0)), groups=[muster.GroupDef(count=count, **group)])


def pytest_terminal_summary(terminalreporter: Any) -> None:
    count = {name: len(terminalreporter.stats.get(name, [])) for name in ("passed", "failed", "error")}
    for report in terminalreporter.stats.get("skipped", []):
        terminalreporter.write_line(f"skipped: {report.longrepr[2].removeprefix('Skipped: ')}")
    for line in measured_lines:
        terminalreporter.write_line(line)
    terminalreporter.write_line(f"{count['passed']} passed, {count['failed'] + count['error']} failed")
