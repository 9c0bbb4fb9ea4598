"""Reads a skinned glTF binary by nothing but the specification: nodes, skin, weights, animations."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from tests.interchange.formats.scenes import taken_apart

KINDS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4, "MAT4": 16}
NUMBERS = {5121: "u1", 5123: "<u2", 5125: "<u4", 5126: "<f4"}


@dataclass(frozen=True, eq=False)
class SkinnedFile:
    """document, binary: of the file."""

    document: dict[str, Any]
    binary: bytes

    @classmethod
    def of(cls, data: bytes) -> SkinnedFile:
        """The file of these bytes."""
        return cls(*taken_apart(data))

    def values(self, place: int) -> np.ndarray:
        """The numbers of an accessor that is not sparse, (count, columns)."""
        entry = self.document["accessors"][place]
        columns = KINDS[entry["type"]]
        view = self.document["bufferViews"][entry["bufferView"]]
        start = view["byteOffset"] + entry.get("byteOffset", 0)
        kind = np.dtype(NUMBERS[entry["componentType"]])
        found = np.frombuffer(self.binary, kind, entry["count"] * columns, start).reshape(-1, columns)
        return found / np.iinfo(kind).max if entry.get("normalized") else found

    @property
    def nodes(self) -> list[dict[str, Any]]:
        """All nodes."""
        return list(self.document["nodes"])

    def node(self, name: str) -> int:
        """The place of a node."""
        return [node["name"] for node in self.nodes].index(name)

    def worlds(self, animation: str | None = None) -> np.ndarray:
        """Where all nodes are (n, 4, 4), at rest or in an animation's first instant."""
        local = np.tile(np.eye(4), (len(self.nodes), 1, 1))
        for matrix, node in zip(local, self.nodes, strict=True):
            matrix[:3, 3] = node.get("translation", (0.0, 0.0, 0.0))
        for moved in self.document.get("animations", []):
            if moved["name"] == animation:
                for channel in moved["channels"]:
                    value = self.values(moved["samplers"][channel["sampler"]]["output"])[0]
                    matrix = local[channel["target"]["node"]]
                    if channel["target"]["path"] == "rotation":
                        matrix[:3, :3] = Rotation.from_quat(value).as_matrix()
                    else:
                        matrix[:3, 3] = value
        found = local.copy()
        pending = [(place, np.eye(4)) for place in self.document["scenes"][0]["nodes"]]
        while pending:
            place, above = pending.pop()
            found[place] = above @ local[place]
            pending += [(child, found[place]) for child in self.nodes[place].get("children", [])]
        return found

    def points(self, mesh: str, animation: str | None = None) -> np.ndarray:
        """Where the vertices of a mesh are (n, 3), on its bones or below its node."""
        place = next(at for at, node in enumerate(self.nodes) if node["name"] == mesh and "mesh" in node)
        node = self.nodes[place]
        attributes = self.document["meshes"][node["mesh"]]["primitives"][0]["attributes"]
        places = self.values(attributes["POSITION"]).astype(np.float64)
        points = np.column_stack([places, np.ones(len(places))])
        worlds = self.worlds(animation)
        if "skin" not in node:
            return np.asarray((points @ worlds[place].T)[:, :3])
        skin = self.document["skins"][node["skin"]]
        inverse = self.values(skin["inverseBindMatrices"]).reshape(-1, 4, 4).swapaxes(1, 2)
        bones = worlds[skin["joints"]] @ inverse
        joints = self.values(attributes["JOINTS_0"]).astype(int)
        weights = self.values(attributes["WEIGHTS_0"])
        return np.asarray(np.einsum("nk,nkab,nb->na", weights, bones[joints], points)[:, :3])
