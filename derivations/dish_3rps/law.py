"""The exported control law, its compiled C called over and over on the same memory."""

import numpy as np

STATES = ("integral", "v", "l_before")
SIGNALS = ("l_ref", "l_dot_ref", "l_measured", "F_ff")


class Law:
    """The law for a batch of rods.

    Args:
        native: the compiled kernels of the dish.
        law: its parameters, each broadcastable to the batch.
        batch: shape of the batch.
    """

    def __init__(self, native, law, batch):
        zeros = {name: np.zeros(batch) for name in (*STATES, *SIGNALS)}
        call = native.rod_control_update.prepare(**law, **zeros)
        self.states = [call.inputs[name] for name in STATES]
        self.signals = [call.inputs[name] for name in SIGNALS]
        self.begin = native.rod_control_init
        self.run, self.force = call.run, call.results.F_drive

    def start(self, measured, force=0.0):
        """From rest, with a force that the integral begins with."""
        begun = self.begin(l_measured=measured, F_start=force)
        for state, name in zip(self.states, STATES, strict=True):
            state[...] = getattr(begun, name)

    def __call__(self, wanted, rate, measured, ahead):
        """The forces for a sampling period; the array is written anew by the next call."""
        l_ref, l_dot_ref, l_measured, known = self.signals
        l_ref[...], l_dot_ref[...], l_measured[...], known[...] = wanted, rate, measured, ahead
        self.run()
        return self.force
