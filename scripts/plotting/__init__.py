"""Pictures of runs of mpm_granular."""
