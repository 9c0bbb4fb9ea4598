"""People whom nobody has seen, drawn from what heads differ by, in looks of their own, ready to be photographed."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.builtin import load_cast, load_identity_modes
from omote.model.albedo import encode_light
from omote.model.cast import Cast, Look
from omote.model.hair import place_strands
from omote.model.recipes.compose_face import mix_looks
from omote.model.space.face import Face
from omote.perform.blending.evaluate import evaluate, evaluate_parts
from omote.perform.channels import gaze_channels
from omote.perform.frame import Frame, Gaze
from tools.photographs.photographer import Model
from tools.tracking.picture import _ball_axes, _colours, _linear, _meshes, _normals, _traits
from tools.tracking.random_people import HUMANS, Person, Warp, random_look, random_warp

Floats = NDArray[np.float32]
NAME = "somebody"


@dataclass(frozen=True, eq=False)
class Sculpted:
    """Somebody: a face on our topology, at rest, in a cast of its own, and a look."""

    face: Face
    cast: Cast
    look: Look

    def wear(self, weights: dict[str, float], gaze: tuple[float, float]) -> tuple[Floats, dict[str, Floats]]:
        """Skin (V, 3) and parts by name with weights of units and the eyes turned (radians)."""
        turned = gaze_channels(self.cast.expressions, Gaze(*gaze))
        frame = Frame({NAME: 1.0}, {"neutral": 1.0}, {**weights, **turned})
        return evaluate(self.cast, frame), evaluate_parts(self.cast, frame)


def random_sculpted(draw: np.random.Generator, spread: float = 1.1, warped: float = 0.5) -> Sculpted:
    """A person of random weights of the identity modes, warped a little so that modes alone do not explain them."""
    modes = load_identity_modes()
    weights = spread * draw.standard_normal(len(modes.moves))
    skin = modes.shape_skin(weights)
    parts = modes.shape_parts(weights)
    warp = random_warp(draw)
    warp = Warp(1.0 + warped * (warp.scale - 1.0), warp.centres, warped * warp.moves, warp.widths)
    face = Face(NAME, warp(skin), {name: warp(points) for name, points in parts.items()})
    return dress(face, draw)


def dress(face: Face, draw: np.random.Generator) -> Sculpted:
    """The face in a random look."""
    cast = load_cast()
    look = random_looks(draw)
    named = Face(NAME, face.positions, face.parts)
    return Sculpted(named, cast.with_faces(named, looks={NAME: look}), look)


def random_looks(draw: np.random.Generator) -> Look:
    """A random look between those of two of the cast."""
    chosen = draw.choice(len(HUMANS), 2, replace=False)
    return random_look(draw, mix_looks([(load_cast().looks[HUMANS[row]], 0.5) for row in chosen]))


def fit_ball(points: NDArray[np.floating]) -> NDArray[np.float64]:
    """The middle (3,) of the sphere nearest to points (n, 3)."""
    middle = points.mean(axis=0)
    off = points - middle
    system = np.column_stack([2.0 * off, np.ones(len(off))])
    found: NDArray[np.float64] = middle + np.linalg.lstsq(system, (off**2).sum(axis=1), rcond=None)[0][:3]
    return found


def model_of(person: Sculpted, weights: dict[str, float], gaze: tuple[float, float]) -> Model:
    """What is drawn of a person who does something."""
    mesh = _meshes()
    skin, parts = person.wear(weights, gaze)
    both = {"skin": skin, **parts}
    balls = {name: _ball_axes(person.face.parts[name]) for name in ("eye_left", "eye_right")}
    local = [balls.get(name, np.zeros((len(both[name]), 3), np.float32)) for name, _ in mesh.own]
    normals = np.concatenate([_normals(both[name], triangles) for name, triangles in mesh.own])
    drawn = np.concatenate([both[name] for name, _ in mesh.own])[mesh.source]
    described = Person({}, None, person.look)  # type: ignore[arg-type]
    return Model(
        drawn.astype(np.float64), normals[mesh.source], mesh.triangles, mesh.material, mesh.uv, mesh.openness,
        np.concatenate(local)[mesh.source].astype(np.float32), mesh.mask, _colours(described), _traits(described),
        person.look.lashes, _strands(person),
    )  # fmt: skip


def _strands(person: Sculpted) -> tuple[Floats, Floats, Floats] | None:
    if not person.look.hair_style:
        return None
    style = person.cast.hair[person.look.hair_style]
    places = place_strands(style, person.cast.space.points, person.face.positions.astype(np.float64))
    return np.asarray(places, np.float32), style.light, _linear(person.look.hair).astype(np.float32)


def painted_colours(look: Look, *, plain: bool = False, side: int = 1024) -> NDArray[np.uint8]:
    """What the skin of a look is painted with on the texture, (side, side, 3) of sRGB, as `rasterizer` does; plain:
    without brows."""
    mask = _meshes().mask[:side, :side, :3] / 255.0
    skin, lip, brow, blush = (_linear(colour) for colour in (look.skin, look.lip, look.brow, look.blush))
    light = skin + (0.3 * mask[..., 2:3]) * (blush - skin)
    light = light + np.minimum(1.0, 1.6 * mask[..., :1]) * (lip - light)
    if not plain:
        light = light + np.minimum(1.0, 2.0 * look.brows * mask[..., 1:2]) * (brow - light)
    return encode_light(light)
