"""The part of a glTF document that a viewer shows of a head at rest: triangles, materials, textures, skins, scenes."""

from __future__ import annotations

from typing import Any

import msgspec

from omote.interchange.formats.gltf_document import Document, Mesh, Node, Primitive, Whole

TRIANGLES, STRIP, FAN, POINTS = 4, 5, 6, 0
"""Modes of primitives; the others are lines."""


class SurfacePrimitive(Primitive, frozen=True, rename="camel"):
    """A primitive with its triangles and its material."""

    indices: Whole | None = None
    mode: Whole = TRIANGLES
    material: Whole | None = None
    extras: Any = None


class SurfaceMesh(Mesh, frozen=True, rename="camel"):
    """A mesh of such primitives."""

    primitives: list[SurfacePrimitive]  # type: ignore[assignment]


class SkinnedNode(Node, frozen=True, rename="camel"):
    """A node whose mesh a skin may place."""

    skin: Whole | None = None


class Skin(msgspec.Struct, frozen=True, rename="camel"):
    """Joints, and what brings the mesh into the space of each."""

    joints: list[Whole]
    inverse_bind_matrices: Whole | None = None


class TextureInfo(msgspec.Struct, frozen=True, rename="camel"):
    """Which texture, by which set of coordinates."""

    index: Whole
    tex_coord: Whole = 0


class Metallic(msgspec.Struct, frozen=True, rename="camel"):
    """The colour of a material."""

    base_color_texture: TextureInfo | None = None
    base_color_factor: tuple[float, float, float, float] = (1.0, 1.0, 1.0, 1.0)


class Material(msgspec.Struct, frozen=True, rename="camel"):
    """A material."""

    pbr_metallic_roughness: Metallic = Metallic()


class Texture(msgspec.Struct, frozen=True, rename="camel"):
    """A texture: a picture, or one in a format that an extension adds."""

    source: Whole | None = None
    extensions: dict[str, Any] = {}


class Image(msgspec.Struct, frozen=True, rename="camel"):
    """A picture in the file or elsewhere."""

    uri: str | None = None
    buffer_view: Whole | None = None


class SceneRoots(msgspec.Struct, frozen=True, rename="camel"):
    """The nodes that a scene shows, with all below them."""

    nodes: list[Whole] = msgspec.field(default_factory=list)


class SceneDocument(Document, frozen=True, rename="camel"):
    """A document with what a viewer shows."""

    nodes: list[SkinnedNode] = msgspec.field(default_factory=list)  # type: ignore[assignment]
    meshes: list[SurfaceMesh] = msgspec.field(default_factory=list)  # type: ignore[assignment]
    skins: list[Skin] = msgspec.field(default_factory=list)
    materials: list[Material] = msgspec.field(default_factory=list)
    textures: list[Texture] = msgspec.field(default_factory=list)
    images: list[Image] = msgspec.field(default_factory=list)
    scenes: list[SceneRoots] = msgspec.field(default_factory=list)
    scene: Whole = 0


def shown_nodes(document: SceneDocument, /) -> set[int]:
    """The nodes of the scene that viewers show; all where the document has no scenes."""
    if not document.scenes:
        return set(range(len(document.nodes)))
    found, waiting = set[int](), list(document.scenes[min(document.scene, len(document.scenes) - 1)].nodes)
    while waiting:
        at = waiting.pop()
        if at not in found and at < len(document.nodes):
            found.add(at)
            waiting += document.nodes[at].children
    return found
