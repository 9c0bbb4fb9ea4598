"""Says in plain words what an error of the system or of a decoder means: people do not read their internal texts."""

from __future__ import annotations

import errno
import os
import re
import struct
import zlib
from collections.abc import Mapping

import msgspec

SYSTEM_REASONS: Mapping[int, str] = {
    errno.ENOSPC: "the disk is full",
    errno.EDQUOT: "your share of the disk is used up",
    errno.EFBIG: "the file would be larger than this system allows",
    errno.EACCES: "you are not allowed to",
    errno.EPERM: "you are not allowed to",
    errno.EROFS: "the disk is write-protected",
    errno.EIO: "the disk fails",
    errno.ENOENT: "it is not there",
    errno.ENOTDIR: "a part of its path is a file, not a folder",
    errno.EISDIR: "it is a folder",
    errno.EEXIST: "something of this name is there already",
    errno.ENAMETOOLONG: "the name is too long",
    errno.ELOOP: "its links lead in a circle",
    errno.EMFILE: "too many files are open",
    errno.ENFILE: "too many files are open on this machine",
    errno.ENOMEM: "there is not enough memory",
    errno.EAGAIN: "this system is busy",
    errno.EBUSY: "another program uses it",
    errno.EADDRINUSE: "it is in use by another program",
    errno.EADDRNOTAVAIL: "this machine has no such address",
}
"""What a system error says of the file or the port that its sentence is about."""

TYPES: Mapping[str, str] = {
    "int": "a whole number",
    "float": "a number",
    "str": "text",
    "bool": "true or false",
    "null": "nothing",
    "None": "nothing",
    "array": "a list",
    "object": "a table",
    "bytes": "bytes",
}
"""The types of messages and documents, as people call them."""

_EXPECTED = re.compile(r"Expected (.+?)(?:, got (.+?))?(?: - at (.+))?")
_FOUND = re.compile(
    r"(Object missing required field|Object contains unknown field|Invalid (?:enum )?value) (.+?)(?: - at (.+))?"
)
_WRONG = {"Object missing required field": "is missing", "Object contains unknown field": "is not known"}
_SIGNS = {" <= ": " at most ", " >= ": " at least ", " < ": " below ", " > ": " above ", " matching regex ": " like "}
_WHOLE = "the whole"
_DAMAGED = "its bytes are damaged or cut off"


def explain_error(error: BaseException, /) -> str:
    """What an error means, as a clause without a full stop; messages of our own errors come through as they are."""
    match error:
        case OSError(errno=int()):
            return SYSTEM_REASONS.get(error.errno or 0) or os.strerror(error.errno or 0).lower()
        case KeyError() if type(error) is KeyError:  # others have sentences of their own
            return f"{error.args[0] if error.args else 'a part of it'} is missing"
        case msgspec.ValidationError():
            return _explain_validation(str(error))
        case UnicodeDecodeError():
            return "its text is not UTF-8"
        case RecursionError():
            return "it is nested too deeply"
        case msgspec.DecodeError() | zlib.error() | struct.error():
            return _DAMAGED
    return str(error)


def _explain_validation(text: str) -> str:
    """Turns msgspec's words ("Expected `float`, got `str` - at `$.value`") into ours."""
    if match := _FOUND.fullmatch(text):
        what, name, place = match.groups()
        if what not in _WRONG:
            return f"{_place(place)} is {name}, not one of those known"
        inside = "" if _place(place) == _WHOLE else f" in {_place(place)}"
        return f"{name.strip('`')}{inside} {_WRONG[what]}"
    if match := _EXPECTED.fullmatch(text):
        expected, came, place = match.groups()
        if came is None or came.isdigit():  # a length
            return f"{_place(place)} is not {_words(expected)}"
        return f"{_place(place)} is {_words(came)}; expected {_words(expected)}"
    return text.replace("`", "")


def _place(place: str | None) -> str:
    """`$.layers[2].weight` as "layers[2].weight"; the whole where no part is named."""
    return (place or "").strip("`").removeprefix("key in `").removeprefix("$").replace("[...]", "").strip(".") or _WHOLE


def _words(types: str) -> str:
    """`float | null` as "a number or nothing"."""
    plain = re.sub(
        r"`([^`]+)`", lambda match: " or ".join(TYPES.get(part, part) for part in match[1].split(" | ")), types
    )
    for sign, word in _SIGNS.items():
        plain = plain.replace(sign, word)
    return plain
