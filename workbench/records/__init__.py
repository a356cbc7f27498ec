"""Records of measurements and simulations: read, cleaned, and turned into spectra, responses and slams."""
