"""Files of scans in every format, written by hand: a ball with colours and a texture, and pictures."""

from __future__ import annotations

import base64
import io
import json
import struct
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

Values = NDArray[np.float64]
Rows = NDArray[np.int64]

ROWS = 9
COLUMNS = 14
ORDERS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}


def ball() -> tuple[Values, Rows]:
    """A ball of 128 points and 252 triangles, counterclockwise from outside; its points are exact in float32."""
    lat, lon = np.meshgrid(
        np.linspace(0, np.pi, ROWS + 2)[1:-1], np.arange(COLUMNS) * 2 * np.pi / COLUMNS, indexing="ij"
    )
    ring = np.stack([np.sin(lat) * np.cos(lon), np.sin(lat) * np.sin(lon), np.cos(lat)], axis=-1).reshape(-1, 3)
    points = np.concatenate([ring, [[0, 0, 1.0], [0, 0, -1.0]]]).astype(np.float32).astype(np.float64)
    at = np.arange(ROWS * COLUMNS).reshape(ROWS, COLUMNS)
    right = np.roll(at, -1, axis=1)
    sides = np.stack([at[:-1], at[1:], right[1:], right[:-1]], axis=-1).reshape(-1, 4)
    top = np.stack([np.full(COLUMNS, len(ring)), at[0], right[0]], axis=1)
    bottom = np.stack([np.full(COLUMNS, len(ring) + 1), right[-1], at[-1]], axis=1)
    return points, np.concatenate([sides[:, [0, 1, 2]], sides[:, [0, 2, 3]], top, bottom])


def colours() -> NDArray[np.uint8]:
    """A colour for each point of the ball, 0 and 255 among them."""
    points, _ = ball()
    return np.rint((points + 1.0) * 127.5).astype(np.uint8)


def texcoords() -> Values:
    """Texture coordinates (t, 3, 2) of the ball's corners, v down, no two corners of a triangle alike."""
    _, triangles = ball()
    return np.random.default_rng(7).random((len(triangles), 3, 2)).astype(np.float32).astype(np.float64)


def picture(rows: int = 6, columns: int = 5) -> NDArray[np.uint8]:
    """A picture of which no two pixels are alike."""
    at = np.arange(rows * columns).reshape(rows, columns)
    return np.stack([at * 3, 255 - at, at * 7 % 256], axis=-1).astype(np.uint8)


def picture_bytes(kind: str = "PNG", pixels: NDArray[np.uint8] | None = None, **options: Any) -> bytes:
    """A picture as a file."""
    found = io.BytesIO()
    Image.fromarray(picture() if pixels is None else pixels).save(found, kind, **options)
    return found.getvalue()


def write_ply(
    order: str = "ascii", *, coloured: str = "", corners: str = "", cloud: bool = False, quads: bool = False
) -> bytes:
    """The ball as PLY: coloured "uchar" or "float"; corners "face" for texture coordinates of faces."""
    points, triangles = ball()
    fields = [(name, "f4") for name in "xyz"]
    names = {"f4": "float", "u1": "uchar"}
    kind = {"uchar": "u1", "float": "f4", "": ""}[coloured]
    fields += [(name, kind) for name in ("red", "green", "blue")] if coloured else []
    head = ["ply", f"format {order} 1.0", "comment TextureFile head.png", f"element vertex {len(points)}"]
    head += [f"property {names[each]} {name}" for name, each in fields]
    if not cloud:
        head += [f"element face {len(triangles)}", "property list uchar int vertex_indices"]
        head += ["property list uchar float texcoord"] if corners else []
    vertices = np.zeros(len(points), [(name, ORDERS[order] + each) for name, each in fields])
    for at, name in enumerate("xyz"):
        vertices[name] = points[:, at]
    for at, name in enumerate(("red", "green", "blue") if coloured else ()):
        vertices[name] = colours()[:, at] if kind == "u1" else colours()[:, at] / np.float32(255.0)
    faces = (
        []
        if cloud
        else [([*row], uv) for row, uv in zip(triangles.tolist(), texcoords() * [1, -1] + [0, 1], strict=True)]
    )
    if quads:
        faces[0] = ([*faces[0][0], faces[0][0][0]], np.concatenate([faces[0][1], faces[0][1][:1]]))
    return "\n".join([*head, "end_header\n"]).encode() + _ply_body(order, vertices, faces, corners)


