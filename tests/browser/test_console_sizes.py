"""The console on the sizes that it is made for and on those that come: everything at hand, nothing cut off."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import pytest
from playwright.sync_api import Locator, Page, expect

import omote
from tests.browser.console_at_rest import DESK, wait_for
from tests.browser.test_console import TWO_FRAMES, bar, console, fader, region, state, tile

__all__ = ["console"]

Console = Callable[..., Page]

SIZES = [(1440, 900), (1024, 768), (768, 1024), (390, 844)]
OTHERS = [
    *[(1366, 640), (1280, 640), (1280, 600), (1024, 640), (1024, 600), (960, 600), (960, 541), (900, 540)],
    *[(1440, 500), (844, 390), (800, 600), (768, 700), (720, 450), (600, 400), (667, 375)],
    *[(430, 932), (375, 667), (360, 640), (320, 568), (320, 480)],
]
"""Windows of laptops with a zoom, phones on their side, small phones."""
FINGER = 40

CONTROLS = """() => {
    const found = [];
    const clipped = (one, box) => {
        for (let up = one; up; up = up.assignedSlot ?? up.parentElement ?? up.getRootNode().host) {
            if (up !== one && getComputedStyle(up).overflow !== "visible") {
                const edge = up.getBoundingClientRect();
                if (box.left < edge.left - 1 || box.right > edge.right + 1) return true;
                if (box.top < edge.top - 1 || box.bottom > edge.bottom + 1) return true;
            }
        }
        return false;
    };
    const walk = (root) => {
        for (const one of root.querySelectorAll("*")) {
            if (one.shadowRoot) walk(one.shadowRoot);
            const box = one.getBoundingClientRect();
            const active = one.matches("button, select, input, a[href], [role=slider]");
            if (!active || box.width === 0 || box.height === 0 || clipped(one, box)) continue;
            if (one.getRootNode().host?.localName === "omote-head-frames") continue; // a head lies behind the keys
            if (getComputedStyle(one).pointerEvents === "none") continue; // for a mouse and the keyboard alone
            const text = one.matches("button") && one.scrollWidth > one.clientWidth + 1;
            found.push({
                name: one.getAttribute("aria-label") || one.textContent.trim().replace(/\\s+/g, " ") || one.className,
                left: box.left, top: box.top, right: box.right, bottom: box.bottom, cut: text,
            });
        }
    };
    walk(document.querySelector("omote-console").shadowRoot);
    return found;
}"""


def controls(page: Page) -> list[dict[str, Any]]:
    """The controls that are seen in full, with their boxes."""
    return list(page.evaluate(CONTROLS))


def overlap(one: dict[str, Any], other: dict[str, Any]) -> bool:
    """Whether two boxes share more than a border."""
    across = min(one["right"], other["right"]) - max(one["left"], other["left"])
    down = min(one["bottom"], other["bottom"]) - max(one["top"], other["top"])
    return bool(across > 1.5 and down > 1.5)


def faults(page: Page) -> list[tuple[str, ...]]:
    """What a finger cannot hit, what is cut off, and what lies under something else."""
    seen = controls(page)
    return [
        *(("cut", one["name"]) for one in seen if one["cut"]),
        *(
            ("small", one["name"], f"{one['right'] - one['left']:.0f} x {one['bottom'] - one['top']:.0f}")
            for one in seen
            if min(one["right"] - one["left"], one["bottom"] - one["top"]) < FINGER - 0.5
        ),
        *(
            ("over", one["name"], other["name"])
            for at, one in enumerate(seen)
            for other in seen[at + 1 :]
            if overlap(one, other)
        ),
    ]


def check_surface(page: Page, width: int, height: int) -> None:
    """Checks that a finger can hit everything and that nothing is cut off, hidden or under something else."""
    assert page.evaluate("document.scrollingElement.scrollWidth") <= width
    assert page.evaluate("document.scrollingElement.scrollHeight") <= height
    expect(page.locator(".panic")).to_be_in_viewport(ratio=1)
    assert faults(page) == []


def slide(page: Page, control: Locator, start: float, end: float) -> None:
    """Draws a finger up a control, from one height to another in parts of its box, 0 its lower edge."""
    box = control.bounding_box()
    assert box is not None
    x = box["x"] + box["width"] / 2
    low = box["y"] + box["height"]
    session = page.context.new_cdp_session(page)

    def touch(kind: str, at: float) -> None:
        points = [] if kind == "touchEnd" else [{"x": x, "y": low - at * box["height"], "id": 0}]
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    touch("touchStart", start)
    for step in range(1, 6):
        touch("touchMove", start + (end - start) * step / 5)
    touch("touchEnd", end)
    session.detach()


def view(page: Page, name: str) -> None:
    """Brings something up where not everything has room."""
    button = page.locator(f".views [data-view='{name}']")
    if button.is_visible():
        button.tap()
        expect(button).to_have_attribute("aria-selected", "true")


@pytest.mark.parametrize(("width", "height"), [(1024, 768), (390, 844)])
def test_the_console_is_played_by_fingers(console: Console, width: int, height: int) -> None:
    page = console(pictures=True, width=width, height=height, has_touch=True)
    check_surface(page, width, height)
    for name in ("generic", "child", "neutral", "angry"):
        expect(tile(page, name)).to_be_in_viewport()
    tile(page, "kaori").tap()
    tile(page, "smile").tap()
    wait_for(page, "state.faces.kaori === 1 && state.expressions.smile === 1")
    view(page, "faders")
    region(page, "jaw")
    check_surface(page, width, height)
    slide(page, fader(page, "jawOpen"), 0.25, 0.5)
    wait_for(page, "Math.abs(state.channels.jawOpen - 0.5) < 0.1")
    view(page, "pads")
    check_surface(page, width, height)
    slide(page, page.get_by_role("slider", name="Gaze: as you see"), 0.5, 0.9)
    wait_for(page, "state.gaze[1] === 0")
    page.evaluate(f"{DESK}.arrange({{ view: 'layers' }})")
    expect(page.locator("omote-layer-panel .strip[data-layer=emotion] .feed")).to_have_text("calls")
    check_surface(page, width, height)
    for head in page.locator("omote-group-heads [role=tab]").filter(visible=True).all():
        expect(head).to_be_in_viewport(ratio=1)
        head.tap()
        check_surface(page, width, height)
    page.evaluate(f"{DESK}.arrange({{ view: 'palettes' }})")
    page.locator(".faces .lists [data-seconds='hand']").tap()
    tile(page, "child").tap()
    wait_for(page, "state.face_call?.by_hand")
    slide(page, bar(page, "Face"), 0.0, 0.5)
    wait_for(page, "Math.abs(state.faces.child - 0.5) < 0.05")
    expect(page.locator(".facebar .percent")).to_be_in_viewport(ratio=1)
    page.locator(".panic").tap()
    wait_for(page, "state.expressions.neutral === 1 && !('jawOpen' in state.channels) && state.home_next")
    assert set(state(page)["faces"]) == {"kaori", "child"}
    check_surface(page, width, height)
    page.locator(".panic").tap()
    home = state(page)["home_face"]
    wait_for(page, f"state.face_call?.target === '{home}' || state.faces['{home}'] === 1")


STRONG = """(face) => {
    const store = document.querySelector("omote-console").context.store;
    const gains = [["brows", 1.6, null], ["mouth", 2, "angry"], ["ears", 1.5, null]].map(
        ([region, value, expression]) => ({ region, value, expression }));
    const faces = store.manifest.faces.map((one) => (one.name === face ? { ...one, gains } : one));
    store.setManifest({ ...store.manifest, faces });
}"""


def test_the_gains_of_a_face_have_their_place_and_all_are_listed(console: Console) -> None:
    page = console(has_touch=True)
    page.evaluate(STRONG, "kaori")
    gains = page.locator("omote-answers button")
    answers = page.get_by_role("dialog", name="How Kaori answers")
    listed = re.compile("^Kaori answers: brows .1.6, mouth in angry .2.0, ears .1.5$")
    expect(gains).to_have_count(0)
    for width, height in SIZES:
        resize(page, width, height)
        tile(page, "kaori").tap()
        expect(gains).to_have_attribute("title", listed)
        check_surface(page, width, height)
        gains.tap()
        expect(answers).to_be_in_viewport(ratio=1)
        tile(page, "man").tap()  # who has no gains, of springs neither
        expect(answers).to_have_count(0)
        expect(gains).to_have_count(0)


HANDS = """() => {
    const root = document.querySelector("omote-console").shadowRoot;
    const inside = (one, part = 1) => {
        if (!one) return false;
        const box = one.getBoundingClientRect();
        const seen = Math.min(innerHeight, box.bottom) - Math.max(0, box.top);
        return box.width > 0 && box.height > 0 && box.left >= 0 && box.right <= innerWidth && seen >= part * box.height;
    };
    const wrong = [];
    for (const bar of root.querySelectorAll("omote-tbar")) {
        const track = bar.shadowRoot.querySelector(".track");
        const height = track.getBoundingClientRect().height;
        if (!inside(track) || height < 45 || height > 620) wrong.push(`${bar.axis} T-bar, ${Math.round(height)} px`);
    }
    for (const palette of root.querySelectorAll("omote-palette")) {
        const times = palette.shadowRoot.querySelector("omote-timing").shadowRoot;
        const hands = [...times.querySelectorAll("[data-seconds=hand]")].filter((one) => one.offsetParent);
        if (hands.length !== 1 || !inside(hands[0])) wrong.push(`times of ${palette.axis}`);
        const tile = palette.shadowRoot.querySelector(".tile");
        const room = palette.shadowRoot.querySelector(".tiles").getBoundingClientRect().height;
        if (!inside(tile) || room < tile.getBoundingClientRect().height) wrong.push(`tiles of ${palette.axis}`);
    }
    return wrong;
}"""
"""What a show is played with that is not whole: T-bars with their ways, times, the first tile of each palette."""


NINE_SCREENS = f"""() => {{
    const [store, screen] = [{DESK}, {{ fps: 4.2, level: "lowest" }}];
    const receive = store.receive.bind(store);
    const nine = {{ lost: 12, stages: Array(9).fill(screen) }};
    store.receive = (message) => receive(message.type === "crew" ? {{ ...message, ...nine }} : message);
    if (store.crew !== null) store.receive(store.crew);
}}"""
"""Has a console hear of nine slow screens, and of twelve whose links broke."""


def resize(page: Page, width: int, height: int) -> None:
    """Gives the window a size, and the page two pictures' time to take it."""
    page.set_viewport_size({"width": width, "height": height})
    page.evaluate(TWO_FRAMES)


