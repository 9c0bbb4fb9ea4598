"""The player of a cue list: it holds the state, and calls on a scene what that calls."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import replace

from omote.perform.cues import cue_state as of_list
from omote.perform.cues.cue import Cue, CueList, check_cues
from omote.perform.cues.cue_action import CueAction
from omote.perform.cues.cue_names import named_cues
from omote.perform.cues.cue_state import CueState, place_of
from omote.perform.limits import FOREVER, check_known, check_within
from omote.perform.scene.goals import WITH_FACE, Goal, Part
from omote.perform.scene.scene import Scene
from omote.perform.scene.scene_frame import SceneFrame

MOST_DONE = 256
"""Actions that wait to be taken."""


class CuePlayer:
    """Plays a list of cues on a scene, from whatever shows; hands, trackers and programs play on beside it.

    It owns no clock and no thread; the same acts and steps give the same frames.

    Parameters
    ----------
    scene : Scene
        The scene.
    cues : sequence of Cue
        In the order in which GO plays them; characters by name or by label.

    Raises
    ------
    ValueError
        Where two cues have one number.

    Examples
    --------
    >>> scene = omote.Scene.begun(cast)
    >>> cues = [
    ...     omote.Cue("a", "1", {"one/face": omote.Move({"dog": 1.0}, 2.0)}, goes_on="follow"),
    ...     omote.Cue("b", "2", {"*/black": omote.Move({"black": 1.0}, 1.0)}),
    ... ]
    >>> player = omote.CuePlayer(scene, cues)
    >>> player.go()
    >>> player.advance(2.5).black, player.current.number
    (0.5, '2')

    References
    ----------
    docs/method.md, "Cues".
    """

    def __init__(self, scene: Scene, cues: Sequence[Cue]) -> None:
        self.scene = scene
        self.cues: CueList = check_cues(named_cues(cues, scene.labels))
        self.state: CueState = of_list.begin(self.cues)
        self.rejected: tuple[str, ...] = ()
        """What could not be called by the last act, in sentences: one move that cannot costs that move."""
        self.pace = 1.0
        """At which it calls, 0 to 1 of the show's time (`Scene.set_pace`): what pauses is below 1."""
        self._done: deque[of_list.Planned] = deque(maxlen=MOST_DONE)
        self._panics: dict[str, int] = {name: scene[name].panics for name in scene}

    @property
    def current(self) -> Cue | None:
        """The cue that was called last."""
        return self._cue(self.state.current)

    @property
    def standby(self) -> Cue | None:
        """The cue that GO plays; None at the end of the list."""
        return self._cue(self.state.standby)

    def go(self, *, seen: str | None = None) -> None:
        """Calls the cue that stands by; all that it does not move goes on.

        Parameters
        ----------
        seen : str, optional
            The number of the cue that its presser saw standing by.

        Raises
        ------
        ValueError
            Where another cue stands by than was seen, and at the end of the list; nothing is called then.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> player = omote.CuePlayer(scene, [omote.Cue("a", "1", {"*/light": omote.Move({"flat": 1.0}, 0.0)})])
        >>> player.go(seen="1")
        >>> dict(player.advance(0.0).light)
        {'flat': 1.0}
        """
        standby = self.standby
        if standby is None:
            raise ValueError("no cue stands by: the list is at its end; go to a cue, or go back")
        if seen is not None and seen != standby.number:
            raise ValueError(f"cue {standby.number} stands by, not {seen}; nothing was called")
        self._play(lambda state: of_list.go(state, self.cues, self._read))

    def go_to(self, number: str, *, whole: bool = False) -> None:
        """Calls a cue out of its order; what waits is forgotten.

        Parameters
        ----------
        number : str
            Of the cue.
        whole : bool
            Whether all that the cues before it leave standing is called too.

        Raises
        ------
        ValueError
            On a number that there is not.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> light = omote.Cue("a", "1", {"*/light": omote.Move({"flat": 1.0})})
        >>> player = omote.CuePlayer(scene, [light, omote.Cue("b", "2", {"one/face": omote.Move({"old": 1.0})})])
        >>> player.go_to("2", whole=True)
        >>> dict(player.advance(1.0).light)
        {'flat': 1.0}
        """
        place = self._place(number)
        self._play(lambda state: of_list.go_to(state, self.cues, place, self._read, whole=whole))

    def go_back(self) -> None:
        """Brings back what stood before the last cue; that cue stands by again.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> player = omote.CuePlayer(scene, [omote.Cue("a", "1", {"*/light": omote.Move({"flat": 1.0})})])
        >>> player.go()
        >>> player.go_back()
        >>> dict(player.advance(1.0).light), player.standby.number
        ({'theatre': 1.0}, '1')
        """
        self._play(of_list.go_back)

    def assert_look(self) -> None:
        """Calls all that the cues have left standing again, whoever has moved it since.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> player = omote.CuePlayer(scene, [omote.Cue("a", "1", {"*/light": omote.Move({"flat": 1.0})})])
        >>> player.go()
        >>> scene.call_light("portrait", seconds=0)
        >>> player.assert_look()
        >>> dict(player.advance(1.0).light)
        {'flat': 1.0}
        """
        self._play(of_list.assert_look)

    def set_standby(self, number: str) -> None:
        """Has another cue stand by; nothing moves.

        Parameters
        ----------
        number : str
            Of the cue.

        Raises
        ------
        ValueError
            On a number that there is not.

        Examples
        --------
        >>> player = omote.CuePlayer(omote.Scene.begun(cast), [omote.Cue("a", "1"), omote.Cue("b", "2")])
        >>> player.set_standby("2")
        >>> player.standby.number
        '2'
        """
        identity = self.cues[self._place(number)].identity
        self._play(lambda state: of_list.set_standby(state, identity))

    def edit(self, cues: Sequence[Cue]) -> None:
        """Plays another edition of the list from now on: nothing moves, and what was called goes on as it was.

        Parameters
        ----------
        cues : sequence of Cue
            The list; a cue is the same by its identity, whatever its number and place.

        Raises
        ------
        ValueError
            Where two cues have one number.

        Examples
        --------
        >>> player = omote.CuePlayer(omote.Scene.begun(cast), [omote.Cue("a", "1"), omote.Cue("b", "2")])
        >>> player.edit([omote.Cue("b", "2")])
        >>> player.standby.number
        '2'
        """
        after = check_cues(named_cues(cues, self.scene.labels))
        self._play(lambda state: of_list.edited(state, self.cues, after))
        self.cues = after

    def advance(self, dt: float) -> SceneFrame:
        """What is on air some time later, with all that was due called at its own time, however long the step.

        Parameters
        ----------
        dt : float
            Seconds since the last step, 0 or more.

        Returns
        -------
        SceneFrame
            As of `Scene.advance`.

        Raises
        ------
        ValueError
            On a step that is negative or endless.
        TypeError
            On what is no number.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> dark = omote.Move({"black": 1.0}, seconds=2.0, delay=1.0)
        >>> player = omote.CuePlayer(scene, [omote.Cue("a", "1", {"*/black": dark})])
        >>> player.go()
        >>> player.advance(2.0).black
        0.5
        """
        return advance_lists(self.scene, [self], dt)

    def begin_step(self, dt: float) -> tuple[of_list.Call, ...]:
        """Goes on some time and returns what was due, to be called by `call`.

        Parameters
        ----------
        dt : float
            Seconds of the list's clock, 0 or more.

        Returns
        -------
        tuple of Call
            The earliest first.

        Examples
        --------
        >>> player = omote.CuePlayer(omote.Scene.begun(cast), [omote.Cue("a", "1")])
        >>> player.begin_step(1.0)
        ()
        """
        self._drop_after_panics()
        self.rejected = ()
        self._note(of_list.advance(replace(self.state, done=()), self.cues, dt, self._read))
        return self.state.calls

    def forget_waiting(self, part: Part) -> None:
        """Forgets what waits for a part that another list has moved.

        Parameters
        ----------
        part : str
            As of `Scene.goal_of`.

        Examples
        --------
        >>> late = omote.Move({"flat": 1.0}, delay=1.0)
        >>> player = omote.CuePlayer(omote.Scene.begun(cast), [omote.Cue("a", "1", {"*/light": late})])
        >>> player.go()
        >>> player.forget_waiting("*/light")
        >>> player.state.waiting
        ()
        """
        if any(one.part == part for one in self.state.waiting):
            self.state = of_list.without_parts(self.state, (part,))

    def _play(self, act: Callable[[CueState], CueState]) -> None:
        """Does an act on what a panic has left, and calls what it calls."""
        self._drop_after_panics()
        self.rejected = ()
        self._note(act(replace(self.state, done=())))
        for call in self.state.calls:
            self.call(call)

    def _note(self, state: CueState) -> None:
        """Goes on from a state; what it has done is there to be taken."""
        self.state = of_list.with_moving(state)
        over = len(self._done) + len(state.done) - MOST_DONE
        if state.done and over > 0:
            self.rejected = (*self.rejected, f"{over} actions came at once and were left out: cues follow too fast")
        self._done.extend(state.done)

    def take_actions(self) -> list[tuple[str, CueAction]]:
        """Returns and clears what cues have done beside moving parts, the newest 256, for whoever sends and speaks.

        Returns
        -------
        list of tuple
            The name of the cue, as "cue 1", and the action, the earliest first.

        Examples
        --------
        >>> note = omote.CueAction("midi", "Desk", "90 3C 7F")
        >>> player = omote.CuePlayer(omote.Scene.begun(cast), [omote.Cue("a", "1", actions=(note,))])
        >>> player.go()
        >>> player.take_actions()[0][1].meant.data.hex(" ")
        '90 3c 7f'
        """
        done = [(self._name(each.cue).removesuffix(": "), each.action) for each in self._done]
        self._done.clear()
        return done

    def call(self, call: of_list.Call) -> None:
        """Calls a part, unless a character or a face of its move is gone by now: then `rejected` says so.

        Parameters
        ----------
        call : Call
            The part, its move and its cue.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> player = omote.CuePlayer(scene, [omote.Cue("a", "1", {"two/face": omote.Move({"dog": 1.0})})])
        >>> player.go()
        >>> len(player.rejected)
        1
        """
        move = call.move
        try:
            self.scene.call_goal(call.part, move.goal, seconds=move.seconds, easing=move.easing, pace=self.pace)
        except ValueError as error:
            self.rejected = (*self.rejected, f"{self._name(call.cue)}{error}")

    def _name(self, identity: str | None) -> str:
        cue = self._cue(identity)
        return "" if cue is None else f"cue {cue.number}: "

    def _read(self, part: Part) -> Goal:
        try:
            return self.scene.goal_of(part)
        except ValueError:  # of somebody who is gone: there is nothing to go back to
            return WITH_FACE

    def _drop_after_panics(self) -> None:
        """Who was panicked since the last step or act waits for nothing."""
        panics = {name: self.scene[name].panics for name in self.scene}
        pressed = [name for name, count in panics.items() if count > self._panics.get(name, 0)]
        if pressed:
            self.state = of_list.drop_waiting(self.state, pressed)
        self._panics = panics

    def _cue(self, identity: str | None) -> Cue | None:
        place = place_of(self.cues, identity)
        return None if place is None else self.cues[place]

    def _place(self, number: str) -> int:
        numbers = [cue.number for cue in self.cues]
        return numbers.index(check_known(number, numbers, "cue of this list"))


def advance_lists(scene: Scene, players: Sequence[CuePlayer], dt: float) -> SceneFrame:
    """What is on air some time later, where several lists play on one scene, each at its pace: what moves a part owns
    it, so what waits for it in another list is forgotten.

    scene: of all players; players: of the lists; dt: seconds.
    """
    dt = check_within(dt, 0.0, FOREVER, "the time step (seconds)")
    due = []
    for place, player in enumerate(players):
        before = player.state.clock
        pace = player.pace
        due += [((call.at - before) / pace if pace else 0.0, place, call) for call in player.begin_step(dt * pace)]
    now = 0.0
    for at, place, call in sorted(due, key=lambda each: each[:2]):
        if at > now:
            scene.advance(at - now)
            now = at
        players[place].call(call)
        for other in (*players[:place], *players[place + 1 :]):
            other.forget_waiting(call.part)
    return scene.advance(max(dt - now, 0.0))
