"""The web's code: direction of imports, short modules. Biome checks cycles and bodies, `test_folders.py` sizes."""

import json
import re
from pathlib import Path, PurePosixPath

import pytest

ROOT = Path(__file__).parent.parent
WEB = ROOT / "web"
SOURCE = WEB / "src"

SHORT_MODULE = 30
# Modules below that length with one importer and no test of their own, and why they stand apart.
LONELY_MODULES: dict[str, str] = {"microphone/capture_worklet": "the browser loads it as a file of its own"}

# Where the browser begins: pages, and workers, which their pages name by a URL.
PAGES_AND_WORKERS = {"main", "landmark_worker", "hand_worker", "body_worker", "photograph_worker"}

# Which folders each folder imports from, lowest first. A page imports from no other page, `face` and `ui` nothing from
# each other.
USED: dict[str, str] = {
    "link": "",
    "face_mesh": "",
    "hands": "face_mesh",
    "body": "face_mesh",
    "webcam": "",
    "ui": "link",
    "access": "link ui",
    "face/pose": "link",
    "face/quality": "link",
    "face/anatomy": "link",
    "face/gpu": "",
    "face/blend": "link face/pose face/anatomy face/gpu",
    "face/light": "link face/gpu",
    "face/skin": "link face/gpu face/light",
    "face/figure": "link face/pose face/anatomy face/gpu face/light face/skin",
    "face/head": "link face/pose face/quality face/anatomy face/gpu face/light face/skin face/figure",
    "face/hair": "link face/quality face/anatomy face/gpu face/light face/skin face/head",
    "face": (
        "link face/pose face/quality face/anatomy face/gpu face/blend face/light face/skin face/figure face/head "
        "face/hair"
    ),
    "stage": "link ui face/pose face/quality face/light face",
    "console/store": "link ui",
    "console/controls": "link ui console/store",
    "console/clips": "link ui access console/store console/controls",
    "console/show_file": "link ui console/store console/controls",
    "console/devices": "link ui console/store console/controls",
    "console/mappings": "link ui console/store console/controls console/devices",
    "console/leases": "link ui console/store console/controls",
    "console/mixer": "link ui console/store console/controls",
    "console/palette": "link ui console/store console/controls console/show_file console/clips",
    "console/pads": "link ui console/store console/controls console/palette",
    "console/panels": (
        "link ui face/pose face/quality face console/store console/controls console/show_file console/clips "
        "console/mappings"
    ),
    "console/learn": (
        "link ui console/store console/controls console/devices console/mixer console/palette console/mappings "
        "console/pads"
    ),
    "console/cues": "link ui access console/store console/pads",
    "console/scene": "link ui console/store console/controls console/cues",
    "console": (
        "link ui access face/pose face console/store console/controls console/show_file console/devices "
        "console/leases console/mixer console/palette console/panels console/scene console/learn console/clips "
        "console/mappings console/pads"
    ),
    "console/devices_page": (
        "link ui access console/store console/show_file console/devices console/mappings console/leases console/panels "
        "console"
    ),
    "rehearsal": "link ui",
    "console/cues_page": (
        "link ui access rehearsal console/store console/leases console/panels console console/cues console/clips"
    ),
    "console/clips_page": "link ui access console/store console/leases console/panels console console/clips",
    "console/solo_page": (
        "link ui access console/store console/controls console/show_file console/leases console/panels console/scene "
        "console/learn console console/cues console/clips console/pads"
    ),
    "microphone": "link ui access",
    "rehearsal/notes": "ui rehearsal",
    "rehearsal/runs": "link ui rehearsal",
    "replay": "ui rehearsal",
    "camera/session": "link face_mesh hands body webcam",
    "camera": "ui access face_mesh hands body camera/session",
    "editor/link": "link",
    "editor/session": "link ui face/pose face/gpu face editor/link",
    "editor/controls": "ui editor/session",
    "editor/canvas/math": "link face/anatomy",
    "editor/scan/data": "link ui editor/canvas/math",
    "editor/scan/views": "link ui face/anatomy face/gpu editor/canvas/math editor/scan/data",
    "editor/scan/photographs": "link ui face_mesh editor/scan/data",
    "editor/scan/turn": "ui face_mesh webcam editor/controls",
    "editor/scan": (
        "link ui editor/session editor/controls editor/scan/data editor/scan/views editor/scan/photographs "
        "editor/scan/turn"
    ),
    "editor/pose": "link ui face face/figure face/pose editor/session editor/controls",
    "editor/panels": "link ui face/pose editor/session editor/controls editor/pose",
    "editor/page": "link ui editor/session editor/controls editor/pose",
    "editor/canvas/model": "link face/anatomy editor/session editor/canvas/math",
    "editor/canvas/draw": (
        "link face/pose face/quality face/anatomy face/gpu face/light face/skin face/head face/hair editor/session "
        "editor/canvas/math editor/canvas/model"
    ),
    "editor/canvas/scene": (
        "link face/anatomy face/gpu face/hair editor/session editor/canvas/math editor/canvas/model editor/canvas/draw"
    ),
    "editor/canvas/input": (
        "ui face/anatomy editor/session editor/canvas/math editor/canvas/model editor/canvas/draw editor/canvas/scene"
    ),
    "editor/canvas": (
        "link face/quality face/anatomy face/gpu editor/session editor/canvas/math editor/canvas/draw "
        "editor/canvas/scene editor/canvas/input"
    ),
    "editor": (
        "link ui access editor/link editor/session editor/controls editor/panels editor/page editor/canvas editor/pose "
        "editor/scan editor/scan/data"
    ),
}
ALLOWED = {folder: set(used.split()) for folder, used in USED.items()}

