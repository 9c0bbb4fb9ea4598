"""Omote plays faces live: any face wears any expression, and both change at any instant."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from omote.builtin import load_cast as load_cast
    from omote.builtin.own_face import fit as fit
    from omote.builtin.own_face import fit_photographs as fit_photographs
    from omote.builtin.random_faces import add_random_faces as add_random_faces
    from omote.client.connect import connect as connect
    from omote.client.connect import connect_async as connect_async
    from omote.interchange.formats.cue_toml import read_cues as read_cues
    from omote.interchange.formats.cue_toml import write_cues as write_cues
    from omote.interchange.formats.sculpt_toml import read_sculpt as read_sculpt
    from omote.model.action_units import action_units as action_units
    from omote.model.cast import Cast as Cast
    from omote.model.controls.control_net import ControlNet as ControlNet
    from omote.model.extraction.extract import extract as extract
    from omote.model.fitting.fit_face import Fit as Fit
    from omote.model.fitting.photographs.photograph import Photograph as Photograph
    from omote.model.fitting.photographs.photograph_fit import PhotographFit as PhotographFit
    from omote.model.fitting.scan import Scan as Scan
    from omote.model.fitting.take_expressions import take_expressions as take_expressions
    from omote.model.sculpting.caricature import caricature as caricature
    from omote.model.sculpting.regions import regional as regional
    from omote.model.sculpting.sculpt import Sculpt as Sculpt
    from omote.model.sculpting.sculpt import sculpted as sculpted
    from omote.model.space.expression import Expression as Expression
    from omote.model.space.face import Face as Face
    from omote.model.space.gain import Gain as Gain
    from omote.model.space.parameter_space import ParameterSpace as ParameterSpace
    from omote.model.transfer.compound import compound as compound
    from omote.perform.blending.evaluate import evaluate as evaluate
    from omote.perform.blending.evaluate import evaluate_parts as evaluate_parts
    from omote.perform.clips.clip import Clip as Clip
    from omote.perform.clips.clip import Lane as Lane
    from omote.perform.cues.cue import Cue as Cue
    from omote.perform.cues.cue import Move as Move
    from omote.perform.cues.cue_action import CueAction as CueAction
    from omote.perform.cues.cue_player import CuePlayer as CuePlayer
    from omote.perform.figures.evaluate_figure import evaluate_figure as evaluate_figure
    from omote.perform.mappings.mapping import HalfBelow as HalfBelow
    from omote.perform.mappings.mapping import MacroCondition as MacroCondition
    from omote.perform.mappings.mapping import MacroMapping as MacroMapping
    from omote.perform.mappings.mapping import MacroTarget as MacroTarget
    from omote.perform.pads.blend_space import Pad as Pad
    from omote.perform.pads.blend_space import PadLook as PadLook
    from omote.perform.performer import Performer as Performer
    from omote.perform.scene.scene import Scene as Scene
    from omote.server.headless.picture_renderer import Renderer as Renderer
    from omote.server.headless.picture_renderer import render as render
    from omote.server.headless.stimulus_run import draw_stimuli as draw_stimuli
    from omote.server.sandbox.voices import speak as speak
    from omote.stage_data.full_cast import read_show as read_show
    from omote.stage_data.pose_parser import parse_pose as parse_pose

__version__ = "0.1.0"

# Loaded when first used: `omote --help` and the supervisor need none of them, and Numba alone takes a third of a
# second.
_HOMES = {
    "Cast": "omote.model.cast",
    "Clip": "omote.perform.clips.clip",
    "ControlNet": "omote.model.controls.control_net",
    "Cue": "omote.perform.cues.cue",
    "CueAction": "omote.perform.cues.cue_action",
    "CuePlayer": "omote.perform.cues.cue_player",
    "Expression": "omote.model.space.expression",
    "ExtractedExpression": "omote.model.extraction.extracted_expression",
    "Face": "omote.model.space.face",
    "Fit": "omote.model.fitting.fit_face",
    "Photograph": "omote.model.fitting.photographs.photograph",
    "PhotographFit": "omote.model.fitting.photographs.photograph_fit",
    "Gain": "omote.model.space.gain",
    "HalfBelow": "omote.perform.mappings.mapping",
    "Lane": "omote.perform.clips.clip",
    "MacroCondition": "omote.perform.mappings.mapping",
    "MacroMapping": "omote.perform.mappings.mapping",
    "MacroTarget": "omote.perform.mappings.mapping",
    "Move": "omote.perform.cues.cue",
    "Pad": "omote.perform.pads.blend_space",
    "PadLook": "omote.perform.pads.blend_space",
    "ParameterSpace": "omote.model.space.parameter_space",
    "Performer": "omote.perform.performer",
    "Renderer": "omote.server.headless.picture_renderer",
    "Scan": "omote.model.fitting.scan",
    "Scene": "omote.perform.scene.scene",
    "Sculpt": "omote.model.sculpting.sculpt",
    "action_units": "omote.model.action_units",
    "add_random_faces": "omote.builtin.random_faces",
    "caricature": "omote.model.sculpting.caricature",
    "compound": "omote.model.transfer.compound",
    "connect": "omote.client.connect",
    "connect_async": "omote.client.connect",
    "draw_stimuli": "omote.server.headless.stimulus_run",
    "evaluate": "omote.perform.blending.evaluate",
    "evaluate_figure": "omote.perform.figures.evaluate_figure",
    "evaluate_parts": "omote.perform.blending.evaluate",
    "extract": "omote.model.extraction.extract",
    "fit": "omote.builtin.own_face",
    "fit_photographs": "omote.builtin.own_face",
    "load_cast": "omote.builtin",
    "parse_pose": "omote.stage_data.pose_parser",
    "read_cues": "omote.interchange.formats.cue_toml",
    "read_sculpt": "omote.interchange.formats.sculpt_toml",
    "read_show": "omote.stage_data.full_cast",
    "regional": "omote.model.sculpting.regions",
    "render": "omote.server.headless.picture_renderer",
    "sculpted": "omote.model.sculpting.sculpt",
    "speak": "omote.server.sandbox.voices",
    "take_expressions": "omote.model.fitting.take_expressions",
    "write_cues": "omote.interchange.formats.cue_toml",
}

__all__ = [*_HOMES]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'omote' has no attribute {name!r}; it has {', '.join(_HOMES)}")
    return getattr(import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    return [*__all__, "__version__"]
