"""Three-dimensional pictures of a simulation: one scene description, two painters.

`description` makes the scene (an `xarray.Dataset`), `sea_view` plays it in the
browser, `standalone` writes it as one HTML file, `stills` paints pictures and
films without a browser. No painter computes physics.
"""
