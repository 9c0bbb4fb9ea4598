"""A character's state on the wire as a frame of the engine."""

from __future__ import annotations

import msgspec

from omote.model.space.complexion import PALE, Complexion
from omote.perform.frame import (
    CallStatus,
    ClipStatus,
    FigureFrame,
    Frame,
    Gaze,
    GazeTarget,
    Head,
    Held,
    Home,
    LayerStatus,
    MacroStatus,
    MotionSettings,
    PadStatus,
    SourceStatus,
    SpeechStatus,
    TrackedPose,
)
from omote.show.objects.state import (
    CallState,
    CharacterState,
    FigureState,
    HeldState,
    LayerState,
    MotionState,
    SpeechState,
    State,
)


def frame_in(state: State, character: CharacterState) -> Frame:
    """The frame of a character of a state, with the scene's light: what `Performer.advance` gave on the server."""
    return Frame(
        faces=character.faces,
        expressions=character.expressions,
        channels=character.channels,
        head=Head(*character.head),
        gaze=Gaze(*character.gaze),
        time=state.time,
        face_call=call_status(character.face_call),
        expression_call=call_status(character.expression_call),
        face_fader=character.face_fader,
        expression_fader=character.expression_fader,
        light=state.light,
        light_call=call_status(state.light_call),
        home=Home(character.home_face, character.home_seconds),
        home_next=character.home_next,
        panics=character.panics,
        regions=character.regions,
        region_calls={region: call_status_of(call) for region, call in character.region_calls.items()},
        layers={layer: layer_status(layer_state) for layer, layer_state in character.layers.items()},
        held=None if character.held is None else held_by_hands(character.held),
        speech=None if character.speech is None else speech_status(character.speech),
        spoken=character.spoken,
        motion=None if character.motion is None else motion_settings(character.motion),
        clips=tuple(
            ClipStatus(**{**msgspec.structs.asdict(clip), "missing": tuple(clip.missing)}) for clip in character.clips
        ),
        macros={name: MacroStatus(macro.value, macro.share) for name, macro in character.macros.items()},
        pads={name: PadStatus(tuple(point.place), point.plays) for name, point in character.pads.items()},
        springs={str(name): amount for name, amount in character.springs.items()},
        complexion=Complexion(*character.complexion[:6]) if character.complexion else PALE,
        drops=character.complexion[6] if character.complexion else 0.0,
        folds=character.folds,
        skin={str(name): amount for name, amount in character.skin.items()},
        figure=None if character.figure is None else figure_frame_of(character.figure),
        idle=character.idle,
    )


def figure_frame_of(figure: FigureState) -> FigureFrame:
    """A figure of the wire as the engine's."""
    return FigureFrame(
        poses=figure.poses,
        regions=figure.regions,
        bodies=figure.bodies,
        pose_call=call_status(figure.pose_call),
        region_calls={region: call_status_of(call) for region, call in figure.region_calls.items()},
        body_call=call_status(figure.body_call),
        fader=figure.fader,
        tracked=tracked_of(figure),
    )


def tracked_of(figure: FigureState) -> TrackedPose | None:
    """The tracked body of a figure of the wire as the engine's."""
    return None if figure.tracked is None else TrackedPose(tuple(figure.tracked.shares), figure.tracked.pose)


def speech_status(speech: SpeechState) -> SpeechStatus:
    """What is said, on the wire, as the engine's."""
    return SpeechStatus(**{**msgspec.structs.asdict(speech), "keys": tuple(speech.keys)})


def motion_settings(motion: MotionState) -> MotionSettings:
    """What is set of the automatic motion, on the wire, as the engine's."""
    target = GazeTarget(**msgspec.structs.asdict(motion.target))
    return MotionSettings(**{**msgspec.structs.asdict(motion), "target": target})


def layer_status(layer: LayerState) -> LayerStatus:
    """A layer of the wire as the engine's."""
    sources = tuple(SourceStatus(feeding.source, feeding.trust, tuple(feeding.parts)) for feeding in layer.sources)
    return LayerStatus(
        tuple(layer.influence), layer.on, layer.trust, layer.source, layer.share, layer.strongest, sources
    )


def held_by_hands(held: HeldState) -> Held:
    """What hands hold, on the wire, as the engine's."""
    return Held(held.channels, Head(*held.head), Gaze(*held.gaze))


def call_status(call: CallState | None) -> CallStatus | None:
    """A running call of the wire as the engine's; None where none runs."""
    return None if call is None else call_status_of(call)


def call_status_of(call: CallState) -> CallStatus:
    """A running call of the wire as the engine's."""
    return CallStatus(**msgspec.structs.asdict(call))
