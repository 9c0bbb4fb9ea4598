"""What is cut off on a page: one walk through all of its shadow roots."""

from __future__ import annotations

from playwright.sync_api import Page

WALK = """([host, names]) => {
    const found = [];
    const above = (one) => one.assignedSlot ?? one.parentElement ?? one.getRootNode().host ?? null;
    const scrolls = (one, way) => {
        const size = way === "X" ? "Width" : "Height";
        for (let up = above(one); up !== null; up = above(up))
            if (/auto|scroll/.test(getComputedStyle(up)[`overflow${way}`]) &&
                up[`scroll${size}`] > up[`client${size}`]) return true;
        return document.documentElement[`scroll${size}`] > document.documentElement[`client${size}`];
    };
    const walk = (root) => {
        for (const one of root.querySelectorAll("*")) {
            if (one.shadowRoot) walk(one.shadowRoot);
            const box = one.getBoundingClientRect();
            if (!one.matches(names) || box.width === 0) continue;
            const called = `${one.className || one.localName} ${one.textContent.trim()}`;
            const outside = ((box.left < 0 || box.right > innerWidth + 1) && !scrolls(one, "X")) ||
                ((box.top < 0 || box.bottom > innerHeight + 1) && !scrolls(one, "Y"));
            if (outside || (one.matches("button") && one.scrollWidth > one.clientWidth + 1)) found.push(called);
            if (matchMedia("(pointer: coarse)").matches && one.matches("button, select") && box.height < 43.9)
                found.push(`${called} ${box.height}`);
        }
    };
    walk(document.querySelector(host).shadowRoot);
    if (document.documentElement.scrollWidth > innerWidth) found.push("the page");
    return found;
}"""


def cut_off(page: Page, host: str, names: str) -> list[str]:
    """What lies outside the window where nothing scrolls to it, buttons whose words do not fit, and, where fingers
    point, those lower than a finger; "the page" where it is wider than the window.

    host: the name of the page's element; names: a selector of what is looked at.
    """
    found: list[str] = page.evaluate(WALK, [host, names])
    return found
