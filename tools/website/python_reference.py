"""Writes the reference of the public Python names as Markdown, from their signatures and NumPy docstrings."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any

import omote
from omote.client.connect import AsyncConnectedShow, ConnectedShow
from omote.client.remote_character import RemoteCharacter
from omote.client.utterance import AsyncUtterance, Utterance

HEAD = """# Python

Written from the docstrings by `tools/website/python_reference.py`.

Everything under `omote` itself is public; `import omote` is quick, and each name is loaded when it is first used.
Units, axes and signs: [conventions](../conventions.md). Whole programs: [examples](../examples.md). The package is
typed (`py.typed`).

In the examples of this page `cast` is `omote.load_cast()` and `np` is NumPy.
"""
GROUPS: Mapping[str, Sequence[str]] = {
    "The cast": ("load_cast", "read_show", "Cast", "Face", "Gain", "Expression", "ParameterSpace"),
    "Playing": (
        "Performer",
        "Scene",
        "connect",
        "connect_async",
        "parse_pose",
        "evaluate",
        "evaluate_figure",
        "evaluate_parts",
        "speak",
    ),
    "Clips": ("Clip", "Lane"),
    "Macros": ("MacroMapping", "MacroTarget", "HalfBelow", "MacroCondition"),
    "Pads": ("Pad", "PadLook"),
    "Cues": ("CuePlayer", "Cue", "Move", "CueAction", "read_cues", "write_cues"),
    "Pictures": ("render", "Renderer", "draw_stimuli"),
    "Expressions": ("compound", "extract", "ExtractedExpression", "take_expressions", "ControlNet", "action_units"),
    "Faces": ("fit", "Fit", "Scan", "Sculpt", "read_sculpt", "sculpted", "regional", "caricature", "add_random_faces"),
    "Photographs": ("Photograph", "fit_photographs", "PhotographFit"),
}
CONNECTED_HEAD = """# A program that plays a running show

Written from the docstrings by `tools/website/python_reference.py`. How to: [let a character speak](../howto/speech.md),
[drive a character](../howto/drive-from-a-program.md). The same over the network without Python: [the wire](wire.md).

```py
with omote.connect("http://127.0.0.1:8090", name="chat") as show:  # blocking: a call returns once the show has obeyed
    show["one"].call_expression("joy", seconds=0.5)
    show["one"].say("Hello there").wait()
```

```py
async with await omote.connect_async("http://127.0.0.1:8090", name="chat") as show:  # under asyncio: each is awaited
    await show["one"].call_expression("joy", seconds=0.5)
    said = await show["one"].say("Hello there")
    await said.wait()
```

Every call raises `ValueError` with the show's reason where it is rejected (a name that there is not, a number out of
range, a part that another holds), `TypeError` for a value of another kind, and `ConnectionError` where the show does
not come back within the `timeout` of the connection: it comes back by itself where the show is started again. Numbers
may be those of numpy. Two programs may play one character: who moved last has it.
"""
CONNECTED: Mapping[str, Sequence[type]] = {
    "The show": (ConnectedShow,),
    "A character of it": (RemoteCharacter,),
    "What was said": (Utterance,),
    "Under asyncio": (AsyncConnectedShow, AsyncUtterance),
}
GIVEN = {"Sent": "", "Said": " -> Utterance"}
"""What a blocking call gives where the code says what a call of either kind does."""
SECTION = re.compile(r"^(\w+)\n-+\n", re.MULTILINE)
PAGE = re.compile(r"\bdocs/([\w/-]+\.md)")
ENTRY = re.compile(r"^(\S.*?)(?: : (.*))?\n((?:    .*\n?|\n)+)", re.MULTILINE)


def python_page() -> str:
    """The page: each public name with what it takes, gives and raises, and an example."""
    parts = [HEAD]
    for title, names in GROUPS.items():
        parts += [f"## {title}\n", *(part for name in names for part in _sections(name))]
    return "\n".join(parts)


def connected_page() -> str:
    """The page of a program's connection: each method of a show and of its characters."""
    parts = [CONNECTED_HEAD, "## Connecting\n"]
    parts += [section_of(f"omote.{each.__name__}", each, depth=3) for each in (omote.connect, omote.connect_async)]
    for title, kinds in CONNECTED.items():
        parts.append(f"## {title}\n")
        for kind in kinds:
            parts += [f"### `{kind.__name__}`\n\n{inspect.getdoc(kind)}\n", *_inherited_sections(kind)]
    return "\n".join(parts)


