"""The documentation site: pages made from the code, and the hook by which mkdocs takes them in."""
