"""Replays a log of commands: the same states come out, byte for byte.

For whoever tests a show, debugs one or studies one: a session is a pure function of messages and times.
Run: python examples/replay_a_log.py [FOLDER]       writes FOLDER/log.jsonl and FOLDER/states.bin
"""

import json
import sys
from pathlib import Path

import msgspec

import omote
from omote.show.messages import PROTOCOL_VERSION
from omote.show.session import ShowSession
from omote.show.wire import encode

out = Path(sys.argv[1] if len(sys.argv) > 1 else "out")
out.mkdir(parents=True, exist_ok=True)

# What consoles sent, and when (seconds of any monotonic clock). It opens with hello, as every link does.
CALL = {"character": "one", "easing": "smooth"}
LOG = [
    (10.00, {"type": "hello", "role": "console", "version": PROTOCOL_VERSION}),
    (10.10, {"type": "call_face", **CALL, "id": "a", "name": "kaori", "seconds": 1.0}),
    (
        10.42,
        {"type": "call_expression", **CALL, "id": "b", "name": "smile", "seconds": 0.5},
    ),
    (
        10.42,
        {"type": "call_expression", **CALL, "id": "b", "name": "smile", "seconds": 0.5},
    ),  # a retry
    (10.70, {"type": "fade_face", "character": "one", "value": 0.8}),
    (10.81, {"type": "set_gaze", "character": "one", "yaw": 0.3, "pitch": -0.1}),
    (11.20, {"type": "call_face", **CALL, "id": "c", "name": "noh", "seconds": 2.0}),
    (11.50, {"type": "panic", "character": "one"}),
]
(out / "log.jsonl").write_text("".join(json.dumps(line) + "\n" for line in LOG))


def replay(log: Path, *, start: float = 10.0, seconds: float = 2.0, rate: float = 60.0) -> bytes:
    """The states that a show sends while it hears a log, one message behind the other."""
    cast = omote.load_cast()
    session = ShowSession(cast)
    waiting = [json.loads(line) for line in log.read_text().splitlines()]
    states = []
    for number in range(round(seconds * rate) + 1):
        now = start + number / rate
        while waiting and waiting[0][0] <= now:
            at, message = waiting.pop(0)
            session.receive_bytes("console-1", msgspec.msgpack.encode(message), at)
        states.append(encode(session.tick(now)))
    assert session.refused == 0
    return b"".join(states)


first = replay(out / "log.jsonl")
second = replay(out / "log.jsonl")
(out / "states.bin").write_bytes(first)
print(f"{len(first)} bytes of states; the second run gives {'the same' if first == second else 'OTHER'} bytes")
sys.exit(first != second)
