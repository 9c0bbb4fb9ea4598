"""Makes what the camera's tracker learns from: pictures of people of ours, and the landmarks that a model finds."""
