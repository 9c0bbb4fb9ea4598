"""The part of a performer that speaks, and has sounds heard."""

from __future__ import annotations

from collections.abc import Sequence

from omote.perform.clip_playing import ClipPlaying
from omote.perform.limits import check_switch
from omote.perform.speech.speaking import make_sound, make_speech, say, stop
from omote.perform.speech.speech_timing import make_track


class SpeechPlaying(ClipPlaying):
    """Speaks on the layer of the lips."""

    def say(
        self,
        text: str = "",
        *,
        timing: str = "text",
        marks: Sequence[str] = (),
        times: Sequence[float] = (),
        language: str = "en",
        seconds: float | None = None,
        sound: str = "",
        delay: float = 0.0,
        offset: float = 0.0,
        queue: bool = False,
        key: str = "",
    ) -> None:
        """Speaks: lips move in time with a sound that something else plays, on the layer *lips*.

        What is said now is interrupted without a jump, and takes the lips from any other source until it ends.

        Parameters
        ----------
        text : str
            What is said, to 2000 characters; read where the timing is "text".
        timing : {"text", "words", "characters", "visemes", "azure", "rhubarb"}
            What the marks are; "text": there are none, and the time of each letter is estimated.
        marks : sequence of str
            Words, single characters, or names of mouth shapes.
        times : sequence of float
            When each mark begins, seconds from the beginning of the sound; one more: the end of the last.
        language : {"en", "de"}
            By whose rules letters are read.
        seconds : float, optional
            The length of the sound, to 600.
        sound : str
            The key of a sound that the stage plays with it.
        delay : float
            Seconds until the sound begins, to 3600; at least 0.15, or 0.4 with a sound of the stage.
        offset : float
            Seconds by which the mouth is later than the sound, -1 to 1.
        queue : bool
            After all that is said already, instead of in its place.
        key : str
            What to call it, to 64 characters: `speech.keys` of a frame has it until it is over, and `spoken` once it
            was said to its end. Without one it has no name.

        Raises
        ------
        ValueError
            On names that there are not, on times that go back, on numbers out of range.
        TypeError
            On what is no number, no text or no switch.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.say("Hello", timing="words", marks=["Hello"], times=[0.0, 0.5])
        >>> speech = performer.advance(0.2).speech
        >>> speech.text, round(speech.elapsed, 2), round(speech.seconds, 2)
        ('Hello', 0.05, 0.5)

        References
        ----------
        docs/method.md, "Speech".
        """
        track = make_track(timing, text, marks, times, language=language, seconds=seconds)
        number = self._now.said + 1
        after = check_switch(queue, "the switch queue")
        speech = make_speech(track, text=text, sound=sound, delay=delay, offset=offset, number=number, key=key)
        self._play(speaking=say(self._now.speaking, speech, queue=after), said=number)

    def play_sound(self, sound: str, seconds: float, *, delay: float = 0.0, key: str = "") -> None:
        """Has a sound heard without lips, in the place of what is said: who plays the mouth goes on.

        Parameters
        ----------
        sound : str
            The key of a sound that the stage plays.
        seconds : float
            How long it is, to 600.
        delay : float
            Seconds until it begins, -3600 to 3600; below 0 it has begun that long ago.
        key : str
            As of `say`.

        Raises
        ------
        ValueError
            On numbers out of range, and texts that are too long.
        TypeError
            On what is no number.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.play_sound("a-key-of-a-sound", 2.0, delay=-0.5)
        >>> frame = performer.advance(0.5)
        >>> frame.speech.elapsed, dict(frame.channels)
        (1.0, {})

        References
        ----------
        docs/method.md, "Speech".
        """
        number = self._now.said + 1
        speech = make_sound(sound, seconds, delay=delay, number=number, key=key)
        self._play(speaking=say(self._now.speaking, speech, queue=False), said=number)

    def stop_speaking(self) -> None:
        """Stops what is said, and forgets what waits: the mouth goes to rest.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.say("Hello")
        >>> performer.stop_speaking()
        >>> performer.advance(0.0).speech is None
        True
        """
        self._play(speaking=stop(self._now.speaking))
