"""Jobs of scans: what is read is found, fitted and shown; what cannot be is asked about; what was fitted is taken."""

import json
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest

from omote.builtin import load_cast, own_face
from omote.edit.protocol.messages import ScanDoubt, ScanPreview
from omote.interchange.scan_face import FIRST_HAIR
from omote.interchange.scans.scan_reader import ScanFile
from omote.model.fitting.doubt import PLACE as ABOUT_PLACE
from omote.model.fitting.doubt import Doubt
from omote.model.fitting.find_head import HeadPlacement
from omote.model.fitting.fit_face import Fit
from omote.model.fitting.landmarks import SEVEN, find_landmarks
from omote.model.fitting.scan import Scan
from omote.model.space.similarity import Similarity
from omote.server.sandbox import scan_faces
from omote.server.sandbox.scan_files import read_scan_in_sandbox
from omote.server.workers import scan_jobs
from omote.server.workers.file_jobs import Imported, run_file_job
from omote.server.workers.scan_jobs import FACE, FILES, ORIGIN, FitScan, TakeScan
from omote.showfile.contents import unpack_face
from omote.showfile.show_file import open_show
from omote.stage_data.assets import rest_positions

CAST = load_cast()
TURN = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
"""From a scan that lies on its back: z is up."""
PLACE = Similarity(0.01, TURN, np.array([0.0, 0.1, 0.0]))


def scan_of(name: str) -> Scan:
    """A face of the cast as another program has it: centimetres, z up."""
    points = (CAST.faces[name].positions.astype(np.float64) - PLACE.shift) @ TURN / PLACE.scale
    return Scan(points, CAST.space.triangles)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """The folder of a preview with a scan in it."""
    scan = scan_of("man")
    assert scan.triangles is not None
    lines = [f"v {x} {y} {z}" for x, y, z in scan.positions] + [f"f {a} {b} {c}" for a, b, c in scan.triangles + 1]
    (tmp_path / FILES).mkdir()
    (tmp_path / FILES / "anna.obj").write_text("\n".join(lines))
    return tmp_path


