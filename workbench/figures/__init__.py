"""Figures: Datasets in, matplotlib `Figure` out, one module per question asked; nothing is computed here."""
