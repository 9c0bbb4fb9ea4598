"""The edits of cues, each a function of the book, of what shows, and of what is asked for."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from omote.perform.cues.cue import Cue, Move, check_cue_number, in_order, is_of, with_move
from omote.perform.cues.cue_names import named_cue, named_part
from omote.perform.cues.tracking import NOTHING_TRACKED, Tracked, tracked_at
from omote.perform.limits import check_known
from omote.perform.scene.character_names import ALL, find_character
from omote.perform.scene.goals import (
    CHARACTER_PARTS,
    SCENE_PARTS,
    Goal,
    Part,
    first_goal,
    is_of_macros,
    ranges_of,
    regions_of,
    split_part,
    whole_of,
)
from omote.perform.scene.pad_goals import is_pad_goal
from omote.perform.scene.scene import Scene
from omote.show.cues.cue_book import (
    CueBook,
    check_list_name,
    edit_cues,
    new_identities,
    next_number,
    place_number,
    renumbered,
)
from omote.show.objects import cues as wire


@dataclass(frozen=True)
class LookedAt:
    """A cue that is looked at in preview, and how all parts stood when that began. cue_list: its list; cue: by
    identity, "" for none."""

    cue_list: str = ""
    cue: str = ""
    goals: Mapping[Part, Goal] = field(default_factory=dict)


DECIMALS = 4
"""Of the numbers that are recorded: a tenth of a millimetre, and less than a hundredth of a degree."""
ON_AIR = LookedAt()
"""No cue is looked at: what is edited is what shows on air, or what was built up."""


@dataclass(frozen=True)
class EditContext:
    """What an edit begins from: the book, what shows, the list that is meant, the cue of it that was called last (by
    identity), who edits, and the cue that is looked at instead."""

    book: CueBook
    scene: Scene
    chosen: str
    current: str | None
    by: str
    looked_at: LookedAt = ON_AIR

    def edit(
        self,
        what: str,
        cues: Mapping[str, Cue | None],
        orders: Mapping[str, Sequence[str] | None] | None = None,
    ) -> CueBook:
        """The book after an edit. what: is done; cues, orders: as of `edit_cues`."""
        named = {identity: None if cue is None else self._as_shown(cue) for identity, cue in cues.items()}
        return edit_cues(self.book, what, self.by, named, orders or {})

    def _as_shown(self, cue: Cue) -> Cue:
        """A cue with its characters by name, in the order of the show."""
        named = named_cue(cue, self.scene.labels)
        return replace(named, moves={part: named.moves[part] for part in in_order(named.moves, self.scene)})

    def cue(self, identity: str) -> Cue:
        """The cue of an identity; ValueError where it is gone."""
        self.book.list_of(identity)
        return self.book.cues[identity]


def put_cue(context: EditContext, message: wire.PutCue) -> CueBook:
    """A new cue, or one with other fields. context: what it begins from; message: says which, and what is given of
    it."""
    names = ("number", "label", "note", "colour", "pre_wait", "post_wait", "goes_on", "skip", "actions")
    given = {name: value for name in names if (value := getattr(message, name)) is not None}
    if message.cue:
        cue = context.cue(message.cue)
        changed = replace(cue, **given)
        return context.edit(f"change cue {changed.number}", {cue.identity: changed})
    after = message.after or None
    if after is not None:
        check_known(after, context.book.orders[context.chosen], "cue of this list")
    number = given.pop("number", "") or next_number(context.book, context.chosen, after)
    cue = Cue(new_identities(context.book, 1)[0], number, **given)
    return context.edit(f"new cue {number}", {cue.identity: cue}, _inserted(context, cue, after))


def put_move(context: EditContext, message: wire.PutMove) -> CueBook:
    """A cue with a move of a part. context: what it begins from; message: says which."""
    cue = context.cue(message.cue)
    part = named_part(message.part, context.scene.labels)
    split_part(part)
    move = Move(message.goal, message.seconds, message.easing, message.delay)
    return context.edit(f"{part} in cue {cue.number}", {cue.identity: with_move(cue, part, move)})


def drop_move(context: EditContext, message: wire.DropMove) -> CueBook:
    """A cue without the move of a part. context: what it begins from; message: says which."""
    cue = context.cue(message.cue)
    named = named_part(message.part, context.scene.labels)
    part = check_known(message.part if message.part in cue.moves else named, cue.moves, "part of this cue")
    return context.edit(f"no {part} in cue {cue.number}", {cue.identity: with_move(cue, part, None)})


def record_cue(context: EditContext, message: wire.RecordCue) -> CueBook:
    """A new cue of what shows. context: what it begins from; message: says its number, and which parts."""
    order = context.book.orders[context.chosen]
    after = context.current if context.current in order else None
    number = message.cue or next_number(context.book, context.chosen, after)
    cues = context.book.cues_of(context.chosen)
    place = place_number(context.book, context.chosen, check_cue_number(number))
    tracked = tracked_at(cues, place - 1) if place else NOTHING_TRACKED
    goals = _chosen(context.scene, message.parts) if message.parts else _changed(context, tracked)
    if not goals:
        raise ValueError(
            "there is nothing to record: all stands as the cues before it leave it; change something first, or name "
            "what is recorded"
        )
    moves = {part: Move(goal, message.seconds) for part, goal in goals.items()}
    cue = Cue(new_identities(context.book, 1)[0], number, moves, label=message.label)
    return context.edit(f"record cue {number}", {cue.identity: cue}, _inserted(context, cue, None))


def update_cue(context: EditContext, message: wire.UpdateCue) -> CueBook:
    """A cue with what shows. context: what it begins from; message: says which, the one that was called last where it
    names none."""
    if not message.cue and context.current is None:
        raise ValueError("no cue has been called that could be updated; name one, or record a new one")
    cue = context.cue(message.cue or context.current or "")
    cues = context.book.cues_of(context.book.list_of(cue.identity))
    tracked = tracked_at(cues, [each.identity for each in cues].index(cue.identity))
    changed = cue
    for part, goal in _changed(context, tracked).items():
        before = cue.moves.get(part, Move(goal))
        changed = with_move(changed, part, replace(before, goal=goal))
    return context.edit(f"update cue {cue.number}", {cue.identity: changed})


def copy_cue(context: EditContext, message: wire.CopyCue) -> CueBook:
    """A copy of a cue. context: what it begins from; message: says which, and behind which it comes."""
    cue = context.cue(message.cue)
    after = message.after or cue.identity
    name = context.book.list_of(after)
    copy = replace(cue, identity=new_identities(context.book, 1)[0], number=next_number(context.book, name, after))
    return context.edit(
        f"copy cue {cue.number}", {copy.identity: copy}, {name: _behind(context.book, name, copy, after)}
    )


def move_cue(context: EditContext, message: wire.MoveCue) -> CueBook:
    """The list of a cue with it at another place. context: what it begins from; message: says which, and behind which
    it comes."""
    cue = context.cue(message.cue)
    name = context.book.list_of(cue.identity)
    others = [identity for identity in context.book.orders[name] if identity != cue.identity]
    place = 0 if not message.after else others.index(check_known(message.after, others, "cue of this list")) + 1
    order = [*others[:place], cue.identity, *others[place:]]
    return context.edit(f"move cue {cue.number}", {}, {name: order})


def drop_cue(context: EditContext, message: wire.DropCue) -> CueBook:
    """The list of a cue without it. context: what it begins from; message: says which."""
    cue = context.cue(message.cue)
    name = context.book.list_of(cue.identity)
    order = [identity for identity in context.book.orders[name] if identity != cue.identity]
    return context.edit(f"delete cue {cue.number}", {cue.identity: None}, {name: order})


def renumber_cues(context: EditContext, message: wire.RenumberCues) -> CueBook:
    """A list with new numbers. context: what it begins from; message: says the first, and the step."""
    return context.edit("renumber cues", renumbered(context.book, context.chosen, message.first, message.step))


def add_cue_list(context: EditContext, message: wire.AddCueList) -> CueBook:
    """One list more. context: what it begins from; message: says its name."""
    name = _free_name(context, message.cue_list)
    return context.edit(f"new list {name}", {}, {name: []})


def rename_cue_list(context: EditContext, message: wire.RenameCueList) -> CueBook:
    """A list under another name. context: what it begins from; message: says which."""
    name = _free_name(context, message.to)
    order = context.book.orders[context.chosen]
    return context.edit(f"rename list {context.chosen} to {name}", {}, {context.chosen: None, name: order})


def drop_cue_list(context: EditContext, message: wire.DropCueList) -> CueBook:  # noqa: ARG001  (as all edits)
    """No list of a name. context: what it begins from; message: says which."""
    gone = dict.fromkeys(context.book.orders[context.chosen])
    return context.edit(f"delete list {context.chosen}", gone, {context.chosen: None})


EDITS: Mapping[type[wire.CueCommand], Callable[[EditContext, Any], CueBook]] = {
    wire.PutCue: put_cue,
    wire.PutMove: put_move,
    wire.DropMove: drop_move,
    wire.RecordCue: record_cue,
    wire.UpdateCue: update_cue,
    wire.CopyCue: copy_cue,
    wire.MoveCue: move_cue,
    wire.DropCue: drop_cue,
    wire.RenumberCues: renumber_cues,
    wire.AddCueList: add_cue_list,
    wire.RenameCueList: rename_cue_list,
    wire.DropCueList: drop_cue_list,
}
"""What makes each edit."""


def shown_goals(scene: Scene) -> dict[Part, Goal]:
    """Where every part of a scene stands, but for who is leaving it, as cues keep it."""
    parts = [f"{name}/{part}" for name in scene for part in CHARACTER_PARTS]
    parts += [f"{ALL}/{part}" for part in SCENE_PARTS]
    return {part: _rounded(part, scene.shown_goal(part)) for part in parts}


def differing(scene: Scene, tracked: Tracked) -> dict[Part, Goal]:
    """The parts that stand otherwise than cues leave them, or a new show has them where nobody means to set that: a
    region goes with its face, eyes look ahead, layers show. scene: what shows; tracked: what the cues leave."""
    shown = shown_goals(scene)
    return {part: goal for part, goal in shown.items() if goal != _left_by(tracked, part)}


def _left_by(tracked: Tracked, part: Part) -> Goal | None:
    """Where cues (tracked) leave a part, as `shown_goals` has it; as a new show where they say nothing of it."""
    return _rounded(part, tracked[part]) if part in tracked else first_goal(part)


def _rounded(part: Part, goal: Goal) -> Goal:
    """A goal with the numbers that its part stands at as a text shows them: a hand and a tracker give sixteen
    digits. One at the end of its range, which lies between two such numbers, stays."""
    ranges = ranges_of(part)
    if is_pad_goal(part, goal) or is_of_macros(part):
        return {name: round(value, DECIMALS) for name, value in goal.items()}
    if ranges is None:
        return goal
    rounded = {name: round(value, DECIMALS) for name, value in goal.items()}
    return {
        name: rounded[name] if low <= rounded[name] <= high else goal[name]
        for name, (low, high) in ranges.items()
        if name in goal
    }


def _changed(context: EditContext, tracked: Tracked) -> dict[Part, Goal]:
    """The parts that stand otherwise than cues leave them (tracked); of a cue that is looked at, what no cue moves only
    where it was changed since. An expression of the whole face takes its regions along: those that stand by themselves
    are recorded with it, also where no cue has to move them."""
    found = context.looked_at.goals
    shown = differing(context.scene, tracked)
    changed = {part: goal for part, goal in shown.items() if part in tracked or goal != found.get(part)}
    taken = {region for part in changed for region in regions_of(part)}
    alone = {part: goal for part, goal in shown_goals(context.scene).items() if part in taken and goal}
    return {**alone, **changed}


def _chosen(scene: Scene, wanted: Sequence[str]) -> dict[Part, Goal]:
    """The parts that are named, and of characters that are named all: whatever plays before, their cue brings back what
    shows. Regions go with the whole expression, unless they stand by themselves."""
    shown = shown_goals(scene)
    wanted = [_wanted(each, scene.labels) for each in wanted]
    for each in wanted:
        if each not in scene:
            check_known(each, shown, "part")
    names = [each for each in wanted if each in scene]
    kept = {part: goal for part, goal in shown.items() if part in wanted or is_of(part, names)}
    return {part: goal for part, goal in kept.items() if part in wanted or goal or whole_of(part) not in kept}


def _wanted(written: str, labels: Mapping[str, str]) -> str:
    """A part, or all of a character, that is to be recorded, by the name of that character; ValueError where there is
    none. labels: what people call each, by name."""
    character, _, name = written.rpartition("/")
    if character == ALL:
        return written
    return f"{find_character(character, labels)}/{name}" if character else find_character(written, labels)


def _inserted(context: EditContext, cue: Cue, after: str | None) -> dict[str, Sequence[str]]:
    """The order of the chosen list with a new cue: behind another, or where its number belongs."""
    if after is not None:
        return {context.chosen: _behind(context.book, context.chosen, cue, after)}
    order = context.book.orders[context.chosen]
    place = place_number(context.book, context.chosen, cue.number)
    return {context.chosen: [*order[:place], cue.identity, *order[place:]]}


def _behind(book: CueBook, name: str, cue: Cue, after: str) -> list[str]:
    order = book.orders[name]
    place = order.index(after) + 1
    return [*order[:place], cue.identity, *order[place:]]


def _free_name(context: EditContext, wanted: str) -> str:
    name = check_list_name(wanted)
    if name.casefold() in (other.casefold() for other in context.book.orders):
        raise ValueError(f"there is a list of cues {name!r} already; give another name")
    return name
