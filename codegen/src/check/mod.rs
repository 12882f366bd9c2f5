//! Lints: findings on a resolved model.
