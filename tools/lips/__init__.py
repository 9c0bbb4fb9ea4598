"""Training of the network that reads visemes."""
