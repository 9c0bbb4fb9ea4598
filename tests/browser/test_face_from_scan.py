"""A scan dropped on the editor: waited for, looked at, corrected by a click, taken, and played on the console."""

from __future__ import annotations

import base64
import re
from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray
from playwright.sync_api import FilePayload, Page, expect

from omote import load_cast
from tests.browser.pictures import picture
from tests.browser.test_console import console
from tests.browser.test_editor import editor, make

__all__ = ["console", "editor"]

Editor = Callable[..., Page]
pytestmark = pytest.mark.long

DROP = """([name, text]) => {
    const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([bytes], name));
    return !document.body.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
}"""


def strange_scan(seed: int) -> bytes:
    """The skin of a face of the cast as a scanner has it (PLY): other triangles, shuffled, on its back, in inches."""
    rng = np.random.default_rng(seed)
    cast = load_cast()
    triangles = cast.space.triangles[cast.space.on_sheet[cast.space.triangles].all(axis=1)]
    points = cast.faces["heavy"].positions.astype(np.float64)
    share = rng.dirichlet([6.0, 6.0, 6.0], len(triangles))  # each triangle is parted into three at a place in it
    inside = np.einsum("tk,tkc->tc", share, points[triangles])
    middle = len(points) + np.arange(len(triangles))
    parted = np.concatenate([np.c_[triangles[:, [at, (at + 1) % 3]], middle] for at in range(3)])
    order = rng.permutation(len(points) + len(inside))
    place = np.argsort(order)
    turned = np.concatenate([points, inside])[order] @ np.array([[1.0, 0, 0], [0, 0, 1.0], [0, -1.0, 0]]) / 0.0254
    head = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(turned)}\n"
    head += "".join(f"property float {axis}\n" for axis in "xyz")
    head += f"element face {len(parted)}\nproperty list uchar int vertex_indices\nend_header\n"
    rows = np.zeros(len(parted), np.dtype([("count", "u1"), ("corners", "<i4", 3)]))
    rows["count"], rows["corners"] = 3, place[parted]
    return b"".join([head.encode(), turned.astype("<f4").tobytes(), rows.tobytes()])


def drop(page: Page, name: str, data: bytes) -> None:
    assert page.evaluate(DROP, [name, base64.b64encode(data).decode()]), "the page took it, not the browser"


def views(page: Page) -> NDArray[np.int16]:
    """What the canvas shows, the marks of points over it."""
    box = page.locator("omote-scan-views").bounding_box()
    assert box is not None
    left = round(box["x"])
    top = round(box["y"])
    return picture(page)[top : top + round(box["height"]), left : left + round(box["width"]), :3]


def lit(pixels: NDArray[np.int16]) -> NDArray[np.bool_]:
    """Where a head is drawn."""
    found: NDArray[np.bool_] = pixels.max(axis=2) > 40
    return found


def test_a_dropped_scan_is_looked_at_corrected_taken_and_plays(editor: Editor, console: Editor) -> None:
    page = editor()
    drop(page, "uncle.ply", strange_scan(5))
    dialog = page.get_by_role("dialog", name="A face from a scan")
    expect(dialog.get_by_role("progressbar")).to_be_visible()
    verdict = page.locator("omote-scan .verdict")
    expect(verdict).to_contain_text("Taken for: inches, z up, facing -y.")
    found = re.search(r"within ([\d.]+) mm of the scan, 95 % within ([\d.]+) mm", verdict.inner_text())
    assert found is not None
    assert float(found[1]) < 0.2

    scan, face = _sides(page)
    same = (lit(scan) & lit(face)).sum() / (lit(scan) | lit(face)).sum()
    assert same > 0.85, "face and scan lie over each other from all three sides"
    page.get_by_role("button", name="Distance").click()
    heat = views(page)
    blue = heat[..., 2] > heat[..., 0] + 15
    assert blue[lit(heat)].mean() > 0.6, "most of it is near"
    expect(dialog).to_contain_text("2 mm and more")

    row = page.get_by_role("button", name="1 Left eye, outer corner")
    page.get_by_role("button", name="Scan", exact=True).click()
    mark = page.locator("omote-scan-views g[data-point=left_eye_outer] circle").first.bounding_box()
    assert mark is not None
    page.mouse.click(mark["x"] + mark["width"] / 2, mark["y"] + mark["height"] / 2)
    expect(row).to_contain_text("✓")
    expect(dialog.get_by_role("button", name="Fit again")).to_be_enabled()
    page.locator("omote-scan-views canvas").focus()
    page.keyboard.press("ArrowRight")
    for _ in range(2):
        dialog.get_by_role("button", name="Undo").click()
    expect(row).not_to_contain_text("✓")
    expect(dialog.get_by_role("button", name="Fit again")).to_have_count(0)

    page.keyboard.press("Escape")
    expect(dialog).to_contain_text("Throw the scan and its points away?")
    dialog.get_by_role("button", name="Keep looking").click()
    page.get_by_label("Name", exact=True).fill("My uncle")
    page.get_by_label("Hair", exact=True).select_option("bun")
    dialog.get_by_role("button", name=re.compile("Take it")).click()
    expect(dialog).to_have_count(0)
    page.get_by_role("button", name="Open it here").click()
    expect(page.locator("omote-heading input").first).to_have_value("My uncle")
    page.get_by_role("tab", name="History").click()
    expect(page.locator("omote-panels")).to_contain_text("from uncle.ply (inches, z up, facing -y), no point given")
    expect(console().locator("omote-palette .tile[data-name='my_uncle']")).to_be_visible()


