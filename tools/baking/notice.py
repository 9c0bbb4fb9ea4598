"""The notice that travels with the cast."""

from __future__ import annotations

from tools.baking.package import REQUIREMENT, SHA256, Package

LICENCE = "mpfb2/LICENSE.md"
OPENING = f"""# Where the built-in cast comes from

`cast.npz` is computed from files that were released under CC0 1.0 Universal (public domain dedication):

* the MakeHuman base mesh, its shape targets and its expression units (makehumancommunity.org, MPFB2);
* the 52 face units of the "Face units" asset pack by Mika Suominen (makehumancommunity.org), which carry no licence
  file of their own: the package's metadata states that they are CC0.

They were read from the package `{REQUIREMENT}` (SHA-256 of its wheel: `{SHA256}`), whose own code
(Apache 2.0, NAVER Corp.) is neither used nor contained here. `mask.png` was painted by Omote's own code. The text that
accompanies the files in the package follows.

---

"""


def notice(package: Package) -> bytes:
    """The notice with the package's own CC0 text, as Markdown."""
    return (OPENING + package.text(LICENCE).strip() + "\n").encode()