def _inherited_sections(kind: type) -> Iterator[str]:
    """Its own methods and those that it inherits; under asyncio only its own, for the others are the same."""
    seen = set[str]()
    for each in kind.__mro__[:-1] if kind is not AsyncConnectedShow else (kind,):
        for member, found in vars(each).items():
            if member in seen or (member.startswith("_") and member != "__getitem__"):
                continue
            seen.add(member)
            title = f"{kind.__name__}.{member}" if member != "__getitem__" else f"{kind.__name__}[name]"
            if isinstance(found, property):
                yield f"#### `{title}`\n\n{inspect.getdoc(found)}\n"
            elif inspect.isfunction(found):
                yield _without_self(section_of(title, found, depth=4))


def _without_self(section: str) -> str:
    """As a caller writes it, with what a blocking call gives."""
    section = section.replace("(self, ", "(").replace("(self)", "()").replace("\n    self,", "")
    section = section.replace("[name](name: str)", "[name: str]")
    for code, gives in GIVEN.items():
        section = section.replace(f") -> {code}\n", f"){gives}\n")
    return re.sub(r"\[Sent, Said\]", "", section)


def _sections(name: str) -> Iterator[str]:
    value = getattr(omote, name)
    yield section_of(f"omote.{name}", value, depth=3)
    kinds = value.__mro__ if inspect.isclass(value) else ()
    ours = [each for each in reversed(kinds) if each.__module__.startswith("omote")]
    members = {member: found for each in ours for member, found in vars(each).items()}
    for member, found in members.items():
        if member.startswith("_"):
            continue
        if isinstance(found, property | cached_property):
            yield f"#### `{name}.{member}`\n\n{inspect.getdoc(found)}\n"
        elif callable(getattr(value, member)):
            yield section_of(f"{name}.{member}", getattr(value, member), depth=4)


def section_of(title: str, value: Any, *, depth: int) -> str:
    """One name: its signature, and its docstring section by section."""
    text, *rest = SECTION.split(inspect.getdoc(value) or "")
    lines = [f"{'#' * depth} `{title}`\n", f"```py\n{signature_of(title, value)}\n```\n", text.strip(), ""]
    for heading, body in zip(rest[::2], rest[1::2], strict=True):
        lines += [f"**{heading}**\n", _body(heading, body), ""]
    return "\n".join(lines)


def signature_of(title: str, value: Any) -> str:
    """A signature as it stands in the code, on lines of their own where it is long."""
    signature = inspect.signature(value)
    words = list[str]()
    for parameter in signature.parameters.values():
        kinds = parameter.kind, {each.kind for each in signature.parameters.values()}
        if kinds[0] is parameter.KEYWORD_ONLY and "*" not in words and parameter.VAR_POSITIONAL not in kinds[1]:
            words.append("*")
        words.append(str(parameter).replace("'", "") if parameter.default is parameter.empty else _optional(parameter))
    back = signature.return_annotation
    gives = "" if inspect.isclass(value) or back is signature.empty else f" -> {back}"
    line = f"{title}({', '.join(words)}){gives}"
    return line if len(line) <= 100 else f"{title}(\n    " + ",\n    ".join(words) + f",\n){gives}"


def _optional(parameter: inspect.Parameter) -> str:
    shown = "..." if "<" in repr(parameter.default) else repr(parameter.default)
    return f"{parameter.name}: {parameter.annotation} = {shown}"


def _body(heading: str, body: str) -> str:
    if heading == "Examples":
        return f"```pycon\n{body.strip()}\n```".replace("  # doctest: +SKIP", "")
    if heading in ("Notes", "References"):
        return PAGE.sub(r"[\1](../\1)", body.strip())
    entries = ENTRY.findall(body + "\n")
    return "\n".join(
        f"* `{name}`{f' ({_plain(kind)})' if kind else ''}: {_joined(text)}" for name, kind, text in entries
    )


def _plain(kind: str) -> str:
    return kind.replace("*", "\\*")


def _joined(text: str) -> str:
    return " ".join(line.strip() for line in text.splitlines() if line.strip())
