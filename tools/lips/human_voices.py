"""Recordings of people with the time of each phone, where they are installed; nothing of them is in the repository.

* A Russian, 100 minutes (Shmyrev 2005, of which festival's voice is made), labelled by its maker: `apt-get install
  festvox-ru`;
* an Englishwoman of LibriVox, five sentences, which pocketsphinx aligns with their text: `apt-get install
  pocketsphinx-testdata`, `pip install pocketsphinx`.
"""

from __future__ import annotations

from collections.abc import Iterator
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

import numpy as np
from scipy.io import wavfile

from omote.inputs.voices.phones import Segment
from tools.lips.named_voices import read_lines
from tools.lips.phones import shapes_of_name
from tools.lips.spoken import Spoken, resample

RUSSIAN = Path("/usr/share/festival/voices/russian/msu_ru_nsh_clunits")
LIBRIVOX = Path("/usr/share/pocketsphinx/test/data/librivox")
ALIGNER = "pocketsphinx"
_FRAME = 0.01
"""Seconds of a frame of pocketsphinx."""


def russian_names() -> list[str]:
    """The names of the Russian's sentences, none where they are not installed."""
    return sorted(path.stem for path in (RUSSIAN / "wav").glob("*.wav"))


def read_russian(name: str) -> Spoken:
    """A sentence of the Russian."""
    sound = _read_sound(RUSSIAN / "wav" / f"{name}.wav")
    segments = []
    start = 0.0
    for phone, end in read_lines(RUSSIAN / "lab" / f"{name}.lab"):
        segments.append(Segment(start, end, phone, shapes_of_name("russian", phone)))
        start = end
    return Spoken(sound, tuple(segments))


def read_librivox() -> Iterator[Spoken]:
    """The sentences of the Englishwoman, aligned; none where they or pocketsphinx are not installed."""
    if not LIBRIVOX.is_dir() or find_spec(ALIGNER) is None:
        return
    for line in (LIBRIVOX / "transcription").read_text().splitlines():
        text, _, name = line.rpartition("(")
        path = LIBRIVOX / f"{name.strip(') ')}.wav"
        yield Spoken(_read_sound(path), tuple(_align(path, text.replace("<s>", "").replace("</s>", "").strip())))


def _align(path: Path, text: str) -> list[Segment]:
    """The phones of a text in a recording."""
    rate, samples = wavfile.read(path)
    decoder = import_module(ALIGNER).Decoder(lm=None, samprate=rate, loglevel="FATAL")
    decoder.set_align_text(text)
    for step in ("words", "phones"):
        if step == "phones":
            decoder.set_alignment()
        decoder.start_utt()
        decoder.process_raw(samples.astype("<i2").tobytes(), full_utt=True)
        decoder.end_utt()
    phones = [phone for word in decoder.get_alignment() for phone in word]
    return [
        Segment(each.start * _FRAME, (each.start + each.duration) * _FRAME, each.name.lower(),
                shapes_of_name("radio", each.name.lower()))
        for each in phones
    ]  # fmt: skip


def _read_sound(path: Path) -> np.ndarray:
    rate, samples = wavfile.read(path)
    return resample(samples.astype(np.float32) / 32768.0, rate)