def _ply_body(order: str, vertices: Any, faces: list[tuple[list[int], Values]], corners: str) -> bytes:
    if order == "ascii":
        lines = [" ".join(f"{value!r}" for value in row) for row in vertices.tolist()]
        for row, uv in faces:
            lines.append(" ".join(map(str, [len(row), *row, *([uv.size, *uv.ravel().tolist()] if corners else [])])))
        return ("\n".join(lines) + "\n").encode()
    sign = ORDERS[order]
    body = vertices.tobytes()
    for row, uv in faces:
        body += struct.pack(f"{sign}B{len(row)}i", len(row), *row)
        body += struct.pack(f"{sign}B{uv.size}f", uv.size, *uv.ravel()) if corners else b""
    return bytes(body)


def write_stl(*, text: bool = False) -> bytes:
    """The ball as STL."""
    points, triangles = ball()
    if text:
        facets = []
        for corners in points[triangles].tolist():
            lines = "".join(f"vertex {x!r} {y!r} {z!r}\n" for x, y, z in corners)
            facets.append(f"facet normal 0 0 1\nouter loop\n{lines}endloop\nendfacet\n")
        return f"solid ball\n{''.join(facets)}endsolid ball\n".encode()
    rows = np.zeros(len(triangles), [("n", "<f4", 3), ("c", "<f4", (3, 3)), ("r", "<u2")])
    rows["c"] = points[triangles]
    return b"solid, yet binary".ljust(80) + struct.pack("<I", len(triangles)) + rows.tobytes()


def write_obj(*, backwards: bool = False, coloured: bool = False, textured: bool = True) -> bytes:
    """The ball as OBJ with a material; backwards: corners counted from the last one."""
    points, triangles = ball()
    tones = colours() / 255.0
    lines = ["# a ball", "mtllib ball.mtl", "o ball"]
    for point, tone in zip(points.tolist(), tones.tolist(), strict=True):
        lines.append("v " + " ".join(repr(value) for value in (point + tone if coloured else point)))
    if textured:
        lines += [f"vt {u!r} {1 - v!r}" for u, v in texcoords().reshape(-1, 2).tolist()]
    lines += ["vn 0 0 1", "usemtl skin"]
    for at, row in enumerate(triangles.tolist()):
        words = []
        for corner, vertex in enumerate(row):
            v = vertex - len(points) if backwards else vertex + 1
            vt = 3 * at + corner - 3 * len(triangles) if backwards else 3 * at + corner + 1
            words.append(f"{v}/{vt}/1" if textured else f"{v}//1")
        lines.append("f " + " ".join(words))
    return "\r\n".join(lines).encode()


MATERIAL = b"newmtl skin\nKd 1 1 1\nmap_Kd -s 1 1 1 head.png\n"


def write_cloud(separator: str = " ", *, names: str = "", coloured: bool = False) -> bytes:
    """The ball's points as text."""
    points, _ = ball()
    lines = [names] if names else []
    for point, tone in zip(points.tolist(), colours().tolist(), strict=True):
        lines.append(separator.join(repr(value) for value in (point + tone if coloured else point)))
    return "\n".join(lines).encode()


