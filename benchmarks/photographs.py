"""Faces from photographs of people whose shape is known: python -m benchmarks.photographs [--people 12] [--seed 0].

Random people of ICT-FaceKit (where it is at hand) and fresh random people of the sculptor are photographed with random
lenses, light and noise, the camera page's landmark model looks at them, and `omote.fit_photographs` fits them. Vertex
error of the face (ears, skull and nape apart) after a similarity, the mean head's error being 1; and of the colours
taken from the photographs, CIE delta E (2000) on the skin that was seen, without and with soft light divided out; and
of hair, beside the known skin.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

import omote
from benchmarks.heads_before_cameras import ict_person
from benchmarks.scans.ict_people import at_hand
from omote.builtin import load_cast, load_identity_modes
from omote.interchange.skin_texture import decode_srgb
from omote.model.appearance.hair_colour import HairColour, find_hair_colour, find_scalp
from omote.model.appearance.lab import to_lab
from omote.model.appearance.photograph_albedo import take_photograph_albedo
from omote.model.cast import Look
from omote.model.fitting.head_zones import head_zones
from omote.model.fitting.photographs.photograph import FILM, Photograph
from omote.model.space.similarity import fit_similarity
from tools.photographs.colour_distance import colour_distance, delta_e
from tools.photographs.observe_heads import random_gaze
from tools.photographs.photographer import Model, photograph
from tools.photographs.sculpted_people import model_of, painted_colours, random_sculpted
from tools.photographs.views import camera_at, random_focal
from tools.tracking.landmark_finder import Looks, find, open_finder
from tools.tracking.picture import random_setting

Values = NDArray[np.float64]
Make = Callable[[dict[str, float], tuple[float, float]], Model]
YAWS = (0.0, 40.0, -40.0, 20.0)
SIDE = 512
BARS = {1: 0.92, 4: 0.70}


def take_views(
    make: Make, draw: np.random.Generator, finder: Looks, *, told: bool = False, side: int = SIDE
) -> list[Photograph]:  # fmt: skip
    """Four photographs (side, side) of somebody by one camera, with the landmarks found; told: with the focal
    length."""
    focal = random_focal(draw)
    setting = random_setting(draw)
    views = []
    for degrees in YAWS:
        yaw = float(np.radians(degrees) + draw.normal(0.0, 0.05))
        camera = camera_at(draw, yaw, float(draw.normal(0, 0.06)), float(draw.normal(0, 0.05)), focal, side)
        picture, _ = photograph(camera, make({}, random_gaze(draw, yaw)), setting, draw)
        points = find(finder, picture)
        if points is not None:
            views.append(Photograph(
                points.astype(np.float64) * side, side, side, FILM * focal if told else None, "one", picture
            ))  # fmt: skip
    return views


def vertex_error(skin: Values, truth: Values) -> float:
    """Millimetres between the faces of two skins (V, 3), the mean after a similarity."""
    face = head_zones(load_cast().space).face
    placed = fit_similarity(skin[face], truth[face], np.ones(int(face.sum())))(skin[face])
    return 1000.0 * float(np.linalg.norm(placed - truth[face], axis=1).mean())


def sculpted_person(draw: np.random.Generator) -> tuple[Values, Make]:
    """A fresh person of the sculptor: skin (V, 3), and how to draw them."""
    person = random_sculpted(draw, 1.0)
    return person.face.positions.astype(np.float64), lambda weights, gaze: model_of(person, weights, gaze)


def measure_shapes(
    name: str, someone: Callable[..., tuple[Values, Make]], people: int, seed: int, side: int
) -> None:  # fmt: skip
    """Prints vertex errors of one photograph and of four, (side, side) pixels each."""
    finder = open_finder()
    rows = []
    seconds = []
    space = load_cast().space
    mean = load_identity_modes().skin
    for number in range(people):
        draw = np.random.default_rng([seed, number])
        truth, make = someone(draw)
        views = take_views(make, draw, finder, side=side)
        if len(views) < len(YAWS):
            print(f"  person {number}: a face found in {len(views)} of {len(YAWS)} photographs, left out")
            continue
        errors = [vertex_error(mean, truth)]
        for count in BARS:
            start = time.thread_time()
            fit = omote.fit_photographs(space, views[:count])
            seconds.append(time.thread_time() - start)
            errors.append(vertex_error(fit.face.positions.astype(np.float64), truth))
        rows.append(errors)
    finder.close()
    table = np.array(rows)
    for column, (count, bar) in enumerate(BARS.items(), 1):
        share = table[:, column].mean() / table[:, 0].mean()
        print(
            f"{name}, {len(table)} people, {count} photograph(s): {table[:, column].mean():.2f} mm, mean head "
            f"{table[:, 0].mean():.2f} mm: {share:.3f} (at most {bar}), worst person "
            f"{(table[:, column] / table[:, 0]).max():.2f}; {np.mean(seconds):.1f} s of one core a fit"
        )


def measure_colours(people: int, seed: int) -> None:
    """Prints delta E of skin that was seen in four photographs, its light left in and divided out."""
    cast = load_cast()
    finder = open_finder()
    found = []
    assert cast.atlas is not None
    for number in range(people):
        draw = np.random.default_rng([seed, 7, number])
        person = random_sculpted(draw, 1.0)
        views = take_views(lambda weights, gaze, who=person: model_of(who, weights, gaze), draw, finder)  # type: ignore[misc]
        if not views:
            continue
        fit = omote.fit_photographs(cast.space, views)
        truth = painted_colours(person.look)
        plain = painted_colours(person.look, plain=True)
        row = []
        for even in (False, True):
            taken = take_photograph_albedo(cast.space, cast.atlas, fit.face, views, fit.cameras, plain, even=even)
            row.append(delta_e(taken.albedo.pixels[..., :3], truth, taken.seen == 255))
        found.append([*row, float((taken.seen == 255).sum() / (taken.albedo.pixels[..., 3] == 255).sum())])
    finder.close()
    left, removed, seen = np.mean(found, axis=0)
    print(f"colours, {len(found)} people, delta E {left:.1f} with light, {removed:.1f} without, on {seen:.0%}")


def measure_hair(people: int, seed: int) -> None:
    """Prints delta E of hair in random looks, beside their own skin, from one photograph and from four."""
    cast = load_cast()
    finder = open_finder()
    scalp = find_scalp(cast.space, cast.hair)
    found: dict[int, list[tuple[Look, HairColour]]] = {count: [] for count in BARS}
    for number in range(people):
        draw = np.random.default_rng([seed, 9, number])
        person = random_sculpted(draw, 1.0)
        views = take_views(lambda weights, gaze, who=person: model_of(who, weights, gaze), draw, finder)  # type: ignore[misc]
        for count in BARS if len(views) == len(YAWS) else ():
            fit = omote.fit_photographs(cast.space, views[:count])
            skin = person.look.skin
            hair = find_hair_colour(cast.space, scalp, fit.face, views[:count], fit.cameras, skin)
            found[count].append((person.look, hair))
    finder.close()
    for count, each in found.items():
        print_hair(count, each)


def print_hair(count: int, found: list[tuple[Look, HairColour]]) -> None:
    """Prints what was found of hair in so many photographs."""
    wearers = [(look, hair) for look, hair in found if look.hair_style]
    known = [(look.hair, hair.colour) for look, hair in wearers if hair.colour is not None]
    seen, true = (np.concatenate([decode_srgb(colour)[None] for colour in each]) for each in zip(*known, strict=True))
    off = colour_distance(to_lab(seen.astype(np.float64)), to_lab(true.astype(np.float64)))
    bald = [hair for look, hair in found if not look.hair_style]
    print(
        f"hair, {count} photograph(s): delta E median {np.median(off):.1f}, worst {off.max():.1f}, of {len(known)} of "
        f"{len(wearers)} people with hair, the others doubted; {sum(hair.colour is None for hair in bald)} of "
        f"{len(bald)} bald ones without"
    )


def main() -> None:
    """Measures shapes, then colours, then hair."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--people", type=int, default=12)
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--side", type=int, default=SIDE, help="of the photographs that show shapes, pixels")
    asked = parser.parse_args()
    seed = int(np.random.SeedSequence().entropy % 2**31) if asked.seed is None else asked.seed  # type: ignore[operator]
    print(f"seed {seed}")
    measure_shapes("the sculptor's", sculpted_person, asked.people, seed, asked.side)
    if at_hand():
        measure_shapes("ICT-FaceKit's", ict_person, asked.people, seed, asked.side)
    measure_colours(max(asked.people // 4, 1), seed)
    measure_hair(2 * asked.people, seed)


if __name__ == "__main__":
    main()
