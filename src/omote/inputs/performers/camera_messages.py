"""Every message of the camera page's link (MessagePack); landmarks and bodies come beside them
(`camera/landmark_frame.py`, `camera/body_points.py`).

`tools/messages.py` writes them in TypeScript.
"""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from omote.inputs.trackers.tracker_frame import LONGEST_SUBJECT
from omote.perform.layers.layer_names import LayerPart
from omote.perform.scene.character_names import MOST_CHARACTERS
from omote.show.declaration import Message

CAMERA_VERSION = 3
CAMERA_PATH = "/camera/link"
LONGEST_MESSAGE = 8192
MOST_HAND_CHANNELS = 64
"""Of one frame of a hand."""
PerformerName = Annotated[str, msgspec.Meta(max_length=4 * LONGEST_SUBJECT)]
Calibrated = Literal["no", "rest", "guided"]
"""How a face is read: not yet, by a moment at rest, by the guided minute."""


class Perform(Message, frozen=True):
    """Says who performs before this camera: the first message of a link, and again for another performer."""

    version: int
    name: PerformerName


class PlayCharacters(Message, frozen=True):
    """Chooses the characters that this performer plays, by name; none: it plays nobody."""

    characters: Annotated[list[str], msgspec.Meta(max_length=MOST_CHARACTERS)]


class HandFrame(Message, frozen=True):
    """What the page has read of the performer's hand in one picture: weights by channel, and how it turns the head
    (yaw, pitch and roll, radians), by the calibration that the page keeps. `time`: seconds of the page's clock;
    `found`: false while no hand is seen. `pad`: the pad whose point the other hand moves on the characters that this
    one plays, "" for none; `point`: where it is, -1..1 right and up as in a mirror."""

    time: float
    found: bool
    weights: Annotated[dict[PerformerName, float], msgspec.Meta(max_length=MOST_HAND_CHANNELS)]
    head: tuple[float, float, float] | None = None
    pad: PerformerName = ""
    point: tuple[float, float] | None = None


class PlayHand(Message, frozen=True):
    """Chooses the characters that this performer's hand plays, and in which regions (none named: all)."""

    characters: Annotated[list[str], msgspec.Meta(max_length=MOST_CHARACTERS)]
    regions: Annotated[list[LayerPart], msgspec.Meta(max_length=6)]


class PlayBody(Message, frozen=True):
    """Chooses the characters whose figure this performer's body plays: arms, shoulders and trunk, as far as they are
    seen."""

    characters: Annotated[list[str], msgspec.Meta(max_length=MOST_CHARACTERS)]


class RestBody(Message, frozen=True):
    """Takes the next two seconds as how the performer's body is at rest."""


class BeginGuide(Message, frozen=True):
    """Begins the guided minute, or with `rest` only a moment of the face at rest."""

    rest: bool = False


class RedoStep(Message, frozen=True):
    """Makes a step of the guided minute again, now or when all are done."""

    step: str


class CancelGuide(Message, frozen=True):
    """Ends the guided minute; the calibration before it stays, and so do the faces that were made."""


class ContinueGuide(Message, frozen=True):
    """Goes on with a guided minute that was ended, at the next face that is missing."""


class UseFaces(Message, frozen=True):
    """Reads the performer by the faces that were made, though others are missing."""


class RenamePerformer(Message, frozen=True):
    """Gives this performer another name, calibration included."""

    name: PerformerName


class DeletePerformer(Message, frozen=True):
    """Forgets the calibration of this performer."""


class UndoPerformer(Message, frozen=True):
    """Takes the last change of the show's performers back."""


class CharacterChoice(msgspec.Struct, frozen=True):
    """A character of the show, and whether this performer plays it."""

    name: str
    label: str
    played: bool


class HandChoice(msgspec.Struct, frozen=True):
    """What the performer's hand plays: characters, and regions (none: all). heard: frames of it so far; pads: those of
    the show with two dimensions or more, which another hand may move."""

    characters: list[CharacterChoice]
    regions: list[LayerPart]
    heard: int
    pads: list[str]


class BodyChoice(msgspec.Struct, frozen=True):
    """What the performer's body plays. known: whether it is known how it is at rest; heard: frames of it so far;
    shares: how much of each region is tracked now, 0..1."""

    characters: list[CharacterChoice]
    known: bool
    heard: int
    shares: dict[str, float]


class GuideStep(msgspec.Struct, frozen=True):
    """The step of a guide that is being made. left: seconds of its phase, of `seconds`; done: steps that are made."""

    step: str
    advice: str
    phase: Literal["ready", "hold"]
    left: float
    seconds: float
    number: int
    of: int
    done: list[str]


class CameraStatus(Message, frozen=True):
    """All that the page shows of the show: complete, ten times a second. `performers`: those that the show knows;
    `redoable`, `missing`: steps of the guided minute that were made and were not, both empty before the first;
    `unrest`: what the face that was taken as at rest does, in a sentence, "" where it rests; `unused`: whether faces
    were made by which the performer is not read; `heard`: frames so far; `undo`: what an undo takes back, "" for
    nothing; `weights`: what the face is read as; `hand`, `body`: what the performer's hand and body
    play."""

    performer: str
    performers: list[str]
    calibrated: Calibrated
    unrest: str
    characters: list[CharacterChoice]
    guide: GuideStep | None
    redoable: list[str]
    missing: list[str]
    unused: bool
    fitting: bool
    heard: int
    found: bool
    undo: str
    weights: dict[str, float]
    hand: HandChoice
    body: BodyChoice


class CameraRefused(Message, frozen=True):
    """Why something was not done."""

    reason: str


class Displaced(Message, frozen=True):
    """Another page plays as this performer now; this one has ended."""


Guide = BeginGuide | RedoStep | CancelGuide | ContinueGuide | UseFaces
"""What is asked of the guided minute."""
BodyMessage = PlayBody | RestBody
"""What is asked of a body."""
FromCamera = (
    Perform
    | PlayCharacters
    | HandFrame
    | PlayHand
    | BodyMessage
    | Guide
    | RenamePerformer
    | DeletePerformer
    | UndoPerformer
)
ToCamera = CameraStatus | CameraRefused | Displaced
CAMERA_MESSAGES: tuple[type[Message], ...] = FromCamera.__args__
CAMERA_ANSWERS: tuple[type[Message], ...] = ToCamera.__args__
