"""Trackers: damaged packets of every protocol, and what four trackers at 60 Hz cost.

* a million damaged packets of each protocol: none raises anything but a rejection, none puts NaN on air (issue 12,
  item 1); of each packet some bytes are another, it is cut short, or it is noise;
* a packet is on air with the next tick;
* 52 channels at 60 Hz with head and gaze from four trackers, decoding and driving: at most 3 % of a core. Beside it
  stands the cost of the same session without them, which is not in it. Times are of the processor, of one thread.

`python -m benchmarks.trackers [--packets N] [--seconds S] [--protocols vmc,livelink]`.
"""

from __future__ import annotations

import os

from benchmarks.pace import Pace
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.link import Hello

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy is loaded

import argparse
import struct
import sys
import time
from collections.abc import Callable

import msgspec
import numpy as np
from rich.console import Console
from rich.table import Table

import omote
from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.inputs.trackers.face_motion.motion_message import Kind, MotionMessage
from omote.inputs.trackers.face_motion.motion_receiver import REVISION, Schema
from omote.inputs.trackers.face_text import encode_face_text
from omote.inputs.trackers.live_link_face import encode_live_link_face
from omote.inputs.trackers.tracker_input import TrackerInput
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS
from omote.inputs.trackers.vmc_messages import encode_vmc
from omote.inputs.trackers.vtube_studio.api_message import API_NAME
from omote.inputs.trackers.vtube_studio.api_parameters import write_parameters
from omote.show.session import ShowSession

RATE = 60
BAR_CORE = 0.03
"""Of a core, where the pace is 1."""
HOST = "10.0.0.7"
SESSION = 7
HEAD = (0.2, -0.1, 0.05)
GAZE = (0.1, 0.05)
PLAY_EVERY = 500
"""Damaged packets between two ticks."""
FOUR = ("vmc", "livelink", "ifacialmocap", "vtubestudio")

Face = Callable[[float], list[bytes]]


def weights_at(moment: float) -> dict[str, float]:
    """Weights that all move."""
    return {name: 0.5 + 0.5 * float(np.sin(moment + index)) for index, name in enumerate(ARKIT_NAMES)}


def phone_face(moment: float) -> list[bytes]:
    """A frame of VTube Studio."""
    shapes = ",".join(f'{{"k":"{name}","v":{value:.6f}}}' for name, value in weights_at(moment).items())
    turn = '{"x":3.5,"y":9.1,"z":0.5}'
    return [
        f'{{"Timestamp":1,"FaceFound":true,"Rotation":{turn},"EyeLeft":{turn},"EyeRight":{turn},'
        f'"BlendShapes":[{shapes}]}}'.encode()
    ]


def open_see_face(moment: float) -> list[bytes]:
    """A record of OpenSeeFace that fits, with features that move."""
    record = bytearray(1785)
    record[28] = 1
    record[33:49] = np.array([0.7071, -0.7071, 0.0, 0.05], "<f4").tobytes()
    record[1729:] = np.sin(moment + np.arange(14)).astype("<f4").tobytes()
    return [bytes(record)]


def link_face(moment: float) -> list[bytes]:
    """A packet of Live Link Face."""
    weights = list(weights_at(moment).values())
    return [encode_live_link_face(weights, HEAD, GAZE, device="D" * 36, subject="Phone", frame=int(60 * moment))]


def text_face(moment: float) -> list[bytes]:
    """A frame of iFacialMocap."""
    return [encode_face_text(weights_at(moment), HEAD, GAZE)]


def vmc_face(moment: float) -> list[bytes]:
    """The packets of VMC."""
    return encode_vmc(weights_at(moment), HEAD, GAZE, moment)


def api_face(moment: float) -> list[bytes]:
    """The parameters of VTube Studio on a computer."""
    values = {**write_parameters(weights_at(moment), HEAD, GAZE), **weights_at(moment)}
    listed = [{"name": name, "value": round(value, 6)} for name, value in values.items()]
    data = {"modelLoaded": True, "customParameters": [], "defaultParameters": listed}
    message = {"apiName": API_NAME, "messageType": "InputParameterListResponse", "requestID": "omote", "data": data}
    return [msgspec.json.encode(message)]


def mediapipe_face(moment: float) -> list[bytes]:
    """A result of MediaPipe."""
    named = weights_at(moment).items()
    categories = ",".join(f'{{"score":{value:.6f},"categoryName":"{name}"}}' for name, value in named)
    return [f'{{"faceBlendshapes":[{{"categories":[{categories}]}}]}}'.encode()]


def motion_face(moment: float) -> list[bytes]:
    """The list of names and a frame of FMV3."""
    values = [round(100.0 * value) for value in weights_at(moment).values()]
    pose = struct.pack("<12f", 5.0, 10.0, 2.0, 0.0, 0.0, 0.3, 3.0, 4.0, 0.0, 3.0, 4.0, 0.0)
    payload = struct.pack(f"<{len(values)}h", *values) + pose
    number = int(RATE * moment)
    frame = MotionMessage(Kind.FRAME, SESSION, 1, number, 1, payload=payload).encode()
    start = struct.pack("<QHHII", 0, RATE, 1200, 10_000, REVISION)
    schema = Schema(
        1, "iFacialMocap", "ifacialmocap-stream", list(ARKIT_NAMES), "i16", "percent",
        "head_rxyz_pxyz_rightEye_rxyz_leftEye_rxyz", "degree", "meter",
    )  # fmt: skip
    names = MotionMessage(Kind.SCHEMA, SESSION, 1, payload=start + msgspec.json.encode(schema)).encode()
    return [names, frame]


