"""Docstrings name all parameters; those of omote's public names are in NumPy style, with examples that run."""

from __future__ import annotations

import ast
import asyncio
import doctest
import inspect
import math
import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import omote
from omote.model.space.similarity import Similarity
from omote.perform.clips.cut_clip import record

SECTIONS = ("Parameters", "Attributes", "Returns", "Raises", "Notes", "Examples", "References")
ROOT = Path(omote.__file__).parent
OPTION = re.compile(r"\btyper\.|(Option|Argument)$")
"""The annotation of a parameter that a command's user reads the help of."""
SOURCE = re.compile(r"Arai \(1993\)|docs/[a-z]+\.md")


def public() -> Iterator[tuple[str, Any]]:
    """Every public name of omote, and the public methods of its classes."""
    for name in omote.__all__:
        value = getattr(omote, name)
        yield name, value
        if inspect.isclass(value):
            methods = inspect.getmembers(value, callable)
            yield from ((f"{name}.{method}", function) for method, function in methods if not method.startswith("_"))


PUBLIC = dict(public())


def sections_of(value: object) -> dict[str, str]:
    """A docstring by section; what comes before the first one is under ""."""
    parts = re.split(r"^(\w+)\n-+\n", inspect.getdoc(value) or "", flags=re.MULTILINE)
    return {"": parts[0], **dict(zip(parts[1::2], parts[2::2], strict=True))}


def entries(section: str) -> dict[str, tuple[str, str]]:
    """What a section lists: its type and its description by name; `theta, h : ...` lists two."""
    found: dict[str, tuple[str, str]] = {}
    for names, kind, description in re.findall(r"^(\S.*?)(?: : (.*))?\n((?:    .*\n?|\n)+)", section, re.MULTILINE):
        found |= {name.strip().lstrip("*"): (kind, description.strip()) for name in names.split(",")}
    return found


def parameters_of(value: object) -> dict[str, str]:
    """The parameters that a caller gives, with their annotations."""
    assert callable(value)
    parameters = inspect.signature(value).parameters
    return {name: str(parameter.annotation) for name, parameter in parameters.items() if name not in ("self", "cls")}