IMPORT = re.compile(r'^(?:import|export)\s+(?:[\w\s{},*]+?\bfrom\s+)?"(\.[^"]+)"|\bimport\("(\.[^"]+)"\)', re.MULTILINE)


def imports_in(text: str, module: str) -> set[str]:
    """The modules that the text of a module imports by a relative path, types too; all as paths below `src`."""
    found = (first or second for first, second in IMPORT.findall(text))
    code = (path for path in found if not path.partition("?")[0].endswith((".jpg", ".json")))  # data
    return {_resolved(PurePosixPath(module).parent / path) for path in code}


def _resolved(path: PurePosixPath) -> str:
    parts: list[str] = []
    for part in PurePosixPath(str(path).partition(".ts?")[0]).parts:  # `?worker&url`: the module as a file of its own
        if part == "..":
            parts.pop()
        else:
            parts.append(part)
    return "/".join(parts)


MODULES = {
    path.relative_to(SOURCE).with_suffix("").as_posix(): path.read_text()
    for path in sorted(SOURCE.rglob("*.ts"))
    if not path.name.endswith((".test.ts", ".d.ts"))  # `.d.ts` names modules that the build makes
}
IMPORTS = {module: imports_in(text, module) for module, text in MODULES.items()}
FOLDERS = sorted({PurePosixPath(module).parent.as_posix() for module in MODULES})


def folder_of(module: str) -> str:
    """The folder of a module below `src`."""
    return PurePosixPath(module).parent.as_posix()


def closure(folder: str) -> set[str]:
    """All folders that a folder may reach, directly or through others."""
    reached = set[str]()
    open_ends = [folder]
    while open_ends:
        new = ALLOWED[open_ends.pop()] - reached
        reached |= new
        open_ends += new
    return reached


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ('import { a } from "./b";\n', {"ui/b"}),
        ('import type {\n  A,\n} from "../link/c";\n', {"link/c"}),
        ('import "./d";\n', {"ui/d"}),
        ('export { e } from "./e";\n', {"ui/e"}),
        ('const f = await import("./f");\n', {"ui/f"}),
        ('import { html } from "lit";\nexport class G {\n  @query(".g") g = "./g";\n}\n', set()),
    ],
)
def test_the_search_for_imports_finds_each_kind(text: str, found: set[str]) -> None:
    assert imports_in(text, "ui/a") == found


def test_every_import_leads_to_a_module() -> None:
    assert {(module, to) for module, all_of in IMPORTS.items() for to in all_of if to not in MODULES} == set()


def test_the_table_names_every_folder_and_no_other() -> None:
    assert sorted(ALLOWED) == FOLDERS
    assert set().union(*ALLOWED.values()) <= set(FOLDERS)


def test_the_table_goes_one_way() -> None:
    order = list(ALLOWED)
    assert all(order.index(to) < order.index(folder) for folder, used in ALLOWED.items() for to in used)


def test_pages_reach_no_other_page_and_what_is_shared_reaches_no_page() -> None:
    pages = {"stage", "console", "editor"}
    for folder in ALLOWED:
        top = folder.split("/")[0]
        assert {to.split("/")[0] for to in closure(folder)} & pages <= {top} & pages
    assert not any(to.startswith("face") for to in closure("ui"))
    assert "ui" not in closure("face")


def test_imports_are_those_of_the_table() -> None:
    used: dict[str, set[str]] = {folder: set() for folder in FOLDERS}
    for module, all_of in IMPORTS.items():
        used[folder_of(module)] |= {folder_of(to) for to in all_of} - {folder_of(module)}
    assert used == ALLOWED


def test_a_short_module_with_one_importer_lives_in_it() -> None:
    importers = {module: {one for one, found in IMPORTS.items() if module in found} for module in MODULES}
    lonely = {
        module
        for module, text in MODULES.items()
        if len(importers[module]) == 1
        and len(text.splitlines()) < SHORT_MODULE
        and not (SOURCE / f"{module}.test.ts").exists()
    }
    assert lonely == set(LONELY_MODULES)


def test_every_module_is_used_or_is_a_page() -> None:
    tests = [imports_in(path.read_text(), path.relative_to(SOURCE).as_posix()) for path in SOURCE.rglob("*.test.ts")]
    used = set().union(*IMPORTS.values(), *tests)
    assert {module for module in MODULES if PurePosixPath(module).name not in PAGES_AND_WORKERS} - used == set()


def test_biome_checks_cycles_and_the_length_of_bodies() -> None:
    config = json.loads((WEB / "biome.json").read_text())
    rules = config["linter"]["rules"]
    assert rules["suspicious"]["noImportCycles"] == {"level": "error", "options": {"ignoreTypes": False}}
    bodies = {"level": "error", "options": {"maxLines": 80}}  # as Python's
    assert rules["complexity"]["noExcessiveLinesPerFunction"] == bodies
    off = [override for override in config["overrides"] if "complexity" in override["linter"]["rules"]]
    assert [override["includes"] for override in off] == [["**/*.test.ts"]]
