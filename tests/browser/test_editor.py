"""The editor page, used as an artist uses it: by mouse, by keyboard, by two at once, and over a link that breaks."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from playwright.sync_api import FilePayload, Locator, Page, Route, WebSocketRoute, expect

from tests.browser.waiting import floats, wait_until

OpenPage = Callable[..., Page]
Editor = Callable[..., Page]

BENCH = "document.querySelector('omote-editor').context.store"
SETTLED = "bench.draft !== null && canvas !== undefined && canvas.settled()"
REACH = 5e-5
"""Metres within which a dragged point lies where it was put."""


@pytest.fixture
def editor(open_page: OpenPage) -> Editor:
    """Opens an editor, each one somebody else, and waits until it is greeted and draws.

    It shows Kaori and the faces `beside` her: each one costs as much as all else on the page.
    """

    def open_one(path: str = "/editor", *, beside: Sequence[str] = (), **options: Any) -> Page:
        view = {"work": "kaori", "neighbours": beside, "mirror": False}
        page = open_page(path, kept={"omote-editor-view": view}, **options)
        wait_for(page, "bench.online && bench.library !== null && canvas !== undefined")
        return page

    return open_one


def wait_for(page: Page, condition: str) -> None:
    """Waits until a condition on the `bench` or the `canvas` (its probe) holds."""
    given = "const bench = document.querySelector('omote-editor')?.context.store; const canvas = window.omoteEditor"
    wait_until(page, f"bench && ({condition})", given)


def bench(page: Page, expression: str) -> Any:
    """What an expression on the bench gives."""
    return page.evaluate(f"{BENCH}.{expression}")


def make(page: Page, label: str, start: str | None = None) -> None:
    """A new expression by the buttons of the page, opened and worn by all faces."""
    page.locator("[data-new]").click()
    form = page.get_by_role("form", name="New expression")
    form.get_by_label("Name").fill(label)
    if start is not None:
        form.get_by_label("Begin from").select_option(label=start)
    form.get_by_role("button", name="Create").click()
    wait_for(page, f"bench.item?.label === {label!r} && {SETTLED}")


def mouth_corner(page: Page) -> dict[str, Any]:
    """The needle nearest to the left end of the lips that a click finds; it is then selected."""
    lips = floats(page, f"{BENCH}.library.lines.get('lips')").astype(int)
    rows = positions(page, str(bench(page, "work")))
    corner = rows[lips[rows[lips, 0].argmax()]]
    needles = page.evaluate("window.omoteEditor.needles()")
    for one in sorted(needles, key=lambda each: float(np.linalg.norm(rows[each["row"]] - corner))):
        page.mouse.click(*head_of(page, one))
        chosen = page.evaluate(f"[...{BENCH}.selection]")
        if chosen:
            return next(dict(each) for each in needles if each["place"] == chosen[0])
    pytest.fail("no needle can be taken")


def head_of(page: Page, one: dict[str, Any]) -> tuple[float, float]:
    """Where a needle's head is on the page, pixels."""
    box = page.locator("omote-editor main .work canvas").first.bounding_box()
    assert box is not None
    return box["x"] + one["head"][0], box["y"] + one["head"][1]


def positions(page: Page, face: str) -> NDArray[np.float64]:
    """What a face shows, (rows, 3) metres."""
    return floats(page, f"window.omoteEditor.positions({face!r})").reshape(-1, 3)


def vectors(page: Page) -> NDArray[np.float64]:
    """The control vectors as the hand has them, (n, 3)."""
    return floats(page, "window.omoteEditor.vectors()").reshape(-1, 3)


def grip(page: Page, one: dict[str, Any]) -> tuple[float, float]:
    """Takes a needle in hand; where the pointer then is."""
    x, y = head_of(page, one)
    page.mouse.move(x, y)
    page.mouse.down()
    return x, y


def drag(page: Page, one: dict[str, Any], dx: float = 9, dy: float = -12) -> None:
    """Drags a needle by so many pixels, until the server's answer is worn."""
    steps = int(bench(page, "draft.undo"))
    x, y = grip(page, one)
    page.mouse.move(x + dx, y + dy, steps=5)
    page.mouse.up()
    wait_for(page, f"bench.draft.undo === {steps + 1} && {SETTLED}")


def save(page: Page) -> None:
    """Saves by the keyboard."""
    page.keyboard.press("Control+s")
    wait_for(page, "!bench.draft.dirty && bench.item.head > 0")


def notice(page: Page) -> Locator:
    return page.locator("omote-notices [role]")


