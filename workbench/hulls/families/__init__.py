"""Mathematical and tabulated surfaces of one hull, each as `Lines` about the hull's own centre plane."""
