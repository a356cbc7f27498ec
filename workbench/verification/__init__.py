"""Verification: cases with a known answer, run by ``workbench verify`` and by the tests."""
