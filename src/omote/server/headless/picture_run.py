"""Draws many pictures into files: each is written when it is done, and one that is there already is not drawn again."""

from __future__ import annotations

import asyncio
import hashlib
import time
import warnings
from collections.abc import Awaitable, Callable, Container, Iterator, Mapping, Sequence
from contextlib import AsyncExitStack, closing
from dataclasses import dataclass, field
from functools import partial
from itertools import pairwise
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from omote import __version__
from omote.arrays import Picture, Values
from omote.builtin import load_cast, load_mask, load_meshes
from omote.interchange.formats.atomic_file import write_whole
from omote.interchange.formats.file_names import KINDS, picture_kind
from omote.interchange.formats.png import read_png
from omote.perform.clips.clip import Clip
from omote.server.headless.chromium import find_chromium, open_chromium
from omote.server.headless.devtools import BrowserError
from omote.server.headless.picture_renderer import PictureBrowser, PicturePage, open_picture_page, serve_pages
from omote.server.http.cast_documents import CastDocuments
from omote.server.http.cast_reload import gather_cast
from omote.server.http.static_pages import Page, read_pages
from omote.show.objects.clips import StoredClip, read_clips
from omote.showfile.contents import unpack_face
from omote.showfile.inspection import Inspection
from omote.stage_data.clip_poses import ClipPoses
from omote.stage_data.full_cast import own_items
from omote.stage_data.morph_distance import SHARE_PLACES, find_even_steps, measure_difference, measure_distance
from omote.stage_data.picture_grid import PictureGrid, lay_out, spell_out
from omote.stage_data.picture_request import (
    MOST_STEPS,
    GridRequest,
    Morph,
    RenderRequest,
    Request,
    plan_cells,
    read_morph,
    spell_kinds,
)
from omote.stage_data.picture_setting import Clipped, Setting
from omote.stage_data.picture_sidecar import (
    PictureState,
    Sidecar,
    describe,
    encode_sidecar,
    is_drawn,
    move_request,
    picture_state,
    sidecar_path,
)
from omote.stage_data.playing_cast import Own, PlayingCast, kinds_of
from omote.stage_data.pose_parser import find_pose


@dataclass(frozen=True)
class PictureFile:
    """A picture to be drawn, where it will lie, and what its sidecar will say."""

    path: Path
    sheet: PictureGrid
    sidecar: Sidecar


@dataclass(frozen=True)
class PictureProgress:
    """What has just been done: a picture drawn in some seconds, the one numbered `number` of `total`."""

    path: Path
    seconds: float
    number: int
    total: int


@dataclass(frozen=True, eq=False)
class PictureRun:
    """All pictures of one command, and the table that they are composed to, where there is one."""

    setting: Setting
    pictures: Sequence[PictureFile]
    table: PictureFile | None = None
    fresh: bool = False
    waiting: list[PictureFile] = field(init=False)
    states: Mapping[Path, PictureState] = field(init=False)

    def __post_init__(self) -> None:
        """Finds out what is drawn already; all pictures of a table that is there are taken for drawn."""
        states = {file.path: picture_state(file.path, file.sidecar) for file in self.files}
        drawn = {path for path, state in states.items() if state == "drawn" and not self.fresh}
        whole = self.table is not None and self.table.path in drawn
        object.__setattr__(self, "states", states)
        object.__setattr__(self, "waiting", [] if whole else [f for f in self.pictures if f.path not in drawn])

    @property
    def files(self) -> list[PictureFile]:
        """Every file that is drawn, the table last."""
        return [*self.pictures, *([self.table] if self.table else [])]

    @property
    def whole(self) -> PictureFile:
        """What the command is to give: the table, or the only picture."""
        return self.table or self.pictures[0]

    @property
    def complete(self) -> bool:
        """Whether nothing is left to do."""
        table = self.table
        return not self.waiting and (table is None or (not self.fresh and is_drawn(table.path, table.sidecar)))

    def refuse_foreign(self) -> None:
        """Rejects, by FileExistsError, to overwrite a picture that Omote did not draw, or that was changed since."""
        for file in (
            [] if self.complete else [file for file in self.files if file in self.waiting or file is self.table]
        ):
            if self.states[file.path] == "foreign":
                beside = sidecar_path(file.path)
                why = f"{beside.name} is of another" if beside.exists() else f"no {beside.name} lies beside it"
                raise FileExistsError(
                    f"{file.path} is there already and is not as Omote drew it ({why}); it stays as it is: --force "
                    "replaces it, or write under another name"
                )


