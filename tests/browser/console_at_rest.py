"""A console whose show is brought to rest: tests of one worker share a show, each begins from the same face."""

from __future__ import annotations

from playwright.sync_api import Page

from tests.browser.waiting import wait_until

DESK = "document.querySelector('omote-console').context.store"
AT_REST = """
    state.faces.generic === 1 && state.expressions.neutral === 1 && Object.keys(state.channels).length === 0
    && [...state.head, ...state.gaze, state.face_fader, state.expression_fader].every((value) => value === 0)
    && state.face_call === null && state.expression_call === null
"""
TO_REST = f"""() => {{
    const desk = {DESK};
    if (window.losses === undefined) {{
        window.losses = 0;
        desk.listen("link", () => {{ window.losses += desk.online ? 0 : 1; }});
    }}
    desk.arrange({{ kind: "performed", tab: "brows", linked: true }});
    for (const axis of ["face", "expression"]) {{
        desk.bar(axis).nudge(0);
        desk.setTiming(axis, {{ seconds: 0 }});
    }}
    desk.flush();
    const before = desk.air.panics;
    desk.panic();
    desk.call("face", "generic");
    return [before, window.losses];
}}"""
"""Brings what is on air to rest; how often there was panic before, and how often this page had lost its link."""


def bring_to_rest(page: Page) -> None:
    """Brings what is on air to rest; again where the link broke meanwhile, for what a page has sent is lost then."""
    arrived = False
    while not arrived:
        before, losses = page.evaluate(TO_REST)
        heard = f"({AT_REST}) && state.panics > {before}"  # a panic that comes later lets go of what is held
        wait_for(page, f"desk.online && (({heard}) || window.losses > {losses})")
        arrived = page.evaluate("losses => window.losses === losses", losses)


def wait_for(page: Page, condition: str) -> None:
    """Waits until a condition on `desk` and `state` holds: what is on air, the character's own that is played too."""
    desk = "const desk = document.querySelector('omote-console')?.context.store"
    given = f"{desk}; const state = desk?.state ? {{...desk.state, ...desk.air}} : null"
    wait_until(page, f"desk && ({condition})", given, told="state")
