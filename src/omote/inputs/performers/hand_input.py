"""Hands before cameras at a show session: each is a source beside its performer's face."""

from __future__ import annotations

import math
from collections.abc import Callable

from omote.inputs.performers import camera_messages as wire
from omote.inputs.performers.source_route import SourceChoice, route_source
from omote.inputs.source_client import refusals
from omote.inputs.trackers.tracker_frame import TrackerFrame
from omote.inputs.trackers.tracker_input import TrackerInput
from omote.inputs.trackers.tracker_protocols import TrackerProtocol
from omote.perform.layers.layer_names import LAYER_PARTS
from omote.perform.limits import check_known
from omote.perform.scene.character_names import ALL
from omote.show.objects.hand.pads import MovePad
from omote.show.session import ShowSession

POINT = 2
"""Dimensions of a hand that moves before a camera."""


def _decode_nothing(_: bytes) -> list[TrackerFrame]:
    """Its frames come as axes that the page has read."""
    return []


HAND = TrackerProtocol(
    "hand", "Hand", None, "open the page /camera of this show in the performer's browser and choose the hand",
    lambda _: _decode_nothing,
)  # fmt: skip


class HandInput:
    """The hands of all performers before cameras. session: the show that plays; heard: frames of all of them."""

    def __init__(self, session: Callable[[], ShowSession]) -> None:
        self.trackers = TrackerInput(HAND, session)
        self._session = session
        self._chosen: dict[str, SourceChoice] = {}
        self._heard: dict[str, int] = {}
        self._points: dict[str, tuple[str, float, float]] = {}
        self.heard = 0

    def receive(self, name: str, frame: wire.HandFrame) -> None:
        """Takes a frame, for the next tick. name: the performer's."""
        self.heard += 1
        self._heard[name] = self._heard.get(name, 0) + 1
        if frame.point is not None and all(map(math.isfinite, frame.point)):
            x, y = (min(1.0, max(-1.0, way)) for way in frame.point)
            self._points[name] = frame.pad, x, y
        self.trackers.note(
            "", TrackerFrame(frame.weights, frame.head, found=frame.found, time=frame.time, subject=name)
        )

    def choose(self, name: str, message: wire.PlayHand) -> None:
        """Chooses what a performer's hand plays, from its first frame on; ValueError for a character that there is not.

        name: the performer's; message: what is asked.
        """
        characters = [check_known(character, self._session().scene, "character") for character in message.characters]
        self._chosen[name] = SourceChoice(characters, list(message.regions))

    def play(self, now: float) -> None:
        """Drives the session by the newest frame of each hand. now: seconds of the show's clock."""
        self.trackers.play(now)
        for name, choice in list(self._chosen.items()):
            if self.trackers.client("", name) is not None:
                del self._chosen[name]
                if reason := route_source(self._session(), self.trackers, name, choice, now):
                    self.trackers.reject(name, reason, now)
        for name, (pad, x, y) in self._points.items():
            self._move_pad(name, pad, (x, y), now)
        self._points = {}

    def _move_pad(self, name: str, pad: str, point: tuple[float, float], now: float) -> None:
        """Moves a pad on all characters that a performer's hand plays, where the show has one of this name."""
        session = self._session()
        who = self.trackers.client("", name)
        if who is None or pad not in session.scene.pads:
            return
        for character in session.sources.route(self.trackers.title("", name)).characters:
            for reason in refusals(session.receive(who, MovePad(character, pad, *point), now)):
                self.trackers.reject(name, reason, now)

    def end(self, name: str) -> None:
        """Ends the source of a performer's hand; what it plays stays with the show."""
        self.trackers.end("", name)
        self._chosen.pop(name, None)
        self._heard.pop(name, None)

    def choice(self, name: str) -> wire.HandChoice:
        """What a performer's hand plays, or will once it is seen."""
        session = self._session()
        route = session.sources.route(self.trackers.title("", name))
        chosen = self._chosen.get(name)
        characters = list(route.characters) if chosen is None else chosen.characters
        regions = route.parts if chosen is None else [part for part in LAYER_PARTS if part in chosen.regions]
        choices = [
            wire.CharacterChoice(character, label, character in characters or ALL in characters)
            for character, label in session.scene.labels.items()
        ]
        pads = [pad for pad, kept in session.scene.pads.items() if kept.dimensions >= POINT]
        return wire.HandChoice(choices, list(regions), self._heard.get(name, 0), pads)
