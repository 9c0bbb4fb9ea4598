"""The handles of the face editor as pages fetch them."""

from __future__ import annotations

from omote.edit.protocol.messages import HandlesAsset
from omote.model.recipes.face_handles import default_handles
from omote.model.space.parameter_space import ParameterSpace


def handles_asset(space: ParameterSpace, /) -> HandlesAsset:
    """The handles of a head by feature; what they do to a face a page works out itself (web/.../canvas/warp.ts)."""
    handles = default_handles(space)
    return HandlesAsset(
        points=[handle.row for handle in handles],
        labels=[handle.label for handle in handles],
        mirror=[handle.mirror for handle in handles],
    )
