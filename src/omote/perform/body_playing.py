"""The part of a performer that has a body: poses and bodies are called as expressions and faces are."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from omote.model.body.pose import STAND, Pose
from omote.model.body.pose_regions import check_pose_region
from omote.perform import axis
from omote.perform.axis import Axis, call_part, move_whole
from omote.perform.called_mix import start_call
from omote.perform.easing import DEFAULT_EASING
from omote.perform.figures.figure_axes import AT_REST, FACES_OWN
from omote.perform.figures.packed_pose import BESIDE_BONES
from omote.perform.figures.tracked_body import lose_body, track_body
from omote.perform.frame import Frame, with_fields
from omote.perform.layers.layer_names import LayerName
from omote.perform.layers.source_frame import BodyFrame, SourceFrame
from omote.perform.limits import check_call_seconds, check_within
from omote.perform.motion.chest_following import AT_HOME, follow_head
from omote.perform.skin_playing import SkinPlaying


class BodyPlaying(SkinPlaying):
    """Plays poses and bodies."""

    def call_pose(
        self, name: str, *, seconds: float = 1.0, easing: str = DEFAULT_EASING, region: str | None = None
    ) -> None:
        """Brings a pose on air from whatever the figure does, all of it or in one region.

        A region that has been called alone keeps its own until the whole figure is called again.

        Parameters
        ----------
        name : str
            One of the cast's poses; "stand" is the one at rest.
        seconds : float
            How long it takes, 0 to 3600; 0 cuts, `math.inf` waits for `fade_pose`.
        easing : {"smooth", "gentle", "sharp", "early", "late"}
            The curve of the way.
        region : {"head", "trunk", "arm_left", "arm_right", "stance"}, optional
            Where alone it is called, in its own time: no T-bar moves it, so `math.inf` is none for it.

        Raises
        ------
        ValueError
            On a name, an easing or a region that there is not, and on seconds out of range.
        TypeError
            On seconds that are no number.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.call_pose("bow", seconds=2)
        >>> sorted(performer.advance(1.0).figure.poses)
        ['bow', 'stand']

        References
        ----------
        docs/method.md, "Poses".
        """

        def call(on: Axis) -> Axis:
            return start_call(on, self._cast.poses, name, "pose", seconds, easing)

        where = None if region is None else check_pose_region(region)
        if where is not None:
            check_call_seconds(seconds)  # no T-bar moves a region
        figure = self._now.figure or AT_REST
        pose, regions = call_part(figure.pose, figure.regions, where, call)
        self._play(figure=replace(figure, pose=pose, regions=regions))

    def fade_pose(self, x: float) -> None:
        """Moves the T-bar of the poses; it takes over the call once it has passed its progress (pick-up).

        Parameters
        ----------
        x : float
            Where it stands, 0 to 1.

        Raises
        ------
        ValueError
            Where it cannot stand.
        TypeError
            On what is no number.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.call_pose("bow", seconds=math.inf)
        >>> performer.fade_pose(0.5)
        >>> round(performer.advance(1.0).figure.poses["bow"], 3)
        0.5
        """
        hand = check_within(x, 0.0, 1.0, "the pose T-bar")
        self._move_pose(lambda on: axis.faded(on, hand))

    def release_pose(self) -> None:
        """Lets go of the T-bar of the poses: a timed call goes on from where it is, a call by hand stays.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.call_pose("bow", seconds=1.0)
        >>> performer.release_pose()
        >>> performer.advance(1.0).figure.poses["bow"]
        1.0
        """
        self._move_pose(axis.released)

    def call_body(self, name: str, *, seconds: float = 1.0, easing: str = DEFAULT_EASING) -> None:
        """Brings a body on air apart from the face, or gives each face its own again.

        Parameters
        ----------
        name : str
            One of the cast's bodies; "own" for those of the faces on air, which it follows from then on.
        seconds : float
            How long it takes, 0 to 3600; 0 cuts.
        easing : {"smooth", "gentle", "sharp", "early", "late"}
            The curve of the way.

        Raises
        ------
        ValueError
            On a name or an easing that there is not, and on seconds out of range.
        TypeError
            On seconds that are no number.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.call_body("heavy", seconds=0)
        >>> dict(performer.advance(0.0).figure.bodies)
        {'heavy': 1.0}
        """
        figure = self._now.figure or AT_REST
        check_call_seconds(seconds)  # no T-bar moves it
        names = {FACES_OWN: None, **self._cast.bodies}
        self._play(figure=replace(figure, body=start_call(figure.body, names, name, "body", seconds, easing)))

    def _drive_body(self, layer: LayerName, frame: SourceFrame, body: BodyFrame) -> None:
        """Takes the body of a source's frame; ValueError where it has other bones than the cast's figures."""
        stand = self._cast.poses.get(STAND)
        if not isinstance(stand, Pose):
            return  # a cast of heads alone
        expected = stand.turns.size + BESIDE_BONES
        if body.numbers.shape != (expected,):
            raise ValueError(
                f"a body of {len(body.numbers)} numbers came for {len(stand.turns)} bones; send {expected}"
            )
        figure = self._now.figure or AT_REST
        tracked = track_body(figure.tracked, layer, frame.source, body, found=frame.found)
        self._now = with_fields(self._now, figure=with_fields(figure, tracked=tracked))

    def _leave_body(self, layer: LayerName, source: str) -> None:
        """Fades out the body of a source that has gone."""
        figure = self._now.figure
        if figure is not None and figure.tracked is not None:
            lost = with_fields(figure, tracked=lose_body(figure.tracked, layer, source))
            self._now = with_fields(self._now, figure=lost)

    def _with_chest(self, frame: Frame, dt: float) -> Frame:
        """A frame with the chest, which follows the head that shows by `dt` seconds. frame: all else that shows now."""
        now = self._now
        if dt > 0.0 and (frame.head.yaw or now.chest != AT_HOME):
            self._now = with_fields(now, chest=follow_head(now.chest, frame.head.yaw, dt))
        breath, left, _ = frame.idle
        turned = self._now.chest[1]
        return with_fields(frame, idle=(breath, left, turned)) if turned else frame

    def _move_pose(self, move: Callable[[Axis], Axis]) -> None:
        figure = self._now.figure or AT_REST
        pose, regions = move_whole(figure.pose, figure.regions, move)
        self._play(figure=replace(figure, pose=pose, regions=regions))
