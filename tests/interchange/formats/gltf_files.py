"""glTF documents made of arrays, for tests of what stands in them and how."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.interchange.scans import scan_samples as samples

Json = dict[str, Any]
KINDS = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}
COMPONENTS = {"i1": 5120, "u1": 5121, "i2": 5122, "u2": 5123, "u4": 5125, "f4": 5126}


class Arrays:
    """Arrays as accessors of one buffer; `document` and `body` are the file's."""

    def __init__(self) -> None:
        self.body = b""
        self.document: Json = {"asset": {"version": "2.0"}, "accessors": [], "bufferViews": [], "buffers": [{}]}

    def add(self, values: NDArray[Any], **said: Any) -> int:
        """The number of the accessor of an array (n, columns), in its own type; said: what else the accessor says."""
        values = np.ascontiguousarray(values)
        columns = values.shape[1] if values.ndim > 1 else 1
        views, accessors = self.document["bufferViews"], self.document["accessors"]
        views.append({"buffer": 0, "byteOffset": len(self.body), "byteLength": values.nbytes})
        kind = {"componentType": COMPONENTS[values.dtype.str[1:]], "type": KINDS[columns], "count": len(values)}
        accessors.append({"bufferView": len(views) - 1, **kind, **said})
        self.body += values.tobytes() + b"\0" * (-values.nbytes % 4)
        self.document["buffers"][0]["byteLength"] = len(self.body)
        return len(accessors) - 1

    def written(self, **said: Any) -> bytes:
        """The file; said: what else the document says."""
        return samples.write_gltf(self.document | said, self.body)


def ball_file(
    *, targets: Mapping[str, NDArray[np.float64]] | None = None, attributes: Mapping[str, NDArray[Any]] | None = None,
    mesh: Json | None = None, nodes: list[Json] | None = None, points: NDArray[Any] | None = None, **said: Any,
) -> bytes:  # fmt: skip
    """The ball of the samples, one mesh with indices.

    targets (n, 3) by name, attributes by theirs; mesh: what else it says; nodes: in place of the one that shows it;
    points: in place of the ball's; said: what else the document says, its first material is the ball's.
    """
    ball, triangles = samples.ball()
    arrays = Arrays()
    primitive: Json = {"attributes": {"POSITION": arrays.add((ball if points is None else points).astype("<f4"))}}
    primitive["indices"] = arrays.add(triangles.reshape(-1).astype("<u2"))
    moves = targets or {}
    primitive["targets"] = [{"POSITION": arrays.add(move.astype("<f4"))} for move in moves.values()]
    for name, values in (attributes or {}).items():
        primitive["attributes"][name] = arrays.add(values)
    if "materials" in said:
        primitive["material"] = 0
    whole = {"primitives": [primitive], "extras": {"targetNames": [*moves]}} | (mesh or {})
    return arrays.written(nodes=nodes or [{"mesh": 0}], meshes=[whole], **said)
