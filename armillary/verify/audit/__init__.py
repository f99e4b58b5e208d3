"""The audit: what a paper prints, compared with what is derived, verdict by verdict."""