class FalseFit:
    """Stands for the search and the fit: writes down what it was asked, for both happen in a child, and says that the
    man is found without fail."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.log = folder / "asked"
        self.log.touch()
        self.failure = ""
        monkeypatch.setattr(own_face, "find_head", self.find)
        monkeypatch.setattr(own_face, "fit_kinds", self.fit)

    def write(self, *asked: object) -> None:
        with self.log.open("a") as file:
            file.write(json.dumps(asked) + "\n")

    @property
    def asked(self) -> list[list[Any]]:
        """What was asked, "find" with landmarks, and "fit" with landmarks and whether the eyes are shut."""
        return [json.loads(line) for line in self.log.read_text().splitlines()]

    def find(self, _: object, __: object, scan: Scan, *, landmarks: Mapping[str, Any] | None) -> HeadPlacement:
        self.write("find", landmarks)
        if self.failure == "nothing":
            raise ValueError("nothing in the scan could be a face")
        rows = find_landmarks(CAST.space)
        marks = {name: scan.positions[rows[name]] for name in SEVEN}
        marks |= {name: np.array(point) for name, point in (landmarks or {}).items()}
        return HeadPlacement(
            PLACE, np.ones(len(scan.positions), bool), 1.0, "centimetres", marks, (Doubt("Look here.", ABOUT_PLACE),)
        )

    def fit(self, _: object, __: object, ___: Scan, place: HeadPlacement, /, **given: Any) -> Fit:
        self.write("fit", given["landmarks"], given["shut"])
        given["follow"](0.5, "the skin")
        if self.failure == "fit":
            raise ValueError("the skin stays folded")
        if self.failure == "limits":
            np.ones(2 * scan_faces.LIMITS.memory // 8)
        face = CAST.faces["man"]
        residual = np.full(len(face.positions), 0.1)
        residual[find_landmarks(CAST.space)["nose_tip"]] = np.nan
        return Fit(face, residual, np.isfinite(residual).astype(float), place.similarity, (Doubt("And there."),))


@pytest.fixture
def false_fit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> FalseFit:
    """No search and no fit, which take seconds and have tests of their own."""
    return FalseFit(tmp_path, monkeypatch)


def fit(folder: Path, **given: Any) -> tuple[ScanPreview, list[tuple[int, int, str]]]:
    """What a page is shown of the scan in a folder, and the steps that it was told of."""
    steps: list[tuple[int, int, str]] = []
    job = FitScan(str(folder), "anna.obj", "token", **given)
    made = run_file_job(msgspec.msgpack.encode(job), lambda *step: steps.append(step))
    return msgspec.msgpack.decode(made, type=ScanPreview), steps


def test_scan_and_face_are_shown_in_one_frame_with_figures_and_doubts(folder: Path, false_fit: FalseFit) -> None:
    seen, steps = fit(folder)
    positions = np.frombuffer(seen.positions, "<f4").reshape(-1, 3)
    face = CAST.faces["man"]
    assert np.allclose(positions, face.positions, atol=1e-6)
    assert seen.face is not None
    assert np.array_equal(np.frombuffer(seen.face, "<f4").reshape(-1, 3), rest_positions(CAST, face).astype("<f4"))
    assert seen.residual is not None
    assert np.isnan(np.frombuffer(seen.residual, "<f4")).sum() == 1
    assert seen.figures is not None
    assert (seen.figures.median, seen.figures.p95) == pytest.approx((0.1, 0.1))
    assert 0.9 < seen.figures.seen < 1.0
    assert (seen.token, seen.file) == ("token", "anna.obj")
    assert seen.doubts == [ScanDoubt("place", "Look here."), ScanDoubt("shape", "And there.")]
    assert seen.unit == "centimetres, z up, facing -y"
    place = Similarity(seen.placement[0], np.reshape(seen.placement[1:10], (3, 3)), np.array(seen.placement[10:]))
    nose = find_landmarks(CAST.space)["nose_tip"]
    assert np.allclose(place(np.array([seen.found["nose_tip"]])), face.positions[nose], atol=1e-6)
    assert [done for done, _, _ in steps] == sorted(done for done, _, _ in steps)
    assert {total for _, total, _ in steps} == {100}


def test_few_points_guide_the_fit_and_enough_of_them_the_search_too(folder: Path, false_fit: FalseFit) -> None:
    given = {name: tuple(place) for name, place in zip(SEVEN, scan_of("man").positions[:7].tolist(), strict=True)}
    one = {"nose_tip": given["nose_tip"]}
    for points in (one, given):
        seen, _ = fit(folder, points=points, shut=True)
        assert {name: tuple(place) for name, place in seen.given.items()} == points
        assert seen.shut is True
    as_sent = json.loads(json.dumps([one, given]))
    assert false_fit.asked == [
        ["find", None], ["fit", as_sent[0], True], ["find", as_sent[1]], ["fit", as_sent[1], True],
    ]  # fmt: skip
    with pytest.raises(ValueError, match="there is no point 'chin'"):
        fit(folder, points={"chin": (0.0, 0.0, 0.0)})


@pytest.mark.parametrize("failure", ["nothing", "fit"])
def test_what_cannot_be_found_or_fitted_is_shown_and_asked_about(
    folder: Path, false_fit: FalseFit, failure: str
) -> None:
    fit(folder)
    assert (folder / FACE).exists()
    false_fit.failure = failure
    seen, _ = fit(folder)
    assert (seen.face, seen.residual, seen.figures) == (None, None, None)
    said = "Look here." if failure == "fit" else "nothing in the scan could be a face."
    assert seen.doubts == [ScanDoubt("place", said)]
    assert seen.found == {}, "what was sought and not found is nowhere"
    positions = np.frombuffer(seen.positions, "<f4").reshape(-1, 3)
    size = np.ptp(positions, axis=0).max()
    head = np.ptp(CAST.space.points[:, 1])
    assert 0.8 < size / head < 1.3, "as large as a head"
    assert not (folder / FACE).exists(), "what was fitted before is no face of what is shown"
    with pytest.raises(ValueError, match="no face has been fitted"):
        take(folder)


def test_a_fit_that_takes_too_much_is_ended(folder: Path, false_fit: FalseFit, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(scan_faces, "LIMITS", replace(scan_faces.LIMITS, memory=2**28))
    false_fit.failure = "limits"
    with pytest.raises(ValueError, match="needs more time or memory than any head"):
        fit(folder)


def take(folder: Path, **given: str) -> Imported:
    """What is taken of the face fitted in a folder."""
    show = folder / "show.omote"
    open_show(show).close()
    asked = {"label": "Anna", "hair_style": "bob", "hair": "#112233"} | given
    job = TakeScan(str(show), str(folder), asked["label"], asked["hair_style"], asked["hair"], 5.0)
    return msgspec.msgpack.decode(run_file_job(msgspec.msgpack.encode(job), lambda *_: None), type=Imported)


def test_what_was_fitted_is_taken_with_its_hair_and_keeps_where_it_came_from(folder: Path, false_fit: FalseFit) -> None:
    fit(folder, points={"nose_tip": (0.0, 1.0, 2.0)})
    (item,) = take(folder).items
    face, look = unpack_face(item.content, "anna")
    assert np.array_equal(face.positions, CAST.faces["man"].positions)
    assert (look.hair_style, look.hair) == ("bob", "#112233")
    assert (item.item.kind, item.item.label, item.revision.written) == ("face", "Anna", 5.0)
    assert item.revision.note == (folder / ORIGIN).read_text()
    assert item.revision.note.startswith("from anna.obj (centimetres, z up, facing -y), 1 point given; ")
    assert "within 0.10 mm" in item.revision.note


@pytest.mark.parametrize(
    ("given", "why"),
    [
        ({"hair_style": "beehive"}, "there is no hair 'beehive'"),
        ({"hair": "red"}, "expected a colour"),
        ({"label": ""}, "a face is named"),
    ],
)
def test_a_face_is_taken_with_what_there_is_alone(
    folder: Path, false_fit: FalseFit, given: dict[str, str], why: str
) -> None:
    fit(folder)
    with pytest.raises(ValueError, match=why):
        take(folder, **given)


RED = (180, 30, 40)


def coloured(folder: Path) -> None:
    """Gives the scan in a folder a colour: all of it is red, the hair too."""
    scan = scan_of("man")
    assert scan.triangles is not None
    points = "".join(f"{x} {y} {z} {RED[0]} {RED[1]} {RED[2]}\n" for x, y, z in scan.positions)
    triangles = "".join(f"3 {a} {b} {c}\n" for a, b, c in scan.triangles)
    head = f"ply\nformat ascii 1.0\nelement vertex {len(scan.positions)}\n"
    head += "".join(f"property float {axis}\n" for axis in "xyz")
    head += "".join(f"property uchar {colour}\n" for colour in ("red", "green", "blue"))
    head += f"element face {len(scan.triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
    (folder / FILES / "anna.obj").write_text(head + points + triangles)  # what it is, its bytes say


@pytest.mark.usefixtures("false_fit")
def test_a_scan_with_shapes_says_that_its_face_takes_none(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def with_shapes(path: Path) -> ScanFile:
        found = read_scan_in_sandbox(path)
        shapes = dict.fromkeys(("smile", "frown"), np.zeros_like(found.scan.positions))
        return replace(found, scan=replace(found.scan, shapes=shapes))

    monkeypatch.setattr(scan_jobs, "read_scan_in_sandbox", with_shapes)
    seen, _ = fit(folder)
    assert seen.notes == ["it brings 2 shapes of its own: import it as expressions, too, and all faces wear them"]


@pytest.mark.usefixtures("false_fit")
def test_a_scan_with_colours_puts_them_on_the_skin_and_one_without_hair_proposes_none(folder: Path) -> None:
    plain, _ = fit(folder)
    assert (plain.hair_style, plain.colours) == (FIRST_HAIR, b"")
    coloured(folder)
    seen, _ = fit(folder)
    assert np.array_equal(np.unique(np.frombuffer(seen.colours, "u1").reshape(-1, 3), axis=0), [RED])
    assert (seen.hair_style, seen.notes) == ("", [])
    _, look = unpack_face((folder / FACE).read_bytes(), "anna")
    assert look.albedo is not None
    covered = look.albedo.pixels[look.albedo.pixels[..., 3] == 255][:, :3].astype(int)
    assert np.abs(np.median(covered, axis=0) - RED).max() <= 3
    (item,) = take(folder, hair_style="").items
    _, worn = unpack_face(item.content, "anna")
    assert worn.albedo is not None
    assert np.array_equal(worn.albedo.pixels, look.albedo.pixels)
    assert worn.scalp == 0.0, "no shade of hair is painted on a bald head"


def test_a_file_that_is_no_scan_is_refused_by_its_name(folder: Path) -> None:
    (folder / FILES / "anna.obj").write_bytes(b"words")
    with pytest.raises(ValueError, match=r"anna\.obj: "):
        fit(folder)
