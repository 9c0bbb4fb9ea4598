"""The scene: several performers on one stage, each at its place, in one light and one picture. It owns no clock."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from omote.model.known_names import GENERIC, explain_unknown
from omote.perform import axis
from omote.perform.axis import Axis
from omote.perform.easing import DEFAULT_EASING, find_easing
from omote.perform.frame import Frame, with_fields
from omote.perform.lights import FIRST_LIGHT, check_light
from omote.perform.limits import FOREVER, check_call_seconds, check_known, check_within
from omote.perform.motion.sight import Point
from omote.perform.pads.kept_pads import NO_PADS
from omote.perform.performer import Performer
from omote.perform.scene import movement
from omote.perform.scene.character_names import ALL, FIRST_CHARACTER, MOST_CHARACTERS, check_character_name
from omote.perform.scene.framings import names_in, size_in
from omote.perform.scene.gaze_targets import (
    MOST_CAMERAS,
    MOST_POINTS,
    Looker,
    check_point,
    check_point_name,
    check_target_there,
    eyes_at,
    find_sight,
)
from omote.perform.scene.goals import BLACK_LIMITS, PRESENCE_LIMITS
from omote.perform.scene.memories import NO_MEMORIES
from omote.perform.scene.removal import framing_back, insert_at_rank, with_kept, with_removal
from omote.perform.scene.scene_character import SceneCharacter
from omote.perform.scene.scene_frame import PLACE_LIMITS, CharacterFrame, Place, SceneFrame, free_place
from omote.perform.scene.scene_pads import ScenePads
from omote.perform.scene.scene_snapshot import (
    CharacterSnapshot,
    Removal,
    SceneSnapshot,
    Standing,
    check_label,
    check_scene,
    standing_after,
)
from omote.perform.snapshot import Playable, axis_names, check_snapshot, refuse_no_cast

FIRST_LABEL = "One"
AWAY = movement.Movement({"presence": 0.0})


class Scene(ScenePads):
    """Characters on one stage: each is a performer with a place; light, framing and black are the scene's.

    It owns no clock and no thread; the same commands and steps give the same frames. What one character plays changes
    nothing of another, but where that looks at it.

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
    >>> scene = omote.Scene(cast)
    >>> kaori = scene.add("kaori", face="kaori")
    >>> scene.enter("kaori", seconds=2)
    >>> kaori.call_expression("smile", seconds=1)
    >>> character = scene.advance(1.0).characters["kaori"]
    >>> dict(character.frame.expressions), character.presence
    ({'smile': 1.0}, 0.5)

    References
    ----------
    docs/architecture.md, "Life of a call".
    """

    def __init__(self, cast: Playable) -> None:
        refuse_no_cast(cast)
        check_known(GENERIC, cast.faces, "face")
        self._cast = cast
        self._characters: dict[str, SceneCharacter] = {}
        self._standings: dict[str, Standing] = {}
        self._shown: dict[str, tuple[Standing, Place, float]] = {}
        self._removals: dict[str, Removal] = {}
        self._gaze_points: dict[str, Point] = {}
        self._cameras: dict[str, Point] = {}
        self._light = Axis(FIRST_LIGHT)
        self._framing = Axis(ALL)
        self._black = movement.Movement({"black": 0.0})
        self._memories = NO_MEMORIES
        self._pads = NO_PADS
        self._clips = {}
        self._time = 0.0

    @classmethod
    def begun(cls, cast: Playable) -> Scene:
        """The scene that a new show begins with: one character, `one`, on the stage.

        Parameters
        ----------
        cast : Cast
            What it plays.

        Returns
        -------
        Scene
            With the character `one`.

        Examples
        --------
        >>> list(omote.Scene.begun(cast))
        ['one']
        """
        scene = cls(cast)
        scene.add_cast_pads()
        scene.add(FIRST_CHARACTER, label=FIRST_LABEL)
        scene.enter(FIRST_CHARACTER, seconds=0.0)
        return scene

    @classmethod
    def restored(cls, cast: Playable, snapshot: SceneSnapshot) -> Scene:
        """The scene that continues from a snapshot, frame by frame the same.

        Parameters
        ----------
        cast : Cast
            What it plays.
        snapshot : SceneSnapshot
            What another one's `snapshot` gave.

        Returns
        -------
        Scene
            Independent of the first.

        Raises
        ------
        ValueError
            Where this cast cannot play the snapshot, or no scene can have written it.
        TypeError
            On what is no snapshot of a scene.

        Examples
        --------
        >>> first = omote.Scene.begun(cast)
        >>> first["one"].call_face("dog", seconds=2)
        >>> second = omote.Scene.restored(cast, first.snapshot())
        >>> first.advance(0.7) == second.advance(0.7)
        True
        """
        scene = cls(cast)
        check_scene(snapshot, cast)
        scene._light = snapshot.light
        scene._framing = snapshot.framing
        scene._black = snapshot.black
        scene._memories = snapshot.memories
        scene._pads = snapshot.pads
        scene._time = snapshot.time
        scene._removals = dict(snapshot.removals)
        scene._gaze_points = dict(snapshot.gaze_points)
        scene._cameras = dict(snapshot.cameras)
        for name, character in snapshot.characters.items():
            restored = SceneCharacter.of(cast, character.performer, scene.call_light, scene._check_target)
            restored.wear_pads(snapshot.pads.kept)
            restored.turning = character.turning
            scene._characters[name] = restored
            scene._standings[name] = character.standing
        return scene

    def snapshot(self) -> SceneSnapshot:
        """Everything needed to continue later, or elsewhere.

        Returns
        -------
        SceneSnapshot
            Plain values, frozen.

        Examples
        --------
        >>> list(omote.Scene.begun(cast).snapshot().characters)
        ['one']
        """
        standings = self._standings
        characters = {
            name: CharacterSnapshot(character.snapshot(), standings[name], character.turning)
            for name, character in self._characters.items()
        }
        kept = (dict(self._removals), self._gaze_points, self._cameras, self._black, self._memories, self._pads)
        return SceneSnapshot(characters, self._light, self._framing, self._time, *kept)

    def recast(self, cast: Playable) -> None:
        """Plays another cast from now on; what is on air stays.

        Parameters
        ----------
        cast : Cast
            One that has everything that is on air.

        Raises
        ------
        ValueError
            Where it has not; then nothing has changed.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene.recast(cast.with_expressions(beam=cast.expressions["joy"]))
        >>> scene["one"].call_expression("beam")
        """
        for character in self._characters.values():
            check_snapshot(character.snapshot(), cast)
        for character in self._characters.values():
            character.recast(cast)
            character.wear_pads(self._pads.kept)
        self._cast = cast

    @property
    def labels(self) -> dict[str, str]:
        """What people call each character, by its name.

        Returns
        -------
        dict of str to str
            In the order in which they were added.

        Examples
        --------
        >>> omote.Scene.begun(cast).labels
        {'one': 'One'}
        """
        return {name: standing.label for name, standing in self._standings.items()}

    def __getitem__(self, name: str) -> Performer:
        """The performer of a character."""
        if name not in self._characters:
            raise KeyError(explain_unknown(name, list(self._characters), "character"))
        return self._characters[name]

    def __iter__(self) -> Iterator[str]:
        """The names of the characters, in the order in which they were added."""
        return iter(list(self._characters))

    def __len__(self) -> int:
        """How many characters there are."""
        return len(self._characters)

    def __contains__(self, name: object) -> bool:
        """Whether there is a character of this name."""
        return name in self._characters

    def add(self, name: str, *, face: str = GENERIC, label: str | None = None) -> Performer:
        """Adds a character, which waits off stage, at a free place, until it enters.

        Parameters
        ----------
        name : str
            Its name for ever: 1 to 24 lower case letters, digits, `_` or `-`.
        face : str
            The face that it wears, which is its home face too.
        label : str, optional
            What people call it; its name where none is given.

        Returns
        -------
        Performer
            The character, as `scene[name]` gives it; `call_light` is the scene's.

        Raises
        ------
        ValueError
            On a name that no character can have or that one has, on a label that another has, on a face that there is
            not, and beyond eight.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene.add("kaori", face="kaori", label="Kaori") is scene["kaori"]
        True
        """
        check_character_name(name)
        self._refuse_one_more(name)
        label = check_label(name if label is None else label, self.labels)
        check_known(face, self._cast.faces, "face")
        place = free_place(Place(**standing.place.goal) for standing in self._standings.values())
        self._characters[name] = SceneCharacter.new(self._cast, face, self._time, self.call_light, self._check_target)
        self._characters[name].wear_pads(self._pads.kept)
        self._standings[name] = Standing(label, movement.Movement(vars(place)), AWAY)
        return self._characters[name]

    def remove(self, name: str, *, seconds: float = 1.0, key: str = "") -> None:
        """Takes a character out of the scene: it leaves the stage, then it is gone; `restore` brings it back, whole.

        Shots that hold it go on without it in the same time; it stays until none holds it any more.

        Parameters
        ----------
        name : str
            The character.
        seconds : float
            How long it takes to leave, 0 to 3600.
        key : str
            What `restore` finds it by; its name where none is given.

        Raises
        ------
        ValueError
            On a character that there is not and on seconds out of range.
        TypeError
            On seconds that are no number.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene.remove("one", seconds=1)
        >>> list(scene.advance(1.0).characters)
        []
        """
        presence = self._standing(name).presence.goal["presence"]
        before = tuple(self._characters)[: list(self._characters).index(name)]
        self._move_presence(name, 0.0, seconds, leaves=True)
        shot = self._shot
        framing = None
        if name in names_in(shot):
            self.call_framing(names_in(shot) - {name}, size=size_in(shot), seconds=seconds)
            framing = (shot, self._shot)
        self._removals = with_removal(self._removals, key or name, Removal(name, before, presence, framing))

    def restore(self, key: str, *, seconds: float = 1.0) -> None:
        """Brings back a character that was removed: all that it had on air, its place, its rank and its shot.

        The last sixteen that were removed can be brought back.

        Parameters
        ----------
        key : str
            What `remove` was given: the character's name, where it was given no key.
        seconds : float
            How long it takes to enter, if it was on the stage, 0 to 3600.

        Raises
        ------
        ValueError
            On a key that there is not, on a name that another has meanwhile, where the cast has lost what it played,
            beyond eight, and on seconds out of range.
        TypeError
            On seconds that are no number.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene["one"].set_channel("jawOpen", 0.5)
        >>> scene.remove("one", seconds=0)
        >>> _ = scene.advance(0.0)
        >>> scene.restore("one", seconds=0)
        >>> scene.advance(0.0).characters["one"].frame.channels
        {'jawOpen': 0.5}
        """
        seconds = check_call_seconds(seconds)
        removal = self._removals[check_known(key, self._removals, "removed character")]
        if removal.kept is not None:
            self._put_back(removal, removal.kept)
        self._move_presence(removal.character, removal.presence, seconds, leaves=False)
        self._removals.pop(key, None)
        held = framing_back(removal, self._shot, self._characters)
        if held is not None:
            self.call_framing(names_in(held), size=size_in(held), seconds=seconds)

    def _put_back(self, removal: Removal, kept: CharacterSnapshot) -> None:
        name = removal.character
        self._refuse_one_more(name)
        snapshot = check_snapshot(replace(kept.performer, time=self._time), self._cast)
        character = SceneCharacter.of(self._cast, snapshot, self.call_light, self._check_target)
        character.find_clips(self._clips)
        character.wear_pads(self._pads.kept)
        self._characters = insert_at_rank(self._characters, name, character, removal.before)
        self._standings = insert_at_rank(self._standings, name, kept.standing, removal.before)

    def rename(self, name: str, label: str) -> None:
        """Gives a character another label; its name stays.

        Parameters
        ----------
        name : str
            The character.
        label : str
            What people call it from now on.

        Raises
        ------
        ValueError
            On a character that there is not, and on a label without letters, with more than 80, or that another has.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene.rename("one", "Kaori")
        >>> scene.advance(0.0).characters["one"].label
        'Kaori'
        """
        self._stand(name, label=check_label(label, {n: other for n, other in self.labels.items() if n != name}))

    def place(
        self,
        name: str,
        *,
        x: float | None = None,
        depth: float | None = None,
        size: float | None = None,
        turn: float | None = None,
        seconds: float = 1.0,
    ) -> None:
        """Moves a character to another place, from wherever it is.

        Parameters
        ----------
        name : str
            The character.
        x, depth, size, turn : float, optional
            Metres to the picture's right, -10 to 10; metres behind the front line, 0 to 20; a factor, 0.25 to 4;
            radians to the character's own left, -pi to pi. What is not given stays.
        seconds : float
            How long it takes, 0 to 3600; 0 cuts.

        Raises
        ------
        ValueError
            On a character that there is not, and on a number out of range.
        TypeError
            On what is no number.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene.place("one", x=0.4, seconds=2)
        >>> round(scene.advance(1.0).characters["one"].place.x, 3)
        0.2
        """
        standing = self._standing(name)
        changes = {"x": x, "depth": depth, "size": size, "turn": turn}
        goal = Place(**{**standing.place.goal, **{key: value for key, value in changes.items() if value is not None}})
        seconds = check_call_seconds(seconds)
        self._stand(name, place=movement.redirect(standing.place, vars(goal), seconds, PLACE_LIMITS))

    def enter(self, name: str, *, seconds: float = 1.0) -> None:
        """Brings a character onto the stage; one that was removed and is not gone yet stays.

        Parameters
        ----------
        name : str
            The character.
        seconds : float
            How long it takes, 0 to 3600; 0 cuts.

        Raises
        ------
        ValueError
            On a character that there is not and on seconds out of range.
        TypeError
            On seconds that are no number.

        Examples
        --------
        >>> scene = omote.Scene(cast)
        >>> kaori = scene.add("kaori")
        >>> scene.enter("kaori", seconds=0)
        >>> scene.advance(0.0).characters["kaori"].presence
        1.0
        """
        self._move_presence(name, 1.0, seconds, leaves=False)

    def leave(self, name: str, *, seconds: float = 1.0) -> None:
        """Takes a character off the stage; it stays in the scene and can be played on.

        Parameters
        ----------
        name : str
            The character.
        seconds : float
            How long it takes, 0 to 3600; 0 cuts.

        Raises
        ------
        ValueError
            On a character that there is not and on seconds out of range.
        TypeError
            On seconds that are no number.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene.leave("one", seconds=2)
        >>> scene.advance(2.0).characters["one"].presence
        0.0
        """
        self._move_presence(name, 0.0, seconds, leaves=self._standing(name).leaves)

    def set_gaze_point(self, name: str, *, x: float, y: float, z: float) -> None:
        """Names a point of the house that characters may look at (`look_at`), such as a seat; one of that name moves.

        Parameters
        ----------
        name : str
            1 to 40 letters.
        x, y, z : float
            Metres: to the picture's right, -20 to 20; above the eyes of a head of size 1, -10 to 10; before the front
            line, -20 to 200.

        Raises
        ------
        ValueError
            On a name that none can have, on numbers out of range, and beyond thirty-two points.
        TypeError
            On what is no number.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene.set_gaze_point("front row", x=0.5, y=-0.4, z=3.0)
        >>> scene["one"].look_at("gaze_point", "front row")
        >>> dict(scene.advance(0.0).gaze_points)
        {'front row': (0.5, -0.4, 3.0)}
        """
        name = check_point_name(name)
        if name not in self._gaze_points and len(self._gaze_points) >= MOST_POINTS:
            raise ValueError(f"there are {MOST_POINTS} gaze points, which is as many as a show keeps; delete one")
        self._gaze_points = {**self._gaze_points, name: check_point(x, y, z, f"the gaze point {name}")}

    def delete_gaze_point(self, name: str) -> None:
        """Forgets a gaze point; who looked at it looks ahead.

        Parameters
        ----------
        name : str
            The point.

        Raises
        ------
        ValueError
            On a point that there is not.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene.set_gaze_point("front row", x=0.5, y=-0.4, z=3.0)
        >>> scene.delete_gaze_point("front row")
        >>> dict(scene.advance(0.0).gaze_points)
        {}
        """
        check_known(name, self._gaze_points, "gaze point")
        self._gaze_points = {other: point for other, point in self._gaze_points.items() if other != name}
        for character in self._characters.values():
            if (character.motion.target.kind, character.motion.target.name) == ("gaze_point", name):
                character.look_at("ahead")

    def note_camera(self, stage: str, camera: Point | None) -> None:
        """Notes where the camera of a stage is, for those who look at it.

        Parameters
        ----------
        stage : str
            The name of the stage; "" for one without a name.
        camera : tuple of float, optional
            Metres as of `set_gaze_point`; None where the stage does not say.

        Raises
        ------
        ValueError
            On numbers out of range.
        TypeError
            On what is no number.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene.note_camera("left", (-0.5, 0.1, 1.2))
        >>> scene["one"].look_at("stage", "left")
        """
        if camera is None or (stage not in self._cameras and len(self._cameras) >= MOST_CAMERAS):
            return
        self._cameras = {**self._cameras, stage: check_point(*camera, f"the camera of the stage {stage!r}")}

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
        >>> scene = omote.Scene.begun(cast)
        >>> scene.call_light("flat", seconds=2)
        >>> sorted(scene.advance(1.0).light)
        ['flat', 'theatre']
        """
        check_light(name)
        find_easing(easing)
        self._light = axis.called(self._light, name, check_call_seconds(seconds), easing)
        for character in self._characters.values():
            character.note_played()

    def call_black(self, black: float, *, seconds: float = 1.0, easing: str = DEFAULT_EASING) -> None:
        """Fades all stages to black, or up again, from whatever shows; 0 seconds are a blackout.

        Parameters
        ----------
        black : float
            How far, 0 (the picture) to 1 (black).
        seconds : float
            How long it takes, 0 to 3600; 0 cuts.
        easing : {"smooth", "gentle", "sharp", "early", "late"}
            The curve of the way.

        Raises
        ------
        ValueError
            On an easing that there is not, and on numbers out of range.
        TypeError
            On what is no number.

        Examples
        --------
        >>> scene = omote.Scene.begun(cast)
        >>> scene.call_black(1.0, seconds=2)
        >>> scene.advance(1.0).black
        0.5
        """
        goal = {"black": check_within(black, 0.0, 1.0, "how black the picture is")}
        find_easing(easing)
        self._black = movement.redirect(self._black, goal, check_call_seconds(seconds), BLACK_LIMITS, easing)

    def advance(self, dt: float) -> SceneFrame:
        """What is on air some time later; one long step lands where many short ones do.

        Parameters
        ----------
        dt : float
            Seconds since the last step, 0 or more.

        Returns
        -------
        SceneFrame
            Each character's frame, place and presence; the mixes of lights and framings, which sum to one.

        Raises
        ------
        ValueError
            On a step that is negative or endless.
        TypeError
            On what is no number.

        Examples
        --------
        >>> omote.Scene.begun(cast).advance(1 / 60).framing
        {'*': 1.0}
        """
        dt = check_within(dt, 0.0, FOREVER, "the time step (seconds)")
        self._light = axis.advanced(self._light, dt)
        self._framing = axis.advanced(self._framing, dt)
        self._time += dt
        self._black = movement.proceed(self._black, dt)
        self._standings = {name: standing_after(at, dt) for name, at in self._standings.items()}
        self._find_sights()
        for name, character in self._characters.items():
            character.stands = self._shown_at(name)[0]
        frames = {name: character.advance(dt) for name, character in self._characters.items()}
        self._let_go()
        light = axis.weights(self._light)
        call = axis.status(self._light)
        return SceneFrame(
            {n: self._frame(n, with_fields(frames[n], light=light, light_call=call)) for n in self._characters},
            light,
            axis.weights(self._framing),
            self._time,
            call,
            axis.status(self._framing),
            self._gaze_points,
            movement.values(self._black, BLACK_LIMITS)["black"],
            self._black.goal["black"],
            tuple(self._memories.kept),
        )

    def _find_sights(self) -> None:
        """Each character is told what it sees of whom or what it looks at."""
        looking = [n for n, performer in self._characters.items() if performer.motion.target.kind != "ahead"]
        if not looking:
            return
        lookers = {name: self._looker(name) for name in self._characters}
        for name in looking:
            sight = find_sight(name, lookers, self._gaze_points, self._cameras, self._time)
            self._characters[name].sight = sight

    def _looker(self, name: str) -> Looker:
        character = self._characters[name]
        at = self._standings[name]
        motion = character.motion
        present = at.presence.goal["presence"] > 0.0
        place = self._shown_at(name)[0]
        return Looker(place, eyes_at(place, character.turned), motion.target, motion.seed, present)

    def _check_target(self, looker: object, kind: str, name: str) -> None:
        check_target_there(kind, name, self._characters, self._gaze_points, self._cameras)
        if looker is self._characters.get(name) and kind == "character":
            raise ValueError(f"{name} cannot look at itself; give another character")

    def _let_go(self) -> None:
        """Forgets characters that were removed, once they have left and no shot holds them."""
        gone = [name for name, at in self._standings.items() if at.leaves and at.presence == AWAY]
        if not gone:
            return
        held = {name for shot in axis_names(self._framing) for name in names_in(shot)}
        for name in gone:
            if name not in held:
                kept = CharacterSnapshot(self._characters.pop(name).snapshot(), self._standings.pop(name))
                self._removals = with_kept(self._removals, name, kept)
                self._shown.pop(name, None)

    def _refuse_one_more(self, name: str) -> None:
        if name in self._characters:
            raise ValueError(f"there is a character {name!r} already; give another name, or remove that one first")
        if len(self._characters) >= MOST_CHARACTERS:
            raise ValueError(f"there are {MOST_CHARACTERS} characters, which is as many as a scene holds; remove one")

    def _frame(self, name: str, frame: Frame) -> CharacterFrame:
        at = self._standings[name]
        (place, presence) = self._shown_at(name)
        return CharacterFrame(frame, place, presence, at.label, at.leaves)

    def _shown_at(self, name: str) -> tuple[Place, float]:
        """The place and the presence of a character now."""
        at = self._standings[name]
        shown = self._shown.get(name)
        if shown is None or shown[0] is not at:
            place = Place(**movement.values(at.place, PLACE_LIMITS))
            shown = self._shown[name] = (at, place, movement.values(at.presence, PRESENCE_LIMITS)["presence"])
        return shown[1:]
