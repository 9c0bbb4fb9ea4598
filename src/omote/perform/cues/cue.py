"""Cues: sparse, tracking. A cue says only what it moves; all else goes on as the cues before it left it."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Literal, get_args

from omote.perform.cues.cue_action import CueAction, check_actions
from omote.perform.easing import DEFAULT_EASING, find_easing
from omote.perform.limits import LONGEST_CALL, check_known, check_switch, check_within
from omote.perform.scene.character_names import ALL
from omote.perform.scene.goals import CHARACTER_PARTS, SCENE_PARTS, Goal, Part, check_goal

GoesOn = Literal["", "continue", "follow"]
"""What comes after a cue by itself: nothing; the next one, counted from its begin (auto-continue); the next one,
counted from its end (auto-follow)."""

NUMBER = re.compile(r"(0|[1-9]\d{0,4})(\.\d{0,2}[1-9])?")
LONGEST_TEXT = {"label": 80, "note": 400, "colour": 20}
"""Characters."""
MOST_CUES = 2000
"""Of a list."""


@dataclass(frozen=True)
class Move:
    """A part's way to a goal, in a cue.

    Parameters
    ----------
    goal : mapping of float
        Where it goes, as `Scene.goal_of` gives it.
    seconds : float
        How long it takes, 0 to 3600; 0 cuts.
    easing : {"smooth", "gentle", "sharp", "early", "late"}
        The curve of the way.
    delay : float
        Seconds after the cue has begun, 0 to 3600.

    Raises
    ------
    ValueError
        On an easing that there is not and on times out of range.
    TypeError
        On what is no number.

    Examples
    --------
    >>> omote.Move({"dog": 1.0}, seconds=2, delay=0.5).length
    2.5

    References
    ----------
    docs/method.md, "Cues".
    """

    goal: Goal
    seconds: float = 1.0
    easing: str = DEFAULT_EASING
    delay: float = 0.0

    def __post_init__(self) -> None:
        """Rejects times and easings that there are not."""
        find_easing(self.easing)
        for name in ("seconds", "delay"):
            object.__setattr__(self, name, _seconds(getattr(self, name), f"the {name} of a move"))
        object.__setattr__(self, "goal", dict(self.goal))

    @property
    def length(self) -> float:
        """Seconds from the begin of its cue to its end."""
        return self.delay + self.seconds


@dataclass(frozen=True)
class Cue:
    """What one GO plays: it says what it moves, and all else goes on as the cues before it have left it.

    Parameters
    ----------
    identity : str
        Its own for ever, whatever it is numbered.
    number : str
        Decimal, 0 to 99999 and at most three decimals, as "12.5".
    moves : mapping of Move
        By part, as of `Scene.goal_of`; they are kept character by character, as these come first, the scene last.
    label, note, colour : str
        For people, to 80, 400 and 20 characters.
    pre_wait : float
        Seconds from GO to its begin, 0 to 3600.
    post_wait : float
        Seconds more until what goes on by itself, 0 to 3600.
    goes_on : {"", "continue", "follow"}
        What comes after it by itself: nothing, the next cue after its begin, the next cue after its end.
    skip : bool
        Whether GO passes it by.
    actions : tuple of CueAction
        What it sends to others, and what is said.

    Raises
    ------
    ValueError
        On a number, a part, a goal or a time that no cue has.
    TypeError
        On what is no number or no switch.

    Examples
    --------
    >>> cue = omote.Cue("dog", "12.5", {"one/face": omote.Move({"dog": 1.0}, seconds=2)}, goes_on="follow", post_wait=1)
    >>> cue.length, cue.next_after
    (2.0, 3.0)

    References
    ----------
    docs/method.md, "Cues".
    """

    identity: str
    number: str
    moves: Mapping[Part, Move] = field(default_factory=dict)
    label: str = ""
    note: str = ""
    colour: str = ""
    pre_wait: float = 0.0
    post_wait: float = 0.0
    goes_on: GoesOn = ""
    skip: bool = False
    actions: tuple[CueAction, ...] = ()

    def __post_init__(self) -> None:
        """Rejects numbers, times and texts that no cue has."""
        check_cue_number(self.number)
        check_known(self.goes_on, get_args(GoesOn), "way to go on after a cue")
        check_switch(self.skip, f"whether the cue {self.number} is skipped")
        for name in ("pre_wait", "post_wait"):
            object.__setattr__(self, name, _seconds(getattr(self, name), f"the {name} of the cue {self.number}"))
        for name, most in LONGEST_TEXT.items():
            if len(getattr(self, name)) > most:
                raise ValueError(f"the {name} of the cue {self.number} is longer than {most} characters; shorten it")
        object.__setattr__(self, "actions", check_actions(self.actions))
        ordered = in_order(self.moves)
        for part in ordered:
            check_goal(part, self.moves[part].goal)
        object.__setattr__(self, "moves", {part: self.moves[part] for part in ordered})

    @property
    def length(self) -> float:
        """Seconds from its begin until nothing of it moves, or is still to be done."""
        lengths = (move.length for move in self.moves.values())
        return max((*lengths, *(action.delay for action in self.actions)), default=0.0)

    @property
    def next_after(self) -> float | None:
        """Seconds from its GO until the next one follows by itself; None where nobody follows."""
        if not self.goes_on:
            return None
        return self.pre_wait + (self.length if self.goes_on == "follow" else 0.0) + self.post_wait


_PLACES = {name: place for place, name in enumerate((*CHARACTER_PARTS, *SCENE_PARTS))}

CueList = tuple[Cue, ...]
"""In the order in which GO plays them."""


def check_cue_number(number: object) -> str:
    """Returns the number of a cue; ValueError where none can have it."""
    if isinstance(number, str) and NUMBER.fullmatch(number):
        return number
    raise ValueError(f"a cue cannot be numbered {number!r}; give 0 to 99999 and at most three decimals, such as 12.5")


def write_cue_number(number: float) -> str:
    """The number of a cue as text, as 12.5 is "12.5"; ValueError where none can have it. number: to thousandths."""
    return check_cue_number(f"{number:.3f}".rstrip("0").rstrip("."))


def check_cues(cues: Sequence[Cue]) -> CueList:
    """Returns the cues of a list; ValueError where two have one number, or there are too many."""
    if len(cues) > MOST_CUES:
        raise ValueError(f"the list has {len(cues)} cues; a list holds {MOST_CUES}, begin another")
    for what in ("number", "identity"):
        twice = [value for value, count in Counter(getattr(cue, what) for cue in cues).items() if count > 1]
        if twice:
            raise ValueError(f"two cues have the {what} {twice[0]}; give one of them another")
    return tuple(cues)


def in_order(parts: Iterable[Part], characters: Iterable[str] = ()) -> list[Part]:
    """Parts as people read them: character by character, each from its face on (a whole expression before its
    regions, which it takes along), the scene last. parts: which; characters: who come first; all others as they
    come."""
    listed = list(parts)
    owners = [*characters, *(part.rpartition("/")[0] for part in listed)]
    places = {owner: place for place, owner in enumerate(dict.fromkeys(owners))}

    def rank(part: Part) -> tuple[bool, int, int]:
        owner, _, name = part.rpartition("/")
        return owner == ALL, places[owner], _PLACES.get(name, len(_PLACES))

    return sorted(listed, key=rank)


def is_of(part: Part, characters: Sequence[str]) -> bool:
    """Whether a part belongs to one of some characters."""
    return part.rpartition("/")[0] in characters


def with_move(cue: Cue, part: Part, move: Move | None) -> Cue:
    """The cue with another move of a part, or without one (None)."""
    others = {name: kept for name, kept in cue.moves.items() if name != part}
    return replace(cue, moves=others if move is None else {**others, part: move})


def _seconds(value: object, what: str) -> float:
    return check_within(value, 0.0, LONGEST_CALL, f"{what} (seconds)")
