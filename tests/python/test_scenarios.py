"""Scenario and gesture files."""

from __future__ import annotations

import json

import pytest

import muster


def test_every_scenario_is_read_and_written_again(scenarios) -> None:
    files = sorted(scenarios.glob("*.json")) + sorted((scenarios / "paper").glob("*.json"))
    assert len(files) > 20
    for file in files:
        scenario = muster.Scenario.load(file)
        text = muster.write_scenario(scenario.definition)
        again = muster.parse_scenario(text)
        again.gestures = scenario.definition.gestures
        assert again == scenario.definition, file.name
        step = muster.World(scenario).parameters["time.step"]
        written = muster.write_gestures(scenario.commands, step)
        assert [c.body for c in muster.parse_gestures(written, step)] == [c.body for c in scenario.commands], file.name


def test_a_scenario_may_be_a_dict_a_path_or_a_definition(scenarios) -> None:
    file = scenarios / "open.json"
    content = json.loads(file.read_text())
    hashes = {muster.World(given).hash() for given in (file, str(file), content, muster.load_scenario(file), muster.Scenario.load(file))}
    assert len(hashes) == 1


def test_failures_name_file_and_place(tmp_path) -> None:
    file = tmp_path / "bad.json"
    file.write_text('{"format": "muster-scenario", "version": 1, "groups": [{"count": -1}]}')
    with pytest.raises(muster.ParseError, match=r"bad.json: \$.groups\[0\].count: found the number -1, expected"):
        muster.Scenario.load(file)
    file.write_text("{")
    with pytest.raises(muster.ParseError, match="bad.json"):
        muster.load_scenario(file)
    with pytest.raises(muster.IoError, match="none.json"):
        muster.load_scenario(tmp_path / "none.json")
    with pytest.raises(muster.ParseError, match="gestures: "):
        muster.parse_gestures("[]")
    with pytest.raises(OSError):
        muster.save_scenario(muster.WorldDef(), tmp_path / "no/such/folder.json")


def test_changed_scenarios_are_copies(scenarios) -> None:
    scenario = muster.Scenario.load(scenarios / "paper/x08-congestion.json")
    changed = scenario.changed(seed=9, parameters={"density.enabled": 0})
    assert (scenario.definition.seed, changed.definition.seed) == (1, 9)
    assert changed.definition.parameters == {**scenario.definition.parameters, "density.enabled": 0}
    assert "density.enabled" not in scenario.definition.parameters


def test_warnings_name_what_is_likely_a_mistake() -> None:
    definition = muster.WorldDef(groups=[muster.GroupDef(count=4)])
    definition.obstacles = [muster.ObstacleDef(centre=(x, 8.0), radius=1.0) for x in (0.0, 2.3)]
    [warning] = muster.scenario_warnings(definition)
    assert "is 0.30 m wide, narrower than a character" in warning
    assert muster.scenario_warnings(definition, 0) == []
    assert muster.scenario_warnings(muster.WorldDef(groups=[muster.GroupDef()])) == []


def test_schemas_are_json() -> None:
    assert "groups" in json.loads(muster.scenario_schema())["properties"]
    assert json.loads(muster.gestures_schema())["$schema"]
