"""The editor's canvas: what the GPU draws while a hand drags, on the face under work and on all others."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from playwright.sync_api import Page

import omote
from tests.browser.pictures import picture
from tests.browser.waiting import floats, wait_until

OpenPage = Callable[..., Page]
Floats = NDArray[np.float64]

BENCH = "document.querySelector('omote-editor').context.store"
CANVAS = "document.querySelector('omote-editor').shadowRoot.querySelector('canvas')"
FACES = ["generic", "dog", "child", "old"]
TOLERANCE = 1e-6
"""Metres between what the GPU and the page compute in single precision."""
REACH = 5e-5
"""Metres within which a dragged point lies where it was put."""
LIPS = next(line for line in omote.load_cast().space.lines if line.kind == "lips")
CORNER = int(LIPS.loop[omote.load_cast().space.points[LIPS.loop, 0].argmax()])
BESIDE = 2590
"""A vertex of the upper lip, 6 mm from that left corner, on which a control point stands."""
CLOSED = 5e-4
"""Metres by which closed lips may go apart."""


def wait_for(page: Page, condition: str) -> None:
    """Waits until a condition on the `bench` and the canvas' `probe` holds."""
    given = "const bench = document.querySelector('omote-editor')?.context.store; const probe = window.omoteEditor"
    wait_until(page, f"bench && probe && ({condition})", given)


@pytest.fixture
def editor(open_page: OpenPage) -> Page:
    """An editor with a new expression that all faces wear."""
    page = open_page("/editor", width=1280, height=720, fine=True)
    wait_for(page, "bench.online && bench.library !== null")
    page.evaluate(f"{BENCH}.setWork('generic')")
    page.evaluate(f"""() => {BENCH}.ask(
        {{type: "create_expression", label: "Tried on the canvas", start: {{}}, on_air: false}}).then(() => null)""")
    wait_for(page, "probe.needles().length > 50 && probe.settled()")
    return page


def on_gpu(page: Page, face: str) -> Floats:
    """The positions of a face that the GPU draws (rows, 3)."""
    return floats(page, f"window.omoteEditor.readPositions({face!r})").reshape(-1, 3)


def computed(page: Page, face: str) -> Floats:
    """The positions of a face as the page computes them (rows, 3)."""
    return floats(page, f"window.omoteEditor.positions({face!r})").reshape(-1, 3)


def needles(page: Page) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = page.evaluate("window.omoteEditor.needles()")
    return found


def needle_at(page: Page, place: Floats) -> dict[str, Any]:
    """The needle nearest to a place of the generic face, metres."""
    rows = computed(page, "generic")
    return min(needles(page), key=lambda one: float(np.linalg.norm(rows[one["row"]] - place)))


def mouth_corner(page: Page) -> dict[str, Any]:
    """The needle at the left corner of the mouth."""
    lips = computed(page, "generic")[page.evaluate(f"[...{BENCH}.library.lines.get('lips')]")]
    return needle_at(page, lips[lips[:, 0].argmax()])


def on_page(page: Page, place: tuple[float, float]) -> tuple[float, float]:
    """A place of the canvas on the page."""
    box = page.evaluate(f"(() => {{ const r = {CANVAS}.getBoundingClientRect(); return [r.left, r.top]; }})()")
    return box[0] + place[0], box[1] + place[1]


@contextmanager
def held(page: Page, needle: dict[str, Any]) -> Iterator[tuple[float, float]]:
    """A needle under the pressed mouse, as long as the block runs."""
    x, y = on_page(page, needle["head"])
    page.mouse.move(x, y)
    page.mouse.down()
    yield x, y
    page.mouse.up()


def drawn(page: Page, face: str) -> None:
    """Waits until the GPU draws a face where the page computes it, whatever the hand last did."""
    wait_for(
        page,
        f"""(() => {{
            const [drawn, computed] = [probe.readPositions({face!r}), probe.positions({face!r})];
            return drawn.every((value, at) => Math.abs(value - computed[at]) < {TOLERANCE});
        }})()""",
    )


def lead(page: Page, x: float, y: float) -> None:
    """Leads the pressed mouse to a place, and waits for the picture."""
    page.mouse.move(x, y, steps=3)
    wait_for(page, "bench.dragging")


