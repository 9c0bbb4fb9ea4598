"""A browser with devices: MIDI (a fake of the standard's interface) and a gamepad."""

from __future__ import annotations

from pathlib import Path

from playwright.sync_api import Page

from tests.browser.waiting import wait_until

FAKE_MIDI = Path(__file__).parents[2] / "web" / "node_modules" / "web-midi-test" / "wmt.js"
# Chromium without a window refuses Web MIDI, also where it is granted.
DEVICES = """
navigator.requestMIDIAccess = WMT.requestMIDIAccess;
window.dial = new WMT.MidiSrc("Dial");
window.other = new WMT.MidiSrc("Other dial");
window.pad = {
    id: "Pad (STANDARD GAMEPAD Vendor: aaaa Product: bbbb)", index: 0, connected: true, mapping: "", axes: [0, 0],
    buttons: [{ value: 0, pressed: false }],
};
window.pads = [];
navigator.getGamepads = () => pads;
"""
DEVICE_STORE = "document.querySelector('omote-console, omote-devices-page').context.devices"
TURN = "(values) => { for (const value of values) dial.emit([0xb0, 7, value]); }"


def connect(page: Page) -> None:
    """Plugs the dial in, and waits until the show hears it from here: the page before may not have let it go yet."""
    page.evaluate("dial.connect()")
    dial = f"{DEVICE_STORE}.devices.find(({{ name }}) => name === 'Dial')"
    wait_until(page, f"(dial.emit([0xb0, 7, 1]), dial.emit([0xb0, 7, 0]), {dial}?.values['1/cc7'] === 0)", told=dial)
