"""The work on a project: find it, bring its generated files up to date, tell what is in it."""
