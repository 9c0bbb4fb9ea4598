"""The face editor, used as an artist uses it: handles dragged in three dimensions, a mix, a caricature, undo."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from playwright.sync_api import Locator, Page, Route, expect

from omote import load_cast
from tests.browser.test_console import console
from tests.browser.test_editor import BENCH, SETTLED, bench, editor, notice, positions, save, wait_for
from tests.interchange.formats.scenes import taken_apart

__all__ = ["console", "editor"]

Console = Callable[..., Page]
Editor = Callable[..., Page]

SHEET = np.flatnonzero(load_cast().space.on_sheet)
REACH = 5e-5
"""Metres within which a dragged handle lies where it was put."""


def make_face(page: Page, label: str) -> None:
    page.evaluate(f"""async () => {{
        await {BENCH}.ask({{ type: "create_face", label: {label!r}, base: {{ kaori: 1 }}, on_air: false }});
    }}""")
    wait_for(page, f"bench.item?.label === {label!r} && {SETTLED}")


def handle(page: Page, label: str) -> dict[str, Any]:
    """A handle by its name, as it stands on the canvas."""
    return next(one for one in page.evaluate("window.omoteEditor.needles()") if one["label"] == label)


def drag_handle(page: Page, label: str, dx: float, dy: float, *, along: bool = False) -> NDArray[np.float64]:
    """Drags a handle, until the server's answer is worn; where it was when the hand let go, metres."""
    one = handle(page, label)
    undo = int(bench(page, "draft.undo"))
    box = page.locator("omote-editor main .work canvas").first.bounding_box()
    assert box is not None
    x, y = box["x"] + one["head"][0], box["y"] + one["head"][1]
    page.mouse.move(x, y)
    if along:
        page.keyboard.down("Alt")
    page.mouse.down()
    page.mouse.move(x + dx, y + dy, steps=5)
    show_all(page)
    live = positions(page, "At rest")
    page.mouse.up()
    if along:
        page.keyboard.up("Alt")
    wait_for(page, f"bench.draft.undo === {undo + 1} && {SETTLED}")
    return live


def show_all(page: Page) -> None:
    """Waits for a picture of all that the hand has done; one may be under way that it was too late for."""
    before = page.evaluate("window.omoteEditor.counters().drawn")
    page.evaluate(f"() => {BENCH}.setOptions({{}})")  # asks for one more
    wait_for(page, f"canvas.counters().drawn > {before}")


def hold_contents(page: Page) -> Callable[[], None]:
    """Lets no content of the editor's come; calling what is returned lets all of it come."""
    held: list[Route] = []
    holds = True
    page.route("**/contents/*", lambda route: held.append(route) if holds else route.continue_())

    def let_go() -> None:
        nonlocal holds
        holds = False
        for route in held:
            route.continue_()

    return let_go


def row_of(page: Page, label: str) -> int:
    return int(handle(page, label)["row"])


def test_opening_a_face_says_what_is_loading(editor: Editor) -> None:
    page = editor()
    bar = page.get_by_role("progressbar", name="Loading the faces")
    expect(bar).to_have_count(0)
    let_go = hold_contents(page)
    label = "Long in coming"
    with page.expect_request("**/contents/*"):
        page.evaluate(f"""async () => {{
            await {BENCH}.ask({{ type: "create_face", label: {label!r}, base: {{ kaori: 1 }}, on_air: false }});
        }}""")
    expect(bar).to_be_visible()
    let_go()
    expect(bar).to_have_count(0)
    wait_for(page, SETTLED)
    expect(page.get_by_title("Which faces are shown")).to_have_count(0)  # those beside are the face itself


def test_a_dragged_handle_moves_the_face_at_once_and_stays_where_it_was_put(editor: Editor) -> None:
    page = editor()
    make_face(page, "Long nose")
    before = positions(page, "At rest")
    live = drag_handle(page, "nose tip", 0, 24)
    after = positions(page, "At rest")
    row = row_of(page, "nose tip")
    assert (before - live)[row, 1] > 0.002
    assert np.linalg.norm(after[row] - live[row]) < REACH
    off = np.linalg.norm(after - live, axis=1)
    assert off[SHEET].max() < 1e-6
    assert off.max() < 0.005, "the server fits the mouth's bag anew behind a lip that has come nearer"
    jaw = row_of(page, "left jaw corner")
    assert np.linalg.norm(after[jaw] - before[jaw]) < REACH