def gltf_document(*, where: str = "binary") -> tuple[dict[str, Any], bytes]:
    """The ball as glTF with doubled corners, a picture, a target and a node that stands elsewhere; its JSON and bytes.

    where: the bytes in the "binary" chunk, as "data" URI, or "beside" the file, with the picture.
    """
    points, triangles = ball()
    corners = points[triangles].reshape(-1, 3)
    stores = [
        ("VEC3", 5126, corners.astype("<f4")),
        ("VEC2", 5126, texcoords().reshape(-1, 2).astype("<f4")),
        ("SCALAR", 5123, np.arange(len(corners), dtype="<u2")),
        ("VEC3", 5126, (corners * [0.0, 0.5, 0.0]).astype("<f4")),
    ]
    views = list[Any]()
    accessors = list[Any]()
    body = b""
    for kind, component, values in stores:
        views.append({"buffer": 0, "byteOffset": len(body), "byteLength": values.nbytes})
        accessors.append({"bufferView": len(accessors), "componentType": component, "type": kind, "count": len(values)})
        body += values.tobytes() + b"\0" * (-values.nbytes % 4)
    png = picture_bytes()
    image: dict[str, Any] = {"uri": "head.png"}
    if where == "binary":
        views.append({"buffer": 0, "byteOffset": len(body), "byteLength": len(png)})
        image = {"bufferView": 4, "mimeType": "image/png"}
        body = body + png
    buffer: dict[str, Any] = {"byteLength": len(body)}
    if where == "data":
        buffer["uri"] = "data:application/octet-stream;base64," + base64.b64encode(body).decode()
        image = {"uri": "data:image/png;base64," + base64.b64encode(png).decode()}
    if where == "beside":
        buffer["uri"] = "ball%201.bin"
    primitive = {
        "attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0, "targets": [{"POSITION": 3}],
    }  # fmt: skip
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"children": [1], "translation": [0, 10, 0]}, {"mesh": 0, "scale": [2, 2, 2]}, {"mesh": 0}],
        "meshes": [{"primitives": [primitive], "extras": {"targetNames": ["jawOpen"]}}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
        "textures": [{"source": 0}],
        "images": [image],
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [buffer],
    }
    return document, body


def write_gltf(document: dict[str, Any], body: bytes, *, binary: bool = True) -> bytes:
    """A document as GLB, or as the text of a .gltf."""
    text = json.dumps(document).encode()
    if not binary:
        return text
    text += b" " * (-len(text) % 4)
    body += b"\0" * (-len(body) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(body), 0x004E4942) + body
    return struct.pack("<III", 0x46546C67, 2, 12 + len(chunks)) + chunks


HEIC = base64.b64decode(
    "AAAAHGZ0eXBoZWljAAAAAG1pZjFoZWljbWlhZgAAAchtZXRhAAAAAAAAACFoZGxyAAAAAAAAAABwaWN0AAAAAAAAAAAAAAAAAAAAADRpbG9j"
    "AAAAAERAAAIAAQAAAAAB7AABAAAAAAAAAEwAAgAAAAACOAABAAAAAAAAACQAAAA4aWluZgAAAAAAAgAAABVpbmZlAgAAAAABAABodmMxAAAA"
    "ABVpbmZlAgAAAQACAABFeGlmAAAAAA5waXRtAAAAAAABAAABB2lwcnAAAADmaXBjbwAAAHZodmNDAQNwAAAAkAAAAAAAHvAA/P34+AAADwNg"
    "AAEAGEABDAH//wNwAAADAJAAAAMAAAMAHroCQGEAAQAqQgEBA3AAAAMAkAAAAwAAAwAeoCCBBZbq5Ka5uAhoMCAAAAMDIAAAAwAhYgABAAZE"
    "AcFzwIkAAAATY29scm5jbHgAAQANAAaAAAAAFGlzcGUAAAAAAAAAQAAAAEAAAAAoY2xhcAAAAEAAAAABAAAAMAAAAAEAAAAAAAAAAv////AA"
    "AAACAAAAEHBpeGkAAAAAAwgICAAAAAlpcm90AwAAABlpcG1hAAAAAAAAAAEAAQaBAgMFhIYAAAAaaXJlZgAAAAAAAAAOY2RzYwACAAEAAQAA"
    "AHhtZGF0AAAASCgBr1j5E5JeKPf/6X9/9zjs+7/3fj836NP5UXRtYBdi/+s3L/AVh/gaQftwWbCFF6/5dXYef5xP9/1QjqoU/o0sFvdCXxnL"
    "PgAAAAZFeGlmAABNTQAqAAAACAABARIAAwAAAAEABgAAAAAAAA=="
)
"""48 x 64 pixels upright, stored lying and turned by its header: red and blue, and green along the right side.
Written by us; what is installed here reads HEIC and does not write it."""