def wrong_calls(cast: omote.Cast) -> dict[tuple[str, type[Exception]], Callable[[], object]]:
    """For each error that a docstring announces one call that raises it."""
    space = cast.space
    kaori = cast.faces["kaori"]
    smile = cast.expressions["smile"]
    strange = omote.Face("strange", np.eye(3))
    rows = np.flatnonzero(space.on_sheet)[::40]
    net = omote.ControlNet.build(space, space.theta[rows], space.h[rows])
    sculpt = omote.Sculpt("far", np.eye(4, 3) + 1, np.zeros((4, 3)))
    performer = omote.Performer(cast)
    frame = omote.Performer(cast).advance(0.0)
    without = omote.Cast(space, {"kaori": kaori}, {"neutral": cast.expressions["neutral"]})
    words: Any = "one"  # what no type checker lets through
    no_parts: Any = 3
    mixed: Any = replace(frame, faces={"kaori": words})
    dtheta = smile.dtheta
    dh = smile.dh
    ratio = smile.ratio
    residual = smile.residual
    nowhere = Path("no such sculpt.toml")
    performer.call_face("old")
    scene = omote.Scene.begun(cast)
    scene["one"].call_face("old")
    scene.keep_memory("finale")
    player = omote.CuePlayer(scene, [])
    lane = omote.Lane(record(omote.Performer(cast), cast, seconds=0.5))
    clip = omote.Clip([lane])
    performer.play_clip(clip)
    scene.set_clips({"line1": clip})
    jaw = omote.MacroTarget("channel/jawOpen")
    performer.set_mapping(omote.MacroMapping("mouth", (jaw,)))
    many = [omote.MacroMapping(f"m{number}", (jaw,)) for number in range(65)]
    look = omote.PadLook("Glad", {"joy": 1.0}, (1.0,))
    pad = omote.Pad("mood", "expression", 1, (omote.PadLook("Calm", {"neutral": 1.0}, (0.0,)), look))
    full = omote.Scene.begun(cast)
    for number in range(29):
        full.set_pad(replace(pad, name=f"p{number}"))
    crowded = omote.Scene.begun(cast)
    crowded.drop_pad("moods")
    for number in range(30):
        crowded.set_pad(replace(pad, name=f"p{number}"))
    return {
        ("HalfBelow", ValueError): lambda: omote.HalfBelow(0.5, ((0.0, 0.5), (1.0, 1.0))),
        ("HalfBelow", TypeError): lambda: omote.HalfBelow(words),
        ("MacroTarget", ValueError): lambda: omote.MacroTarget("head/up"),
        ("MacroTarget", TypeError): lambda: omote.MacroTarget("head/yaw", high=words),
        ("MacroCondition", ValueError): lambda: omote.MacroCondition("head/yaw", 0.5),
        ("MacroCondition", TypeError): lambda: omote.MacroCondition("macro/on", words),
        ("MacroMapping", ValueError): lambda: omote.MacroMapping("mouth", ()),
        ("MacroMapping.with_name", ValueError): lambda: many[0].with_name("a/b"),
        ("Performer.set_mapping", ValueError): lambda: performer.set_mapping(
            omote.MacroMapping("mouth", (omote.MacroTarget("channel/jawOpn"),))
        ),
        ("Performer.set_mapping", TypeError): lambda: performer.set_mapping(words),
        ("Performer.set_mappings", ValueError): lambda: performer.set_mappings(many),
        ("Performer.rename_mapping", ValueError): lambda: performer.rename_mapping("mouth", "a/b"),
        ("Performer.drop_mapping", ValueError): lambda: performer.drop_mapping("jaw"),
        ("Performer.restore_mapping", ValueError): lambda: performer.restore_mapping("nothing"),
        ("Performer.move_macro", ValueError): lambda: performer.move_macro("mouth", 2.0),
        ("Performer.move_macro", TypeError): lambda: performer.move_macro("mouth", words),
        ("PadLook", ValueError): lambda: replace(look, mix={"joy": 0.5}),
        ("PadLook", TypeError): lambda: replace(look, place=(words,)),
        ("Pad", ValueError): lambda: replace(pad, dimensions=2),
        ("Pad", TypeError): lambda: replace(pad, looks=(look, words)),
        ("Pad.weights_at", ValueError): lambda: pad.weights_at((2.0,)),
        ("Pad.weights_at", TypeError): lambda: pad.weights_at((words,)),
        ("Pad.mix_at", ValueError): lambda: pad.mix_at((0.0, 0.0)),
        ("Pad.mix_at", TypeError): lambda: pad.mix_at((words,)),
        ("Pad.check_place", ValueError): lambda: pad.check_place((2.0,)),
        ("Pad.check_place", TypeError): lambda: pad.check_place((words,)),
        ("Pad.moved", ValueError): lambda: pad.moved((), 0.0, 0.0, None),
        ("Pad.moved", TypeError): lambda: pad.moved((), words, None, None),
        ("Performer.move_pad", ValueError): lambda: performer.move_pad(pad, 2.0),
        ("Performer.move_pad", TypeError): lambda: performer.move_pad(words, 0.0),
        ("Scene.set_pad", ValueError): lambda: full.set_pad(pad),
        ("Scene.set_pad", TypeError): lambda: scene.set_pad(words),
        ("Scene.rename_pad", ValueError): lambda: scene.rename_pad("moods", "mouth"),
        ("Scene.copy_pad", ValueError): lambda: scene.copy_pad("nowhere", "lips"),
        ("Scene.drop_pad", ValueError): lambda: scene.drop_pad("nowhere"),
        ("Scene.restore_pad", ValueError): lambda: scene.restore_pad("nowhere"),
        ("Scene.add_cast_pads", ValueError): lambda: crowded.add_cast_pads(),
        ("Scene.move_pad", ValueError): lambda: scene.move_pad("one", "nowhere", 0.0),
        ("Scene.move_pad", TypeError): lambda: scene.move_pad("one", "mouth", words),
        ("Scene.find_pad", ValueError): lambda: scene.find_pad("nowhere"),
        ("Lane", ValueError): lambda: omote.Lane(lane.curve, weight=2.0),
        ("Lane", TypeError): lambda: omote.Lane(lane.curve, muted=words),
        ("Clip", ValueError): lambda: omote.Clip([]),
        ("Clip", TypeError): lambda: omote.Clip([lane], speed=words),
        ("Performer.play_clip", ValueError): lambda: performer.play_clip(clip, start=9.0),
        ("Performer.play_clip", TypeError): lambda: performer.play_clip(words),
        ("Performer.stop_clip", ValueError): lambda: performer.stop_clip(seconds=-1.0),
        ("Performer.stop_clip", TypeError): lambda: performer.stop_clip(seconds=words),
        ("Scene.set_clips", TypeError): lambda: scene.set_clips({"line1": words}),
        ("Scene.play_clip", ValueError): lambda: scene.play_clip("one", "line2"),
        ("Scene.play_clip", TypeError): lambda: scene.play_clip("one", "line1", seconds=words),
        ("Move", ValueError): lambda: omote.Move({}, seconds=-1.0),
        ("Move", TypeError): lambda: omote.Move({}, seconds=words),
        ("Cue", ValueError): lambda: omote.Cue("a", "1.10"),
        ("Cue", TypeError): lambda: omote.Cue("a", "1", pre_wait=words),
        ("CueAction", ValueError): lambda: omote.CueAction("osc", "nowhere", "/go"),
        ("CueAction", TypeError): lambda: omote.CueAction("say", "one", "Ho", delay=words),
        ("CuePlayer", ValueError): lambda: omote.CuePlayer(scene, [omote.Cue("a", "1"), omote.Cue("b", "1")]),
        ("CuePlayer.go", ValueError): player.go,
        ("CuePlayer.go_to", ValueError): lambda: player.go_to("7"),
        ("CuePlayer.set_standby", ValueError): lambda: player.set_standby("7"),
        ("CuePlayer.edit", ValueError): lambda: player.edit([omote.Cue("a", "1"), omote.Cue("a", "2")]),
        ("CuePlayer.advance", ValueError): lambda: player.advance(-1.0),
        ("CuePlayer.advance", TypeError): lambda: player.advance(words),
        ("read_cues", ValueError): lambda: omote.read_cues("no such cues.toml"),
        ("write_cues", OSError): lambda: omote.write_cues([], "no such folder/cues.toml"),
        ("Scene.goal_of", ValueError): lambda: scene.goal_of("one/tail"),
        ("Scene.shown_goal", ValueError): lambda: scene.shown_goal("two/face"),
        ("Scene.call_goal", ValueError): lambda: scene.call_goal("one/face", {"dgo": 1.0}),
        ("Scene.call_goal", TypeError): lambda: scene.call_goal("*/black", {"black": words}),
        ("Cast", ValueError): lambda: omote.Cast(space, {"strange": strange}, dict(cast.expressions)),
        ("Cast", KeyError): lambda: cast.faces["dgo"],
        ("Cast.under", ValueError): lambda: cast.under(words),
        ("Cast.with_expressions", ValueError): lambda: cast.with_expressions(
            new=omote.Expression(np.zeros(3), np.zeros(3), np.ones(3), np.zeros((0, 3)))
        ),
        ("Cast.with_faces", ValueError): lambda: cast.with_faces(strange),
        ("ControlNet.build", ValueError): lambda: omote.ControlNet.build(space, [0, 0, 0], [9, 9, 9]),
        ("ControlNet.drag", ValueError): lambda: net.drag(kaori, -1, [0, 0, 0]),
        ("ControlNet.expression", ValueError): lambda: net.expression(np.zeros((2, 3))),
        ("ControlNet.points_on", ValueError): lambda: net.points_on(strange),
        ("Expression", ValueError): lambda: omote.Expression(dtheta, dh, -ratio, residual),
        ("Expression", TypeError): lambda: omote.Expression(dtheta, dh, ratio, residual, no_parts),
        ("Face", ValueError): lambda: omote.Face("", kaori.positions),
        ("Photograph", ValueError): lambda: omote.Photograph(np.asarray(kaori.positions, np.float64), 640, 480),
        ("fit_photographs", ValueError): lambda: omote.fit_photographs(space, []),
        ("Face", TypeError): lambda: omote.Face("one", kaori.positions, no_parts),
        ("fit", ValueError): lambda: omote.fit(space, np.zeros((3, 3))),
        ("Gain", ValueError): lambda: omote.Gain("mouth", 9.0),
        ("ParameterSpace.build", ValueError): lambda: omote.ParameterSpace.build(np.eye(3), [[0, 1, 2]]),
        ("ParameterSpace.under", ValueError): lambda: space.under(words),
        ("ParameterSpace.with_line", ValueError): lambda: space.with_line("lips", "lips", [np.nan, 0, 0]),
        ("Performer", ValueError): lambda: omote.Performer(without),
        ("Performer.advance", ValueError): lambda: performer.advance(-1.0),
        ("Performer.advance", TypeError): lambda: performer.advance(words),
        ("Performer.call_pose", ValueError): lambda: performer.call_pose("nobody"),
        ("Performer.call_pose", TypeError): lambda: performer.call_pose("stand", seconds=words),
        ("Performer.fade_pose", ValueError): lambda: performer.fade_pose(2),
        ("Performer.fade_pose", TypeError): lambda: performer.fade_pose(words),
        ("Performer.call_body", ValueError): lambda: performer.call_body("nobody"),
        ("Performer.call_body", TypeError): lambda: performer.call_body("own", seconds=words),
        ("Performer.call_expression", ValueError): lambda: performer.call_expression("nobody"),
        ("Performer.call_expression", TypeError): lambda: performer.call_expression("smile", seconds=words),
        ("Performer.call_face", ValueError): lambda: performer.call_face("old", easing="none"),
        ("Performer.call_face", TypeError): lambda: performer.call_face("old", seconds=words),
        ("Performer.call_light", ValueError): lambda: performer.call_light("flat", seconds=-1),
        ("Performer.call_light", TypeError): lambda: performer.call_light("flat", seconds=words),
        ("Performer.fade_expression", ValueError): lambda: performer.fade_expression(2),
        ("Performer.fade_expression", TypeError): lambda: performer.fade_expression(words),
        ("Performer.fade_face", ValueError): lambda: performer.fade_face(-1),
        ("Performer.fade_face", TypeError): lambda: performer.fade_face(words),
        ("Performer.play_sound", ValueError): lambda: performer.play_sound("bell", 601.0),
        ("Performer.play_sound", TypeError): lambda: performer.play_sound("bell", words),
        ("Performer.recast", ValueError): lambda: performer.recast(without),
        ("Performer.restored", ValueError): lambda: omote.Performer.restored(
            without_face(cast, "old"), performer.snapshot()
        ),
        ("Performer.set_channel", ValueError): lambda: performer.set_channel("neutral", 1),
        ("Performer.set_channel", TypeError): lambda: performer.set_channel("jawOpen", words),
        ("Performer.set_channels", ValueError): lambda: performer.set_channels({"neutral": 1}),
        ("Performer.set_channels", TypeError): lambda: performer.set_channels({"jawOpen": words}),
        ("Performer.drive", ValueError): lambda: performer.drive({"jawOpen": 4.0}),
        ("Performer.drive", TypeError): lambda: performer.drive({"jawOpen": words}),
        ("Performer.look_at", ValueError): lambda: performer.look_at("nowhere"),
        ("Performer.look_at", TypeError): lambda: performer.look_at("direction", yaw=words),
        ("Performer.set_layer", ValueError): lambda: performer.set_layer("lips", influence=4.0),
        ("Performer.set_motion", ValueError): lambda: performer.set_motion(4.0),
        ("Performer.set_motion", TypeError): lambda: performer.set_motion(words),
        ("Performer.set_spring", ValueError): lambda: performer.set_spring("tail", 1.0),
        ("Performer.set_spring", TypeError): lambda: performer.set_spring("ears-sway", words),
        ("Performer.set_skin", ValueError): lambda: performer.set_skin("sweat", 1.0),
        ("Performer.set_skin", TypeError): lambda: performer.set_skin("folds", words),
        ("Performer.set_layer", TypeError): lambda: performer.set_layer("lips", influence=words),
        ("Performer.say", ValueError): lambda: performer.say("a", language="fr"),
        ("Performer.say", TypeError): lambda: performer.say("a", delay=words),
        ("Performer.gesture", ValueError): lambda: performer.gesture("dance"),
        ("Performer.gesture", TypeError): lambda: performer.gesture("nod", amplitude=words),
        ("Performer.set_gaze", ValueError): lambda: performer.set_gaze(4, 0),
        ("Performer.set_gaze", TypeError): lambda: performer.set_gaze(words, 0),
        ("Performer.set_head", ValueError): lambda: performer.set_head(0, 0, 4),
        ("Performer.set_head", TypeError): lambda: performer.set_head(0, 0, words),
        ("Performer.set_home", ValueError): lambda: performer.set_home("nobody"),
        ("Performer.set_home", TypeError): lambda: performer.set_home("old", seconds=words),
        ("Scene", ValueError): lambda: omote.Scene(without),
        ("Scene.add", ValueError): lambda: scene.add("Old"),
        ("Scene.advance", ValueError): lambda: scene.advance(-1.0),
        ("Scene.advance", TypeError): lambda: scene.advance(words),
        ("Scene.keep_memory", ValueError): lambda: scene.keep_memory(""),
        ("Scene.delete_memory", ValueError): lambda: scene.delete_memory("nowhere"),
        ("Scene.restore_memory", ValueError): lambda: scene.restore_memory("nowhere"),
        ("Scene.call_memory", ValueError): lambda: scene.call_memory("nowhere"),
        ("Scene.call_memory", TypeError): lambda: scene.call_memory("finale", seconds=words),
        ("Scene.delete_gaze_point", ValueError): lambda: scene.delete_gaze_point("nowhere"),
        ("Scene.note_camera", ValueError): lambda: scene.note_camera("", (0.0, 0.0, 999.0)),
        ("Scene.note_camera", TypeError): lambda: scene.note_camera("", (0.0, 0.0, words)),
        ("Scene.keep_look_of", ValueError): lambda: scene.keep_look_of(scene, " "),
        ("Scene.channels_of", ValueError): lambda: scene.channels_of("zoe"),
        ("Scene.call_channels", ValueError): lambda: scene.call_channels("one", {"jawOpn": 1.0}),
        ("Scene.call_channels", TypeError): lambda: scene.call_channels("one", {"jawOpen": words}),
        ("Scene.set_pace", ValueError): lambda: scene.set_pace(2.0),
        ("Scene.set_pace", TypeError): lambda: scene.set_pace(words),
        ("Scene.set_gaze_point", ValueError): lambda: scene.set_gaze_point("", x=0.0, y=0.0, z=1.0),
        ("Scene.set_gaze_point", TypeError): lambda: scene.set_gaze_point("seat", x=words, y=0.0, z=1.0),
        ("Scene.call_black", ValueError): lambda: scene.call_black(1.5),
        ("Scene.call_black", TypeError): lambda: scene.call_black(words),
        ("Scene.call_framing", ValueError): lambda: scene.call_framing(["nobody"]),
        ("Scene.call_framing", TypeError): lambda: scene.call_framing("one"),
        ("Scene.call_light", ValueError): lambda: scene.call_light("candle"),
        ("Scene.call_light", TypeError): lambda: scene.call_light("flat", seconds=words),
        ("Scene.enter", ValueError): lambda: scene.enter("nobody"),
        ("Scene.enter", TypeError): lambda: scene.enter("one", seconds=words),
        ("Scene.leave", ValueError): lambda: scene.leave("one", seconds=-1),
        ("Scene.leave", TypeError): lambda: scene.leave("one", seconds=words),
        ("Scene.place", ValueError): lambda: scene.place("one", x=99.0),
        ("Scene.place", TypeError): lambda: scene.place("one", size=words),
        ("Scene.recast", ValueError): lambda: scene.recast(without),
        ("Scene.remove", ValueError): lambda: scene.remove("nobody"),
        ("Scene.remove", TypeError): lambda: scene.remove("one", seconds=words),
        ("Scene.rename", ValueError): lambda: scene.rename("one", " "),
        ("Scene.restore", ValueError): lambda: scene.restore("nobody"),
        ("Scene.restore", TypeError): lambda: scene.restore("nobody", seconds=words),
        ("Scene.restored", ValueError): lambda: omote.Scene.restored(without_face(cast, "old"), scene.snapshot()),
        ("Scene.restored", TypeError): lambda: omote.Scene.restored(cast, words),
        ("Sculpt", ValueError): lambda: omote.Sculpt("same", np.zeros((4, 3)), np.zeros((4, 3))),
        ("add_random_faces", ValueError): lambda: omote.add_random_faces(cast, 0),
        ("add_random_faces", TypeError): lambda: omote.add_random_faces(cast, words),
        ("caricature", ValueError): lambda: omote.caricature(space, kaori, math.nan),
        ("Renderer", ValueError): lambda: omote.Renderer(cast, size=(1, 1)),
        ("Scan", ValueError): lambda: omote.Scan(np.zeros((4, 3))),
        ("take_expressions", ValueError): lambda: omote.take_expressions(
            space,
            omote.Fit(kaori, np.zeros(4278), np.ones(4278), Similarity(1.0, np.eye(3), np.zeros(3)), ()),
            omote.Scan(np.asarray(kaori.positions, np.float64)),
        ),
        ("compound", ValueError): lambda: omote.compound(space, strange, smile),
        ("connect", ConnectionError): lambda: omote.connect("http://127.0.0.1:1", timeout=0.1),
        ("connect", OSError): lambda: omote.connect("https://127.0.0.1:1", timeout=0.1, authority="nowhere.pem"),
        ("connect", ValueError): lambda: omote.connect("ftp://stage"),
        ("connect", TypeError): lambda: omote.connect(no_parts),
        ("connect_async", ConnectionError): lambda: asyncio.run(omote.connect_async("http://127.0.0.1:1", timeout=0.1)),
        ("connect_async", OSError): lambda: asyncio.run(
            omote.connect_async("https://127.0.0.1:1", timeout=0.1, authority="nowhere.pem")
        ),
        ("connect_async", ValueError): lambda: asyncio.run(omote.connect_async("ftp://stage")),
        ("connect_async", TypeError): lambda: asyncio.run(omote.connect_async(no_parts)),
        ("speak", ValueError): lambda: omote.speak("..."),
        ("draw_stimuli", ValueError): lambda: omote.draw_stimuli(Path(omote.__file__), "out"),
        ("draw_stimuli", OSError): lambda: omote.draw_stimuli(nowhere, "out"),
        ("evaluate", ValueError): lambda: omote.evaluate(cast, frame, words),
        ("evaluate", TypeError): lambda: omote.evaluate(cast, mixed),
        ("evaluate_figure", ValueError): lambda: omote.evaluate_figure(replace(cast, figures=None), mixed),
        ("evaluate_parts", ValueError): lambda: omote.evaluate_parts(cast, frame, words),
        ("evaluate_parts", TypeError): lambda: omote.evaluate_parts(cast, mixed),
        ("extract", ValueError): lambda: omote.extract(space, kaori, np.zeros((2, 3))),
        ("extract", TypeError): lambda: omote.extract(space, kaori, kaori.positions, parts=no_parts),
        ("parse_pose", ValueError): lambda: omote.parse_pose(cast, face="nobody"),
        ("parse_pose", TypeError): lambda: omote.parse_pose(cast, turn=no_parts),
        ("read_show", RuntimeError): lambda: omote.read_show(nowhere),
        ("read_show", TypeError): lambda: omote.read_show(no_parts),
        ("read_sculpt", ValueError): lambda: omote.read_sculpt(nowhere),
        ("regional", ValueError): lambda: omote.regional(space, "new", {words: kaori}),
        ("render", ValueError): lambda: omote.render(cast, frame, size=(1, 1)),
        ("render", TypeError): lambda: omote.render(cast, mixed),
        ("sculpted", ValueError): lambda: omote.sculpted(space, sculpt),
    }


