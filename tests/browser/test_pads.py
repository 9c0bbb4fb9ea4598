"""Pads of looks in a real browser: played and edited at the console, and by two thumbs on the page of one person."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
import pytest
from playwright.sync_api import Locator, Page, expect

from omote.perform.pads.blend_space import Pad, PadLook
from tests.browser.conftest import playing
from tests.browser.waiting import wait_until

OpenPage = Callable[..., Page]

DESK = "document.querySelector('omote-console').context.store"
SOLO = "document.querySelector('omote-solo').store"
SIZES = [(1280, 800, False), (1024, 768, True), (768, 1024, True), (390, 844, True), (844, 390, True)]
CUT = """(name) => {
    const found = [];
    const walk = (root, scrolls) => {
        for (const one of root.querySelectorAll("*")) {
            const inner = scrolls || ["omote-memories", "omote-clip-tiles"].includes(one.localName);
            if (one.shadowRoot) walk(one.shadowRoot, inner);
            const box = one.getBoundingClientRect();
            if (inner || !one.matches("button, select, .field, canvas") || box.width === 0) continue;
            if (box.left < -1 || box.right > innerWidth + 1 || box.top < -1 || box.bottom > innerHeight + 1)
                found.push(`${one.className || one.localName} ${one.textContent.trim()} cut`);
        }
    };
    walk(document.querySelector(name).shadowRoot, false);
    if (document.documentElement.scrollWidth > innerWidth) found.push("the page");
    return found;
}"""


@pytest.fixture(scope="module")
def show(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """A show of its own: its pads are changed."""
    yield from playing(tmp_path_factory.mktemp("pads") / "pads.omote")


def console(open_page: OpenPage, *, pictures: bool = False, **options: bool) -> Page:
    """A console that shows its pads; options: of its context."""
    page = open_page("/console", pictures=pictures, **options)
    wait_until(page, f"document.querySelector('omote-console')?.context.store.state && {DESK}.manifest")
    wait_until(page, f"{DESK}.newest('pad_list') && {DESK}.online")
    page.keyboard.press("Shift+H")
    expect(page.locator("omote-pad-panel")).to_be_visible()
    return page


def field(page: Page, pad: str) -> Locator:
    """The field of a pad."""
    return page.locator(f"[data-pad={pad}] .field")


def at(page: Page, pad: str, x: float, y: float) -> tuple[float, float]:
    """Where a place of a pad lies in the page."""
    box = field(page, pad).bounding_box()
    assert box is not None
    return box["x"] + box["width"] * (0.5 + 0.4 * x), box["y"] + box["height"] * (0.5 - 0.4 * y)


def press(page: Page, *place: float) -> None:
    """Brings the mouse down at a place of the page."""
    page.mouse.move(*place)
    page.mouse.down()


def looks(page: Page, pad: str, store: str = DESK) -> dict[str, list[float]]:
    """The places of a pad's looks, as the show has told. store: of the page."""
    found: dict[str, list[float]] = page.evaluate(
        f"Object.fromEntries({store}.newest('pad_list').pads.find(({{name}}) => name === {pad!r}).looks.map("
        "({label, place}) => [label, place]))"
    )
    return found


def test_the_page_weighs_looks_as_the_engine_does(open_page: OpenPage) -> None:
    page = console(open_page)
    random = np.random.default_rng(36)
    for dimensions in (1, 2, 3):
        places = random.uniform(-1, 1, (7, dimensions)).round(3)
        places[:, 0] = random.permutation(np.linspace(-0.9, 0.9, 7))  # as far apart as a pad asks for
        points = np.concatenate([random.uniform(-1, 1, (40, dimensions)), places])
        pad = Pad(
            "any",
            "expression",
            dimensions,
            tuple(PadLook(f"L{n}", {"joy": 1.0}, tuple(place)) for n, place in enumerate(places)),
        )
        drawn = page.evaluate(
            """([dimensions, places, points]) => {
                const pad = document.createElement("omote-blend-pad");
                const looks = places.map((place, at) => ({ label: `L${at}`, mix: { joy: 1 }, place }));
                pad.pad = { name: "any", part: "expression", dimensions, looks };
                return points.map((point) => pad.weightsAt(point));
            }""",
            [dimensions, places.tolist(), points.tolist()],
        )
        assert np.allclose(drawn, [pad.weights_at(tuple(point)) for point in points], rtol=0, atol=1e-12)


