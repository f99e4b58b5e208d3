"""The site: a page for each derivation, the figures on it, and the theme."""