# --- one artist -------------------------------------------------------------------------------------------------------


def test_a_newcomer_makes_a_crooked_smile_with_what_the_page_says(editor: Editor, open_page: OpenPage) -> None:
    page = editor()
    expect(page.locator(".welcome li")).to_have_count(3)
    page.locator(".welcome").get_by_role("button", name="New expression").click()
    page.get_by_label("Name", exact=True).fill("Crooked smile")
    page.get_by_role("button", name="Create").click()
    wait_for(page, SETTLED)
    expect(page.locator(".welcome")).to_have_count(0)
    expect(page.locator(".hint")).to_contain_text("Drag a white pin (a needle)")
    drag(page, mouth_corner(page))
    page.get_by_role("button", name="Save").click()
    expect(notice(page)).to_contain_text("is now under Own")
    console = open_page("/console", pictures=False)
    console.locator("[data-kind='own']").click()  # where the page said that it is
    tile = console.locator(".expressions .tile", has_text="Crooked smile")
    tile.click()
    name = tile.get_attribute("data-name")
    desk = "document.querySelector('omote-console').context.store"
    expect(tile).to_have_class(re.compile(r"\bair\b"))
    assert console.evaluate(f"{desk}.air.expressions[{name!r}]") > 0
    console.evaluate(f"{desk}.panic()")


def test_all_faces_follow_while_a_needle_is_dragged_and_it_lies_where_it_was_put(editor: Editor) -> None:
    page = editor(beside=("dog", "child", "old"))
    make(page, "Follow me")
    faces = page.evaluate("window.omoteEditor.faces()")
    assert len(faces) >= 4
    assert "dog" in faces
    before = {face: positions(page, face) for face in faces}
    corner = mouth_corner(page)
    x, y = grip(page, corner)
    page.mouse.move(x + 9, y - 12, steps=5)
    wait_for(page, "bench.dragging")
    for face in faces:  # before the server has heard of it
        moved = np.linalg.norm(positions(page, face) - before[face], axis=1)
        assert moved[corner["row"]] > 1e-3, face
    page.mouse.up()
    wait_for(page, f"bench.draft.undo === 1 && {SETTLED}")
    assert bench(page, "draft.miss") <= REACH


def test_undo_and_redo_go_back_and_forth_exactly_and_name_their_steps(editor: Editor) -> None:
    page = editor()
    make(page, "Back and forth")
    still = vectors(page)
    drag(page, mouth_corner(page))
    smiled = vectors(page)
    drag(page, mouth_corner(page), dx=-6, dy=4)
    undo = page.locator("[data-step=undo]")
    redo = page.locator("[data-step=redo]")
    expect(undo).to_contain_text("drag")
    page.keyboard.press("Control+z")
    wait_for(page, f"bench.draft.redo === 1 && {SETTLED}")
    np.testing.assert_array_equal(vectors(page), smiled)
    undo.click()
    wait_for(page, f"bench.draft.redo === 2 && {SETTLED}")
    np.testing.assert_array_equal(vectors(page), still)
    expect(undo).to_be_disabled()
    redo.click()
    wait_for(page, f"bench.draft.redo === 1 && {SETTLED}")
    np.testing.assert_array_equal(vectors(page), smiled)


def test_typed_numbers_move_the_selected_needle_and_nonsense_is_refused(editor: Editor) -> None:
    page = editor()
    make(page, "Numbers")
    place = mouth_corner(page)["place"]
    page.evaluate(f"{BENCH}.select([{place}])")
    page.locator("[data-tab=points]").click()
    height = page.get_by_label("Height")
    height.fill("3,5")
    height.press("Enter")
    wait_for(page, f"bench.draft.undo === 1 && {SETTLED}")
    assert vectors(page)[place, 1] == pytest.approx(0.0035)
    height.fill("high")
    height.press("Enter")
    expect(notice(page)).to_contain_text('"high" is not a number')
    page.get_by_role("button", name="Reset selected").click()
    wait_for(page, f"bench.draft.undo === 2 && {SETTLED}")
    np.testing.assert_array_equal(vectors(page)[place], [0, 0, 1])


