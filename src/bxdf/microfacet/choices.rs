//! Which choices of the models of a rough interface have loops of their own.

/// `$made` with `$normals` and `$interface` the distribution and the interface in `$params`: compiled by itself for each
/// common choice, so that its loops carry none, and once for all rare ones. Common are in f32 exact interfaces of any
/// distribution and approximate ones of GGX; in f64, where functions stay calls, an exact one of GGX; in a precision `$real`
/// without wide registers, none.
macro_rules! with_choices {
    ($real:ty, $params:expr, |$normals:ident, $interface:ident| $made:expr) => {{
        use $crate::microfacet::Distribution;
        use $crate::optics::interface::AnyInterface;
        let $normals = Distribution::<$real>::from_params($params);
        let $interface = AnyInterface::<$real>::from_params($params);
        // Conditions on constants of the precision alone: what they exclude is not compiled.
        if <$real>::VECTORISES {
            if let (Distribution::Ggx($normals), AnyInterface::Exact($interface)) =
                ($normals, $interface)
            {
                return $made;
            }
        }
        if <$real>::FUNCTIONS_VECTORISE {
            match ($normals, $interface) {
                (Distribution::Ggx($normals), AnyInterface::Approximate($interface)) => {
                    return $made;
                }
                (Distribution::Beckmann($normals), AnyInterface::Exact($interface)) => {
                    return $made;
                }
                (Distribution::BeckmannRational($normals), AnyInterface::Exact($interface)) => {
                    return $made;
                }
                _ => {}
            }
        }
        $made
    }};
}

pub(crate) use with_choices;
