//! Factors that follow time.
