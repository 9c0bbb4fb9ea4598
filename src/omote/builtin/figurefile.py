"""The arrays of figures.npz, and the figures that they hold.

Arrays, V rows of the head, B of the body, J bones:

    format                 the number FIGURE_FORMAT
    about                  JSON text as bytes: bones [name], bodies [name], garments [[name, label]]
    parents (J,)           of the bones           triangles (t, 3)         of the body
    head_rows, rim         numbers                edge (e,)                rows of the head
    bones, weights (V + B, 8), shares (V + B,)    weights of 65535, shares of 255
    joined (n,), join (n, e)                      head_joint (h,), head_joint_offset (3,)
    uvs (k, 2), uv_rows (t, 3)
    skirt (s, 3)           triangles of the skirt
    garment/NAME           (4, V + B) cover, thick, trim, hidden: in steps of a metre, int16
    bending, bending_hinges (c,)                  rows that have correctives, and which joint calls them
    body/NAME/WHAT         positions (B, 3), edge (e, 3), joints, ends (J, 3), correctives (4 c, 3): in steps of a
                           metre, int16; size
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import Any, Literal

import msgspec
import numpy as np
from numpy.typing import NDArray

from omote.model.body.body import Body
from omote.model.body.compose_pose import pose_of
from omote.model.body.figure_space import FigureSpace
from omote.model.body.figures import Figures
from omote.model.body.garment import Garment
from omote.model.body.limb_field import make_fields
from omote.model.body.limb_recipe import LimbRecipe
from omote.model.body.limbs import unroll_limbs
from omote.model.body.pose import STAND, Pose
from omote.model.body.pose_recipe import NamedPose
from omote.model.body.skeleton import Skeleton

FIGURE_FORMAT = 4
STEPS_OF_A_METRE = 15_000
"""Steps of 16 bits in which places are kept: a fifteenth of a millimetre, as far as 2.18 m from the eyes."""
PLACES = ("positions", "edge", "joints", "ends", "correctives")
Arrays = Mapping[str, NDArray[Any]]


def figures_of(arrays: Arrays, recipes: Iterable[NamedPose], limb_recipes: Iterable[LimbRecipe] = ()) -> Figures:
    """The figures that the arrays hold; ValueError or KeyError where they are not of this version.

    arrays: of figures.npz; recipes: of the poses beside the stand; limb_recipes: of the limb fields.
    """
    if int(arrays["format"]) != FIGURE_FORMAT:
        raise ValueError(f"it has format {int(arrays['format'])}, this version reads format {FIGURE_FORMAT}")
    about = json.loads(arrays["about"].tobytes())
    weights = arrays["weights"].astype(np.float64)
    space = FigureSpace(
        head_rows=int(arrays["head_rows"]),
        triangles=arrays["triangles"],
        skeleton=Skeleton(tuple(about["bones"]), arrays["parents"]),
        bones=arrays["bones"].astype(np.int32),
        weights=(weights / weights.sum(axis=1, keepdims=True)).astype(np.float32),
        shares=(arrays["shares"] / np.float32(np.iinfo(np.uint8).max)).astype(np.float32),
        edge=arrays["edge"],
        rim=int(arrays["rim"]),
        joined=arrays["joined"],
        join=arrays["join"],
        head_joint=arrays["head_joint"],
        head_joint_offset=arrays["head_joint_offset"],
        uvs=arrays["uvs"],
        uv_rows=arrays["uv_rows"],
        skirt=arrays["skirt"],
        bending=arrays["bending"],
        bending_hinges=arrays["bending_hinges"].astype(np.int32),
    )
    written = {recipe.name: recipe for recipe in recipes}
    bodies = {name: _body(arrays, name) for name in about["bodies"]}
    garments = {name: _garment(arrays, name, label) for name, label in about["garments"]}
    limbs = unroll_limbs(space, next(iter(bodies.values())))
    fields = {field.name: field for recipe in limb_recipes for field in make_fields(recipe, limbs)}
    poses = _poses(written.values(), space)
    return Figures(space, bodies, poses, garments, MappingProxyType(written), limbs, MappingProxyType(fields))


def read_poses(text: bytes) -> list[NamedPose]:
    """The poses of a TOML text, a table `pose` for each; ValueError where it holds something else."""
    return msgspec.toml.decode(text, type=dict[Literal["pose"], list[NamedPose]])["pose"]


def _poses(recipes: Iterable[NamedPose], space: FigureSpace) -> dict[str, Pose]:
    """The stand first, then all others."""
    stand = Pose(STAND, np.zeros((len(space.skeleton.names), 3)))
    return {STAND: stand} | {
        recipe.name: pose_of(recipe, space.skeleton, recipe.name, recipe.label) for recipe in recipes
    }


def _body(arrays: Arrays, name: str) -> Body:
    places = {what: (arrays[f"body/{name}/{what}"] / STEPS_OF_A_METRE).astype(np.float32) for what in PLACES}
    return Body(name, **places, size=float(arrays[f"body/{name}/size"]))


def _garment(arrays: Arrays, name: str, label: str) -> Garment:
    return Garment(name, label, *(arrays[f"garment/{name}"] / STEPS_OF_A_METRE).astype(np.float32))
