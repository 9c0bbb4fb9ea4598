"""The state of layers: which columns show a source, and where trust and shares go."""

import numpy as np

from omote.model.cast import Cast
from omote.perform.frame import Held
from omote.perform.layers.layer_names import DRIVEN, LAYERS
from omote.perform.layers.layer_vectors import columns_of_source, plays, trust_goal, trust_of
from omote.perform.layers.layers import begin, drive
from omote.perform.layers.source_frame import SourceFrame


def test_a_source_has_the_columns_of_its_parts_and_their_trust(cast: Cast) -> None:
    before = begin(cast, Held())
    assert not plays(before)
    layers = drive(cast, before, "tracker", SourceFrame(("jawOpen",), np.array([0.5]), source="phone"))
    assert plays(layers)
    own = columns_of_source(layers, "tracker", "phone")
    assert own[layers.columns.index["jawOpen"]]
    assert not columns_of_source(layers, "tracker", "other").any()
    goal = dict(zip(DRIVEN, np.frombuffer(trust_goal(layers)).reshape(len(DRIVEN), -1).tolist(), strict=True))
    assert max(goal["tracker"]) == 1.0
    assert max(goal["lips"]) == 0.0
    assert trust_of(layers, "tracker").max() == 0.0, "it is followed"


def test_shares_of_what_nothing_plays_are_as_they_are_set(cast: Cast) -> None:
    layers = begin(cast, Held())
    shares = dict(zip(LAYERS, layers.columns.rows(layers.second, "share").tolist(), strict=True))
    assert shares["lips"][2] == 0.7
    assert shares["emotion"] == [1.0] * len(shares["emotion"])
