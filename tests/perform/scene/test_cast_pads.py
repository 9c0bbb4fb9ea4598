"""The pads that come with the cast."""

from __future__ import annotations

from omote.perform.scene.cast_pads import FACES, MOODS, MOUTH, cast_pads
from omote.server.workers.file_jobs import NamedCast

NAMES = {of: None for layout in (MOODS, MOUTH) for _, of in layout.values()}
WHOLE = NamedCast({of: None for _, of in FACES.values()}, NAMES)


def test_neutral_is_in_the_middle_of_each_and_every_look_alone_at_its_place() -> None:
    pads = cast_pads(WHOLE)
    assert {name: pad.part for name, pad in pads.items()} == {
        "moods": "expression",
        "mouth": "mouth",
        "faces": "face",
    }
    for pad in pads.values():
        assert pad.mix_at((0.0, 0.0)) in ({"neutral": 1.0}, {"generic": 1.0})
        for look in pad.looks:
            assert pad.mix_at(look.place) == look.mix


def test_a_look_that_a_cast_lacks_is_left_out_and_a_pad_of_one_look_too() -> None:
    pads = cast_pads(NamedCast({"generic": None}, {"neutral": None, "smile": None}))
    assert {name: [look.label for look in pad.looks] for name, pad in pads.items()} == {
        "moods": ["Neutral", "Smile"],
        "mouth": ["Neutral", "Smile"],
    }
