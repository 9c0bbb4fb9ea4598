"""The performer: takes commands at any moment and returns frames at any later time. It owns no clock."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

from omote.model.known_names import GENERIC, NEUTRAL
from omote.perform import axis
from omote.perform.axis import Axis
from omote.perform.channels import with_channel
from omote.perform.easing import DEFAULT_EASING, find_easing
from omote.perform.frame import Frame, Gaze, Head, Home
from omote.perform.lights import check_light
from omote.perform.limits import FOREVER, LONGEST_CALL, SHORTEST_CALL, check_known, check_within
from omote.perform.panic import (
    PANIC_EASING,
    PANIC_SECONDS,
    Settling,
    settled_later,
    with_settling_channels,
    with_settling_gaze,
    with_settling_head,
    without_channel,
)
from omote.perform.snapshot import Playable, Snapshot, check_snapshot, is_home_next, refuse_no_cast


class Performer:
    """Plays a cast: calls, T-bars, channels, head, gaze and light in; a frame for each step of time out.

    It owns no clock and no thread; the same commands and steps give the same frames.

    Parameters
    ----------
    cast : Cast
        The faces and expressions that can be called; a face "generic" is among them.

    Raises
    ------
    ValueError
        Where the cast has no face "generic".

    Examples
    --------
    >>> performer = omote.Performer(cast)
    >>> performer.call_expression("smile", seconds=0.5)
    >>> frame = performer.advance(0.25)
    >>> round(frame.expressions["smile"], 3), frame.expression_call.remaining
    (0.5, 0.25)

    References
    ----------
    docs/method.md, "The mix"; inertialised calls after D. Bollo (2018).
    """

    def __init__(self, cast: Playable) -> None:
        refuse_no_cast(cast)
        check_known(GENERIC, cast.faces, "face")
        self._cast = cast
        self._now = Snapshot(Axis(GENERIC), Axis(NEUTRAL))

    @classmethod
    def restored(cls, cast: Playable, snapshot: Snapshot) -> Performer:
        """The performer that continues from a snapshot, frame by frame the same.

        Parameters
        ----------
        cast : Cast
            What it plays.
        snapshot : Snapshot
            What another one's `snapshot` gave.

        Returns
        -------
        Performer
            Independent of the first.

        Raises
        ------
        ValueError
            Where this cast cannot play the snapshot, or no performer can have written it.

        Examples
        --------
        >>> first = omote.Performer(cast)
        >>> first.call_face("dog", seconds=2)
        >>> second = omote.Performer.restored(cast, first.snapshot())
        >>> first.advance(0.7) == second.advance(0.7)
        True
        """
        performer = cls(cast)
        performer._now = check_snapshot(snapshot, cast)
        return performer

    def snapshot(self) -> Snapshot:
        """Everything needed to continue later, or elsewhere.

        Returns
        -------
        Snapshot
            Plain values, frozen.

        Examples
        --------
        >>> omote.Performer(cast).snapshot().face.on_air
        'generic'
        """
        return self._now

    def recast(self, cast: Playable) -> None:
        """Plays another cast from now on; what is on air stays.

        Parameters
        ----------
        cast : Cast
            One that has everything that is on air.

        Raises
        ------
        ValueError
            Where it has not.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.recast(cast.with_expressions(beam=cast.expressions["joy"]))
        >>> performer.call_expression("beam")
        """
        self._now = check_snapshot(self._now, cast)
        self._cast = cast

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
        self._play(face=_start_call(self._now.face, self._cast.faces, name, "face", seconds, easing))

    def call_expression(self, name: str, *, seconds: float = 1.0, easing: str = DEFAULT_EASING) -> None:
        """Brings an expression on air from whatever is showing.

        Parameters
        ----------
        name : str
            One of the cast's expressions.
        seconds : float
            How long it takes, 0 to 3600; 0 cuts, `math.inf` waits for `fade_expression`.
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
        >>> performer.call_expression("smile", seconds=0)
        >>> dict(performer.advance(0.0).expressions)
        {'smile': 1.0}
        """
        called = _start_call(self._now.expression, self._cast.expressions, name, "expression", seconds, easing)
        self._play(expression=called)

    def call_light(self, name: str, *, seconds: float = 1.0, easing: str = DEFAULT_EASING) -> None:
        """Brings a light on air from whatever light shows.

        Parameters
        ----------
        name : {"theatre", "portrait", "flat"}
            The light.
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
        self._play(light=axis.called(self._now.light, name, _length(seconds), easing))

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
        self._play(expression=axis.faded(self._now.expression, hand))

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
        self._play(expression=axis.released(self._now.expression))

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
        channels = with_channel(self._now.channels, self._cast.expressions, name, value)
        self._play(channels=channels, settling=without_channel(self._now.settling, name))

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
        head, settling = Head(yaw, pitch, roll), self._now.settling
        self._play(head=head, settling=None if settling is None else replace(settling, head=Head()))

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
        gaze, settling = Gaze(yaw, pitch), self._now.settling
        self._play(gaze=gaze, settling=None if settling is None else replace(settling, gaze=Gaze()))

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

    def panic(self) -> None:
        """The face on air goes neutral and holds still: in a quarter of a second nothing moves, and nothing goes on.

        Expression, channels, head and gaze ease to rest, a call of a face stops where it is, both T-bars stand at 0;
        the light is left alone. Panic again brings the home face (`set_home`), where nothing has been played in
        between; within 0.7 s it is the same press.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.call_face("dog", seconds=0)
        >>> performer.set_channel("jawOpen", 1.0)
        >>> performer.panic()
        >>> frame = performer.advance(1.0)
        >>> dict(frame.faces), dict(frame.channels)
        ({'dog': 1.0}, {})
        >>> performer.panic()
        >>> dict(performer.advance(2.0).faces)
        {'generic': 1.0}
        """
        now = self._now
        if now.panicked is None:
            now = _at_rest(now)
        elif is_home_next(now):
            now = replace(now, face=axis.called(now.face, now.home.face, _length(now.home.seconds), DEFAULT_EASING))
        self._now = replace(now, panicked=now.time, panics=now.panics + 1)

    def advance(self, dt: float) -> Frame:
        """What is on air some time later; one long step lands where many short ones do.

        Parameters
        ----------
        dt : float
            Seconds since the last step, 0 or more.

        Returns
        -------
        Frame
            The mixes of faces, expressions and lights (each sums to one), channels, head and gaze.

        Raises
        ------
        ValueError
            On a step that is negative or endless.
        TypeError
            On what is no number.

        Examples
        --------
        >>> omote.Performer(cast).advance(1 / 60).expressions
        {'neutral': 1.0}
        """
        dt = check_within(dt, 0.0, FOREVER, "the time step (seconds)")
        now = self._now
        self._now = replace(
            now,
            face=axis.advanced(now.face, dt),
            expression=axis.advanced(now.expression, dt),
            light=axis.advanced(now.light, dt),
            settling=settled_later(now.settling, dt),
            time=now.time + dt,
        )
        return _frame(self._now)

    def _play(self, **changes: object) -> None:
        """What an operator does: the next panic is a first one again."""
        self._now = replace(self._now, panicked=None, **changes)  # type: ignore[arg-type]


