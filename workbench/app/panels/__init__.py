"""The tabs of the page, one module each; a panel builds its widgets when first shown, and only links."""