def test_a_point_is_taken_along_and_what_shows_follows_it(open_page: OpenPage) -> None:
    page = console(open_page, pictures=True)
    expect(page.locator("omote-blend-pad .look")).to_have_count(30)
    expect(page.locator("omote-monitor .tally")).to_be_visible()
    neutral = page.locator("omote-monitor").screenshot()
    press(page, *at(page, "moods", 0.6, 0.0))  # far from the dot: it comes to the pointer
    wait_until(page, f"({DESK}.air.expressions.smile ?? 0) > 0.999", told=f"{DESK}.air.pads")
    page.mouse.up()
    assert page.evaluate(f"{DESK}.air.pads.moods") == {
        "place": [pytest.approx(0.6, abs=0.02), pytest.approx(0, abs=0.02)],
        "plays": True,
    }
    while page.locator("omote-monitor").screenshot() == neutral:
        pass  # the picture follows what is on air within a frame or two
    before = page.evaluate(f"{DESK}.air.pads.moods.place")
    x, y = at(page, "moods", before[0] + 0.1, before[1])
    press(page, x, y)  # near it: it stays where it is, and goes along
    page.mouse.move(x - 40, y)
    page.mouse.up()
    box = field(page, "moods").bounding_box()
    assert box is not None
    moved = before[0] - 40 / (0.4 * box["width"])
    wait_until(page, f"Math.abs({DESK}.air.pads.moods.place[0] - {moved}) < 1e-6", told=f"{DESK}.air.pads.moods")
    expect(field(page, "moods").locator(".dot")).to_have_class("carrier dot air")

    field(page, "moods").focus()
    page.keyboard.press("ArrowUp")
    wait_until(page, f"{DESK}.air.pads.moods.place[1] > {before[1]} + 0.04")
    page.keyboard.press("Home")
    wait_until(page, f"({DESK}.air.expressions.neutral ?? 0) > 0.999 && {DESK}.air.pads.moods.plays")
    page.keyboard.press("Shift+Backspace")
    wait_until(page, f"{DESK}.air.pads.moods === undefined")
    expect(field(page, "moods").locator(".read")).to_have_text("not playing")
    expect(field(page, "moods").locator(".dot")).to_have_class("carrier dot")


def test_a_pad_is_made_of_tiles_edited_on_air_and_taken_back(open_page: OpenPage) -> None:
    page = console(open_page)
    page.get_by_role("button", name="New pad …").click()
    page.get_by_label("Name of the new pad").fill("my faces")
    page.get_by_label("What it plays").select_option("face")
    page.get_by_role("button", name="Make").click()
    tile = page.locator(".faces [data-name=child]")
    expect(tile).to_have_attribute("draggable", "true")
    box = field(page, "my-faces").bounding_box()
    assert box is not None
    tile.drag_to(field(page, "my-faces"), target_position={"x": 0.82 * box["width"], "y": 0.5 * box["height"]})
    wait_until(page, f"{DESK}.newest('pad_list').pads.some(({{name}}) => name === 'my-faces')")
    assert looks(page, "my-faces")["Child"] == pytest.approx([0.8, 0.0], abs=0.03)
    page.get_by_label("Add a look: search faces").fill("doll")
    page.keyboard.press("Enter")
    wait_until(page, f"{DESK}.newest('pad_list').pads.find(({{name}}) => name === 'my-faces').looks.length === 3")

    page.locator("[data-pad=my-faces] .done").click()
    press(page, *at(page, "my-faces", 0.5, 0.0))
    wait_until(page, f"({DESK}.air.faces.child ?? 0) > 0.5")
    page.mouse.up()
    place = page.evaluate(f"{DESK}.air.pads['my-faces'].place")
    page.get_by_label("Edit my-faces").click()
    before = looks(page, "my-faces")
    page.evaluate(f"""() => {{
        window.steps = [];
        let last = {DESK}.air.faces.child ?? 0;
        {DESK}.listen("state", () => {{
            const now = {DESK}.air.faces.child ?? 0;
            steps.push(Math.abs(now - last));
            last = now;
        }});
    }}""")
    press(page, *at(page, "my-faces", *before["Child"]))
    page.mouse.move(*at(page, "my-faces", 0.6, -0.7), steps=12)
    page.mouse.up()
    wait_until(page, "Math.max(0, ...steps.slice(-10)) < 1e-9 && steps.length > 20 && Math.max(...steps) > 0")
    assert page.evaluate("Math.max(...steps)") < 0.35  # the whole look within a few frames, and never at once
    assert looks(page, "my-faces")["Child"] == pytest.approx([0.6, -0.7], abs=0.03)
    assert page.evaluate(f"{DESK}.air.pads['my-faces'].place") == place
    page.keyboard.press("Control+z")
    wait_until(
        page,
        f"{DESK}.newest('pad_list').pads.find(({{ name }}) => name === 'my-faces').looks[1].place[0] === back",
        given=f"const back = {before['Child'][0]}",
    )

    page.locator("[data-pad=my-faces] [data-do=keep]").click()  # what shows, where the point is
    wait_until(page, f"{DESK}.newest('pad_list').pads.find(({{name}}) => name === 'my-faces').looks.length === 4")
    assert place in looks(page, "my-faces").values()
    page.locator("[data-pad=my-faces] [data-do=delete]").click()
    wait_until(page, f"!{DESK}.newest('pad_list').pads.some(({{name}}) => name === 'my-faces')")
    page.keyboard.press("Control+z")
    wait_until(page, f"{DESK}.newest('pad_list').pads.some(({{name}}) => name === 'my-faces')")


