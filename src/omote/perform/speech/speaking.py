"""What a character says: the speech that is on, those that wait, and the mouth of it all; an interruption does not
jump."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from omote.arrays import Values
from omote.perform.easing import EASINGS
from omote.perform.frame import SpeechStatus
from omote.perform.limits import FOREVER, check_within
from omote.perform.speech.speech_timing import LONGEST_TEXT
from omote.perform.speech.viseme_track import EMPTY_TRACK, LEAD_SECONDS, VisemeTrack, mouth_at
from omote.perform.speech.visemes import MOUTH_UNITS

SOUND_LEAD_SECONDS = 0.4
"""How long before its first sound a speech begins whose sound the stage plays: it must fetch and decode it first."""
ABOUT_TO_SPEAK = 0.2
"""How long before its sound a speech takes the lips."""
TAKE_SECONDS = 0.12
GIVE_SECONDS = 0.35
"""In which the lips are taken from what lies below, a smile, and given back to it."""
LONGEST_DELAY = 3600.0
LONGEST_OFFSET = 1.0
MOST_WAITING = 16
RELEASE_SECONDS = 0.15
"""In which the mouth of a speech that is interrupted goes over to what follows."""
_RELEASE = EASINGS["smooth"]
LONGEST_KEY = 64
SHOWN_TEXT = 120
"""Characters of a text that a state has: it is sent sixty times a second."""


@dataclass(frozen=True)
class Speech:
    """One thing said.

    Parameters
    ----------
    track : VisemeTrack
        Its visemes with their times.
    text : str
        For people.
    sound : str
        The key of the sound that the stage plays; "" for none.
    offset : float
        Seconds by which the mouth is later than the sound, -1 to 1: to trim a desk's or a loudspeaker's delay.
    elapsed : float
        Seconds since its sound began; below 0 before that.
    number : int
        Counts what the character has said.
    key : str
        What whoever said it calls it; "" for nothing.
    lips : bool
        Whether it moves the lips; else the sound is heard, and who plays the mouth goes on.

    Raises
    ------
    ValueError
        On numbers out of range.
    TypeError
        On what is no number.
    """

    track: VisemeTrack
    text: str = ""
    sound: str = ""
    offset: float = 0.0
    elapsed: float = -LEAD_SECONDS
    number: int = 0
    key: str = ""
    lips: bool = True

    def __post_init__(self) -> None:
        """Rejects what is out of range."""
        check_within(self.offset, -LONGEST_OFFSET, LONGEST_OFFSET, "the offset of a speech (seconds)")
        check_within(self.elapsed, -FOREVER, FOREVER, "the time of a speech (seconds)")
        if len(self.text) > LONGEST_TEXT or max(len(self.sound), len(self.key)) > LONGEST_KEY:
            raise ValueError(
                f"a speech has a text of at most {LONGEST_TEXT} characters, a sound and a key of at most {LONGEST_KEY}"
            )

    @property
    def ended(self) -> bool:
        """Whether neither mouth nor sound has anything left."""
        return self.elapsed >= self.track.seconds + max(self.offset, 0.0) + LEAD_SECONDS


@dataclass(frozen=True)
class Speaking:
    """What a character says now, and what it says after. mouth: that which showed when something else was said or it
    was stopped, `since` seconds ago; speech: None once it is stopped. lips: how far they have been taken from what
    lies below, as a share of the time for it."""

    speech: Speech | None = None
    waiting: tuple[Speech, ...] = ()
    mouth: tuple[float, ...] = ()
    since: float = 0.0
    lips: float = 0.0

    @property
    def moves(self) -> bool:
        """Whether the mouth moves, or is about to."""
        return self.lips > 0.0 or self.takes_lips

    @property
    def takes_lips(self) -> bool:
        """Whether something is said, or about to be."""
        return self.speech is not None and self.speech.lips and self.speech.elapsed > -ABOUT_TO_SPEAK

    @property
    def ended(self) -> bool:
        """Whether nothing is said and the lips are given back."""
        return self.speech is None and self.lips <= 0.0


def make_speech(
    track: VisemeTrack, *, text: str, sound: str, delay: float, offset: float, number: int, key: str = ""
) -> Speech:
    """A speech that begins in `delay` seconds, 0 to 3600; the sound of one that the stage plays a little later, so that
    it can be fetched. ValueError and TypeError for what is out of range.

    track: its mouth; text: what is said; offset: seconds by which the mouth is later, -1 to 1; number: counts all that
    was said; key: what whoever said it calls it.
    """
    wait = check_within(delay, 0.0, LONGEST_DELAY, "the delay of a speech (seconds)")
    lead = max(SOUND_LEAD_SECONDS if sound else LEAD_SECONDS, wait)
    trim = check_within(offset, -LONGEST_OFFSET, LONGEST_OFFSET, "the offset of a speech (seconds)")
    return Speech(track, text, sound, trim, -max(lead, LEAD_SECONDS - trim), number, key)


def make_sound(sound: str, seconds: float, *, delay: float, number: int, key: str = "") -> Speech:
    """A sound that is heard without lips, and begins in `delay` seconds to the bit, -3600 to 3600: below 0 it has begun
    that long ago. ValueError and TypeError for what is out of range.

    sound: the key of what the stage plays; seconds: its length; number, key: as of `make_speech`.
    """
    wait = check_within(delay, -LONGEST_DELAY, LONGEST_DELAY, "the delay of a sound (seconds)")
    return Speech(VisemeTrack((), (), seconds), "", sound, elapsed=-wait, number=number, key=key, lips=False)


def say(speaking: Speaking | None, speech: Speech, *, queue: bool) -> Speaking:
    """What is said from now on: a speech instead of all others, or, by `queue`, after them; ValueError where too many
    wait.

    speaking: what is said now, None for nothing.
    """
    if speaking is None:
        return Speaking(speech)
    if not queue or speaking.speech is None:
        return Speaking(speech, (), _shown(speaking), lips=speaking.lips)
    if len(speaking.waiting) >= MOST_WAITING:
        raise ValueError(f"{MOST_WAITING} speeches wait already; wait for one to end, or say this without queue")
    return replace(speaking, waiting=(*speaking.waiting, speech))


def stop(speaking: Speaking | None) -> Speaking | None:
    """Nothing is said any more: the mouth goes to rest."""
    return None if speaking is None else Speaking(None, (), _shown(speaking), lips=speaking.lips)


def advance_speaking(speaking: Speaking, dt: float) -> Speaking | None:
    """What is said `dt` seconds later; None once nothing is and the mouth is at rest. speaking: what is said now."""
    speech = speaking.speech
    waiting = speaking.waiting
    since = speaking.since + dt
    later = None if speech is None else replace(speech, elapsed=speech.elapsed + dt)
    while later is not None and later.ended:
        late = later.elapsed - (later.track.seconds + max(later.offset, 0.0) + LEAD_SECONDS)
        later = replace(waiting[0], elapsed=waiting[0].elapsed + late) if waiting else None
        waiting = waiting[1:]
    lips = speaking.lips + dt / TAKE_SECONDS if speaking.takes_lips else speaking.lips - dt / GIVE_SECONDS
    lips = min(max(lips, 0.0), 1.0)
    advanced = replace(speaking, speech=later, waiting=waiting, since=min(since, RELEASE_SECONDS), lips=lips)
    return None if advanced.ended else advanced


def find_spoken(before: Speaking, after: Speaking | None) -> str | None:
    """The key of the newest speech that ended by itself while time went from `before` to `after`; None for none."""
    left = set() if after is None else {speech.number for speech in speeches_of(after)}
    ended = [speech.key for speech in speeches_of(before) if speech.number not in left]
    return ended[-1] if ended else None


def speeches_of(speaking: Speaking) -> tuple[Speech, ...]:
    """What is said and what waits, in its order."""
    return (() if speaking.speech is None else (speaking.speech,)) + speaking.waiting


def share_of_lips(speaking: Speaking) -> float:
    """How much of the layer of the lips is taken now, 0 to 1."""
    return _RELEASE.value(speaking.lips)


def mouth_of_speaking(speaking: Speaking) -> Values:
    """The mouth now, weights of `MOUTH_UNITS`."""
    speech = speaking.speech
    said = speech if speech is not None else Speech(EMPTY_TRACK)
    mouth = mouth_at(said.track, said.elapsed - said.offset if speech is not None else LEAD_SECONDS)
    if not speaking.mouth or speaking.since >= RELEASE_SECONDS:
        return mouth
    gone = _RELEASE.value(speaking.since / RELEASE_SECONDS)
    held: Values = (1.0 - gone) * np.array(speaking.mouth) + gone * mouth
    return held


def speech_status(speaking: Speaking | None) -> SpeechStatus | None:
    """What is said now, for those who look on."""
    if speaking is None or speaking.speech is None:
        return None
    speech = speaking.speech
    waiting = speaking.waiting
    return SpeechStatus(
        speech.number,
        speech.text[:SHOWN_TEXT],
        speech.elapsed,
        speech.track.seconds,
        speech.sound,
        len(waiting),
        waiting[0].sound if waiting else "",
        tuple(speech.key for speech in speeches_of(speaking) if speech.key),
    )


def check_speaking(speaking: Speaking | None) -> Speaking | None:
    """Returns what was read; ValueError where no performer can have said it."""
    if speaking is None:
        return None
    if len(speaking.mouth) not in (0, len(MOUTH_UNITS)) or len(speaking.waiting) > MOST_WAITING:
        raise ValueError(f"a mouth has {len(MOUTH_UNITS)} weights, and at most {MOST_WAITING} speeches wait")
    for weight in speaking.mouth:
        check_within(weight, 0.0, 1.0, "the weight of a mouth")
    check_within(speaking.lips, 0.0, 1.0, "how far lips are taken")
    check_within(speaking.since, 0.0, FOREVER, "the time since a speech was interrupted (seconds)")
    return speaking


def _shown(speaking: Speaking) -> tuple[float, ...]:
    return tuple(min(max(weight, 0.0), 1.0) for weight in mouth_of_speaking(speaking).tolist())
