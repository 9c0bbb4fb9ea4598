"""What becomes of macros when mappings change."""

from __future__ import annotations

from omote.perform.mappings.kept_mappings import ByName
from omote.perform.mappings.macro_vectors import move_macro, states_of
from omote.perform.mappings.macros import check_macros, follow_change
from omote.perform.mappings.mapping import MacroMapping, MacroTarget


def test_a_rename_and_another_change_at_once_keep_what_each_macro_gives() -> None:
    # the mappings of air reach the preview after several changes
    jaw, lip = (MacroTarget(f"channel/{name}") for name in ("jawOpen", "mouthPucker"))
    before: ByName = {"m1": MacroMapping("m1", (jaw,)), "m2": MacroMapping("m2", (jaw,))}
    after: ByName = {"m1": MacroMapping("m1", (jaw, lip)), "m3": MacroMapping("m3", (jaw,))}
    macros = states_of(move_macro(None, before, "m1", 0.5, lambda _: 0.0))
    check_macros(follow_change(macros, before, after), after)
