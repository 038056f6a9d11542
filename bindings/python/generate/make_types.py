"""Writes what follows from Muster's C++ headers: the Python types, and the C++ table that converts them.

Usage: make_types.py ROOT FOLDER. Writes FOLDER/_types.py and FOLDER/described_types.inc.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

from read_headers import Enumeration, Field, HeaderError, Struct, read_header

HEADERS = (
    "generated/enumerations geometry generated/ground_definitions generated/people_definitions generated/orders_definitions ground order control "
    "generated/world_definitions generated/command_kinds "
    "generated/former_commands command event characters walk_totals views take"
).split()
# What has a Python class of its own, or none.
LEFT_OUT = {
    "TriangleMesh", "CharactersView", "GroupView", "ObstacleView", "PatchView", "AreaView", "StageInfo", "StageTimes", "Rejection",
    "Take", "TakeFrame", "ReplayFrom",
}  # fmt: skip
# Classes with methods, which are in the files NAME_methods.txt.
WITH_METHODS = ("Order", "Distribution")
RENAMED = {"def": "placement", "from": "from_"}
NUMBERS = {f"std::{sign}int{bits}_t" for sign in ("", "u") for bits in (8, 16, 32, 64)} | {"std::size_t", "MotionId"}
PLAIN = {
    "double": ("float", ""),
    "bool": ("bool", "False"),
    "std::string": ("str", '""'),
    "Vec2": ("Vec2", "(0.0, 0.0)"),
    "Box": ("Box", ""),
    "Polygon": ("list[Vec2]", "field(default_factory=list)"),
    "Parameters": ("dict[str, float]", "field(default_factory=dict)"),
    "EventCounts": ("dict[str, int]", "field(default_factory=dict)"),
    "CommandBody": ("CommandBody", "field(default_factory=TouchDown)"),
}


def snake(name: str) -> str:
    """A name of C++ as one of Python: maxSpeed, max_speed."""
    return RENAMED.get(name, re.sub(r"(?<=[a-z0-9])([A-Z])", r"_\1", name).lower())


def word(name: str) -> str:
    """The word of an enumerator in files: LeftFlank, leftFlank."""
    return name[0].lower() + name[1:]


def annotation(type_: str) -> str:
    """The Python type of a C++ one."""
    if type_ in NUMBERS or re.fullmatch(r"\w+Id", type_):
        return "int"
    if type_ in PLAIN:
        return PLAIN[type_][0]
    if inner := re.fullmatch(r"std::optional<(.+)>", type_):
        return f"{annotation(inner[1])} | None"
    if inner := re.fullmatch(r"std::vector<(.+)>", type_):
        return f"list[{annotation(inner[1])}]"
    if type_ == "std::array<double, 3>":
        return "tuple[float, float, float]"
    if type_.startswith("std::array<double, "):
        return "dict[str, float]"
    return type_


def default(item: Field, enumerations: set[str]) -> str:
    """The Python expression of a field's default."""
    type_, text = item.type, item.default
    if type_.startswith("std::optional"):
        return "None"
    if text == "defaultClipFacts()":
        return "field(default_factory=lambda: _core.default_clip_facts())"
    if type_.startswith("std::vector") or type_ == "Polygon":
        return "field(default_factory=list)"
    if type_.startswith("std::array") and text == "{}":
        return "field(default_factory=dict)"
    if type_ in enumerations:
        return f"{type_}.{snake(text.split('::')[1]).upper()}"
    if text in ("true", "false"):
        return text.capitalize()
    if text == "kTakeEnd":
        return "0xFFFFFFFF"
    if type_ == "Box":
        corners = re.findall(r"\{([-\d., ]+)\}", text)
        return "(" + ", ".join("(" + ", ".join(f"{float(x)}" for x in corner.split(",")) + ")" for corner in corners) + ")"
    if type_ == "std::array<double, 3>":
        return "(" + ", ".join(f"{float(x)}" for x in text.strip("{}").split(",")) + ")"
    if text and text != "{}":
        return text
    if type_ in PLAIN and PLAIN[type_][1]:
        return PLAIN[type_][1]
    if annotation(type_) == "int":
        return "0"
    if type_ == "double":
        raise HeaderError(f"{item.name}: found a number without a default, expected one")
    return f"field(default_factory={type_})"


def wrapped(text: str, indent: str) -> str:
    """Text in lines of at most 120 characters."""
    lines, line = [], indent
    for part in text.split():
        if len(line) + len(part) > 118 and line.strip():
            lines.append(line.rstrip())
            line = indent + "    "
        line += part + " "
    return "\n".join([*lines, line.rstrip()])


def python_enumeration(thing: Enumeration) -> str:
    lines = [f"class {thing.name}(str, Enum):", wrapped(f'"""{thing.doc}', "    "), ""]
    lines += [wrapped(f"{snake(value).upper()}: {doc}" if doc else snake(value).upper(), "    ") for value, doc in thing.values]
    lines += ['    """', ""]
    lines += [f'    {snake(value).upper()} = "{word(value)}"' for value, _ in thing.values]
    return "\n".join(lines)