def test_a_pad_of_poses_is_made_of_tiles_and_plays_the_figure(open_page: OpenPage) -> None:
    page = console(open_page)
    page.evaluate(f"{DESK}.arrange({{ kind: 'poses' }})")
    page.get_by_role("button", name="New pad …").click()
    page.get_by_label("Name of the new pad").fill("moves")
    page.get_by_label("What it plays").select_option("pose")
    page.get_by_role("button", name="Make").click()
    bow = page.locator("omote-pose-tiles .tile[data-name=bow]")
    bow.drag_to(field(page, "moves"), target_position={"x": 20.0, "y": 20.0})
    wait_until(page, f"{DESK}.newest('pad_list').pads.some(({{name}}) => name === 'moves')")
    page.get_by_label("Add a look: search poses").fill("wave")
    page.keyboard.press("Enter")
    wait_until(page, f"{DESK}.newest('pad_list').pads.find(({{name}}) => name === 'moves').looks.length === 3")
    x, y = looks(page, "moves")["Bow"]
    page.locator("[data-pad=moves] .done").click()
    press(page, *at(page, "moves", x, y))
    wait_until(page, f"({DESK}.air.figure?.poses.bow ?? 0) > 0.9")
    page.mouse.up()
    page.locator("[data-pad=moves]").get_by_role("button", name="Rest").click()
    wait_until(page, f"{DESK}.air.figure?.poses.stand === 1")


def test_one_person_plays_two_pads_by_two_thumbs_cues_and_panic(open_page: OpenPage) -> None:
    page = open_page("/solo", pictures=False, width=1024, height=768, has_touch=True)
    wait_until(
        page, f"document.querySelector('omote-solo')?.store.state && {SOLO}.newest('pad_list') && {SOLO}.manifest"
    )
    tools = page.context.new_cdp_session(page)

    def touch(kind: str, *points: tuple[float, float]) -> None:
        touches = [{"x": x, "y": y, "id": n} for n, (x, y) in enumerate(points)]
        tools.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": touches})

    mouth = looks(page, "mouth", SOLO)
    moods = looks(page, "moods", SOLO)
    touch("touchStart", at(page, "mouth", *mouth["Funnel"]))
    touch("touchStart", at(page, "mouth", *mouth["Funnel"]), at(page, "moods", *moods["Surprise"]))
    wait_until(
        page,
        "(air.regions.mouth?.mouthFunnel ?? air.expressions.surprise ?? 0) > 0.9",
        given=f"const {{ air }} = {SOLO}",
        told=f"[{SOLO}.air.regions, {SOLO}.air.pads]",
    )
    touch("touchMove", at(page, "mouth", *mouth["Pout"]), at(page, "moods", *moods["Sad"]))
    wait_until(
        page,
        "(air.regions.mouth?.pout ?? 0) > 0.9 && (air.regions.brows ?? air.expressions).sad > 0.9",
        given=f"const {{ air }} = {SOLO}",
        told=f"[{SOLO}.air.regions, {SOLO}.air.expressions]",
    )
    touch("touchEnd")
    page.keyboard.press("Shift+Backspace")
    wait_until(page, f"Object.keys({SOLO}.air.pads).length === 0")

    page.evaluate(f"{SOLO}.ask({{ type: 'record_cue', cue: '1', label: 'Enter', parts: ['one'], cue_list: 'main' }})")
    wait_until(page, "document.querySelector('omote-solo').cues.list.length === 1")
    page.keyboard.press("Space")
    wait_until(page, "document.querySelector('omote-solo').cues.status.lists.main.current !== null")
    page.keyboard.press("j")
    expect(field(page, "moods")).to_be_focused()


@pytest.mark.parametrize(("width", "height", "touch"), SIZES)
def test_nothing_of_the_page_of_one_person_is_cut_off(
    open_page: OpenPage, width: int, height: int, touch: bool
) -> None:
    page = open_page("/solo", pictures=False, width=width, height=height, has_touch=touch)
    wait_until(
        page, f"document.querySelector('omote-solo')?.store.state && {SOLO}.newest('pad_list') && {SOLO}.manifest"
    )
    expect(page.locator("omote-blend-pad")).to_have_count(2)
    assert page.evaluate(CUT, "omote-solo") == []
    picture, *others = [
        page.locator(name).bounding_box()
        for name in (".face", "[data-pad=mouth]", "[data-pad=moods]", "omote-next-cue")
    ]
    for other in others:
        assert picture
        assert other
        beside = other["x"] >= picture["x"] + picture["width"] or picture["x"] >= other["x"] + other["width"]
        below = other["y"] >= picture["y"] + picture["height"] or picture["y"] >= other["y"] + other["height"]
        assert beside or below


