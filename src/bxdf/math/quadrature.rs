//! Fixed quadrature rules.

use gauss_quad::legendre::GaussLegendre;

/// The Gauss-Legendre rule of -1..1 with `nodes` nodes, as (node, weight).
#[must_use]
pub fn gauss_legendre(nodes: usize) -> Vec<(f64, f64)> {
    let degree = std::num::NonZeroUsize::new(nodes).unwrap_or(std::num::NonZeroUsize::MIN);
    let rule = GaussLegendre::new(degree);
    rule.as_node_weight_pairs()
        .iter()
        .map(|pair| (pair.0, pair.1))
        .collect()
}
