"""Makes what faces from photographs are fitted by: what a landmark model says of heads whose shape is known."""
