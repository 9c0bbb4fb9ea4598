"""The part of a scene that reads and calls goals, whatever part they are of."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from omote.perform import axis
from omote.perform.axis import Axis
from omote.perform.easing import DEFAULT_EASING, find_easing
from omote.perform.lights import LIGHTS
from omote.perform.limits import check_call_seconds, check_known, check_within
from omote.perform.scene import movement
from omote.perform.scene.character_names import ALL, check_character
from omote.perform.scene.clip_goals import clip_of_goal
from omote.perform.scene.framings import framing_of, names_in, size_in
from omote.perform.scene.goals import (
    BLACK_LIMITS,
    PRESENCE_LIMITS,
    Goal,
    Part,
    check_goal,
    check_names,
    split_part,
)
from omote.perform.scene.removal import without_stay
from omote.perform.scene.scene_character import SceneCharacter
from omote.perform.scene.scene_clips import SceneClips
from omote.perform.scene.scene_frame import PLACE_LIMITS
from omote.perform.scene.scene_snapshot import Removal, Standing

STANDING: Mapping[str, movement.Ranges] = {"place": PLACE_LIMITS, "presence": PRESENCE_LIMITS}
"""The parts that say how a character stands, by the field of `Standing`."""


class SceneGoals(SceneClips):
    """Where the parts of a scene go: read, and called from whatever shows."""

    _characters: dict[str, SceneCharacter]
    _standings: dict[str, Standing]
    _light: Axis
    _framing: Axis
    _black: movement.Movement
    _removals: dict[str, Removal]

    def goal_of(self, part: Part) -> Goal:
        """Where a part goes, or stands.

        Parameters
        ----------
        part : str
            Of a character, `kaori/face` (face, expression, brows, eyes, mouth, rest, head, gaze, place, presence,
            motion, look, clip, macros, layer:tracker and the other layers), or of the scene, `*/light` (light, framing,
            black).

        Returns
        -------
        mapping of float
            A mix, or numbers by name, radians and metres; nothing for a region that goes with the whole face, and for
            a clip where none plays.

        Raises
        ------
        ValueError
            On a part or a character that there is not.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene["one"].call_face("dog", seconds=2)
        >>> scene.goal_of("one/face"), scene.goal_of("*/black")
        ({'dog': 1.0}, {'black': 0.0})
        """
        character, name = split_part(part)
        if character == ALL:
            return dict(self._black.goal) if name == "black" else dict(axis.goal_of(self._scene_axis(name)))
        standing = self._standing(character)
        return dict(getattr(standing, name).goal) if name in STANDING else self._characters[character].goal_of(name)

    def shown_goal(self, part: Part) -> Goal:
        """What a part shows now, as a goal that brings it back.

        Parameters
        ----------
        part : str
            As of `goal_of`.

        Returns
        -------
        mapping of float
            As of `goal_of`.

        Raises
        ------
        ValueError
            On a part or a character that there is not.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene.call_black(1.0, seconds=2)
        >>> frame = scene.advance(1.0)
        >>> scene.shown_goal("*/black")
        {'black': 0.5}
        """
        return self._showing(part)

    def _showing(self, part: Part, *, points: bool = True) -> Goal:
        """As `shown_goal`. points: where a pad plays, its point; else the mix that it shows."""
        character, name = split_part(part)
        if name == "black":
            return movement.values(self._black, BLACK_LIMITS)
        if character == ALL:
            return axis.standing_mix(axis.weights(self._scene_axis(name)))
        standing = self._standing(character)
        if name in STANDING:
            return movement.values(getattr(standing, name), STANDING[name])
        return self._characters[character].shown_goal(name, points=points)

    def _check_call(self, part: Part, goal: Goal) -> Goal:
        """Returns a goal that can be called now; ValueError, TypeError where a name or a number of it is none.

        part, goal: as of `call_goal`.
        """
        checked = check_goal(part, goal)
        character, name = split_part(part)
        if name == "framing":
            for framing in checked:
                framing_of(names_in(framing), self._characters, size_in(framing))
        elif name == "light":
            check_names(checked, LIGHTS, "light")
        elif name == "clip":
            self._present(character)
            if checked:
                check_known(clip_of_goal(checked).name, self._clips, "clip")
        elif character != ALL:
            self._characters[self._present(character)].check_call(part, checked)
        return checked

    def call_goal(
        self,
        part: Part,
        goal: Goal,
        *,
        seconds: float = 1.0,
        easing: str = DEFAULT_EASING,
        pace: float | None = None,
    ) -> None:
        """Brings a part to a goal from whatever shows, as its own call would; other parts go on.

        Parameters
        ----------
        part : str
            As of `goal_of`.
        goal : mapping of float
            As `goal_of` gives it.
        seconds : float
            How long it takes, 0 to 3600; 0 cuts. Automatic motion takes what its own filters take.
        easing : {"smooth", "gentle", "sharp", "early", "late"}
            The curve of the way.
        pace : float, optional
            How fast its time goes, 0 to 1 of the show's, until `set_pace` changes that; without it nothing does.

        Raises
        ------
        ValueError
            On names that there are not and numbers out of range; then nothing has changed.
        TypeError
            On what is no number.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene.call_goal("one/expression", {"smile": 0.5, "neutral": 0.5}, seconds=0)
        >>> scene.call_goal("one/head", {"yaw": 0.2, "pitch": 0.0, "roll": 0.0}, seconds=1)
        >>> round(scene.advance(0.5).characters["one"].frame.head.yaw, 3)
        0.1
        """
        checked = self._check_call(part, goal)
        find_easing(easing)
        seconds = check_call_seconds(seconds)
        pace = None if pace is None else check_within(pace, 0.0, 1.0, "the pace")
        character, name = split_part(part)
        if name == "black":
            way = movement.redirect(self._black, checked, seconds, BLACK_LIMITS, easing)
            self._black = movement.with_pace(way, pace)
        elif name == "light":
            self._light = axis.with_pace(axis.called_to_mix(self._light, checked, seconds, easing), pace)
            for each in self._characters.values():
                each.note_played()
        elif name == "framing":
            self._framing = axis.with_pace(axis.called_to_mix(self._framing, checked, seconds, easing), pace)
        elif name == "place":
            way = movement.redirect(self._standing(character).place, checked, seconds, PLACE_LIMITS, easing)
            self._stand(character, place=movement.with_pace(way, pace))
        elif name == "presence":
            stays = checked["presence"] > 0.0
            leaves = self._standing(character).leaves and not stays
            self._move_presence(character, checked["presence"], seconds, leaves=leaves, easing=easing)
            self._stand(character, presence=movement.with_pace(self._standing(character).presence, pace))
        elif name == "clip" and checked:
            call = clip_of_goal(checked)
            self.play_clip(
                character,
                call.name,
                seconds=seconds,
                start=call.start or 0.0,
                speed=call.speed,
                loop=call.loop,
                weights=call.weights,
                pace=pace,
            )
        else:
            self._characters[character].call_goal(name, checked, seconds, easing, pace)

    def channels_of(self, name: str) -> Mapping[str, float]:
        """Where the weights of a character's channels go, or stand.

        Parameters
        ----------
        name : str
            The character.

        Returns
        -------
        mapping of float
            By channel; those that are not 0.

        Raises
        ------
        ValueError
            On a character that there is not.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene["one"].set_channel("jawOpen", 0.4)
        >>> scene.channels_of("one")
        {'jawOpen': 0.4}
        """
        return self._characters[self._present(name)].channels_goal

    def call_channels(
        self, name: str, weights: Mapping[str, float], *, seconds: float = 1.0, easing: str = DEFAULT_EASING
    ) -> None:
        """Brings all channels of a character to some weights, from whatever they are; a hand on one of them ends that.

        Parameters
        ----------
        name : str
            The character.
        weights : mapping of float
            By channel, -0.5 to 1.5; those that are not named go to 0.
        seconds : float
            How long it takes, 0 to 3600; 0 cuts.
        easing : {"smooth", "gentle", "sharp", "early", "late"}
            The curve of the way.

        Raises
        ------
        ValueError
            On names that there are not and numbers out of range; then nothing has changed.
        TypeError
            On what is no number.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene.call_channels("one", {"jawOpen": 0.4}, seconds=1)
        >>> round(scene.advance(0.5).characters["one"].frame.channels["jawOpen"], 3)
        0.2
        """
        character = self._characters[self._present(name)]
        find_easing(easing)
        character.call_channels(character.check_channels(weights), check_call_seconds(seconds), easing)

    def set_pace(self, pace: float) -> None:
        """Lets the time of all that was called with a pace go faster or slower; what else moves goes on as it does.

        What is called meanwhile takes over the speed that shows.

        Parameters
        ----------
        pace : float
            0 to 1 of the show's time; 0 holds it.

        Raises
        ------
        ValueError
            On a pace out of range.
        TypeError
            On what is no number.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene.call_goal("*/black", {"black": 1.0}, seconds=2, pace=1.0)
        >>> frame = scene.advance(1.0)
        >>> scene.set_pace(0.0)
        >>> scene.advance(5.0).black
        0.5
        """
        pace = check_within(pace, 0.0, 1.0, "the pace")
        self._black = movement.repaced(self._black, pace)
        self._light = axis.repaced(self._light, pace)
        self._framing = axis.repaced(self._framing, pace)
        for name, standing in self._standings.items():
            place = movement.repaced(standing.place, pace)
            self._stand(name, place=place, presence=movement.repaced(standing.presence, pace))
        for character in self._characters.values():
            character.set_pace(pace)

    def call_framing(
        self,
        characters: Iterable[str] | None = (),
        *,
        size: str | None = None,
        seconds: float = 1.0,
        easing: str = DEFAULT_EASING,
    ) -> None:
        """Brings a framing on air, from whatever the picture shows.

        Parameters
        ----------
        characters : sequence of str, optional
            Whom the picture holds; nobody: all that are on the stage; None: whom it holds now.
        size : {"portrait", "head", "bust", "half", "full"}, optional
            How much of their figures the picture shows, a portrait heads alone; without it as much as now.
        seconds : float
            How long it takes, 0 to 3600; 0 cuts.
        easing : {"smooth", "gentle", "sharp", "early", "late"}
            The curve of the way.

        Raises
        ------
        ValueError
            On a character, a size or an easing that there is not, and on seconds out of range.
        TypeError
            On a text instead of a list, and on seconds that are no number.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> kaori = scene.add("kaori")
        >>> scene.call_framing(["one", "kaori"], seconds=0)
        >>> dict(scene.advance(0.0).framing)
        {'kaori+one': 1.0}
        >>> scene.call_framing(size="full", seconds=2)
        >>> dict(scene.advance(1.0).framing)
        {'kaori+one': 0.5, '*:full': 0.5}
        """
        held = names_in(self._shot) if characters is None else characters
        framing = framing_of(held, self._characters, size_in(self._shot) if size is None else size)
        find_easing(easing)
        self._framing = axis.called(self._framing, framing, check_call_seconds(seconds), easing)

    @property
    def _shot(self) -> str:
        return self._framing.on_air if self._framing.call is None else self._framing.call.target

    def _scene_axis(self, name: str) -> Axis:
        return self._light if name == "light" else self._framing

    def _present(self, name: str) -> str:
        """The name of a character that is there; ValueError, with the names and labels of all, for another."""
        return check_character(name, {each: self._standings[each].label for each in self._characters})

    def _standing(self, name: str) -> Standing:
        return self._standings[self._present(name)]

    def _stand(self, name: str, **changes: Any) -> None:
        self._standings[name] = replace(self._standing(name), **changes)

    def _move_presence(
        self, name: str, goal: float, seconds: float, *, leaves: bool, easing: str = DEFAULT_EASING
    ) -> None:
        seconds = check_call_seconds(seconds)
        before = self._standing(name).presence
        presence = movement.redirect(before, {"presence": goal}, seconds, PRESENCE_LIMITS, easing)
        self._stand(name, presence=presence, leaves=leaves)
        if not leaves:
            self._removals = without_stay(self._removals, name)
