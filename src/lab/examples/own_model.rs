//! A model of one's own, known by its text and put through the laws: `cargo run -p bxdf-lab --example own_model`.

use bxdf::math::warp;
use bxdf::{
    Bxdf, Catalogue, Category, Lobe, Lobes, Material, ModelSpec, ParamSet, ParamSpec, Properties,
    Real, Result, Sample, Scatterer, Spectrum, Vec3, both_above, builders, sample_reflection,
};
use bxdf_lab::contract::{Effort, check};

/// What Minnaert wrote down for the moon (Minnaert 1941, "The Reciprocity Principle in Lunar Photometry"): a diffuse surface
/// whose value goes with (mu_o mu_i)^(k - 1), scaled so that light along the normal comes back by the albedo.
static MINNAERT: ModelSpec = ModelSpec {
    id: "minnaert",
    title: "Minnaert",
    source: "Minnaert 1941",
    summary: "Darker towards the horizon the larger k is",
    lobes: &[Lobe::reflection(Category::Diffuse)],
    parameters: &[
        ParamSpec::rgb(
            "albedo",
            [0.5; 3],
            "Share of the light along the normal that comes back",
        ),
        ParamSpec::number("k", 1.5, "Exponent; Lambert's surface at 1").hard(1.0, 4.0),
    ],
    properties: Properties::PLAIN,
    validate: ModelSpec::any,
    builders: builders!(build),
    stand_ins: &[],
};

struct Minnaert<R> {
    /// Of f, in 1/sr.
    scale: Spectrum<R>,
    exponent: R,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    let k = R::of(params.number("k"));
    let scale = (k + R::one()) * R::of(0.5) * R::frac_1_pi();
    Box::new(Minnaert {
        scale: Spectrum::of(params.rgb("albedo")) * scale,
        exponent: k - R::one(),
    })
}

impl<R: Real> Bxdf<R> for Minnaert<R> {
    fn f(&self, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        let Some((wo, wi)) = both_above(wo, wi) else {
            return Spectrum::black();
        };
        // Each by itself: the product of two grazing cosines would underflow, as the law of non-negativity told.
        self.scale * (wo.z.powf(self.exponent) * wi.z.powf(self.exponent))
    }

    fn pdf(&self, wo: Vec3<R>, wi: Vec3<R>) -> R {
        both_above(wo, wi).map_or(R::zero(), |(_, wi)| warp::cosine_hemisphere_pdf(wi.z))
    }

    fn sample_f(&self, wo: Vec3<R>, _uc: R, u: [R; 2]) -> Option<Sample<R>> {
        sample_reflection(self, wo, |_| Some(warp::cosine_hemisphere(u)))
    }
}

impl<R: Real> Lobes<R> for Minnaert<R> {
    fn lobes(&self) -> &[Lobe] {
        MINNAERT.lobes
    }
}

impl<R: Real> Scatterer<R> for Minnaert<R> {}

fn main() -> Result<()> {
    // Before anything else: from here on texts, lists and laws know it.
    Catalogue::default().with(&MINNAERT)?.install()?;
    let moon: Material = "minnaert:albedo=0.12,k=1.3".parse()?;
    let up = Vec3::new(0.0, 0.0, 1.0);
    println!(
        "{}: f along the normal {:?}",
        moon.title(),
        moon.build::<f64>().f(up, up).to_f64()
    );
    for report in check(&MINNAERT, Effort::Quick) {
        println!(
            "{:24} {:?}, worst {:.1e}",
            report.law.title(),
            report.status,
            report.worst
        );
    }
    Ok(())
}

#[test]
fn the_model_from_outside_keeps_every_law() {
    use bxdf_lab::contract::Status;

    main().unwrap();
    for report in check(&MINNAERT, Effort::Quick) {
        assert!(
            !matches!(report.status, Status::Violated | Status::Misdeclared),
            "{}: {:?}",
            report.law.title(),
            report.worst
        );
    }
    // It takes part in whatever lists or names models.
    assert!(
        Catalogue::current()
            .models()
            .iter()
            .any(|model| model.id == "minnaert")
    );
    let refused = "minnaert:k=5".parse::<Material>().unwrap_err().to_string();
    assert!(refused.contains("minnaert: k = 5"), "{refused}");
    let unknown = "minaert".parse::<Material>().unwrap_err().to_string();
    assert!(unknown.contains("minnaert"), "{unknown}");
}
