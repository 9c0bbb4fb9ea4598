"""Exports as downloads: the plan of each, and the process that writes it."""

import sys
from collections.abc import Mapping
from pathlib import Path
from types import SimpleNamespace
from typing import cast as typed

import pytest
from aiohttp import web

from omote.model.cast import Cast
from omote.server.http.command_process import COMMAND
from omote.server.http.downloads import Downloads, plan_download
from omote.showfile.changes import content_key
from omote.showfile.contents import pack_expression
from omote.stage_data.playing_cast import Own, PlayingCast, build_playing_cast

SHOW = Path("my.omote")
# Stands for `omote`: writes its own words into the file that -o names.
SCRIBBLE = "import sys; at = sys.argv.index('-o') + 1; open(sys.argv[at], 'w').write(' '.join(sys.argv[1:at - 1]))"
FAILS = "import sys; sys.exit('omote: the cast is missing: run make bake')"


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


def test_each_export_is_a_command(playing: PlayingCast) -> None:
    document = plan_download(SHOW, "crooked_smile.json", {}, playing)
    assert [*document.options, *document.arguments] == ["file", "export", "my.omote", "crooked_smile"]
    worn = plan_download(SHOW, "broad.glb", {"expressions": "crooked_smile,smile"}, playing)
    assert worn.options == ["export", "--expressions", "crooked_smile,smile", "--show", "my.omote"]
    assert (worn.arguments, worn.file) == (["broad"], "broad-crooked_smile-smile.glb")
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


@pytest.mark.parametrize("kind", ["arkit", "performed"])
def test_a_kind_of_expressions_is_asked_for_by_its_name(playing: PlayingCast, kind: str) -> None:
    assert plan_download(SHOW, "broad.glb", {"expressions": kind}, playing).options[2] == kind


@pytest.mark.asyncio
async def test_a_download_is_what_the_command_writes(playing: PlayingCast) -> None:
    answer = await Downloads(lambda: SHOW, (sys.executable, "-c", SCRIBBLE)).respond(
        asked("crooked_smile.json"), playing
    )
    assert answer.body == b"file export"
    assert answer.headers["Content-Disposition"] == 'attachment; filename="crooked_smile.json"'
    assert answer.content_type == "application/json"


@pytest.mark.asyncio
async def test_what_the_command_says_is_the_reason(playing: PlayingCast) -> None:
    with pytest.raises(web.HTTPServiceUnavailable) as refused:
        await Downloads(lambda: SHOW, (sys.executable, "-c", FAILS)).respond(asked("broad.glb"), playing)
    assert refused.value.text == "the cast is missing: run make bake"
    with pytest.raises(web.HTTPNotFound):
        await Downloads(lambda: SHOW).respond(asked("nobody.glb"), playing)


@pytest.mark.asyncio
async def test_the_real_command_writes_a_document(tmp_path: Path, playing: PlayingCast) -> None:
    with pytest.raises(web.HTTPServiceUnavailable) as refused:
        await Downloads(lambda: tmp_path / "none.omote", COMMAND).respond(asked("smile.json"), playing)
    assert "there is no show file" in (refused.value.text or "")