def python_struct(thing: Struct, enumerations: set[str], methods: str = "") -> str:
    lines = ["@dataclass(slots=True)", f"class {thing.name}:", wrapped(f'"""{thing.doc}', "    ")]
    if thing.fields:
        lines += ["", "    Attributes:"]
        lines += [wrapped(f"{snake(item.name)}: {item.doc}", "        ") for item in thing.fields]
    lines += ['    """', ""]
    for item in thing.fields:
        lines.append(f"    {snake(item.name)}: {annotation(item.type)} = {default(item, enumerations)}")
    return "\n".join(lines) + (f"\n\n{methods.rstrip()}" if methods else "")


PYTHON_HEAD = '''"""Definitions, commands, orders and what is read of worlds, as plain data. Made from the C++ headers by generate/make_types.py.

Points are pairs (x, y) in metres, x to the right and y forward; wherever a list of points stands, an array of shape (n, 2) is taken
too. Ids are numbers, 0 for none. A value of an enumeration may be given as its word: `FormationDef(kind="wedge")`.
Ranges are checked where the engine gets the data, and a failure names the field.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum
from typing import Union

from . import _core

Vec2 = tuple[float, float]
Box = tuple[Vec2, Vec2]

'''


def write_python(things: list[Struct | Enumeration], commands: list[str], methods: dict[str, str]) -> str:
    enumerations = {thing.name for thing in things if isinstance(thing, Enumeration)}
    parts = []
    for thing in things:
        if isinstance(thing, Enumeration):
            parts.append(python_enumeration(thing))
            continue
        if thing.name == "Command":
            parts.append("CommandBody = Union[\n    " + ",\n    ".join(commands) + ",\n]")
        parts.append(python_struct(thing, enumerations, methods.get(thing.name, "")))
    names = sorted([thing.name for thing in things] + ["CommandBody", "Vec2", "Box"])
    listed = "__all__ = [\n" + "".join(f'    "{name}",\n' for name in names) + "]\n"
    return PYTHON_HEAD + listed + "\n\n" + "\n\n\n".join(parts) + "\n"


def write_table(things: list[Struct | Enumeration]) -> str:
    lines = ["// Made from the C++ headers by generate/make_types.py: names and fields of the Python types.", ""]
    for thing in things:
        if isinstance(thing, Enumeration):
            words = ", ".join(f'"{word(value)}"' for value, _ in thing.values)
            lines += [f"template <>\nstruct Words<{thing.name}> {{", f'    static constexpr const char* kName = "{thing.name}";']
            lines += [f"    static constexpr std::array kWords{{{words}}};", "};"]
            continue
        lines += [f"template <>\nstruct Described<{thing.name}> : std::true_type {{"]
        lines += [f'    static constexpr const char* kName = "{thing.name}";', "    template <class Visitor, class Value>"]
        lines += ["    static void fields(Visitor& visitor, Value& value) {"]
        lines += [f'        visitor("{snake(item.name)}", value.{item.name});' for item in thing.fields]
        lines += ["    }", "};"]
    names = ", ".join(thing.name for thing in things if isinstance(thing, Struct))
    lines += ["/// Every described type.", f"using AllDescribed = std::tuple<{names}>;"]
    return "\n".join(lines) + "\n"


def in_order(things: list[Struct | Enumeration], commands: list[str]) -> list[Struct | Enumeration]:
    """Each type after those that it is made of."""
    by_name = {thing.name: thing for thing in things}
    ordered: dict[str, Struct | Enumeration] = {}

    def add(thing: Struct | Enumeration) -> None:
        for item in thing.fields if isinstance(thing, Struct) else []:
            for name in commands if item.type == "CommandBody" else re.findall(r"\w+", item.type):
                if name in by_name and name not in ordered:
                    add(by_name[name])
        ordered[thing.name] = thing

    for thing in things:
        if thing.name not in ordered:
            add(thing)
    return list(ordered.values())


def variant_of(name: str, header: Path) -> list[str]:
    """The alternatives of the variant of that name, in their order."""
    found = re.search(rf"using {name} = std::variant<([^>]+)>", header.read_text(encoding="utf-8"))
    if not found:
        raise HeaderError(f"{header.name}: found no {name}, expected a variant of that name")
    return [name.strip() for name in found[1].split(",")]


def main() -> None:
    root, folder = Path(sys.argv[1]), Path(sys.argv[2])
    include = root / "include/muster"
    figures = [root / f"src/engine/world/{name}.h" for name in ("departures", "metrics")]
    paths = [include / f"{name}.h" for name in HEADERS] + figures
    things = [thing for path in paths for thing in read_header(path) if thing.name not in LEFT_OUT]
    commands = variant_of("CommandKinds", include / "generated/command_kinds.h")
    commands += variant_of("FormerKinds", include / "generated/former_commands.h")
    things = in_order(things, commands)
    folder.mkdir(parents=True, exist_ok=True)
    methods = {name: (Path(__file__).parent / f"{name.lower()}_methods.txt").read_text(encoding="utf-8") for name in WITH_METHODS}
    (folder / "_types.py").write_text(write_python(things, commands, methods), encoding="utf-8")
    (folder / "described_types.inc").write_text(write_table(things), encoding="utf-8")


if __name__ == "__main__":
    main()
