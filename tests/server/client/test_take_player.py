"""A recording into a show: each frame at its time, the last one too, none twice where time has gone on."""

from typing import Any

import pytest

from omote.inputs.takes.take import Take
from omote.server.client.take_player import LONGEST_STEP, play_take

TAKE = Take(("jawOpen",), (0.0, 0.1, 0.2, 0.3), ((0.0,), (0.25,), (0.5,), (0.75,)), gazes=((0.1, 0.2),) * 4)


class Character:
    """Notes what drives it; every frame takes some seconds."""

    def __init__(self, seconds: float) -> None:
        self.now, self._seconds = 5.0, seconds
        self.frames: list[tuple[float, float]] = []
        self.options: dict[str, Any] = {}

    def drive(self, channels: dict[str, float], **options: Any) -> None:
        self.frames.append((self.now - 5.0, channels["jawOpen"]))
        self.options = options
        self.now += self._seconds

    def sleep(self, seconds: float) -> None:
        self.now += seconds


@pytest.mark.parametrize("seconds", [0.0, 0.13, 10.0])
def test_frames_are_played_at_their_times(seconds: float) -> None:
    character = Character(seconds)
    sent = play_take(TAKE, character.drive, clock=lambda: character.now, sleep=character.sleep, layer="tracker")
    assert sent == len(character.frames)
    assert all(weight == TAKE.values[TAKE.frame_at(time)][0] for time, weight in character.frames)
    assert character.frames[-1][1] == 0.75
    assert character.options == {"layer": "tracker", "head": None, "gaze": (0.1, 0.2)}
    steps = [later - before for (before, _), (later, _) in zip(character.frames, character.frames[1:], strict=False)]
    assert all(step <= seconds + LONGEST_STEP + 1e-6 for step in steps)
