"""Speech by festival and by flite with the time of each phone: voices made of recordings of people."""

from __future__ import annotations

import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.io import wavfile

from omote.inputs.voices.phones import Segment
from tools.lips.phones import shapes_of_name
from tools.lips.spoken import Spoken, resample

SECONDS = 300
"""The longest that a synthesizer may take."""


@dataclass(frozen=True)
class NamedVoice:
    """A voice of festival or flite. phone_set: which names its phones have; words: its language's dictionary."""

    name: str
    phone_set: str
    words: str


FESTIVAL_VOICES = (
    NamedVoice("voice_ked_diphone", "radio", "american-english"),
    NamedVoice("voice_cmu_us_slt_arctic_hts", "radio", "american-english"),
    NamedVoice("voice_suo_fi_lj_diphone", "finnish", "finnish"),
    NamedVoice("voice_hy_fi_mv_diphone", "finnish", "finnish"),
    NamedVoice("voice_lp_diphone", "latin", "italian"),
    NamedVoice("voice_pc_diphone", "latin", "italian"),
    NamedVoice("voice_czech_machac", "czech", "czech"),
    NamedVoice("voice_czech_dita", "czech", "czech"),
    NamedVoice("voice_czech_ph", "czech", "czech"),
    NamedVoice("voice_upc_ca_ona_hts", "latin", "catalan"),
)
FLITE_VOICES = tuple(NamedVoice(name, "radio", "american-english") for name in ("rms", "slt"))
LEFT_OUT_FLITE = tuple(NamedVoice(name, "radio", "american-english") for name in ("awb", "kal16"))
"""Never trained on, nor any other voice of these speakers."""


def speak_festival(voice: NamedVoice, texts: Sequence[str], *, stretch: float = 1.0) -> list[Spoken]:
    """Texts by a voice of festival; those that it cannot speak are left out. stretch: as of `speak_flite`.

    voice: which; texts: one after the other.
    """
    with tempfile.TemporaryDirectory() as folder:
        script = Path(folder) / "speak.scm"
        lines = [f"({voice.name})", f"(Parameter.set 'Duration_Stretch {stretch})"]
        for index, text in enumerate(texts):
            plain = text.replace('"', "").replace("\\", "")
            lines.append(
                f'(unwind-protect (begin (set! u (utt.synth (Utterance Text "{plain}")))'
                f'(utt.save.wave u "{folder}/{index}.wav")(utt.save.segs u "{folder}/{index}.lab")) nil)'
            )
        script.write_text("\n".join(lines))
        subprocess.run(["festival", "-b", str(script)], check=False, capture_output=True, timeout=SECONDS)
        return [
            _read(Path(folder) / f"{index}.wav", read_lines(Path(folder) / f"{index}.lab"), voice)
            for index in range(len(texts))
            if (Path(folder) / f"{index}.lab").exists() and (Path(folder) / f"{index}.wav").exists()
        ]  # fmt: skip


def speak_flite(voice: NamedVoice, text: str, *, stretch: float = 1.0) -> Spoken:
    """A text by a voice of flite. stretch: how many times as long as it would be."""
    with tempfile.TemporaryDirectory() as folder:
        sound = Path(folder) / "speech.wav"
        command = [
            "flite",
            "-voice",
            voice.name,
            "--setf",
            f"duration_stretch={stretch}",
            "-psdur",
            "-t",
            text,
            "-o",
            str(sound),
        ]
        said = subprocess.run(command, check=True, capture_output=True, text=True, timeout=SECONDS).stdout
        pairs = [each.rsplit(":", 1) for each in said.split()]
        return _read(sound, [(name, float(end)) for name, end in pairs], voice)


def read_lines(path: Path) -> list[tuple[str, float]]:
    """Names and ends of the phones of a file of xwaves."""
    found = []
    for line in path.read_text(errors="replace").splitlines():
        parts = line.split()
        if len(parts) >= 3:
            found.append((parts[2], float(parts[0])))
    return found


def _read(path: Path, ends: list[tuple[str, float]], voice: NamedVoice) -> Spoken:
    rate, samples = wavfile.read(path)
    sound = samples.astype(np.float32) / 32768.0
    segments = []
    start = 0.0
    for name, end in ends:
        if end > start:
            segments.append(Segment(start, end, name, shapes_of_name(voice.phone_set, name)))
            start = end
    return Spoken(resample(sound, rate), tuple(segments))
