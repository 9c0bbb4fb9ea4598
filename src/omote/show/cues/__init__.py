"""The cue lists of a show: their cues with the history of their edits, and how far each is played."""
