"""Characters that were removed from a scene, for as long as they can be brought back: whole, and where they were."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TypeVar

from omote.perform.newest_entries import with_newest
from omote.perform.scene.framings import names_in
from omote.perform.scene.scene_snapshot import MOST_REMOVALS, CharacterSnapshot, Removal

Value = TypeVar("Value")
Removals = Mapping[str, Removal]


def with_removal(removals: Removals, key: str, removal: Removal) -> dict[str, Removal]:
    """The removals with one more, the newest; the oldest is forgotten where there are too many.

    key: what names the removal; removal: the new one.

    One that is removed again while it is on its way comes back as before the first time.
    """
    under_way = next((former for former in removals.values() if _is_under_way(former, removal.character)), removal)
    return with_newest(removals, key, under_way, MOST_REMOVALS)


def with_kept(removals: Removals, character: str, snapshot: CharacterSnapshot) -> dict[str, Removal]:
    """The removals once a character is gone, as it was then. snapshot: of the character as it went."""
    return {
        k: replace(removal, kept=snapshot) if _is_under_way(removal, character) else removal
        for k, removal in removals.items()
    }


def without_stay(removals: Removals, character: str) -> dict[str, Removal]:
    """The removals without those of a character that was on its way and stays."""
    return {key: removal for key, removal in removals.items() if not _is_under_way(removal, character)}


def _is_under_way(removal: Removal, character: str) -> bool:
    return removal.character == character and removal.kept is None


def insert_at_rank(
    characters: Mapping[str, Value], name: str, value: Value, before: tuple[str, ...]
) -> dict[str, Value]:
    """The characters with one more, behind the last of those `before` it, in their order.

    name: of the new one; value: what stands for it.
    """
    names = list(characters)
    at = max((names.index(other) + 1 for other in before if other in characters), default=0)
    return {key: value if key == name else characters[key] for key in [*names[:at], name, *names[at:]]}


def framing_back(removal: Removal, framing: str, characters: Mapping[str, object]) -> str | None:
    """The shot that a removal has changed; None where another was called since, or somebody of it is gone.

    framing: the one on air; characters: those in the scene.
    """
    if removal.framing is None or removal.framing[1] != framing:
        return None
    former = removal.framing[0]
    return former if names_in(former) <= characters.keys() else None
