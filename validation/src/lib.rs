//! Scenes, runs, checks and reports around the kernel.
