"""Types of arrays, named once for every module.

References: `numpy.typing.NDArray`; shapes and units stand in the docstrings of the functions that take them.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Values = NDArray[np.float64]
"""Numbers in double precision: what is computed."""
Points = NDArray[np.float64]
"""Positions (n, 3), metres."""
Floats = NDArray[np.float32]
"""Numbers in single precision: what is kept, sent and drawn."""
Indices = NDArray[np.int32]
"""Numbers of vertices, triangles or patches, as files and graphics processors take them."""
Triangles = NDArray[np.int32]
"""Numbers of vertices by triangle (t, 3)."""
Rows = NDArray[np.intp]
"""Rows of an array, as numpy counts them."""
Mask = NDArray[np.bool_]
"""True where something holds."""
Picture = NDArray[np.uint8]
"""Pixels by row and column, 0 to 255."""