def test_alt_drags_along_the_view_and_all_expressions_come_along(editor: Editor) -> None:
    page = editor()
    make_face(page, "Flat nose")
    assert page.evaluate("window.omoteEditor.faces()") == ["At rest", "Smile", "Blink", "Jaw open"]
    smiling = positions(page, "Smile")
    open_wide = positions(page, "Jaw open")
    rest = positions(page, "At rest")
    drag_handle(page, "nose tip", 0, 30, along=True)
    row = row_of(page, "nose tip")
    move = (positions(page, "At rest") - rest)[row]
    assert abs(move[0]) < REACH
    assert abs(move[1]) < REACH
    assert move[2] > 0.002
    for label, before in (("Smile", smiling), ("Jaw open", open_wide)):
        assert np.linalg.norm((positions(page, label) - before)[row] - move) < 0.3 * np.linalg.norm(move)


def test_mirrored_drags_undo_and_a_second_drag_from_a_moved_face(editor: Editor) -> None:
    page = editor()
    make_face(page, "Wide mouth")
    page.locator("[data-option='mirror']").click()
    first = positions(page, "At rest")
    drag_handle(page, "left mouth corner", 14, -6)
    moved = positions(page, "At rest")
    left = row_of(page, "left mouth corner")
    right = row_of(page, "right mouth corner")
    assert np.allclose((moved - first)[left] * [-1, 1, 1], (moved - first)[right], atol=2 * REACH)
    live = drag_handle(page, "left upper lid", 0, -8)
    off = np.linalg.norm(positions(page, "At rest") - live, axis=1)
    assert off[SHEET].max() < 1e-6
    assert off.max() < 0.005, "the server fits the mouth's bag anew behind lips so wide"
    page.keyboard.press("Control+z")
    wait_for(page, f"bench.draft.undo === 1 && {SETTLED}")
    assert np.allclose(positions(page, "At rest"), moved, atol=1e-6)
    page.keyboard.press("Control+z")
    wait_for(page, f"bench.draft.undo === 0 && {SETTLED}")
    assert np.allclose(positions(page, "At rest"), first, atol=1e-6)


def test_a_mix_a_part_of_another_and_caricature_keep_the_handles_and_save(editor: Editor) -> None:
    page = editor()
    make_face(page, "Kaori's aunt")
    drag_handle(page, "chin", 0, 16)
    plain = positions(page, "At rest")
    undo = int(bench(page, "draft.undo"))
    page.get_by_label("Mix in a face").select_option(label="Old")
    part = page.get_by_label("Where the mouth come from")
    for label, source in (("Old", "old"), ("Dog", "dog")):
        part.select_option(label=label)
        expect(part).to_have_value(source)  # not the choice before
    amount = page.locator("omote-amount[label=Exaggerate] input[type=text]")
    amount.fill("130")
    amount.press("Enter")
    recipe = bench(page, "face")  # all that the hand has done, whatever the server has answered by now
    assert (recipe["base"], recipe["regions"], recipe["amount"]) == ({"kaori": 0.5, "old": 0.5}, {"mouth": "dog"}, 1.3)
    wait_for(page, f"bench.draft.undo === {undo + 4} && {SETTLED}")
    kept = bench(page, "draft.recipe")
    assert {**recipe, "kind": "face"} == {**kept, "kind": "face"}
    assert np.abs(positions(page, "At rest") - plain).max() > 0.002
    live = drag_handle(page, "left cheek", 10, 0)
    off = np.linalg.norm(positions(page, "At rest") - live, axis=1)
    assert off[SHEET].max() < 2e-4
    assert off.max() < 0.005, "the server fits what lies behind the skin anew"
    save(page)


def type_amount(page: Page, label: str, text: str) -> Locator:
    """Types a number into the field of an amount."""
    field = page.locator(f"omote-amount[label='{label}'] input[type=text]")
    field.fill(text)
    field.press("Enter")
    return field