DOCUMENTED = {name: sections_of(value) for name, value in PUBLIC.items()}
"""The docstring of each public name, by section."""


def raised_by(call: Callable[[], object]) -> Exception | None:
    """The error that a call raises."""
    try:
        call()
    except Exception as error:
        return error
    return None


def without_face(cast: omote.Cast, gone: str) -> omote.Cast:
    """The cast without one of its faces."""
    looks = {name: look for name, look in cast.looks.items() if name != gone}
    return replace(cast, faces={name: face for name, face in cast.faces.items() if name != gone}, looks=looks)


@pytest.fixture(scope="module")
def cast() -> omote.Cast:
    """The built-in cast, loaded once for all examples."""
    built_in: omote.Cast = omote.load_cast()
    return built_in


Function = ast.FunctionDef | ast.AsyncFunctionDef


def defined(tree: ast.Module) -> Iterator[Function]:
    """The public functions of a module, and the public methods of its public classes."""
    classes = [node for node in tree.body if isinstance(node, ast.ClassDef) and not node.name.startswith("_")]
    for node in (*tree.body, *(each for made in classes for each in made.body)):
        if isinstance(node, Function) and not node.name.startswith("_"):
            yield node


def given(function: Function) -> list[str]:
    """The names of a function's parameters, but for the first one of a method, and the options of commands: what one
    means its help says."""
    arguments = function.args
    starred = [each for each in (arguments.vararg, arguments.kwarg) if each is not None]
    parameters = (*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs, *starred)
    helped = [each.arg for each in parameters if each.annotation and OPTION.search(ast.unparse(each.annotation))]
    return [each.arg for each in parameters if each.arg not in ("self", "cls", *helped)]


