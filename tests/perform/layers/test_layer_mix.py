"""How layers add: a mean by region where they replace; the gaze is mixed as what turns the eyes."""

import pytest

from omote.model.cast import Cast
from omote.perform.channels import channels_of, gaze_channels
from omote.perform.frame import Frame, Gaze
from omote.perform.performer import Performer


def settled(performer: Performer, seconds: float = 6.0, **drive: object) -> Frame:
    frame = performer.advance(0.0)
    for _ in range(round(seconds * 60)):
        if drive:
            performer.drive(**drive)  # type: ignore[arg-type]
        frame = performer.advance(1 / 60)
    return frame


def test_an_influence_is_of_a_region(cast: Cast) -> None:
    performer = Performer(cast)
    performer.call_expression("smile", seconds=0.0)
    performer.set_layer("tracker", region="brows", influence=0.25)
    frame = settled(performer, channels={"jawOpen": 0.5}, layer="tracker")
    assert dict(frame.regions["brows"]) == {"smile": pytest.approx(0.75), "neutral": pytest.approx(0.25)}
    assert frame.expressions["neutral"] == pytest.approx(1.0, abs=1e-3)


def test_a_part_of_the_emotion_can_be_held_back(cast: Cast) -> None:
    performer = Performer(cast)
    performer.call_expression("smile", seconds=0.0)
    performer.set_layer("emotion", region="mouth", influence=0.5)
    frame = settled(performer)
    assert dict(frame.expressions) == {"smile": 1.0}
    assert dict(frame.regions["mouth"]) == {"smile": pytest.approx(0.5), "neutral": pytest.approx(0.5)}


def test_the_gaze_of_a_source_turns_the_eyes_and_no_larger_magnitude_wins(cast: Cast) -> None:
    performer = Performer(cast)
    gaze = Gaze(0.3, 0.2)
    sent = dict.fromkeys(gaze_channels(cast.expressions, gaze), 0.9) | {"jawOpen": 0.5}
    frame = settled(performer, channels=sent, gaze=(0.3, 0.2), layer="tracker")
    wanted = gaze_channels(cast.expressions, gaze)
    shown = channels_of(cast.expressions, frame)
    assert {name: shown[name] for name in wanted} == {
        name: pytest.approx(value, abs=1e-3) for name, value in wanted.items()
    }
    performer.set_layer("tracker", region="gaze", influence=0.5)
    half = channels_of(cast.expressions, settled(performer, channels=sent, gaze=(0.3, 0.2), layer="tracker"))
    assert all(half[name] == pytest.approx(value / 2, abs=1e-3) for name, value in wanted.items())


def test_a_layer_tells_its_source_and_its_strongest_channels(cast: Cast) -> None:
    performer = Performer(cast)
    sent = {"jawOpen": 0.7, "smile": -0.3, "browInnerUp": 0.001}
    status = settled(performer, channels=sent, layer="tracker").layers["tracker"]
    assert list(status.strongest) == ["jawOpen", "smile"]
    assert status.on
    assert [status.trust, status.share] == pytest.approx([1.0, 1.0])
