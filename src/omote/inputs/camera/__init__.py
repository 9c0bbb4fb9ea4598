"""The performer's face from a camera: landmarks in, weights, head and gaze out."""
