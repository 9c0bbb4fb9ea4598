"""Scans from pages: looked at, fitted by points, taken as faces, and thrown away for good."""

import asyncio
import io
import json

import aiohttp
import msgspec
import numpy as np
import pytest
from aiohttp.test_utils import TestClient, TestServer

from omote.edit.protocol.messages import PhotographPreview, ScanPreview
from omote.interchange.scans.picture_reader import read_picture, write_plain
from omote.model.cast import Cast
from omote.server.access.security import own_names
from omote.server.http.uploads import CANCELLED
from omote.server.scans.scan_previews import ScanPreviews
from omote.server.scans.scan_routes import ScanRoutes
from omote.server.scans.scan_upload import LARGEST_POINTS, POINTS_FILE
from omote.server.workers.scan_jobs import FILES, FitPhotographs, FitScan, TakeScan
from omote.show.declaration import MESSAGE_LIMIT
from omote.show.objects.link import Cancel, Progress
from omote.show.wire import encode
from omote.showfile.contents import unpack_face
from tests.interchange.scans import scan_samples as samples
from tests.server.conftest import open_edit_harness
from tests.server.scans.conftest import ScanHarness, stored_in
from tests.server.scans.test_photograph_upload import described

pytestmark = pytest.mark.asyncio

TAKING = {"label": "Anna", "hair_style": "", "hair": "#000000", "replaced": None}
NOSE = [1.0, 2.5, -3.0]


async def test_a_scan_comes_with_what_lies_beside_it_and_is_kept_until_it_is_taken(scan_harness: ScanHarness) -> None:
    files = {"../anna.obj": b"scan", "anna.mtl": b"material", "C:\\pictures\\skin.png": b"picture"}
    status, body = await scan_harness.bring(files)
    seen = msgspec.msgpack.decode(body, type=ScanPreview)
    assert (status, seen.file) == (200, "anna.obj")
    (folder,) = scan_harness.folders()
    kept = {path.name: path.read_bytes() for path in (folder / FILES).iterdir()}
    assert kept == {"anna.obj": b"scan", "anna.mtl": b"material", "skin.png": b"picture"}
    assert folder.stat().st_mode & 0o077 == 0, "nobody else on this machine reads it"
    status, text = await scan_harness.post(f"/scans/{seen.token}/face", TAKING)
    assert (status, json.loads(text)["items"]) == (
        200, [{"kind": "face", "name": "anna", "label": "Anna", "known": False}],
    )  # fmt: skip
    assert not folder.exists()
    assert [(item.label, item.head) for item in stored_in(scan_harness.path).items] == [("Anna", 1)]
    assert scan_harness.show.documents.playing.own[0].name == "anna", "it plays"


async def test_points_and_shut_eyes_go_to_the_next_fit_of_the_same_scan(scan_harness: ScanHarness) -> None:
    seen = await scan_harness.preview()
    status, _ = await scan_harness.post(f"/scans/{seen.token}", {"points": {"nose_tip": NOSE}, "shut": True})
    first, second = scan_harness.jobs.asked
    assert isinstance(first, FitScan)
    assert isinstance(second, FitScan)
    assert status == 200
    assert (first.points, first.shut) == ({}, None)
    assert (second.points, second.shut) == ({"nose_tip": tuple(NOSE)}, True)
    assert (second.folder, second.token, second.file) == (first.folder, seen.token, "anna.ply")


async def test_the_same_scan_under_two_names_is_two_faces(scan_harness: ScanHarness) -> None:
    for label in ("Anna", "Bo"):
        token = (await scan_harness.preview()).token
        status, text = await scan_harness.post(f"/scans/{token}/face", {**TAKING, "label": label})
        assert (status, json.loads(text)["items"][0]["label"]) == (200, label)
    assert [item.label for item in stored_in(scan_harness.path).items] == ["Anna", "Bo"]
    assert [own.name for own in scan_harness.show.documents.playing.own] == ["anna", "bo"]


