"""Records what artists' tools compute: extraction, nets, recipes, own faces, sculpts, tangents, the inverse solve."""

from __future__ import annotations

from itertools import product

import numpy as np

from omote.builtin import load_cast
from omote.geometry.mesh import normals
from omote.interchange.formats.sculpt_toml import read_sculpt
from omote.model.cast import Cast
from omote.model.controls.control_net import ControlNet
from omote.model.controls.default_net import default_net
from omote.model.controls.face_muscles import muscle_fields
from omote.model.controls.inverse_solve import solve_vectors
from omote.model.controls.mirror import mirror_expression
from omote.model.controls.net_field import build_net_field
from omote.model.controls.tangents import tangents
from omote.model.extraction.extract import extract
from omote.model.hair import place_strands
from omote.model.recipes.compose_expression import change_net, compose_expression
from omote.model.recipes.compose_face import FaceWithLook, compose_face
from omote.model.recipes.face_handles import default_handles, drag_handles
from omote.model.recipes.recipe import FaceRecipe, Layer, Pull, Recipe, Vector
from omote.model.sculpting.caricature import caricature
from omote.model.sculpting.regions import regional
from omote.model.sculpting.sculpt import sculpted
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.head_regions import REGIONS, region_weights
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.compound import compound, compound_parts
from tools.baking.sculpts import sculpt_paths
from tools.same.compounds import SEED, cast_under
from tools.same.recording import Numbers, Recording

WORN = ("kaori", "dog", "generic", "gaunt")
TAKEN = ("smile", "jawOpen", "eyeBlinkLeft", "shout", "tongueOut", "eyeLookOutLeft")
SOLVES = 6


def numbers_of(expression: Expression) -> list[Numbers]:
    """All that an expression consists of."""
    parts = [expression.parts[name] for name in sorted(expression.parts)]
    fields = [expression.dtheta, expression.dh, expression.ratio, expression.residual, expression.eyes]
    return [*fields, np.array(expression.pupil), *parts]


def record_extraction(recording: Recording) -> None:
    """Expressions measured on faces again, under both transfer rules and both rules of radii."""
    for transfer in ("smooth", "paper"):
        cast = cast_under(transfer)
        for face, name in product(WORN, TAKEN):
            if name in cast.expressions:
                wearer = cast.faces[face]
                worn = cast.expressions[name]
                moved = compound(cast.space, wearer, worn).astype(np.float64) - wearer.positions
                found = compound_parts(cast.space, wearer, worn)
                parts = {part: points - wearer.parts[part] for part, points in found.items()}
                taken = extract(cast.space, wearer, moved, parts=parts)
                recording.numbers(f"extracted {transfer}", f"{face} {name}", *numbers_of(taken))
    _record_radii(recording)


def _record_radii(recording: Recording) -> None:
    """A space built anew, by the rule of radii that the cast does not have."""
    cast = cast_under("paper")
    space = ParameterSpace.build(cast.space.points, cast.space.triangles, radius="surface", transfer="paper")
    recording.numbers("spaces", "built with radii of the surface", space.theta, space.h, space.skin_triangles)
    bare = {face: Face(face, cast.faces[face].positions) for face in WORN}
    for name in TAKEN[:2]:
        moved = compound(cast.space, cast.faces["generic"], cast.expressions[name]) - cast.space.points
        taken = extract(space, bare["generic"], moved)
        recording.numbers("extracted radius=surface", name, *numbers_of(taken))
        for face in WORN[:2]:
            recording.numbers("compounds radius=surface", f"{face} {name}", compound(space, bare[face], taken))


def record_recipes(recording: Recording) -> None:
    """Nets, muscles, regions, mirror images and seeded random recipes."""
    cast = load_cast()
    rng = np.random.default_rng(SEED)
    space = cast.space
    net = default_net(cast.space)
    recording.numbers("control nets", "default net", np.array(net))
    weave = build_net_field(space, net)
    recording.numbers("control nets", "woven", weave.net.triangles, weave.net.corners, weave.net.weights)
    recording.numbers("control nets", "points on dog", ControlNet.points_on(weave.net, cast.faces["dog"]))
    for name, field in muscle_fields(space).items():
        recording.numbers("muscles", name, field)
    for region, share in region_weights(space).items():
        recording.numbers("regions", region, share)
    for name in [*cast.expressions][::3]:
        recording.numbers("mirrored", name, *numbers_of(mirror_expression(space, cast.expressions[name])))
    for place in range(16):
        recipe = random_recipe(cast, net, rng)
        made = compose_expression(space, recipe, cast.expressions)
        recording.numbers("recipes composed", f"{place:02d}", *numbers_of(made))
        recording.numbers("recipes worn", f"{place:02d}", compound(space, cast.faces["dog"], made))
        fewer, _, ground = change_net(space, recipe, None, net[: -3 - place % 4])
        recording.numbers("recipes under other nets", f"{place:02d}", np.array(fewer.vectors))
        if ground is not None:
            recording.numbers("recipes under other nets", f"{place:02d} ground", *numbers_of(ground))


