"""Connections to VTube Studio on computers."""
