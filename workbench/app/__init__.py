"""The app: a model of traits, jobs, panels that only link, and the page that holds them."""
