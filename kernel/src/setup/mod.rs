//! Initial states, thesis sections 3.7.2-3.7.6.
