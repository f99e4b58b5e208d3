"""Runs studies: finds their parts, runs what is not kept, and keeps what was found."""
