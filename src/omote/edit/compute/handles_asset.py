"""Serializes the face editor's handles (sculpting points by feature) for pages."""

from __future__ import annotations

from omote.edit.protocol.messages import HandlesAsset
from omote.model.recipes.face_handles import default_handles
from omote.model.space.parameter_space import ParameterSpace


def handles_asset(space: ParameterSpace, /) -> HandlesAsset:
    """The handles of a head by feature; pages compute their effect on a face themselves (warp.ts)."""
    handles = default_handles(space)
    return HandlesAsset(
        points=[handle.row for handle in handles],
        labels=[handle.label for handle in handles],
        mirror=[handle.mirror for handle in handles],
    )