def test_all_faces_follow_while_a_needle_stays_under_the_pointer(editor: Page) -> None:
    needle = mouth_corner(editor)
    rest = {face: computed(editor, face) for face in FACES}
    with held(editor, needle) as (x, y):
        lead(editor, x + 14, y - 9)
        for face in FACES:
            drawn(editor, face)
        after = next(one for one in needles(editor) if one["place"] == needle["place"])
        np.testing.assert_allclose(np.subtract(after["foot"], needle["foot"]), [14, -9], atol=0.02)
        for face in FACES:
            assert np.linalg.norm(on_gpu(editor, face) - rest[face], axis=1).max() > 2e-3
        goal = computed(editor, "generic")[needle["row"]]
    wait_for(editor, "!bench.dragging && probe.settled()")
    drawn(editor, "generic")
    assert np.linalg.norm(on_gpu(editor, "generic")[needle["row"]] - goal) < REACH
    assert set(editor.evaluate("Object.keys(window.omoteEditor.counters().differences)")) == set(FACES)


def opening(page: Page, face: str, before: Floats) -> float:
    """How much farther a face's lips are apart than before (rows, 3), metres, where most."""
    return float((LIPS.rungs(computed(page, face)) - LIPS.rungs(before))[:, 1].max())


@pytest.mark.parametrize(("face", "row"), [("generic", CORNER), ("noh", CORNER), ("baby", CORNER), ("generic", BESIDE)])
def test_one_drag_at_a_corner_of_the_mouth_is_a_crooked_smile_with_closed_lips(
    editor: Page, face: str, row: int
) -> None:
    editor.evaluate(f"{BENCH}.setWork({face!r})")
    wait_for(editor, f"bench.work === {face!r} && probe.settled()")
    rest = computed(editor, face)
    with held(editor, next(one for one in needles(editor) if one["row"] == row)) as (x, y):
        lead(editor, x + 8, y - 14)
        assert opening(editor, face, rest) < CLOSED
    wait_for(editor, "!bench.dragging && probe.settled()")
    assert np.linalg.norm(computed(editor, face)[row] - rest[row]) > 3e-3
    assert opening(editor, face, rest) < CLOSED


def test_escape_puts_everything_back(editor: Page) -> None:
    needle = mouth_corner(editor)
    before = on_gpu(editor, "dog")
    vectors = editor.evaluate("window.omoteEditor.vectors()")
    with held(editor, needle) as (x, y):
        lead(editor, x + 12, y)
        drawn(editor, "dog")
        assert np.abs(on_gpu(editor, "dog") - before).max() > 1e-3
        editor.keyboard.press("Escape")
        drawn(editor, "dog")
        assert editor.evaluate("window.omoteEditor.vectors()") == vectors
        np.testing.assert_allclose(on_gpu(editor, "dog"), before, atol=TOLERANCE)
    assert editor.evaluate(f"{BENCH}.draft.undo") == 0


def test_mirror_moves_the_other_side_too(editor: Page) -> None:
    editor.evaluate(f"{BENCH}.setOptions({{mirror: true}})")
    needle = mouth_corner(editor)
    with held(editor, needle) as (x, y):
        lead(editor, x + 8, y - 8)
        vectors = np.reshape(editor.evaluate("window.omoteEditor.vectors()"), (-1, 3))
        image = editor.evaluate(f"{BENCH}.net.mirror")[needle["place"]]
        assert image != needle["place"]
        np.testing.assert_allclose(vectors[image], vectors[needle["place"]] * [-1, 1, 1], atol=1e-12)
        editor.keyboard.press("Escape")


def test_a_needle_behind_the_head_is_not_taken(editor: Page) -> None:
    needle = mouth_corner(editor)
    editor.evaluate(f"{CANVAS}.focus()")
    editor.keyboard.press("Digit3")  # from the character's right: the left corner is behind the head
    wait_for(editor, "Math.abs(probe.view().yaw) > 1.5")
    hidden = next(one for one in needles(editor) if one["place"] == needle["place"])
    editor.mouse.click(*on_page(editor, hidden["head"]))
    assert needle["place"] not in editor.evaluate(f"[...{BENCH}.selection]")


