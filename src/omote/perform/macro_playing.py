"""The part of a performer whose macros play several targets each."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from operator import is_not

from omote.model.known_names import NEUTRAL
from omote.perform.axis import weights
from omote.perform.channels import effective_channels
from omote.perform.frame import Frame, Gaze, Head, Held, with_fields
from omote.perform.limits import check_known
from omote.perform.mappings.kept_mappings import (
    Mappings,
    with_all,
    with_mapping,
    with_renamed,
    with_restored,
    without_mapping,
)
from omote.perform.mappings.macro_vectors import (
    MacroVectors,
    advance_macros,
    given_by,
    is_a_condition_new,
    move_macro,
    states_of,
    sum_by_target,
    vectors_of,
)
from omote.perform.mappings.macros import follow_change
from omote.perform.mappings.mapping import (
    ANGLES,
    CHANNEL,
    GAZE,
    HEAD,
    PAD,
    MacroCondition,
    MacroMapping,
    axis_of_pad,
    places_in,
)
from omote.perform.mix import Weights
from omote.perform.pads.blend_space import AXES
from omote.perform.pads.pad_point import TAKE_UP_SECONDS
from omote.perform.speech_playing import SpeechPlaying

NO_PLACES: Mapping[str, float] = {}


class MacroPlaying(SpeechPlaying):
    """Keeps mappings and plays their macros: what they give is of hands, beside what faders hold."""

    _macros: MacroVectors | None = None
    _gives = False
    _last_held: Held
    _resting: MacroVectors | None = None
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
        self._macros = move_macro(self._macros, kept, name, value, self._reading)
        self._play()

    def _change_mappings(self, later: Mappings) -> None:
        """Plays other mappings; what shows goes on."""
        now = self._now
        macros = follow_change(states_of(self._macros), now.mappings.kept, later.kept)
        self._now = with_fields(now, mappings=later)
        self._macros = vectors_of(macros, later.kept)

    def _rename_in_mappings(self, renamed: Mapping[str, str]) -> None:
        macros = states_of(self._macros)
        super()._rename_in_mappings(renamed)
        self._macros = vectors_of(macros, self._now.mappings.kept)

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
            macros = self._macros
            return 0.0 if macros is None else macros.value_of(name)
        if kind == CHANNEL:
            return now.channels.get(name, 0.0)
        mix: Weights = weights(now.expression)
        return mix.get(name, 0.0)

    def _advance_macros(self, dt: float) -> None:
        """Macros go on. dt: seconds."""
        macros = self._macros
        if macros is None or (macros is self._resting and not is_a_condition_new(macros, self._reading)):
            return
        later = advance_macros(macros, self._reading, dt)
        self._resting = later if later is macros else None
        if later is macros:
            return
        before = self._points()
        self._macros = later
        self._move_points(before, self._points())

    def _points(self) -> Mapping[str, float]:
        """Where macros have points of pads, by pad and axis."""
        macros = self._macros
        if macros is None or not macros.table.plays_pads:
            return NO_PLACES
        values = given_by(macros)
        table = macros.table
        sums = sum_by_target(table, values, [0.0] * len(table.targets))
        given = {to for (_, to), value in zip(table.sources, values.tolist(), strict=True) if value}
        return {
            name: number
            for (kind, name), number in zip(table.targets, sums, strict=True)
            if kind == PAD and f"{PAD}/{name}" in given
        }

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
        sources = (now.channels, now.head, now.gaze, self._macros)
        before = self._last_sources
        if not before or any(map(is_not, before, sources)):
            self._last_sources = sources
            self._last_held = self._with_given()
        return self._last_held

    def _with_given(self) -> Held:
        """What faders hold, with what macros give their targets."""
        now = self._now
        held = self.held_by_faders
        macros = self._macros
        values = None if macros is None else given_by(macros)
        self._gives = macros is not None and values is not None and bool(values[macros.table.beside_pads].any())
        if macros is None or values is None or not self._gives:
            return held
        table = macros.table
        count = len(table.channels)
        own = [now.channels.get(name, 0.0) for name in table.channels] if now.channels else [0.0] * count
        turns = {HEAD: dict(vars(now.head)), GAZE: dict(vars(now.gaze)), PAD: {}}
        own += [turns[kind].get(name, 0.0) for kind, name in table.targets[count:]]
        sums = sum_by_target(table, values, own)
        known = self._cast.expressions
        given = zip(table.channels, sums, strict=False)
        channels = {name: value for name, value in given if value and name in known}
        if now.channels:
            others = {name: value for name, value in now.channels.items() if name not in table.channels}
            channels = dict(sorted({**others, **channels}.items()))
        for (kind, name), value in zip(table.targets[count:], sums[count:], strict=True):
            limit = ANGLES.get(kind, {}).get(name)
            if limit is not None:
                turns[kind][name] = min(max(value, -limit), limit)
        return Held(channels, Head(**turns[HEAD]), Gaze(**turns[GAZE]))

    def _with_faders(self, frame: Frame) -> Frame:
        """A frame of what hands hold, where macros give something: as it stands, beside what faders hold."""
        if frame.held is not None:
            return with_fields(frame, held=self.held_by_faders)
        channels = effective_channels(self._cast.expressions, frame.channels, frame.gaze)
        return with_fields(frame, channels=channels, held=self.held_by_faders)
