"""Entries that say where a figure comes from, and the documents they name."""

GRANDE = (
    'K. Grande, "Prediction of slamming occurrence of catamarans", MSc thesis, '
    "Curtin University of Technology, 2002"
)
CHUANG = (
    'S.-L. Chuang, J. T. Birmingham and A. J. Furio, "Experimental investigation of catamaran '
    'cross-structure slamming", Naval Ship Research and Development Center, report 4653, 1975'
)
COUSER = (
    'P. R. Couser, "An investigation into the performance of high-speed catamarans in calm water and waves", '
    "PhD thesis, University of Southampton, 1996"
)
AMIN = (
    'W. Amin, M. R. Davis, G. A. Thomas and D. S. Holloway, "Slamming quasi-static analysis of an Incat 98-m '
    'high-speed wave piercing catamaran", University of Tasmania and Australian Maritime College'
)
BAGGUS = (
    'K. R. Baggus, "Dynamic response to wet deck slamming: a fast numerical method for a heavy-lift '
    'catamaran in head seas", MSc thesis, Delft University of Technology, 2025'
)
VEER = (
    "R. van 't Veer, \"Experimental results of motions, hydrodynamic coefficients and wave loads on the 372 "
    'catamaran model", Delft University of Technology, Ship Hydromechanics Laboratory, report 1129, 1998'
)
VEER_BASIN = (
    "R. van 't Veer, Delft University of Technology, Ship Hydromechanics Laboratory, report 1130, 1998"
)

Entry = tuple[str, str, str, str]


def published(quantity: str, value: str, source: str) -> Entry:
    """Return the entry of a figure that stands in the source."""
    return quantity, value, source, "published"


def derived(quantity: str, value: str, source: str) -> Entry:
    """Return the entry of a figure that follows from published ones."""
    return quantity, value, source, "derived"


def ours(quantity: str, value: str, reason: str) -> Entry:
    """Return the entry of a figure that we chose, with the reason."""
    return quantity, value, reason, "ours"
