"""Curves of what showed: what they are of, and that they come back as they were kept."""

from __future__ import annotations

import dataclasses
import math
from typing import ClassVar

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from omote.model.known_names import PLAY_REGIONS
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import CallExpression, CallFace
from omote.show.objects.cues import Go, GoBack, PutCue
from omote.show.objects.faders import SetChannel, SetHead
from omote.show.objects.link import Hello
from omote.show.objects.motion import SetMotion
from omote.show.objects.state import Place
from omote.show.recording.curves import (
    QUANTITIES,
    WORDS,
    Curves,
    CurveSampler,
    Shown,
    ShownCharacter,
    join_curves,
    pack_curves,
    sample_curves,
    unpack_curves,
)
from omote.show.session import ShowSession
from omote.show.wire import encode
from tests import synthetic

CAST = synthetic.cast()
COLUMNS = list(QUANTITIES)


class Titled:
    """A cast that knows the regions of two channels."""

    titles: ClassVar = {
        "jawOpen": dataclasses.replace(CAST.titles["jawOpen"], region="jaw"),
        "eyeBlinkLeft": dataclasses.replace(CAST.titles["jawOpen"], region="eyes"),
    }


TITLED = Titled()


def started() -> ShowSession:
    """A show with an operator, and a character that holds still."""
    session = ShowSession(CAST)
    session.receive("ana", Hello("console", PROTOCOL_VERSION, "ana"), 0.0)
    session.receive("ana", SetMotion("one", liveliness=0.0), 0.0)
    return session


def sampled(session: ShowSession, seconds: float) -> CurveSampler:
    """Curves of a show that plays on, sixty times a second, of which six are one sample."""
    sampler = CurveSampler()
    sampler.cast = TITLED
    for number in range(round(60 * seconds)):
        now = number / 60
        state = encode(session.tick(now))
        if number % 6 == 5:
            sampler.note(now, state, ())
    return sampler


def column(curves: Curves, quantity: str) -> list[float]:
    return [float(value) for value in curves.values["one"][:, COLUMNS.index(quantity)]]


def test_curves_are_of_what_showed() -> None:
    session = started()
    session.receive("ana", CallFace("one", "1", "broad", 0.0), 0.0)
    session.receive("ana", SetHead("one", 0.3, -0.2, 0.1), 0.0)
    session.receive("ana", SetChannel("one", "jawOpen", 0.5), 0.0)
    curves = unpack_curves(sampled(session, 1.0).take()[0])
    assert np.diff(curves.times) == pytest.approx(0.1, abs=0.0011)
    assert curves.words("one", "face_name")[-1] == "broad"
    assert column(curves, "face")[-1] == 1.0
    assert column(curves, "mouth")[-1] == 0.5
    angles = [column(curves, name)[-1] for name in ("head_yaw", "head_pitch", "head_roll")]
    assert angles == pytest.approx([math.degrees(0.3), math.degrees(-0.2), math.degrees(0.1)], abs=0.051)


def test_an_expression_moves_each_region() -> None:
    session = started()
    name = next(name for name in CAST.expressions if name != "neutral")
    session.receive("ana", CallExpression("one", "1", name, 0.0), 0.0)
    curves = unpack_curves(sampled(session, 0.5).take()[0])
    assert curves.words("one", "expression_name")[-1] == name
    assert [column(curves, region)[-1] for region in ("expression", *PLAY_REGIONS)] == [1.0] * 5


def test_nothing_noted_is_nothing_to_keep() -> None:
    assert CurveSampler().take() == (b"", [])


def test_cues_are_found_at_the_time_of_their_go_and_back_calls_none() -> None:
    session = started()
    for cue in ("1", "2"):
        session.receive("ana", PutCue(f"put-{cue}", number=cue), 0.0)
    sampler = CurveSampler()
    pressed = {30: Go("g1"), 100: Go("g2"), 170: GoBack("b"), 240: Go("g3")}
    backs: list[float] = []
    for number in range(300):
        now = number / 60
        if number in pressed:
            session.receive("ana", pressed[number], now)
            backs += [now] if isinstance(pressed[number], GoBack) else []
        state = encode(session.tick(now))
        if number % 6 == 5:
            sampler.note(now, state, backs)
            backs = []
    calls = sampler.take()[1]
    assert [call.number for call in calls] == ["1", "2", "2"]
    assert [call.at for call in calls] == pytest.approx([30 / 60, 100 / 60, 240 / 60], abs=1e-6)


TABLES = arrays.arrays(
    np.float64, (7, len(COLUMNS)), elements=st.one_of(st.floats(-32.0, 32.0), st.sampled_from([0.0, 1.0]))
)


@given(tables=st.lists(TABLES, min_size=1, max_size=3), missing=st.sets(st.integers(0, 6)), names=st.permutations("ab"))
def test_curves_come_back_within_half_a_step_and_join_as_they_were(
    tables: list[np.ndarray], missing: set[int], names: list[str]
) -> None:
    parts = []
    for number, table in enumerate(tables):
        words = np.full((7, len(WORDS)), number % 2, dtype=np.float64)
        whole = np.hstack([table, words])
        whole[sorted(missing)] = np.nan
        parts.append(Curves(np.arange(7) / 10 + number, {f"one{number}": whole, "all": whole}, tuple(names)))
    joined = join_curves([unpack_curves(pack_curves(part)) for part in parts])
    again = unpack_curves(pack_curves(joined))
    steps = np.array([*QUANTITIES.values()])
    for number, part in enumerate(parts):
        rows = slice(7 * number, 7 * number + 7)
        expected = part.values["all"][:, : len(COLUMNS)]
        found = again.values["all"][rows, : len(COLUMNS)]
        assert np.array_equal(np.isnan(found), np.isnan(expected))
        assert np.nanmax(np.abs(found - expected) * steps, initial=0.0) <= 0.5 + 1e-6
        assert again.words("all", "face_name")[rows] == part.words("all", "face_name")
        others = np.delete(again.values[f"one{number}"], np.arange(7) + 7 * number, axis=0)
        assert np.isnan(others).all()


@pytest.mark.parametrize("data", [b"", b"no curves", pack_curves(Curves(np.zeros(3), {}))[:-5]])
def test_damaged_curves_are_refused(data: bytes) -> None:
    with pytest.raises(ValueError, match="damaged"):
        unpack_curves(data)


def test_blinks_are_left_out() -> None:
    blink = {"eyeBlinkLeft": 1.0, "jawOpen": 0.25}
    neutral = {"neutral": 1.0}
    character = ShownCharacter({"broad": 1.0}, neutral, blink, (0.0, 0.0, 0.0), (0.0, 0.0), Place(), 1.0)
    curves = sample_curves([0.0], [Shown({"one": character})], TITLED)
    assert [column(curves, region) for region in PLAY_REGIONS] == [[0.0], [0.0], [0.25], [0.0]]