def test_a_phone_on_its_side_reaches_every_part_and_says_what_a_panic_has_stopped(open_page: OpenPage) -> None:
    page = open_page("/solo", pictures=False, width=844, height=390, has_touch=True)
    wait_until(
        page, f"document.querySelector('omote-solo')?.store.state && {SOLO}.newest('pad_list') && {SOLO}.manifest"
    )
    page.evaluate(f"{SOLO}.ask({{ type: 'set_motion', character: 'one', liveliness: 0.4 }})")
    home = "type: 'call_face', id: 'home', character: 'one', name: 'generic', seconds: 0, easing: 'smooth'"
    page.evaluate(f"{SOLO}.ask({{ {home} }})")  # another test may have left another
    wait_until(page, f"{SOLO}.air.motion.liveliness === 0.4 && {SOLO}.air.faces.generic === 1")
    page.keyboard.press("Shift+Backspace")
    wait_until(page, f"{SOLO}.air.motion.liveliness === 0")
    expect(page.locator("[role=status].notice")).to_contain_text("Stopped by panic: liveliness of One.")
    expect(page.locator(".panic")).to_have_text("PANIC")  # the home face shows: a second one brings no other
    expect(page.get_by_role("button", name="Still", exact=True)).to_have_attribute("aria-pressed", "true")
    for row, part in (("lines", "omote-clip-tiles"), ("head", "omote-pad .field"), ("looks", "omote-memories")):
        page.locator(f"[data-row={row}]").click()
        expect(page.locator(part)).to_be_visible()
        assert page.evaluate(CUT, "omote-solo") == []
    page.get_by_role("button", name="Sources on again").click()
    wait_until(page, f"{SOLO}.air.motion.liveliness === 0.4")
    expect(page.get_by_role("button", name="Still", exact=True)).to_have_attribute("aria-pressed", "false")
    page.locator("[data-row=lines]").click()
    page.keyboard.press("z")
    for target in ("/omote/go", "/omote/back", "/omote/black", "/omote/one/pad/mouth", "/omote/one/stop_clip"):
        expect(page.locator(f".spot[data-to='{target}']")).to_be_visible()
    assert page.evaluate(CUT, "omote-solo") == []
    bar, picture = (page.get_by_label(name, exact=True).bounding_box() for name in ("Learn", "On air"))
    assert bar
    assert picture
    assert bar["y"] + bar["height"] <= picture["y"]


def test_no_key_lies_on_the_picture_while_pads_are_open(open_page: OpenPage) -> None:
    page = console(open_page)
    for width, height in ((1440, 900), (1280, 800), (1024, 768)):
        page.set_viewport_size({"width": width, "height": height})
        picture, keys = (page.locator(name).bounding_box() for name in ("omote-monitor", "omote-characters"))
        assert picture
        assert keys
        assert picture["y"] + picture["height"] <= keys["y"] + 1
        assert picture["height"] > 120


def test_a_finger_carries_a_tile_onto_a_pad_that_is_edited(open_page: OpenPage) -> None:
    page = console(open_page, has_touch=True)
    before = looks(page, "moods")
    page.get_by_label("Edit moods").click()
    tools = page.context.new_cdp_session(page)

    def touch(kind: str, *points: tuple[float, float]) -> None:
        touches = [{"x": x, "y": y} for x, y in points]
        tools.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": touches})

    page.locator(".expressions [data-name=kiss]").scroll_into_view_if_needed()
    tile = page.locator(".expressions [data-name=kiss]").bounding_box()
    assert tile is not None
    touch("touchStart", (tile["x"] + 20, tile["y"] + 20))
    expect(page.locator("body > span", has_text="Kiss")).to_be_visible()  # it is in the hand
    there = at(page, "moods", 0.8, -0.9)
    touch("touchMove", (there[0] - 9, there[1]))
    touch("touchMove", there)
    touch("touchEnd")
    wait_until(
        page, f"{DESK}.newest('pad_list').pads.find(({{name}}) => name === 'moods').looks.length > {len(before)}"
    )
    assert looks(page, "moods")["Kiss"] == pytest.approx([0.8, -0.9], abs=0.03)
    assert page.evaluate(f"{DESK}.air.expression_call") is None, "the tile was not called"
    page.keyboard.press("Control+z")
    wait_until(
        page, f"{DESK}.newest('pad_list').pads.find(({{name}}) => name === 'moods').looks.length === {len(before)}"
    )
