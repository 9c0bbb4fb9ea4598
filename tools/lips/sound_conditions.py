"""What happens to a voice between mouth and microphone: rooms, filters, noise, gain; and a whisper made of a voice."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.linalg import solve_toeplitz
from scipy.signal import butter, fftconvolve, lfilter, sosfilt

from omote.inputs.microphone.sound_features import SAMPLE_RATE

Sound = np.ndarray
KINDS = {
    "white": 0.15, "pink": 0.23, "brown": 0.1, "hum": 0.04, "clicks": 0.06, "music": 0.12, "babble": 0.3,
}  # fmt: skip
"""Of noise for training, and how often."""
_ORDER = 18
_WHISPER_WINDOW = 400
_WHISPER_STEP = 200


@dataclass(frozen=True)
class Condition:
    """noise: dB of noise beside the speech, None without; swell: dB by which it comes and goes; peak: dB of full scale;
    room: seconds of its decay, 0 without; talkers: of babble."""

    noise: float | None = None
    kind: str = "pink"
    peak: float = -10.0
    room: float = 0.0
    whisper: bool = False
    tilt: tuple[float, ...] = ()
    lowest: float = 0.0
    highest: float = 8000.0
    swell: float = 0.0
    talkers: int = 4


def apply_condition(sound: Sound, condition: Condition, rng: np.random.Generator, babble: Sound | None = None) -> Sound:
    """The sound as a microphone hears it. babble: others who speak, for the kind "babble".

    condition: level, noise, room and filter; rng: of what is random in them.
    """
    heard = whisper(sound, rng) if condition.whisper else sound
    heard = _room(heard, condition.room, rng) if condition.room else heard
    heard = _color(heard, condition)
    level = speech_power(heard)
    if condition.noise is not None:
        noise = make_noise(condition.kind, len(heard), rng, babble, condition.talkers)
        noise = noise * _swell(len(heard), condition.swell, rng) if condition.swell else noise
        heard = heard + noise * np.sqrt(level / max(np.mean(noise**2), 1e-12)) * 10 ** (condition.noise / 20)
    heard = heard * (10 ** (condition.peak / 20) / max(np.max(np.abs(heard)), 1e-6))
    dither = rng.uniform(-0.5, 0.5, len(heard)) / 32768
    clipped: Sound = np.clip(heard + dither, -1.0, 1.0).astype(np.float32)
    return clipped


def draw_condition(rng: np.random.Generator) -> Condition:
    """A condition for training, drawn at random."""
    loud = rng.random() < 0.15
    return Condition(
        noise=_draw_noise(rng),
        kind=str(rng.choice(list(KINDS), p=list(KINDS.values()))),
        peak=float(rng.uniform(0, 12)) if loud else float(rng.uniform(-36, 0)),
        room=float(rng.uniform(0.08, 0.5)) if rng.random() < 0.35 else 0.0,
        whisper=bool(rng.random() < 0.12),
        tilt=tuple(rng.normal(0, 5, 5).tolist()) if rng.random() < 0.7 else (),
        lowest=float(rng.uniform(50, 250)) if rng.random() < 0.3 else 0.0,
        highest=float(rng.uniform(3400, 7900)) if rng.random() < 0.25 else 8000.0,
        swell=float(rng.uniform(2, 8)) if rng.random() < 0.3 else 0.0,
        talkers=int(rng.integers(1, 6)),
    )


def _draw_noise(rng: np.random.Generator) -> float | None:
    """dB of noise beside the speech: none, a lot, some, little."""
    drawn = rng.random()
    if drawn < 0.12:
        return None
    return float(-rng.uniform(*((2, 13) if drawn < 0.55 else (13, 25) if drawn < 0.8 else (25, 45))))


def speech_power(sound: Sound) -> float:
    """The mean square of what is spoken: of the frames within 25 dB of the loudest."""
    frames = sound[: len(sound) // 160 * 160].reshape(-1, 160)
    power = np.mean(frames.astype(float) ** 2, axis=1)
    return float(np.mean(power[power > np.max(power, initial=0.0) * 10**-2.5])) if len(power) else 0.0


def make_noise(kind: str, count: int, rng: np.random.Generator, babble: Sound | None = None, talkers: int = 4) -> Sound:
    """Noise of a kind: white, pink, brown, hum (of the mains), clicks, music, babble (`talkers` of it speak).

    kind: as named; count: samples; rng: of the noise.
    """
    if kind == "babble" and babble is not None and len(babble):
        starts = rng.integers(0, len(babble), talkers)
        return sum((np.resize(np.roll(babble, -start), count) for start in starts), np.zeros(count))
    if kind == "hum":
        time = np.arange(count) / SAMPLE_RATE
        base = float(rng.choice([50.0, 60.0]))
        return sum((np.sin(2 * np.pi * base * n * time + n) / n for n in range(1, 9)), 0.02 * rng.normal(size=count))
    if kind == "music":
        return _music(count, rng)
    if kind == "clicks":  # keys, cups, steps
        struck = (rng.random(count) < 4.0 / SAMPLE_RATE) * rng.normal(size=count)
        fall = rng.normal(size=800) * np.exp(-np.arange(800) / rng.uniform(40, 250))
        clicks: Sound = fftconvolve(struck, fall)[:count] + 1e-3 * rng.normal(size=count)
        return clicks
    slope = {"white": 0.0, "pink": -0.5, "brown": -1.0}.get(kind, -0.5)
    spectrum = np.fft.rfft(rng.normal(size=count))
    return np.fft.irfft(spectrum * np.maximum(np.fft.rfftfreq(count, 1 / SAMPLE_RATE), 20.0) ** slope, count)


def _music(count: int, rng: np.random.Generator) -> Sound:
    """Chords of plucked notes and a beat of noise: what a loudspeaker beside the speaker plays."""
    made = 1e-3 * rng.normal(size=count)
    beat = int(rng.uniform(0.2, 0.6) * SAMPLE_RATE)
    time = np.arange(2 * beat) / SAMPLE_RATE
    for start in range(0, count, beat):
        notes = 110.0 * 2.0 ** (rng.choice([0, 3, 5, 7, 10, 12, 15, 17, 19, 24], 3) / 12)
        chord = sum(np.sin(2 * np.pi * note * n * time) / n**1.5 for note in notes for n in range(1, 7))
        struck = (chord + (rng.random() < 0.5) * rng.normal(size=len(time)) * np.exp(-30 * time)) * np.exp(-4 * time)
        made[start : start + len(time)] += struck[: count - start]
    return made


def _swell(count: int, most: float, rng: np.random.Generator) -> Sound:
    """A gain that comes and goes by `most` dB, every half second or so."""
    places = np.arange(0, count + SAMPLE_RATE // 2, SAMPLE_RATE // 2)
    return 10.0 ** (np.interp(np.arange(count), places, rng.uniform(-most, most, len(places))) / 20)


def whisper(sound: Sound, rng: np.random.Generator) -> Sound:
    """A voice without its vocal cords: each frame's resonances (linear prediction), excited by noise.

    sound: samples; rng: of the noise.
    """
    window = np.hanning(_WHISPER_WINDOW)
    made = np.zeros(len(sound) + _WHISPER_WINDOW)
    for start in range(0, len(sound) - _WHISPER_WINDOW, _WHISPER_STEP):
        frame = sound[start : start + _WHISPER_WINDOW] * window
        spectrum = np.abs(np.fft.rfft(np.append(frame[0], frame[1:] - 0.9 * frame[:-1]), 1024)) ** 2
        correlation = np.fft.irfft(spectrum)[: _ORDER + 1]
        if correlation[0] < 1e-9:
            continue
        correlation[0] *= 1.001
        predictor = solve_toeplitz(correlation[:-1], correlation[1:])
        noise = rng.normal(size=_WHISPER_WINDOW)
        shaped = lfilter([1.0], np.concatenate([[1.0], -predictor]), noise) * window
        gain = np.sqrt(np.mean(frame**2) / max(np.mean(shaped**2), 1e-12))
        made[start : start + _WHISPER_WINDOW] += shaped * gain
    return made[: len(sound)]


def _room(sound: Sound, decay: float, rng: np.random.Generator) -> Sound:
    """A room whose sound falls by 60 dB in `decay` seconds, heard from near."""
    count = int(decay * SAMPLE_RATE)
    tail = rng.normal(size=count) * 10 ** (-3.0 * np.arange(count) / count)
    tail[: int(0.002 * SAMPLE_RATE)] = 0.0
    tail *= rng.uniform(0.1, 0.6) / np.sqrt(np.sum(tail**2))
    tail[0] = 1.0
    heard: Sound = fftconvolve(sound, tail)[: len(sound)]
    return heard


def _color(sound: Sound, condition: Condition) -> Sound:
    """The tone of a microphone: a smooth curve, and its ends cut."""
    if condition.tilt:
        spectrum = np.fft.rfft(sound)
        bands = np.interp(np.fft.rfftfreq(len(sound), 1 / SAMPLE_RATE), [100, 400, 1200, 3000, 7000], condition.tilt)
        sound = np.fft.irfft(spectrum * 10 ** (bands / 20), len(sound))
    if condition.lowest > 20.0:
        sound = sosfilt(butter(2, condition.lowest, "high", fs=SAMPLE_RATE, output="sos"), sound)
    if condition.highest < 7950.0:
        sound = sosfilt(butter(4, condition.highest, "low", fs=SAMPLE_RATE, output="sos"), sound)
    return sound
