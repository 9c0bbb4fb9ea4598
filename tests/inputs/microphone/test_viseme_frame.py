"""A frame of visemes: shares of one mouth."""

import pytest

from omote.inputs.microphone.viseme_frame import VisemeFrame
from omote.perform.speech.visemes import VISEMES


def weights(**given: float) -> tuple[float, ...]:
    return tuple(given.get(viseme, 0.0) for viseme in VISEMES)


def test_the_strongest_and_whether_somebody_speaks() -> None:
    frame = VisemeFrame(0.01, weights(sil=0.25, aa=0.6, E=0.15), -20.0, 0.5)
    assert frame.strongest == "aa"
    assert frame.speaks == pytest.approx(0.375)


@pytest.mark.parametrize(
    ("shares", "level", "gate", "said"),
    [
        ((1.0,), 0.0, 0.0, "a frame has 1 visemes"),
        (weights(aa=0.5), 0.0, 0.0, "sum to 0.5"),
        (weights(aa=1.5, E=-0.5), 0.0, 0.0, "shares of 1"),
        (weights(aa=1.0), 0.0, 1.5, "the gate is 1.5"),
        (weights(aa=1.0), float("nan"), 1.0, "the level is nan"),
        (weights(aa=float("nan")), 0.0, 1.0, "sum to nan"),
    ],
)
def test_rejects_what_is_no_frame(shares: tuple[float, ...], level: float, gate: float, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        VisemeFrame(0.0, shares, level, gate)
