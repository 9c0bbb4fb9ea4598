"""People that nobody has seen: mixes of the cast, warped at random, each in a look of their own."""

from __future__ import annotations

import colorsys
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.builtin import load_cast
from omote.model.cast import Look
from omote.model.hair import place_strands
from omote.model.recipes.compose_face import mix_looks
from omote.perform.blending.evaluate import evaluate, evaluate_parts
from omote.perform.channels import gaze_channels
from omote.perform.frame import Frame, Gaze

Values = NDArray[np.float64]
Floats = NDArray[np.float32]

HUMANS = ("generic", "kaori", "round", "child", "baby", "old", "man", "gaunt", "heavy", "doll", "auntie", "count")
LEFT_OUT = ("kaori", "gaunt")
"""Of the cast, those whom no training person has in their mix: people of tests are made of them."""
STYLES = ("", "bob", "bun", "crop", "mop", "short", "swept", "thin")


@dataclass(frozen=True)
class Warp:
    """A smooth warp of space: axes scaled by (3,), then moved by kernels at centres (k, 3) of widths (k,), metres."""

    scale: Values
    centres: Values
    moves: Values
    widths: Values

    def __call__(self, points: NDArray[np.floating]) -> Values:
        """The points (n, 3) after the warp."""
        scaled = points.astype(np.float64) * self.scale
        near = ((scaled[:, None] - self.centres) ** 2).sum(-1) / (2 * self.widths**2)
        result: Values = scaled + np.exp(-near) @ self.moves
        return result


@dataclass(frozen=True, eq=False)
class Person:
    """Somebody: shares of the cast's faces, a warp, a look."""

    shares: dict[str, float]
    warp: Warp
    look: Look

    def pose(self, weights: dict[str, float], gaze: tuple[float, float]) -> tuple[Floats, dict[str, Floats]]:
        """Skin (V, 3) and parts by name, metres, with the weights of units worn and the eyes turned (radians).

        weights: by unit; gaze: yaw and pitch.
        """
        cast = load_cast()
        turned = gaze_channels(cast.expressions, Gaze(*gaze))
        frame = Frame(self.shares, {"neutral": 1.0}, {**weights, **turned})
        skin = self.warp(evaluate(cast, frame)).astype(np.float32)
        parts = {name: self.warp(points).astype(np.float32) for name, points in evaluate_parts(cast, frame).items()}
        return skin, parts

    def strands(self, skin: Floats) -> tuple[Floats, Floats] | None:
        """The hair on a skin (V, 3) at rest: places (n, k, 3) and their light (n, k); None where there is none."""
        cast = load_cast()
        if not self.look.hair_style:
            return None
        style = cast.hair[self.look.hair_style]
        places = place_strands(style, cast.space.points, skin.astype(np.float64))
        return np.asarray(places, np.float32), style.light


def random_person(draw: np.random.Generator, sources: tuple[str, ...]) -> Person:
    """A person mixed from some of the sources, warped by millimetres, in a random look.

    draw: of all that is random; sources: faces of the cast.
    """
    count = min(int(draw.integers(1, 5)), len(sources))
    chosen = draw.choice(len(sources), count, replace=False)
    shares = draw.dirichlet(np.full(count, 1.2))
    faces = {sources[row]: float(share) for row, share in zip(chosen, shares, strict=True)}
    if faces.get("count", 0.0) > 0.4:  # his chin is a caricature's
        faces = {"generic": 1.0 - 0.4 * faces["count"], "count": 0.4 * faces["count"]}
    cast = load_cast()
    look = mix_looks([(cast.looks[name], share) for name, share in faces.items()])
    return Person(faces, random_warp(draw), random_look(draw, look))


def random_warp(draw: np.random.Generator) -> Warp:
    """A warp that makes another person: mostly the same on both sides."""
    skin = load_cast().space.points
    front = skin[(skin[:, 2] > 0.06) & (skin[:, 1] > -0.11) & (skin[:, 1] < 0.09)]
    centres = front[draw.choice(len(front), 7)].astype(np.float64)
    moves = draw.normal(0.0, 0.0022, (7, 3))
    mirror = np.array([-1.0, 1.0, 1.0])
    both = np.concatenate([centres, centres * mirror])
    twice = np.concatenate([moves, moves * mirror])
    twice += draw.normal(0.0, 0.0004, twice.shape)
    widths = np.tile(draw.uniform(0.018, 0.04, 7), 2)
    return Warp(1.0 + draw.normal(0.0, 0.04, 3), both, twice, widths)


def random_look(draw: np.random.Generator, look: Look) -> Look:
    """The look with colours of its own.

    draw: of the colours; look: where they begin.
    """
    tone = draw.uniform(0.03, 0.09)
    light = draw.uniform(0.25, 0.98) ** 0.8
    skin = _hex(tone, draw.uniform(0.25, 0.6) * (1.25 - 0.7 * light), light)
    lip = _hex((draw.uniform(-0.02, 0.03)) % 1.0, draw.uniform(0.35, 0.65), light * draw.uniform(0.7, 0.95))
    dark = draw.uniform(0.05, 0.6) * min(1.0, light + 0.2)
    hair = _hex(draw.uniform(0.04, 0.11), draw.uniform(0.1, 0.6), dark)
    brow = _hex(draw.uniform(0.04, 0.11), draw.uniform(0.1, 0.5), 0.7 * dark)
    iris = _hex(draw.uniform(0.05, 0.6), draw.uniform(0.2, 0.6), draw.uniform(0.12, 0.5))
    return Look(**{
        **vars(look), "skin": skin, "lip": lip, "hair": hair, "brow": brow, "iris": iris,
        "hair_style": str(draw.choice(STYLES)), "brows": float(draw.uniform(0.35, 0.9)),
        "lashes": float(draw.uniform(0.1, 0.9)), "iris_size": float(draw.uniform(0.93, 1.12)),
    })  # fmt: skip


def _hex(hue: float, saturation: float, value: float) -> str:
    colour = colorsys.hsv_to_rgb(hue, min(saturation, 1.0), min(value, 1.0))
    return "#" + "".join(f"{round(255 * each):02x}" for each in colour)
