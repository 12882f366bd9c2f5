//! `simulate`: a virtual drive of any profile, commanded by a script.

mod script;
mod words;
