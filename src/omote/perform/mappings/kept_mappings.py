"""The mappings that a character has, and what was changed of them and can be taken back."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from omote.perform.limits import check_free, check_known, check_within
from omote.perform.mappings.mapping import MacroMapping, check_macro_name
from omote.perform.newest_entries import with_newest

MOST_MAPPINGS = 64
"""Of one character."""
MOST_REPLACED = 16
"""Changes that can be taken back."""
READS_MACRO = "macro/"
"""What a condition begins with that reads another macro."""

ByName = Mapping[str, MacroMapping]
Change = Mapping[str, MacroMapping | None]
"""What names stand for from now on; None for nothing."""


@dataclass(frozen=True)
class Mappings:
    """The mappings of a character by name, and by key what names stood for before they were changed, the oldest
    first."""

    kept: Mapping[str, MacroMapping] = field(default_factory=dict)
    replaced: Mapping[str, Mapping[str, MacroMapping | None]] = field(default_factory=dict)


NO_MAPPINGS = Mappings()


def with_mapping(mappings: Mappings, mapping: MacroMapping, key: str) -> Mappings:
    """The mappings with one more, or with another under its name; ValueError where there are too many.

    mapping: with its name; key: what `with_restored` finds the one before by.
    """
    return with_change(mappings, {mapping.name: mapping}, key or mapping.name)


def without_mapping(mappings: Mappings, name: str, key: str) -> Mappings:
    """The mappings without one; ValueError where there is none of the name.

    name: of its macro; key: what `with_restored` finds it by.
    """
    return with_change(mappings, {check_known(name, mappings.kept, "macro"): None}, key or name)


def with_renamed(mappings: Mappings, name: str, to: str, key: str) -> Mappings:
    """The mappings with another name for one of them, in conditions too; ValueError for a name that another has.

    name: of its macro; to: the name from now on; key: what `with_restored` finds it by.
    """
    mapping = mappings.kept[check_known(name, mappings.kept, "macro")]
    others = [other for other in mappings.kept if other != name]
    check_free(check_macro_name(to), others, "macro")
    read = {
        other: later
        for other, each in mappings.kept.items()
        if other != name and (later := _reading(each, name, to)) is not each
    }
    return with_change(mappings, {name: None, to: mapping.with_name(to), **read} if to != name else {}, key or name)


def with_all(mappings: Mappings, wanted: ByName, key: str) -> Mappings:
    """These mappings in the place of all that there are. wanted: by name; key: what `with_restored` finds those before
    by."""
    return with_change(mappings, {**dict.fromkeys(mappings.kept), **wanted}, key)


def with_restored(mappings: Mappings, key: str) -> Mappings:
    """The mappings as before a change; asked again, as after it.

    key: what that was given; ValueError where there is none.
    """
    return with_change(mappings, mappings.replaced[check_known(key, mappings.replaced, "change of a macro")], key)


def with_change(mappings: Mappings, change: Change, key: str) -> Mappings:
    """The mappings after names stand for something else; ValueError for too many.

    change: what they stand for; key: what `with_restored` finds what was before by.
    """
    kept = _after(mappings.kept, change)
    if len(kept) > MOST_MAPPINGS:
        raise ValueError(f"there are {MOST_MAPPINGS} macros, which is as many as a character keeps; delete one")
    before = {name: mappings.kept.get(name) for name in change}
    return Mappings(kept, with_newest(mappings.replaced, key, before, MOST_REPLACED))


def renaming_in(before: ByName, after: ByName) -> tuple[str, str] | None:
    """The old and the new name, where all that differs is that one mapping is called otherwise, in the conditions of
    others too; None elsewhere.

    before, after: mappings by name.
    """
    gone = [name for name in before if name not in after]
    new = [name for name in after if name not in before]
    if len(gone) != 1 or len(new) != 1 or before[gone[0]].with_name(new[0]) != after[new[0]]:
        return None
    old = gone[0]
    to = new[0]
    same = all(after[other] == _reading(each, old, to) for other, each in before.items() if other != old)
    return (old, to) if same else None


def _reading(mapping: MacroMapping, name: str, to: str) -> MacroMapping:
    """A mapping whose condition reads a macro by its new name. name: of that macro before; to: from now on."""
    when = mapping.when
    if when is None or when.reads != READS_MACRO + name:
        return mapping
    return replace(mapping, when=replace(when, reads=READS_MACRO + to))


def _after(kept: ByName, change: Change) -> dict[str, MacroMapping]:
    """Those that stay where they stood; one that is called otherwise too."""
    later = {**kept, **change}
    named = {name: mapping for name, mapping in later.items() if mapping is not None}
    renaming = renaming_in(kept, named)
    if renaming is None:
        return named
    old, new = renaming
    return {(new if name == old else name): named[new if name == old else name] for name in kept}


def check_mappings(mappings: Mappings) -> None:
    """Rejects mappings that no character has kept; whether a cast has their channels is asked where they play."""
    check_within(len(mappings.kept), 0, MOST_MAPPINGS, "the number of macros")
    check_within(len(mappings.replaced), 0, MOST_REPLACED, "the number of changes of macros that can be taken back")
    for change in (mappings.kept, *mappings.replaced.values()):
        for name, mapping in change.items():
            if mapping is not None and mapping.name != name:
                raise ValueError(f"the mapping {mapping.name} is kept as {name}; both must be one name")
