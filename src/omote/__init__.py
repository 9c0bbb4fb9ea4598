"""Omote plays faces live: any face wears any expression, and both change at any instant."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from omote.builtin import load_cast as load_cast
    from omote.files.sculptfile import read_sculpt as read_sculpt
    from omote.model.cast import Cast as Cast
    from omote.model.compound import compound as compound
    from omote.model.control_net import ControlNet as ControlNet
    from omote.model.expression import Expression as Expression
    from omote.model.extract import extract as extract
    from omote.model.face import Face as Face
    from omote.model.regions import caricature as caricature
    from omote.model.regions import regional as regional
    from omote.model.sculpt import Sculpt as Sculpt
    from omote.model.sculpt import sculpted as sculpted
    from omote.model.space import ParameterSpace as ParameterSpace
    from omote.perform.evaluate import evaluate as evaluate
    from omote.perform.evaluate import evaluate_parts as evaluate_parts
    from omote.perform.performer import Performer as Performer

__version__ = "0.1.0"

# Loaded when first used: `omote --help` and the supervisor need none of them, and Numba alone takes a third of a
# second.
_HOMES = {
    "Cast": "omote.model.cast",
    "ControlNet": "omote.model.control_net",
    "Expression": "omote.model.expression",
    "Face": "omote.model.face",
    "ParameterSpace": "omote.model.space",
    "Performer": "omote.perform.performer",
    "Sculpt": "omote.model.sculpt",
    "caricature": "omote.model.regions",
    "compound": "omote.model.compound",
    "evaluate": "omote.perform.evaluate",
    "evaluate_parts": "omote.perform.evaluate",
    "extract": "omote.model.extract",
    "load_cast": "omote.builtin",
    "read_sculpt": "omote.files.sculptfile",
    "regional": "omote.model.regions",
    "sculpted": "omote.model.sculpt",
}

__all__ = [*_HOMES]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'omote' has no attribute {name!r}; it has {', '.join(_HOMES)}")
    return getattr(import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    return [*__all__, "__version__"]