def faults(function: Function) -> list[str]:
    """What a docstring lacks: the parameters that it does not name, or a verb where the function changes something."""
    text = ast.get_docstring(function) or ""
    names = given(function)
    missing = [name for name in names if len(names) > 1 and not re.search(rf"\b{name}\b", text)]
    changes = isinstance(function.returns, ast.Constant) and function.returns.value is None
    return [*missing, "a verb"] if changes and not re.match(r"[A-Z][a-z]+s\b", text) else missing


@pytest.mark.parametrize(
    ("text", "missing"),
    [
        ("def f(a, b):\n 'The sum of a and b.'", []),
        ("def f(a, b):\n 'The sum.'", ["a", "b"]),
        ("def f(a):\n 'Its half.'", []),
        ("def f(a) -> None:\n 'A half.'", ["a verb"]),
        ("def f(a, *, key) -> None:\n 'Sets a for key.'", []),
        ("def f(a: Annotated[int, typer.Option(help='A.')], b: JsonOption):\n 'The sum.'", []),
    ],
)
def test_what_a_docstring_lacks_is_found(text: str, missing: list[str]) -> None:
    assert [fault for function in defined(ast.parse(text)) for fault in faults(function)] == missing


def test_docstrings_name_all_parameters_and_say_by_a_verb_what_changes() -> None:
    lacking = {
        f"{path.relative_to(ROOT).as_posix()}:{function.name}": missing
        for path in sorted(ROOT.rglob("*.py"))
        for function in defined(ast.parse(path.read_text()))
        if (missing := faults(function))
    }
    assert lacking == {}


