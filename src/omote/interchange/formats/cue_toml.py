"""Cue lists as text (TOML), for any editor and for readable differences between two nights (docs/howto/cues.md).

A cue is a table `[[cue]]`; its moves and actions stand below it, a line each. What a cue has as all others have is left
out.
"""

from __future__ import annotations

import csv
import io
import json
import math
import re
import tomllib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import MISSING, Field, fields
from pathlib import Path
from typing import Any

from omote.interchange.formats.atomic_file import write_whole
from omote.interchange.formats.error_reasons import explain_error
from omote.perform.cues.cue import Cue, CueList, Move, check_cues
from omote.perform.cues.cue_action import CueAction, check_actions
from omote.perform.layers.layer_names import check_part
from omote.perform.pads.blend_space import AXES
from omote.perform.scene.clip_goals import ClipCall, clip_of_goal, goal_of_clip
from omote.perform.scene.goals import WITH_FACE, Goal, Part, passes, ranges_of, takes_one_number, whole_of
from omote.perform.scene.pad_goals import PAD, is_pad_goal, point_of_goal

CUE_FIELDS: Mapping[str, Field[Any]] = {
    each.name: each for each in fields(Cue) if each.name not in ("identity", "moves", "actions")
}
MOVE_FIELDS: Mapping[str, Field[Any]] = {each.name: each for each in fields(Move) if each.name != "goal"}
ACTION_FIELDS: Mapping[str, Field[Any]] = {each.name: each for each in fields(CueAction)}
TABLES = ("moves", "actions")
"""What of a cue stands below it."""
FACE = "face"
"""How the text says that a region goes with the whole face."""
STOP = "stop"
"""How it says that clips stop."""
CLIP_FIELDS = ("clip", "start", "speed", "loop", "parts")
"""What it says of a clip that plays otherwise than the clip itself says."""
HEADING = "# Cues of an Omote show (docs/howto/cues.md)."
RUNNING_ORDER = ("number", "label", "pre_wait", "goes_on", "post_wait", "note", "skip", "colour")
"""The columns of a running order."""

_ACTION = re.compile(r"\s*\{")
_CUE = re.compile(r"\s*\[\[\s*cue\s*\]\]")


class CueFileError(ValueError):
    """The text is no cue list; the message has a line for each thing that is wrong, with its place."""


def read_cues(path: str | Path) -> CueList:
    """The cues in a text file (TOML).

    Parameters
    ----------
    path : str or Path
        The file.

    Returns
    -------
    tuple of Cue
        In the order of the file; a cue is the same from one file to another by its number.

    Raises
    ------
    ValueError
        CueFileError: names the file and every line that is wrong, and what was expected there.

    Examples
    --------
    >>> from pathlib import Path
    >>> _ = Path("evening.toml").write_text('''
    ... [[cue]]
    ... number = "1"
    ... [cue.moves]
    ... "one/face" = { to = "dog", seconds = 2 }
    ... ''')
    >>> cues = omote.read_cues("evening.toml")
    >>> cues[0].moves["one/face"].seconds
    2.0

    References
    ----------
    docs/method.md, "Cues".
    """
    path = Path(path)
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise CueFileError(f"{path} cannot be read ({explain_error(error)}); expected a text file with cues") from error
    try:
        return parse_cues(text)
    except CueFileError as error:
        raise CueFileError(f"{path}: {error}") from error


def write_cues(cues: Sequence[Cue], path: str | Path) -> None:
    """Writes cues as a text file (TOML) that `read_cues` reads back as they are.

    Parameters
    ----------
    cues : sequence of Cue
        The list.
    path : str or Path
        The file; cues that are there are replaced whole, any other file stays.

    Raises
    ------
    OSError
        Where it cannot be written, or another file is there.

    Examples
    --------
    >>> omote.write_cues([omote.Cue("1", "1", label="The dog wakes")], "matinee.toml")
    >>> omote.read_cues("matinee.toml")[0].label
    'The dog wakes'

    References
    ----------
    docs/method.md, "Cues".
    """
    write_whole(Path(path), format_cues(cues).encode())


