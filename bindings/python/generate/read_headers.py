"""Reads the structs and enumerations of Muster's C++ headers: the source of the Python types.

The headers are formatted by clang-format, so a few patterns are enough. What the patterns do not fit is refused with the file and
the text, never passed over.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path


class HeaderError(Exception):
    """A header holds something that is not understood."""


@dataclass
class Field:
    """A field of a struct: its C++ type, name, default expression ("" for none) and description."""

    type: str
    name: str
    default: str
    doc: str


@dataclass
class Struct:
    """A struct with its fields in the order of declaration."""

    name: str
    doc: str
    fields: list[Field] = field(default_factory=list)


@dataclass
class Enumeration:
    """An enumeration: names and descriptions of its values."""

    name: str
    doc: str
    values: list[tuple[str, str]] = field(default_factory=list)


DECLARATION = re.compile(
    r"^(?P<type>(?:std::)?\w+(?:::\w+)*(?:<.+>)?) (?P<name>\w+)(?: = (?P<assigned>.+)|(?P<braces>\{.*\}))?$"
)
# What a struct may hold beside fields.
PASSED_OVER = re.compile(r"^(template|static|friend|using|explicit|constexpr|public:|private:)|\)( const)?( noexcept)?( \{|;)")


def plain(text: str) -> str:
    """A description without line breaks, in Python's spelling of members."""
    return re.sub(r"(\w)::(\w)", r"\1.\2", " ".join(text.split()))


class Lines:
    """The lines of a header, with comments parted from code."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.lines = path.read_text(encoding="utf-8").split("\n")
        self.at = 0

    def refuse(self, text: str) -> HeaderError:
        return HeaderError(f"{self.path.name}:{self.at}: found '{text}', expected a field or a function of one block")

    def next(self) -> tuple[str, str, str]:
        """The next line as (code, comment before a declaration, comment behind one)."""
        line = self.lines[self.at].strip()
        self.at += 1
        if line.startswith("///<"):
            return "", "", line[4:]
        if line.startswith("///"):
            return "", line[3:], ""
        if "///<" in line:
            code, behind = line.split("///<", 1)
            return code.strip(), "", behind
        return line.split("//")[0].strip(), "", ""

    def skip_block(self, code: str) -> None:
        """Passes over the rest of a function whose first line is `code`."""
        depth = code.count("{") - code.count("}")
        opened = "{" in code
        while depth > 0 or (not opened and not code.endswith(";")):
            code = self.next()[0]
            opened = opened or "{" in code
            depth += code.count("{") - code.count("}")


def read_struct(lines: Lines, name: str, doc: str) -> Struct:
    struct = Struct(name, doc)
    before = code = behind = ""
    while True:
        text, ahead, after = lines.next()
        if text == "};" and not code:
            return struct
        if not text:
            if after and struct.fields and not code:
                struct.fields[-1].doc = plain(f"{struct.fields[-1].doc} {after}")
            elif after:
                behind += after
            else:
                before = f"{before} {ahead}" if ahead else before
            continue
        code = f"{code} {text}".strip()
        behind += after
        if PASSED_OVER.search(code.split(" = ")[0] if code.endswith(";") else code):
            lines.skip_block(code)
        elif not code.endswith(";"):
            continue
        else:
            struct.fields.append(read_field(lines, code[:-1], plain(f"{before} {behind}")))
        before = code = behind = ""


def read_field(lines: Lines, code: str, doc: str) -> Field:
    match = DECLARATION.match(code)
    if not match:
        raise lines.refuse(code)
    if not doc:
        raise HeaderError(f"{lines.path.name}:{lines.at}: the field {match['name']} has no description")
    return Field(match["type"], match["name"], match["assigned"] or match["braces"] or "", doc)


def read_enumeration(lines: Lines, name: str, doc: str, rest: str) -> Enumeration:
    found = Enumeration(name, doc)
    if rest.endswith("};"):
        found.values = [(value.strip(), "") for value in rest[:-2].split(",")]
        return found
    before = ""
    while True:
        text, ahead, after = lines.next()
        if text == "};":
            return found
        if text:
            # Python names a value by its word, so that the number of a value does not matter.
            found.values.append((text.rstrip(",").split(" = ")[0], plain(f"{before} {after}")))
            before = ""
        elif after:
            value, known = found.values[-1]
            found.values[-1] = (value, plain(f"{known} {after}"))
        else:
            before += ahead


def read_header(path: Path) -> list[Struct | Enumeration]:
    """All structs and enumerations that stand in the namespace itself, in their order."""
    lines = Lines(path)
    found: list[Struct | Enumeration] = []
    doc = ""
    while lines.at < len(lines.lines):
        indented = lines.lines[lines.at].startswith(" ")
        code, ahead, _ = lines.next()
        if ahead and not indented:
            doc += ahead
            continue
        enum = re.match(r"^enum class (\w+)(?: : std::\w+)? \{(.*)$", code)
        struct = re.match(r"^struct (\w+) \{$", code)
        if enum and not indented:
            found.append(read_enumeration(lines, enum[1], plain(doc), enum[2].strip()))
        elif struct and not indented:
            found.append(read_struct(lines, struct[1], plain(doc)))
        doc = ""
    for thing in found:
        if isinstance(thing, Enumeration) and thing.values[-1][0] == "Count":
            thing.values.pop()
    return found
