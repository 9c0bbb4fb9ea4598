"""Who gets in: tokens, cookies, certificates."""
