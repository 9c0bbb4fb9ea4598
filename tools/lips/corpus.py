"""Recordings for the training: many voices and languages under many conditions, as inputs of the network and labels."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from omote.inputs.microphone.sound_features import BANDS, SAMPLE_RATE, FeatureStream, SoundFeatures, band_hertz
from omote.inputs.microphone.speaker_profile import SpeakerState, measure_speaker
from omote.inputs.microphone.viseme_network import frame_inputs
from omote.inputs.voices.phones import Segment
from tools.lips.espeak_voice import Espeak, EspeakVoice
from tools.lips.named_voices import FESTIVAL_VOICES, FLITE_VOICES, NamedVoice, speak_festival, speak_flite
from tools.lips.sentences import make_sentence
from tools.lips.sound_conditions import apply_condition, draw_condition
from tools.lips.spoken import Spoken, label_frames

LANGUAGES = {
    "en": "american-english", "en-us": "american-english", "en-gb-x-rp": "american-english",
    "en-us-nyc": "american-english", "en-gb-scotland": "american-english", "fr": "french",
    "pl": "polish", "sv": "swedish", "nl": "dutch", "pt": "portuguese", "pt-br": "portuguese", "it": "italian",
    "da": "danish", "uk": "ukrainian", "ca": "catalan", "nb": "bokmaal", "bg": "bulgarian",
    "tr": "", "fi": "", "hu": "", "cs": "", "ro": "", "id": "", "sw": "", "et": "", "eo": "", "sk": "", "hr": "",
    "eu": "",
}  # fmt: skip
"""Languages of espeak-ng that are trained on, and their dictionaries."""
LEFT_OUT_LANGUAGES = {"de": "ngerman", "es": "spanish"}
LEFT_OUT_VARIANTS = ("f4", "m7", "Andrea")
"""Never trained on: `benchmarks/lips.py` speaks with them."""
VARIANTS = (
    "", "m1", "m2", "m3", "m4", "m5", "m6", "m8", "f1", "f2", "f3", "f5", "Alex", "Alicia", "Andy", "Annie",
    "Denis", "Diogo", "Gene", "Hugo", "Jacky", "Lee", "Marco", "Mario", "Michael", "Mike", "adam", "anika",
    "antonio", "aunty", "belinda", "benjamin", "boris", "caleb", "david", "ed", "edward", "grandma", "grandpa",
    "gustave", "iven", "john", "kaukovalta", "klatt", "klatt2", "klatt3", "klatt4", "klatt5", "linda", "max",
    "michel", "miguel", "norbert", "pablo", "paul", "pedro", "quincy", "rob", "robert", "sandro", "shelby",
    "steph", "travis", "victor", "zac",
)  # fmt: skip
SENTENCES = 6
TAKES = 4
"""Conditions under which each of the slower voices is heard."""
MOST_OTHERS = 30
"""Sentences that were spoken last, of whom babble is made."""
CALIBRATED_SHARE = 0.4
CALIBRATION_SECONDS = 4


@dataclass(frozen=True, eq=False)
class Recording:
    """What the network is given of each frame, and the viseme of each."""

    frames: np.ndarray
    labels: np.ndarray


def make_recordings(count: int, festival: int, rng: np.random.Generator) -> Iterator[Recording]:
    """`count` recordings of voices of espeak-ng, and `festival` of each slower voice, under several conditions each.

    rng: of all that is random.
    """
    espeak = Espeak()
    others = list[np.ndarray]()
    slower = [voice for voice in (*FESTIVAL_VOICES, *FLITE_VOICES, *FLITE_VOICES) for _ in range(festival)]
    order = rng.permutation(count + len(slower))
    for index in order.tolist():
        said = speak_some(espeak, rng) if index < count else speak_named(slower[index - count], rng)
        for _ in range((1 if index < count else TAKES) if said else 0):
            spoken = change_speed(join_speech(said, rng), rng)
            yield make_recording(spoken, rng, np.concatenate(others) if others else None)
        others = [*others[-MOST_OTHERS:], *(each.sound / max(float(np.abs(each.sound).max()), 0.05) for each in said)]


def speak_named(voice: NamedVoice, rng: np.random.Generator) -> list[Spoken]:
    """Some sentences by a voice of festival or flite.

    voice: which; rng: of the sentences.
    """
    texts = [_plain(make_sentence(voice.words, rng, words=4), voice.words) for _ in range(SENTENCES)]
    stretch = float(rng.uniform(0.65, 1.3))
    if voice in FLITE_VOICES:
        return [speak_flite(voice, text, stretch=stretch) for text in texts]
    return speak_festival(voice, texts, stretch=stretch)


def speak_some(espeak: Espeak, rng: np.random.Generator) -> list[Spoken]:
    """Some sentences by a random voice.

    espeak: the synthesizer; rng: of voice and sentences.
    """
    language = str(rng.choice(list(LANGUAGES)))
    variant = str(rng.choice(VARIANTS))
    name = f"{language}+{variant}" if variant else language
    rate, pitch, span = (int(rng.integers(*each)) for each in ((100, 280), (15, 85), (10, 90)))
    voice = EspeakVoice(name, rate, pitch, span)
    return [espeak.speak(voice, make_sentence(LANGUAGES[language], rng)) for _ in range(SENTENCES)]


def join_speech(parts: Sequence[Spoken], rng: np.random.Generator) -> Spoken:
    """Sentences one after the other, with pauses between them.

    parts: the sentences; rng: of the pauses.
    """
    sounds: list[np.ndarray] = []
    segments: list[Segment] = []
    start = 0
    for part in parts:
        pause = int((rng.uniform(1.5, 4.0) if rng.random() < 0.08 else rng.uniform(0.15, 0.9)) * SAMPLE_RATE)
        segments.append(Segment(start / SAMPLE_RATE, (start + pause) / SAMPLE_RATE, "", ("sil",)))
        start += pause
        shift = start / SAMPLE_RATE
        segments += [Segment(s.start + shift, s.end + shift, s.name, s.shapes) for s in part.segments]
        sounds += [np.zeros(pause, np.float32), part.sound / max(float(np.max(np.abs(part.sound), initial=0.0)), 0.05)]
        start += len(part.sound)
    return Spoken(np.concatenate(sounds), tuple(segments))


def change_speed(spoken: Spoken, rng: np.random.Generator) -> Spoken:
    """The same at another speed, as of a tape, half of the time: it makes a smaller or a larger mouth.

    spoken: speech and its phones; rng: of the speed.
    """
    if rng.random() < 0.5:
        return spoken
    speed = float(rng.uniform(0.84, 1.2))
    places = np.arange(0, len(spoken.sound) - 1, speed)
    sound = np.interp(places, np.arange(len(spoken.sound)), spoken.sound).astype(np.float32)
    return Spoken(sound, tuple(Segment(s.start / speed, s.end / speed, s.name, s.shapes) for s in spoken.segments))


def change_mouth(heard: SoundFeatures, rng: np.random.Generator) -> SoundFeatures:
    """The same from a longer or a shorter throat, half of the time: its resonances lie lower or higher, its pitch does
    not change (Jaitly and Hinton 2013).

    heard: features of a sound; rng: of the length.
    """
    if rng.random() < 0.5:
        return heard
    hertz = band_hertz()
    places = np.interp(hertz * rng.uniform(0.86, 1.16), hertz, np.arange(BANDS))
    low = np.minimum(places.astype(int), BANDS - 2)
    share = (places - low).astype(np.float32)
    bands = heard.bands[:, low] * (1 - share) + heard.bands[:, low + 1] * share
    return SoundFeatures(bands.astype(np.float32), heard.level, heard.voicing)


def make_recording(spoken: Spoken, rng: np.random.Generator, babble: np.ndarray | None) -> Recording:
    """A recording of speech under a random condition, by a speaker who is calibrated or not.

    spoken: speech and its phones; rng: of the condition; babble: others who speak, as samples.
    """
    heard = FeatureStream().push(apply_condition(spoken.sound, draw_condition(rng), rng, babble))
    heard = change_mouth(heard, rng)
    speaker = SpeakerState()
    if rng.random() < CALIBRATED_SHARE:
        first = int(rng.integers(0, max(1, len(heard) - 100 * CALIBRATION_SECONDS)))
        part = slice(first, first + 100 * CALIBRATION_SECONDS)
        try:
            sentence = SoundFeatures(heard.bands[part], heard.level[part], heard.voicing[part])
            speaker = SpeakerState(measure_speaker(sentence))
        except ValueError:
            speaker = SpeakerState()
    frames = frame_inputs(heard, speaker)
    return Recording(frames.astype(np.float16), label_frames(spoken)[: len(frames)].astype(np.int8))


def _plain(text: str, words: str) -> str:
    """Letters as a voice of festival reads them."""
    if words == "ukrainian":
        return text.translate(str.maketrans("іїєґ", "ииег"))
    return unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode()
