"""The programs in docs/python.md and in the README of the package run as they stand."""

from __future__ import annotations

import re

import pytest


@pytest.mark.parametrize("page", ["docs/python.md", "bindings/python/README.md"])
def test_programs_of_the_page_run(page: str, root, tmp_path, monkeypatch, capsys) -> None:
    (tmp_path / "scenarios").symlink_to(root / "scenarios")
    monkeypatch.chdir(tmp_path)
    programs = re.findall(r"```python\n(.*?)```", (root / page).read_text(encoding="utf-8"), re.DOTALL)
    assert programs
    scope: dict = {"__name__": "__main__"}
    for program in programs:
        exec(compile(program, page, "exec"), scope)
    assert "15.0 [" in capsys.readouterr().out
    if page == "docs/python.md":
        assert len(programs) == 9 and scope["info"]["time"] == 1.0 and len(scope["figures"]) == 4
        assert (scope["frame"]["id"].nunique(), scope["frame"]["frame"].max()) == (36, 125)
