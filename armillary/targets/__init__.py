"""Printers: what a program looks like in each language."""
