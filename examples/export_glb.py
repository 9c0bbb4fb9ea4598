"""Writes a face as GLB with the 52 ARKit blendshapes as named morph targets, and reads the file back.

For people of Blender, three.js, Unity, Unreal, VRM: what a tracker sends by ARKit names moves this head.
Run: python examples/export_glb.py [FOLDER]         writes FOLDER/child.glb

The same from a shell: omote export child -o child.glb
"""

import sys
from pathlib import Path

import numpy as np

import omote
from omote.builtin import load_mask, load_meshes
from omote.interchange.export_face import ExportContext, build_scene, choose_expressions, named_compound_meshes
from omote.interchange.formats.glb_reader import read_glb
from omote.interchange.formats.glb_writer import glb_bytes

out = Path(sys.argv[1] if len(sys.argv) > 1 else "out")
out.mkdir(parents=True, exist_ok=True)

FACE = "child"
cast = omote.load_cast()
names = choose_expressions(cast, "arkit")  # kinds or names, by commas: "arkit,smile"
bench = ExportContext(cast, load_meshes(), load_mask())
scene = build_scene(bench, FACE, ((name, named_compound_meshes(cast, FACE, name)) for name in names))
path = out / f"{FACE}.glb"
path.write_bytes(glb_bytes(scene))

pieces = {piece.name: piece for piece in read_glb(path.read_bytes())}
skin = pieces["skin"]
print(f"{path}: {path.stat().st_size / 1e6:.1f} MB; meshes {', '.join(pieces)}; {len(skin.moves)} morph targets")

# What was written is what Omote plays: the worst vertex of each shape, in micrometres.
assert skin.rows is not None  # which vertex of the cast each one is; seams of the texture double some
face = cast.faces[FACE]
worst = {}
for name, moves in skin.moves.items():
    played = omote.compound(cast.space, face, cast.expressions[name])[skin.rows]
    worst[name] = 1e6 * float(np.abs(skin.points + moves - played).max())
name = max(worst, key=lambda each: worst[each])
print(f"read back: at most {worst[name]:.2f} micrometres from the stage's own positions ({name})")
