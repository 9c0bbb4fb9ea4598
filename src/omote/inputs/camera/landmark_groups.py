"""Points of MediaPipe's face mesh by what they lie on. Left and right are the performer's own."""

from __future__ import annotations

import numpy as np

from omote.arrays import Rows


def _rows(text: str) -> Rows:
    return np.array(text.split(), np.intp)


LIDS = {
    "Left": (_rows("398 384 385 386 387 388 466"), _rows("382 381 380 374 373 390 249")),
    "Right": (_rows("173 157 158 159 160 161 246"), _rows("155 154 153 145 144 163 7")),
}
"""Points of the upper lid's edge, and those of the lower lid's below them, from the inner to the outer corner."""
CORNERS = {"Left": (362, 263), "Right": (133, 33)}
"""Inner and outer corner of each eye."""
IRISES = {"Left": _rows("473 474 475 476 477"), "Right": _rows("468 469 470 471 472")}
"""Middle of the iris, then four points of its edge."""
MOUTH_CORNERS = (308, 78)
"""Of the inner lips, left and right."""
LIPS_APART = ((13, 14), (312, 317), (82, 87), (311, 402), (81, 178))
"""Points of the inner upper lip, and those of the lower below them."""
BROWS = {"Left": _rows("276 283 282 295 285 300 293 334 296 336"), "Right": _rows("46 53 52 65 55 70 63 105 66 107")}
STEADY = _rows(
    "6 197 195 5 4 1 168 8 9 151 10 109 338 67 297 103 332 54 284 21 251 162 389 127 356 234 454 93 323 "
    "33 133 362 263 122 351 193 417 245 465 188 412 174 399 196 419 3 248 51 281 45 275 98 327 97 326 2"
)
"""Points that expressions move least: forehead, temples, nose, corners of the eyes."""
