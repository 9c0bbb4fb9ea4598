"""What stages fetch or draw: documents of the playing cast, poses, picture grids."""
