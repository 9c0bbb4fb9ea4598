"""The handles as pages fetch them are the head's."""

from __future__ import annotations

import msgspec

from omote.edit.compute.welcome import handles_asset
from omote.edit.protocol.messages import HandlesAsset
from omote.model.recipes.face_handles import Handle, default_handles
from tests import synthetic


def test_rows_labels_and_mirror_images_come_back_from_the_wire() -> None:
    space = synthetic.space()
    asset = msgspec.msgpack.decode(msgspec.msgpack.encode(handles_asset(space)), type=HandlesAsset)
    found = zip(asset.labels, asset.points, asset.mirror, strict=True)
    assert tuple(Handle(label, row, mirror) for label, row, mirror in found) == default_handles(space)