def listed_in(sections: dict[str, str]) -> dict[str, tuple[str, str]]:
    """The parameters, or the fields, that a docstring lists."""
    return entries(sections.get("Parameters", "") + sections.get("Attributes", ""))


def test_sections_are_known_and_in_order() -> None:
    for name, sections in DOCUMENTED.items():
        titles = [section for section in sections if section]
        assert titles == [section for section in SECTIONS if section in titles], name


def test_a_docstring_begins_with_one_sentence_on_one_line() -> None:
    for name, sections in DOCUMENTED.items():
        first = sections[""].strip().split("\n\n")[0]
        assert re.fullmatch(r"\S.*\.", first), f"{name}: {first}"
        assert not re.search(r"\. [A-Z]", first), f"{name} begins with more than one sentence: {first}"


def test_parameters_are_those_of_the_signature_in_its_order() -> None:
    for name, value in PUBLIC.items():
        given = parameters_of(value)
        listed = listed_in(DOCUMENTED[name])
        inherits_order = inspect.isclass(value)  # fields of one meaning are listed together
        assert (sorted(listed) == sorted(given)) if inherits_order else ([*listed] == [*given]), name
        assert [parameter for parameter, (kind, text) in listed.items() if not kind or not text] == [], name


def test_arrays_are_given_with_their_shapes() -> None:
    for name, value in PUBLIC.items():
        listed = listed_in(DOCUMENTED[name])
        arrays = [p for p, kind in parameters_of(value).items() if re.search("ArrayLike|NDArray|Values|Indices", kind)]
        assert [p for p in arrays if not re.search(r"\(\w+,?.*\)", listed[p][0])] == [], name


