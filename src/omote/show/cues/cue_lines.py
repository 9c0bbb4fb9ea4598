"""What cues have characters say: as every `say`, by a member of the crew that is the cues themselves."""

from __future__ import annotations

from omote.perform.cues.cue_action import SpokenLine
from omote.perform.cues.cue_names import named_character
from omote.show.declaration import ClientMessage, Session
from omote.show.objects.link import Refused
from omote.show.objects.speech import PlaySound, Say, SayByVoice

CUES = "cues"
"""The client that speaks for cues: links are numbered, and senders have two words."""


def speak_lines(session: Session, now: float) -> None:
    """Has said what cues ask for; consoles read of what cannot be. session: of the show; now: seconds, monotonic."""
    for place, (cue, line) in enumerate(session.cues.take_lines()):
        if CUES not in session.members.present:
            session.join(CUES, "Cues")
        call = f"{CUES} {session.epoch} {session.number} {place}"
        who = named_character(line.character, session.scene.labels)
        for answer in session.receive(CUES, _message(line, who, call), now):
            if isinstance(answer.message, Refused):
                session.reject_line(f"{cue}: {answer.message.reason}")


def _message(line: SpokenLine, character: str, call: str) -> ClientMessage:
    if line.voice:
        return SayByVoice(character, call, line.text, line.voice)
    if line.sound and not line.text:
        return PlaySound(character, call, line.sound)
    return Say(character, call, line.text, sound=line.sound)
