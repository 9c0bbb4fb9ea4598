"""Clips as pictures and films: exact times, and alpha that comes back."""

from __future__ import annotations

import hashlib
import io
import shutil
import subprocess
import wave
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest

from omote.builtin import load_cast
from omote.interchange.formats.png import png_bytes
from omote.model.cast import Cast
from omote.perform.clips.clip import Clip, Lane
from omote.perform.clips.motion_curve import make_curve
from omote.server.headless import clip_pictures
from omote.server.headless.clip_pictures import (
    ClipPictures,
    FilmSound,
    begin_pictures,
    draw_clip,
    film_clip,
    find_film_sound,
    play_frames,
    write_sidecar,
)
from omote.show.objects.speech import StoredSound
from omote.showfile.changes import Stored
from omote.showfile.inspection import Inspection

RAMP = Clip([Lane(make_curve([0.0, 0.5, 1.0], {"jawOpen": [0.0, 0.5, 1.0]}, {}))], loop=True)
SIZE = 64


def test_each_frame_is_that_of_its_time(cast: Cast) -> None:
    frames = [*play_frames(cast, RAMP, face="generic", rate=10.0)]
    assert [time for time, _ in frames] == [place / 10 for place in range(10)]
    shown = [frame.channels.get("jawOpen", 0.0) for _, frame in frames]
    assert shown == pytest.approx([place / 10 for place in range(10)], abs=1e-12)


def test_a_face_that_is_not_there_is_refused(cast: Cast) -> None:
    with pytest.raises(ValueError, match="there is no face 'nobody'"):
        next(play_frames(cast, RAMP, face="nobody", rate=10.0))


def test_a_film_without_ffmpeg_says_what_to_do(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", "")
    with pytest.raises(FileNotFoundError, match="install it, or take the pictures"):
        film_clip(tmp_path / "a.mov", lambda _: pytest.fail("nothing is drawn"))


ALPHA = 255.0 - np.clip(np.hypot(*np.indices((SIZE, SIZE)) - SIZE / 2) - SIZE / 3, 0.0, 1.0) * 255.0
"""Of a disc, whose edge is a pixel wide as a head's is."""


def request(**others: Any) -> ClipPictures:
    """What lies beside pictures of a clip."""
    given = {
        "omote": "0", "clip": "line1", "motion": "m", "face": "kaori", "cast": "c", "rate": 25.0,
        "seconds": 0.08, "size": (SIZE, SIZE), "quality": "low", "frames": {"00000.png": 0.0},
    }  # fmt: skip
    return ClipPictures(**{**given, **others})


def edge(folder: Path) -> ClipPictures:
    """Two pictures of a disc."""
    picture = np.dstack([np.full((SIZE, SIZE, 3), 128.0), ALPHA]).round().astype(np.uint8)
    for number in range(2):
        (folder / f"{number:05}.png").write_bytes(png_bytes(picture))
    drawn = request(frames={"00000.png": 0.0, "00001.png": 0.04})
    (folder / clip_pictures.SIDECAR).write_bytes(msgspec.json.encode(drawn))
    return drawn


@pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="ffmpeg is not installed")
@pytest.mark.parametrize(("ending", "decoder"), [(".mov", []), (".webm", ["-c:v", "libvpx-vp9"])])
def test_the_alpha_of_a_film_is_within_two_of_255(tmp_path: Path, ending: str, decoder: list[str]) -> None:
    film = tmp_path / f"line1{ending}"
    film_clip(film, edge)
    read = ["ffmpeg", "-v", "error", *decoder, "-i", str(film), "-f", "rawvideo", "-pix_fmt", "rgba", "-"]
    data = subprocess.run(read, capture_output=True, check=True).stdout
    pictures = np.frombuffer(data, np.uint8).reshape(-1, SIZE, SIZE, 4)
    assert len(pictures) == 2
    assert np.abs(pictures[:, :, :, 3] - ALPHA).max() <= 2
    sidecar = msgspec.json.decode((tmp_path / f"{film.name}.frames.json").read_bytes(), type=ClipPictures)
    assert sidecar.frames == {"00000.png": 0.0, "00001.png": 0.04}
    assert {path.name for path in tmp_path.iterdir()} == {film.name, f"{film.name}.frames.json"}


