"""The pads that a show keeps, and what takes the last changes of them back."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from omote.perform.limits import check_free, check_known, check_within
from omote.perform.newest_entries import with_newest
from omote.perform.pads.blend_space import MOST_PADS, Pad, check_pad_name

MOST_REPLACED = 16
"""Changes of pads that can be taken back."""


@dataclass(frozen=True)
class PadChange:
    """What some names stood for before a change, None for nothing. renamed: the name that a pad had then, and the one
    that it was given."""

    before: Mapping[str, Pad | None]
    renamed: tuple[str, str] | None = None


@dataclass(frozen=True)
class Pads:
    """The pads of a scene by name, in the order in which they came, and by key what was changed, the oldest first."""

    kept: Mapping[str, Pad] = field(default_factory=dict)
    changes: Mapping[str, PadChange] = field(default_factory=dict)


NO_PADS = Pads()


def with_pads(pads: Pads, added: Mapping[str, Pad], key: str, *, goes_on: bool = False) -> Pads:
    """The pads with some more, or with others under their names; ValueError where there are too many.

    added: by name; key: what `with_change_back` finds those before by; goes_on: changes of the same pads under one key,
    one after the other, are one: whoever drags a look takes the whole way back.
    """
    before = {name: pads.kept.get(name) for name in added}
    last = pads.changes.get(key)
    if goes_on and last is not None and [*pads.changes][-1] == key and last.before.keys() == before.keys():
        before = dict(last.before)
    return _changed(pads, {**pads.kept, **added}, PadChange(before), key)


def with_name(pads: Pads, name: str, other: str, key: str) -> Pads:
    """The pads with one of them under another name, in its place; ValueError where that is taken, or none.

    name: of the pad; other: its new one; key: what `with_change_back` finds it by.
    """
    check_known(name, pads.kept, "pad")
    check_pad_name(other)
    check_free(other, (each for each in pads.kept if each != name), "pad")
    renamed = {
        other if each == name else each: replace(pad, name=other) if each == name else pad
        for each, pad in pads.kept.items()
    }
    return _changed(pads, renamed, PadChange({name: pads.kept[name], other: None}, (name, other)), key)


def with_copy(pads: Pads, name: str, other: str, key: str) -> Pads:
    """The pads with a copy of one (name), last of all; ValueError where its name is taken, or none.

    other: the name of the copy; key: what `with_change_back` finds it by.
    """
    check_known(name, pads.kept, "pad")
    check_free(check_pad_name(other), pads.kept, "pad")
    return with_pads(pads, {other: replace(pads.kept[name], name=other)}, key)


def without_pad(pads: Pads, name: str, key: str) -> Pads:
    """The pads without one; ValueError where there is none of the name. key: what `with_change_back` finds it by."""
    check_known(name, pads.kept, "pad")
    kept = {other: pad for other, pad in pads.kept.items() if other != name}
    return _changed(pads, kept, PadChange({name: pads.kept[name]}), key)


def with_change_back(pads: Pads, key: str) -> tuple[Pads, dict[str, str]]:
    """The pads as before a change, and what pads were called, with what they are called again.

    key: what the change was given; ValueError where there is none. Asked again, they are as after it.
    """
    change = pads.changes[check_known(key, pads.changes, "change of a pad")]
    again = PadChange({name: pads.kept.get(name) for name in change.before})
    renamed: dict[str, str] = {}
    if change.renamed is not None and change.renamed[1] in pads.kept:
        before, now = change.renamed
        renamed = {now: before}
        again = replace(again, renamed=(now, before))
        kept = {before if name == now else name: pad for name, pad in pads.kept.items()}
    else:
        kept = dict(pads.kept)
    put = {**kept, **change.before}
    return _changed(pads, {name: pad for name, pad in put.items() if pad is not None}, again, key), renamed


def renamed_between(before: Mapping[str, Pad], after: Mapping[str, Pad]) -> dict[str, str]:
    """What pads were called, with what they are called now: in the same place, and as they were in all else.

    before, after: pads by name.
    """
    if len(before) != len(after):
        return {}
    pairs = zip(before.values(), after.values(), strict=True)
    renamed = {was.name: now.name for was, now in pairs if was.name != now.name}
    same = all(replace(before[name], name=to) == after[to] for name, to in renamed.items())
    return renamed if same and not renamed.keys() & after.keys() and not before.keys() & {*renamed.values()} else {}


def _changed(pads: Pads, kept: Mapping[str, Pad], change: PadChange, key: str) -> Pads:
    if len(kept) > MOST_PADS and len(kept) > len(pads.kept):
        raise ValueError(f"there are {MOST_PADS} pads, which is as many as a show keeps; delete one")
    return Pads(dict(kept), with_newest(pads.changes, key, change, MOST_REPLACED))


def check_pads(pads: Pads) -> None:
    """Rejects pads that no scene has kept; whether a cast has their looks is asked when they are moved."""
    check_within(len(pads.kept), 0, MOST_PADS, "the number of pads")
    check_within(len(pads.changes), 0, MOST_REPLACED, "the number of changes of pads that can be taken back")
    for name, pad in (
        *pads.kept.items(),
        *(each for change in pads.changes.values() for each in change.before.items()),
    ):
        if pad is not None and pad.name != name:
            raise ValueError(f"the pad {pad.name} is kept as {name[:80]!r}; expected one name")