def test_a_mix_that_takes_long_is_said_to_be_made_and_a_drag_is_not(editor: Editor) -> None:
    page = editor()
    make_face(page, "Long in the making")
    sign = page.locator("omote-making")
    let_go = hold_contents(page)
    one = handle(page, "chin")
    page.locator("omote-editor main .work canvas").first.click(position={"x": one["head"][0], "y": one["head"][1]})
    page.keyboard.press("ArrowDown")
    wait_for(page, "bench.draft.undo === 1 && !bench.waiting")
    expect(sign).to_have_count(0)  # a hand shows by itself where it moves the face
    page.get_by_label("Mix in a face").select_option(label="Old")
    expect(sign.get_by_text("Making the face")).to_be_visible()
    let_go()
    expect(sign).to_have_count(0)
    wait_for(page, SETTLED)
    type_amount(page, "Old", "0")
    wait_for(page, f"bench.draft.undo === 3 && {SETTLED}")
    expect(sign).to_have_count(0)
    page.get_by_role("button", name="Without Old").click()  # it looks the same
    wait_for(page, f"bench.draft.undo === 4 && {SETTLED}")
    expect(sign).to_have_count(0)


def test_numbers_stay_as_typed_within_limits_and_what_goes_out_is_told(editor: Editor) -> None:
    page = editor()
    make_face(page, "Typed")
    save(page)
    page.get_by_label("Mix in a face").select_option(label="Old")
    expect(type_amount(page, "Old", "30")).to_have_value("30")
    expect(page.locator("omote-amount[label=Kaori] input[type=text]")).to_have_value("70")
    expect(type_amount(page, "Old", "-5")).to_have_value("0")
    expect(type_amount(page, "Exaggerate", "-5")).to_have_value("100")
    name = page.locator("omote-heading").get_by_label("Name", exact=True)
    name.fill("")
    name.press("Enter")
    expect(name).to_have_value("Typed")
    page.get_by_role("tab", name="Import & export").click()
    expect(page.locator("omote-panels .behind")).to_contain_text("What goes out is your last save")
    save(page)
    expect(page.locator("omote-panels .behind")).to_have_count(0)


def test_arrows_move_what_is_chosen_and_the_panel_puts_it_back(editor: Editor) -> None:
    page = editor()
    make_face(page, "By keys")
    first = positions(page, "At rest")
    one = handle(page, "chin")
    page.locator("omote-editor main .work canvas").first.click(position={"x": one["head"][0], "y": one["head"][1]})
    for _ in range(4):
        page.keyboard.press("ArrowDown")
        wait_for(page, SETTLED)
    row = row_of(page, "chin")
    assert (positions(page, "At rest") - first)[row, 1] == pytest.approx(-0.002, abs=REACH)
    page.get_by_role("button", name="Reset chin").click()
    wait_for(page, f"bench.draft.undo === 5 && {SETTLED}")
    assert np.allclose(positions(page, "At rest"), first, atol=1e-6)


def test_a_look_is_chosen_by_pictures_kept_in_the_recipe_and_left_again(editor: Editor) -> None:
    page = editor()
    make_face(page, "Ann")
    page.locator("[data-tab=look]").click()
    panel = page.locator("omote-look")
    expect(panel.locator(".tile")).to_have_count(len(load_cast().hair) + 1)
    expect(panel.locator("[data-hair=bob]")).to_have_attribute("aria-pressed", "true")  # as kaori brings it
    expect(panel.locator("[data-hair=crop] canvas")).to_have_attribute("data-drawn", re.compile("with crop$"))
    panel.locator("[data-hair=crop]").click()
    wait_for(page, f"bench.face.look.hair_style === 'crop' && bench.face.look.scalp === 1 && {SETTLED}")
    panel.get_by_label("Colour of the hair: red", exact=True).click()
    panel.locator("[data-trait=freckles] input[type=text]").fill("80")
    panel.locator("[data-trait=freckles] input[type=text]").press("Enter")
    wait_for(page, f"bench.face.look.freckles === 0.8 && bench.face.look.hair === '#8f3b1e' && {SETTLED}")
    save(page)
    kept = "bench.library.manifest.faces.find((face) => face.label === 'Ann')?.look"
    wait_for(page, f"{kept}?.hair_style === 'crop' && {kept}.hair === '#8f3b1e'")
    panel.locator("[data-hair=none]").click()
    wait_for(page, f"bench.face.look.hair_style === '' && bench.face.look.scalp === 0 && {SETTLED}")
    panel.get_by_role("button", name="as its faces have it").first.click()
    wait_for(page, f"!('hair_style' in bench.face.look) && bench.face.look.freckles === 0.8 && {SETTLED}")
    expect(panel.locator("[data-hair=bob]")).to_have_attribute("aria-pressed", "true")