FACES: dict[str, Face] = {
    "vmc": vmc_face, "vmc-performer": vmc_face, "livelink": link_face, "ifacialmocap": text_face,
    "facemotion3d": text_face, "openseeface": open_see_face, "vtubestudio": phone_face, "meowface": phone_face,
    "mediapipe": mediapipe_face, "ifacialmocap-v3": motion_face, "facemotion3d-v3": motion_face,
    "ifacialmocap-tcp": text_face, "facemotion3d-tcp": text_face, "vtubestudio-pc": api_face,
}  # fmt: skip


class Damage:
    """Packets with some bytes changed, cut short, or noise; numbers are drawn many at a time, which takes less than
    decoding does."""

    def __init__(self, seed: int) -> None:
        self._generator = np.random.default_rng(seed)
        self._drawn: list[int] = []

    def _draw(self, below: int) -> int:
        if not self._drawn:
            self._drawn = self._generator.integers(0, 1 << 31, 65536).tolist()
        return self._drawn.pop() % below

    def damage(self, packet: bytes) -> bytes:
        """Another packet that is not as it should be."""
        kind = self._draw(10)
        if kind == 0:
            return packet[: self._draw(len(packet))]
        if kind == 1:
            return self._generator.bytes(1 + self._draw(199))
        damaged = bytearray(packet)
        for _ in range(1 + self._draw(3)):
            damaged[self._draw(len(damaged))] = self._draw(256)
        return bytes(damaged)


def play_damaged(cast: omote.Cast, name: str, count: int) -> tuple[int, int, int]:
    """Damaged packets of a protocol: how many were rejected, raised something else, and put on air what is no
    number."""
    session = ShowSession(cast)
    spoiler = Damage(12)
    trackers = TrackerInput(TRACKER_PROTOCOLS[name], lambda: session)
    golden = FACES[name](0.0)
    raised = wrong = 0
    for index in range(count):
        packet = spoiler.damage(golden[index % len(golden)])
        now = index / PLAY_EVERY / RATE
        try:
            trackers.receive(HOST, packet, now)
            if index % PLAY_EVERY == 0:
                trackers.play(now)
                character = next(iter(session.tick(now).characters.values()))
                wrong += not np.isfinite([*character.channels.values(), *character.head, *character.gaze]).all()
        except Exception as error:
            raised += 1
            sys.stderr.write(f"{name}: {error!r}\n")
    return trackers.rejected, raised, wrong


def is_on_air_at_once(cast: omote.Cast, name: str) -> bool:
    """Whether the packets of one frame are on air with the tick after them."""
    session = ShowSession(cast)
    trackers = TrackerInput(TRACKER_PROTOCOLS[name], lambda: session)
    session.tick(0.0)
    for packet in FACES[name](1.0):
        trackers.receive(HOST, packet, 0.0)
    trackers.play(0.0)
    character = next(iter(session.tick(1.0 / RATE).characters.values()))
    return bool(character.layers) and character.layers["tracker"].share > 0.0


def share_of_core(cast: omote.Cast, seconds: float, pace: Pace) -> dict[str, float]:
    """The part of a core that each of four trackers takes in so many seconds of a show, each driving a character of its
    own; pace: measured by turns with the ticks."""
    session = ShowSession(cast)
    session.receive("console", Hello("console", PROTOCOL_VERSION, "console"), 0.0)
    inputs = {name: TrackerInput(TRACKER_PROTOCOLS[name], lambda: session) for name in FOUR}
    frames = {name: [FACES[name](0.1 * moment) for moment in range(RATE)] for name in FOUR}
    taken = dict.fromkeys(FOUR, 0.0)
    for tick in range(round(seconds * RATE)):
        for name, trackers in inputs.items():
            begun = time.thread_time()
            for packet in frames[name][tick % RATE]:
                trackers.receive(HOST, packet, tick / RATE)
            trackers.play(tick / RATE)
            taken[name] += time.thread_time() - begun
        session.tick(tick / RATE)
        pace.measure()
    return {name: each / seconds for name, each in taken.items()}


def main() -> int:
    """Prints the figures; returns 1 where one is not reached."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--packets", type=int, default=1_000_000)
    parser.add_argument("--seconds", type=float, default=20.0)
    parser.add_argument("--protocols", default=",".join(TRACKER_PROTOCOLS), help="which, behind commas")
    options = parser.parse_args()
    cast = omote.load_cast()
    table = Table("protocol", "damaged", "rejected", "raised", "no number", "on air at once")
    good = True
    for name in options.protocols.split(","):
        rejected, raised, wrong = play_damaged(cast, name, options.packets)
        at_once = is_on_air_at_once(cast, name)
        good = good and not raised and not wrong and at_once
        table.add_row(name, f"{options.packets:,}", f"{rejected:,}", str(raised), str(wrong), str(at_once))
    pace = Pace()
    shares = share_of_core(cast, options.seconds, pace)
    most = BAR_CORE * pace.ratio()
    console = Console()
    console.print(table)
    parts = ", ".join(f"{name} {100 * share:.2f} %" for name, share in shares.items())
    total = sum(shares.values())
    console.print(f"four trackers: {100 * total:.2f} % of a core ({parts}); at most {100 * most:.1f} %")
    return 0 if good and total <= most else 1


if __name__ == "__main__":
    sys.exit(main())
