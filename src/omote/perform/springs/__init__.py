"""Springs: what hangs and shakes of a face, driven by the head's motion above all layers."""
