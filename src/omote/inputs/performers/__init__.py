"""Performers before a camera: who they are, how their faces are read, and whom they play."""
