"""Voices of Piper: models that their user has put into a folder of this machine, each a file beside its settings.

Piper is another program's (GPL-3), installed by whoever wants it; only a child process that ends with its task loads
it, and the model too.
"""

from __future__ import annotations

import importlib.util
import re
import shutil
import textwrap
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import msgspec
import numpy as np

from omote.inputs.voices.piper_phones import Sign, join_signs, lay_stops_on_silence, share_seconds
from omote.inputs.voices.spoken_text import FULL_SCALE, SpokenText, Voice, WantedSpeech, put_together
from omote.perform.limits import check_known
from omote.server.sandbox.child_task import Limits, run_limited
from omote.show.objects.speech import MOST_MARKS
from omote.showfile.show_file import default_path

if TYPE_CHECKING:
    from piper import PiperVoice

LIMITS = Limits(seconds=60, patience=120.0, memory=3 * 2**30)
MODEL = ".onnx"
SETTINGS = ".onnx.json"
"""How the name of a model's file ends, and that of its settings beside it."""
HOW_TO_GET_PIPER = "install Piper where the show runs: pip install 'omote[piper]'"
_TOO_MUCH = "speaking this text by a model needs more time or memory than any speech; say less at once"
LONGEST_PIECE = 300
"""Letters of a sentence that a model speaks at once: what that costs grows with their square."""
_SENTENCE_END = re.compile(r"(?<=[.!?…。])\s+")
_PAD = "_"
"""The sign that a model has between all others; its time is that of the one before."""
_INPUTS = {"input", "input_lengths", "scales"}


class _Sound(msgspec.Struct, frozen=True):
    sample_rate: int
    quality: str = ""


class _Language(msgspec.Struct, frozen=True):
    name_english: str = ""
    country_english: str = ""


class ModelSettings(msgspec.Struct, frozen=True):
    """The settings beside a model, as far as a list of voices and the lips need them."""

    audio: _Sound
    phoneme_id_map: dict[str, list[int]]
    num_speakers: int = 1
    language: _Language = _Language()
    dataset: str = ""
    speaker_id_map: dict[str, int] = {}


def models_folder() -> Path:
    """The folder of this machine in which models lie."""
    return default_path().with_name("voices")


def list_models() -> list[Voice]:
    """The voices of all models by name; what one lacks that cannot speak is in its label."""
    return [Voice(name, _label(path)) for name, path in find_models().items()]


def find_models() -> dict[str, Path]:
    """All models by the names of their files."""
    found = sorted(models_folder().glob(f"*{MODEL}")) if models_folder().is_dir() else []
    return {path.name.removesuffix(MODEL): path for path in found}


def speak_by_model(path: Path, wanted: WantedSpeech, speaker: str = "") -> SpokenText:
    """A text as a model says it, by a child process; ValueError with a sentence where it cannot.

    path: its file; wanted: the text; speaker: which of a model of several, "" for its first.
    """
    settings = read_settings(path)
    number = None
    if speaker:
        number = settings.speaker_id_map[check_known(speaker, list(settings.speaker_id_map), "variant of a voice")]
    return run_limited(lambda _: _speak(path, settings, wanted, number), SpokenText, LIMITS, exhausted=_TOO_MUCH)


def keep_model(path: Path) -> str:
    """Puts a model with its settings among the voices of this machine, once it has spoken a word, and returns its name;
    ValueError with a sentence where it cannot speak. OSError where it cannot be copied."""
    if path.name.endswith(SETTINGS):
        path = path.with_name(path.name.removesuffix(".json"))
    if path.suffix != MODEL:
        raise ValueError(f"{path} is no model of Piper; name a file that ends with {MODEL}")
    speak_by_model(path, WantedSpeech("a 1"))
    folder = models_folder()
    folder.mkdir(parents=True, exist_ok=True)
    for source in (_settings_of(path), path):
        target = folder / source.name
        shutil.copyfile(source, target.with_suffix(".part"))
        target.with_suffix(".part").replace(target)
    return path.name.removesuffix(MODEL)


def read_settings(path: Path) -> ModelSettings:
    """The settings beside a model; ValueError with a sentence where there are none, or none that can be used."""
    beside = _settings_of(path)
    if not path.is_file():
        raise ValueError(f"there is no model {path}")
    if not beside.is_file():
        raise ValueError(f"the model {path.name} has no settings; put {beside.name}, which comes with it, beside it")
    try:
        return msgspec.json.decode(beside.read_bytes(), type=ModelSettings)
    except (msgspec.DecodeError, OSError) as error:
        raise ValueError(f"{beside.name} cannot be read as the settings of a model: {error}") from error


