"""Compounds are computed once, are those of the model, and make room for each other."""

import numpy as np

from omote.model.cast import Cast
from omote.model.transfer.compound import compound, compound_parts
from omote.perform.blending.compound_cache import CompoundCache, compound_cache


def test_they_are_the_compounds_of_the_model(cast: Cast) -> None:
    compounds = CompoundCache(cast)
    worn = compound(cast.space, cast.faces["long"], cast.expressions["smile"])
    assert np.array_equal(compounds.skin("long", "smile"), worn)
    parts = compound_parts(cast.space, cast.faces["long"], cast.expressions["jawOpen"])
    assert all(np.array_equal(compounds.parts("long", "jawOpen")[name], points) for name, points in parts.items())


def test_asked_again_they_are_the_same_arrays(cast: Cast) -> None:
    compounds = CompoundCache(cast)
    assert compounds.skin("broad", "smile") is compounds.skin("broad", "smile")
    assert compounds.parts("broad", "smile") is compounds.parts("broad", "smile")


def test_the_least_recently_used_makes_room(cast: Cast) -> None:
    compounds = CompoundCache(cast, room=2 * cast.faces["generic"].positions.nbytes)
    first = compounds.skin("generic", "smile")
    second = compounds.skin("broad", "smile")
    assert compounds.skin("generic", "smile") is first
    compounds.skin("long", "smile")
    assert compounds.skin("generic", "smile") is first
    assert compounds.skin("broad", "smile") is not second


def test_each_cast_has_its_own(cast: Cast) -> None:
    other = cast.with_expressions(smile=cast.expressions["jawOpen"])
    assert compound_cache(cast) is compound_cache(cast)
    assert compound_cache(other) is not compound_cache(cast)
    assert np.array_equal(compound_cache(other).skin("long", "smile"), compound_cache(cast).skin("long", "jawOpen"))
