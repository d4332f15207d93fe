// Holds a precompiled header for the targets that share it.