def _settings_of(path: Path) -> Path:
    return path.with_name(path.name.removesuffix(MODEL) + SETTINGS)


def _label(path: Path) -> str:
    """What a model speaks, for people, or why it cannot."""
    try:
        settings = read_settings(path)
    except ValueError as error:
        return f"{path.name}: {error}"
    if not is_installed():
        return f"{path.name}: {HOW_TO_GET_PIPER}"
    places = [settings.language.name_english, settings.language.country_english]
    whose = " ".join(filter(None, (settings.dataset, settings.audio.quality)))
    return ", ".join(filter(None, (*places, whose))) or path.name


def is_installed() -> bool:
    """Whether what runs models is there."""
    return all(importlib.util.find_spec(name) is not None for name in ("piper", "onnx"))


def _speak(path: Path, settings: ModelSettings, wanted: WantedSpeech, speaker: int | None) -> SpokenText:
    try:
        from piper import SynthesisConfig  # an extra
    except ImportError as error:
        raise ValueError(f"{path.name} is a model of Piper; {HOW_TO_GET_PIPER}") from error
    voice = _load(path)
    slow = voice.config.length_scale / wanted.speed
    names = {number: name for name, numbers in settings.phoneme_id_map.items() for number in numbers}
    manner = SynthesisConfig(speaker_id=speaker, length_scale=slow)
    parts = list[np.ndarray]()
    signs = list[Sign]()
    for sentence in _SENTENCE_END.split(wanted.text):
        for piece in textwrap.wrap(sentence, LONGEST_PIECE):
            for chunk in voice.synthesize(piece, manner, include_alignments=True):
                parts.append(chunk.audio_float_array)
                signs += _signs(chunk, names)
    sound = np.concatenate([*parts, np.zeros(0, np.float32)])
    segments = lay_stops_on_silence(join_signs(signs), sound, settings.audio.sample_rate)
    samples = np.round(sound * (FULL_SCALE - 1.0)).astype(np.int16)
    return put_together(samples, settings.audio.sample_rate, segments, most=MOST_MARKS)


def _signs(chunk: Any, names: dict[int, str]) -> Iterator[Sign]:
    """The signs of a sentence with their times, by rule where the model tells none."""
    numbers = chunk.phoneme_ids
    told = chunk.phoneme_id_samples
    if told is None or np.size(told) != len(numbers):
        spoken = [name for number in numbers if (name := names.get(number, _PAD)) != _PAD]
        return iter(share_seconds(spoken, chunk.audio_float_array, chunk.sample_rate))
    seconds = np.asarray(told, float) / chunk.sample_rate
    starts = [place for place, number in enumerate(numbers) if place == 0 or names.get(number, _PAD) != _PAD]
    sums = np.add.reduceat(seconds, starts)
    return (Sign(names.get(numbers[place], _PAD), float(sum_)) for place, sum_ in zip(starts, sums, strict=True))


def _load(path: Path) -> PiperVoice:
    """A model, ready to speak. It is asked for the length of each sign too, which those that are published compute and
    do not give; on one thread and as it is written, which is ready soonest."""
    import onnx
    import onnxruntime
    from piper import PiperVoice
    from piper.config import PiperConfig
    from piper.patch_voice_with_alignment import add_alignment_output

    try:
        config = PiperConfig.from_dict(msgspec.json.decode(_settings_of(path).read_bytes()))
        model = onnx.load(path)
        if not {given.name for given in model.graph.input} >= _INPUTS:
            raise ValueError("it takes other inputs than a text")
        _ask_for_lengths(add_alignment_output, model)
        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = 1
        options.graph_optimization_level = onnxruntime.GraphOptimizationLevel.ORT_DISABLE_ALL
        session = onnxruntime.InferenceSession(model.SerializeToString(), options, providers=["CPUExecutionProvider"])
    except Exception as error:  # of three libraries, each with its own
        raise ValueError(
            f"{path.name} cannot be read as a model of Piper: {str(error)[:200] or type(error)}"
        ) from error
    return PiperVoice(session=session, config=config)


def _ask_for_lengths(add_output: Any, model: Any) -> None:
    """Has a model give how long each sign is; what has them nowhere, or gives them already, stays as it is."""
    try:
        add_output(model)
    except ValueError:
        return
