"""The stubs say what the module has, and types fit under mypy --strict."""

from __future__ import annotations

import ast
import inspect
import subprocess
import sys
from pathlib import Path

import pytest

import muster
from muster import _core

STUB = Path(muster.__file__).parent / "_core.pyi"


def names_of(body: list[ast.stmt]) -> dict[str, ast.stmt]:
    named = {node.name: node for node in body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
    named |= {node.target.id: node for node in body if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name)}
    return named


def parameters_of(documented: str) -> list[str]:
    """Names of the parameters in the first line that pybind11 writes: `f(a: int, *, b: int = 1) -> None`."""
    line = documented.splitlines()[0]
    call = ast.parse(line[: line.rindex(")") + 1].replace("muster._core.", "").replace("os.", ""), mode="eval") if ":" not in line else None
    if call is not None:
        return [argument.id for argument in call.body.args if isinstance(argument, ast.Name)]  # type: ignore[attr-defined]
    inside = line[line.index("(") + 1 : line.rindex(")")]
    return [part.split(":")[0].strip() for part in inside.split(", ") if part.strip() not in ("", "*", "/")]


def test_every_name_of_the_module_is_in_the_stub_and_no_other() -> None:
    tree = names_of(ast.parse(STUB.read_text()).body)
    assert set(tree) == {name for name in vars(_core) if not name.startswith("__")}
    for name, node in tree.items():
        if not isinstance(node, ast.ClassDef):
            continue
        members = {m for m in vars(getattr(_core, name)) if not m.startswith("_")}
        assert {m for m in names_of(node.body) if not m.startswith("_")} == members, name


def test_parameters_have_the_same_names() -> None:
    tree = names_of(ast.parse(STUB.read_text()).body)
    scopes = [(_core, tree)] + [(getattr(_core, n), names_of(node.body)) for n, node in tree.items() if isinstance(node, ast.ClassDef)]
    compared = 0
    for owner, named in scopes:
        for name, node in named.items():
            if not isinstance(node, ast.FunctionDef) or isinstance(inspect.getattr_static(owner, name), property) or name == "__len__":
                continue
            stub = [a.arg for a in (*node.args.args, *node.args.kwonlyargs)]
            assert parameters_of(getattr(owner, name).__doc__) == stub, f"{owner.__name__}.{name}"
            compared += 1
    assert compared > 40


def test_what_users_see_is_described() -> None:
    for name in muster.__all__:
        thing = getattr(muster, name)
        if inspect.isclass(thing) or inspect.isroutine(thing):
            assert inspect.getdoc(thing), name
    for type_ in (_core.World, _core.Characters, _core.Group, _core.RunMetrics, _core.TakeWriter, _core.CrowdMotion):
        for name, member in vars(type_).items():
            if not name.startswith("_"):
                text = (member.__doc__ if isinstance(member, property) else getattr(type_, name).__doc__) or ""
                assert len(text.splitlines()[-1]) > 5, f"{type_.__name__}.{name}"
    for name in ("position", "velocity", "cost"):
        assert "Shape (n" in vars(_core.Characters)[name].__doc__


SAMPLE = """
import muster
import numpy as np

definition = muster.WorldDef(groups=[muster.GroupDef(count=4, formation=muster.FormationDef(muster.FormationKind.WEDGE))])
world = muster.World(definition, threads=2)
command: muster.Command = world.submit(muster.GiveOrder(1, order=muster.Order.move((1.0, 2.0))), step=4)
world.step(10)
middle: np.ndarray[tuple[int], np.dtype[np.float64]] = world.characters.position.mean(axis=0)
kinds: list[str] = [event.kind.value for event in world.events]
figures = muster.run_batch(definition, [1, 2], seconds=1.0)
hashes: list[int] = [f.hash for f in figures]
doubled: list[float] = muster.run_batch(float, ["1", "2"], processes=1)
"""
WRONG = {
    'muster.GroupDef(count="many")': "arg-type",
    "muster.World(definition).stepp()": "attr-defined",
    "world.submit(4)": "arg-type",
}


def test_types_fit(tmp_path) -> None:
    pytest.importorskip("mypy", reason="mypy is not there (Debian's package mypy)")
    sample = tmp_path / "sample.py"
    sample.write_text(SAMPLE + "\n".join(WRONG) + "\n")
    command = [sys.executable, "-m", "mypy", "--strict", "--ignore-missing-imports", "--no-color-output", "--cache-dir", str(tmp_path / "cache")]
    done = subprocess.run([*command, str(sample)], capture_output=True, text=True)
    found = [line for line in done.stdout.splitlines() if "error:" in line]
    first = len(SAMPLE.splitlines())
    expected = {f"sample.py:{first + 1 + i}" for i in range(len(WRONG))}
    assert {line[line.index("sample.py") :].split(": error")[0] for line in found} == expected, done.stdout
    assert all(f"[{kind}]" in done.stdout for kind in WRONG.values())
    whole = subprocess.run([*command, "-p", "muster"], capture_output=True, text=True)
    assert whole.returncode == 0, whole.stdout
