"""What consoles are told of mappings: once with each change, with what there is not."""

from __future__ import annotations

from omote.model.cast import Cast
from omote.perform.mappings.mapping import MacroMapping, MacroTarget
from omote.perform.pads.blend_space import Pad, PadLook
from omote.perform.scene.scene import Scene
from omote.show.objects.hand.macros import MappingList
from omote.show.told_mappings import ToldMappings


def test_it_is_told_once_with_each_change_and_names_what_there_is_not(cast: Cast) -> None:
    scene = Scene.begun(cast)
    playing = [cast.with_expressions(beam=cast.expressions["smile"])]
    told = ToldMappings(lambda: scene, lambda: playing[0])
    assert told.news() is None
    scene.recast(playing[0])
    targets = (MacroTarget("channel/beam"), MacroTarget("pad/gone/x"), MacroTarget("pad/mix/z"))
    mapping = MacroMapping("m", targets)
    scene["one"].set_mapping(mapping)
    looks = (PadLook("Open", {"smile": 1.0}, (-1.0, 0.0)), PadLook("Shut", {"neutral": 1.0}, (1.0, 0.0)))
    scene.set_pad(Pad("mix", "expression", 2, looks))
    expected = ["pad/gone/x", "pad/mix/z"]
    assert told.news() == MappingList({"one": [mapping]}, {"one": expected})
    assert told.news() is None
    playing[0] = cast
    news = told.news()
    assert news is not None
    assert news.missing == {"one": ["channel/beam", *expected]}
    scene["one"].drop_mapping("m")
    assert told.news() == MappingList({})
