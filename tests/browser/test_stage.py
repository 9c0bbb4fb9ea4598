"""The stage page: what the GPU blends and draws, on walls and in OBS, and what it does when something goes away."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import msgspec
import numpy as np
import pytest
from numpy.typing import NDArray
from playwright.sync_api import Page, Route, WebSocketRoute, expect

import omote
from omote.model.cast import Cast
from omote.model.known_names import PLAY_REGIONS
from omote.perform.frame import Frame, Gaze, Head
from omote.perform.scene.character_names import MOST_CHARACTERS
from omote.show.objects.state import CharacterState, Place, State
from omote.show.wire import decode_answer
from omote.stage_data.pose_parser import pose_of as whole_pose_of
from tests.browser.pictures import picture
from tests.browser.waiting import PATIENCE, draw_on_demand, floats, wait_until

pytestmark = pytest.mark.long

OpenPage = Callable[..., Page]
Floats = NDArray[np.float64]
FRAMES = 40
TOLERANCE = 0.05e-3  # metres
POSE = ("faces", "expressions", "regions", "channels", "added", "head", "eyes")
TWO = {
    "one": {"faces": {"kaori": 0.6, "old": 0.4}, "expressions": {"laugh": 1.0}, "place": {"x": -0.1, "turn": 0.3}},
    "two": {"faces": {"old": 1.0}, "place": {"x": 0.16, "depth": 0.1, "size": 0.9, "turn": -0.4}},
}
LAUGHING = {"faces": {"kaori": 0.6, "old": 0.4}, "expressions": {"laugh": 1.0}, "head": [0.3, 0.1, -0.1]}


def wait_for(page: Page, condition: str) -> None:
    """Waits until a condition on the `stage`'s probe holds."""
    wait_until(page, f"stage && ({condition})", "const stage = window.omoteStage", told="stage?.counters()")


@pytest.fixture
def stage(open_page: OpenPage, held_stage: OpenPage) -> Callable[..., Page]:
    """Opens a stage and waits until it draws; one that is not `live` draws what it is to hold from then on."""

    def open_one(query: str = "", *, width: int = 320, height: int = 240, live: bool = False) -> Page:
        if not live:
            return held_stage(query, width=width, height=height)
        page = open_page(f"/stage{query}", width=width, height=height)
        wait_for(page, "stage.counters().drawn > 0")
        return page

    return open_one


@pytest.fixture
def tile(open_page: OpenPage) -> Callable[..., Page]:
    """Opens a stage that draws what it is to hold, in the place of the last one."""
    opened: Page | None = None

    def open_one(query: str, *, width: int, height: int) -> Page:
        nonlocal opened
        opened = open_page(f"/stage{query}", width=width, height=height, over=opened)
        wait_for(opened, "stage.counters().drawn > 0")
        draw_on_demand(opened)
        return opened

    return open_one


@pytest.fixture(scope="module")
def cast() -> Cast:
    return omote.load_cast()


def hold(page: Page, pose: Mapping[str, Any]) -> None:
    page.evaluate("pose => window.omoteStage.hold(pose)", pose)


def hold_scene(page: Page, characters: Mapping[str, Any], black: float = 0.0) -> None:
    page.evaluate(
        "([characters, black]) => window.omoteStage.holdScene({ characters, black })", [dict(characters), black]
    )


def positions(page: Page) -> Floats:
    """The GPU's positions (vertices, 3)."""
    return floats(page, "window.omoteStage.readPositions()").reshape(-1, 3)


def expected(cast: Cast, frame: Frame) -> Floats:
    """The reference evaluator's positions: skin, then the parts."""
    parts = omote.evaluate_parts(cast, frame)
    return np.concatenate([omote.evaluate(cast, frame), *(parts[name] for name in cast.space.parts)])


# --- what the GPU blends ----------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Pool:
    """The names that frames are drawn from: some of the cast's, so that the compounds are worked out once for many."""

    faces: list[str]
    expressions: list[str]

    @classmethod
    def drawn(cls, cast: Cast, rng: np.random.Generator) -> Pool:
        expressions = [name for name in cast.expressions if name != "neutral"]
        return cls(rng.permutation(list(cast.faces))[:4].tolist(), rng.permutation(expressions)[:24].tolist())


