"""Landmarks as people give them: `nose_tip=0,1.2,9.4`, or a JSON file of names and places."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path

import msgspec
import numpy as np

from omote.interchange.formats.error_reasons import explain_error
from omote.model.fitting.landmarks import FEWEST_LANDMARKS, SEVEN

LandmarkPoints = dict[str, tuple[float, float, float]]
LARGEST = 2**20
"""Bytes of a file of landmarks at most."""
EXAMPLE = "--landmarks nose_tip=0,1.2,9.4"
_MALFORMED = re.compile(r"JSON is malformed: (.+) \(byte (\d+)\)")


def parse_point(word: str, /) -> tuple[str, tuple[float, float, float]]:
    """The name and the place in `nose_tip=0,1.2,9.4`; ValueError for another word."""
    name, _, place = word.partition("=")
    try:
        numbers = [float(part) for part in place.split(",")]
    except ValueError:
        numbers = []
    if name.strip() not in SEVEN:
        raise ValueError(f"{word!r} is no landmark; expected one of {', '.join(SEVEN)} as in {EXAMPLE}")
    if len(numbers) != 3 or not np.isfinite(numbers).all():
        raise ValueError(f"{word!r} says no place; expected three numbers with commas, as in {EXAMPLE}")
    return name.strip(), (numbers[0], numbers[1], numbers[2])


def parse_document(data: bytes, scan: str, /, *, others: Sequence[str] = ()) -> LandmarkPoints:
    """The landmarks of a scan in a JSON document: {"nose_tip": [0, 1.2, 9.4], ...}, or such ones by the names of scans.

    others: the scans that are fitted beside it. ValueError for an invalid document, and for one that names none of all.

    data: JSON; scan: the file's name.
    """
    if len(data) > LARGEST:
        raise ValueError(f"the landmarks have {len(data)} bytes; expected {LARGEST} at most")
    try:
        document = msgspec.json.decode(data, type=dict[str, list[float] | dict[str, list[float]]])
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
        raise ValueError(
            f'the landmarks are no JSON such as {{"nose_tip": [0, 1.2, 9.4]}} ({_explain(error, data)})'
        ) from error
    section = document.get(scan, document)
    points = (
        {name: place for name, place in section.items() if isinstance(place, list)} if isinstance(section, dict) else {}
    )
    if not points and not document.keys() & set(others):
        raise ValueError(f"the landmarks have none for {scan}; they name {', '.join(document)[:200] or 'nothing'}")
    return dict(parse_point(f"{name}={','.join(map(repr, place))}") for name, place in points.items())


def read_landmarks(words: Sequence[str], scan: Path, scans: Sequence[Path], /) -> LandmarkPoints:
    """The landmarks of one of several scans, from words and files of them; ValueError where these say none.

    words: `nose_tip=...`, or names of files; scan: the one that is asked for; scans: all.
    """
    landmarks: LandmarkPoints = {}
    for word in words:
        if "=" in word:
            landmarks.update([parse_point(word)])
            continue
        path = Path(word)
        if not path.is_file() or path.stat().st_size > LARGEST:
            raise ValueError(f"there is no file of landmarks {word}; give nose_tip=x,y,z, or a JSON file")
        landmarks.update(parse_document(path.read_bytes(), scan.name, others=[other.name for other in scans]))
    return landmarks


def _explain(error: Exception, data: bytes) -> str:
    """What is wrong with a document, and in which line and column, counted from 1, where its text is."""
    if isinstance(error, msgspec.ValidationError) or not isinstance(error, msgspec.DecodeError):
        return explain_error(error)
    match = _MALFORMED.fullmatch(str(error))
    what, before = (match[1], data[: int(match[2])]) if match else ("it ends too soon", data)
    column = len(before.rpartition(b"\n")[2].decode("utf-8", "replace")) + 1
    line = before.count(b"\n") + 1
    return f"line {line}, column {column}: {what}"


def require_enough(points: Mapping[str, object], /) -> None:
    """Raises ValueError where some landmarks are given, and fewer than say where a face is."""
    if points and len(points) < FEWEST_LANDMARKS:
        raise ValueError(
            f"{len(points)} landmarks are given; expected at least {FEWEST_LANDMARKS} of {', '.join(SEVEN)}"
        )


def explain_landmarks(names: Sequence[str] = SEVEN, /, *, accepted: bool = False) -> str:
    """What people do to give them; accepted: whether --accept was given, though no face was fitted.

    names: of the points that may be given.
    """
    nothing = "Where no face was fitted there is none that --accept could store. " if accepted else ""
    return (
        f"{nothing}Say where the face is, with at least {FEWEST_LANDMARKS} of {', '.join(names)} in the scan's own"
        f" numbers, of an animal all; left is the person's own: {EXAMPLE}, again for each, or a JSON file of them."
        " MeshLab, CloudCompare and Blender show the numbers of a point that you click."
    )
