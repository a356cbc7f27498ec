"""The tables of names, one a field: what each quantity is called, its unit and its symbol."""