def set_gain(page: Page, region: str, value: float) -> None:
    """Types a gain into its field and waits until the server has baked it."""
    undo = int(bench(page, "draft.undo"))
    field = page.locator(f"omote-recipe omote-amount[data-gain='{region}'] input[type=text]")
    field.fill(str(value))
    field.press("Enter")
    field.blur()
    wait_for(page, f"bench.draft.undo === {undo + 1} && {SETTLED}")


def test_a_gain_makes_an_expression_stronger_there_is_undone_saved_and_read_on_the_console(
    editor: Editor, console: Console
) -> None:
    page = editor()
    make_face(page, "Loud Kaori")
    rest = positions(page, "At rest")
    smiling = positions(page, "Smile")
    set_gain(page, "mouth", 2)
    louder = positions(page, "Smile")
    row = row_of(page, "left mouth corner")
    plain, loud = (np.linalg.norm((worn - rest)[row]) for worn in (smiling, louder))
    assert loud > 1.3 * plain
    assert np.allclose(positions(page, "At rest"), rest, atol=1e-7)
    page.keyboard.press("Control+z")
    wait_for(page, f"bench.draft.undo === 0 && {SETTLED}")
    assert np.allclose(positions(page, "Smile"), smiling, atol=1e-6)
    page.keyboard.press("Control+Shift+z")
    wait_for(page, f"bench.draft.undo === 1 && {SETTLED}")
    set_gain(page, "ears", 1.5)
    page.get_by_label("A gain for one expression", exact=True).select_option("angry")
    wait_for(page, f"bench.face.gains.length === 3 && {SETTLED}")
    set_gain(page, "mouth:angry", 0.5)
    save(page)
    desk = console()
    name = bench(page, "item.name")
    desk.locator(f"omote-palette .tile[data-name='{name}']").click()
    line = desk.locator("omote-answers button")
    said = "Loud Kaori answers: mouth \N{MULTIPLICATION SIGN}2.0, mouth in angry \N{MULTIPLICATION SIGN}0.5, ears"
    expect(line).to_have_attribute("aria-label", re.compile(re.escape(said)))
    line.click()
    answers = desk.get_by_role("dialog", name="How Loud Kaori answers")
    expect(answers).to_contain_text("mouth in angry")
    desk.keyboard.press("Escape")
    expect(answers).to_have_count(0)
    desk.locator("omote-palette .tile[data-name='kaori']").click()
    expect(line).to_have_count(0)


def test_a_face_goes_out_as_an_avatar_by_keys_once_its_author_is_named(editor: Editor) -> None:
    page = editor()
    make_face(page, "Aunt Ann")
    save(page)
    page.get_by_role("tab", name="Import & export").click()
    button = page.get_by_role("button", name="Download aunt_ann.vrm")
    author = page.get_by_label("Author of the avatar")
    button.press("Enter")
    expect(notice(page).filter(has_text="An avatar names who made it: fill in its author.")).to_be_visible()
    author.focus()
    page.keyboard.type("Ann Lee")
    page.keyboard.press("Tab")
    expect(page.get_by_label("Who may use the avatar")).to_be_focused()
    button.focus()
    with page.expect_download() as coming:
        page.keyboard.press("Enter")
    document, _ = taken_apart(Path(coming.value.path()).read_bytes())
    meta = document["extensions"]["VRMC_vrm"]["meta"]
    assert coming.value.suggested_filename == "aunt_ann.vrm"
    assert (meta["name"], meta["authors"], meta["avatarPermission"]) == ("Aunt Ann", ["Ann Lee"], "onlyAuthor")
