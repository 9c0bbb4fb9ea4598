"""The job of photographs: they are read, fitted and shown, and the face that is taken has their colours."""

from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest
from PIL import Image

from omote.builtin import load_cast, load_identity_modes, load_landmark_table
from omote.edit.protocol.messages import PhotographPreview
from omote.model.fitting.photographs.landmark_table import LANDMARKS
from omote.model.fitting.photographs.photograph import PhotographCamera
from omote.server.workers.file_jobs import Imported, run_file_job
from omote.server.workers.scan_jobs import FACE, FILES, ORIGIN, FitPhotographs, SeenPhotograph, TakeScan
from omote.showfile.contents import unpack_face
from omote.showfile.show_file import open_show
from omote.stage_data.assets import rest_positions
from tools.tracking.picture import turn

CAST = load_cast()
SIDE = 320
GREEN = (60, 150, 70)
SECRET = b"the maker of a camera"


def seen_at(yaw: float, file: str) -> SeenPhotograph:
    """The mean head as a page finds it at a turn of the head."""
    modes = load_identity_modes()
    table = load_landmark_table()
    camera = PhotographCamera(turn("y", yaw), np.array([0.0, 0.0, -0.8]), 450.0, SIDE, SIDE)
    places = table.places(modes.shape_skin(np.zeros(len(modes.moves))))
    points = np.full((LANDMARKS, 3), 0.5)
    points[: len(places), :2] = (camera.project(camera.view(places)) + table.error_at(yaw).mean.reshape(-1, 2)) / SIDE
    return SeenPhotograph(file, f"{file} of Anna", SIDE, SIDE, [tuple(row) for row in points.tolist()])


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """The folder of a preview with two green photographs in it."""
    (tmp_path / FILES).mkdir()
    exif = Image.Exif()
    exif[271] = SECRET.decode()
    for name in ("1.jpg", "2.jpg"):
        Image.new("RGB", (SIDE, SIDE), GREEN).save(tmp_path / FILES / name, exif=exif)
    return tmp_path


def fit(folder: Path, *photographs: SeenPhotograph) -> tuple[PhotographPreview, list[tuple[int, int, str]]]:
    """What a page is shown of the photographs in a folder, and the steps that it was told of."""
    steps: list[tuple[int, int, str]] = []
    job = msgspec.msgpack.encode(FitPhotographs(str(folder), "token", list(photographs)))
    return msgspec.msgpack.decode(run_file_job(job, lambda *step: steps.append(step)), type=PhotographPreview), steps


def rows(data: bytes, kind: str) -> Any:
    return np.frombuffer(data, kind).reshape(-1, 3)


def test_photographs_are_shown_as_a_face_in_their_colours_and_taken_without_what_else_was_in_them(folder: Path) -> None:
    seen, steps = fit(folder, seen_at(0.0, "1.jpg"), seen_at(0.6, "2.jpg"))
    assert [done for done, _, _ in steps] == sorted(done for done, _, _ in steps)
    assert {"photograph 1 is read", "photograph 2 is read", "its colours"} <= {what for _, _, what in steps}
    face, look = unpack_face((folder / FACE).read_bytes(), "Anna")
    assert np.array_equal(rows(seen.face, "<f4"), rest_positions(CAST, face).astype("<f4"))
    assert look.albedo is not None
    positions = rows(seen.positions, "<f4")
    colours = rows(seen.colours, "u1").astype(int)
    assert len(positions) == len(colours) == rows(seen.triangles, "<u4").max() + 1
    assert np.isin(positions.round(7)[:, 0], face.positions.astype("<f4").round(7)[:, 0]).mean() > 0.05
    front = positions[:, 2] > np.quantile(positions[:, 2], 0.7)
    assert (colours[front].argmax(axis=1) == 1).mean() > 0.8, "green where the photographs are"
    shown = np.frombuffer(seen.shown, "u1")
    assert len(shown) == CAST.space.vertex_count
    skin = np.unique(CAST.space.skin_triangles)
    assert seen.seen == pytest.approx((shown[skin] > 0).mean())
    assert 0.2 < seen.seen < 0.95, "the back of the head was not photographed"
    assert len(seen.off) == 2
    assert SECRET not in (folder / FACE).read_bytes()


def test_the_face_of_photographs_is_taken_as_that_of_a_scan_is(folder: Path, tmp_path: Path) -> None:
    seen, _ = fit(folder, seen_at(0.0, "1.jpg"))
    assert any("One photograph" in doubt for doubt in seen.doubts)
    origin = (folder / ORIGIN).read_text()
    assert origin == f"from 1 photograph (1.jpg of Anna); {seen.seen:.0%} of the skin was seen"
    show = tmp_path / "show.omote"
    open_show(show).close()
    job = TakeScan(str(show), str(folder), "Anna", "bob", "#102030", 9.0)
    imported = msgspec.msgpack.decode(run_file_job(msgspec.msgpack.encode(job), lambda *_: None), type=Imported)
    (item,) = imported.items
    _, look = unpack_face(item.content, "anna")
    assert (item.item.label, item.revision.note, look.hair_style, look.hair) == ("Anna", origin, "bob", "#102030")
    assert look.albedo is not None


def test_a_photograph_of_another_size_and_one_that_is_damaged_are_refused_by_their_names(folder: Path) -> None:
    seen = seen_at(0.0, "1.jpg")
    with pytest.raises(ValueError, match=r"1\.jpg of Anna has 320 x 320 pixels, and the page saw 99 x 320"):
        fit(folder, msgspec.structs.replace(seen, width=99))
    (folder / FILES / "1.jpg").write_bytes(b"words")
    with pytest.raises(ValueError, match=r"^1.jpg of Anna: the file is no picture"):
        fit(folder, seen)
    assert not (folder / FACE).exists()
