"""The command `omote export`: faces with expressions into files of other programs."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omote.picture_commands import ShowOption
from omote.terminal import complete_name, exit_on_refusal, say

if TYPE_CHECKING:
    from omote.interchange.export_face import Meshes
    from omote.model.cast import Cast
    from omote.showfile.inspection import Inspection


def export(
    face: Annotated[str, typer.Argument(help="A face of the cast: kaori, dog.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="The file to write: face.glb, face.npz, face.csv.")],
    expressions: Annotated[
        str,
        typer.Option(
            help="arkit, performed, makehuman, omote, own, all, neutral (the face alone), or names, by commas."
        ),
    ] = "arkit",
    hair: Annotated[bool, typer.Option("--hair/--no-hair", help="The face's hair, as ribbons.")] = True,
    show: ShowOption = None,
    force: Annotated[bool, typer.Option("--force", help="Replaces a file that is there.")] = False,
) -> None:
    """Writes a face with expressions: as morph targets (GLB), or as what each moves in numbers (NPZ, CSV)."""
    output = complete_name(output, ".glb")
    found = check_export(output, show, force=force)
    from rich.console import Console  # what is heavy comes after what can be refused without it
    from rich.progress import track

    from omote.builtin import load_cast
    from omote.interchange.export_face import choose_expressions, named_compound_meshes
    from omote.interchange.formats.atomic_file import write_whole
    from omote.stage_data.full_cast import build_full_cast, find_face

    with exit_on_refusal():
        encode = find_encoder(output, hair=hair)
        cast = load_cast()
        cast = cast if found is None else build_full_cast(cast, found.stored, found.contents, say)
        face = find_face(cast, None if found is None else found.stored, face)
        names = choose_expressions(cast, expressions)
        busy = track(names, f"omote: {face}", console=Console(stderr=True), transient=True)
        poses = ((name, named_compound_meshes(cast, face, name)) for name in busy)
        write_whole(output, encode(cast, face, poses))
    what = "morph targets" if output.suffix.lower() == ".glb" else "expressions"
    say(f"{output}: {face}, {what}: {len(names)}, {output.stat().st_size / 1e6:.1f} MB")


def check_export(output: Path, show: Path | None, *, force: bool) -> Inspection | None:
    """What the show file holds, if one is named; ends the command where the export could not be written."""
    from omote.interchange.formats.atomic_file import check_writable, require_free
    from omote.interchange.formats.file_names import check_export_name
    from omote.showfile.inspection import inspect_show

    with exit_on_refusal():
        check_export_name(output)
        check_writable(output)
        require_free(output, force=force)
        return None if show is None else inspect_show(show)


def find_encoder(path: Path, *, hair: bool) -> Callable[[Cast, str, Iterable[tuple[str, Meshes]]], bytes]:
    """What makes the bytes of an exported face, by the file's ending."""
    from omote.builtin import load_mask, load_meshes
    from omote.interchange.export_deltas import encode_deltas, measure_deltas
    from omote.interchange.export_face import ExportContext, build_scene
    from omote.interchange.formats.file_names import GLB
    from omote.interchange.formats.glb_writer import glb_bytes

    if path.suffix.lower() != GLB:
        return lambda cast, face, poses: encode_deltas(measure_deltas(cast, face, poses), path)

    def encode(cast: Cast, face: str, poses: Iterable[tuple[str, Meshes]]) -> bytes:
        return glb_bytes(build_scene(ExportContext(cast, load_meshes(), load_mask()), face, poses, hair=hair))

    return encode
