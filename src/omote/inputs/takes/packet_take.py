"""A recording of a tracker from a capture of its packets, whatever it speaks."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from omote.inputs.rejection import PacketError
from omote.inputs.takes.packet_capture import Packet
from omote.inputs.takes.take import Take, TakeNotes
from omote.inputs.trackers.arkit_names import ARKIT_CHANNELS
from omote.inputs.trackers.head_angles import GazeAngles, HeadAngles
from omote.inputs.trackers.packet_format import is_read_by, recognize_format
from omote.inputs.trackers.tracker_frame import TrackerFrame
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS, TrackerProtocol
from omote.perform.limits import check_known

MOST_LOOKED_AT = 1000
"""Packets by whose first bytes a protocol is known."""


def choose_protocol(packets: Sequence[Packet], name: str = "") -> TrackerProtocol:
    """The protocol that packets are read by: the named one, else that of the port to which most have come, else the one
    whose packets they are, VMC where a capture does not say; ValueError where there is none.

    name: as options spell it, "" for none.
    """
    if name:
        return TRACKER_PROTOCOLS[check_known(name.strip().lower(), TRACKER_PROTOCOLS, "tracker")]
    usual = {
        protocol.port: protocol
        for protocol in reversed(list(TRACKER_PROTOCOLS.values()))
        if protocol.heard and not protocol.stream
    }
    for port, _ in Counter(packet.port for packet in packets).most_common():
        if port in usual:
            return usual[port]
    if all(packet.port == 0 for packet in packets):
        return TRACKER_PROTOCOLS["vmc"]
    if name := recognize_most(packets):
        return TRACKER_PROTOCOLS[name]
    raise ValueError("no packet went to a tracker's usual port; say what it is, such as --protocol vmc")


def recognize_most(packets: Sequence[Packet]) -> str:
    """The protocol that most packets are of, of those that are known by their first bytes; "" where none is."""
    formats = Counter(recognize_format(packet.data) for packet in packets[:MOST_LOOKED_AT])
    del formats[""]
    return next((name for name, _ in formats.most_common(1)), "")


def read_packet_take(packets: Sequence[Packet], protocol: TrackerProtocol) -> Take:
    """The recording of the sender that sent most; ValueError where none of its packets is a face.

    protocol: by which they are read.
    """
    ports = {packet.port for packet in packets}
    spoken = [packet for packet in packets if packet.port == protocol.port] if protocol.port in ports else packets
    (host, _), *_ = Counter(packet.host for packet in spoken).most_common(1)
    decode = protocol.open(lambda _: None)
    frames = list[tuple[float, TrackerFrame]]()
    notes = TakeNotes()
    newest = ""
    for packet in spoken:
        if packet.host != host:
            continue
        try:
            frames += [(packet.time, frame) for frame in decode(packet.data) if frame.found]
        except PacketError as error:
            newest = str(error)
            notes.add("packet", f"a packet is left out: {newest}")
    if not frames:
        name = recognize_most(spoken)
        other = f"they are {TRACKER_PROTOCOLS[name].title}, --protocol {name}" if name else newest
        reason = newest if is_read_by(name, protocol.name) else other
        raise ValueError(f"no packet of the capture is a face of {protocol.title}{reason and f': {reason}'}")
    begun = next((at for at, (_, frame) in enumerate(frames) if frame.weights), 0)
    return _gather(frames[begun:], notes)  # bones that come before the first values of VMC are no frame yet


def _gather(frames: Sequence[tuple[float, TrackerFrame]], notes: TakeNotes) -> Take:
    """Frames one after the other; what one lacks is as it was. notes: on packets that are no frames."""
    weights: dict[str, float] = {}
    head: HeadAngles = (0.0, 0.0, 0.0)
    gaze: GazeAngles = (0.0, 0.0)
    times = list[float]()
    rows = list[dict[str, float]]()
    heads = list[HeadAngles]()
    gazes = list[GazeAngles]()
    for time, frame in frames:
        weights |= _read_channels(frame)
        notes.add_values(frame.left_out)
        head = frame.head or head
        gaze = frame.gaze or gaze
        times.append(max(time - frames[0][0], times[-1] if times else 0.0))
        rows.append(dict(weights))
        heads.append(head)
        gazes.append(gaze)
    names = tuple(weights)
    values = [tuple(row.get(name, 0.0) for name in names) for row in rows]
    turned = any(map(any, heads))
    looked = any(map(any, gazes))
    return Take(names, times, values, heads if turned else (), gazes if looked else (), notes.sentences())


def _read_channels(frame: TrackerFrame) -> dict[str, float]:
    """A frame's weights by ARKit's names; of several that mean the same the largest."""
    weights: dict[str, float] = {}
    for name, value in frame.weights.items():
        for channel, share in ARKIT_CHANNELS.shares(name).items():
            weights[channel] = max(weights.get(channel, -1.0), share * value)
    return weights
