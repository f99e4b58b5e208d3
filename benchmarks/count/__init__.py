"""Counting by running: a kernel is compiled with a scalar that tallies what is done to it."""

from benchmarks.count.count import CountError, Counts, Run, count_c_source, run_source

__all__ = ["CountError", "Counts", "Run", "count_c_source", "run_source"]
