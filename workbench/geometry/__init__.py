"""Geometry of the wetted ship: sections, panels, hydrostatics and the wet deck, from `Hull` to arrays."""
