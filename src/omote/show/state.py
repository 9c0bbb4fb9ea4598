"""Converts a frame of the engine to a state on the wire."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import msgspec

from omote.perform.channels import channels_of, eye_turns
from omote.perform.complexion import check_skin_fader
from omote.perform.easing import DEFAULT_EASING, EASINGS
from omote.perform.frame import CallStatus, ClipStatus, FigureFrame, Frame, Held, LayerStatus, MotionSettings
from omote.perform.mix import mix_in
from omote.perform.saturation import saturate
from omote.perform.scene.scene_frame import CharacterFrame, SceneFrame
from omote.perform.springs.cast_springs import check_spring
from omote.show.objects.cues import CueName, CueStatus
from omote.show.objects.show_notes import ShowNotes
from omote.show.objects.state import (
    CallState,
    CharacterState,
    ClipState,
    FigureState,
    GazeTargetState,
    HeldState,
    LayerSource,
    LayerState,
    MacroState,
    MotionState,
    PadPointState,
    Place,
    SpeechState,
    State,
    TrackedState,
)

if TYPE_CHECKING:
    from omote.perform.snapshot import Playable


EYE_SECONDS = 0.25
"""Eyes of an expression that changes on air take as long as its skin does on a stage (`source_crossfade.ts`)."""

Angles = tuple[float, float, float, float]
FindSound = Callable[[str], str | None]


@dataclass(frozen=True)
class EyeOffset:
    """How far the eyes were from where a changed cast has them (radians, as `State.eyes`), at `start`; it eases out."""

    angles: Angles = (0.0, 0.0, 0.0, 0.0)
    start: float = -EYE_SECONDS

    def add_to(self, eyes: Angles, time: float) -> Angles:
        """The angles that show at `time`, seconds of the show. eyes: the angles without it, radians."""
        part = (time - self.start) / EYE_SECONDS
        if part >= 1.0:
            return eyes
        rest = 1.0 - EASINGS[DEFAULT_EASING].value(part)
        left_yaw, left_pitch, right_yaw, right_pitch = (
            eye + rest * offset for eye, offset in zip(eyes, self.angles, strict=True)
        )
        return left_yaw, left_pitch, right_yaw, right_pitch


NO_OFFSET = EyeOffset()
NO_NOTES = ShowNotes()


def offset_between(shown: Angles, wanted: Angles, time: float) -> EyeOffset:
    """What keeps eyes that are wanted at some angles (radians) where they were shown, from `time` (seconds of the show)
    on."""
    left_yaw, left_pitch, right_yaw, right_pitch = (before - after for before, after in zip(shown, wanted, strict=True))
    return EyeOffset((left_yaw, left_pitch, right_yaw, right_pitch), time)


def state_of(
    cast: Playable,
    frame: SceneFrame,
    eye_offsets: Mapping[str, EyeOffset] = MappingProxyType({}),
    *,
    epoch: int,
    number: int,
    revision: int,
    notes: ShowNotes = NO_NOTES,
    cues: CueStatus | None = None,
    sounds: FindSound | None = None,
) -> State:
    """The complete state of a frame; eye_offsets: by character, what is added to the eyes that its frame has. cast:
    what plays; epoch, number and revision: those of the state; notes: of the crew; cues: how far they are;
    sounds: the key of one that is there, by what it is called, None for another; None for any."""
    return State(
        epoch=epoch,
        number=number,
        time=frame.time,
        revision=revision,
        characters={
            name: character_state(cast, character, eye_offsets.get(name, NO_OFFSET), sounds)
            for name, character in frame.characters.items()
        },
        light=dict(frame.light),
        light_call=call_state(frame.light_call),
        framing=dict(frame.framing),
        framing_call=call_state(frame.framing_call),
        gaze_points=dict(frame.gaze_points),
        black=frame.black,
        black_goal=frame.black_goal,
        memories=list(frame.memories),
        note=notes.note,
        began=notes.began,
        cues=cues,
    )


def preview_state(cast: Playable, frame: SceneFrame, air: State, looked_at: CueName | None) -> State:
    """The complete state of the preview: what is not of its frame is as on air, and so are panics and homes, which play
    there alone.

    cast: what plays; frame: of the preview; air: the state at that time; looked_at: the cue in preview.
    """
    notes = ShowNotes(air.note, air.began)
    state = state_of(cast, frame, epoch=air.epoch, number=air.number, revision=air.revision, notes=notes, cues=air.cues)
    characters = {name: _with_panics(each, air.characters.get(name)) for name, each in state.characters.items()}
    return msgspec.structs.replace(state, time=air.time, characters=characters, bus="preview", looked_at=looked_at)


def _with_panics(state: CharacterState, air: CharacterState | None) -> CharacterState:
    if air is None:
        return state
    home = {name: getattr(air, name) for name in ("panics", "home_face", "home_seconds", "home_next")}
    return msgspec.structs.replace(state, **home)


def character_state(
    cast: Playable, character: CharacterFrame, eye_offset: EyeOffset, sounds: FindSound | None = None
) -> CharacterState:
    """The complete state of a character; `eyes` and `gaze_lids` are what the gaze makes of it. cast: what plays;
    eye_offset: what is added to the eyes; sounds: as of `state_of`."""
    frame = character.frame
    place = character.place
    channels = saturate(cast.expressions, frame, channels_of(cast.expressions, frame))
    return CharacterState(
        faces=dict(frame.faces),
        expressions=dict(frame.expressions),
        channels=dict(frame.channels),
        head=(frame.head.yaw, frame.head.pitch, frame.head.roll),
        gaze=(frame.gaze.yaw, frame.gaze.pitch),
        eyes=eye_offset.add_to(_eyes(cast, frame, channels), frame.time),
        added=added_to(frame.channels, channels),
        face_call=call_state(frame.face_call),
        expression_call=call_state(frame.expression_call),
        face_fader=frame.face_fader,
        expression_fader=frame.expression_fader,
        panics=frame.panics,
        **_home(frame),
        clips=[_clip_state(clip, sounds) for clip in frame.clips],
        springs={check_spring(name): amount for name, amount in frame.springs.items()},
        complexion=[*frame.complexion, frame.drops] if any(frame.complexion) else [],
        folds=frame.folds,
        skin={check_skin_fader(name): amount for name, amount in frame.skin.items()},
        **_layers(frame),
        motion=None if frame.motion is None else _motion_state(frame.motion),
        label=character.label,
        place=Place(place.x, place.depth, place.size, place.turn),
        presence=character.presence,
        leaves=character.leaves,
        regions={region: dict(mix) for region, mix in frame.regions.items()},
        region_calls={region: call_state_of(status) for region, status in frame.region_calls.items()},
        macros={name: MacroState(macro.value, macro.share) for name, macro in frame.macros.items()},
        pads={name: PadPointState(list(point.place), point.plays) for name, point in frame.pads.items()},
        figure=None if frame.figure is None else figure_state(frame.figure),
        idle=frame.idle,
    )


def figure_state(figure: FigureFrame) -> FigureState:
    """A figure on the wire."""
    return FigureState(
        poses=dict(figure.poses),
        regions={region: dict(mix) for region, mix in figure.regions.items()},
        bodies=dict(figure.bodies),
        pose_call=call_state(figure.pose_call),
        region_calls={region: call_state_of(status) for region, status in figure.region_calls.items()},
        body_call=call_state(figure.body_call),
        fader=figure.fader,
        tracked=None if figure.tracked is None else TrackedState(list(figure.tracked.shares), figure.tracked.pose),
    )


def _eyes(cast: Playable, frame: Frame, channels: Mapping[str, float]) -> Angles:
    """As the eyeballs stand: what shows around the eyes turns them, and channels do."""
    return eye_turns(cast.expressions, mix_in("eyes", frame.expressions, frame.regions), channels)


def call_state(status: CallStatus | None) -> CallState | None:
    """The call on the wire; None when none runs."""
    return None if status is None else call_state_of(status)


def call_state_of(status: CallStatus) -> CallState:
    """A running call on the wire."""
    return CallState(**{**vars(status), "start": dict(status.start)})


def _home(frame: Frame) -> dict[str, Any]:
    """What a state tells of the home face and of speech, by field."""
    said = frame.speech
    speech = None if said is None else SpeechState(**{**vars(said), "keys": list(said.keys)})
    home = {"home_face": frame.home.face, "home_seconds": frame.home.seconds, "home_next": frame.home_next}
    return {**home, "speech": speech, "spoken": frame.spoken}


def _clip_state(clip: ClipStatus, sounds: FindSound | None) -> ClipState:
    fields = {**vars(clip), "missing": list(clip.missing)}
    key = sounds(clip.sound) if clip.sound and sounds is not None else clip.sound
    fields["sound"] = key
    if key is None:
        fields |= {"sound": "", "heard": 0.0, "turn": 0, "silent": "its sound is not there any more"}
    return ClipState(**fields)


def _layers(frame: Frame) -> dict[str, Any]:
    """What a state tells of layers, by field."""
    layers = {layer: _layer_state(status) for layer, status in frame.layers.items()}
    return {"layers": layers, "held": None if frame.held is None else _held_state(frame.held)}


@lru_cache(maxsize=64)
def _motion_state(settings: MotionSettings) -> MotionState:
    return MotionState(**{**vars(settings), "target": GazeTargetState(**vars(settings.target))})


def _layer_state(status: LayerStatus) -> LayerState:
    strongest = dict(status.strongest)
    sources = [LayerSource(source.source, source.trust, list(source.parts)) for source in status.sources]
    return LayerState(list(status.influence), status.on, status.trust, status.source, status.share, strongest, sources)


def _held_state(held: Held) -> HeldState:
    head = held.head
    gaze = held.gaze
    return HeldState(dict(held.channels), (head.yaw, head.pitch, head.roll), (gaze.yaw, gaze.pitch))


def added_to(channels: Mapping[str, float], effective: Mapping[str, float]) -> dict[str, float]:
    """What is added to the channels, name by name. effective: their weights with it."""
    if effective == channels:  # nearly always
        return {}
    added = {name: weight - channels.get(name, 0.0) for name, weight in effective.items()}
    return {name: weight for name, weight in added.items() if weight}


def names_on_air(state: State) -> tuple[frozenset[str], frozenset[str]]:
    """The faces and the expressions (channels are expressions too) that any character has on air or called."""
    faces = set[str]()
    expressions = set[str]()
    for character in state.characters.values():
        faces.update(character.faces)
        expressions.update(character.expressions, character.channels, character.added, *character.regions.values())
        faces.update(_called(character.face_call))
        expressions.update(_called(character.expression_call))
        expressions.update(call.target for call in character.region_calls.values())
    return frozenset(faces), frozenset(expressions)


def _called(call: CallState | None) -> tuple[str, ...]:
    return () if call is None else (call.target,)
