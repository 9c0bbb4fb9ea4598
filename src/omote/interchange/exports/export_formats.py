"""The formats of exported faces, a function each: a face of the cast and what it wears, as files."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from pathlib import Path

from omote import builtin
from omote.interchange.avatar.export_vrm import vrm_bytes
from omote.interchange.avatar.vrm_licence import Credit
from omote.interchange.export_deltas import encode_deltas, measure_deltas
from omote.interchange.export_face import ExportContext, Meshes, build_scene, named_compound_meshes
from omote.interchange.exports.obj_writer import obj_files, obj_folder, require_single
from omote.interchange.exports.usd_writer import NEEDS_USD, check_usd, has_usd, usd_files
from omote.interchange.figures.figure_scene import build_figure_scene
from omote.interchange.formats.file_names import GLB, NUMBERS, OBJ, USD, VRM
from omote.interchange.formats.glb_rig import INFLUENCES, glb_of_rig
from omote.interchange.formats.glb_writer import ExportScene, glb_bytes
from omote.model.body.figure_space import BONES_OF_A_ROW
from omote.model.cast import Cast
from omote.perform.figures.figure_axes import FACES_OWN
from omote.perform.limits import check_known

Files = dict[str, bytes]
"""The bytes of files, by their paths from the folder that they are written into; the first is the one that is named."""
Encode = Callable[[ExportScene, str], Files]
"""Encodes a scene under a name without an ending."""

OBJ_FOLDER = "obj"
FORMATS = ("glb", "vrm", "usd", "usdc", "usda", "usdz", "obj", "npz", "csv")
"""What `--format` knows; usd is usdc, obj a folder of shapes for each face."""


def _glb(scene: ExportScene, stem: str) -> Files:
    return {f"{stem}{GLB}": glb_bytes(scene) if scene.rig is None else glb_of_rig(scene, scene.rig)}


SCENES: Mapping[str, Encode] = {
    GLB: _glb,
    OBJ: obj_files,
    OBJ_FOLDER: obj_folder,
    **{suffix: partial(usd_files, suffix=suffix) for suffix in USD},
}
"""The formats that hold a head, by the ending of their files; a folder of OBJ has none."""


def find_kind(name: str, /) -> str:
    """The kind that `encode_face` writes for a name of `--format`; ValueError for another name."""
    if name.lower() not in FORMATS:
        raise ValueError(f"there is no format {name!r}; give one of {', '.join(FORMATS)}")
    return {"obj": OBJ_FOLDER, "usd": ".usdc"}.get(name.lower(), f".{name.lower()}")


def check_kind(kind: str, credit: Credit | None = None, /) -> None:
    """Refuses a kind that cannot be written here: ValueError that says what to install, or to say of it.

    kind: an ending; credit: of a VRM.
    """
    if kind in USD:
        check_usd()
    if kind == VRM and credit is None:
        Credit(())  # says what is missing


def unwritable_kinds() -> dict[str, str]:
    """The endings that cannot be written here, and what to install; packages are looked for, not loaded."""
    return {} if has_usd() else dict.fromkeys(USD, NEEDS_USD)


def check_count(kind: str, expressions: Sequence[str], /) -> None:
    """Refuses more expressions than a kind can hold, by ValueError."""
    if kind == OBJ:
        require_single(expressions)


def check_body(cast: Cast, kind: str, body: str, /) -> None:
    """Refuses a figure in a kind without a skeleton, and a body that is not in the cast, by ValueError. body: its name,
    `own` for each face's, "" for heads alone."""
    if body and kind not in (GLB, VRM, *USD):
        raise ValueError(f"a figure is written as GLB, VRM or USD, which have a skeleton; {kind} has none")
    if body not in ("", FACES_OWN):
        check_known(body, cast.bodies, "body")


def encode_face(
    context: ExportContext,
    face: str,
    poses: Iterable[tuple[str, Meshes]],
    kind: str,
    stem: str,
    /,
    *,
    hair: bool = True,
    credit: Credit | None = None,
    body: str = "",
) -> Files:
    """Encodes a face of the cast wearing each of some poses (`named_compound_meshes`, by name) as files named STEM.

    kind: an ending (.glb, .usdc, .obj, .npz), or OBJ_FOLDER; credit: of a VRM. ValueError where that cannot be.

    context, face: of the cast; stem: of the files' names; hair: whether it comes along; body: of a figure: a body's
    name, or `own` for the face's; "" for the head alone.
    """
    name = f"{stem}{kind}"
    check_body(context.cast, kind, body)
    if kind in NUMBERS:
        return {name: encode_deltas(measure_deltas(context.cast, face, poses), Path(name))}
    if kind == VRM:
        own = context.cast.faces.get(face) is not builtin.load_cast().faces.get(face)
        return {name: vrm_bytes(context, face, poses, credit or Credit(()), own=own, hair=hair, body=body)}
    if body:
        most = INFLUENCES if kind == GLB else BONES_OF_A_ROW
        return SCENES[kind](build_figure_scene(context, face, body, poses, hair=hair, influences=most), stem)
    return SCENES[kind](build_scene(context, face, poses, hair=hair, drawn=kind not in (OBJ, OBJ_FOLDER)), stem)


def pack_files(files: Files, /) -> bytes:
    """Files as one that is downloaded: the only one as it is, several in a ZIP, the same bytes for the same files."""
    if len(files) == 1:
        return next(iter(files.values()))
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            archive.writestr(zipfile.ZipInfo(name), data, zipfile.ZIP_DEFLATED)
    return packed.getvalue()


def bake_face(
    context: ExportContext,
    face: str,
    expressions: Iterable[str],
    kind: str,
    stem: str,
    /,
    *,
    hair: bool = True,
    credit: Credit | None = None,
    body: str = "",
) -> Files:
    """Computes what a face of the cast wears, by the names of expressions, and encodes it as `encode_face` does.

    context, face, expressions: by name; kind, stem, hair, credit, body: as of `encode_face`.
    """
    poses = ((name, named_compound_meshes(context.cast, face, name)) for name in expressions)
    return encode_face(context, face, poses, kind, stem, hair=hair, credit=credit, body=body)
