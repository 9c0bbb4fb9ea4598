"""The arrays of cast.npz, and the cast that they hold.

Arrays, V vertices of the skin, n of a part, E expressions:

    format              the number FORMAT
    about               JSON text as bytes: faces {name: look}, gains {name: [{region, value, expression}]} of those
                        who set any, expressions [{name, label, kind, region}]
    triangles (F, 3)    of the skin                  jaw (m,)            skin vertices that show where the jaw is
    sheet (f, 3)        of the sheet S, which the generic face's lips, closed, would cover in part
    face/NAME (V, 3)    metres                       face/NAME/PART (n, 3)
    part/PART (t, 3)    triangles of a part
    dtheta, dh, swell (E, V)                         fields on S, radians, metres and R - 1
    residual (E, i, 3)  of the inner skin            rest/PART (E, n, 3)  eyes (E, 2, 2)  pupil (E,)
    ears (E, 2, 3)      radians, head (E, 3) radians: what ears and heads do that answer
    complexion (E, 7)   blood, tears and sweat: omote.model.space.complexion
    folding (V,)        of 255, how far expressions press the skin together (omote.model.folding); 0 where none folds
    hair/STYLE/WHAT     of a HairStyle: points, rows, weights, anchors, facing, light, fullness, width,
                        scalp
    drawn/MESH/source (k,), drawn/MESH/uv (k, 2), drawn/MESH/triangles (t, 3), drawn/MESH/openness (k,)
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Floats, Indices
from omote.builtin.binding import PARTS, PartMesh, head_space
from omote.model.albedo import SkinAtlas
from omote.model.cast import Cast, Look
from omote.model.hair import HairStyle
from omote.model.known_names import GENERIC
from omote.model.space.complexion import Complexion
from omote.model.space.expression import Expression, Title
from omote.model.space.face import Face
from omote.model.space.gain import Gain
from omote.model.space.parameter_space import ParameterSpace

FORMAT = 6
SKIN = "skin"
Arrays = Mapping[str, NDArray[Any]]


@dataclass(frozen=True, eq=False)
class BakedMesh:
    """A mesh ready to be drawn: its vertices are split where the texture has a seam.

    source (k,): the row of the mesh's own vertices;  uv (k, 2), (0, 0) the upper left corner;  triangles (t, 3);
    openness (k,): how much of the sky each vertex of the generic face sees, 0 to 255 (ambient occlusion)
    """

    name: str
    source: Indices
    uv: Floats
    triangles: Indices
    openness: NDArray[np.uint8]


def cast_of(arrays: Arrays) -> Cast:
    """The cast that the arrays hold; ValueError or KeyError where they are not a cast of this version."""
    if int(arrays["format"]) != FORMAT:
        raise ValueError(f"it has format {int(arrays['format'])}, this version reads format {FORMAT}")
    about = json.loads(arrays["about"].tobytes())
    gains = about["gains"]
    faces = {name: _face(arrays, name, gains.get(name, ())) for name in about["faces"]}
    space = _space(arrays, faces[GENERIC])
    titles = {row["name"]: Title(row["label"], row["kind"], row["region"]) for row in about["expressions"]}
    return Cast(
        space=space,
        faces=faces,
        expressions={
            name: _expression(arrays, name, row, space, signed=title.kind == "spring")
            for row, (name, title) in enumerate(titles.items())
        },
        looks={name: Look(**look) for name, look in about["faces"].items()},
        titles=titles,
        hair=_hair(arrays),
        folding=arrays["folding"],
        atlas=SkinAtlas(*(arrays[f"drawn/{SKIN}/{what}"] for what in ("source", "uv", "triangles"))),
    )


def meshes_of(arrays: Arrays) -> tuple[BakedMesh, ...]:
    """The meshes that draw the head: the skin first, then the parts."""
    return tuple(
        BakedMesh(name, *(arrays[f"drawn/{name}/{what}"] for what in ("source", "uv", "triangles", "openness")))
        for name in (SKIN, *PARTS)
    )


def _hair(arrays: Arrays) -> dict[str, HairStyle]:
    names = sorted({name.split("/")[1] for name in arrays if name.startswith("hair/")})
    whats = [what.name for what in fields(HairStyle) if what.name not in ("name", "width", "scalp")]
    return {
        name: HairStyle(
            name,
            **{what: arrays[f"hair/{name}/{what}"] for what in whats},
            width=float(arrays[f"hair/{name}/width"]),
            scalp=float(arrays[f"hair/{name}/scalp"]),
        )
        for name in names
    }


def _face(arrays: Arrays, name: str, gains: Iterable[Mapping[str, Any]]) -> Face:
    parts = {part: arrays[f"face/{name}/{part}"] for part in PARTS}
    return Face(name, arrays[f"face/{name}"], parts, tuple(Gain(**gain) for gain in gains))


def _space(arrays: Arrays, generic: Face) -> ParameterSpace:
    parts = {part: PartMesh(generic.parts[part].astype(np.float64), arrays[f"part/{part}"]) for part in PARTS}
    return head_space(generic.positions.astype(np.float64), arrays["triangles"], parts, arrays["jaw"], arrays["sheet"])


def _expression(arrays: Arrays, name: str, row: int, space: ParameterSpace, *, signed: bool) -> Expression:
    rests = {part: arrays[f"rest/{part}"][row] for part in PARTS}
    inner = len(arrays["residual"][row])
    if inner != len(space.inner.vertices):
        raise ValueError(
            f"its fields know {inner} vertices of inner skin, this version finds {len(space.inner.vertices)}"
        )
    return Expression(
        dtheta=arrays["dtheta"][row],
        dh=arrays["dh"][row],
        ratio=1.0 + arrays["swell"][row].astype(np.float64),
        residual=arrays["residual"][row],
        parts={part: rest for part, rest in rests.items() if rest.any()},
        eyes=arrays["eyes"][row],
        radius=space.radius,
        transfer=space.transfer,
        pupil=float(arrays["pupil"][row]),
        name=name,
        ears=arrays["ears"][row],
        head=arrays["head"][row],
        signed=signed,
        complexion=Complexion(*np.round(arrays["complexion"][row].astype(np.float64), 6).tolist()),
    )
