"""A noun is found in code that somebody writes, in any spelling, and nowhere else."""

from pathlib import Path

import pytest

from tools.noun_files import files_naming, pattern_of


@pytest.mark.parametrize(
    "text", ["set_gaze_point", "GazePoints", "SetGazePoint(", "gazePoint", "MOST_GAZE_POINTS", "gaze point"]
)
def test_every_spelling_of_a_noun_is_found(text: str) -> None:
    assert pattern_of("gaze_point").search(text)


@pytest.mark.parametrize("text", ["playout", "layouted", "displayLayouting", "gaze", "point"])
def test_a_word_that_only_holds_the_noun_is_not(text: str) -> None:
    assert not pattern_of("layout").search(text)
    assert not pattern_of("gaze_point").search(text)


def test_tests_generated_files_and_words_for_readers_do_not_count(tmp_path: Path) -> None:
    files = {
        "src/omote/show/objects/poses.py": "class Pose: ...\n",
        "src/omote/show/spoken.py": '"""Of a pose."""\n# a pose\nX = 1\n"""And a pose."""\n',
        "src/omote/server/web/built.html": "<p>pose</p>",
        "web/src/link/messages.ts": "// Written by tools/messages.py\nexport interface Pose {}\n",
        "web/src/console/pose.ts": 'send("set_pose");',
        "web/src/console/pose.test.ts": 'send("set_pose");',
        "web/src/console/other.ts": "/** A pose. */\nlet x; // pose\n",
    }
    for name, text in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    expected = ["src/omote/show/objects/poses.py", "web/src/console/pose.ts"]
    assert [path.as_posix() for path in files_naming("pose", tmp_path)] == expected
