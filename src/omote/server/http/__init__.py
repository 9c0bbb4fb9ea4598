"""The web server: pages, documents, the link of consoles and stages, the link of editors."""
