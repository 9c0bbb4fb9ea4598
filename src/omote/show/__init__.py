"""A show without input or output: messages and a time in, messages and states out; a log of them replays.

A state is complete and absolute: the newest wins, any may be lost.
"""