async def test_a_better_scan_replaces_a_face_that_keeps_its_name(scan_harness: ScanHarness, cast: Cast) -> None:
    await scan_harness.post(f"/scans/{(await scan_harness.preview()).token}/face", TAKING)
    scan_harness.jobs.face = "long"
    number = stored_in(scan_harness.path).items[0].id
    token = (await scan_harness.preview()).token
    status, text = await scan_harness.post(f"/scans/{token}/face", {**TAKING, "label": "Other", "replaced": number})
    assert (status, json.loads(text)["items"][0]["label"]) == (200, "Anna")
    stored = stored_in(scan_harness.path)
    (item,) = stored.items
    assert (item.id, item.name, item.label, item.head) == (number, "anna", "Anna", 2)
    assert [(each.number, each.parent, each.note) for each in stored.revisions] == [
        (1, 0, "a scan"),
        (2, 1, "a scan"),
    ]
    contents = scan_harness.show.documents.contents
    face, _ = unpack_face(contents[stored.revisions[1].content], "anna")
    assert (face.positions == cast.faces["long"].positions).all()
    token = (await scan_harness.preview()).token
    status, text = await scan_harness.post(f"/scans/{token}/face", {**TAKING, "replaced": number + 1})
    assert (status, "there is no face" in text) == (503, True)
    assert len(stored_in(scan_harness.path).revisions) == 2
    assert len(scan_harness.folders()) == 1, "what was not taken can still be"


async def test_a_scan_that_is_thrown_away_is_gone_from_the_disk(scan_harness: ScanHarness) -> None:
    seen = await scan_harness.preview()
    (folder,) = scan_harness.folders()
    for _ in range(2):  # a page that closes may say it twice
        async with scan_harness.client.delete(f"/scans/{seen.token}") as response:
            assert response.status == 204
    assert not folder.exists()
    for path, body in ((f"/scans/{seen.token}", {"points": {}}), (f"/scans/{seen.token}/face", TAKING)):
        status, text = await scan_harness.post(path, body)
        assert (status, "was thrown away" in text) == (400, True)


@pytest.mark.parametrize(
    ("files", "why"),
    [
        ({"anna.ply": b"words"}, "anna.ply is no scan."),
        ({"anna.fbx": b"x"}, "no scan that is read here"),
        ({"anna.mtl": b"x"}, "came without a scan"),
        ({"anna.ply": b"x", "bert.ply": b"x"}, "two scans"),
        ({}, "came without a scan"),
    ],
)
async def test_what_cannot_be_read_is_refused_in_a_sentence_and_leaves_nothing(
    scan_harness: ScanHarness, files: dict[str, bytes], why: str
) -> None:
    if files:
        status, body = await scan_harness.bring(files)
    else:
        with aiohttp.MultipartWriter("form-data") as writer:
            async with scan_harness.client.post("/scans", data=writer) as response:
                status = response.status
                body = await response.read()
    assert (status, why in body.decode()) == (400, True)
    assert scan_harness.folders() == []


@pytest.mark.parametrize("body", [b"", b"{}", b'{"points": {"nose_tip": [1, 2]}}', b'{"points": 3}'])
async def test_what_is_no_document_is_refused_and_the_scan_stays(scan_harness: ScanHarness, body: bytes) -> None:
    seen = await scan_harness.preview()
    async with scan_harness.client.post(f"/scans/{seen.token}", data=body) as response:
        assert response.status == 400
    async with scan_harness.client.post("/scans", data=b"no form") as response:
        assert response.status == 400
    assert len(scan_harness.folders()) == 1


async def test_a_fit_tells_its_progress_and_its_page_ends_it(scan_harness: ScanHarness) -> None:
    editor = await scan_harness.editor()
    sent = asyncio.create_task(scan_harness.bring({"anna.ply": b"endless"}, "?request=mine"))
    while await editor.next(Progress) != Progress("mine", 50, 100, "the head is sought"):
        pass
    (folder,) = scan_harness.folders()
    waiting = asyncio.create_task(scan_harness.bring({"bert.ply": b"scan"}, "?request=next"))
    sentence = "it waits until another scan is fitted"
    while await editor.next(Progress) != Progress("next", 0, 0, sentence):
        pass
    await editor.socket.send_bytes(encode(Cancel("mine")))
    assert await sent == (CANCELLED, b"")
    assert not folder.exists()
    assert (await waiting)[0] == 200


async def test_only_our_own_pages_may_bring_scans(scan_harness: ScanHarness) -> None:
    headers = {aiohttp.hdrs.ORIGIN: "http://elsewhere.example"}
    async with scan_harness.client.post("/scans", data=b"", headers=headers) as response:
        assert response.status == 403


