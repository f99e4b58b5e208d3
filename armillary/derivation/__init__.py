"""The record: quantities, definitions, identities, kernels."""