def test_layers_muscles_and_eyes_make_steps_and_bake_into_one(editor: Editor) -> None:
    page = editor(beside=("dog",))
    make(page, "Composed", start="Smile")
    start = positions(page, "dog")
    page.locator("[data-tab=layers]").click()
    page.get_by_label("Add a layer").select_option(label="Surprise")
    wait_for(page, f"bench.draft.undo === 1 && {SETTLED}")
    page.get_by_label("Region of Surprise").select_option("brows")
    wait_for(page, f"bench.draft.undo === 2 && {SETTLED}")
    page.locator("[data-tab=muscles]").click()
    muscle = page.locator("[data-muscle]").first.locator("input[type=text]")
    muscle.fill("80")
    muscle.press("Enter")
    wait_for(page, f"bench.draft.undo === 3 && {SETTLED}")
    composed = positions(page, "dog")
    assert np.abs(composed - start).max() > 1e-3
    page.locator("[data-tab=layers]").click()
    page.get_by_role("button", name="Bake into one").click()
    wait_for(page, f"bench.draft.undo === 4 && {SETTLED}")
    assert bench(page, "recipe.layers.length") == 0
    assert bench(page, "recipe.pulls.length") == 0
    # the wire rounds compounds to counts
    np.testing.assert_allclose(positions(page, "dog"), composed, atol=2e-5)


def test_layers_show_while_weighed_and_are_muted_and_heard_alone(editor: Editor) -> None:
    page = editor(beside=("dog",))
    make(page, "Weighed", start="Smile")
    smiling = positions(page, "dog")
    page.locator("[data-tab=layers]").click()
    weight = page.locator("[data-layer='0'] input[type=range]")
    box = weight.bounding_box()
    assert box is not None
    y = box["y"] + box["height"] / 2
    page.mouse.move(box["x"] + box["width"] * 0.7, y)
    page.mouse.down()
    page.mouse.move(box["x"] + 12, y, steps=4)
    wait_for(page, f"bench.layerPreview.content !== null && {SETTLED}")
    assert np.abs(positions(page, "dog") - smiling).max() > 1e-3, "all faces follow before the hand lets go"
    assert (bench(page, "draft.undo"), bench(page, "recipe.layers[0].weight")) == (0, 1)
    page.mouse.up()
    wait_for(page, f"bench.draft.undo === 1 && bench.layerPreview.content === null && {SETTLED}")
    weighed = positions(page, "dog")
    page.get_by_label("Add a layer").select_option(label="Surprise")
    wait_for(page, f"bench.draft.undo === 2 && {SETTLED}")
    both = positions(page, "dog")
    mute = page.get_by_role("button", name="Mute Surprise")
    mute.press("Enter")
    wait_for(page, f"bench.draft.undo === 3 && {SETTLED}")
    expect(mute).to_have_attribute("aria-pressed", "true")
    np.testing.assert_allclose(positions(page, "dog"), weighed, atol=2e-5)
    page.get_by_role("button", name="Solo Surprise").press("Enter")
    expect(page.locator(".looking")).to_contain_text('"Surprise" alone')
    wait_for(page, f"bench.layerPreview.content !== null && {SETTLED}")
    assert np.abs(positions(page, "dog") - both).max() > 1e-3
    assert np.abs(positions(page, "dog") - weighed).max() > 1e-3
    page.locator("canvas[tabindex='0']").focus()
    page.keyboard.press("Escape")
    wait_for(page, f"bench.layerPreview.solo.size === 0 && {SETTLED}")
    np.testing.assert_allclose(positions(page, "dog"), weighed, atol=2e-5)
    assert bench(page, "draft.undo") == 3, "solo is no step"


def test_what_is_loading_is_said_instead_of_a_blank_page(editor: Editor) -> None:
    page = editor()
    held: list[Route] = []
    page.route("**/manifest", lambda route: held.append(route))
    page.reload(wait_until="commit")
    bar = page.get_by_role("progressbar", name="Loading the faces")
    expect(bar).to_be_visible()
    expect(page.get_by_text("Fetching the cast")).to_be_visible()
    held[0].continue_()
    expect(bar).to_have_count(0)


def test_who_leaves_an_item_is_not_said_to_be_at_it_any_more(editor: Editor) -> None:
    first = editor()
    second = editor()
    make(first, "For two")
    second.get_by_role("button", name="Open For two").click()
    wait_for(second, f"bench.item?.label === 'For two' && {SETTLED}")
    told = first.get_by_role("status").filter(has_text="is at it too")
    expect(told).to_be_visible()
    make(second, "For one")
    expect(told).to_have_count(0)