async def test_what_is_asked_for_is_what_the_job_takes(scan_harness: ScanHarness) -> None:
    seen = await scan_harness.preview()
    await scan_harness.post(f"/scans/{seen.token}/face", {"label": "B", "hair_style": "bob", "hair": "#112233"})
    taken = scan_harness.jobs.asked[-1]
    assert isinstance(taken, TakeScan)
    assert (taken.label, taken.hair_style, taken.hair, taken.show) == ("B", "bob", "#112233", str(scan_harness.path))


async def test_without_a_show_file_nothing_is_read(cast: Cast) -> None:
    async with open_edit_harness(cast, None) as opened:
        assert opened.show.editing is not None
        routes = ScanRoutes(None, opened.show.long_requests, opened.show.editing.add_items, ScanPreviews())
        opened.show.more_routes.append(routes.add_routes)
        server = TestServer(opened.show.application(own_names()))
        async with TestClient(server) as client, client.post("/scans", data=b"") as response:
            assert (response.status, "no show file that can be written" in await response.text()) == (503, True)


async def test_photographs_are_fitted_again_by_moved_points_and_taken_as_scans_are(scan_harness: ScanHarness) -> None:
    said = [described("1.jpg"), described("2.jpg")]
    files = {"1.jpg": b"one", "2.jpg": b"two", POINTS_FILE: msgspec.json.encode(said)}
    status, body = await scan_harness.bring(files, path="/photographs")
    assert status == 200
    seen = msgspec.msgpack.decode(body, type=PhotographPreview)
    (folder,) = scan_harness.folders()
    assert (folder / FILES / "2.jpg").read_bytes() == b"two"
    said[1]["points"] = [[0.25, 0.5, 0.125]] * len(said[1]["points"])
    status, _ = await scan_harness.post(f"/photographs/{seen.token}", said)
    first, second = scan_harness.jobs.asked
    assert isinstance(first, FitPhotographs)
    assert isinstance(second, FitPhotographs)
    assert status == 200
    assert [each.file for each in first.photographs] == ["1.jpg", "2.jpg"]
    assert second.photographs[0] == first.photographs[0]
    assert second.photographs[1].points[0] == (0.25, 0.5, 0.125)
    status, _ = await scan_harness.post(f"/scans/{seen.token}/face", TAKING)
    assert status == 200
    assert not folder.exists()
    assert [item.label for item in stored_in(scan_harness.path).items] == ["Anna"]


async def test_photographs_that_cannot_be_fitted_are_refused_and_leave_nothing(scan_harness: ScanHarness) -> None:
    for files, why in (
        ({"1.jpg": b"one"}, "without their landmarks"),
        ({POINTS_FILE: msgspec.json.encode([described()])}, "did not come as JPEG or PNG"),
    ):
        status, body = await scan_harness.bring(files, path="/photographs")
        assert (status, why in body.decode()) == (400, True)
    assert scan_harness.folders() == []
    status, text = await scan_harness.post("/photographs/gone", [described()])
    assert (status, "was thrown away" in text) == (400, True)


async def test_landmarks_have_room_for_eight_photographs_and_no_more(scan_harness: ScanHarness) -> None:
    said = [described(f"{number}.jpg") for number in range(8)]
    exact = [[1 / 3, 2 / 3, -1 / 7]] * len(said[0]["points"])
    long = msgspec.json.encode([{**each, "points": exact} for each in said])
    assert MESSAGE_LIMIT < len(long) < LARGEST_POINTS
    files = {each["file"]: b"x" for each in said} | {POINTS_FILE: long}
    _, body = await scan_harness.bring(files, path="/photographs")
    token = msgspec.msgpack.decode(body, type=PhotographPreview).token
    for data, wanted in ((long, 200), (long + b" " * LARGEST_POINTS, 400)):
        async with scan_harness.client.post(f"/photographs/{token}", data=io.BytesIO(data)) as response:
            assert response.status == wanted


async def test_a_photograph_that_browsers_do_not_decode_comes_back_as_one_that_they_do(
    scan_harness: ScanHarness,
) -> None:
    status, body = await scan_harness.bring({"Anna.HEIC": samples.HEIC}, path="/photographs/picture")
    assert status == 200
    assert body.startswith(b"\xff\xd8\xff")
    np.testing.assert_array_equal(read_picture(body), read_picture(write_plain(read_picture(samples.HEIC), 4096)))
    assert (await scan_harness.bring({"a.heic": samples.HEIC[:300]}, path="/photographs/picture"))[0] == 400
    assert not scan_harness.folders()
