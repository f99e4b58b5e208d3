"""Chains of frames and what follows from them."""