def _start_call(on: Axis, names: Mapping[str, object], name: str, what: str, seconds: float, easing: str) -> Axis:
    check_known(name, names, what)
    find_easing(easing)
    if isinstance(seconds, float) and seconds == math.inf:
        return axis.called(on, name, None, easing)
    return axis.called(on, name, _length(seconds), easing)


def _length(seconds: float) -> float:
    seconds = check_within(seconds, 0.0, LONGEST_CALL, "the time of a call (seconds)")
    return seconds if seconds >= SHORTEST_CALL else 0.0


def _at_rest(now: Snapshot) -> Snapshot:
    settling = Settling(
        with_settling_channels(now.channels, now.settling),
        with_settling_head(now.head, now.settling),
        with_settling_gaze(now.gaze, now.settling),
    )
    return replace(
        now,
        face=axis.halted(now.face, PANIC_SECONDS),
        expression=axis.called(replace(now.expression, hand=0.0), NEUTRAL, PANIC_SECONDS, PANIC_EASING),
        channels={},
        head=Head(),
        gaze=Gaze(),
        settling=settling,
    )


def _frame(now: Snapshot) -> Frame:
    return Frame(
        faces=axis.weights(now.face),
        expressions=axis.weights(now.expression),
        channels=with_settling_channels(now.channels, now.settling),
        head=with_settling_head(now.head, now.settling),
        gaze=with_settling_gaze(now.gaze, now.settling),
        time=now.time,
        face_call=axis.status(now.face),
        expression_call=axis.status(now.expression),
        face_fader=now.face.hand,
        expression_fader=now.expression.hand,
        light=axis.weights(now.light),
        light_call=axis.status(now.light),
        home=now.home,
        home_next=is_home_next(now),
        panics=now.panics,
    )
