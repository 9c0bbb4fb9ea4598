"""Stages: what they draw, and what they are told."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Literal

import msgspec

from omote.show.declaration import ClientMessage, Outgoing, ServerMessage, Session

StageName = Annotated[str, msgspec.Meta(max_length=24)]
Level = Literal["lowest", "low", "medium", "good", "high"]
"""How much of a figure a picture shows."""
SoundState = Literal["", "blocked", "ready"]
AwakeState = Literal["", "kept", "insecure", "refused"]


class Drawing(ClientMessage, frozen=True):
    """A stage's heartbeat, once a second: the rate of frames that it really drew, and its level of quality. `name`: as
    its address has it; `camera`: where that is, metres as of `look_at`. `sound`: whether it can play sounds: "" never,
    `blocked` until somebody clicks it, `ready`; `sound_here`: its address asks that it plays them. `dark`: seconds for
    which it has had no graphics context, and so draws nothing. `awake`: whether its browser keeps the screen on:
    `kept`, `refused`, `insecure` where the address is neither https nor of its own machine; "" before it has said.
    Nobody looks at the camera of a stage of the preview."""

    access = "view"
    open_to = "everybody"

    fps: float
    level: Level
    name: StageName = ""
    camera: tuple[float, float, float] | None = None
    sound: SoundState = ""
    sound_here: bool = False
    dark: float = 0.0
    awake: AwakeState = ""

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Notes what the stage draws, and where its camera is. session: the show; who: the client; now: seconds,
        monotonic."""
        session.members.report(who, self, now)
        if session.members.looks_at(who) == "air":
            session.scene.note_camera(self.name, self.camera)
        return ()


class StageReport(msgspec.Struct, frozen=True):
    """The last report of a stage: frames per second, the level of quality, and its name, where its address has one; of
    sounds, darkness and the screen that stays on as in `drawing`."""

    fps: float
    level: Level
    name: StageName = ""
    sound: SoundState = ""
    sound_here: bool = False
    dark: float = 0.0
    awake: AwakeState = ""


class Crew(ServerMessage, frozen=True):
    """Who is connected, once a second, with each stage's last report (`None`: it is silent).

    `lost`: stages whose link broke while their page was open, and that have not come back.
    """

    stages: list[StageReport | None]
    consoles: int
    lost: int = 0


class PlaysSound(ServerMessage, frozen=True):
    """To a stage: whether it is the one that plays sounds, when that changes. One does at a time."""

    on: bool


class CastChanged(ServerMessage, frozen=True, tag="cast"):
    """The cast has changed: pages fetch the manifest again and go on."""

    revision: int
    digest: str
