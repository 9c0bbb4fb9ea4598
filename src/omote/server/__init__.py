"""The only sockets, threads, processes and clocks."""
