//! The chance of a false alarm.

/// Chance of a false alarm in a whole run over one model.
const SIGNIFICANCE: f64 = 1e-3;

/// The largest p-value that counts as a failure among `tests` independent ones (Sidak 1967): with it, the chance that
/// any of them fails by chance is [`SIGNIFICANCE`].
pub(super) fn sidak(tests: usize) -> f64 {
    // 1 - (1 - a)^(1/n), without cancellation.
    -((-SIGNIFICANCE).ln_1p() / tests.max(1) as f64).exp_m1()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_tests_share_one_chance_of_a_false_alarm() {
        assert!((sidak(1) - SIGNIFICANCE).abs() < 1e-15);
        assert!((1.0 - (1.0 - sidak(100)).powi(100) - SIGNIFICANCE).abs() < 1e-12);
    }
}
