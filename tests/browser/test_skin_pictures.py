"""Pictures of certain people's skin on stage: where they cover, where not, and half-way to a painted face."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import closing
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray
from playwright.sync_api import Page

import omote
from omote.edit.store.import_items import ImportedItem, changes_to_import
from omote.model.albedo import Albedo
from omote.model.recipes.compose_face import FaceWithLook, compose_face
from omote.model.recipes.recipe import FaceRecipe
from omote.showfile.changes import Stored
from omote.showfile.show_file import open_show
from tests.browser.conftest import playing
from tests.browser.pictures import picture
from tests.browser.test_editor import SETTLED, Editor, editor, wait_for

__all__ = ["editor"]

pytestmark = pytest.mark.long

SIDE = 1024
SQUARE = 32
"""Texels along a side of the chequer's squares."""


OPEN = """async label => {
    const { store } = document.querySelector("omote-editor").context;
    await store.ask({ type: "open_item", item: store.items.find((each) => each.label === label).id });
}"""
LOSE = """async () => {
    const canvas = document.querySelector("canvas");
    const handle = canvas.getContext("webgl2").getExtension("WEBGL_lose_context");
    const happens = (what) => new Promise((done) => canvas.addEventListener(what, done, { once: true }));
    const lost = happens("webglcontextlost");
    handle.loseContext();
    await lost;
    const restored = happens("webglcontextrestored");
    setTimeout(() => handle.restoreContext());
    await restored;
}"""


def chequer() -> Albedo:
    """Red and green squares over the half of the texture with the character's left cheek; nothing over the other."""
    rows, columns = np.indices((SIDE, SIDE)) // SQUARE
    texels = np.zeros((SIDE, SIDE, 4), np.uint8)
    texels[..., 0] = np.where((rows + columns) % 2, 200, 10)
    texels[..., 1] = 210 - texels[..., 0]
    texels[:, SIDE // 2 :, 3] = 255
    return Albedo(texels)


@pytest.fixture(scope="module")
def show(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """A show with two own faces, both of kaori's shape: under the chequer, and half-way from there to kaori."""
    cast = omote.load_cast()
    path = tmp_path_factory.mktemp("pictures") / "pictures.omote"
    kaori = FaceWithLook(cast.faces["kaori"], cast.looks["kaori"])
    under = FaceWithLook(kaori.face, replace(kaori.look, albedo=chequer()))
    half = compose_face(cast.space, "half", FaceRecipe({"kaori": 0.5, "own": 0.5}), {"kaori": kaori, "own": under})
    items = [ImportedItem("chequered", (under.face, under.look)), ImportedItem("half", (half.face, half.look))]
    with closing(open_show(path)) as file:
        file.apply(changes_to_import(cast, Stored(), items, wall=0.0))
    yield from playing(path)


@pytest.fixture
def stage(held_stage: Callable[..., Page], request: pytest.FixtureRequest) -> Page:
    return held_stage(f"?quality={request.param}&light=flat", width=320, height=320)


def look(page: Page, faces: dict[str, float]) -> NDArray[np.int16]:
    page.evaluate("faces => window.omoteStage.hold({ faces })", faces)
    return picture(page)[..., :3]


@pytest.mark.parametrize("stage", ["lowest", "medium"], indirect=True)
def test_a_picture_shows_where_it_covers_and_mixes_in_linear_light(stage: Page) -> None:
    painted = look(stage, {"kaori": 1.0})
    under = look(stage, {"chequered": 1.0})
    cheeks = np.s_[165:200, 95:225]
    redder = (under - painted)[cheeks][..., 0] - (under - painted)[cheeks][..., 1]
    there = redder[:, 80:]
    assert (there > 40).mean() > 0.2
    assert (there < -40).mean() > 0.2
    assert np.abs((under - painted)[cheeks][:, :50]).max() <= 1
    live = look(stage, {"chequered": 0.5, "kaori": 0.5})
    baked = look(stage, {"half": 1.0})
    assert np.abs(live - baked).mean() < 0.5
    assert np.percentile(np.abs(live - baked), 99.9) <= 4


@pytest.mark.parametrize("stage", ["lowest"], indirect=True)
def test_a_picture_comes_back_with_a_lost_context(stage: Page) -> None:
    before = look(stage, {"chequered": 1.0})
    stage.evaluate(LOSE)
    np.testing.assert_array_equal(look(stage, {"chequered": 1.0}), before)


def work(page: Page, label: str) -> NDArray[np.int16]:
    """The large picture of an own face at rest in the editor."""
    page.evaluate(OPEN, label)
    wait_for(page, f"bench.item?.label === {label!r} && {SETTLED} && canvas.refined()")
    box = page.locator("omote-editor main .work canvas").first.bounding_box()
    assert box is not None
    across = slice(int(box["x"]), int(box["x"] + 0.65 * box["width"]))
    return picture(page)[int(box["y"]) : int(box["y"] + box["height"]), across, :3]


def test_the_editor_shows_the_picture_of_a_face_and_of_a_mix(editor: Editor) -> None:
    page = editor(fine=True)
    under = work(page, "chequered")
    half = work(page, "half")
    redder, mixed = (each[..., 0] - each[..., 1] for each in (under, half))
    squares = redder < -40  # skin is never green
    assert squares.mean() > 0.02
    middle = under.shape[1] // 2
    assert squares[:, middle:].sum() > 20 * squares[:, :middle].sum(), "it covers the left half alone"
    assert (mixed < -40).sum() < 0.1 * squares.sum(), "half of it is skin"
    assert np.median((mixed - redder)[squares]) > 20
