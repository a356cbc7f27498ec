"""Published vessels and stand-ins for them, each figure with where it comes from."""
