"""Lists the hand-written files whose code names a noun of the show: `python -m tools.noun_files gaze_point`.

A noun is declared once and the rest is derived from it: the list is what another such noun would cost.
"""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parent.parent
FOLDERS = ("src/omote", "web/src")
ENDINGS = (".py", ".ts", ".css", ".html")
GENERATED = "// Written by tools/"
"""How a generated file begins."""


def pattern_of(noun: str) -> re.Pattern[str]:
    """What finds a noun as a word or in a name: `gaze_points`, `GazePoint`, `setGazePoint`, `MOST_GAZE_POINTS`.

    noun: in snake case and the singular.
    """
    camel = "".join(word.title() for word in noun.split("_"))
    lower = camel[0].lower() + camel[1:]
    end = "s?(?![a-z])"
    snake = rf"(?<![A-Za-z])(?:{noun.replace('_', '[-_ ]')}|{lower}){end}"
    return re.compile(rf"{snake}|{camel}{end}|(?<![A-Z]){noun.upper()}S?(?![A-Z])")


def hand_written(root: Path = ROOT) -> Iterator[Path]:
    """The source files of a checkout that somebody writes: no tests, nothing generated or built."""
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            built = path.is_relative_to(root / "src/omote/server/web")
            if path.suffix not in ENDINGS or built or path.name.endswith((".test.ts", ".d.ts")):
                continue
            if not path.read_text(encoding="utf-8").startswith(GENERATED):
                yield path


def code_of(path: Path) -> str:
    """The text of a source file without what is written for readers alone: comments and docstrings."""
    text = path.read_text(encoding="utf-8")
    if path.suffix != ".py":
        return re.sub(r"/\*.*?\*/|(?<!:)//[^\n]*", "", text, flags=re.DOTALL)
    tree = ast.parse(text)
    for node in ast.walk(tree):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
            node.body = [line for line in node.body if not _is_text(line)] or [ast.Pass()]
    return ast.unparse(tree)


def _is_text(line: ast.stmt) -> bool:
    return isinstance(line, ast.Expr) and isinstance(line.value, ast.Constant) and isinstance(line.value.value, str)


def files_naming(noun: str, root: Path = ROOT) -> list[Path]:
    """The hand-written files whose code names a noun.

    noun: in snake case; root: of a checkout, to which the paths are relative.
    """
    pattern = pattern_of(noun)
    return [path.relative_to(root) for path in hand_written(root) if pattern.search(code_of(path))]


def main(nouns: list[str]) -> None:
    """Prints the files of each noun, and how many they are."""
    for noun in nouns:
        found = files_naming(noun)
        print(f"{noun}: {len(found)} files")
        for path in found:
            print(f"  {path.as_posix()}")


if __name__ == "__main__":
    main(sys.argv[1:])