def random_frame(pool: Pool, rng: np.random.Generator, regional: bool) -> Frame:
    """A mix as a show meets it: some faces, expressions, channels and a gaze; weights may leave 0..1 a little.

    regional: one to four regions show mixes of their own.
    """

    def weights(names: list[str], count: int) -> dict[str, float]:
        chosen = rng.choice(names, size=count, replace=False).tolist()
        share = rng.dirichlet(np.ones(count)) + 0.03 * rng.standard_normal(count)
        return dict(zip(chosen, (share / share.sum()).tolist(), strict=True))

    def expressions() -> dict[str, float]:
        return weights(["neutral", *pool.expressions], int(rng.integers(1, 5)))

    channels = rng.choice(pool.expressions, size=int(rng.integers(0, 9)), replace=False).tolist()
    regions = rng.permutation(PLAY_REGIONS)[: int(rng.integers(1, 5))].tolist() if regional else []
    return Frame(
        faces=weights(pool.faces, int(rng.integers(1, 4))),
        expressions=expressions(),
        regions={region: expressions() for region in regions},
        channels={name: float(rng.uniform(-0.2, 1.4)) for name in channels},
        head=Head(*rng.uniform(-0.5, 0.5, 3).tolist()),
        gaze=Gaze(*rng.uniform(-0.4, 0.4, 2).tolist()),
    )


def pose_of(cast: Cast, frame: Frame) -> dict[str, Any]:
    """What the server would tell a stage of this frame."""
    whole = whole_pose_of(cast, frame)
    return {name: whole[name] for name in POSE}


@pytest.fixture(scope="module")
def random_frames(cast: Cast) -> list[tuple[Frame, Floats]]:
    """Frames, every second one with regions of its own, and what the evaluator has of each."""
    rng = np.random.default_rng(1993)
    pool = Pool.drawn(cast, rng)
    frames = [random_frame(pool, rng, regional=number % 2 == 1) for number in range(FRAMES)]
    return [(frame, expected(cast, frame)) for frame in frames]


@pytest.mark.parametrize("level", ["lowest", "medium"])
def test_positions_equal_the_bilinear_evaluator(
    stage: Callable[..., Page], cast: Cast, random_frames: list[tuple[Frame, Floats]], level: str
) -> None:
    """By shaders, or at low levels without a graphics processor not. With and without regions that go their own way, in
    turn: what one leaves on the GPU is not in the next."""
    page = stage(f"?quality={level}")
    for frame, points in random_frames:
        hold(page, pose_of(cast, frame))
        wrong = np.linalg.norm(positions(page) - points, axis=1)
        assert wrong.max() < TOLERANCE, (frame, wrong.argmax())


@pytest.mark.parametrize("level", ["lowest", "medium"])
def test_one_unit_beyond_its_end_is_corrected_as_by_the_evaluator(
    stage: Callable[..., Page], cast: Cast, level: str
) -> None:
    """Lids that are asked for more than a closed eye press, and triangles stay upright."""
    page = stage(f"?quality={level}")
    for name in ("eyeBlinkLeft", "mouthPucker"):
        frame = Frame({"baby": 1.0}, {"neutral": 1.0}, channels={name: 1.5})
        hold(page, pose_of(cast, frame))
        assert np.linalg.norm(positions(page) - expected(cast, frame), axis=1).max() < TOLERANCE


def test_all_expressions_at_once_are_blended(stage: Callable[..., Page], cast: Cast) -> None:
    """More compounds than the texture array holds at first: it grows, and nothing is lost."""
    frame = Frame(
        faces={"kaori": 0.5, "old": 0.5},
        expressions={"neutral": 1.0},
        channels={name: 0.02 for name in cast.expressions if name != "neutral"},
    )
    page = stage()
    hold(page, pose_of(cast, frame))
    assert np.linalg.norm(positions(page) - expected(cast, frame), axis=1).max() < TOLERANCE


