"""Hydrodynamic coefficients and wave loads: from wetted panels to added mass, damping and excitation."""
