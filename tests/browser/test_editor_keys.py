"""Whom a key press is for in the editor: dialogs, menus and forms keep theirs, and Escape closes them alone."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from playwright.sync_api import Locator, Page, expect

from tests.browser.test_editor import BENCH, SETTLED, bench, drag, editor, make, mouth_corner, save, wait_for

__all__ = ["editor"]

Editor = Callable[..., Page]

SHORTCUTS = ["Control+z", "Control+Shift+z", "p", "x", "w", "2", "n", "ArrowUp"]


def still(page: Page) -> dict[str, Any]:
    """All that keys could change."""
    found = page.evaluate(f"[{BENCH}.options, {BENCH}.draft.undo, {BENCH}.draft.redo, [...{BENCH}.selection]]")
    return {"found": found}


def in_history(page: Page) -> None:
    page.locator("[data-tab=history]").click()
    page.locator("[data-revision='1']").get_by_role("button", name="Compare").click()


LAYERS: dict[str, tuple[Callable[[Page], None], Callable[[Page], Locator]]] = {
    "help": (
        lambda page: page.locator("omote-heading").get_by_role("button", name="Keys").click(),
        lambda page: page.get_by_role("dialog", name="Keys"),
    ),
    "comparison": (in_history, lambda page: page.get_by_role("dialog", name="Comparison")),
    "faces": (
        lambda page: page.locator("omote-faces-choice button").click(),
        lambda page: page.get_by_role("group", name="Faces shown"),
    ),
    "form": (
        lambda page: page.locator("[data-new]").click(),
        lambda page: page.get_by_role("form", name="New expression"),
    ),
}


def test_escape_closes_what_is_open_alone_and_no_shortcut_works_through_it(editor: Editor) -> None:
    page = editor()
    make(page, "Keys of layers")
    drag(page, mouth_corner(page))
    save(page)
    drag(page, mouth_corner(page), dx=4, dy=4)
    for name, (opened, layer) in LAYERS.items():
        before = still(page)
        assert before["found"][1] >= 1, "there is something to undo"
        opened(page)
        expect(layer(page)).to_be_visible()
        if name == "form":
            layer(page).get_by_role("button", name="Create").focus()  # not in its field
        for key in SHORTCUTS:
            page.keyboard.press(key)
        if name != "form":  # a form leaves the page beside it usable
            page.evaluate("document.activeElement.blur()")
            for key in SHORTCUTS:
                page.keyboard.press(key)
        else:
            layer(page).get_by_label("Name").focus()
        page.keyboard.press("Escape")
        expect(layer(page)).to_have_count(0)
        wait_for(page, SETTLED)
        assert still(page) == before, name


def test_tab_goes_round_in_a_dialog(editor: Editor) -> None:
    page = editor()
    page.locator("omote-heading").get_by_role("button", name="Keys").click()
    close = page.get_by_role("dialog", name="Keys").get_by_role("button", name="Close")
    expect(close).to_be_focused()
    for key in ("Tab", "Shift+Tab"):
        page.keyboard.press(key)
        expect(close).to_be_focused()


def test_escape_leaves_a_name_as_it_was(editor: Editor) -> None:
    page = editor()
    make(page, "Named once")
    page.get_by_label("Rename: Named once").click()
    entry = page.get_by_label("New name of Named once")
    entry.fill("Named twice")
    page.keyboard.press("Escape")
    expect(entry).to_have_count(0)
    label = page.get_by_label("Name", exact=True)
    label.click()
    page.keyboard.type(" more")
    page.keyboard.press("Escape")
    expect(label).to_have_value("Named once")
    expect(label).not_to_be_focused()
    assert bench(page, "item.label") == "Named once"


def test_a_needle_is_chosen_and_moved_by_keys_alone(editor: Editor) -> None:
    page = editor()
    make(page, "By keys")
    page.locator("canvas[tabindex='0']").focus()
    chosen = []
    for key in (".", ".", ","):
        page.keyboard.press(key)
        chosen += page.evaluate(f"[...{BENCH}.selection]")
    assert len(chosen) == 3
    assert chosen[0] == chosen[2] != chosen[1], "one on, one back"
    for _ in range(20):
        page.keyboard.press(".")  # down into the face: beside the crown's needles there is no skin to go to
    page.keyboard.press("ArrowRight")
    wait_for(page, f"bench.draft.undo === 1 && {SETTLED}")
