"""A noun of the show is one module: all else is derived. A throw-away noun is put beside the others and played."""

import subprocess
import sys
from pathlib import Path

LANTERN = '''
"""Lanterns that hang over the stage."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated

from omote.show.declaration import CallId, ClientMessage, Name, Outgoing, Session
from omote.show.osc import Value, osc

HUNG = {}


class HangLantern(ClientMessage, frozen=True):
    """Hangs a lantern at a height over the stage, in metres."""

    access = "edit"
    plays = "light"
    method = ""
    osc = (osc("lantern/{name}", "hangs a lantern", "height", of_show=True),)

    id: CallId
    name: Annotated[Name, Value("text")]
    height: Annotated[float, Value(low=0.0, high=9.0, unit="m")]

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Hangs it."""
        HUNG[self.name] = self.height
        return ()
'''

PLAYED = """
import sys
import omote.show.objects
omote.show.objects.__path__.append(sys.argv[1])

from omote.builtin import load_cast
from omote.client.remote_show import RemoteShow
from omote.inputs.bindings.target import read_target
from omote.inputs.osc_input import OscInput
from omote.inputs.osc_packet import encode_message
from omote.inputs.oscquery_tree import build_addresses, find_node
from omote.show.access.people_list import Visitor
from omote.show.messages import BY_TAG, PROTOCOL_VERSION
from omote.show.objects.lantern import HUNG, HangLantern
from omote.show.objects.leases import Lease, SetLeases
from omote.show.objects.link import Hello, Refused
from omote.show.session import ShowSession
from omote.show.wire import decode, encode
from tools.messages import show_module
from tools.website.osc_reference import osc_page
from tools.website.wire_reference import wire_page

session = ShowSession(load_cast())
session.receive("a", Hello("console", PROTOCOL_VERSION, "Ana"), 0.0)
message = HangLantern("a-1", "red", 2.0)
assert BY_TAG["hang_lantern"] is HangLantern
assert decode(encode(message)) == message

session.receive_bytes("a", encode(message), 0.0)
session.receive("a", HangLantern("a-1", "red", 8.0), 0.0)
assert HUNG == {"red": 2.0}, "an id executes once"

osc = OscInput(lambda: session)
osc.receive(("10.0.0.5", 9000), encode_message("/omote/lantern/blue", 3.0), 0.0)
assert HUNG["blue"] == 3.0
assert find_node(build_addresses(session.cast, ["one"]), "/omote/lantern") is not None
assert read_target("/omote/lantern/blue").usual_range == (0.0, 9.0)

(refused,) = session.receive("a", HangLantern("a-2", "red", 15.0), 0.0)
assert refused.message.reason.startswith("height is 15.0; give a number from 0 to 9"), refused
assert HUNG["red"] == 2.0

session.members.identify("b", Visitor("operate", "Ben", "id"))
session.receive("b", Hello("console", PROTOCOL_VERSION, "Ben"), 0.0)
(denied,) = session.receive("b", HangLantern("b-1", "red", 1.0), 0.0)
assert 'needs the role "edit"' in denied.message.reason

session.receive("a", SetLeases("a-2", True), 0.0)
session.receive("a", Lease("a-3", "*", "light"), 0.0)
session.receive("c", Hello("console", PROTOCOL_VERSION, "Cem"), 0.0)
held = session.receive("c", HangLantern("c-1", "red", 1.0), 0.0)[0].message
assert isinstance(held, Refused) and "Ana holds the light" in held.reason
assert HUNG["red"] == 2.0

sent = []
show = RemoteShow(sent.append, None, lambda: "p-1", None, None)
show.hang_lantern("green", height=4.0)
assert sent == [HangLantern("p-1", "green", 4.0)]

assert "export type HangLantern" in show_module()
assert "/omote/lantern/{name}" in osc_page()
assert "hang_lantern" in wire_page()
"""


def test_a_noun_is_one_module_and_all_else_is_derived(tmp_path: Path) -> None:
    (tmp_path / "lantern.py").write_text(LANTERN)
    played = subprocess.run(
        [sys.executable, "-c", PLAYED, str(tmp_path)], check=False, capture_output=True, text=True, timeout=300
    )
    assert played.returncode == 0, played.stderr
