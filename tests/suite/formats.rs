//! Real files of every format.
