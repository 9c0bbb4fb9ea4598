"""A running show for agents: its commands as tools of the Model Context Protocol."""
