"""The verification cases, each a module with TITLE and verify(suite)."""