def found_wrong(page: Page, width: int, height: int) -> list[object]:
    """What is wrong with a window of a size, in each of its views."""
    wrong: list[object] = []
    fingers = page.evaluate("matchMedia('(pointer: coarse)').matches")
    resize(page, width, height)
    for name in ("faders", "pads", "scene", "layers", "palettes"):
        page.evaluate(f"{DESK}.arrange({{ view: {name!r} }})")
        page.evaluate(TWO_FRAMES)
        page_size = page.evaluate("[document.scrollingElement.scrollWidth, document.scrollingElement.scrollHeight]")
        if page_size[0] > width or page_size[1] > height:
            wrong.append((name, "the page grows", page_size))
        wrong += [(name, *fault) for fault in faults(page) if fingers or fault[0] == "cut"]
        for panic in page.locator(".panic").all():
            expect(panic).to_be_in_viewport(ratio=1)
    return wrong + list(page.evaluate(HANDS))


@pytest.mark.parametrize("touch", [True, False])
def test_no_window_grows_and_hands_are_always_in_view(console: Console, show: str, touch: bool) -> None:
    page = console(**({"has_touch": True} if touch else {}))
    page.evaluate(NINE_SCREENS)
    with omote.connect(show, name="crowd") as program:  # the bar is fullest with a seat and with others' characters
        program.add("crowd")
        program.set_leases(True)
        try:
            expect(page.locator("omote-seat button")).to_be_visible()
            wrong = {size: found_wrong(page, *size) for size in (*OTHERS[:: 1 if touch else 4], SIZES[3])}
        finally:
            program.set_leases(False)
            program.remove("crowd")
    assert {size: what for size, what in wrong.items() if what} == {}