def test_a_late_compound_is_held_back_and_grows_in(stage: Callable[..., Page], cast: Cast) -> None:
    waiting: list[Route] = []
    page = stage(live=True, width=160, height=120)
    page.route("**/compounds/*/generic/mouth-open", lambda route: waiting.append(route))
    hold(page, {"faces": {"generic": 1.0}})
    rest = positions(page)
    page.evaluate("""() => window.omoteStage.set({ faces: { generic: 1 }, expressions: { "mouth-open": 1 } })""")
    wait_for(page, "stage.counters().drawn > 3 && !stage.settled()")
    assert np.array_equal(positions(page), rest)
    full = np.linalg.norm(expected(cast, Frame({"generic": 1.0}, {"mouth-open": 1.0})) - rest, axis=1).argmax()
    page.evaluate(f"""() => {{
        const place = () => window.omoteStage.readPositions().slice({3 * full}, {3 * full + 3});
        const seen = window.seen = [place()];
        const look = () => {{ seen.push(place()); requestAnimationFrame(look); }};
        requestAnimationFrame(look);
    }}""")
    for route in waiting:
        route.continue_()
    wait_for(page, "stage.settled()")
    wait_for(page, "window.seen.length > 5")
    way = np.linalg.norm(floats(page, "window.seen.flat()").reshape(-1, 3) - rest[full], axis=1)
    way = way / way[-1]
    assert way[0] == 0
    assert (np.diff(way) >= -1e-6).all()
    assert ((way > 0.01) & (way < 0.99)).any(), "it popped"


# --- what is drawn ----------------------------------------------------------------------------------------------------


def test_a_face_stands_on_a_dark_stage(stage: Callable[..., Page]) -> None:
    page = stage()
    hold(page, {"faces": {"kaori": 1.0}})
    seen = picture(page)
    middle = seen[80:160, 120:200, :3].mean(axis=(0, 1))
    corner = seen[:8, :8, :3].mean(axis=(0, 1))
    assert (seen[..., 3] == 255).all()
    assert corner.max() < 40 < 110 < middle.min()
    assert middle[0] > middle[2], "skin is warm"
    hold_scene(page, {"one": {"faces": {"kaori": 1.0}}})
    up = picture(page)
    hold_scene(page, {"one": {"faces": {"kaori": 1.0}}}, black=0.25)
    assert np.abs(picture(page)[..., :3] - 0.75 * up[..., :3]).max() <= 1.0
    hold_scene(page, {"one": {"faces": {"kaori": 1.0}}}, black=1.0)
    assert (picture(page) == (0, 0, 0, 255)).all()


def test_skin_is_painted_anew_whenever_its_look_changes(stage: Callable[..., Page]) -> None:
    """At `lowest` a skin's colour is a picture of its own: what one face leaves in it is not on the next."""
    page = stage("?quality=lowest", width=160, height=120)
    faces: list[dict[str, float]] = [{"kaori": 1.0}, {"dog": 1.0}, {"kaori": 0.5, "noh": 0.5}, {"noh": 1.0}]
    looks = []
    for mix in faces:
        hold(page, {"faces": mix})
        looks.append(picture(page))
    for mix, look in zip(reversed(faces), reversed(looks), strict=True):
        hold(page, {"faces": mix})
        assert np.array_equal(picture(page), look), mix
    dog = looks[1][..., :3]
    noh = looks[3][..., :3]
    assert dog[40:90, 60:100, 0].mean() > dog[40:90, 60:100, 2].mean() + 40, "orange fur"
    assert noh[40:60, 70:90].mean(axis=(0, 1)).min() > 160, "white paint, whatever the light"


def test_two_faces_and_two_expressions_look_different(stage: Callable[..., Page]) -> None:
    page = stage()
    seen = []
    poses = [("kaori", "neutral"), ("old", "neutral"), ("kaori", "laugh"), ("kaori", "neutral")]
    for face, expression in poses:
        hold(page, {"faces": {face: 1.0}, "expressions": {expression: 1.0}})
        seen.append(picture(page))
    assert np.array_equal(seen[0], seen[3])
    for other in seen[1:3]:
        assert (np.abs(other - seen[0]).max(axis=2) > 30).sum() > 300


def test_a_transparent_stage_leaves_the_background_open(stage: Callable[..., Page]) -> None:
    page = stage("?transparent")
    hold(page, {"faces": {"kaori": 1.0}})
    alpha = picture(page)[..., 3]
    assert (alpha[:8, [0, 1, -2, -1]] == 0).all()
    assert (alpha[80:160, 130:190] == 255).all()
    assert ((alpha > 0) & (alpha < 255)).sum() > 100  # edges are smooth at the lowest level too
    hold_scene(page, {"one": {"faces": {"kaori": 1.0}}}, black=1.0)
    assert (picture(page) == 0).all(), "what it lies over stays"


