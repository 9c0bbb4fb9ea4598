"""What one pair of hands sends, as packets to be damaged: pads, macros, springs, set-ups and hands, in OSC, as messages
of the wire, and the set-ups that a show file keeps."""

from __future__ import annotations

import math

import msgspec

from omote.inputs.osc_packet import encode_bundle, encode_message
from omote.perform.mappings.mapping import HalfBelow, MacroCondition, MacroMapping, MacroTarget
from omote.perform.pads.blend_space import PadLook
from omote.show.declaration import ClientMessage
from omote.show.objects.bindings import BindingDocument
from omote.show.objects.clips import KeepPass, RecordClip
from omote.show.objects.hand.macros import (
    DropMapping,
    MoveMacro,
    RenameMapping,
    RestoreMapping,
    SetMapping,
    SetMappings,
)
from omote.show.objects.hand.pads import AddCastPads, CopyPad, DropPad, MovePad, RenamePad, RestorePad, SetPad
from omote.show.objects.hand.setups import CallSetup, DropSetup, KeepSetup, RestoreSetup, StoredSetup
from omote.show.objects.motion import SetMotion, SetSpring
from omote.show.wire import encode

CALL = "call0000"
"""Stands in a message for the id of its call: a number of as many digits takes its place in each packet, for what comes
twice under one id is executed once."""
STICK = MacroMapping(
    "stick",
    (
        MacroTarget("channel/jawOpen", 0.0, 0.8, ((0.0, 0.0), (0.4, 0.1), (1.0, 1.0)), rise=0.1, fall=0.3),
        MacroTarget("head/yaw", 0.0, 0.3, below=HalfBelow(-0.3)),
        MacroTarget("pad/mouth/x", -1.0, 1.0),
    ),
)
GAZE = MacroMapping("gaze", (MacroTarget("gaze/yaw", 0.0, 0.4),), MacroCondition("macro/stick", 0.2))
MAPPINGS = [STICK, GAZE]
HAND_AXES = ("opening", "curl1", "curl4", "yaw", "pitch", "roll")


def osc_packets() -> list[bytes]:
    """OSC of pads, macros, springs, set-ups and hands: all of them whole."""
    packets = [
        encode_message("/omote/one/pad/moods", 0.3, -0.6),
        encode_message("/omote/one/pad/mouth", -1.0, 0.25),
        encode_message("/omote/*/pad/faces", 0.5, 0.5),
        encode_message("/omote/{one,two}/pad/{moods,mouth}", 0.1),
        encode_message("/omote/one/macro/stick", -0.75),
        encode_message("/omote/*/macro/gaze", 1),
        encode_message("/omote/one/spring/ears-sway", 1.5),
        encode_message("/omote/one/spring/*", 0.5),
        encode_message("/omote/one/face", "dog", 0.5),
        encode_message("/omote/one/head", 10.0, -5.0, 3.0),
        encode_message("/omote/one/head", -10.0, 5.0, -3.0),
        encode_message("/omote/one/motion", 0.9),
        encode_message("/omote/setup/left-handed", 1.0),
        *(encode_message(f"/omote/one/hand/right/{axis}", 0.4) for axis in HAND_AXES),
        encode_message("/omote/one/hand/left/opening", 1),
    ]
    return [*packets, encode_bundle(packets[-7:]), encode_bundle([packets[0], packets[4], packets[6]])]


def message_packets() -> list[bytes]:
    """The messages of the same (MessagePack), each with the id `CALL`."""
    looks = [PadLook("rest", {"neutral": 1.0}, (0.0, 0.0)), PadLook("wide", {"joy": 0.5, "neutral": 0.5}, (0.7, -0.3))]
    messages: list[ClientMessage] = [
        SetPad(CALL, "own", "mouth", 2, looks, "k1"),
        SetPad(CALL, "line", "expression", 1, [PadLook(each.label, each.mix, each.place[:1]) for each in looks]),
        RenamePad(CALL, "own", "mine", "k1"),
        CopyPad(CALL, "moods", "mine"),
        DropPad(CALL, "mine", "k2"),
        RestorePad(CALL, "k1"),
        AddCastPads(CALL),
        MovePad("one", "moods", 0.4, -0.2),
        MovePad("one", "own", None, 0.9),
        MovePad("*", "faces", 0.5, 0.25, None),
        SetMapping("one", CALL, STICK, "k3"),
        SetMappings("one", CALL, MAPPINGS),
        RenameMapping("one", CALL, "gaze", "look"),
        DropMapping("one", CALL, "look", "k3"),
        RestoreMapping("one", CALL, "k3"),
        MoveMacro("one", "stick", -0.3),
        MoveMacro("*", "gaze", 0.8),
        SetSpring("one", "ears-sway", 1.25),
        SetMotion("one", liveliness=0.8),
        KeepSetup(CALL, "mine"),
        CallSetup(CALL, "mine"),
        DropSetup(CALL, "mine"),
        RestoreSetup(CALL, CALL),
        RecordClip(CALL, "one", "pass", ["mouth"], speed=0.5),
        KeepPass(CALL, "one"),
    ]
    return [encode(message) for message in messages]


def setup_documents() -> list[bytes]:
    """Set-ups as a show file keeps them (JSON)."""
    bound = BindingDocument("pad", "1/cc1", "/omote/one/macro/stick")
    return [
        msgspec.json.encode(each)
        for each in (StoredSetup({"one": MAPPINGS}, [bound]), StoredSetup({"one": [STICK], "two": [GAZE]}))
    ]


def not_numbers() -> list[bytes]:
    """OSC and messages whose numbers are none, or as large as they get."""
    numbers = (math.nan, math.inf, -math.inf, 3.4e38)
    osc = [encode_message("/omote/one/pad/moods", each, each) for each in numbers]
    osc += [
        encode_message(f"/omote/one/{place}", each) for each in numbers for place in ("macro/stick", "spring/ears-flap")
    ]
    return [*osc, *(encode_message("/omote/one/hand/right/yaw", each) for each in numbers)]
