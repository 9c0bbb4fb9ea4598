"""Parses untrusted glTF files (.glb, .gltf, .vrm) into one scan: every mesh that a viewer shows, at rest, joined."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.interchange.formats.file_content import describe_content
from omote.interchange.formats.gltf_accessors import node_places, split_glb
from omote.interchange.formats.gltf_document import parse_document_as
from omote.interchange.scans.atlas import Picture, join_textures
from omote.interchange.scans.companions import Companions
from omote.interchange.scans.gltf.gltf_pieces import ScenePiece, SceneReader
from omote.interchange.scans.gltf.gltf_scene import SceneDocument, shown_nodes
from omote.interchange.scans.gltf.gltf_textures import material_pictures, read_uri
from omote.interchange.scans.scan_parts import LARGEST, MOST_NUMBERS, Values, make_scan, refuse_many, weld_scan
from omote.model.fitting.scan import Scan

_COMPRESSED = ("KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression")


def read_gltf(data: bytes, beside: Companions, /) -> Scan:
    """The scan in a glTF file, binary or text; beside: reads the buffers and pictures that lie beside it.

    ValueError for an invalid file.
    """
    refuse_many(len(data), "bytes", LARGEST)
    text, binary = (data, b"") if data.lstrip()[:1] == b"{" else split_glb(data)
    document = parse_document_as(SceneDocument, text)
    squeezed = [name for name in document.extensions_required if name in _COMPRESSED]
    if squeezed:
        raise ValueError(f"the file is compressed ({squeezed[0]}); export it without compression")
    buffers = _buffers(document, binary, beside)
    reader = SceneReader(document, buffers)
    places, shown = node_places(document), shown_nodes(document)
    reader.refuse_costly([document.nodes[at] for at in places if at in shown])
    pieces = [piece for at in places if at in shown for piece in reader.pieces(at, places)]
    if not pieces:
        raise ValueError(f"the file shows no mesh of triangles ({describe_content(data)}); export the head as a mesh")
    return _join(pieces, material_pictures(document, reader, beside))


def _buffers(document: SceneDocument, binary: bytes, beside: Companions) -> list[bytes]:
    found = []
    for place, buffer in enumerate(document.buffers[:256]):
        body = binary if buffer.uri is None and place == 0 else read_uri(buffer.uri or "", beside)
        if body is None:
            name = (buffer.uri or f"buffer {place}")[-80:]
            raise ValueError(f"{name!r}, which holds its numbers, does not lie beside it; export one .glb of all")
        if buffer.byte_length > len(body):
            raise ValueError(
                f"buffer {place} has {buffer.byte_length} bytes, and the file holds {len(body)}; export it anew"
            )
        found.append(body)
    return found


def _join(pieces: list[ScenePiece], pictures: list[Picture]) -> Scan:
    """One scan of all pieces, doubled points joined."""
    begins = np.cumsum([0, *(len(piece.points) for piece in pieces)])
    points = np.concatenate([piece.points for piece in pieces])
    triangles = np.concatenate([piece.triangles + begin for piece, begin in zip(pieces, begins[:-1], strict=True)])
    of = np.repeat([piece.material for piece in pieces], [len(piece.triangles) for piece in pieces])
    texcoords = np.concatenate([_texcoords(piece)[piece.triangles] for piece in pieces])
    if (of < 0).any():  # what has no material is grey in the picture of all
        of = np.where(of < 0, len(pictures), of)
    texture, moved = join_textures([*pictures, None], texcoords, of) if len(of) else (None, None)
    return weld_scan(make_scan(points, triangles, _colours(pieces), texture, moved, _shapes(pieces, begins)))


def _texcoords(piece: ScenePiece) -> Values:
    return np.zeros((len(piece.points), 2)) if piece.texcoords is None else piece.texcoords


def _colours(pieces: list[ScenePiece]) -> NDArray[np.uint8] | None:
    """The colours of all points, white where a piece has none; None where no piece has any."""
    if all(piece.colours is None for piece in pieces):
        return None
    return np.concatenate(
        [np.full((len(each.points), 3), 255, np.uint8) if each.colours is None else each.colours for each in pieces]
    )


def _shapes(pieces: list[ScenePiece], begins: NDArray[np.int64]) -> dict[str, Values]:
    """The targets of all pieces by name; a name in several pieces moves them together, as programs play it."""
    names = dict.fromkeys(name for piece in pieces for name in piece.moves)
    refuse_many(3 * int(begins[-1]) * len(names), "numbers of morph targets", MOST_NUMBERS)
    shapes = {name: np.zeros((int(begins[-1]), 3)) for name in names}
    for piece, begin in zip(pieces, begins[:-1], strict=True):
        for name, moves in piece.moves.items():
            shapes[name][begin : begin + len(moves)] = moves
    return shapes
