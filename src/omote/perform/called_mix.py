"""What hands play of a performer's mix: calls of faces, expressions and lights, T-bars, channels, head, gaze, home."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

from omote.model.known_names import NEUTRAL, check_play_region
from omote.perform import axis
from omote.perform.axis import Axis, call_part, move_whole
from omote.perform.channels import with_channels
from omote.perform.easing import DEFAULT_EASING, find_easing
from omote.perform.frame import Gaze, Head, Home, with_fields
from omote.perform.lights import check_light
from omote.perform.limits import check_call_seconds, check_known, check_within
from omote.perform.panic import without_channels, without_turn
from omote.perform.snapshot import Playable, Snapshot


class CalledMix:
    """The part of a performer that hands play: calls, T-bars, channels, head, gaze, and the home face of a panic."""

    _cast: Playable
    _now: Snapshot

    def call_face(self, name: str, *, seconds: float = 1.0, easing: str = DEFAULT_EASING) -> None:
        """Brings a face on air from whatever is showing.

        Parameters
        ----------
        name : str
            One of the cast's faces.
        seconds : float
            How long it takes, 0 to 3600; 0 cuts, `math.inf` waits for `fade_face`.
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
        >>> performer.call_face("old", seconds=0)
        >>> dict(performer.advance(0.0).faces)
        {'old': 1.0}
        """
        self._play(face=start_call(self._now.face, self._cast.faces, name, "face", seconds, easing))

    def call_expression(
        self,
        name: str,
        *,
        seconds: float = 1.0,
        easing: str = DEFAULT_EASING,
        region: str | None = None,
        strength: float = 1.0,
    ) -> None:
        """Brings an expression on air from whatever is showing, on the whole face or in one region of it.

        A region that has been called alone keeps its own until the whole face is called again.

        Parameters
        ----------
        name : str
            One of the cast's expressions.
        seconds : float
            How long it takes, 0 to 3600; 0 cuts, `math.inf` waits for `fade_expression`.
        easing : {"smooth", "gentle", "sharp", "early", "late"}
            The curve of the way.
        region : {"brows", "eyes", "mouth", "rest"}, optional
            Where alone it is called, in its own time: no T-bar moves it, so `math.inf` is none for it.
        strength : float
            How much of it, 0 (neutral) to 1; no T-bar moves a call of less than all.

        Raises
        ------
        ValueError
            On a name, an easing or a region that there is not, and on seconds or a strength out of range.
        TypeError
            On seconds and a strength that are no number.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.call_expression("joy", seconds=0, strength=0.75)
        >>> dict(performer.advance(0.0).expressions)
        {'neutral': 0.25, 'joy': 0.75}
        >>> performer.call_expression("smile", seconds=0)
        >>> dict(performer.advance(0.0).expressions)
        {'smile': 1.0}
        >>> performer.call_expression("surprise", seconds=0.2, region="brows")
        >>> dict(performer.advance(0.2).regions["brows"])
        {'surprise': 1.0}

        References
        ----------
        docs/method.md, "Regions of a call".
        """

        def call(on: Axis) -> Axis:
            return start_call(on, self._cast.expressions, name, "expression", seconds, easing, goal)

        goal = _part_of(name, strength)
        now = self._now
        if goal is not None:
            check_call_seconds(seconds)  # no T-bar moves it
        where = None if region is None else check_play_region(region)
        if where is not None:
            check_call_seconds(seconds)  # no T-bar moves a region
        expression, regions = call_part(now.expression, now.regions, where, call)
        self._play(expression=expression, regions=regions)

    def call_light(self, name: str, *, seconds: float = 1.0, easing: str = DEFAULT_EASING) -> None:
        """Brings a light on air from whatever light shows.

        Parameters
        ----------
        name : str
            The light, one of `omote.perform.lights.LIGHTS`.
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
        >>> performer.call_light("flat", seconds=2)
        >>> sorted(performer.advance(1.0).light)
        ['flat', 'theatre']
        """
        check_light(name)
        find_easing(easing)
        self._play(light=axis.called(self._now.light, name, check_call_seconds(seconds), easing))

    def fade_face(self, x: float) -> None:
        """Moves the T-bar of the faces; it takes over the call once it has passed its progress (pick-up).

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
        >>> performer.call_face("old", seconds=math.inf)
        >>> performer.fade_face(0.5)
        >>> round(performer.advance(1.0).faces["old"], 3)
        0.5
        """
        self._play(face=axis.faded(self._now.face, check_within(x, 0.0, 1.0, "the face T-bar")))

    def fade_expression(self, x: float) -> None:
        """Moves the T-bar of the expressions; it takes over the call once it has passed its progress (pick-up).

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
        >>> performer.call_expression("smile", seconds=math.inf)
        >>> performer.fade_expression(0.5)
        >>> round(performer.advance(1.0).expressions["smile"], 3)
        0.5
        """
        hand = check_within(x, 0.0, 1.0, "the expression T-bar")
        now = self._now
        expression, regions = move_whole(now.expression, now.regions, lambda on: axis.faded(on, hand))
        self._play(expression=expression, regions=regions)

    def release_face(self) -> None:
        """Lets go of the T-bar of the faces: a timed call goes on from where it is, a call by hand stays.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.call_face("old", seconds=1.0)
        >>> performer.release_face()
        >>> performer.advance(1.0).faces["old"]
        1.0
        """
        self._play(face=axis.released(self._now.face))

    def release_expression(self) -> None:
        """Lets go of the T-bar of the expressions: a timed call goes on from where it is, a call by hand stays.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.call_expression("smile", seconds=1.0)
        >>> performer.release_expression()
        >>> performer.advance(1.0).expressions["smile"]
        1.0
        """
        now = self._now
        expression, regions = move_whole(now.expression, now.regions, axis.released)
        self._play(expression=expression, regions=regions)

    def set_channel(self, name: str, value: float) -> None:
        """Adds an expression to the mix at once, beside the calls.

        Parameters
        ----------
        name : str
            Any expression but "neutral"; the 52 ARKit units are what trackers send.
        value : float
            Its weight, -0.5 to 1.5; 0 takes it out.

        Raises
        ------
        ValueError
            On a name that there is not and on a weight out of range.
        TypeError
            On what is no number.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.set_channel("jawOpen", 0.4)
        >>> dict(performer.advance(0.0).channels)
        {'jawOpen': 0.4}
        """
        self.set_channels({name: value})

    def set_channels(self, values: Mapping[str, float]) -> None:
        """Adds expressions to the mix at once, as `set_channel` one after the other; none where one is rejected.

        Parameters
        ----------
        values : mapping of float
            Weights by expression, -0.5 to 1.5; 0 takes one out.

        Raises
        ------
        ValueError
            On a name that there is not and on a weight out of range.
        TypeError
            On what is no number.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.set_channels({"jawOpen": 0.4})
        >>> dict(performer.advance(0.0).channels)
        {'jawOpen': 0.4}
        """
        channels = with_channels(self._now.channels, self._cast.expressions, values)
        self._play(channels=channels, easing_to_rest=without_channels(self._now.easing_to_rest, values))

    def set_head(self, yaw: float, pitch: float, roll: float) -> None:
        """Turns the head.

        Parameters
        ----------
        yaw, pitch, roll : float
            Radians, -pi/2 to pi/2; + is the character's left, up, tilt to its left.

        Raises
        ------
        ValueError
            On angles out of range.
        TypeError
            On what is no number.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.set_head(yaw=0.2, pitch=0.0, roll=0.0)
        >>> performer.advance(0.0).head.yaw
        0.2
        """
        head = Head(yaw, pitch, roll)
        self._play(head=head, easing_to_rest=without_turn(self._now.easing_to_rest, "head"))

    def set_gaze(self, yaw: float, pitch: float) -> None:
        """Turns the eyes relative to the head.

        Parameters
        ----------
        yaw, pitch : float
            Radians; + is the character's left, up. Eyes turn 0.698 (40 degrees) sideways and 0.524 (30) up or down:
            beyond, the iris would go out of sight.

        Raises
        ------
        ValueError
            On angles out of range.
        TypeError
            On what is no number.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.set_gaze(yaw=0.3, pitch=-0.1)
        >>> performer.advance(0.0).gaze.pitch
        -0.1
        """
        gaze = Gaze(yaw, pitch)
        self._play(gaze=gaze, easing_to_rest=without_turn(self._now.easing_to_rest, "gaze"))

    def set_home(self, face: str, *, seconds: float = 2.0) -> None:
        """Chooses the face that a second panic brings on air.

        Parameters
        ----------
        face : str
            One of the cast's faces; "generic" until one is chosen.
        seconds : float
            How long it takes, 0 to 3600; 0 cuts.

        Raises
        ------
        ValueError
            On a name that there is not and on seconds out of range.
        TypeError
            On seconds that are no number.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.set_home("old", seconds=3)
        >>> performer.advance(0.0).home.face
        'old'
        """
        self._now = replace(self._now, home=Home(check_known(face, self._cast.faces, "face"), seconds))

    def _play(self, **changes: object) -> None:
        """What an operator does: the next panic is a first one again."""
        if changes or self._now.panicked is not None:
            self._now = with_fields(self._now, panicked=None, **changes)


def _part_of(expression: str, strength: float) -> dict[str, float] | None:
    """The mix of an expression that is called in part; None for all of it."""
    share = check_within(strength, 0.0, 1.0, "the strength of an expression")
    if share == 1.0 or expression == NEUTRAL:
        return None
    return {NEUTRAL: 1.0 - share, expression: share} if share else {NEUTRAL: 1.0}


def start_call(
    on: Axis,
    names: Mapping[str, object],
    name: str,
    what: str,
    seconds: float,
    easing: str,
    goal: Mapping[str, float] | None = None,
) -> Axis:
    """An axis with a call, checked. on: as it is; names: what can be called; name: what is; what: what messages call
    it; seconds, easing: of the call, `math.inf` for one by hand; goal: as of `axis.called`."""
    check_known(name, names, what)
    find_easing(easing)
    if isinstance(seconds, float) and seconds == math.inf:
        return axis.called(on, name, None, easing)
    return axis.called(on, name, check_call_seconds(seconds), easing, goal)
