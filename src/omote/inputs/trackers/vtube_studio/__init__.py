"""The public API of VTube Studio on a computer."""
