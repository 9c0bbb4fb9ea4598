"""Synthetic voices of this machine, of eSpeak NG and of Piper: a child process with limits on time and memory speaks,
and ends.

Nothing of the voice's library is in the show: see docs/decisions/microphone-and-speech.md, "A voice".
"""

from __future__ import annotations

import importlib
import importlib.util
import re
from pathlib import Path

import numpy as np

from omote.inputs.voices.phones import Segment, claim_closures, shapes_of_ipa
from omote.inputs.voices.spoken_text import (
    FULL_SCALE,
    NO_VOICE,
    SpokenText,
    Voice,
    WantedSpeech,
    check_wanted,
    put_together,
)
from omote.perform.limits import check_known
from omote.server.sandbox.child_task import Limits, run_limited
from omote.server.sandbox.espeak_ng import USUAL_RATE, Espeak, LibraryVoice, Sounded
from omote.server.sandbox.piper_models import find_models, list_models, speak_by_model
from omote.show.objects.speech import MOST_MARKS

LIMITS = Limits(seconds=20, patience=60.0, memory=2**30)
SHORTEST_PAUSE = 0.06
"""Seconds; what is silent for less belongs to a phone."""
_SWITCH = re.compile(r"\([a-z-]+\)")
"""How the library marks that another language begins."""
_PACKAGE = "espeakng_loader"
_TOO_MUCH = "speaking this text needs more time or memory than any speech; say less at once"


def list_voices() -> list[Voice]:
    """The voices of this machine: models of Piper, then those of eSpeak NG by the names of their languages."""
    models = list_models()
    if not _is_installed():
        return models
    languages = run_limited(
        lambda _: [Voice(voice.language, voice.label) for _, voice in sorted(_by_language(_library()).items())],
        list[Voice], LIMITS, exhausted="the voices of this machine cannot be listed: its eSpeak NG does not answer",
    )  # fmt: skip
    return models + languages


def speak(text: str, *, voice: str = "en-gb", speed: float = 1.0) -> SpokenText:
    """A text as a synthetic voice of this machine says it, with the times of its visemes, for `say`.

    Parameters
    ----------
    text : str
        What is said, to 2000 characters, in the voice's language.
    voice : str
        The name of a voice, `de` or `en-us`, with a variant `de+f2`, or of a model of Piper that `omote voice` keeps.
    speed : float
        How fast, as a share of the voice's own speed, 0.5 to 2.

    Returns
    -------
    SpokenText
        Its sound (a WAV), `seconds`, and `marks` (visemes) with their `times` (seconds).

    Raises
    ------
    ValueError
        Where no voice is installed, for one that there is not, and for a text that it cannot speak.

    Examples
    --------
    >>> performer = omote.Performer(cast)
    >>> spoken = omote.speak("Mama", voice="de")
    >>> spoken.marks
    ['PP', 'aa', 'PP', 'aa', 'sil']
    >>> performer.say("Mama", timing="visemes", marks=spoken.marks, times=spoken.times)

    References
    ----------
    docs/method.md, "Speech"; docs/decisions/microphone-and-speech.md, "A voice".
    """
    wanted = check_wanted(WantedSpeech(text, voice, speed))
    models = find_models()
    name, _, speaker = (voice, "", "") if voice in models else voice.rpartition("+")
    if name in models:
        return speak_by_model(models[name], wanted, speaker)
    if not _is_installed():
        raise ValueError(f"there is no voice {voice!r}; near are {', '.join(models)}" if models else NO_VOICE)
    return run_limited(lambda _: _speak(wanted, list(models)), SpokenText, LIMITS, exhausted=_TOO_MUCH)


def _is_installed() -> bool:
    importlib.invalidate_caches()  # it may have been installed while the show was on
    return importlib.util.find_spec(_PACKAGE) is not None


def _library() -> Espeak:
    import espeakng_loader  # an extra

    return Espeak(espeakng_loader.get_library_path(), espeakng_loader.get_data_path())


def _speak(wanted: WantedSpeech, models: list[str]) -> SpokenText:
    library = _library()
    language, plus, variant = wanted.voice.partition("+")
    found = _find_voice(_by_language(library), language, models)
    if plus:
        check_known(variant, _variants(), "variant of a voice")
    sounded = library.speak(found.identifier + plus + variant, wanted.text, rate=round(USUAL_RATE * wanted.speed))
    levels = sounded.sound.astype(np.float32) / FULL_SCALE
    segments = claim_closures(segments_of(sounded), levels, sounded.rate)
    return put_together(sounded.sound, sounded.rate, segments, most=MOST_MARKS)


def _variants() -> list[str]:
    """The names of speakers that each voice can be."""
    import espeakng_loader

    return sorted(path.name for path in (Path(espeakng_loader.get_data_path()) / "voices" / "!v").iterdir())


def _by_language(library: Espeak) -> dict[str, LibraryVoice]:
    """The first voice of each language."""
    return {voice.language: voice for voice in reversed(list(library.voices()))}


def _find_voice(voices: dict[str, LibraryVoice], language: str, models: list[str]) -> LibraryVoice:
    """The voice of a language; of `en` the first of its regions. models: names that are near too, where none has it."""
    wanted = language.strip().lower().replace("_", "-")
    by_name = {name.lower(): voice for name, voice in voices.items()}
    region = next((name for name in sorted(by_name) if wanted and name.startswith(f"{wanted}-")), wanted)
    found = wanted if wanted in by_name else region
    return by_name[found] if found in by_name else by_name[check_known(language, [*models, *voices], "voice")]


def segments_of(sounded: Sounded) -> list[Segment]:
    """The phones of a text in time; a gap between two of them that is no pause looks as the next."""
    names = [_SWITCH.sub("", name) for _, name in sounded.phones]
    starts = [sample / sounded.rate for sample, _ in sounded.phones]
    ends = [*starts[1:], len(sounded.sound) / sounded.rate]
    return [
        Segment(start, end, name, () if not name and end - start < SHORTEST_PAUSE else shapes_of_ipa(name))
        for start, end, name in zip(starts, ends, names, strict=True)
        if end > start
    ]