class PictureStudio:
    """The cast, with a show file's own work where one is given, and the pages that draw it; for one run."""

    def __init__(self, show: Inspection | None = None, report: Callable[[str], None] | None = None) -> None:
        self.documents = CastDocuments(load_cast(), load_meshes(), load_mask())
        self.pages = read_pages()
        self._report = report
        self.show = show
        own: tuple[Own, ...] = ()
        clips: Mapping[str, Clip] = {}
        if show is not None:
            own = own_items(show.stored)
            self.documents.contents = show.contents
            clips, lost = read_clips(show.stored.documents.get(StoredClip.kind, {}))
            for sentence in lost:
                self._say(sentence)
        base = self.documents.playing
        contents = self.documents.contents
        self.cast: PlayingCast = gather_cast(self.documents.cast, own, contents, report or warnings.warn, before=base)
        self.clips = ClipPoses(self.cast, clips)
        self._made_by = (__version__, self.cast.digest, digest_of_pages(self.pages))

    def plan(self, request: Request, path: Path, *, fresh: bool = False) -> PictureRun:
        """Everything that a request wants drawn; ValueError where that cannot be, before anything is drawn.

        path: of the picture or the table; fresh: draws all again.
        """
        request = spell_out(self._count_steps(request), self.cast)
        whole = self.file_of(request, path)
        if isinstance(request, RenderRequest):
            return PictureRun(request.setting, [whole], fresh=fresh)
        return PictureRun(request.setting, list(self._cells(request, path)), whole, fresh)

    def _count_steps(self, request: Request) -> Request:
        """The request with its morph's steps spelled out, where they are to be measured."""
        if isinstance(request, RenderRequest) or not request.morph.strip():
            return request
        morph = read_morph(request.morph)
        if not morph.measured:
            return request
        steps = self._even_in_colour(request, morph) if morph.colour else self._even_in_mesh(morph)
        return msgspec.structs.replace(request, morph=f"{morph.first}:{morph.last}:{steps}")

    def _even_in_mesh(self, morph: Morph) -> str:
        """How many steps of a morph are as many millimetres apart as it says."""
        millimetres = morph.apart or 0.0
        away = measure_distance(self.cast.base.space, self._mix_shape(morph.first), self._mix_shape(morph.last))
        count = round(away / millimetres) + 1
        if not 2 <= count <= MOST_STEPS:
            raise ValueError(
                f"{morph.first} and {morph.last} are {away:.2f} mm apart, so steps of {millimetres:g} mm are "
                f"{count - 1}; give a distance of which there are 1 to {MOST_STEPS - 1}"
            )
        self._say(
            f"{morph.first} and {morph.last} are {away:.2f} mm apart (root mean square of the skin): {count} "
            f"pictures, {away / (count - 1):.3f} mm from each to the next."
        )
        return str(count)

    def _even_in_colour(self, grid: GridRequest, morph: Morph) -> str:
        """The percents of steps whose pictures are even in CIELAB, found by drawing them.

        Drawn with the table's first expression and turn: its other rows have the same faces.
        """
        self._say(f"{morph.first} to {morph.last}: pictures are drawn to find steps that are even in CIELAB")
        fresh = None if self.show is None else PictureStudio(self.show)
        playing = None if fresh is None else (fresh.documents, fresh.cast)
        with closing(PictureBrowser(grid.setting, playing=playing)) as browser:
            probe = MorphProbe(self.cast, grid, morph, browser)
            found = find_even_steps(morph.count, probe.measure, morph.apart, MOST_STEPS)
        self._say(
            f"{len(found.shares)} pictures, {found.apart.mean():.3f} from each to the next (mean CIE 1976 difference "
            f"of their pixels; the least {found.apart.min():.3f}, the most {found.apart.max():.3f})."
        )
        return _spell([100.0 * share for share in found.shares])

    def _say(self, text: str) -> None:
        if self._report is not None:
            self._report(text)

    def _mix_shape(self, mix: str) -> Values:
        """The skin (V, 3) of a mix of faces as it is typed, metres."""
        own = {item.name: item.content for item in self.cast.own if item.kind == "face"}
        weights = find_pose(self.cast, RenderRequest(face=(mix,)).words).faces
        shapes = [
            weight
            * (
                unpack_face(self.documents.contents[own[name]], name)[0] if name in own else self.cast.base.faces[name]
            ).positions.astype(np.float64)
            for name, weight in weights.items()
        ]
        return np.asarray(np.sum(shapes, axis=0), np.float64)

    def file_of(self, request: Request, path: Path) -> PictureFile:
        """A picture or a table where it will lie; errors as `plan`.

        request: what it shows, spelled out; path: of the file.
        """
        setting = request.setting
        sheet = lay_out(request, self.cast, self.clips).on_paper(setting, picture_kind(path))
        named = move_request(request, Path(), path.parent)
        return PictureFile(path, sheet, describe(named, sheet, setting, self._made_by))

    def _cells(self, request: GridRequest, path: Path) -> Iterator[PictureFile]:
        folder = pictures_folder(path)
        for row in plan_cells(request).cells:
            yield from (self.file_of(cell, folder / f"{name}.png") for name, cell in row)


