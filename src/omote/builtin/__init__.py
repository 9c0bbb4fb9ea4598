"""The baked cast: twelve people, five sculpted faces and what they can do, ready to be called.

cast.npz, figures.npz, identity_modes.npz, mask.png and the notice of their origin are written beside this file by
`make bake` (tools/bake.py).
"""

from __future__ import annotations

import functools
import zipfile
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from omote.builtin.binding import PARTS
from omote.builtin.castfile import BakedMesh, cast_of, meshes_of
from omote.builtin.figurefile import figures_of, read_poses
from omote.builtin.limb_channels import with_limb_channels
from omote.model.body.figures import Figures
from omote.model.body.limb_recipe import read_limb_recipes
from omote.model.cast import Cast
from omote.model.fitting.fit_face import PEOPLE
from omote.model.fitting.identity_modes import IdentityModes
from omote.model.fitting.photographs.landmark_table import LandmarkTable

__all__ = [
    "BakedMesh",
    "load_cast",
    "load_figures",
    "load_head_kinds",
    "load_identity_modes",
    "load_mask",
    "load_meshes",
    "read_cast",
]

HERE = Path(__file__).parent
CAST = HERE / "cast.npz"
MASK = HERE / "mask.png"
FIGURES = HERE / "figures.npz"
POSES = HERE / "poses.toml"
LIMB_FIELDS = HERE / "limbs.toml"
NOTICE = HERE / "NOTICE-CC0.md"
IDENTITY_MODES = HERE / "identity_modes.npz"
LANDMARK_TABLE = HERE / "photographs" / "landmark_table.npz"
ANIMALS = ("cat", "dog")
"""From whom of the cast the face of an animal begins."""
_SIGNATURE = b"\x89PNG\r\n\x1a\n"


@functools.cache
def load_cast() -> Cast:
    """The built-in cast: twelve people, five sculpted faces and all they can do, read once.

    Returns
    -------
    Cast
        The same object for every caller; it is frozen. 4278 vertices of skin, 17 faces, 127 expressions, ten of
        which play limb fields of figures alone.

    Raises
    ------
    FileNotFoundError
        Where the cast was not baked; the message says how to.
    ValueError
        Where the file is no cast of this version.

    Examples
    --------
    >>> cast = omote.load_cast()
    >>> [*cast.faces][:3]
    ['generic', 'kaori', 'round']
    >>> cast.expressions["smile"].dtheta.shape
    (4278,)

    References
    ----------
    docs/conventions.md for units and axes; the meshes are CC0, see the notice beside the cast.
    """
    return with_limb_channels(replace(read_cast(CAST), figures=load_figures()))


@functools.cache
def load_meshes() -> tuple[BakedMesh, ...]:
    """The meshes that draw the built-in head: skin, then the parts in the space's order; errors as `load_cast`."""
    try:
        return meshes_of(_arrays(CAST))
    except KeyError as error:
        raise _broken(CAST, error) from error


@functools.cache
def load_figures() -> Figures:
    """The bodies of the built-in cast, one mesh with its heads; errors as `load_cast`."""
    try:
        return figures_of(_arrays(FIGURES), read_poses(POSES.read_bytes()), read_limb_recipes(LIMB_FIELDS.read_bytes()))
    except (KeyError, ValueError) as error:
        raise _broken(FIGURES, error) from error


@functools.cache
def load_mask() -> bytes:
    """The layers of the skin on its texture coordinates, a PNG in which they lie one below the other.

    In the first, red = lips, green = brows, blue = blush, alpha = light that is left (255 = all);
    tools/baking/skin/mask.py says what the others hold. Errors as `load_cast`.
    """
    if not MASK.is_file():
        raise _missing(MASK)
    data = MASK.read_bytes()
    if not data.startswith(_SIGNATURE):
        raise _broken(MASK, ValueError("it is no PNG"))
    return data


@functools.cache
def load_identity_modes() -> IdentityModes:
    """What heads differ by, from 900 random people on the built-in head's topology; errors as `load_cast`."""
    try:
        arrays = _arrays(IDENTITY_MODES)
        space = load_cast().space
        mean = arrays["mean"].astype(np.float64)
        moves = arrays["modes"].astype(np.float64)
    except KeyError as error:
        raise _broken(IDENTITY_MODES, error) from error
    ends = np.cumsum([space.vertex_count, *(len(space.parts[part].points) for part in PARTS)])
    if mean.shape != (ends[-1], 3) or moves.shape[1:] != mean.shape:
        raise _broken(IDENTITY_MODES, ValueError(f"it holds {mean.shape} points; expected ({ends[-1]}, 3)"))
    rows = {part: slice(ends[i], ends[i + 1]) for i, part in enumerate(PARTS)}
    return IdentityModes(
        mean[: ends[0]], moves[:, : ends[0]],
        {part: mean[row] for part, row in rows.items()}, {part: moves[:, row] for part, row in rows.items()},
    )  # fmt: skip


@functools.cache
def load_head_kinds() -> Mapping[str, IdentityModes]:
    """What a scan's head may be, by name: people first, then animals of the cast, which differ as people do."""
    people = load_identity_modes()
    faces = load_cast().faces
    animals = {
        name: replace(
            people, skin=faces[name].positions.astype(np.float64),
            parts={part: faces[name].parts[part].astype(np.float64) for part in people.parts},
        )
        for name in ANIMALS
    }  # fmt: skip
    return MappingProxyType({PEOPLE: people, **animals})


@functools.cache
def load_landmark_table() -> LandmarkTable:
    """Where a landmark model's points lie on the built-in head and how they err (tools/photographs); errors as
    `load_cast`."""
    arrays = _arrays(LANDMARK_TABLE)
    values = {
        name: arrays[name].astype(np.float64)
        for name in ("shares", "nodes", "basis", "mean", "slopes", "person", "shared", "alone")
    }
    units = dict(zip(arrays["unit_names"].tolist(), arrays["units"].astype(np.float64), strict=True))
    return LandmarkTable(corners=arrays["corners"], units=units, **values)


def read_cast(path: Path) -> Cast:
    """The cast in a file as tools/bake.py writes it; errors as `load_cast`."""
    try:
        return cast_of(_arrays(path))
    except (KeyError, ValueError) as error:
        raise _broken(path, error) from error


def _arrays(path: Path) -> dict[str, NDArray[Any]]:
    if not path.is_file():
        raise _missing(path)
    try:
        with path.open("rb") as stream, np.load(stream, allow_pickle=False) as file:
            return dict(file)
    except (OSError, EOFError, ValueError, zipfile.BadZipFile) as error:
        raise _broken(path, error) from error


def _missing(path: Path) -> FileNotFoundError:
    return FileNotFoundError(
        f"the built-in cast is missing: there is no {path.name} in {path.parent}; run `make bake` in a checkout, "
        "or install a wheel of Omote"
    )


def _broken(path: Path, error: Exception) -> ValueError:
    return ValueError(f"{path} is not a cast of this version ({error}); delete it and run `make bake`")
