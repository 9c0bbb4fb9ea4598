"""What a scene of four characters costs on a machine without a graphics processor (issue 11, item 1).

Chromium on llvmpipe at 640x360 and `lowest`. All characters change face and expression twice a second, each in half a
second; the pages draw one frame after the other, as fast as they can, each waited for. In turns in the same run:

* one character, and four of them side by side, on the stage page;
* one head with three.js's own morph targets: its skin, eyes, teeth and tongue without hair, lashes, collar, textures
  and correctives, with as many targets as those calls need (four faces, each with four expressions), positions and
  normals, under three.js's standard material and two lamps.

Milliseconds of the processors for a frame, the least of the rounds. The stage is a page of a server of its own,
without a show. `--runs N` for another number of rounds, `--frames N` for their length.
"""

from __future__ import annotations

import argparse
import asyncio
import sys
from collections.abc import Awaitable, Callable
from pathlib import Path

import msgspec
import numpy as np
from playwright.async_api import Browser, Page, Route, async_playwright
from rich.console import Console
from rich.table import Table

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

import omote
from benchmarks.render import ProcessorTime
from benchmarks.stage import CHROMIUM, HEIGHT, WIDTH
from omote.builtin import load_cast, load_meshes
from omote.server.headless.picture_renderer import serve_pages
from omote.server.http.cast_documents import built_in_documents
from omote.server.http.static_pages import read_pages
from tools.browser import SENTENCE, find_browser

THREE = Path(__file__).resolve().parent.parent / "web" / "node_modules" / "three" / "build"
FACES = ("kaori", "old", "round", "child")
EXPRESSIONS = ("smile", "angry", "surprise", "cry")
MOST = 3.0
"""How often one character's frame four of them may cost."""

# The page draws when it is told to, not with the display.
BY_HAND = """
window.waiting = [];
const display = window.requestAnimationFrame.bind(window);
window.requestAnimationFrame = (drawn) => (window.byHand ? window.waiting.push(drawn) : display(drawn));
"""
# Face and expression of a character at a frame: the next ones come every half second, smoothly.
CALLS = """
const [faces, expressions] = [%s, %s];
const call = (names, frame, ahead) => {
    const [number, part] = [Math.floor(frame / 30) + ahead, (frame %% 30) / 30];
    const weight = part * part * (3 - 2 * part);
    return { [names[number %% 4]]: 1 - weight, [names[(number + 1) %% 4]]: weight };
};
""" % (msgspec.json.encode(FACES).decode(), msgspec.json.encode(EXPRESSIONS).decode())  # noqa: UP031
STAGE = (
    CALLS
    + """
const places = (count) => (count === 1 ? [{}] : [{ x: -0.39 }, { x: -0.13 }, { x: 0.13 }, { x: 0.39 }]);
const scene = (frame, count) => ({ characters: Object.fromEntries(places(count).map((place, at) =>
    [`c${at}`, { faces: call(faces, frame, at), expressions: call(expressions, frame, at), place }])) });
window.drawFrame = (frame, count) => {
    window.omoteStage.setScene(scene(frame, count));
    for (const drawn of window.waiting.splice(0)) drawn(performance.now());
};
window.loadAll = async () => {
    const each = faces.flatMap((face) => expressions.map((expression) => [face, expression]));
    for (const [face, expression] of each)
        await window.omoteStage.hold({ faces: { [face]: 1 }, expressions: { [expression]: 1 } });
    window.byHand = true;
};
"""
)
HEAD = (
    CALLS
    + """
window.loadAll = async () => {
    const THREE = await import("/three.module.js");
    const floats = new Float32Array(await (await fetch("/heads")).arrayBuffer());
    const triangles = new Uint32Array(await (await fetch("/triangles")).arrayBuffer());
    const size = floats.length / 21;
    const shape = (n) => new THREE.BufferAttribute(floats.slice(n * size, (n + 1) * size), 3);
    const normals = (n) => {
        const whole = new THREE.BufferGeometry().setIndex(new THREE.BufferAttribute(triangles, 1));
        const base = shape(0);
        if (n > 0) shape(n).array.forEach((value, at) => { base.array[at] += value; });
        whole.setAttribute("position", base).computeVertexNormals();
        return whole.getAttribute("normal");
    };
    const geometry = new THREE.BufferGeometry().setIndex(new THREE.BufferAttribute(triangles, 1));
    geometry.setAttribute("position", shape(0)).setAttribute("normal", normals(0));
    const still = normals(0).array;
    const relative = (n) => new THREE.BufferAttribute(normals(n).array.map((value, at) => value - still[at]), 3);
    geometry.morphTargetsRelative = true;
    geometry.morphAttributes.position = Array.from({ length: 20 }, (_, n) => shape(n + 1));
    geometry.morphAttributes.normal = Array.from({ length: 20 }, (_, n) => relative(n + 1));
    const head = new THREE.Mesh(geometry, new THREE.MeshStandardMaterial({ color: 0xd8a080, roughness: 0.6 }));
    const lamp = new THREE.DirectionalLight(0xffffff, 2);
    lamp.position.set(-0.6, 0.7, 0.6);
    const scene = new THREE.Scene().add(head, lamp, new THREE.HemisphereLight(0x8899aa, 0x221100, 1));
    const canvas = document.querySelector("canvas");
    const renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
    renderer.setSize(innerWidth, innerHeight, false);
    const camera = new THREE.PerspectiveCamera(18, innerWidth / innerHeight, 0.1, 10);
    camera.position.set(0, -0.011, 1.013);
    window.drawFrame = (frame) => {
        const [worn, wearing] = [call(faces, frame, 0), call(expressions, frame, 0)];
        head.morphTargetInfluences.fill(0);
        faces.forEach((face, i) => {
            head.morphTargetInfluences[5 * i] = worn[face] ?? 0;
            expressions.forEach((expression, j) => {
                head.morphTargetInfluences[5 * i + 1 + j] = (worn[face] ?? 0) * (wearing[expression] ?? 0);
            });
        });
        renderer.render(scene, camera);
    };
    window.drawFrame(0);
};
"""
)
DRAW = """async ([frames, count]) => {
    const gl = document.querySelector("canvas").getContext("webgl2");
    for (let frame = 0; frame < frames; frame++) {
        await new Promise((done) => setTimeout(done));
        window.drawFrame(frame, count);
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)); // waits until it is drawn
    }
}"""