def test_by_mouse_nothing_is_cut_off_and_nothing_scrolls(console: Console) -> None:
    page = console(pictures=True)
    for width, height in [(1024, 768), (1440, 900), (1920, 1080)]:
        resize(page, width, height)
        assert page.evaluate("document.scrollingElement.scrollHeight") <= height
        assert page.evaluate("document.scrollingElement.scrollWidth") <= width
        assert [one["name"] for one in controls(page) if one["cut"]] == []
        for control in (page.locator(".panic"), bar(page, "Face"), bar(page, "Expression"), page.locator("omote-bank")):
            expect(control).to_be_in_viewport(ratio=1)


NOTICE = f"""() => {DESK}.receive({{ type: "notices",
    notices: [{{ id: "disk", time: Date.now() / 1000, text: "No space left. ".repeat(20), solved: false }}] }})"""
BOXES = """(names) => Object.fromEntries(names.map((name) => {
    const box = document.querySelector("omote-console").shadowRoot.querySelector(name).getBoundingClientRect();
    return [name, { left: box.left, top: box.top, right: box.right, bottom: box.bottom }];
}))"""
PLAYED = ["omote-characters", "omote-tbar", "omote-palette", "omote-lights", "omote-bank"]
"""Parts that are played on, which stay where they are when something is said."""


