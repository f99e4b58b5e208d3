"""Typed structural expressions: what a derivation is made of."""
