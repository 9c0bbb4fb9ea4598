"""The characters that cues name as people write them, by their labels too: `Anna/face`, `character Anna`, a line of
Anna. Cues are tracked part by part, so they have the names of characters once these are known."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import replace

from omote.perform.cues.cue import Cue, Move
from omote.perform.cues.cue_action import CueAction, SpokenLine
from omote.perform.scene.character_names import ALL, find_character
from omote.perform.scene.framings import names_in, size_in, write_framing
from omote.perform.scene.goals import Goal, Part
from omote.perform.scene.look_goals import name_in

Labels = Mapping[str, str]


def named_character(written: str, labels: Labels) -> str:
    """The name of a character that is written by its label; as it is written where none is meant. labels: what people
    call each, by name."""
    if written != ALL:
        with suppress(ValueError):
            return find_character(written, labels)
    return written


def named_part(part: Part, labels: Labels) -> Part:
    """A part by the name of its character. labels: as of `named_character`."""
    character, _, name = part.rpartition("/")
    return f"{named_character(character, labels)}/{name}" if character else part


def named_goal(part: Part, goal: Goal, labels: Labels) -> Goal:
    """A goal of a part with the names of the characters that it looks at or frames. labels: as of
    `named_character`."""
    if part.endswith("/look") and (looked := name_in(dict(goal))):
        return {f"character {named_character(looked, labels)}": 1.0}
    if part == f"{ALL}/framing":
        framings = {each: _named_framing(each, labels) for each in goal}
        if len(set(framings.values())) == len(goal):  # else two become one, and the cue says which when it is called
            return {framings[each]: weight for each, weight in goal.items()}
    return goal


def _named_framing(framing: str, labels: Labels) -> str:
    """Nobody of a label stays as written."""
    return write_framing((named_character(name, labels) for name in names_in(framing)), size_in(framing))


def named_cue(cue: Cue, labels: Labels) -> Cue:
    """A cue with the names of the characters that it writes by their labels; nobody of a label stays as written, for a
    list is often written before its characters come.

    cue: as it is; labels: as of `named_character`.
    """
    moves: dict[Part, Move] = {}
    for part, move in cue.moves.items():
        meant = named_part(part, labels)
        is_taken = meant in moves or (meant != part and meant in cue.moves)
        kept = part if is_taken else meant  # of two moves of one part none is dropped
        moves[kept] = replace(move, goal=named_goal(kept, move.goal, labels))
    actions = tuple(_named_action(action, labels) for action in cue.actions)
    return cue if (moves, actions) == (cue.moves, cue.actions) else replace(cue, moves=moves, actions=actions)


def named_cues(cues: Sequence[Cue], labels: Labels) -> tuple[Cue, ...]:
    """Cues as `named_cue` has each. cues: as they are; labels: as of `named_character`."""
    return tuple(named_cue(cue, labels) for cue in cues)


def _named_action(action: CueAction, labels: Labels) -> CueAction:
    if not isinstance(action.meant, SpokenLine):
        return action
    named = named_character(action.meant.character, labels)
    return action if named == action.to else replace(action, to=named)