@dataclass(frozen=True, eq=False)
class MorphProbe:
    """How far the pictures of a morph's steps are apart in CIELAB; no step is drawn twice.

    cast: that knows the names; grid: what the pictures are like; morph: its ends; browser: that draws.
    """

    cast: PlayingCast
    grid: GridRequest
    morph: Morph
    browser: PictureBrowser
    _drawn: dict[str, Picture] = field(default_factory=dict, init=False)

    def measure(self, shares: Sequence[float]) -> list[float]:
        """How far each of these shares of the last face is from the next."""
        morph = f"{self.morph.first}:{self.morph.last}:{_spell([100.0 * share for share in shares])}"
        cells = plan_cells(spell_kinds(msgspec.structs.replace(self.grid, morph=morph), kinds_of(self.cast))).cells[0]
        pictures = [self._draw(cell) for _, cell in cells]
        return [measure_difference(one, other) for one, other in pairwise(pictures)]

    def _draw(self, cell: RenderRequest) -> Picture:
        name = cell.face[0]
        if name not in self._drawn:
            sheet = lay_out(cell, self.cast).on_paper(cell.setting, "image/png")
            self._drawn[name] = read_png(self.browser.draw(sheet))
        return self._drawn[name]


def _spell(percents: Sequence[float]) -> str:
    """Percents as a morph lists them."""
    return "/".join(f"{percent:.{SHARE_PLACES - 2}f}".rstrip("0").rstrip(".") for percent in percents)


def pictures_folder(path: Path) -> Path:
    """Where the single pictures of a table lie."""
    return path.with_name(f"{path.stem}.pictures")


def former_pictures(run: PictureRun, path: Path) -> list[Path]:
    """The pictures of a former table under this name: Omote drew them, nobody changed them, and this run has others.

    None where another table (`grid.jpg` beside `grid.png`) shares their folder. run: what is to be drawn; path: of its
    table.
    """
    folder = pictures_folder(path)
    own = {file.path for file in run.pictures}
    others = [other for ending in KINDS if (other := path.with_suffix(ending)) != path and other.exists()]
    if others or not folder.is_dir():
        return []
    unlisted = [file for file in sorted(folder.glob("*.png")) if file not in own]
    return [file for file in unlisted if picture_state(file, run.pictures[0].sidecar) in ("former", "drawn")]


def digest_of_pages(pages: Mapping[str, Page]) -> str:
    """The digest of the built pages: what draws a picture in another way has another."""
    digest = hashlib.blake2b(digest_size=12)
    for url, page in sorted(pages.items()):
        if page.immutable or url == "/stage":
            digest.update(url.encode() + b"\0" + page.body)
    return digest.hexdigest()


