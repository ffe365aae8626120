"""Series of runs: running the program, orders of convergence, tables."""
