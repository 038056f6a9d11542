"""Runs the cells of a notebook, without Jupyter."""

from __future__ import annotations

import importlib
import json
import os
from typing import Any
from unittest import mock

import pytest
from conftest import ROOT


def cells_of(name: str, **environment: str) -> dict[str, Any]:
    """What the cells of docs/notebooks/NAME leave behind, run with these variables of the environment; and the notebook itself."""
    matplotlib = pytest.importorskip("matplotlib", reason="matplotlib is not there (Debian's python3-matplotlib)")
    matplotlib.use("Agg")
    importlib.import_module("matplotlib.pyplot").close("all")
    notebook = json.loads((ROOT / "docs/notebooks" / name).read_text(encoding="utf-8"))
    scope: dict[str, Any] = {"__name__": "notebook"}
    with mock.patch.dict(os.environ, environment):
        for cell in notebook["cells"]:
            if cell["cell_type"] == "code":
                exec(compile("".join(cell["source"]), name, "exec"), scope)
    scope["notebook"] = notebook
    return scope


def texts_of(notebook: dict[str, Any]) -> list[str]:
    """What its cells printed when it was checked in."""
    return ["".join(out["text"]) for cell in notebook["cells"] for out in cell.get("outputs", []) if "text" in out]


def pictures_of(notebook: dict[str, Any]) -> list[Any]:
    """What they drew then."""
    return [out for cell in notebook["cells"] for out in cell.get("outputs", []) if "image/png" in out.get("data", {})]
