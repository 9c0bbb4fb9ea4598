"""Motion that a character makes by itself, what its eyes look at, gestures, what swings as its head moves, its skin."""

from __future__ import annotations

from typing import Annotated

import msgspec

from omote.perform.complexion import SKIN_FADERS, SKIN_LIMIT, SkinFader, check_skin_fader
from omote.perform.frame import DETAIL_LIMIT, DIRECTION_LIMITS, POINT_LIMITS, TargetKind
from omote.perform.gestures import AMPLITUDE_LIMIT, GestureName
from omote.perform.performer import Performer
from omote.perform.scene.character_names import ALL
from omote.perform.scene.scene import Scene
from omote.perform.springs.cast_springs import SPRING_NAMES, SpringName, check_spring
from omote.perform.springs.springs import AMOUNT_LIMIT
from omote.show.declaration import CallId, CharacterCommand, CharacterName, RequestId, SceneCommand, characters_of
from omote.show.objects.state import CharacterState
from omote.show.osc import PRESS, Osc, Value, angle, osc

OTHER = Value("character", name="name")
_DETAIL = "sets the {} of its own motion, beside all else of it; 1 at first"


def _amount(state: CharacterState, spring: str) -> tuple[float]:
    """How much of a spring is set."""
    return (state.springs.get(check_spring(spring), 1.0),)


def _of_skin(state: CharacterState, fader: str) -> tuple[float]:
    """Where a fader of the skin stands."""
    return (state.skin.get(check_skin_fader(fader), 1.0),)


class SetMotion(CharacterCommand, frozen=True):
    """How much a character moves by itself: `liveliness` 0 (nothing) to 1, 0.5 as people move; `blinks`, `gaze` and
    `breath` each beside the others, 0..2; `seed`: which of all ways to move; `idle`: whether it moves as people do
    while its tracker is lost, where the liveliness is 0 too. `None` leaves a setting as it is."""

    hand = "moves"
    osc = (
        osc("motion", "sets how much it moves by itself: lids, eyes, head, breath; 0.5 as people move", "liveliness"),
        osc("motion/blinks", _DETAIL.format("blinks"), "blinks"),
        osc("motion/gaze", _DETAIL.format("gaze"), "gaze"),
        osc("motion/breath", _DETAIL.format("breath"), "breath"),
        osc(
            "motion/idle",
            "whether it moves as people do (1 or true) while its tracker is lost, where it holds still otherwise",
            "idle",
        ),
    )

    liveliness: Annotated[float | None, Value()] = None
    blinks: Annotated[float | None, Value(high=DETAIL_LIMIT)] = None
    gaze: Annotated[float | None, Value(high=DETAIL_LIMIT)] = None
    breath: Annotated[float | None, Value(high=DETAIL_LIMIT)] = None
    seed: int | None = None
    id: RequestId = ""
    idle: Annotated[bool | None, Value("switch", name="on")] = None

    def play(self, performer: Performer) -> None:
        """Plays it."""
        performer.set_motion(
            self.liveliness, blinks=self.blinks, gaze=self.gaze, breath=self.breath, seed=self.seed, idle=self.idle
        )


