"""Mappings follow a pad that is given another name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from omote.perform.mappings.kept_mappings import Mappings
from omote.perform.mappings.mapping import PAD, MacroMapping, MacroTarget, axis_of_pad


def plays_pad(mapping: MacroMapping, pad: str) -> bool:
    """Whether a mapping moves the point of a pad (by its name)."""
    return any(_pad_of(target) == pad for target in mapping.targets)


def mapping_after_rename(mapping: MacroMapping, pad: str, to: str) -> MacroMapping:
    """A mapping that moves a pad under its new name; one that has a target of that name already keeps both.

    mapping: as it is; pad: the name before; to: the name now.
    """
    if not plays_pad(mapping, pad):
        return mapping
    reached = {target.to for target in mapping.targets}

    def later(target: MacroTarget) -> MacroTarget:
        name = f"{PAD}/{to}/{axis_of_pad(target.place[1])[1]}"
        return replace(target, to=name) if _pad_of(target) == pad and name not in reached else target

    return replace(mapping, targets=tuple(later(target) for target in mapping.targets))


def mappings_after_rename(mappings: Mappings, renamed: Mapping[str, str]) -> Mappings:
    """The mappings of a character after pads have other names, and what of them can be taken back.

    mappings: as they are; renamed: what pads were called, with what they are called now.
    """

    def later(mapping: MacroMapping | None) -> MacroMapping | None:
        for pad, to in renamed.items():
            mapping = None if mapping is None else mapping_after_rename(mapping, pad, to)
        return mapping

    kept = {name: after for name, mapping in mappings.kept.items() if (after := later(mapping)) is not None}
    replaced = {
        key: {name: later(mapping) for name, mapping in change.items()} for key, change in mappings.replaced.items()
    }
    return Mappings(kept, replaced)


def _pad_of(target: MacroTarget) -> str:
    kind, name = target.place
    return axis_of_pad(name)[0] if kind == PAD else ""
