"""Checks: identities, independent engines, dual numbers, and every target against the evaluator."""
