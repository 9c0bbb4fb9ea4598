"""Named points of the house that eyes may look at, such as a seat."""

from __future__ import annotations

from typing import Annotated

import msgspec

from omote.perform.frame import POINT_LIMITS
from omote.perform.scene.scene import Scene
from omote.show.declaration import CallId, SceneCommand
from omote.show.osc import Value, osc

PointName = Annotated[str, msgspec.Meta(min_length=1, max_length=40), Value("text")]
_X = Value(low=POINT_LIMITS["x"][0], high=POINT_LIMITS["x"][1], unit="m")
_Y = Value(low=POINT_LIMITS["y"][0], high=POINT_LIMITS["y"][1], unit="m")
_Z = Value(low=POINT_LIMITS["z"][0], high=POINT_LIMITS["z"][1], unit="m")


class SetGazePoint(SceneCommand, frozen=True):
    """Names a point of the house that eyes may look at, such as a seat, or moves it: metres as of `look_at`. It is kept
    with the show. An `id` executes once, as of the one below."""

    follows_bus = False
    osc = (
        osc(
            "gaze_point",
            "names a point of the house that eyes may look at, or moves it",
            "name",
            "x",
            "y",
            "z",
            of_show=True,
        ),
    )

    id: CallId
    name: PointName
    x: Annotated[float, _X]
    y: Annotated[float, _Y]
    z: Annotated[float, _Z]

    def change(self, scene: Scene) -> None:
        """Changes the scene."""
        scene.set_gaze_point(self.name, x=self.x, y=self.y, z=self.z)


class DeleteGazePoint(SceneCommand, frozen=True):
    """Forgets a gaze point; who looked at it looks ahead."""

    follows_bus = False
    osc = (osc("delete_gaze_point", "forgets a named point of the house", "name", of_show=True),)

    id: CallId
    name: PointName

    def change(self, scene: Scene) -> None:
        """Changes the scene."""
        scene.delete_gaze_point(self.name)