def tone(silent: float, seconds: float) -> bytes:
    """A WAV, 48 kHz, of silence and then a tone of 1 kHz."""
    samples = np.zeros(round(48000 * (silent + seconds)), "<i2")
    loud = samples[round(48000 * silent) :]
    loud[:] = 16000 * np.cos(2.0 * np.pi * 1000.0 * np.arange(len(loud)) / 48000)
    whole = io.BytesIO()
    with wave.open(whole, "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(48000)
        file.writeframes(samples.tobytes())
    return whole.getvalue()


@pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="ffmpeg is not installed")
@pytest.mark.parametrize("ending", [".mov", ".webm"])
@pytest.mark.parametrize(("silent", "at", "begins"), [(0.0, 0.02, 0.02), (0.5, -0.45, 0.05), (0.5, -0.5, 0.0)])
def test_a_film_has_the_sound_of_its_clip_in_its_place_and_as_long_as_the_pictures(
    tmp_path: Path, ending: str, silent: float, at: float, begins: float
) -> None:
    film = tmp_path / f"line1{ending}"
    film_clip(film, edge, FilmSound(tone(silent, 1.0), at))
    read = ["ffmpeg", "-v", "error", "-i", str(film), "-vn", "-ac", "1", "-ar", "48000", "-f", "f32le", "-"]
    heard = np.frombuffer(subprocess.run(read, capture_output=True, check=True).stdout, "<f4")
    assert len(heard) / 48000 == pytest.approx(0.08, abs=0.021)  # Opus has frames of 20 ms
    assert np.argmax(np.abs(heard) > 0.2) / 48000 == pytest.approx(begins, abs=0.004)


def test_a_film_has_the_sound_that_the_show_file_keeps_at_the_speed_of_one() -> None:
    told: list[str] = []
    line = StoredSound("5" * 32, 2.0, "c1", 3, former=("first",))
    stored = Stored(documents={"sound": {"line 1": line.encode()}})
    inspection = Inspection(8, 0, stored, {"c1": b"wav"})
    clip = Clip([Lane(make_curve([0.0, 1.0], {"jawOpen": [0.0, 1.0]}, {}))], start=0.25, sound_at=0.5)
    for called in ("line 1", "first", line.sound):
        assert find_film_sound(inspection, replace(clip, sound=called), told.append) == FilmSound(b"wav", 0.25)
    assert find_film_sound(inspection, clip, told.append) is None
    assert find_film_sound(inspection, replace(clip, sound="line 1", sound_at=-2.0), told.append) is None, "it is over"
    assert told == []
    assert find_film_sound(inspection, replace(clip, sound="line 1", speed=0.5), told.append) is None
    assert find_film_sound(inspection, replace(clip, sound="gone"), told.append) is None
    assert [sentence.partition(",")[0] for sentence in told] == [
        "the clip plays at the speed 0.5",
        "the show file has no sound gone",
    ]


def test_a_folder_goes_on_for_the_same_request_alone(tmp_path: Path) -> None:
    folder = tmp_path / "out"
    assert begin_pictures(folder, request()) == {}
    (folder / "00000.png").write_bytes(b"drawn")
    hashes = begin_pictures(folder, request())
    assert hashes == {"00000.png": hashlib.sha256(b"drawn").hexdigest()}
    write_sidecar(folder / clip_pictures.SIDECAR, request(pictures=hashes))
    assert begin_pictures(folder, request()) == hashes
    (folder / "00000.png").write_bytes(b"changed")
    assert begin_pictures(folder, request()) == {}
    for field, other in (("motion", "n"), ("size", (8, 8)), ("quality", "high"), ("face", "old"), ("omote", "1")):
        with pytest.raises(FileExistsError, match=rf"pictures of another request \({field}: "):
            begin_pictures(folder, request(**{field: other}))
    (folder / clip_pictures.SIDECAR).write_text("{}")
    with pytest.raises(FileExistsError, match="is not empty"):
        begin_pictures(folder, request())


def test_a_folder_is_made_in_one_that_is_there_alone(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match=r"there is no folder .*/no; make it, or write somewhere else"):
        begin_pictures(tmp_path / "no" / "m04", request())
    assert not (tmp_path / "no").exists()


def test_a_clip_is_drawn_as_pictures_and_goes_on_where_it_was_stopped(tmp_path: Path) -> None:
    clip = Clip([Lane(make_curve([0.0, 0.5], {"jawOpen": [0.0, 0.5]}, {}))])
    told: list[tuple[int, int]] = []
    folder = tmp_path / "out"

    def stop(done: int, count: int) -> None:
        if done == 1:
            raise KeyboardInterrupt

    def draw(tell: Callable[[int, int], None]) -> ClipPictures:
        return draw_clip(
            load_cast(), clip, folder, name="line1", motion="m", face="kaori", rate=4.0, size=(SIZE, SIZE),
            quality="lowest", tell=tell,
        )  # fmt: skip

    with pytest.raises(KeyboardInterrupt):
        draw(stop)
    first = (folder / "00000.png").stat().st_mtime_ns
    drawn = draw(lambda *count: told.append(count))
    assert told == [(1, 2), (2, 2)]
    assert (folder / "00000.png").stat().st_mtime_ns == first
    assert drawn.frames == {"00000.png": 0.0, "00001.png": 0.25}
    assert (drawn.size, drawn.quality, drawn.motion) == ((SIZE, SIZE), "lowest", "m")
    assert msgspec.json.decode((folder / "frames.json").read_bytes(), type=ClipPictures) == drawn
    pictures = [(folder / name).read_bytes() for name in drawn.frames]
    assert pictures[0] != pictures[1]
    assert [*drawn.pictures.values()] == [hashlib.sha256(picture).hexdigest() for picture in pictures]
    told.clear()
    assert draw(lambda *count: told.append(count)) == drawn
    assert told == [(2, 2)]
