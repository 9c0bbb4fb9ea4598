"""Parses sculpt files: one face as readable TOML, every control point named by its feature (docs/sculpts.md)."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from omote.arrays import Values
from omote.interchange.formats.error_reasons import explain_error
from omote.model.cast import Look
from omote.model.sculpting.sculpt import KERNELS, Brush, Sculpt
from omote.model.space.gain import Gain

UNITS = {"mm": 0.001, "m": 1.0}
HEADINGS = ("name", "unit", "symmetric", "kernel", "teeth", "base", "look", "gains", "points", "smooth")
POINT_KEYS = ("at", "to", "by", "reach", "size")
ALL = "all"
"""Of a region's gains: that of all expressions which have none of their own."""
BRUSH_KEYS = ("at", "reach", "rounds")


class SculptFileError(ValueError):
    """The text is not a valid sculpt; the message says why."""


def read_sculpt(path: str | Path) -> Sculpt:
    """The sculpt in a text file (TOML).

    Parameters
    ----------
    path : str or Path
        The file; lengths in it are in the unit that it names, millimetres without one.

    Returns
    -------
    Sculpt
        Its control points and moves, in metres.

    Raises
    ------
    ValueError
        SculptFileError: names the file, what is wrong in it and what to do.

    Examples
    --------
    >>> from pathlib import Path
    >>> noh = omote.read_sculpt(Path(omote.__file__).parent / "builtin" / "sculpts" / "noh.toml")
    >>> noh.name, noh.kernel, noh.points.shape[1]
    ('noh', 'triharmonic', 3)

    References
    ----------
    docs/sculpts.md has the format, key by key.
    """
    if not isinstance(path, str | Path):
        raise TypeError(f"a sculpt file is named by its path, not by {path!r}; write 'mask.toml'")
    path = Path(path)
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise SculptFileError(
            f"{path} cannot be read ({explain_error(error)}); expected a text file with a sculpt"
        ) from error
    try:
        return parse_sculpt(text)
    except ValueError as error:
        raise SculptFileError(f"{path}: {error}") from error


def parse_sculpt(text: str, /) -> Sculpt:
    """Parses a sculpt; SculptFileError or ValueError with a message where it is invalid."""
    try:
        table = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise SculptFileError(f"this is no TOML ({error}); expected a sculpt as in docs/sculpts.md") from error
    _refuse_unknown("a sculpt", table, HEADINGS)
    unit = _choice(table, "unit", tuple(UNITS), "mm")
    symmetric = table.get("symmetric", True)
    if not isinstance(symmetric, bool):
        raise SculptFileError(f"symmetric is {symmetric!r}; expected true or false")
    points, targets = _control_points(_table(table, "points"), symmetric)
    return Sculpt(
        name=table.get("name", ""),
        points=points * UNITS[unit],
        moves=(targets - points) * UNITS[unit],
        symmetric=symmetric,
        teeth=_number("teeth", table.get("teeth", 1.0)),
        kernel=_choice(table, "kernel", KERNELS, "triharmonic"),  # type: ignore[arg-type]
        look=_look(_table(table, "look")),
        base={name: _number(f"base {name!r}", weight) for name, weight in _table(table, "base").items()},
        brushes=tuple(_brush(name, row, UNITS[unit]) for name, row in _table(table, "smooth").items()),
        gains=_gains(_table(table, "gains")),
    )


def _control_points(table: Mapping[str, Any], symmetric: bool) -> tuple[Values, Values]:
    """Where the points are (n, 3) and where they go (n, 3), in the file's unit."""
    if not table:
        raise SculptFileError("the sculpt has no control points; expected [points] with a line for each")
    pairs = [_pair(name, row, symmetric) for name, row in table.items()]
    return np.concatenate([at for at, _ in pairs]), np.concatenate([to for _, to in pairs])


def _pair(name: str, row: Any, symmetric: bool) -> tuple[Values, Values]:
    """One line of [points]: a point, or with `reach` a ball of seven that is carried as one, `size` times as large."""
    if not isinstance(row, dict) or "at" not in row:
        raise SculptFileError(f"point {name!r} is {row!r}; expected {{ at = [x, y, z], to = [x, y, z] }}")
    _refuse_unknown(f"point {name!r}", row, POINT_KEYS)
    if "to" in row and "by" in row:
        raise SculptFileError(f"point {name!r} has both `to` and `by`; expected one of them, or none: it stays")
    at = _triple(f"`at` of point {name!r}", row["at"])
    to = at + _triple(f"`by` of point {name!r}", row.get("by", [0, 0, 0]))
    to = _triple(f"`to` of point {name!r}", row["to"]) if "to" in row else to
    if "reach" not in row:
        if "size" in row:
            raise SculptFileError(f"point {name!r} has a `size` without a `reach`; expected both: they make a ball")
        return at[None], to[None]
    reach = _number(f"`reach` of point {name!r}", row["reach"])
    size = row.get("size", 1)
    sizes = _triple(f"`size` of point {name!r}", size if isinstance(size, list) else [size] * 3)
    if reach <= 0 or (sizes <= 0).any():
        raise SculptFileError(f"point {name!r} has reach {reach} and size {size}; expected both above zero")
    arms = np.concatenate([np.zeros((1, 3)), np.eye(3), -np.eye(3)]) * reach
    if symmetric and at[0] == 0:
        arms = arms[arms[:, 0] >= 0]  # its mirror image is the other half
    return at + arms, to + arms * sizes


def _brush(name: str, row: Any, unit: float) -> Brush:
    """One line of [smooth]."""
    if not isinstance(row, dict) or set(row) != set(BRUSH_KEYS):
        raise SculptFileError(
            f"brush {name!r} is {row!r}; expected {{ at = [x, y, z], reach = length, rounds = count }}"
        )
    x, y, z = (_triple(f"`at` of brush {name!r}", row["at"]) * unit).tolist()
    return Brush((x, y, z), _number(f"`reach` of brush {name!r}", row["reach"]) * unit, row["rounds"])


def _gains(table: Mapping[str, Any]) -> tuple[Gain, ...]:
    """[gains]: for each region a number for all expressions, or numbers by expression and ALL for the others."""
    gains = []
    for region, row in table.items():
        values = row if isinstance(row, dict) else {ALL: row}
        gains += [Gain(region, value, None if name == ALL else name) for name, value in values.items()]  # type: ignore[arg-type]
    return tuple(gains)


def _look(table: Mapping[str, Any]) -> Look:
    _refuse_unknown("the look", table, tuple(Look.__dataclass_fields__))
    return Look(**table)


def _table(table: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    section = table.get(name, {})
    if not isinstance(section, dict):
        raise SculptFileError(f"{name} is {section!r}; expected a table [{name}]")
    return section


def _choice(table: Mapping[str, Any], name: str, choices: tuple[str, ...], usual: str) -> str:
    choice = table.get(name, usual)
    if choice not in choices:
        raise SculptFileError(f"{name} is {choice!r}; expected one of {', '.join(map(repr, choices))}")
    return str(choice)


def _triple(name: str, value: Any) -> Values:
    if not isinstance(value, list) or len(value) != 3:
        raise SculptFileError(f"{name} is {value!r}; expected three numbers")
    return np.array([_number(name, number) for number in value])


def _number(name: str, value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise SculptFileError(f"{name} is {value!r}; expected a finite number")
    return float(value)


def _refuse_unknown(what: str, table: Mapping[str, Any], allowed: tuple[str, ...]) -> None:
    strange = [name for name in table if name not in allowed]
    if strange:
        raise SculptFileError(f"{what} has {strange[0]!r}; expected only {', '.join(allowed)}: correct or remove it")
