"""The audit: what a paper prints, compared with what is derived, verdict by verdict.

`audit.audit(paper)` gives the findings; `verdict` holds what they are made of. A print and what it
claims are `sides`, compared at the points of a `compare.Bench`. What does not hold is explained by
the smallest of: a change of one entry (`repairs`, of those that `changes` lists), of the whole, or
of what it claims (`wholes`, `claims`), or by a value at which it does hold (`special`).
"""
