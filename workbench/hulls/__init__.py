"""Hull forms: parametric families, tables of offsets, panel meshes, and the library of published vessels."""