def test_save_and_the_name_are_in_sight_on_a_phone(editor: Editor) -> None:
    page = editor(width=390, height=844, has_touch=True)
    width = 390
    make(page, "On a phone")
    save = page.get_by_role("button", name="Save")
    name = page.get_by_label("Name", exact=True)
    for place in (save.bounding_box(), name.bounding_box()):
        assert place is not None
        assert place["width"] > 70, "wide enough to read and to hit"
        assert place["x"] >= 0
        assert place["x"] + place["width"] <= width
    assert page.evaluate("document.documentElement.scrollWidth") <= width


def test_an_old_revision_is_looked_at_compared_and_brought_back(editor: Editor) -> None:
    page = editor(beside=("child",))
    make(page, "Two states")
    first = positions(page, "child")
    save(page)
    drag(page, mouth_corner(page))
    save(page)
    second = positions(page, "child")
    page.locator("[data-tab=history]").click()
    old = page.locator("[data-revision='1']")
    old.get_by_role("button", name="Look").click()
    expect(page.locator(".looking")).to_contain_text("old revision")
    wait_for(page, SETTLED)
    np.testing.assert_allclose(positions(page, "child"), first, atol=2e-5)
    page.keyboard.press("Escape")
    wait_for(page, f"bench.look === null && {SETTLED}")
    np.testing.assert_allclose(positions(page, "child"), second, atol=2e-5)
    old.get_by_role("button", name="Compare").click()
    expect(page.get_by_role("dialog", name="Comparison")).to_contain_text("They differ by up to")
    page.get_by_role("dialog").get_by_role("button", name="Close").click()
    old.get_by_role("button", name="Bring back").click()
    wait_for(page, f"bench.draft.dirty && {SETTLED}")
    np.testing.assert_allclose(positions(page, "child"), first, atol=2e-5)


def test_a_reload_finds_the_draft_with_its_steps(editor: Editor) -> None:
    page = editor()
    make(page, "Kept")
    drag(page, mouth_corner(page))
    drawn = vectors(page)
    page.reload()
    wait_for(page, f"bench.item?.label === 'Kept' && {SETTLED}")
    np.testing.assert_array_equal(vectors(page), drawn)
    assert bench(page, "draft.undo") == 1
    assert bench(page, "draft.dirty") is True


def test_items_are_renamed_tagged_found_copied_deleted_and_brought_back(editor: Editor) -> None:
    page = editor()
    make(page, "Grumble")
    save(page)
    label = page.get_by_label("Name", exact=True)
    label.fill("Grumpy")
    label.press("Enter")
    tags = page.get_by_label("Tags", exact=True)
    tags.fill("act two, angry")
    tags.press("Enter")
    wait_for(page, "bench.item.label === 'Grumpy' && bench.item.tags.length === 2")
    own = page.locator("omote-item-list li.item")
    page.get_by_label("Search by name or tag").fill("act grum")
    expect(own).to_have_count(1)
    page.get_by_label("Duplicate: Grumpy").click()
    expect(own).to_have_count(2)
    page.get_by_label("Delete: Grumpy copy").click()
    expect(own).to_have_count(1)
    page.get_by_role("button", name="Undo", exact=True).last.click()
    expect(own).to_have_count(2)
    page.get_by_label("Delete: Grumpy copy").dblclick()  # the second click falls where the next one came
    expect(own).to_have_count(1)
    page.keyboard.press("Control+z")
    expect(own).to_have_count(2)
    expect(own.nth(1)).not_to_contain_text("not saved")
    count = int(bench(page, "items.length"))
    page.locator("omote-item-list [data-new]").dblclick()
    page.get_by_role("button", name="Create").dblclick()
    wait_for(page, f"bench.items.length === {count + 1} && bench.item?.label === 'New expression'")
    expect(page.locator("omote-new")).to_have_count(0)


# --- two artists ------------------------------------------------------------------------------------------------------


def test_whoever_saves_second_is_told_and_chooses(editor: Editor) -> None:
    anna = editor()
    make(anna, "Ours")
    drag(anna, mouth_corner(anna))
    save(anna)
    ben = editor(f"/editor#{bench(anna, 'item.name')}")
    wait_for(ben, SETTLED)
    expect(ben.locator(".others")).to_contain_text("at it too")
    drag(ben, mouth_corner(ben), dx=-8, dy=8)
    drag(anna, mouth_corner(anna), dx=4, dy=-8)
    save(anna)
    ben.keyboard.press("Control+s")
    expect(notice(ben).filter(has_text="saved")).to_contain_text("meanwhile")
    mine = vectors(ben)
    ben.get_by_role("button", name="Look at theirs").click()
    wait_for(ben, "bench.look === bench.item.content")
    ben.keyboard.press("Escape")
    np.testing.assert_array_equal(vectors(ben), mine)
    ben.locator("[data-tab=history]").click()
    expect(ben.locator("[data-revision='3']")).to_contain_text("aside")
    head = bench(ben, "item.head")
    ben.keyboard.press("Control+s")
    wait_for(ben, f"bench.item.head > {head}")
    assert bench(ben, "item.content") == bench(ben, "draft.content")


