"""A show to which scans can be brought, with a job that tests control."""

import asyncio
from collections.abc import AsyncIterator
from dataclasses import dataclass, field
from pathlib import Path

import aiohttp
import msgspec
import pytest_asyncio
from aiohttp.test_utils import TestClient, TestServer

from omote.edit.protocol.messages import PhotographPreview, ScanPreview
from omote.edit.store.import_items import ImportedItem, changes_to_import
from omote.model.cast import Cast
from omote.server.access.security import own_names
from omote.server.scans.scan_previews import ScanPreviews
from omote.server.scans.scan_routes import ScanRoutes
from omote.server.workers.file_jobs import Imported, bring_items, run_file_job
from omote.server.workers.job_server import Follow, JobError
from omote.server.workers.scan_jobs import FILES, FitPhotographs, FitScan, ShowPhotograph, TakeScan
from omote.showfile.changes import Stored
from omote.showfile.show_file import open_show
from tests.server.conftest import EditHarness, open_edit_harness

Job = FitScan | FitPhotographs | ShowPhotograph | TakeScan
_job: msgspec.msgpack.Decoder[Job] = msgspec.msgpack.Decoder(Job)


@dataclass
class FalseJobs:
    """Stands for `run_file_job` in its process: a fit says what it was asked, a face is one of the cast's."""

    cast: Cast
    asked: list[Job] = field(default_factory=list)
    face: str = "broad"

    async def __call__(self, job: bytes, follow: Follow) -> bytes:
        wanted = _job.decode(job)
        self.asked.append(wanted)
        if isinstance(wanted, TakeScan):
            return self._take(wanted)
        if isinstance(wanted, ShowPhotograph):
            return run_file_job(job, follow)
        if isinstance(wanted, FitPhotographs):
            follow(20, 100, "shape and cameras")
            return msgspec.msgpack.encode(
                PhotographPreview(wanted.token, [], [0.5], 4.0, 0.7, b"", b"", b"", b"", b"", "", "#000000")
            )
        data = (Path(wanted.folder) / FILES / wanted.file).read_bytes()
        follow(50, 100, "the head is sought")
        if data == b"words":
            raise JobError(f"{wanted.file} is no scan.")
        if data == b"endless":
            await asyncio.Event().wait()
        given = {name: list(point) for name, point in wanted.points.items()}
        preview = ScanPreview(
            wanted.token, wanted.file, [1.0] * 13, "metres", [], [], given, {}, b"", b"", b"", shut=wanted.shut
        )
        return msgspec.msgpack.encode(preview)

    def _take(self, wanted: TakeScan) -> bytes:
        arrival = ImportedItem(wanted.label, (self.cast.faces[self.face], self.cast.looks[self.face]), note="a scan")
        stored = stored_in(Path(wanted.show))
        changes = changes_to_import(self.cast, stored, [arrival], wall=wanted.wall)
        return msgspec.msgpack.encode(Imported(list(bring_items(changes)), ["from a scan"]))


@dataclass
class ScanHarness(EditHarness):
    """A show to which scans can be brought."""

    jobs: FalseJobs = field(kw_only=True)
    previews: ScanPreviews = field(kw_only=True)

    async def bring(self, files: dict[str, bytes], query: str = "", path: str = "/scans") -> tuple[int, bytes]:
        """What the show answers to files of a form."""
        form = aiohttp.FormData(quote_fields=False)  # as browsers write names
        for name, data in files.items():
            form.add_field("file", data, filename=name)
        async with self.client.post(f"{path}{query}", data=form) as response:
            return response.status, await response.read()

    async def preview(self, data: bytes = b"scan") -> ScanPreview:
        """What comes of a scan that can be read."""
        status, body = await self.bring({"anna.ply": data})
        assert status == 200
        return msgspec.msgpack.decode(body, type=ScanPreview)

    async def post(self, path: str, body: object) -> tuple[int, str]:
        """What the show answers to a document."""
        async with self.client.post(path, data=msgspec.json.encode(body)) as response:
            return response.status, (await response.read()).decode(errors="replace")

    def folders(self) -> list[Path]:
        """The folders of the scans that are kept."""
        return [preview.folder for preview in self.previews._previews.values()]


def stored_in(path: Path) -> Stored:
    """What a show file holds."""
    file = open_show(path)
    try:
        return file.stored()
    finally:
        file.close()


@pytest_asyncio.fixture
async def scan_harness(cast: Cast, tmp_path: Path) -> AsyncIterator[ScanHarness]:
    """A house to which scans can be brought."""
    async with open_edit_harness(cast, tmp_path / "show.omote") as opened:
        assert opened.show.editing is not None
        jobs = FalseJobs(cast)
        previews = ScanPreviews()
        work = (lambda: opened.path, jobs)
        routes = ScanRoutes(work, opened.show.long_requests, opened.show.editing.add_items, previews)
        opened.show.more_routes.append(routes.add_routes)
        async with TestClient(TestServer(opened.show.application(own_names()))) as client:
            yield ScanHarness(opened.show, client, opened.clock, opened.said, opened.path, jobs=jobs, previews=previews)
        previews.close()
