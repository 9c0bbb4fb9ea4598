"""A chat program speaks through a character: any text to speech, the sound from the stage, lips in time, a nod.

For developers of chat bots and of exhibits. A voice is a function from a text to a sound and its times: here espeak-ng
where it is installed (--voice espeak), else a humming one that needs nothing. The chat is a few rules.
Run: python examples/chat_speaks.py [FOLDER]                     opens a show of its own, writes FOLDER/spoken.csv
     python examples/chat_speaks.py --show http://127.0.0.1:8090   speaks in yours: open /stage, then type
"""

import argparse
import csv
import io
import re
import shutil
import subprocess
import sys
import wave
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

import omote

RATE = 16000


class Voiced(NamedTuple):
    """What a voice gives: a sound (WAV, MP3, Ogg), and what it knows of its times.

    timing, marks, times: as of `say`: ("words", ["Hello", "there"], [0.0, 0.4]), or ("visemes", ...), ("azure", ...),
    ("characters", ...). A voice that knows nothing leaves them: the text is then stretched to the sound.
    """

    sound: bytes
    timing: str = "text"
    marks: Sequence[str] = ()
    times: Sequence[float] = ()


Voice = Callable[[str], Voiced]


def humming_voice(text: str) -> Voiced:
    """A tone for each word, as long as the word has letters; it knows exactly when each begins."""
    words = re.findall(r"[\w'’]+", text)  # noqa: RUF001  (the apostrophe of typesetters)
    lengths = [0.12 + 0.06 * len(word) for word in words]
    times = [0.05 + sum(lengths[:place]) + 0.04 * place for place in range(len(words))]
    samples = np.zeros(int(RATE * (times[-1] + lengths[-1] + 0.2)) if words else RATE)
    for place, (begin, length) in enumerate(zip(times, lengths, strict=True)):
        at = np.arange(int(RATE * length)) / RATE
        tone = 140.0 + 12.0 * (place % 4)
        hum = sum(np.sin(2 * np.pi * tone * number * at) / number for number in range(1, 8))
        samples[int(RATE * begin) :][: len(at)] += 0.15 * hum * np.sin(np.pi * at / length) ** 0.5
    return Voiced(wav(samples), "words", words, [*times, times[-1] + lengths[-1]]) if words else Voiced(wav(samples))


def espeak_voice(text: str) -> Voiced:
    """The command espeak-ng, which tells no times: the text is stretched to its sound."""
    done = subprocess.run(["espeak-ng", "-v", "en", "-s", "150", "--stdout", text], capture_output=True, check=True)
    return Voiced(done.stdout)


def wav(samples: np.ndarray) -> bytes:
    """A WAV file of samples from -1 to 1."""
    made = io.BytesIO()
    with wave.open(made, "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(RATE)
        file.writeframes((32767 * np.clip(samples, -1, 1)).astype("<i2").tobytes())
    return made.getvalue()


class Chat:
    """Answers by a few rules: what it says, and with which expression and gesture."""

    RULES = (
        (r"\b(hi|hello|hey)\b", "Hello! Nice to meet you.", "smile", "nod"),
        (r"\?", "My answer is maybe. Please believe me.", "doubt", "tilt"),
        (r"\b(sad|bad|no)\b", "Oh no, I am so sorry about that.", "sad", "shake"),
        (r"", "Wonderful! Tell me more about it.", "joy", "brows"),
    )

    def answer(self, line: str) -> tuple[str, str, str]:
        """What to say, an expression, and a gesture."""
        rule = next(rule for rule in self.RULES if re.search(rule[0], line.lower()))
        return rule[1:]


class Speaker:
    """A character of a running show that says what a program wants it to say."""

    def __init__(self, show: Any, voice: Voice, character: str = "one") -> None:
        self.show, self.voice, self.character = show, voice, show[character]

    def speak(self, text: str, *, expression: str = "neutral", gesture: str = "") -> None:
        """Says a text, after what is being said; the stage plays the voice."""
        sound, timing, marks, times = self.voice(text)
        key = self.show.send_sound(sound)
        self.character.call_expression(expression, seconds=0.5, strength=0.7)
        self.character.say(text, timing=timing, marks=marks, times=times, sound=key, queue=True)
        if gesture:
            self.character.gesture(gesture)

    def wait(self) -> Iterator[Any]:
        """The frames until all is said."""
        while (frame := self.character.frame).speech is not None:
            yield frame
            self.show.wait()


@contextmanager
def own_show(folder: Path) -> Iterator[str]:
    """The address of a show of this script's own."""
    folder.mkdir(parents=True, exist_ok=True)
    command = [str(Path(sys.executable).with_name("omote")), "show", str(folder / "chat.omote")]
    with subprocess.Popen([*command, "--port", "0", "--no-open"], stdout=subprocess.PIPE, text=True) as show:
        assert show.stdout is not None
        try:
            yield next(found[0] for line in show.stdout if (found := re.search(r"http://127\.0\.0\.1:\d+", line)))
        finally:
            show.terminate()


def talk(speaker: Speaker, lines: Iterator[str]) -> list[dict[str, Any]]:
    """Answers line by line; what the character did meanwhile."""
    seen = []
    for line in lines:
        text, expression, gesture = Chat().answer(line)
        print(f"> {line}\n{text}")
        speaker.speak(text, expression=expression, gesture=gesture)
        for frame in speaker.wait():
            jaw, pitch = frame.channels.get("jawOpen", 0.0), frame.head.pitch
            seen.append({"time": frame.time, "text": frame.speech.text, "jaw": jaw, "pitch": pitch})
    return seen


options = argparse.ArgumentParser()
options.add_argument("folder", nargs="?", type=Path, default=Path("out"))
options.add_argument("--show", default="", help="the address of a running show")
options.add_argument(
    "--voice", choices=["espeak", "humming"], default="espeak" if shutil.which("espeak-ng") else "humming"
)
given = options.parse_args()
voice: Voice = {"espeak": espeak_voice, "humming": humming_voice}[given.voice]
if given.show:
    with suppress(EOFError), omote.connect(given.show, name="chat") as show:  # until an empty line or Ctrl-D
        talk(Speaker(show, voice), iter(lambda: input("you: "), ""))
else:
    with own_show(given.folder) as address, omote.connect(address, name="chat") as show:
        seen = talk(Speaker(show, voice), iter(["Hello there", "Do you like the theatre?"]))
    with (given.folder / "spoken.csv").open("w", newline="") as file:
        writer = csv.DictWriter(file, ["time", "text", "jaw", "pitch"])
        writer.writeheader()
        writer.writerows(seen)
    widest = max(each["jaw"] for each in seen)
    print(f"{len(seen)} frames of speech, jaw open to {widest:.2f}, with the voice {given.voice}")
