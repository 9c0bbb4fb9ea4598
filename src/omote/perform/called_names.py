"""Finds the faces and expressions that people call by what they read: by name, else by label."""

from __future__ import annotations

from omote.perform.figures.figure_axes import FACES_OWN
from omote.perform.name_lookup import find_name
from omote.perform.snapshot import Playable


def find_called(typed: str, kind: str, cast: Playable) -> str:
    """The name of what a person means to call, as `find_name`: the labels of own ones count.

    typed: what was written; kind: "face", "expression", "channel", "pose" or "body"; cast: what can be called.
    ValueError where there is none, and where several could be meant.
    """
    if kind == "face":
        return find_name(typed, cast.faces, kind, cast.face_labels)
    if kind == "body":
        return typed if typed == FACES_OWN else find_name(typed, cast.bodies, kind)
    if kind == "pose":
        return find_name(typed, cast.poses, kind)
    return find_name(typed, cast.expressions, kind, {name: title.label for name, title in cast.titles.items()})
