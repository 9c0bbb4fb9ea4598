"""Records the cast's documents as pages fetch them, and the files that other programs exchange with us."""

from __future__ import annotations

import msgspec

from omote.builtin import load_cast, load_mask, load_meshes
from omote.edit.protocol.wire import encode as encode_editing
from omote.interchange.export_face import ExportContext, build_scene, choose_expressions, named_compound_meshes
from omote.interchange.formats.glb_reader import Piece, read_glb
from omote.interchange.formats.glb_writer import glb_bytes
from omote.interchange.import_meshes import import_expressions, import_face
from omote.model.controls.default_net import default_net
from omote.model.recipes.compose_expression import compose_expression
from omote.model.recipes.recipe import KEY, Recipe
from omote.server.workers.order_worker import CompoundOrder, FaceOrder, HandlesOrder, OrderWorker, TangentsOrder
from omote.show.cast_documents import ContentAsset
from omote.show.wire import encode
from omote.showfile.contents import unpack_expression, unpack_face
from omote.stage_data.assets import documents
from omote.stage_data.picture_setting import Setting
from omote.stage_data.playing_cast import manifest_of
from omote.stage_data.pose_parser import parse_pose, pose_of
from tools.same.authoring import numbers_of
from tools.same.recording import Recording
from tools.same.show_link import own_contents, own_troupe

EVERY_COMPOUND = 6
"""Of how many expressions of a face one compound document is recorded."""
SCENES = {"kaori": "performed", "dog": "smile,jawOpen,eyeBlinkLeft,eyeLookOutLeft"}


def record_documents(recording: Recording) -> None:
    """Manifest, assets of faces and hair, compounds, tangents, handles, the greeting of editors."""
    cast = load_cast()
    bench = OrderWorker(load_cast())
    made = documents(cast, load_meshes(), mask="/assets/mask")
    recording.data("documents", "digest", cast.digest.encode())
    recording.data("documents", "manifest", encode(made.manifest))
    recording.data("documents", "mask", load_mask())
    for url, asset in {**made.faces, **made.hair}.items():
        recording.data("documents", url, encode(asset))
    recording.data("documents", "handles", bench.make(encode(HandlesOrder())))
    recording.data("documents", "greeting", encode_editing(bench.welcome))
    recording.data("documents", "net", encode(bench.runner.net_document(bench.net)))
    for row, face in enumerate(cast.faces):
        recording.data("documents: tangents", face, bench.make(encode(TangentsOrder(face, {}))))
        for name in [*cast.expressions][row % EVERY_COMPOUND :: EVERY_COMPOUND]:
            recording.data("documents: compounds", f"{face} {name}", bench.make(encode(CompoundOrder(face, name, {}))))
    _record_own(recording, bench)
    manifest = manifest_of(own_troupe(cast), made.manifest, {})
    recording.data("documents", "manifest with an own expression", encode(manifest))


def _record_own(recording: Recording, bench: OrderWorker) -> None:
    """Documents of own things, by the keys of their contents."""
    contents = own_contents(bench.cast)
    smile, face = contents
    recording.data("documents: own", "keys", repr([*contents]).encode())
    asset = bench.make(encode(FaceOrder(face, contents)))
    recording.data("documents: own", "face", asset)
    document = msgspec.msgpack.decode(asset, type=ContentAsset).face
    troupe = own_troupe(bench.cast)
    manifest = manifest_of(troupe, documents(bench.cast, load_meshes(), mask="").manifest, {face: document})
    recording.data("documents: own", "manifest", encode(manifest))
    for pair in ((KEY + face, KEY + smile), (KEY + face, "jawOpen"), ("kaori", KEY + smile)):
        recording.data("documents: own", " ".join(pair), bench.make(encode(CompoundOrder(*pair, contents))))
    recording.numbers("documents: own", "expression read", *numbers_of(unpack_expression(contents[smile])))
    recording.numbers("documents: own", "face read", unpack_face(contents[face], "own")[0].positions)
    for key, pair in {"no face": ("nobody", "smile"), "a face as expression": ("kaori", KEY + face)}.items():
        with recording.refusal("documents: refused", key):
            bench.make(encode(CompoundOrder(*pair, contents)))


def record_scenes(recording: Recording) -> None:
    """GLB files, and what becomes of them when they are read again."""
    cast = load_cast()
    meshes = load_meshes()
    bench = ExportContext(cast, meshes, load_mask())
    for face, words in SCENES.items():
        poses = [(name, named_compound_meshes(cast, face, name)) for name in choose_expressions(cast, words)]
        data = glb_bytes(build_scene(bench, face, poses))
        recording.data("GLB", face, data)
        _record_import(recording, face, read_glb(data))
    _record_words(recording)


def _record_words(recording: Recording) -> None:
    """Poses in words, and what is refused where nobody is connected."""
    cast = load_cast()
    rest = ((0.0, 0.0, 1.0),) * 3
    words = {
        "pose": ("kaori=0.6+dog=0.4", "smile=0.5+laugh=0.5", "jawOpen=0.3", "12,-4", "8"),
        "no face": ("x", "smile", "", "", ""),
        "no sum": ("kaori=0.6+dog=0.6", "smile", "", "", ""),
        "no angle": ("kaori", "smile", "", "far", ""),
    }
    for key, (face, expression, channels, turn, gaze) in words.items():
        with recording.refusal("poses: refused", key):
            frame = parse_pose(cast, face=face, expression=expression, channel=channels, turn=turn, gaze=gaze)
            recording.data("poses", key, msgspec.json.encode(pose_of(cast, frame)))
    recipes = {"two points": Recipe((1, 2), rest[:2]), "no ground": Recipe(default_net(cast.space)[:3], rest, "#x")}
    for key, recipe in recipes.items():
        with recording.refusal("recipes: refused", key):
            compose_expression(cast.space, recipe, cast.expressions)
    with recording.refusal("pictures: refused", "huge"):
        Setting(10**6, 1)


def _record_import(recording: Recording, face: str, pieces: tuple[Piece, ...]) -> None:
    cast = load_cast()
    meshes = load_meshes()
    for place, piece in enumerate(pieces):
        moves = [piece.moves[name] for name in piece.moves]
        recording.numbers("GLB read", f"{face} {place} {piece.name}", piece.points, *moves, every=97)
    found, look = import_face(cast, meshes, "again", pieces)
    recording.numbers("GLB imported", f"{face} face", found.positions)
    recording.data("GLB imported", f"{face} look", repr(vars(look)).encode())
    for each in import_expressions(cast, meshes, {"file": pieces}):
        recording.numbers("GLB imported", f"{face} {each.label}", *numbers_of(each.expression), each.error, every=97)
