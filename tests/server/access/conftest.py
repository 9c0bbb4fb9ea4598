"""A show that asks for tokens, behind a real socket."""

from collections.abc import AsyncIterator
from dataclasses import dataclass, field
from pathlib import Path

import pytest_asyncio
from aiohttp import web
from aiohttp.test_utils import TestClient, TestServer

from omote.inputs.microphone.microphone_messages import MICROPHONE_PATH
from omote.inputs.performers.camera_messages import CAMERA_PATH
from omote.inputs.trackers.tracker_protocols import MEDIAPIPE_PATH
from omote.model.cast import Cast
from omote.server.access.access_control import AccessControl
from omote.server.access.people_file import new_person, open_people, people_path
from omote.server.access.security import own_names
from omote.server.links.links import Links
from omote.server.scans.scan_previews import ScanPreviews
from omote.server.scans.scan_routes import ScanRoutes
from omote.show.access.access_role import ACCESS_ROLES, AccessRole
from omote.show.access.people_list import add_person, token_of
from tests.server.conftest import Clock, EditHarness, open_edit_harness

GARBAGE = "x" * 30


@dataclass
class AccessHarness(EditHarness):
    """A show whose people have tokens: one for each role, and those of two who may not enter any more."""

    control: AccessControl = field(kw_only=True)
    wall: Clock = field(kw_only=True)
    tokens: dict[str, str] = field(default_factory=dict)

    def may(self, credential: str) -> AccessRole | None:
        """The role of a credential; None where it lets nobody in."""
        return next((role for role in ACCESS_ROLES if role == credential), None)


async def _hear(_: web.Request) -> web.StreamResponse:
    """As a tracker at a page is heard."""
    return web.Response()


@pytest_asyncio.fixture
async def access_harness(cast: Cast, tmp_path: Path) -> AsyncIterator[AccessHarness]:
    """The harness with a file, an OSC port and a list of people; `wall` is at 1000 seconds."""
    async with open_edit_harness(cast, tmp_path / "show.omote") as opened:
        people = open_people(people_path(tmp_path / "show.omote"))
        wall = Clock(1000.0)
        control = AccessControl(people_path(tmp_path / "show.omote"), people, wall=wall, clock=opened.clock)
        tokens = {str(person.role): token_of(people, person) for person in people.people}
        for name, hours in (("revoked", None), ("expired", 0.1)):
            person = new_person(name, "admin", 0.0, hours)
            tokens[name] = token_of(people, person)
            if hours is not None:
                control.people = add_person(control.people, person)
        tokens |= {"garbage": GARBAGE}
        opened.show.enable_oscquery(9000)
        for path in (MEDIAPIPE_PATH, MICROPHONE_PATH, CAMERA_PATH):
            opened.show.enable_sender(path, _hear, Links())
        assert opened.show.editing is not None
        scans = ScanRoutes(None, opened.show.long_requests, opened.show.editing.add_items, ScanPreviews())
        opened.show.more_routes.append(scans.add_routes)
        opened.show.enable_access(control, b"PEM")
        async with TestClient(TestServer(opened.show.application(own_names()))) as client:
            yield AccessHarness(
                opened.show, client, opened.clock, opened.said, opened.path, control=control, wall=wall, tokens=tokens
            )