def _sides(page: Page) -> tuple[NDArray[np.int16], NDArray[np.int16]]:
    """What the canvas shows of the scan alone, and of the face alone."""
    page.get_by_role("button", name="Scan", exact=True).click()
    scan = views(page)
    page.get_by_role("button", name="Face", exact=True).click()
    return scan, views(page)


def as_obj(ply: bytes) -> bytes:
    """The points and triangles of `strange_scan` as OBJ: a file that may be a head of Omote's own too."""
    head, body = ply.split(b"end_header\n", 1)
    count, size = (int(found) for found in re.findall(rb"element \w+ (\d+)", head))
    points = np.frombuffer(body[: 12 * count], "<f4").reshape(-1, 3)
    rows = np.frombuffer(body[12 * count :], np.dtype([("count", "u1"), ("corners", "<i4", 3)]), size)
    lines = [f"v {x:.5f} {y:.5f} {z:.5f}" for x, y, z in points]
    lines += [f"f {a} {b} {c}" for a, b, c in (rows["corners"] + 1).tolist()]
    return "\n".join(lines).encode()


def test_a_strangers_head_is_a_scan_where_nothing_is_open_and_a_name_of_the_cast_is_told(editor: Editor) -> None:
    page = editor()
    drop(page, "uncle.obj", as_obj(strange_scan(8)))
    dialog = page.get_by_role("dialog", name="A face from a scan")
    expect(page.locator("omote-scan .verdict")).to_contain_text("Taken for: inches")
    page.get_by_label("Name", exact=True).fill("Dog")
    expect(dialog).to_contain_text('There is a face "Dog" already: this one will be "Dog 2".')
    dialog.get_by_role("button", name=re.compile("Take it")).click()
    expect(dialog).to_have_count(0)
    expect(page.locator("omote-notices")).to_contain_text('"Dog 2" plays, with all expressions')


def test_a_strangers_head_on_an_open_expression_is_refused_and_offered_as_a_face(editor: Editor) -> None:
    page = editor()
    make(page, "A smirk")
    drop(page, "uncle.obj", as_obj(strange_scan(9)))
    page.get_by_role("button", name="Make a face of it").click()
    expect(page.get_by_role("dialog", name="A face from a scan")).to_contain_text("uncle.obj")


def test_what_is_no_scan_is_said_in_a_sentence_and_a_fit_is_cancelled(editor: Editor) -> None:
    page = editor()
    dialog = page.get_by_role("dialog", name="A face from a scan")
    drop(page, "words.ply", b"words")
    expect(dialog.get_by_role("alert")).to_contain_text("words.ply: ")
    drop(page, "other.ply", b"words")
    expect(dialog.get_by_role("alert")).to_contain_text("take it or throw it away first")
    page.keyboard.press("Escape")
    expect(dialog).to_have_count(0)
    notices = page.locator("omote-notices")
    expect(notices).not_to_contain_text("take it or throw it away first")  # it is not left standing on the page
    page.get_by_role("tab", name="Faces").click()
    page.get_by_label("A face from a scan").first.set_input_files(
        FilePayload(name="uncle.ply", mimeType="application/octet-stream", buffer=strange_scan(6))
    )
    expect(dialog).to_contain_text("The head is sought")
    dialog.get_by_role("button", name="Cancel").click()
    expect(dialog).to_have_count(0)
    expect(page.locator("omote-item-list")).not_to_contain_text("Uncle")
