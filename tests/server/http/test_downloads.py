"""Exports as downloads: the plan of each, and what is answered."""

import asyncio
from collections.abc import Mapping
from pathlib import Path
from types import SimpleNamespace
from typing import cast as typed

import msgspec
import pytest
from aiohttp import web

from omote.model.cast import Cast
from omote.server.http.downloads import Downloads, plan_download
from omote.server.http.long_requests import LongRequests
from omote.server.http.uploads import CANCELLED, RunFileJob
from omote.server.workers.file_jobs import ExportExpression, ExportFace
from omote.server.workers.job_server import Follow, JobError
from omote.showfile.changes import content_key
from omote.showfile.contents import pack_expression
from omote.stage_data.playing_cast import Own, PlayingCast, build_playing_cast

SHOW = Path("my.omote")


async def write_job(job: bytes, _: Follow) -> bytes:
    """Stands for `run_file_job` in its process: what it is asked for."""
    return job


async def fail_job(_: bytes, __: Follow) -> bytes:
    """A job that cannot be done."""
    raise JobError("the cast is missing: run make bake")


def downloads(run: RunFileJob) -> Downloads:
    """Downloads that are made so."""
    return Downloads(lambda: SHOW, run, LongRequests(lambda _: None))


@pytest.fixture
def playing(cast: Cast) -> PlayingCast:
    """The synthetic cast with an own expression."""
    data = pack_expression(cast.expressions["smile"])
    key = content_key(data)
    own = Own("expression", "crooked_smile", "Crooked smile", (), 0.0, key)
    return build_playing_cast(cast, (own,), {key: data})


def asked(file: str, query: Mapping[str, str] | None = None) -> web.Request:
    """A request for an export."""
    return typed(web.Request, SimpleNamespace(match_info={"file": file}, query=query or {}))


def test_each_export_is_a_job(playing: PlayingCast) -> None:
    document = plan_download(SHOW, "crooked_smile.json", {}, playing)
    assert document.job == ExportExpression("my.omote", "crooked_smile")
    worn = plan_download(SHOW, "broad.glb", {"expressions": "crooked_smile,smile"}, playing)
    assert worn.job == ExportFace("my.omote", "broad", "crooked_smile,smile")
    assert worn.file == "broad-crooked_smile-smile.glb"
    assert plan_download(SHOW, "broad.glb", {}, playing).file == "broad.glb"


@pytest.mark.parametrize(
    ("file", "query", "named"),
    [
        ("nobody.glb", {}, "no face 'nobody'"),
        ("grin.json", {}, "no expression 'grin' in this show; save it first"),
        ("broad.glb", {"expressions": "grin"}, "no expression 'grin'"),
        ("--help.glb", {}, "no face '--help'"),
        ("../round.glb", {}, "no face"),
        ("round.exe", {}, "is no export"),
        ("round", {}, "is no export"),
    ],
)
def test_what_does_not_play_is_refused(playing: PlayingCast, file: str, query: dict[str, str], named: str) -> None:
    with pytest.raises(ValueError, match=named):
        plan_download(SHOW, file, query, playing)


def test_a_face_goes_out_as_an_avatar_and_for_other_programs(playing: PlayingCast) -> None:
    wanted = {"author": "Ann, Ben,", "licence": "strict"}
    avatar = plan_download(SHOW, "broad.vrm", wanted, playing)
    assert avatar.job == ExportFace("my.omote", "broad", "arkit", ".vrm", ("Ann", "Ben"), "strict")
    assert (avatar.file, avatar.content_type) == ("broad.vrm", "model/gltf-binary")
    usd = plan_download(SHOW, "broad.usdz", {}, playing)
    assert (usd.job, usd.file) == (ExportFace("my.omote", "broad", "arkit", ".usdz"), "broad.usdz")
    plain = plan_download(SHOW, "broad.obj", {"expressions": "neutral"}, playing)
    assert plain.job == ExportFace("my.omote", "broad", "neutral", ".obj")
    assert (plain.file, plain.content_type) == ("broad-neutral.zip", "application/zip")


@pytest.mark.parametrize("kind", ["arkit", "performed"])
def test_a_kind_of_expressions_is_asked_for_by_its_name(playing: PlayingCast, kind: str) -> None:
    assert plan_download(SHOW, "broad.glb", {"expressions": kind}, playing).job == ExportFace("my.omote", "broad", kind)


@pytest.mark.asyncio
async def test_a_download_is_what_the_job_makes(playing: PlayingCast) -> None:
    answer = await downloads(write_job).respond(asked("crooked_smile.json"), playing)
    assert answer.body == msgspec.msgpack.encode(ExportExpression("my.omote", "crooked_smile"))
    assert answer.headers["Content-Disposition"] == 'attachment; filename="crooked_smile.json"'
    assert answer.content_type == "application/json"


@pytest.mark.asyncio
async def test_what_the_job_says_is_the_reason(playing: PlayingCast) -> None:
    with pytest.raises(web.HTTPServiceUnavailable) as refused:
        await downloads(fail_job).respond(asked("broad.glb"), playing)
    assert refused.value.text == "the cast is missing: run make bake"
    with pytest.raises(web.HTTPNotFound):
        await downloads(write_job).respond(asked("nobody.glb"), playing)


@pytest.mark.asyncio
async def test_a_page_ends_its_export_and_the_next_is_made(playing: PlayingCast) -> None:
    begun = asyncio.Event()

    async def run(job: bytes, _: Follow) -> bytes:
        if begun.is_set():
            return job
        begun.set()
        await asyncio.Event().wait()
        return b""

    requests = LongRequests(lambda _: None)
    exports = Downloads(lambda: SHOW, run, requests)
    ended = asyncio.create_task(exports.respond(asked("broad.glb", {"request": "mine"}), playing))
    await begun.wait()
    requests.cancel("mine")
    assert (await ended).status == CANCELLED
    assert (await exports.respond(asked("broad.glb"), playing)).status == 200
