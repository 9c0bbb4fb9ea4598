"""Opens a show, joins it as a console over its websocket, calls a face and hears what is on air.

For developers of consoles, bridges (OSC, MIDI, a tracker) and bots; the messages are in the reference, "The wire".
Run: python examples/talk_to_a_show.py [FOLDER]     writes FOLDER/talk.omote (the show) and FOLDER/heard.jsonl
"""

import asyncio
import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import aiohttp
import msgspec

out = Path(sys.argv[1] if len(sys.argv) > 1 else "out")
out.mkdir(parents=True, exist_ok=True)

pack = msgspec.msgpack.encode
unpack = msgspec.msgpack.decode


async def play(address: str) -> list[dict[str, Any]]:
    """What a console hears from hello until its call has arrived."""
    heard = []
    async with aiohttp.ClientSession() as session, session.ws_connect(f"{address}/link") as link:
        await link.send_bytes(pack({"type": "hello", "role": "console", "version": 14}))
        call = {
            "type": "call_face",
            "character": "one",
            "id": "first",
            "name": "dog",
            "seconds": 0.5,
            "easing": "smooth",
        }
        await link.send_bytes(pack(call))
        await link.send_bytes(pack({**call, "id": "second", "name": "nobody"}))  # is answered with the reason
        async for message in link:
            heard.append(unpack(message.data))
            if heard[-1]["type"] == "state" and heard[-1]["characters"]["one"]["faces"] == {"dog": 1.0}:
                break
    return heard


command = ["omote", "show", str(out / "talk.omote"), "--port", "0", "--no-open"]
command[0] = str(Path(sys.executable).with_name("omote"))
with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as show:
    assert show.stdout is not None
    address = next(found[0] for line in show.stdout if (found := re.search(r"http://127\.0\.0\.1:\d+", line)))
    try:
        heard = asyncio.run(asyncio.wait_for(play(address), 60))
    finally:
        show.terminate()

states = [message for message in heard if message["type"] == "state"]
print("welcome:", *(m["digest"] for m in heard if m["type"] == "welcome"))
print("refused:", *(m["reason"] for m in heard if m["type"] == "refused"))
print(f"{len(states)} states until {states[-1]['characters']['one']['faces']}")
(out / "heard.jsonl").write_text("".join(json.dumps(message) + "\n" for message in heard))
