//! The real program, killed and fed with nonsense.