def test_what_is_returned_is_documented_where_something_is() -> None:
    functions = {name: value for name, value in PUBLIC.items() if not inspect.isclass(value)}
    gives = {
        name: inspect.signature(value).return_annotation not in (None, "None") for name, value in functions.items()
    }
    assert {name: "Returns" in DOCUMENTED[name] for name in functions} == gives


def test_public_names_say_where_they_come_from() -> None:
    assert [name for name in omote.__all__ if not SOURCE.search(DOCUMENTED[name].get("References", ""))] == []


@pytest.mark.parametrize("name", PUBLIC)
def test_examples_run(name: str, cast: omote.Cast, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)  # for what they write
    text = sections_of(PUBLIC[name]).get("Examples", "")
    names = {"omote": omote, "cast": cast, "np": np, "math": math}
    example = doctest.DocTestParser().get_doctest(text, names, name, None, None)
    assert example.examples
    said: list[str] = []
    assert doctest.DocTestRunner().run(example, out=said.append).failed == 0, "".join(said)


def test_every_announced_error_is_raised_and_no_other_is_listed(cast: omote.Cast) -> None:
    announced = {
        (name, error) for name, value in PUBLIC.items() for error in entries(sections_of(value).get("Raises", ""))
    }
    announced -= {("load_cast", "FileNotFoundError"), ("load_cast", "ValueError")}  # tests/builtin/test_cast.py
    calls = wrong_calls(cast)
    assert announced == {(name, error.__name__) for name, error in calls}
    for (name, error), call in calls.items():
        assert type(raised_by(call)) in {error, *error.__subclasses__()}, name


