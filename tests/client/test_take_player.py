"""A recording into a show: each frame at its time, the last one too, none twice where time has gone on."""

import asyncio
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from omote.cli import app
from omote.client.take_player import LONGEST_STEP, play_take
from omote.inputs.takes.take import Take
from tests.client.test_program_link import ticking
from tests.inputs.takes.test_live_link_take import HEADER, row
from tests.server.conftest import ShowHarness

TAKE = Take(("jawOpen",), (0.0, 0.1, 0.2, 0.3), ((0.0,), (0.25,), (0.5,), (0.75,)), gazes=((0.1, 0.2),) * 4)


class Character:
    """Notes what drives it; every frame takes some seconds."""

    def __init__(self, seconds: float) -> None:
        self.now = 5.0
        self._seconds = seconds
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


def test_a_part_is_played_at_another_speed() -> None:
    character = Character(0.0)
    play_take(TAKE, character.drive, clock=lambda: character.now, sleep=character.sleep, start=0.2, speed=0.5)
    assert character.frames[0] == (0.0, 0.5)
    assert character.frames[-1][1] == 0.75
    assert character.frames[-1][0] == pytest.approx(0.2, abs=LONGEST_STEP)


@pytest.mark.asyncio
@pytest.mark.parametrize(
    ("options", "said"),
    [(["--character", "Rex"], "there is no character 'Rex' in this scene, which has one"),
     (["--layer", "foo"], "there is no layer for a source 'foo'; expected one of breath")],
)  # fmt: skip
async def test_a_character_or_layer_that_there_is_not_is_one_sentence(
    show_harness: ShowHarness, tmp_path: Path, options: list[str], said: str
) -> None:
    path = tmp_path / "take.csv"
    path.write_text(HEADER + row("00:00:00:00", *[0.5] * 8))
    command = ["play-take", str(path), "--show", str(show_harness.client.make_url("/")), *options]
    async with ticking(show_harness):
        done = await asyncio.to_thread(CliRunner().invoke, app, command)
    assert isinstance(done.exception, SystemExit)
    assert done.exit_code == 1
    assert f"omote: {said}" in done.stderr
    assert done.stderr.count("\n") == 2, "what it waits for, and why it does not play"


@pytest.mark.asyncio
@pytest.mark.parametrize("character", ["one", "*"])
async def test_whom_it_plays_and_how_often_is_said(
    show_harness: ShowHarness, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, character: str
) -> None:
    monkeypatch.setattr("omote.client.take_player.play_take", lambda *_, **__: 1)
    path = tmp_path / "take.csv"
    path.write_text(HEADER + row("00:00:00:00", *[0.5] * 8))
    address = str(show_harness.client.make_url("/"))
    command = ["play-take", str(path), "--show", address, "--character", character]
    async with ticking(show_harness):
        done = await asyncio.to_thread(CliRunner().invoke, app, command)
    whom = show_harness.show.session.scene.labels.get(character, "all")
    assert done.stderr.splitlines() == [
        f"omote: take.csv waits for the show at {address} ...",
        f"omote: take.csv plays {whom} on the layer playback, once: 1 frames in 0.0 s.",
        "omote: take.csv is over.",
    ]


@pytest.mark.asyncio
async def test_how_a_loop_is_ended_is_said(
    show_harness: ShowHarness, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def stop(*_: object, **__: object) -> int:
        raise KeyboardInterrupt

    monkeypatch.setattr("omote.client.take_player.play_take", stop)
    path = tmp_path / "take.csv"
    path.write_text(HEADER + row("00:00:00:00", *[0.5] * 8))
    command = ["play-take", str(path), "--loop", "--show", str(show_harness.client.make_url("/"))]
    async with ticking(show_harness):
        done = await asyncio.to_thread(CliRunner().invoke, app, command)
    assert "again and again, until Ctrl-C" in done.stderr
    assert done.stderr.endswith("omote: stopped.\n")
