"""Other people's clients against ours, both ways, over real sockets: PyPI's `vmcp` and `PyLiveLinkFace`.

They run in processes of their own, from an environment of their own, for `vmcp` is under the AGPL and neither is a
dependency:

    python -m venv /tmp/clients && /tmp/clients/bin/pip install "vmcp[osc4py3]" PyLiveLinkFace timecode
    python -m benchmarks.tracker_clients --python /tmp/clients/bin/python

What each sends drives a character of a session; what our face output sends, each reads back. Values are compared.
"""

from __future__ import annotations

import argparse
import socket
import subprocess
import sys
import time

import omote
from omote.inputs.face_output.face_target import FaceTarget
from omote.inputs.trackers.tracker_input import TrackerInput
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS
from omote.server.devices.face_output import FaceOutput
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.faders import SetChannel, SetHead
from omote.show.objects.link import Hello
from omote.show.session import ShowSession

HOST = "127.0.0.1"
JAW = 0.625
LONG = 20.0

VMC_NAMES = """
from vmcp.typing import BlendShapeKey
class Key(BlendShapeKey):
    JAW = "JawOpen"
    BLINK = "Blink_L"
"""
VMC_SENDS = (
    VMC_NAMES
    + """
import sys, time
from vmcp.osc import OSC
from vmcp.osc.typing import Message
from vmcp.osc.backend.osc4py3 import as_comthreads as backend
from vmcp.protocol import blendshape, blendshape_apply, bone_transform, state, time as vmc_time
from vmcp.typing import Bone, CoordinateVector, ModelState, Quaternion, Timestamp
osc = OSC(backend)
with osc.open():
    out = osc.create_sender("127.0.0.1", int(sys.argv[1]), "sender").open()
    for _ in range(40):
        out.send((
            Message(*state(ModelState.LOADED)), Message(*vmc_time(Timestamp())),
            Message(*bone_transform(Bone.HEAD, CoordinateVector.identity(), Quaternion(0.0, -0.0998, 0.0, 0.995))),
            Message(*blendshape(Key.JAW, 0.625)), Message(*blendshape(Key.BLINK, 0.25)), Message(*blendshape_apply()),
        ))
        osc.run()
        time.sleep(0.05)
"""
)
VMC_READS = """
import sys, time
from vmcp.osc import OSC
from vmcp.osc.backend.osc4py3 import as_comthreads as backend
from vmcp.events import BlendShapeEvent, BoneTransformEvent
from vmcp.facades import on_receive
from vmcp.typing import BlendShapeKey
class Key(BlendShapeKey):
    JAW = "JawOpen"
found = {}
def received(event):
    found[type(event).__name__ + str(getattr(event, "key", getattr(event, "joint", "")))] = event
osc = OSC(backend)
with osc.open():
    receiver = osc.create_receiver("127.0.0.1", int(sys.argv[1]), "receiver").open()
    on_receive(receiver, BlendShapeEvent, received)
    on_receive(receiver, BoneTransformEvent, received)
    print("ready", flush=True)
    until = time.monotonic() + 15
    while time.monotonic() < until and not any("JawOpen" in str(e) or "JAW" in k for k, e in found.items()):
        osc.run()
for each in found.values():
    print(each, flush=True)
"""
LINK_SENDS = """
import socket, sys, time
from pylivelinkface import PyLiveLinkFace, FaceBlendShape
face = PyLiveLinkFace(name="Python", fps=60)
face.set_blendshape(FaceBlendShape.JawOpen, 0.625, True)
face.set_blendshape(FaceBlendShape.EyeBlinkLeft, 0.25, True)
face.set_blendshape(FaceBlendShape.HeadYaw, -0.2, True)
out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
for _ in range(40):
    out.sendto(face.encode(), ("127.0.0.1", int(sys.argv[1])))
    time.sleep(0.05)
"""
LINK_READS = """
import socket, sys
from pylivelinkface import PyLiveLinkFace, FaceBlendShape
heard = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
heard.bind(("127.0.0.1", int(sys.argv[1])))
heard.settimeout(15)
print("ready", flush=True)
found, face = PyLiveLinkFace.decode(heard.recv(2000))
read = (round(face.get_blendshape(each), 5) for each in (FaceBlendShape.JawOpen, FaceBlendShape.HeadYaw))
print(found, face.name, *read)
"""


def free_port() -> int:
    """A port of UDP that nobody has."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind((HOST, 0))
        return int(taken.getsockname()[1])


def hear(cast: omote.Cast, protocol: str, python: str, code: str) -> tuple[dict[str, float], int]:
    """What a client's packets drive, once both its values have come, and how many were rejected."""
    session = ShowSession(cast)
    port = free_port()
    trackers = TrackerInput(TRACKER_PROTOCOLS[protocol], lambda: session)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as heard:
        heard.bind((HOST, port))
        heard.settimeout(0.2)
        client = subprocess.Popen([python, "-c", code, str(port)])
        until = time.monotonic() + LONG
        while time.monotonic() < until and client.poll() is None:
            try:
                data, (host, _) = heard.recvfrom(65536)
            except TimeoutError:
                continue
            trackers.receive(host, data, 0.0)
        client.wait(LONG)
    return trackers.values(), trackers.rejected


def tell(cast: omote.Cast, protocol: str, python: str, code: str) -> str:
    """What a client reads of a face that we send."""
    session = ShowSession(cast)
    port = free_port()
    session.receive("console", Hello("console", PROTOCOL_VERSION, "console"), 0.0)
    session.receive("console", SetChannel("one", "jawOpen", JAW), 0.0)
    session.receive("console", SetHead("one", 0.2, 0.0, 0.0), 0.0)
    client = subprocess.Popen([python, "-c", code, str(port)], stdout=subprocess.PIPE, text=True)
    assert client.stdout is not None
    client.stdout.readline()
    output = FaceOutput([FaceTarget(protocol, HOST, port)], lambda: session)
    for tick in range(200):
        output.tell(session.tick(tick / 60), tick / 60)
        if client.poll() is not None:
            break
        time.sleep(1 / 60)
    said, _ = client.communicate(timeout=LONG)
    return said.strip()


def main() -> int:
    """Prints what was heard and told; returns 1 where a value is another."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--python", required=True, help="of the environment that has the clients")
    options = parser.parse_args()
    cast = omote.load_cast()
    checks: dict[str, bool] = {}
    for name, protocol, code in (("vmcp", "vmc", VMC_SENDS), ("PyLiveLinkFace", "livelink", LINK_SENDS)):
        values, rejected = hear(cast, protocol, options.python, code)
        yaw = values.get("head yaw", 0.0)
        print(f"{name} heard: jawOpen {values.get('jawOpen')}, eyeBlinkLeft {values.get('eyeBlinkLeft')}, "
              f"head yaw {yaw:.4f}, {rejected} rejected")  # fmt: skip
        right = abs(values.get("jawOpen", 0.0) - JAW) < 1e-6 and abs(values.get("eyeBlinkLeft", 0.0) - 0.25) < 1e-6
        checks[f"{name} sends"] = right and not rejected
    for name, protocol, code in (("vmcp", "vmc", VMC_READS), ("PyLiveLinkFace", "livelink", LINK_READS)):
        said = tell(cast, protocol, options.python, code)
        print(f"{name} reads of ours: {said[:400] or 'nothing'}")
        checks[f"{name} reads"] = str(JAW) in said
    for name, holds in checks.items():
        print(f"  {name}: {'as it was sent' if holds else 'ANOTHER VALUE'}")
    return 0 if all(checks.values()) else 1


if __name__ == "__main__":
    sys.exit(main())
