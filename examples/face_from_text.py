"""Makes a face from a text file (a sculpt): nineteen lines of TOML, and it wears every expression.

For artists who want faces under version control; docs/sculpts.md explains the format.
Run: python examples/face_from_text.py [FOLDER]     writes FOLDER/elf.toml and FOLDER/elf_smile.obj
"""

import sys
from pathlib import Path

import numpy as np

import omote

out = Path(sys.argv[1] if len(sys.argv) > 1 else "out")
out.mkdir(parents=True, exist_ok=True)

ELF = """
name = "elf"
unit = "mm"

[base]
child = 0.4                # two fifths of the way to the child first

[points]                   # where a point of the generic head is, and by how much it goes; mirrored to the other side
"nose tip"      = { at = [0, -35, 168], by = [0, 6, 8] }
"chin"          = { at = [0, -100, 148], by = [0, -9, 2] }
"cheekbone"     = { at = [56, -18, 112], by = [3, 5, 2] }
"ear top"       = { at = [76, 22, 42], by = [10, 30, -6] }
"ear lobe"      = { at = [73, -46, 58] }
"brow outer"    = { at = [48, 22, 128], by = [2, 6, 0] }
"crown"         = { at = [0, 121, 40] }
"skull back"    = { at = [0, 20, -39] }
"skull side"    = { at = [64, 80, 40] }
"neck front"    = { at = [0, -125, 74] }
"neck back"     = { at = [0, -134, -23] }
"""

text = out / "elf.toml"
text.write_text(ELF)

cast = omote.load_cast()
sculpt = omote.read_sculpt(text)
elf = omote.sculpted(cast.space, sculpt, cast.faces)
cast = cast.with_faces(elf, looks={"elf": sculpt.look})  # from here on it plays like any other face

smiling = omote.compound(cast.space, cast.faces["elf"], cast.expressions["smile"])
away = 1000 * np.linalg.norm(elf.positions - cast.faces["generic"].positions, axis=1)
print(f"{len(sculpt.points)} control points; the elf is up to {away.max():.0f} mm from the generic face")
print("it smiles by", f"{1000 * np.linalg.norm(smiling - elf.positions, axis=1).max():.1f} mm")

with (out / "elf_smile.obj").open("w") as file:
    file.writelines(f"v {x:.6f} {y:.6f} {z:.6f}\n" for x, y, z in smiling)
    file.writelines(f"f {a} {b} {c}\n" for a, b, c in cast.space.triangles + 1)
