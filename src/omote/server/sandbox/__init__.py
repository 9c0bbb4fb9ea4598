"""Parses untrusted files in a child process with limits on CPU, memory and descriptors."""