def test_a_click_on_a_small_face_moves_the_work_there(editor: Page) -> None:
    width, height = editor.evaluate(f"[{CANVAS}.clientWidth, {CANVAS}.clientHeight]")
    editor.mouse.click(*on_page(editor, (width - 30, height / 6)))
    wait_for(editor, "bench.work === 'dog' && probe.settled()")
    assert editor.evaluate("window.omoteEditor.faces()")[:2] == ["dog", "generic"]
    needle = needles(editor)[0]
    assert len(needle["head"]) == 2


def test_a_drag_of_the_ground_turns_the_head_and_a_double_click_resets_it(editor: Page) -> None:
    x, y = on_page(editor, (30, 60))
    editor.mouse.move(x, y)
    editor.mouse.down()
    editor.mouse.move(x + 40, y + 10)
    editor.mouse.move(x + 80, y + 20)
    editor.mouse.up()
    view = editor.evaluate("window.omoteEditor.view()")
    assert view["yaw"] < -0.1
    assert view["pitch"] > 0.02
    editor.mouse.move(x + 100, y + 100)
    editor.mouse.wheel(0, -400)
    wait_for(editor, "probe.view().zoom > 1.2")
    editor.mouse.dblclick(x, y)
    wait_for(editor, "probe.view().zoom === 1 && probe.view().yaw === 0")


def test_arrows_nudge_by_half_a_millimetre(editor: Page) -> None:
    needle = needle_at(editor, np.array([0.0, 0.055, 0.135]))  # the forehead is smooth
    editor.mouse.click(*on_page(editor, needle["head"]))
    before = computed(editor, "generic")[needle["row"]]
    editor.keyboard.press("ArrowUp")
    wait_for(editor, "!bench.dragging && bench.draft.undo === 1 && probe.settled()")
    moved = computed(editor, "generic")[needle["row"]] - before
    assert abs(moved[1] - 0.5e-3) < REACH


def shown(page: Page) -> NDArray[np.int16]:
    """The canvas once all is drawn as well as can be, without needles."""
    page.evaluate(f"{BENCH}.setOptions({{needles: false}})")
    wait_for(page, "probe.settled() && probe.refined()")
    left, top = (round(part) for part in on_page(page, (0, 0)))
    width, height = page.evaluate(f"[{CANVAS}.clientWidth, {CANVAS}.clientHeight]")
    return picture(page)[top : top + height, left : left + width, :3]


def test_faces_wear_their_hair(editor: Page) -> None:
    """Over the crown of a face with dark hair it is dark, of one without any as bright as skin."""
    editor.evaluate(f"{BENCH}.setNeighbours(['kaori', 'noh'])")
    light = {}
    for face in ("kaori", "noh"):
        editor.evaluate(f"{BENCH}.setWork({face!r})")
        editor.evaluate(f"{BENCH}.setOptions({{needles: true}})")
        wait_for(editor, "probe.settled() && probe.needles().length > 50")
        rows = computed(editor, face)
        crown = max(needles(editor), key=lambda one: float(rows[one["row"]][1]))
        x, y = (round(part) for part in crown["foot"])
        light[face] = float(shown(editor)[y + 8 : y + 14, x - 3 : x + 4].mean())
    assert light["kaori"] < 60 < 120 < light["noh"], light


def test_a_drag_leaves_the_picture_that_a_new_one_would_be(editor: Page) -> None:
    """Hair lies still under and over what a hand moves; once all rests nothing of the way there is left."""
    before = shown(editor)
    editor.evaluate(f"{BENCH}.setOptions({{needles: true}})")
    wait_for(editor, "probe.needles().length > 50")
    with held(editor, mouth_corner(editor)) as (x, y):
        lead(editor, x + 25, y - 30)
    wait_for(editor, "!bench.dragging && probe.settled()")
    after = shown(editor)
    editor.keyboard.press("2")
    wait_for(editor, "probe.view().yaw !== 0 && probe.refined()")
    editor.keyboard.press("1")
    wait_for(editor, "probe.view().yaw === 0 && probe.refined()")
    assert np.abs(after - before).max() > 50
    assert np.array_equal(shown(editor), after)
