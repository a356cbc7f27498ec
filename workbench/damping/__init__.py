"""Forces beside those of the hull in potential flow: sails, foils and fins, drag across the hull, roll damping."""