class LookAt(SceneCommand, frozen=True):
    """Whom or what the eyes of a character look at by its automatic motion: `ahead`, nothing; `direction`, `yaw` and
    `pitch` of the house in radians, + to the picture's right and up; `point`, `x` metres to the picture's right, `y`
    above the eyes, `z` before the front line; by `name`: a `gaze_point`, a `character`, the camera of a `stage` ("" for
    any). Rejected where there is none of that name."""

    method = None
    osc = (
        osc("look_ahead", "its eyes look at nothing", PRESS, kind="ahead"),
        osc(
            "look_at/direction",
            "its eyes look in a direction of the house: to the picture's right, up",
            "yaw",
            "pitch",
            kind="direction",
        ),
        osc(
            "look_at/point",
            "its eyes look at a point: to the picture's right, above the eyes, before the front line",
            "x",
            "y",
            "z",
            kind="point",
        ),
        osc("look_at/gaze_point", "its eyes look at a named point of the house", "name", kind="gaze_point"),
        osc("look_at/character", "its eyes look at another character", OTHER, kind="character"),
        osc(
            "look_at/stage", "its eyes look at the camera of a stage, by the name in its address", "name", kind="stage"
        ),
    )

    character: CharacterName
    kind: TargetKind
    name: Annotated[str, msgspec.Meta(max_length=80), Value("text")] = ""
    yaw: Annotated[float, angle(DIRECTION_LIMITS["yaw"])] = 0.0
    pitch: Annotated[float, angle(DIRECTION_LIMITS["pitch"])] = 0.0
    x: Annotated[float, Value(low=POINT_LIMITS["x"][0], high=POINT_LIMITS["x"][1], unit="m")] = 0.0
    y: Annotated[float, Value(low=POINT_LIMITS["y"][0], high=POINT_LIMITS["y"][1], unit="m")] = 0.0
    z: Annotated[float, Value(low=POINT_LIMITS["z"][0], high=POINT_LIMITS["z"][1], unit="m")] = 2.0
    id: RequestId = ""

    def change(self, scene: Scene) -> None:
        """Turns the eyes of all that it is for, but of the one that is looked at."""
        for name in characters_of(scene, self.character):
            if (self.character, self.kind, self.name) != (ALL, "character", name):
                at = {"yaw": self.yaw, "pitch": self.pitch, "x": self.x, "y": self.y, "z": self.z}
                scene[name].look_at(self.kind, self.name, **at)


class MakeGesture(CharacterCommand, frozen=True):
    """A short motion on top of all that plays: nod, shake, tilt, bow, shrug, brows or wink. `amplitude`: -2..2, 1 as it
    is, below 0 to the other side; `seconds`: 0.2..10, `None` as long as it takes. An `id` executes once."""

    method = "gesture"
    osc = (
        osc(
            "gesture",
            "makes the gesture of this name on top of all that plays; an amplitude below 0 is to the other side",
            "name",
            "amplitude",
        ),
        osc("gesture/{name}", "the same for a button, when it is pressed", PRESS, "amplitude"),
    )

    id: CallId
    name: Annotated[GestureName, Value("gesture")]
    amplitude: Annotated[float, Value(low=-AMPLITUDE_LIMIT, high=AMPLITUDE_LIMIT, default=1.0)] = 1.0
    seconds: float | None = None

    def play(self, performer: Performer) -> None:
        """Plays it."""
        performer.gesture(self.name, amplitude=self.amplitude, seconds=self.seconds)


class SetSpring(CharacterCommand, frozen=True):
    """How much of a spring of a character shows, 0..2, 1 at first: of the ears of animals that sway and flap, of jowls
    that sway, of cheeks that bounce as the head moves. It is multiplied by twice the liveliness of `set_motion`."""

    hand = "moves"
    osc = (
        Osc(
            "spring/{name}",
            "sets how much of a spring shows: ears, jowls or cheeks that swing as the head moves; 1 at first",
            ("amount",),
            on_air=_amount,
            reported=lambda _: ((name,) for name in SPRING_NAMES),
        ),
    )

    name: Annotated[SpringName, Value("spring")]
    amount: Annotated[float, Value(high=AMOUNT_LIMIT)]
    id: RequestId = ""

    def play(self, performer: Performer) -> None:
        """Plays it."""
        performer.set_spring(self.name, self.amount)

    def control(self, character: str) -> str:
        """The fader of a spring."""
        return f"{super().control(character)}:{self.name}"


class SetSkin(CharacterCommand, frozen=True):
    """How much of the folds that skin under pressure makes (`folds`), or of the flush and the pallor of expressions
    (`blood`), a character shows: 0..1.5, 1 at first."""

    hand = "moves"
    osc = (
        Osc(
            "skin/{name}",
            "sets how much of the skin's folds, or of its flush and pallor, shows; 1 at first",
            ("amount",),
            on_air=_of_skin,
            reported=lambda _: ((name,) for name in SKIN_FADERS),
        ),
    )

    name: Annotated[SkinFader, Value("skin")]
    amount: Annotated[float, Value(high=SKIN_LIMIT)]
    id: RequestId = ""

    def play(self, performer: Performer) -> None:
        """Plays it."""
        performer.set_skin(self.name, self.amount)

    def control(self, character: str) -> str:
        """The fader of the skin."""
        return f"{super().control(character)}:{self.name}"
