"""A browser for tests that only speaks DevTools: a program that answers every call in the way its script says."""

from __future__ import annotations

import stat
import sys
from pathlib import Path

ANSWERS = """
def answer(method, parameters):
    if method == "Runtime.evaluate" and "heet(" in parameters["expression"]:
        return {"result": {"value": "cGljdHVyZQ=="}}
    if method == "Runtime.evaluate":
        return {"result": {"value": True}}
    return {"targetId": "t", "sessionId": "s", "method": method, "parameters": parameters}
"""
LOOP = """
heard = b""
while part := os.read(3, 65536):
    heard += part
    while b"\\0" in heard:
        message, heard = heard.split(b"\\0", 1)
        call = json.loads(message)
        result = answer(call["method"], call["params"])
        said = {"error": {"message": result}} if isinstance(result, str) else {"result": result}
        said["id"] = call["id"]
        os.write(4, json.dumps(said).encode() + b"\\0")
"""


def false_browser(folder: Path, answers: str = ANSWERS, loop: str = LOOP) -> Path:
    """The path of the program; `answers` defines `answer(method, parameters)`: a result, or a refusal as a text."""
    path = folder / "chromium"
    note = f"open({str(folder / 'arguments')!r}, 'w').write('\\n'.join(sys.argv[1:]))\n"
    path.write_text(f"#!{sys.executable}\nimport json, os, sys\n{note}{answers}{loop}")
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return path
