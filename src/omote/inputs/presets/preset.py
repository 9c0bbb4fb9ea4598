"""A preset: the controls of a device as its makers tell them, and what they play until somebody binds them anew."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from omote.inputs.bindings.control_binding import Binding
from omote.inputs.bindings.target import BANK, read_target
from omote.inputs.presets.lamp import DeviceLamp
from omote.show.objects.bindings import PresetDocument, SourceKind

FEELINGS = (
    *("neutral", "smile", "joy", "laugh", "sad", "cry", "angry", "shout"),
    *("surprise", "fear", "disgust", "contempt", "sleepy", "asleep", "kiss", "wink"),
)
"""Expressions for rows of keys, in the order in which people look for them."""
LEVELS = (
    ("jawOpen",),
    ("mouthSmileLeft", "mouthSmileRight"),
    ("mouthFrownLeft", "mouthFrownRight"),
    ("mouthPucker",),
    ("browInnerUp",),
    ("browDownLeft", "browDownRight"),
    ("eyeBlinkLeft", "eyeBlinkRight"),
    ("cheekPuff",),
)
"""Channels for eight faders, both halves of a face on one."""
DIRECTIONS = (("head", "yaw"), ("head", "pitch"), ("head", "roll"), ("gaze", "yaw"), ("gaze", "pitch"))


@dataclass(frozen=True)
class PresetControl:
    """What a control plays: `to` is an address behind the character, or with a slash before it one of the show; more:
    fields of its binding."""

    name: str
    to: str
    axis: str | None = None
    arguments: tuple[str | float, ...] = ()
    more: Mapping[str, Any] = field(default_factory=dict)

    def binding(self, device: str, character: str) -> Binding:
        """Its binding for a device and a character."""
        path = self.to if self.to.startswith((BANK, "/")) else f"/omote/{character}/{self.to}"
        target = read_target(path, self.arguments, self.axis)
        low, high = target.usual_range if target.is_level else (0.0, 1.0)
        return Binding(device, self.name, target, **{"low": low, "high": high, **self.more})


@dataclass(frozen=True)
class Preset:
    """A device's preset. matches: regular expressions that its name fulfils; lamps, touches, greeting: how it is shown
    what is on air (`DeviceFeedback`)."""

    name: str
    label: str
    kind: SourceKind
    matches: tuple[str, ...]
    controls: tuple[PresetControl, ...]
    lamps: Mapping[str, DeviceLamp] = field(default_factory=dict)
    touches: Mapping[str, str] = field(default_factory=dict)
    greeting: bytes = b""

    def fits(self, device: str, kind: str) -> bool:
        """Whether it is made for a device of this name and kind."""
        return kind == self.kind and any(re.search(match, device, re.IGNORECASE) for match in self.matches)

    def bindings(self, device: str, character: str) -> list[Binding]:
        """Its bindings for a device. character: whom they play."""
        return [control.binding(device, character) for control in self.controls]

    @property
    def document(self) -> PresetDocument:
        """What pages are told of it."""
        return PresetDocument(self.name, self.label, self.kind, list(self.matches))


def faders(names: Iterable[str], **more: Any) -> list[PresetControl]:
    """The channels of `LEVELS`, one after the other, on these controls.

    names: of the controls; more: options of their bindings.
    """
    pairs = zip(names, LEVELS, strict=False)
    return [PresetControl(name, f"channel/{unit}", more=more) for name, units in pairs for unit in units]


def feelings(names: Iterable[str], first: int = 0, seconds: float = 0.5) -> list[PresetControl]:
    """The expressions of `FEELINGS` from one on, called by these keys.

    names: of the keys; first: the place of the first; seconds: that a call takes.
    """
    pairs = zip(names, FEELINGS[first:], strict=False)
    return [PresetControl(name, "expression", arguments=(feeling, seconds)) for name, feeling in pairs]


def faces(names: Iterable[str], wanted: Iterable[str], seconds: float = 2.0) -> list[PresetControl]:
    """Faces, called by these keys. names: of the keys; wanted: the faces; seconds: that a call takes."""
    return [PresetControl(name, "face", arguments=(face, seconds)) for name, face in zip(names, wanted, strict=False)]


def directions(names: Iterable[str], **more: Any) -> list[PresetControl]:
    """Head and gaze on these controls; their middle looks straight ahead.

    names: of the controls; more: options of their bindings.
    """
    return [PresetControl(name, to, axis, more=more) for name, (to, axis) in zip(names, DIRECTIONS, strict=False)]