def test_what_is_of_another_type_is_refused_with_what_was_expected(cast: omote.Cast) -> None:
    space = cast.space
    kaori = cast.faces["kaori"]
    wrong = cast_to_any(7)
    performer = omote.Performer(cast)
    frame = omote.Performer(cast).advance(0.0)
    expected = {
        "a channel is named by text": lambda: omote.action_units(wrong),
        "expected an omote.ParameterSpace": lambda: omote.caricature(wrong, kaori, 1.5),
        "expected a number such as 1.5": lambda: omote.caricature(space, kaori, cast_to_any("x")),
        "expected an omote.Sculpt": lambda: omote.sculpted(space, wrong),
        "a sculpt file is named by its path": lambda: omote.read_sculpt(wrong),
        "a show file is named by its path": lambda: omote.read_show(wrong),
        "a picture is named by its path": lambda: omote.render(cast, frame, path=wrong),
        "give a colour as text": lambda: omote.render(cast, frame, background=wrong),
        "give whole numbers of pixels": lambda: omote.render(cast, frame, size=cast_to_any((64.5, 64))),
        "the cast is a int; expected an omote.Cast": lambda: omote.Performer(wrong),
        "the cast is a ParameterSpace; expected": lambda: omote.parse_pose(cast_to_any(space)),
        "expected an omote.Cast, such as": lambda: performer.recast(wrong),
        "expected what Performer.snapshot": lambda: omote.Performer.restored(cast, wrong),
        "turn must be text, not 7; write turn='30,-5'": lambda: omote.parse_pose(cast, turn=wrong),
    }
    for said, call in expected.items():
        error = raised_by(call)
        assert isinstance(error, TypeError), (said, error)
        assert said in str(error)
    assert "give width and height" in str(raised_by(lambda: omote.render(cast, frame, size=wrong)))


def cast_to_any(value: object) -> Any:
    """A value that no type checker looks at."""
    return value