def test_nine_tiles_make_one_picture(stage: Callable[..., Page], tile: Callable[..., Page]) -> None:
    def shown(page: Page) -> NDArray[np.int16]:
        hold_scene(page, TWO)
        return picture(page)

    whole = shown(stage("", width=480, height=360))
    tiles = [
        [shown(tile(f"?tile={column},{row}&of=3x3", width=160, height=120)) for column in range(3)] for row in range(3)
    ]
    wall = np.concatenate([np.concatenate(row, axis=1) for row in tiles], axis=0)
    difference = np.abs(wall - whole).max(axis=2)
    assert wall.std() > 20
    assert (difference <= 2).mean() > 0.99
    assert difference.mean() < 0.5


def test_a_bezel_hides_what_lies_behind_it(stage: Callable[..., Page], tile: Callable[..., Page]) -> None:
    """Two tiles with a gap of 20 % are the outer parts of one picture of 2.2 tiles."""
    whole = stage("", width=352, height=160)
    hold(whole, LAUGHING)
    everything = picture(whole)
    for column, left in ((0, 0), (1, 192)):
        page = tile(f"?tile={column},0&of=2x1&bezel=20", width=160, height=160)
        hold(page, LAUGHING)
        difference = np.abs(picture(page) - everything[:, left : left + 160]).max(axis=2)
        assert (difference <= 2).mean() > 0.99


@pytest.mark.parametrize(
    ("query", "named"),
    [("?tile=3,0&of=3x3", "tile=3,0"), ("?quality=best", "quality=best"), ("?colour=red", '"colour"')],
)
def test_a_bad_address_is_refused_with_a_sentence(open_page: OpenPage, query: str, named: str) -> None:
    expect(open_page(f"/stage{query}").get_by_role("alert")).to_contain_text(named)


# --- what goes away ---------------------------------------------------------------------------------------------------


LOSE = """async () => {
    const canvas = document.querySelector("canvas");
    const handle = canvas.getContext("webgl2").getExtension("WEBGL_lose_context");
    const happens = (what) => new Promise((done) => canvas.addEventListener(what, done, { once: true }));
    const lost = happens("webglcontextlost");
    handle.loseContext();
    await lost;
    await new Promise(requestAnimationFrame);
    const restored = happens("webglcontextrestored");
    handle.restoreContext();
    await restored;
}"""


def lose_and_restore(page: Page) -> None:
    """Takes the graphics context from a stage and gives it back; waits until it shows what it showed."""
    page.evaluate(LOSE)
    drawn = page.evaluate("window.omoteStage.counters().drawn")
    wait_for(page, f"stage.counters().drawn > {drawn} && stage.settled()")


def test_a_lost_context_comes_back_with_the_same_face(stage: Callable[..., Page]) -> None:
    page = stage(live=True, width=160, height=120)
    hold(page, LAUGHING)
    before = positions(page)
    looked = picture(page)
    for _ in range(3):
        lose_and_restore(page)
        assert np.array_equal(positions(page), before)
        assert np.array_equal(picture(page), looked)


LOSE_FOR_EVER = """() => {
    const canvas = document.querySelector("canvas");
    window.lostCanvas = canvas;
    canvas.getContext("webgl2").getExtension("WEBGL_lose_context").loseContext();
}"""


def test_a_context_that_does_not_come_back_is_replaced_on_a_new_canvas(stage: Callable[..., Page]) -> None:
    page = stage(live=True, width=160, height=120)
    hold(page, LAUGHING)
    before = positions(page)
    looked = picture(page)
    page.evaluate(LOSE_FOR_EVER)
    wait_for(page, "!stage.settled()")
    wait_for(page, "window.lostCanvas.isConnected === false && stage.settled()")
    assert page.locator("canvas#stage").count() == 1
    hold(page, LAUGHING)
    assert np.array_equal(positions(page), before)
    assert np.array_equal(picture(page), looked)


def test_a_browser_that_gives_no_context_again_loads_the_page_anew(open_page: OpenPage) -> None:
    page = open_page("/stage?quality=lowest&name=left", width=160, height=120, disposable=True)
    wait_for(page, "stage && stage.counters().drawn > 5")
    lost = "document.querySelector('canvas').dispatchEvent(new Event('webglcontextlost', { cancelable: true }))"
    with page.expect_navigation(timeout=1000.0 * PATIENCE):
        page.evaluate(f"() => {{ HTMLCanvasElement.prototype.getContext = () => null; {lost}; }}")
    wait_for(page, "stage.counters().drawn > 5")