# --- a link that breaks -----------------------------------------------------------------------------------------------


def test_a_drag_made_while_the_link_is_lost_arrives_when_it_is_back(editor: Editor) -> None:
    page = editor(disposable=True)
    links: list[WebSocketRoute] = []
    away = [False]

    def carry(link: WebSocketRoute) -> None:
        if away[0]:
            link.close()
        else:
            link.connect_to_server()
            links.append(link)

    page.route_web_socket("**/editing", carry)
    page.reload()
    wait_for(page, "bench.online && bench.library !== null && canvas !== undefined")
    make(page, "Over a bad link")
    corner = mouth_corner(page)
    away[0] = True
    links[-1].close()
    expect(page.locator(".lost[role='alert']")).to_contain_text("LINK LOST")
    x, y = grip(page, corner)
    page.mouse.move(x + 9, y - 12, steps=5)
    page.mouse.up()
    page.keyboard.press("Control+s")
    expect(notice(page)).to_contain_text("Save: not sent")
    away[0] = False
    wait_for(page, f"bench.online && bench.draft.undo === 1 && {SETTLED}")
    assert np.abs(vectors(page)[corner["place"]] - [0, 0, 1]).max() > 0
    assert bench(page, "draft.miss") <= REACH


# --- hands of all kinds -----------------------------------------------------------------------------------------------


def test_every_control_has_a_name_and_fingers_find_room(editor: Editor) -> None:
    page = editor(has_touch=True, is_mobile=True)
    make(page, "For fingers")
    small = page.evaluate("""() => {
        const found = [];
        const look = (root) => {
            for (const one of root.querySelectorAll("*")) {
                if (one.shadowRoot) look(one.shadowRoot);
                if (!one.matches("button, select, input")) continue;
                const box = one.getBoundingClientRect();
                const label = one.getAttribute("aria-label") || one.title || one.textContent.trim()
                    || one.labels?.[0]?.textContent.trim();
                if (!label) found.push(`${one.outerHTML} has no name`);
                if (one.matches("button") && box.height > 0 && box.height < 40) found.push(`${label}: ${box.height}`);
            }
        };
        look(document);
        return found;
    }""")
    assert small == []


def test_keys_take_up_tools_and_a_question_mark_opens_the_help(editor: Editor) -> None:
    page = editor()
    make(page, "Keys")
    page.locator("omote-editor main .work canvas").first.focus()
    for key, tool in (("p", "pull"), ("a", "add"), ("r", "remove"), ("m", "place"), ("d", "drag")):
        page.keyboard.press(key)
        assert bench(page, "options.tool") == tool
    page.keyboard.press("x")
    assert bench(page, "options.mirror") is True
    page.keyboard.press("?")
    expect(page.get_by_role("dialog", name="Keys")).to_be_visible()
    page.keyboard.press("Escape")
    expect(page.get_by_role("dialog", name="Keys")).to_have_count(0)


def test_the_list_of_faces_closes_by_escape_and_by_going_on_elsewhere(editor: Editor) -> None:
    page = editor()
    shown = page.get_by_role("group", name="Faces shown")
    button = page.locator("omote-faces-choice button")
    button.click()
    box = shown.bounding_box()
    page.get_by_label("Cat beside").check()
    assert shown.bounding_box() == box  # whatever the button says by now
    page.keyboard.press("Escape")
    expect(shown).to_have_count(0)
    button.click()
    page.get_by_label("Search by name or tag").click()
    expect(shown).to_have_count(0)


def test_a_reload_shows_the_faces_and_the_mirror_that_were_chosen(editor: Editor) -> None:
    page = editor()
    make(page, "As I left it")
    page.evaluate(f"{BENCH}.setWork('dog')")
    page.evaluate(f"{BENCH}.setNeighbours(['cat', 'old'])")
    page.locator("[data-option=mirror]").click()
    page.reload()
    wait_for(page, SETTLED)
    assert page.evaluate("window.omoteEditor.faces()") == ["dog", "cat", "old"]
    assert bench(page, "options.mirror") is True