def random_recipe(cast: Cast, net: tuple[int, ...], rng: np.random.Generator) -> Recipe:
    """Layers, muscles, control points and eyes, a little of each."""
    names = rng.choice([*cast.expressions], size=int(rng.integers(0, 4)), replace=False).tolist()
    muscles = rng.choice([*muscle_fields(cast.space)], size=int(rng.integers(0, 4)), replace=False).tolist()
    regions = [None, *REGIONS]
    layers = tuple(
        Layer(
            name, name, float(rng.uniform(-0.3, 0.9)), regions[int(rng.integers(len(regions)))], rng.random() < 0.3
        )
        for name in names
    )  # fmt: skip
    vectors = rng.normal([0.0, 0.0, 1.0], [0.01, 0.001, 0.005], (len(net), 3)) if rng.random() < 0.7 else None
    eyes = rng.uniform(-0.2, 0.2, 4).tolist()
    return Recipe(
        net,
        ((0.0, 0.0, 1.0),) * len(net) if vectors is None else tuple(_vector(row) for row in vectors),
        layers=layers,
        pulls=tuple(Pull(name, float(rng.uniform(0.0, 0.8))) for name in muscles),
        eyes=(eyes[0], eyes[1], eyes[2], eyes[3]),
        pupil=float(rng.uniform(-0.3, 0.3)),
    )


def record_solves(recording: Recording) -> None:
    """Control points dragged to targets, and how faces answer to fields."""
    cast = load_cast()
    rng = np.random.default_rng(SEED)
    space = cast.space
    net = default_net(cast.space)
    for name, face in cast.faces.items():
        recording.numbers("tangents", name, tangents(space, face))
    weave = build_net_field(space, net)
    rest = ((0.0, 0.0, 1.0),) * len(net)
    for place, face in product(range(SOLVES), WORN[:2]):
        under = compose_expression(space, random_recipe(cast, net, rng), cast.expressions)
        points = sorted(rng.choice(len(net), size=1 + place % 3, replace=False).tolist())
        start = compound(space, cast.faces[face], under)[[net[point] for point in points]]
        found = solve_vectors(
            space, cast.faces[face], under, weave, rest, points, start + rng.normal(0.0, 0.002, start.shape)
        )
        recording.numbers("inverse solves", f"{face} {place}", found.vectors, np.array([found.miss, found.compounds]))
    for point in range(0, len(net), 9):
        target = weave.net.points_on(cast.faces["kaori"])[point] + [0.002, -0.003, 0.001]
        recording.numbers(
            "inverse solves", f"drag {point}", np.array(weave.net.drag(cast.faces["kaori"], point, target))
        )


def record_faces(recording: Recording) -> None:
    """Own faces: sculpts, regions, caricature, handles, recipes of all; and hair on faces."""
    cast = load_cast()
    for path in sculpt_paths():
        sculpt = read_sculpt(path)
        made = sculpted(cast.space, sculpt, cast.faces)
        recording.numbers("sculpts", sculpt.name, made.positions, *(made.parts[name] for name in sorted(made.parts)))
        recording.data("sculpts", f"{sculpt.name} look", repr(vars(sculpt.look)).encode())
    for name in WORN:
        for amount in (0.5, 1.3):
            grown = caricature(cast.space, cast.faces[name], amount)
            recording.numbers("caricatures", f"{name} {amount:g}", grown.positions)
        recording.numbers(
            "shading normals", name, normals(cast.faces[name].positions.astype(np.float64), cast.space.triangles)
        )
    mixed = regional(
        cast.space, "mixed", {"nose": cast.faces["dog"], "jaw": cast.faces["gaunt"]}, rest=cast.faces["kaori"]
    )
    recording.numbers("regional faces", "mixed", mixed.positions, *(mixed.parts[name] for name in sorted(mixed.parts)))
    for style, face in product(cast.hair, WORN[:3]):
        strands = place_strands(cast.hair[style], cast.space.points, cast.faces[face].positions.astype(np.float64))
        recording.numbers("hair", f"{face} {style}", strands, every=97)
    _record_handles(recording, cast)


def _record_handles(recording: Recording, cast: Cast) -> None:
    rng = np.random.default_rng(SEED)
    handles = default_handles(cast.space)
    rows = [handle.row for handle in handles]
    recording.data("handles", "default", repr([(each.label, each.row, each.mirror) for each in handles]).encode())
    sources = {name: FaceWithLook(cast.faces[name], cast.looks[name]) for name in cast.faces}
    for place in range(8):
        moves = rng.normal(0.0, 0.0015, (len(rows), 3))
        moved = drag_handles(cast.space, cast.faces[WORN[place % 4]], "moved", rows=rows, moves=moves)
        recording.numbers("handles", f"dragged {place}", moved.positions)
        one, two, three = rng.choice([*cast.faces], size=3, replace=False).tolist()
        region = REGIONS[place % len(REGIONS)]
        points, ways = (tuple(rows), tuple(_vector(row) for row in moves / 2)) if place % 2 else ((), ())
        recipe = FaceRecipe({one: 0.4, two: 0.6}, {region: three}, 1.0 + 0.1 * (place % 3), points, ways)
        made = compose_face(cast.space, "own", recipe, sources)
        recording.numbers("own faces", f"{place}", made.face.positions, *made.face.parts.values())
        recording.data("own faces", f"{place} look", repr(vars(made.look)).encode())


def _vector(row: Numbers) -> Vector:
    x, y, z = row.tolist()
    return x, y, z
