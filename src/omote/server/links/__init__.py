"""Open WebSocket links of pages and programs, whatever they carry."""
