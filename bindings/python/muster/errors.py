"""Failures of the engine. The text of each is one sentence that names the faulty value or file, as the C++ API gives it."""

from __future__ import annotations


class Error(Exception):
    """Any failure of the engine.

    Attributes:
        code: What kind of thing went wrong: "invalid argument", "not found", "parse error", "i/o error", "corrupt",
            "unsupported" or "limit exceeded".
    """

    code = "internal error"


class InvalidArgumentError(Error, ValueError):
    """A value is outside its range or contradicts another."""

    code = "invalid argument"


class NotFoundError(Error, LookupError):
    """No object has this name or id."""

    code = "not found"


class ParseError(Error, ValueError):
    """Text or bytes that do not follow the format."""

    code = "parse error"


class IoError(Error, OSError):
    """A file that cannot be read or written."""

    code = "i/o error"


class CorruptError(Error):
    """A checksum or hash that does not match."""

    code = "corrupt"


class UnsupportedError(Error):
    """Valid, but of a version or kind not known here, or not possible now."""

    code = "unsupported"


class LimitExceededError(Error):
    """Too large, too many, too often."""

    code = "limit exceeded"
