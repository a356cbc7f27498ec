"""Motions in time: from the linear response, and with the water forces of the hull as it really lies in the wave."""
