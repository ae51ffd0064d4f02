"""This process and its neighbours: linear algebra on one thread, private memory, the window watched and rejoined."""