def test_without_webgl_the_page_says_so(open_page: OpenPage, show: str) -> None:
    page = open_page("/", disposable=True)
    page.add_init_script("HTMLCanvasElement.prototype.getContext = () => null")
    page.goto(f"{show}/stage")
    expect(page.get_by_role("alert")).to_contain_text("WebGL2")


class Wire:
    """The link of a page as the test holds it: it may be cut, refused, and given messages of the test's own."""

    def __init__(self, page: Page) -> None:
        self.refusing = False
        self.routes: list[tuple[WebSocketRoute, WebSocketRoute]] = []
        self.states: list[State] = []
        page.route_web_socket("**/link", self._open)

    def _open(self, route: WebSocketRoute) -> None:
        if self.refusing:
            route.close()
            return
        server = route.connect_to_server()
        self.routes.append((route, server))

        def forward(message: str | bytes) -> None:
            assert isinstance(message, bytes)
            decoded = decode_answer(message)
            if isinstance(decoded, State):
                self.states.append(decoded)
            route.send(message)

        server.on_message(forward)

    def cut(self) -> None:
        """The server dies."""
        self.refusing = True
        for route, server in self.routes:
            server.close()
            route.close()
        self.routes = []

    def send(self, state: State) -> None:
        """A state of the test's own arrives."""
        self.routes[-1][0].send(msgspec.msgpack.encode(state))


def test_a_stage_holds_its_face_while_the_server_is_gone(open_page: OpenPage) -> None:
    page = open_page("/", disposable=True)
    wire = Wire(page)
    page.goto(page.url + "stage")
    wait_for(page, "stage.counters().received > 5 && stage.settled()")
    wire.cut()
    wait_for(page, "!stage.counters().connected")
    before = page.evaluate("window.omoteStage.pose()")
    counted = page.evaluate("window.omoteStage.counters()")
    wait_for(page, f"stage.counters().drawn > {counted['drawn'] + 30}")
    held = page.evaluate("window.omoteStage.pose()")
    assert (held["faces"], held["expressions"]) == (before["faces"], before["expressions"])
    assert np.abs(np.subtract(held["head"], before["head"])).max() < 0.03, "it only breathes"
    wire.refusing = False
    wait_for(page, f"stage.counters().connected && stage.counters().received > {counted['received'] + 10}")


RECORD_TOPS = """() => {
    window.tops = [];
    const look = () => {
        for (const [, top] of Object.values(window.omoteStage.heads())) window.tops.push(top);
        requestAnimationFrame(look);
    };
    look();
}"""


def test_a_stage_that_has_waited_for_the_show_has_the_head_in_its_place_at_once(open_page: OpenPage) -> None:
    """A source of OBS that loads again is on air: its picture begins without an entrance."""
    page = open_page("/", disposable=True)
    wire = Wire(page)
    wire.refusing = True
    page.goto(page.url + "stage")
    wait_for(page, "true")
    page.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    page.evaluate(RECORD_TOPS)
    wire.refusing = False
    wait_for(page, "stage.settled() && window.tops.length > 3")
    tops = page.evaluate("window.tops")
    assert max(tops) - min(tops) < 0.05


