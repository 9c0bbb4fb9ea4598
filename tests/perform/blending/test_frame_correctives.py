"""Correctives of a frame: what they are allowed where regions show mixes of their own, and what moves along."""

from collections.abc import Mapping

import numpy as np
import pytest

import omote
from omote.model.known_names import PLAY_REGIONS, PlayRegion
from omote.perform.blending import frame_correctives
from omote.perform.blending.evaluate import evaluate, evaluate_parts
from omote.perform.blending.frame_correctives import angles_of_eyes, correct_frame, correct_parts
from omote.perform.blending.region_masks import play_masks
from omote.perform.frame import Frame

CAST = omote.load_cast()
MIXES: Mapping[PlayRegion, Mapping[str, float]] = {
    "brows": {"angry": 1.0},
    "eyes": {"asleep": 0.7, "joy": 0.3},
    "mouth": {"shout": 1.0},
}
SUM = Frame({"kaori": 1.0}, {"joy": 1.0}, {"eyeBlinkLeft": 1.0, "eyeSquintLeft": 1.0, "cheekSquintLeft": 1.0})


def test_each_region_allows_what_its_own_mix_uses_up(monkeypatch: pytest.MonkeyPatch) -> None:
    """What is handed to the correctives is the mean, by the masks, of what whole faces with those mixes hand them."""
    handed = list[np.ndarray]()

    def keep(*given: np.ndarray) -> np.ndarray:
        handed.append(given[3])
        return given[2]

    monkeypatch.setattr(frame_correctives, "correct_combination", keep)
    faces = {"kaori": 0.4, "dog": 0.6}
    whole = {"joy": 1.0}
    evaluate(CAST, Frame(faces, whole, regions=MIXES))
    for region in PLAY_REGIONS:
        evaluate(CAST, Frame(faces, MIXES.get(region, whole)))
    masks = [play_masks(CAST.space)[region].allowances for region in PLAY_REGIONS]
    assert handed[0] == pytest.approx(sum(mask * one for mask, one in zip(masks, handed[1:], strict=True)), abs=1e-6)


def test_eyes_look_where_the_mix_around_them_does() -> None:
    frame = Frame(
        {"kaori": 1.0}, {"joy": 1.0}, regions={"eyes": {"eyeLookUpLeft": 1.0}, "mouth": {"eyeLookInLeft": 1.0}}
    )
    wanted = CAST.expressions["eyeLookUpLeft"].eyes
    assert angles_of_eyes(CAST, frame, {}) == pytest.approx(wanted)


def test_what_stands_on_the_skin_moves_as_far_as_it_is_corrected() -> None:
    mixed = evaluate(CAST, Frame(SUM.faces, SUM.expressions))  # any skin will do that is not the sum itself
    for name, weight in SUM.channels.items():
        more = weight * (evaluate(CAST, Frame(SUM.faces, {name: 1.0})) - CAST.faces["kaori"].positions)
        mixed = mixed + more.astype(np.float32)
    corrected = correct_frame(CAST, SUM, SUM.channels, mixed)
    assert np.abs(corrected - mixed).max() > 1e-4
    parts = evaluate_parts(CAST, Frame(SUM.faces, SUM.expressions))
    moved = correct_parts(CAST, SUM, SUM.channels, mixed, parts)
    assert set(moved) == {"lashes"}
    assert np.abs(moved["lashes"] - parts["lashes"]).max() > 1e-4
    assert (
        correct_parts(
            CAST, Frame({"kaori": 1.0}, {"joy": 1.0}), {}, evaluate(CAST, Frame({"kaori": 1.0}, {"joy": 1.0})), parts
        )
        == {}
    )
