"""The part of a performer whose macros play several targets each."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from operator import is_not

from omote.model.known_names import NEUTRAL
from omote.perform.axis import weights
from omote.perform.channels import effective_channels
from omote.perform.frame import Frame, Gaze, Head, Held, with_fields
from omote.perform.limits import CHANNEL_LOWEST, GAZE_LIMITS, HEAD_LIMITS, check_known
from omote.perform.mappings.kept_mappings import (
    Mappings,
    with_all,
    with_mapping,
    with_renamed,
    with_restored,
    without_mapping,
)
from omote.perform.mappings.macros import (
    Macros,
    advance_macros,
    follow_change,
    given_by,
    is_a_condition_new,
    move_macro,
)
from omote.perform.mappings.mapping import (
    CHANNEL,
    HEAD,
    PAD,
    MacroCondition,
    MacroMapping,
    axis_of_pad,
    places_in,
)
from omote.perform.mappings.soft_limit import soft_sum
from omote.perform.mix import Weights
from omote.perform.pads.blend_space import AXES, PLACE_RANGE
from omote.perform.pads.pad_point import TAKE_UP_SECONDS
from omote.perform.speech_playing import SpeechPlaying

FULL_CHANNEL = (CHANNEL_LOWEST, 1.0)
"""Where the sum of sources of a channel ends; one alone may go beyond, as a fader does."""
OF_PAD = f"{PAD}/"
NOTHING_GIVEN: Mapping[str, list[float]] = {}
NO_PLACES: Mapping[str, float] = {}


class MacroPlaying(SpeechPlaying):
    """Keeps mappings and plays their macros: what they give is of hands, beside what faders hold."""

    _given: Mapping[str, list[float]] = NOTHING_GIVEN
    _places: Mapping[str, float] = NO_PLACES
    _given_of: Macros | None = None
    _last_held: Held
    _resting: Macros | None = None
    _last_sources: tuple[object, ...] = ()

    @property
    def mappings(self) -> Mapping[str, MacroMapping]:
        """The mappings of the character.

        Returns
        -------
        mapping of MacroMapping
            By the name of their macro.

        Examples
        --------
        >>> dict(omote.Performer(cast).mappings)
        {}
        """
        return self._now.mappings.kept

    def set_mapping(self, mapping: MacroMapping, *, key: str = "") -> None:
        """Says what a macro plays from now on; one that plays already goes on without a jump.

        Parameters
        ----------
        mapping : MacroMapping
            In the place of the one of the same name.
        key : str
            What `restore_mapping` finds the one before by; the name where none is given.

        Raises
        ------
        ValueError
            On a channel that there is not, and beyond sixty-four.
        TypeError
            On what is no mapping.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.set_mapping(omote.MacroMapping("mouth", [omote.MacroTarget("channel/jawOpen", high=0.6)]))
        >>> performer.move_macro("mouth", 0.5)
        >>> dict(performer.advance(0.0).channels)
        {'jawOpen': 0.3}
        """
        if not isinstance(mapping, MacroMapping):
            raise TypeError(f"the mapping is a {type(mapping).__name__}; give an omote.MacroMapping")
        self._check_channels(mapping)
        self._change_mappings(with_mapping(self._now.mappings, mapping, key))

    def set_mappings(self, mappings: Iterable[MacroMapping], *, key: str = "") -> None:
        """Changes all mappings at once; macros that are still there stay where they are, without a jump.

        Parameters
        ----------
        mappings : sequence of MacroMapping
            In the place of all that there are; a channel that the cast has not gives nothing.
        key : str
            What `restore_mapping` finds those before by; "*" where none is given.

        Raises
        ------
        ValueError
            Beyond sixty-four, and where two have one name.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.set_mappings([omote.MacroMapping("mouth", (omote.MacroTarget("channel/jawOpen"),))])
        >>> list(performer.mappings)
        ['mouth']
        """
        listed = [*mappings]
        wanted = {mapping.name: mapping for mapping in listed}
        if len(wanted) < len(listed):
            twice = next(each.name for each in listed if wanted[each.name] is not each)
            raise ValueError(f"two macros are called {twice}; give one of them another name")
        self._change_mappings(with_all(self._now.mappings, wanted, key or "*"))

    def rename_mapping(self, name: str, to: str, *, key: str = "") -> None:
        """Gives a macro another name, in the conditions of others too; nothing changes on air.

        Parameters
        ----------
        name : str
            The macro.
        to : str
            Its name from now on.
        key : str
            What `restore_mapping` finds the change by; the old name where none is given.

        Raises
        ------
        ValueError
            On a macro that there is not, and on a name that none can have or that another has.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.set_mapping(omote.MacroMapping("mouth", [omote.MacroTarget("channel/jawOpen")]))
        >>> performer.rename_mapping("mouth", "jaw")
        >>> list(performer.mappings)
        ['jaw']
        """
        self._change_mappings(with_renamed(self._now.mappings, name, to, key))

    def drop_mapping(self, name: str, *, key: str = "") -> None:
        """Forgets a macro and its mapping; what it gives fades out.

        Parameters
        ----------
        name : str
            The macro.
        key : str
            What `restore_mapping` finds it by; the name where none is given.

        Raises
        ------
        ValueError
            On a macro that there is not.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.set_mapping(omote.MacroMapping("mouth", [omote.MacroTarget("channel/jawOpen")]))
        >>> performer.drop_mapping("mouth")
        >>> dict(performer.mappings)
        {}
        """
        self._change_mappings(without_mapping(self._now.mappings, name, key))

    def restore_mapping(self, key: str) -> None:
        """Takes back that mappings were set, renamed or dropped; again, it is as after that.

        The last sixteen changes can be taken back.

        Parameters
        ----------
        key : str
            What the change was given: the name, where it was given no key.

        Raises
        ------
        ValueError
            On a key that there is not.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.set_mapping(omote.MacroMapping("mouth", [omote.MacroTarget("channel/jawOpen")]))
        >>> performer.drop_mapping("mouth")
        >>> performer.restore_mapping("mouth")
        >>> list(performer.mappings)
        ['mouth']
        """
        self._change_mappings(with_restored(self._now.mappings, key))

    def move_macro(self, name: str, value: float) -> None:
        """Moves a macro: each of its targets follows by its own curve.

        Parameters
        ----------
        name : str
            The macro.
        value : float
            -1 to 1; below 0 plays what has a half below zero.

        Raises
        ------
        ValueError
            On a macro that there is not, and on a value out of range.
        TypeError
            On what is no number.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> turn = omote.MacroTarget("head/yaw", high=0.4, below=omote.HalfBelow(-0.2))
        >>> performer.set_mapping(omote.MacroMapping("turn", [turn, omote.MacroTarget("channel/browInnerUp")]))
        >>> performer.move_macro("turn", -0.5)
        >>> frame = performer.advance(0.0)
        >>> frame.head.yaw, dict(frame.channels)
        (-0.1, {})

        References
        ----------
        docs/method.md, "Mappings".
        """
        kept = self._now.mappings.kept
        if not (isinstance(name, str) and name in kept):
            check_known(name, kept, "macro")
        self._play(macros=move_macro(self._now.macros, kept[name], value, self._reading))

    def _change_mappings(self, later: Mappings) -> None:
        """Plays other mappings; what shows goes on."""
        now = self._now
        macros = follow_change(now.macros, now.mappings.kept, later.kept)
        self._now = with_fields(now, mappings=later, macros=macros)

    def _check_channels(self, mapping: MacroMapping) -> None:
        units = [name for name in self._cast.expressions if name != NEUTRAL]
        for kind, channel in places_in([mapping]):
            if kind == CHANNEL and (channel not in self._cast.expressions or channel == NEUTRAL):
                check_known(channel, units, "channel")

    def _reading(self, condition: MacroCondition) -> float:
        """What a condition reads: what hands and calls hold, never what mappings make of it."""
        kind, name = condition.place
        now = self._now
        if kind == "macro":
            state = now.macros.moved.get(name)
            return 0.0 if state is None else state.value
        if kind == CHANNEL:
            return now.channels.get(name, 0.0)
        mix: Weights = weights(now.expression)
        return mix.get(name, 0.0)

    def _advance_macros(self, dt: float) -> None:
        """Macros go on. dt: seconds."""
        now = self._now
        macros = now.macros
        if not macros.moved and not macros.fading:
            return
        if macros is self._resting and not is_a_condition_new(macros, now.mappings.kept, self._reading):
            return
        later = advance_macros(macros, now.mappings.kept, self._reading, dt)
        self._resting = later if later is macros else None
        if later is macros:
            return
        plays_pads = any(now.mappings.kept[name].plays_pads for name in later.moved)
        before = self._points() if plays_pads else NO_PLACES
        self._now = with_fields(now, macros=later)
        if plays_pads:
            self._move_points(before, self._points())

    def _points(self) -> Mapping[str, float]:
        """Where macros have points of pads, by pad and axis."""
        self._sources()
        return self._places

    def _move_points(self, before: Mapping[str, float], places: Mapping[str, float]) -> None:
        """Moves the points of pads where macros have moved one; who moves a pad last has it. before, places: by pad and
        axis."""
        moved = dict[str, dict[str, float]]()
        for name in {**before, **places}:
            if before.get(name) != places.get(name):
                pad, axis = axis_of_pad(name)
                moved.setdefault(pad, {})[axis] = places.get(name, 0.0)
        for name, numbers in moved.items():
            worn = self._pads.get(name)
            if worn is None:
                continue
            x, y, z = (numbers.get(axis) if place < worn.dimensions else None for place, axis in enumerate(AXES))
            place = worn.moved(self._now.pads.get(name, ()), x, y, z)
            self._now = with_fields(self._now, **self._moved(worn, place, TAKE_UP_SECONDS))

    def _sources(self) -> Mapping[str, list[float]]:
        """What macros give channels, head and gaze now, by target; the same object until one moves."""
        now = self._now
        if now.macros is not self._given_of:
            self._given_of = now.macros
            given = given_by(now.macros, now.mappings.kept)
            points = [to for to in given if to.startswith(OF_PAD)]
            self._places = {to.partition("/")[2]: soft_sum(given.pop(to), *PLACE_RANGE) for to in points}
            self._given = given
        return self._given

    @property
    def held_by_faders(self) -> Held:
        """What hands hold by faders alone, without what macros give.

        Returns
        -------
        Held
            Channels, head and gaze.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.set_channel("jawOpen", 0.4)
        >>> dict(performer.held_by_faders.channels)
        {'jawOpen': 0.4}
        """
        return Held(self._now.channels, self._now.head, self._now.gaze)

    def _held(self) -> Held:
        """What hands hold, by faders and by macros; the same object until one moves."""
        now = self._now
        sources = (now.channels, now.head, now.gaze, now.macros, now.mappings)
        before = self._last_sources
        if not before or any(map(is_not, before, sources)):
            self._last_sources = sources
            given = self._sources()
            self._last_held = self.held_by_faders if not given else self._with_given(given)
        return self._last_held

    def _with_given(self, given: Mapping[str, list[float]]) -> Held:
        """What faders hold, with what macros give their targets."""
        now = self._now
        channels = dict(now.channels)
        head = {"yaw": now.head.yaw, "pitch": now.head.pitch, "roll": now.head.roll}
        gaze = {"yaw": now.gaze.yaw, "pitch": now.gaze.pitch}
        expressions = self._cast.expressions
        for to, values in given.items():
            kind, _, name = to.partition("/")
            if kind == CHANNEL:
                if name in expressions:
                    own = channels.get(name, 0.0)
                    alone = len(values) == 1 and not own  # nearly always: the sum is that
                    channels[name] = values[0] if alone else soft_sum((own, *values), *FULL_CHANNEL)
            elif kind == HEAD:
                limit = HEAD_LIMITS[name]
                head[name] = min(max(soft_sum((head[name], *values), -limit, limit), -limit), limit)
            else:
                limit = GAZE_LIMITS[name]
                gaze[name] = min(max(soft_sum((gaze[name], *values), -limit, limit), -limit), limit)
        shown = {name: channels[name] for name in sorted(channels) if channels[name]}
        return Held(shown, Head(**head), Gaze(**gaze))

    def _with_faders(self, frame: Frame) -> Frame:
        """A frame of what hands hold, where macros give something: as it stands, beside what faders hold."""
        if frame.held is not None:
            return with_fields(frame, held=self.held_by_faders)
        channels = effective_channels(self._cast.expressions, frame.channels, frame.gaze)
        return with_fields(frame, channels=channels, held=self.held_by_faders)