def test_a_stage_takes_the_newest_state_and_draws_its_whole_scene(open_page: OpenPage, cast: Cast) -> None:
    page = open_page("/", disposable=True, width=160, height=120)
    wire = Wire(page)
    page.goto(page.url + "stage?quality=lowest")
    wait_for(page, "stage.counters().received > 5")
    newest = wire.states[-1]
    one = newest.characters["one"]
    doll = {"one": msgspec.structs.replace(one, faces={"doll": 1.0})}
    wire.send(msgspec.structs.replace(newest, epoch=newest.epoch - 1, number=newest.number + 10**9, characters=doll))
    wire.send(msgspec.structs.replace(newest, number=0, characters=doll))
    wait_for(page, "stage.counters().ignored === 2")
    assert page.evaluate("window.omoteStage.pose().faces") == one.faces

    # From here on only the test's own states count.
    scene = Scene(wire, msgspec.structs.replace(newest, epoch=newest.epoch + 1), one)
    laughing = {"faces": {"old": 1.0}, "expressions": {"laugh": 1.0}, "regions": {"brows": {"surprise": 1.0}}}
    scene.show({"one": {}, "two": {**laughing, "presence": 0.5}})
    wait_for(page, "stage.scene().characters.two?.presence === 0.5 && stage.settled()")
    frame = Frame(faces={"old": 1.0}, expressions={"laugh": 1.0}, regions={"brows": {"surprise": 1.0}})
    drawn = floats(page, "window.omoteStage.readPositions('two')").reshape(-1, 3)
    np.testing.assert_allclose(drawn, expected(cast, frame), rtol=0, atol=TOLERANCE)
    np.testing.assert_allclose(
        positions(page), expected(cast, Frame(one.faces, one.expressions)), rtol=0, atol=TOLERANCE
    )
    hold_scene(page, TWO)
    together = picture(page)
    page.evaluate("window.omoteStage.holdScene(null)")

    scene.show({"one": {}, "two": {"faces": {"dog": 1.0}, "expressions": {"angry": 1.0}}})  # gone while it loads
    scene.show({"one": {}})
    wait_for(page, "!stage.scene().characters.two && stage.settled()")
    mixes = {
        f"n{number}": {"laugh": 0.9 - number / 40, "neutral": 0.1 + number / 40} for number in range(1, MOST_CHARACTERS)
    }
    scene.show({"one": {}, **{name: {**laughing, "expressions": mix} for name, mix in mixes.items()}})
    wait_for(page, f"Object.keys(stage.scene().characters).length === {MOST_CHARACTERS} && stage.settled()")
    for name in ("n1", f"n{MOST_CHARACTERS - 1}"):  # all in the same passes
        drawn = floats(page, f"window.omoteStage.readPositions('{name}')").reshape(-1, 3)
        frame = Frame(faces={"old": 1.0}, expressions=mixes[name], regions={"brows": {"surprise": 1.0}})
        np.testing.assert_allclose(drawn, expected(cast, frame), rtol=0, atol=TOLERANCE)
    lose_and_restore(page)
    hold_scene(page, TWO)
    assert np.array_equal(picture(page), together), "the same scene is the same picture, whatever was before"


@dataclass
class Scene:
    """States of the test's own, each newer than the last."""

    wire: Wire
    state: State
    rest: CharacterState

    def show(self, characters: Mapping[str, Mapping[str, Any]]) -> None:
        """These characters, each at rest but for what is given, side by side, are on air."""
        whole = {
            name: msgspec.structs.replace(self.rest, place=Place(0.3 * at, 0.0, 1.0, 0.0), **given)
            for at, (name, given) in enumerate(characters.items())
        }
        self.state = msgspec.structs.replace(
            self.state, number=self.state.number + 1, characters=whole, framing={"*": 1.0}
        )
        self.wire.send(self.state)


RECORD_SEEN = """
window.seen = [];
const look = () => {
    if (document.body !== null) window.seen.push(Number(getComputedStyle(document.body).opacity));
    requestAnimationFrame(look);
};
look();
"""


def test_a_stage_comes_up_from_black_and_goes_black_with_the_show_and_all_that_lies_on_it(open_page: OpenPage) -> None:
    page = open_page("/", disposable=True, width=160, height=120)
    page.add_init_script(RECORD_SEEN)
    wire = Wire(page)
    page.goto(page.url + "stage?quality=lowest&hud")
    wait_for(page, "stage.settled() && window.seen.at(-1) === 1")
    seen = np.array(page.evaluate("window.seen"))
    assert seen[0] == 0.0
    assert (np.diff(seen) >= 0.0).all()
    assert np.diff(seen).max() < 0.35, "half a second, however slow its frames"
    page.locator("#hud").get_by_text("on air").wait_for()
    assert picture(page)[..., :3].max() > 100

    newest = msgspec.structs.replace(
        wire.states[-1], epoch=wire.states[-1].epoch + 1
    )  # the test's own count from now on
    wire.send(msgspec.structs.replace(newest, black=1.0, black_goal=1.0))
    wait_for(page, "stage.scene().black === 1 && document.body.style.opacity === '0'")
    assert (picture(page) == (0, 0, 0, 255)).all()
    drawn = page.evaluate("window.omoteStage.counters().drawn")
    wait_for(page, f"stage.counters().drawn > {drawn + 3}")  # below it the picture goes on
    wire.send(msgspec.structs.replace(newest, number=newest.number + 1, black=0.5))
    wait_for(page, "stage.scene().black === 0.5 && document.body.style.opacity === '0.5'")
    wire.cut()
    wait_for(page, f"!stage.counters().connected && stage.counters().drawn > {drawn + 30}")
    assert page.evaluate("window.omoteStage.scene().black") == 0.5, "a server that dies brings no light"


