"""The addresses of OSC by which a character speaks and makes gestures."""

from __future__ import annotations

from omote.inputs.addresses.address import PRESS, Address, Value
from omote.perform.gestures.gesturing import AMPLITUDE_LIMIT
from omote.perform.speech.speaking import LONGEST_DELAY
from omote.show import messages as wire

STRENGTH = Value("strength", default=1.0)
TEXT = Value("text", "speech")
DELAY = Value("delay", low=0.0, high=LONGEST_DELAY, unit="s", default=0.0)
AMPLITUDE = Value("amplitude", low=-AMPLITUDE_LIMIT, high=AMPLITUDE_LIMIT, default=1.0)
SPEECH_ADDRESSES: tuple[Address, ...] = (
    Address(
        "say",
        "moves its lips to an English text, timed by rule; the sound, which another plays, begins after the delay",
        (TEXT, DELAY),
        lambda who, call, text, delay: wire.Say(who, call, text, delay=delay),
    ),
    Address(
        "say/{language}",
        "the same in a language: en or de",
        (Value("language", "language"), TEXT, DELAY),
        lambda who, call, language, text, delay: wire.Say(who, call, text, language=language, delay=delay),
    ),
    Address(
        "stop_speaking",
        "ends what it says, and all that it would say after",
        (PRESS,),
        lambda who, call: wire.StopSpeaking(who, call),
    ),
    Address(
        "gesture",
        "makes the gesture of this name on top of all that plays; an amplitude below 0 is to the other side",
        (Value("name", "gesture"), AMPLITUDE),
        lambda who, call, name, amplitude: wire.MakeGesture(who, call, name, amplitude),
    ),
    Address(
        "gesture/{name}",
        "the same for a button, when it is pressed",
        (Value("name", "gesture"), PRESS, AMPLITUDE),
        lambda who, call, name, amplitude: wire.MakeGesture(who, call, name, amplitude),
    ),
)
