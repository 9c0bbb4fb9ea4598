"""Levels of DMX512 that lighting desks send by network, without input or output."""