INSECURE = "Object.defineProperty(window, 'isSecureContext', { value: false });"


def test_a_stage_keeps_its_screen_on_or_is_named_and_fills_it_by_f_and_by_a_double_click(open_page: OpenPage) -> None:
    devices = open_page("/devices", pictures=False)
    stages = devices.locator("omote-stages")
    page = open_page("/", disposable=True, width=160, height=120)
    page.goto(page.url + "stage?quality=lowest&name=left")
    expect(stages).to_contain_text("Stage left keeps its screen on.")
    full = "document.fullscreenElement !== null"
    page.keyboard.press("f")
    wait_for(page, full)
    page.mouse.dblclick(80, 60)
    wait_for(page, f"!({full})")
    page.add_init_script(INSECURE)
    page.reload()
    expect(stages.locator(".attention")).to_contain_text("Stage left may go to sleep: its address is not secure")


COUNT_DRAWING = """
for (const name of ["drawElements", "drawArrays"]) {
    const draw = WebGL2RenderingContext.prototype[name];
    WebGL2RenderingContext.prototype[name] = function (...given) {
        window.draws = (window.draws ?? 0) + 1;
        return draw.apply(this, given);
    };
}
"""
END_FRAMES = """() => {
    const ask = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = () => 0;
    return new Promise(ask); // those that were asked for before have had their turn
}"""
FRAMES_DRAWN = """(frames) => new Promise((done) => {
    let [drawn, draws, left] = [0, window.draws, frames];
    const look = () => {
        drawn += window.draws > draws ? 1 : 0;
        draws = window.draws;
        left -= 1;
        if (left > 0) requestAnimationFrame(look);
        else done(drawn);
    };
    requestAnimationFrame(look);
})"""


def test_a_still_picture_is_seldom_drawn_and_what_changes_it_without_waiting_for_a_frame(open_page: OpenPage) -> None:
    page = open_page("/", disposable=True, width=160, height=120)
    page.add_init_script(COUNT_DRAWING)
    wire = Wire(page)
    page.goto(page.url + "stage?quality=lowest")
    wait_for(page, "stage.counters().received > 5 && stage.settled()")
    wait_for(page, f"stage.counters().drawn > {page.evaluate('window.omoteStage.counters().drawn')} + 5")
    shown = page.evaluate("window.omoteStage.counters().drawn")
    assert page.evaluate(FRAMES_DRAWN, 60) <= 5
    assert page.evaluate("window.omoteStage.counters().drawn") > shown + 50, "a frame that shows it counts"
    page.evaluate(END_FRAMES)
    draws = page.evaluate("window.draws")
    newest = wire.states[-1]
    one = msgspec.structs.replace(newest.characters["one"], channels={"jawOpen": 0.5})
    wire.send(
        msgspec.structs.replace(newest, number=newest.number + 10**9, time=newest.time + 1.0, characters={"one": one})
    )
    wait_for(page, f"stage.pose().channels.jawOpen > 0 && window.draws > {draws}")


SLOW = """() => {
    const ask = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (draw) => ask((time) => {
        for (const end = performance.now() + 2000; performance.now() < end; );
        draw(time);
    });
}"""


def test_a_stage_whose_frames_take_seconds_keeps_its_link(stage: Callable[..., Page]) -> None:
    page = stage("?quality=lowest", live=True)
    page.evaluate(SLOW)
    before = page.evaluate("window.omoteStage.counters()")
    wait_for(page, f"stage.counters().drawn >= {before['drawn'] + 4}")
    after = page.evaluate("window.omoteStage.counters()")
    assert after["connected"]
    assert after["received"] - before["received"] > 0.5 * (after["number"] - before["number"]) > 60
    assert after["fps"] < 1