@pytest.mark.parametrize("touch", [True, False])
def test_the_keys_of_eight_characters_lie_beside_the_picture_and_no_notice_moves_them(
    console: Console, show: str, touch: bool
) -> None:
    page = console(**({"has_touch": True} if touch else {}))
    others = [f"person-{number}" for number in range(2, 9)]
    sizes = [(1280, 800), (1100, 700), (1440, 900), (1024, 768), (768, 1024), (390, 844), (667, 375), (320, 568)]
    with omote.connect(show, name="crowd") as program:
        for name in others:
            program.add(name)
        try:
            expect(page.locator("omote-characters [data-character]")).to_have_count(8)
            for width, height in sizes:
                page.evaluate(f"{DESK}.receive({{ type: 'notices', notices: [] }})")
                resize(page, width, height)
                before = page.evaluate(BOXES, PLAYED)
                page.evaluate(NOTICE)
                page.evaluate(TWO_FRAMES)
                boxes = page.evaluate(BOXES, [*PLAYED, "omote-monitor", "omote-show-notices"])
                assert {name: boxes[name] for name in PLAYED} == before, (width, height)
                row, picture, notice = (boxes[name] for name in ("omote-characters", *list(boxes)[-2:]))
                assert not overlap(row, picture), (width, height)
                assert not overlap(row, notice), (width, height)
                assert not overlap(picture, notice), (width, height)
                assert picture["bottom"] - picture["top"] >= FINGER, (width, height)
                assert [fault for fault in faults(page) if touch or fault[0] == "cut"] == [], (width, height)
                if not touch and width >= 900:
                    for key in page.locator("omote-characters button").all():
                        expect(key).to_be_in_viewport(ratio=1)
        finally:
            for name in others:
                program.remove(name)
            page.evaluate(f"{DESK}.receive({{ type: 'notices', notices: [] }})")
