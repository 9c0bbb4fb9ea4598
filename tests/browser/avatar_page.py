"""An exported avatar in three-vrm, in a page: what it is called there, and where its vertices are."""

from __future__ import annotations

import base64
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from playwright.sync_api import Browser, Page, Route

from omote.builtin import load_cast
from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.interchange.avatar.fold_overlays import PREFIX
from omote.interchange.avatar.preset_expressions import EMOTIONS
from omote.interchange.export_face import close_over_teeth, compound_meshes
from omote.interchange.formats.glb_writer import NO_ROW
from omote.model.space.face_fit import fit
from omote.perform.blending.evaluate import evaluate, evaluate_parts
from omote.perform.frame import Frame

Points = NDArray[np.float32]
Meshes = Mapping[str, Points]
Turn = NDArray[np.float64]

HERE = Path(__file__).resolve().parent
PACKAGES = HERE.parents[1] / "web" / "node_modules"
ADDRESS = "http://avatar.test"
NOT_OURS = ("hair", "collar", PREFIX)
"""What the names of meshes begin with that are no rows of the cast."""
NEAR = 5e-5
"""Metres that a vertex may be from where ours is."""
PERFECT_SYNC = {name[0].upper() + name[1:]: {name: 1.0} for name in ARKIT_NAMES}


@contextmanager
def open_avatar(browser: Browser, file: Path) -> Iterator[Page]:
    """A page with the avatar of a file, as three-vrm has loaded it; what it says against it fails."""

    def answer(route: Route) -> None:
        name = route.request.url.removeprefix(ADDRESS).removeprefix("/")
        own = {"": HERE / "three_vrm.html", "face.vrm": file}
        route.fulfill(path=own.get(name, PACKAGES / name))

    page = browser.new_context(viewport={"width": 400, "height": 400}).new_page()
    said: list[str] = []
    page.on("console", lambda message: said.append(message.text) if message.type in ("warning", "error") else None)
    page.on("pageerror", lambda error: said.append(str(error)))
    page.route("**/*", answer)
    page.goto(ADDRESS)
    page.wait_for_function("() => Boolean(window.avatar)", polling=100)
    yield page
    page.context.close()
    assert said == []


def numbers(text: str) -> Points:
    """Numbers as the page tells them."""
    return np.frombuffer(base64.b64decode(text), np.float32)


def worn(page: Page, weights: Mapping[str, float], at: list[float] | None = None) -> dict[str, Points]:
    """Where three-vrm has the vertices of each mesh but hair, collar and folds: (n, 3) metres.

    at: what is looked at, from the eyes.
    """
    page.evaluate("([weights, at]) => window.avatar.wear(weights, at)", [dict(weights), at])
    names = [name for name in page.evaluate("window.avatar.found.meshes") if not name.startswith(NOT_OURS)]
    found = page.evaluate("names => names.map((name) => window.avatar.points(name))", names)
    return {name: numbers(text).reshape(-1, 3) for name, text in zip(names, found, strict=True)}


def on_air(face: str, weights: Mapping[str, float]) -> dict[str, Points]:
    """Where Omote has them on air, sums corrected: an emotion is worn, units are channels."""
    cast = load_cast()
    rest = {"neutral": 1.0}
    emotion = bool(weights) and set(weights) <= set(EMOTIONS.values())
    frame = Frame({face: 1.0}, weights) if emotion else Frame({face: 1.0}, rest, channels=weights)
    return {"skin": evaluate(cast, frame), **evaluate_parts(cast, frame)}


def blended(face: str, weights: Mapping[str, float]) -> dict[str, Points]:
    """Where compounds alone bring them, which is what targets can hold: on air before sums are corrected, but for teeth
    that would come out of closed lips."""
    cast = load_cast()
    wearer = cast.faces[face]
    rest = compound_meshes(cast.space, wearer, cast.expressions["neutral"])
    posed = {name: compound_meshes(cast.space, wearer, cast.expressions[name]) for name in (*weights, "jawOpen")}
    posed = close_over_teeth(cast.space, fit(cast.space, wearer), posed)
    return {
        name: (points + sum(part * (posed[each][name] - points) for each, part in weights.items())).astype(np.float32)
        for name, points in rest.items()
    }


def distances(
    page: Page, names: Mapping[str, Mapping[str, float]], ours: Callable[[Mapping[str, float]], Meshes], turn: Turn
) -> dict[str, float]:
    """How far from ours three-vrm has the farthest vertex, metres, for expressions by name and what they are made of.

    ours: where ours are by what is worn; turn: where the model's axes lie. All of them but neutral must move something.
    """
    rest = worn(page, {})
    told = {name: numbers(page.evaluate("name => window.avatar.rows(name)", name)).astype(int) for name in rest}
    ours_among = {name: rows != NO_ROW for name, rows in told.items()}
    rows = {name: told[name][among] for name, among in ours_among.items()}
    shift = (rest["skin"] - ours({})["skin"][rows["skin"]] * turn).mean(axis=0)
    far = {}
    for name, weights in names.items():
        theirs = worn(page, {name: 1.0})
        aim = ours(weights)
        placed = {mesh: points[ours_among[mesh]] - shift for mesh, points in theirs.items()}
        far[name] = max(float(np.abs(placed[mesh] - aim[mesh][rows[mesh]] * turn).max()) for mesh in theirs)
        moves = max(float(np.abs(points - rest[mesh]).max()) for mesh, points in theirs.items())
        assert (moves > 10 * NEAR) == (name != "neutral"), name
    return far