def heads() -> tuple[bytes, bytes]:
    """The generic head and 20 shapes relative to it as float32 positions, and its triangles as uint32."""
    cast = load_cast()

    def positions(face: str, expression: str) -> np.ndarray:
        frame = omote.parse_pose(cast, face=face, expression=expression)
        parts = omote.evaluate_parts(cast, frame)
        return np.concatenate([omote.evaluate(cast, frame), *(parts[name] for name in cast.space.parts)])

    base = positions("generic", "neutral")
    shapes = [base]
    for face in FACES:
        rest = positions(face, "neutral")
        shapes += [rest - base, *(positions(face, expression) - rest for expression in EXPRESSIONS)]
    worn = [mesh for mesh in load_meshes() if mesh.name != "lashes"]
    triangles = np.concatenate([np.asarray(mesh.source)[np.asarray(mesh.triangles)].ravel() for mesh in worn])
    return np.stack(shapes).astype(np.float32).tobytes(), triangles.astype(np.uint32).tobytes()


async def open_stage(browser: Browser, address: str) -> Page:
    """The stage page, all compounds loaded."""
    page = await browser.new_page(viewport={"width": WIDTH, "height": HEIGHT})
    await page.add_init_script(BY_HAND)
    await page.goto(f"{address}/stage?quality=lowest")
    while not await page.evaluate("Boolean(window.omoteStage)"):
        await asyncio.sleep(0.1)
    await page.evaluate("() => {" + STAGE + "}")
    await page.evaluate("window.loadAll()")
    return page


async def open_head(browser: Browser, address: str) -> Page:
    """A page with one head of three.js."""
    shapes, triangles = heads()
    files = {"heads": shapes, "triangles": triangles}

    async def answer(route: Route) -> None:
        name = route.request.url.rpartition("/")[2]
        if name.endswith(".js"):
            await route.fulfill(path=THREE / name)
        elif name in files:
            await route.fulfill(body=files[name])
        else:
            await route.fulfill(body="<body style='margin:0'><canvas></canvas>", content_type="text/html")

    page = await browser.new_page(viewport={"width": WIDTH, "height": HEIGHT})
    await page.route("**/*", answer)
    await page.goto(f"{address}/head")
    await page.evaluate("() => {" + HEAD + "}")
    await page.evaluate("window.loadAll()")
    return page


async def spend(page: Page, frames: int, count: int) -> float:
    """Milliseconds of the processors for one frame."""
    await page.bring_to_front()
    await page.evaluate(DRAW, [10, count])
    with ProcessorTime() as processors:
        await page.evaluate(DRAW, [frames, count])
    return 1000 * processors.seconds / frames


async def measure(runs: int, frames: int) -> dict[str, list[float]]:
    """Every way in turns, as often as asked for."""
    path = find_browser()
    if path is None:
        raise SystemExit(SENTENCE)
    found: dict[str, list[float]] = {}
    async with serve_pages(built_in_documents(), read_pages()) as address, async_playwright() as playwright:
        browser = await playwright.chromium.launch(executable_path=str(path), chromium_sandbox=False, args=CHROMIUM)
        stage = await open_stage(browser, address)
        head = await open_head(browser, address)
        ways: dict[str, Callable[[], Awaitable[float]]] = {
            "one character": lambda: spend(stage, frames, 1),
            "four characters": lambda: spend(stage, frames, 4),
            "one head, three.js": lambda: spend(head, frames, 1),
        }
        for _ in range(runs):
            for name, way in ways.items():
                found.setdefault(name, []).append(await way())
        await browser.close()
    return found


def verdict(found: dict[str, list[float]]) -> bool:
    """Prints the figures; whether both bars hold."""
    least = {name: min(values) for name, values in found.items()}
    one, four, head = least.values()
    table = Table(title=f"a frame on llvmpipe, {WIDTH}x{HEIGHT}, lowest", title_justify="left", box=None)
    for column in ("what", "ms of the processors", "least", "/ one character"):
        table.add_column(column)
    for name, values in found.items():
        texts = " ".join(f"{value:.1f}" for value in values)
        table.add_row(name, texts, f"{least[name]:.1f}", f"{least[name] / one:.2f}")
    Console(width=120).print(table)
    holds = {f"four cost {four / one:.2f} of one, {MOST:g} at most": four <= MOST * one}
    holds[f"four cost {four / head:.2f} of three.js's one head, less than 1"] = four < head
    for words, kept in holds.items():
        print(f"{'holds' if kept else 'MISSED'}: {words}")
    return all(holds.values())


def main() -> int:
    """Measures and prints; exit status 1 when a bar is missed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--frames", type=int, default=150)
    chosen = parser.parse_args()
    return 0 if verdict(asyncio.run(measure(chosen.runs, chosen.frames))) else 1


if __name__ == "__main__":
    sys.exit(main())
