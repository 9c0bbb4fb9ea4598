"""Mappings follow a pad to another name, and what of them can be taken back."""

from __future__ import annotations

from omote.perform.mappings.kept_mappings import NO_MAPPINGS, with_mapping, with_restored, without_mapping
from omote.perform.mappings.mapping import MacroMapping, MacroTarget
from omote.perform.mappings.renamed_pads import mapping_after_rename, mappings_after_rename, plays_pad

WIDE = MacroMapping(
    "wide", (MacroTarget("pad/lips/x", high=0.5), MacroTarget("channel/lips"), MacroTarget("pad/lip/y"))
)


def test_targets_of_that_pad_alone_have_the_new_name_and_all_else_stays() -> None:
    after = mapping_after_rename(WIDE, "lips", "snout")
    assert [target.to for target in after.targets] == ["pad/snout/x", "channel/lips", "pad/lip/y"]
    assert after.targets[0].high == 0.5
    assert (plays_pad(WIDE, "lips"), plays_pad(after, "lips"), plays_pad(after, "snout")) == (True, False, True)
    assert mapping_after_rename(after, "snout", "lips") == WIDE
    assert mapping_after_rename(WIDE, "moods", "snout") is WIDE


def test_no_target_comes_twice() -> None:
    both = MacroMapping("both", (MacroTarget("pad/lips/x"), MacroTarget("pad/snout/x")))
    assert mapping_after_rename(both, "lips", "snout") == both


def test_what_can_be_taken_back_has_the_new_name() -> None:
    dropped = without_mapping(with_mapping(NO_MAPPINGS, WIDE, "set"), "wide", "drop")
    after = with_restored(mappings_after_rename(dropped, {"lips": "snout"}), "drop")
    assert after.kept == {"wide": mapping_after_rename(WIDE, "lips", "snout")}
