"""The straight-line program: lowering, passes, cost, evaluation."""
