"""The editing session: requests, drafts, saving, items."""