def parse_cues(text: str, /) -> CueList:
    """Parses a cue list; CueFileError with every line that is wrong."""
    try:
        table = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise CueFileError(f"this is no TOML ({error})") from error
    rows = table.get("cue", [])
    lines = _Lines(text)
    wrong = [f"line {lines.of_key(0, key)}: {key!r} is no cue; write [[cue]]" for key in table if key != "cue"]
    if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
        raise CueFileError("a cue is written below [[cue]], with two brackets on each side")
    cues = []
    for place, row in enumerate(rows):
        found, errors = _cue(row, lines, place + 1)
        wrong += errors
        cues += found
    if wrong:
        raise CueFileError("\n".join(sorted(wrong, key=_line_of)))
    try:
        return check_cues(cues)
    except ValueError as error:
        raise CueFileError(str(error)) from error


def format_cues(cues: Iterable[Cue]) -> str:
    """Cues as text that `parse_cues` reads back as they are, but for identities: there a cue is known by its number."""
    return "\n".join([HEADING, *(_format_cue(cue) for cue in cues)])


def format_running_order(cues: Iterable[Cue]) -> str:
    """A running order as comma-separated values, a line for each cue with its moves in words, and a heading."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow((*RUNNING_ORDER, *TABLES))
    for cue in cues:
        values = [getattr(cue, name) for name in RUNNING_ORDER]
        moves = "; ".join(_describe_move(part, move) for part, move in cue.moves.items())
        actions = "; ".join(f"{action.does} {action.to} {action.what}" for action in cue.actions)
        told = [("yes" if value else "") if isinstance(value, bool) else value for value in values]
        table.writerow((*told, moves, actions))
    return text.getvalue()


def _describe_move(part: Part, move: Move) -> str:
    """A move in words, as `one/face dog 2 s after 0.5 s`."""
    goal = _format_goal(part, move.goal).replace('"', "")
    after = f" after {move.delay:g} s" if move.delay else ""
    return f"{part} {goal} {move.seconds:g} s{after}"


def _line_of(sentence: str) -> int:
    """The line that a sentence about it begins with."""
    return int(sentence.removeprefix("line ").partition(":")[0])


class _Lines:
    """The lines of a text: where its cues begin, and where a key stands below one."""

    def __init__(self, text: str) -> None:
        self.lines = text.splitlines()
        self.begins = [0, *(at for at, line in enumerate(self.lines) if _CUE.match(line)), len(self.lines)]

    def of_key(self, cue: int, key: str) -> int:
        """The line of a key below the cue of a number (0: before all); that of the cue itself where it is not found."""
        begin, end = self.begins[cue : cue + 2]
        named = re.compile(rf"\s*(\[cue\.)?[\"']?{re.escape(key)}[\"']?\s*[=\]]")
        return next((at + 1 for at in range(begin, end) if named.match(self.lines[at])), begin + 1)

    def of_action(self, cue: int, place: int) -> int:
        """The line of an action of a cue, at its place from 0, where each has a line of its own; else that of all."""
        first = self.of_key(cue, "actions")
        begun = [at + 1 for at in range(first - 1, self.begins[cue + 1]) if _ACTION.match(self.lines[at])]
        return begun[place] if place < len(begun) else first


def _cue(row: Mapping[str, Any], lines: _Lines, place: int) -> tuple[list[Cue], list[str]]:
    """The cue of a table, and what is wrong with it, each with its line."""
    wrong = [
        f"line {lines.of_key(place, key)}: a cue has no {key!r}; expected {', '.join((*CUE_FIELDS, *TABLES))}"
        for key in row
        if key not in (*CUE_FIELDS, *TABLES)
    ]
    actions, errors = _actions(row.get("actions", []), lines, place)
    wrong += errors
    written = row.get("moves", {})
    moves = {}
    for part, move in written.items() if isinstance(written, dict) else ():
        try:
            moves[part] = _move(part, move)
            Cue("", "0", {part: moves[part]})
        except (ValueError, TypeError) as error:
            wrong.append(f"line {lines.of_key(place, part)}: {error}")
    if not isinstance(written, dict):
        wrong.append(
            f"line {lines.of_key(place, 'moves')}: the moves are {written!r}; expected [cue.moves] and lines below"
        )
    given = {key: value for key, value in row.items() if key in CUE_FIELDS}
    for key, value in given.items():
        try:
            Cue(**{"identity": "", "number": "0", key: value})
        except (ValueError, TypeError) as error:
            wrong.append(f"line {lines.of_key(place, key)}: {error}")
    if "number" not in given:
        wrong.append(f'line {lines.of_key(place, "number")}: a cue has no number; write number = "1"')
    return ([] if wrong else [Cue(identity=given["number"], moves=moves, actions=actions, **given)]), wrong


def _actions(written: Any, lines: _Lines, cue: int) -> tuple[tuple[CueAction, ...], list[str]]:
    """The actions of the cue at a place, and what is wrong with them, each with its line."""
    if not isinstance(written, list):
        return (), [f"line {lines.of_key(cue, 'actions')}: the actions are {written!r}; expected a row of {{ ... }}"]
    actions = []
    wrong = []
    for place, each in enumerate(written):
        try:
            actions.append(_action(each))
        except (ValueError, TypeError) as error:
            wrong.append(f"line {lines.of_action(cue, place)}: {error}")
    try:
        check_actions(actions)
    except ValueError as error:
        wrong.append(f"line {lines.of_key(cue, 'actions')}: {error}")
    return tuple(actions), wrong


def _action(written: Any) -> CueAction:
    if not isinstance(written, dict) or not {"does", "to", "what"} <= written.keys():
        raise ValueError(f'an action is {written!r}; expected {{ does = "osc", to = "10.0.0.2:53000", what = "/go" }}')
    strange = [key for key in written if key not in ACTION_FIELDS]
    if strange:
        raise ValueError(f"an action has no {strange[0]!r}; expected {', '.join(ACTION_FIELDS)}")
    texts = [name for name in ("does", "to", "what", "voice", "sound") if not isinstance(written.get(name, ""), str)]
    if texts:
        raise ValueError(f"the {texts[0]} of an action is {written[texts[0]]!r}; expected a text in quotes")
    return CueAction(**written)


def _move(part: Part, written: Any) -> Move:
    if not isinstance(written, dict) or "to" not in written:
        raise ValueError(f"the move of {part} is {written!r}; expected {{ to = ..., seconds = 1 }}")
    strange = [key for key in written if key not in (*MOVE_FIELDS, "to")]
    if strange:
        raise ValueError(f"a move has no {strange[0]!r}; expected {', '.join(('to', *MOVE_FIELDS))}")
    return Move(_goal(part, written["to"]), **{key: value for key, value in written.items() if key != "to"})


def _goal(part: Part, to: Any) -> Goal:
    """A goal as text has it: a name, a number where the part has one alone, or all weights or numbers by name."""
    ranges = ranges_of(part)
    if isinstance(to, str) and ranges is None:
        return WITH_FACE if to == _nothing(part) else {to: 1.0}
    if isinstance(to, int | float) and ranges is not None and takes_one_number(part):
        return dict.fromkeys(ranges, to)
    if isinstance(to, dict) and passes(part) and isinstance(to.get("clip"), str):
        return _clip_goal(to)
    if isinstance(to, dict) and isinstance(to.get("pad"), str):
        return {f"{PAD}{to['pad']}": 1.0, **{f":{axis}": at for axis, at in to.items() if axis != "pad"}}
    if isinstance(to, dict):
        return to
    expected = (
        "a name, or weights by name" if ranges is None else f"{{ {', '.join(f'{name} = 0' for name in ranges)} }}"
    )
    raise ValueError(f"{part} goes to {to!r}; expected {expected}")


def _clip_goal(to: Mapping[str, Any]) -> Goal:
    """A clip with how it plays: parts are named, or each with its weight."""
    strange = [key for key in to if key not in CLIP_FIELDS]
    if strange:
        raise ValueError(f"a clip has no {strange[0]!r}; expected {', '.join(CLIP_FIELDS)}")
    loop = to.get("loop")
    if not isinstance(loop, bool | None):
        raise TypeError(f"the loop of a clip is {loop!r}; expected true or false")
    parts = to.get("parts")
    if isinstance(parts, list) and all(isinstance(each, str) for each in parts):
        parts = dict.fromkeys(parts, 1.0)
    if not (parts is None or (isinstance(parts, dict) and parts)):
        raise ValueError(
            f'the parts of a clip are {parts!r}; expected ["mouth", "head"] or {{ mouth = 0.5, head = 1 }}'
        )
    for each in parts or ():
        check_part(each)
    return goal_of_clip(ClipCall(to["clip"], to.get("start"), to.get("speed"), loop, parts))


def _nothing(part: Part) -> str | None:
    """The word for a goal without names, where a part can have one."""
    return FACE if whole_of(part) else STOP if passes(part) else None


def _format_cue(cue: Cue) -> str:
    lines = ["[[cue]]"]
    lines += [f"{name} = {_value(getattr(cue, name))}" for name, each in CUE_FIELDS.items() if _differs(cue, each)]
    if cue.actions:
        lines += ["actions = [", *(f"  {_format_action(action)}," for action in cue.actions), "]"]
    if cue.moves:
        lines += ["[cue.moves]", *(f"{_value(part)} = {_format_move(part, move)}" for part, move in cue.moves.items())]
    return "\n".join(lines) + "\n"


def _format_move(part: Part, move: Move) -> str:
    said = {"to": _format_goal(part, move.goal)}
    said |= {name: _value(getattr(move, name)) for name, each in MOVE_FIELDS.items() if _differs(move, each)}
    return f"{{ {', '.join(f'{name} = {value}' for name, value in said.items())} }}"


def _format_action(action: CueAction) -> str:
    said = [f"{name} = {_value(getattr(action, name))}" for name, of in ACTION_FIELDS.items() if _differs(action, of)]
    return f"{{ {', '.join(said)} }}"


def _format_goal(part: Part, goal: Goal) -> str:
    if not goal:
        return _value(_nothing(part) or FACE)
    name, value = next(iter(goal.items()))
    if takes_one_number(part) and set(goal.values()) == {value}:
        return _value(value)
    if is_pad_goal(part, goal):
        pad, place = point_of_goal(goal)
        numbers = (f"{axis} = {_value(at)}" for axis, at in zip(AXES, place, strict=False))
        return f"{{ {', '.join((f'pad = {_value(pad)}', *numbers))} }}"
    if passes(part) and len(goal) > 1:
        return _format_clip(clip_of_goal(goal))
    if goal == {name: 1.0} and ranges_of(part) is None and name != _nothing(part):
        return _value(name)
    return f"{{ {', '.join(f'{_value(each)} = {_value(number)}' for each, number in goal.items())} }}"


def _format_clip(call: ClipCall) -> str:
    said = {"clip": call.name, "start": call.start, "speed": call.speed, "loop": call.loop}
    written = {name: _value(value) for name, value in said.items() if value is not None}
    weights = {} if call.weights is None else call.weights
    if weights and set(weights.values()) == {1.0}:
        written["parts"] = f"[{', '.join(_value(part) for part in weights)}]"
    elif weights:
        written["parts"] = f"{{ {', '.join(f'{part} = {_value(weight)}' for part, weight in weights.items())} }}"
    return f"{{ {', '.join(f'{name} = {value}' for name, value in written.items())} }}"


def _differs(of: object, each: Field[Any]) -> bool:
    """Whether a field has to be written: it has no default, or is another."""
    return each.default is MISSING or getattr(of, each.name) != each.default


def _value(value: str | float | bool) -> str:
    """A value of TOML; the escapes of a JSON text are TOML's too, but for one character that JSON leaves bare."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    return repr(value) if math.isfinite(value) else "inf"
