"""A chat program speaks through a character of a running show: your bot, your text to speech, lips in time.

For developers of chat bots and of exhibits: put your bot in the place of `answer` and your text to speech in that of
`voice`. First start `omote show chat.omote`, open its /stage in a browser and click it once for the sound.
Run: python examples/chat_speaks.py [ADDRESS]     then type; an empty line ends
"""

import argparse
import re
import shutil
import subprocess
import sys

import omote

RULES = (  # what one says, what it answers, with which expression and gesture
    (r"\b(hi|hello|hey)\b", "Hello! Nice to meet you.", "smile", "nod"),
    (r"\?", "My answer is maybe. Please believe me.", "doubt", "tilt"),
    (r"\b(sad|bad|no)\b", "Oh no, I am so sorry about that.", "sad", "shake"),
    (r"", "Wonderful! Tell me more about it.", "joy", "brows"),
)


def answer(line: str) -> tuple[str, str, str]:
    """Your chat program: what to say, an expression, a gesture."""
    return next(rule[1:] for rule in RULES if re.search(rule[0], line.lower()))


def voice(text: str) -> bytes | None:
    """Your text to speech: a WAV, MP3 or Ogg; None: the lips move, and nothing is heard."""
    if shutil.which("espeak-ng") is None:
        return None
    command = ["espeak-ng", "-v", "en", "-s", "150", "--stdout", "--", text]
    return subprocess.run(command, capture_output=True, check=True).stdout


def chat(address: str, character: str) -> None:
    """Answers what is typed, line by line; each answer is awaited before the next line is read."""
    with omote.connect(address, name="chat") as show:
        one = show[character]
        for line in iter(lambda: input("you: "), ""):
            text, expression, gesture = answer(line)
            print(text)
            sound = voice(text)
            one.call_expression(expression, seconds=0.5, strength=0.7)
            one.gesture(gesture)
            if not one.say(text, sound=sound).wait(timeout=60):
                print("(interrupted)")
        one.call_expression("neutral")


options = argparse.ArgumentParser(description="A chat program speaks through a character of a running show.")
options.add_argument("address", nargs="?", default="http://127.0.0.1:8090", help="what `omote show` prints")
options.add_argument("--character", default="one", help="its name or label")
given = options.parse_args()
if shutil.which("espeak-ng") is None:
    print("espeak-ng is not installed: the lips move, and nothing is heard (apt install espeak-ng)", file=sys.stderr)
try:
    chat(given.address, given.character)
except (EOFError, KeyboardInterrupt):
    print()
except (ConnectionError, TimeoutError, ValueError, subprocess.CalledProcessError) as error:
    sys.exit(f"chat_speaks: {error}")
except KeyError as error:  # no such character
    sys.exit(f"chat_speaks: {error.args[0]}")
