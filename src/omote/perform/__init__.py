"""The live engine: state, commands and time in, state out."""
