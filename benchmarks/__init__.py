"""Operation counts of generated kernels, compared between code generators.

`python -m benchmarks` rewrites `RESULTS.md` and `results.json`. One text-book recipe per kernel is
given to every tool; the code a tool prints is compiled with a scalar that counts, and its values
are compared with a reference that shares nothing with the recipe.
"""
