"""Mutation runs: whether the checks see a wrong sign, function, order or term."""
