//! One made-up drive in the language of each compiler.

pub mod profile;
pub mod svd;
pub mod zencan;