def draw_run(
    studio: PictureStudio, run: PictureRun, report: Callable[[PictureProgress], None], *, jobs: int = 1
) -> None:
    """Draws what a run is waiting for, in `jobs` browsers at once, and composes its table.

    FileNotFoundError where there is no browser; OSError where a file cannot be written; BrowserError where a browser
    does not draw. What was written before stays. studio: the cast and the pages; run: what is wanted; report: told of
    each picture.
    """
    draw_runs(studio, [run], report, jobs=jobs)


Lose = Callable[[PictureFile, Exception], Container[Path]]


def draw_runs(
    studio: PictureStudio,
    runs: Sequence[PictureRun],
    report: Callable[[PictureProgress], None],
    *,
    jobs: int = 1,
    lose: Lose | None = None,
) -> None:
    """Draws several runs, each in its own setting, one after another in the same browsers; errors as `draw_run`.

    studio: the cast and the pages; runs: what is wanted; report: told of each picture, counted through all runs; jobs:
    browsers at once; lose: told of a picture that is not drawn and why, gives the paths of those that make no sense
    without it; None: the first ends all.
    """
    browser = find_chromium()
    for run in runs:
        if run.table is not None:
            pictures_folder(run.table.path).mkdir(exist_ok=True)
    waiting = max((len(run.waiting) for run in runs), default=0)
    browsers = min(jobs, waiting) or 1  # one composes the table where all its pictures are there
    asyncio.run(_Drawing(studio, runs, report, lose).draw(browser, browsers))


class _Drawing:
    def __init__(
        self,
        studio: PictureStudio,
        runs: Sequence[PictureRun],
        report: Callable[[PictureProgress], None],
        lose: Lose | None,
    ) -> None:
        self._studio = studio
        self._lose = lose
        self._runs = runs
        self._report = report
        self._left: list[PictureFile] = []
        self._total = sum(len(run.pictures) for run in runs)
        self._done = self._total - sum(len(run.waiting) for run in runs)

    async def draw(self, browser: Path, jobs: int) -> None:
        documents = self._studio.documents
        await documents.prepare(self._studio.cast)
        documents.play(self._studio.cast)
        async with serve_pages(documents, self._studio.pages) as address, AsyncExitStack() as open_browsers:
            tools = [await open_browsers.enter_async_context(open_chromium(browser)) for _ in range(jobs)]
            for run in self._runs:
                openings = [partial(open_picture_page, tool, address, run.setting) for tool in tools]
                self._left = list(run.waiting)
                pages = await asyncio.gather(*(self._work(opening) for opening in openings))
                if run.table is not None:
                    await self._compose(pages[0], run, run.table)
                await asyncio.gather(*(page.close() for page in pages))

    async def _work(self, opening: Callable[[], Awaitable[PicturePage]]) -> PicturePage:
        """Draws one picture after the other, as long as there are any; returns its page. opening: opens one."""
        page = await opening()
        while self._left:
            file = self._left.pop(0)
            began = time.monotonic()
            following: Any = self._left[0].sheet.poses[0][0] if self._left else None
            try:
                drawn = await page.draw(file.sheet, following)
            except (ValueError, BrowserError) as error:
                if self._lose is None:
                    raise
                gone = self._lose(file, error)
                self._left = [each for each in self._left if each.path not in gone]
                await page.close()
                page = await opening()  # it may have crashed; a browser that ended opens none, and ends all
                continue
            write_picture(file, *drawn)
            self._done += 1
            self._report(PictureProgress(file.path, time.monotonic() - began, self._done, self._total))
        return page

    async def _compose(self, page: PicturePage, run: PictureRun, table: PictureFile) -> None:
        files = iter(run.pictures)
        pictures = [[next(files).path for _ in row] for row in table.sheet.poses]
        write_picture(table, await page.compose(table.sheet, pictures))


def write_picture(file: PictureFile, data: bytes, clipped: Clipped | None = None) -> None:
    """Writes a picture, then its sidecar, whose hash tells whether it is that of the picture beside it.

    file: where it belongs; data: the image file; clipped: what of it was cut off to match, None for nothing asked.
    """
    write_whole(file.path, data)
    write_whole(sidecar_path(file.path), encode_sidecar(msgspec.structs.replace(file.sidecar, clipped=clipped), data))
