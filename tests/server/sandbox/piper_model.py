"""A model that takes and gives what one of Piper does: each sign a tone of a length and a loudness that are known."""

from __future__ import annotations

from pathlib import Path

import msgspec
import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper

RATE = 16000
FRAME = 256
"""Samples of the sound to one of the lengths that a model computes."""
SIGNS = {"_": [0], "^": [1], "$": [2], " ": [3], ".": [4], "m": [5], "a": [6], "p": [7], "o": [8]}
FRAMES = np.array([1, 3, 3, 2, 9, 4, 6, 4, 6], np.float32)
LOUD = np.array([1, 0, 0, 1, 0, 1, 1, 0, 1], np.float32)


def write_model(folder: Path, name: str = "xx-tone", *, tells: bool = True, speakers: int = 1) -> Path:
    """Writes a model and its settings; tells: whether the lengths of its signs are found in it; speakers: of whom each
    is so many times slower."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"{name}.onnx"
    inputs = [
        helper.make_tensor_value_info("input", TensorProto.INT64, [1, None]),
        helper.make_tensor_value_info("input_lengths", TensorProto.INT64, [1]),
        helper.make_tensor_value_info("scales", TensorProto.FLOAT, [3]),
    ]
    if speakers > 1:
        inputs.append(helper.make_tensor_value_info("sid", TensorProto.INT64, [1]))
    output = helper.make_tensor_value_info("output", TensorProto.FLOAT, [1, 1, 1, None])
    graph = helper.make_graph(_nodes(tells, speakers), "tone", inputs, [output], _constants())
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 13)], ir_version=8)
    onnx.checker.check_model(model)
    path.write_bytes(model.SerializeToString())
    path.with_name(path.name + ".json").write_bytes(msgspec.json.encode(_settings(speakers)))
    return path


def _settings(speakers: int) -> dict[str, object]:
    return {
        "audio": {"sample_rate": RATE, "quality": "low"},
        "espeak": {"voice": "en-us"},
        "phoneme_type": "text",
        "phoneme_id_map": SIGNS,
        "num_symbols": len(SIGNS),
        "num_speakers": speakers,
        "speaker_id_map": {f"speaker {number}": number for number in range(speakers)} if speakers > 1 else {},
        "language": {"name_english": "English", "country_english": "Nowhere"},
        "dataset": "tone",
    }


def _constants() -> list[onnx.TensorProto]:
    numbers = {
        "frames": FRAMES, "loud": LOUD, "second": np.array([1]), "frame": np.float32(FRAME), "axis": np.array(1),
        "columns": np.array([1]), "rows": np.array([0]), "zero": np.float32(0.0), "one": np.float32(1.0),
        "two": np.float32(2.0), "shape": np.array([1, 1, 1, -1]), "flat": np.array([-1]),
    }  # fmt: skip
    return [numpy_helper.from_array(np.asarray(value), name) for name, value in numbers.items()]


def _nodes(tells: bool, speakers: int) -> list[onnx.NodeProto]:
    """The graph: lengths of signs, the sign at each sample, and a square wave as loud as it."""
    node = helper.make_node
    slow = "slow" if speakers > 1 else "one"
    speaker = [
        node("Cast", ["sid"], ["speaker"], to=TensorProto.FLOAT),
        node("Add", ["speaker", "one"], ["slow"]),
    ]
    return [
        *(speaker if speakers > 1 else []),
        node("Gather", ["frames", "input"], ["usual"]),
        node("Gather", ["scales", "second"], ["scale"]),
        node("Mul", ["usual", "scale"], ["scaled"]),
        node("Mul", ["scaled", slow], ["wanted"]),
        node("Ceil" if tells else "Round", ["wanted"], ["lengths"]),
        node("Mul", ["lengths", "frame"], ["samples"]),
        node("CumSum", ["samples", "axis"], ["ends"]),
        node("ReduceMax", ["ends"], ["count"], keepdims=0),
        node("Range", ["zero", "count", "one"], ["time"]),
        node("Unsqueeze", ["time", "columns"], ["column"]),
        node("GreaterOrEqual", ["column", "ends"], ["over"]),
        node("Cast", ["over"], ["passed"], to=TensorProto.INT64),
        node("ReduceSum", ["passed", "columns"], ["place"], keepdims=0),
        node("Gather", ["loud", "input"], ["levels"]),
        node("Reshape", ["levels", "flat"], ["row"]),
        node("Gather", ["row", "place"], ["level"]),
        node("Mod", ["time", "two"], ["odd"], fmod=1),
        node("Mul", ["odd", "two"], ["twice"]),
        node("Sub", ["one", "twice"], ["wave"]),
        node("Mul", ["level", "wave"], ["tone"]),
        node("Reshape", ["tone", "shape"], ["output"]),
    ]