def test_mirror_moves_the_muscles_of_both_sides(editor: Editor) -> None:
    page = editor()
    make(page, "Both cheeks")
    page.locator("[data-tab=muscles]").click()
    page.locator("[data-option=mirror]").click()
    muscle = page.locator("[data-muscle=zygomaticus_left] input[type=text]")
    muscle.fill("70")
    muscle.press("Enter")
    wait_for(page, f"bench.draft.undo === 1 && {SETTLED}")
    pulls = {one["muscle"]: one["contraction"] for one in bench(page, "recipe.pulls")}
    assert pulls == {"zygomaticus_left": 0.7, "zygomaticus_right": 0.7}


def test_an_own_face_has_a_picture_as_soon_as_it_is_saved(editor: Editor) -> None:
    page = editor()
    page.evaluate(f"""() => {BENCH}.ask(
        {{type: "create_face", label: "Pictured", base: {{goblin: 1}}, on_air: false}}).then(() => null)""")
    wait_for(page, "bench.item?.label === 'Pictured' && bench.face !== null")
    expect(page.locator("[data-kind=face]")).to_have_attribute("aria-selected", "true")
    save(page)
    source = bench(page, "item.content")
    canvas = page.locator("omote-item-list .item.open canvas")
    expect(canvas).to_have_attribute("data-drawn", f"{source} neutral")
    level = canvas.evaluate(
        "one => one.getContext('2d').getImageData(one.width / 2, one.height / 2, 1, 1).data.slice(0, 3).join()"
    )
    assert max(int(part) for part in level.split(",")) > 80  # its skin, not black


def test_the_list_shows_the_item_that_has_just_been_opened(editor: Editor) -> None:
    page = editor()
    page.set_viewport_size({"width": 1280, "height": 600})
    for label in ("Above one", "Above two", "Above three", "Above four", "Below them"):
        page.evaluate(f"""() => {BENCH}.ask(
            {{type: "create_face", label: {label!r}, base: {{goblin: 1}}, on_air: false}}).then(() => null)""")
        wait_for(page, f"bench.item?.label === {label!r} && bench.face !== null")
    row = page.locator("omote-item-list .item.open")
    expect(row).to_have_attribute("data-item", str(bench(page, "item.name")))
    expect(row).to_be_in_viewport(ratio=1)
    page.locator("omote-item-list .list").evaluate("one => { one.scrollTop = 0; }")
    expect(row).not_to_be_in_viewport(ratio=1)
    page.get_by_label("Search by name or tag").press("Tab")
    expect(row).not_to_be_in_viewport(ratio=1)  # who scrolls away from what is open stays there
    other = editor()  # where expressions were listed, and what takes in scans comes with the faces
    other.set_viewport_size({"width": 1280, "height": 600})
    other.evaluate(f"""() => {BENCH}.ask(
        {{type: "create_face", label: "Last of all", base: {{goblin: 1}}, on_air: false}}).then(() => null)""")
    row = other.locator("omote-item-list .item.open")
    expect(row).to_have_attribute("data-item", "last_of_all")
    wait_for(other, "bench.face !== null")
    expect(row).to_be_in_viewport(ratio=1)


def test_what_is_saved_is_downloaded_by_a_button_and_what_is_not_says_why(editor: Editor) -> None:
    page = editor()
    make(page, "Goes out", "Smile")
    page.get_by_role("tab", name="Import & export").click()
    button = page.get_by_role("button", name="Download goes_out.json")
    expect(button).to_be_disabled()
    expect(page.locator("omote-exchange")).to_contain_text("Save first")
    save(page)
    with page.expect_download() as coming:
        button.click()
    document = json.loads(Path(coming.value.path()).read_text())
    assert (coming.value.suggested_filename, document["label"]) == ("goes_out.json", "Goes out")
    page.route("**/exports/*", lambda route: route.fulfill(status=503, body="the disk is full."))
    button.click()
    expect(notice(page).filter(has_text="The disk is full.")).to_be_visible()
    files = {"goes_out.json": json.dumps(document).encode(), "notes.json": b"words"}
    page.get_by_label("Import expressions").set_input_files(
        [FilePayload(name=name, mimeType="application/json", buffer=data) for name, data in files.items()]
    )
    known = "Nothing new in goes_out.json: Goes out is there already."
    expect(notice(page).filter(has_text=known)).to_be_visible()
    expect(notice(page).filter(has_text="notes.json was not taken in: ")).to_be_visible()
    expect(page.get_by_role("button", name="Open Goes out")).to_have_count(1)
