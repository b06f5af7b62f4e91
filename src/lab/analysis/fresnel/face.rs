//! What one side of a smooth interface reflects of s and p polarised light, and the angles that have names.
//!
//! # Source
//! Born & Wolf, "Principles of Optics", 7th ed., sections 1.5.2 and 14.2 (`born1999`). With A + iB the root of
//! (n - ik)^2 - sin^2, s polarised light reflects ((A - c)^2 + B^2) / ((A + c)^2 + B^2), and p polarised light of that the
//! share ((A c - s^2)^2 + (B c)^2) / ((A c + s^2)^2 + (B c)^2). Schlick 1994, eq. 15; the term of Lazanyi &
//! Szirmay-Kalos 2005 (`lazanyi2005`) as Hoffman 2019 has it (`hoffman2019`).

use bxdf::internals::fresnel;
use bxdf::math::frame;

/// n and k of a medium, n + ik, over the index of the medium on the other side, which is clear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Index {
    /// The real part, 0 or more; with k = 0 above 0.
    pub n: f64,
    /// The imaginary part, 0 or more; 0 for a clear medium.
    pub k: f64,
}

impl Index {
    /// Whether light is absorbed in it, so that there is no other side to look from.
    #[must_use]
    pub fn is_absorbing(self) -> bool {
        self.k > 0.0
    }

    /// Whether there is no interface at all.
    #[must_use]
    pub fn is_matched(self) -> bool {
        self.n == 1.0 && self.k == 0.0
    }

    /// Whether there is such a medium.
    #[must_use]
    pub fn is_medium(self) -> bool {
        self.n > 0.0 || self.k > 0.0
    }
}

/// The shares of light that are reflected, 0..1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reflectances {
    /// Of light whose electric field is perpendicular to the plane of incidence.
    pub s: f64,
    /// Of light whose electric field lies in that plane.
    pub p: f64,
    /// By Schlick's approximation, of unpolarised light.
    pub schlick: f64,
    /// By that with the term of Lazanyi & Szirmay-Kalos.
    pub lazanyi: f64,
}

impl Reflectances {
    /// Of unpolarised light: the mean of both.
    #[must_use]
    pub fn mean(&self) -> f64 {
        0.5 * (self.s + self.p)
    }
}

/// An angle of incidence at which something happens.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// What happens.
    pub kind: MarkKind,
    /// The angle in degrees.
    pub theta_deg: f64,
}

/// What happens at an angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarkKind {
    /// Brewster's angle: no p polarised light is reflected.
    Brewster,
    /// The critical angle: from here on all light is reflected.
    Critical,
    /// The least p polarised light is reflected, by a medium that absorbs.
    LeastP,
}

/// One side of an interface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    /// The index of the far side over that of this side.
    index: Index,
    /// n - 1, which a quotient has lost digits of.
    n_minus_1: f64,
    /// The reflectance at normal incidence.
    f0: f64,
    /// The factor of Lazanyi's term.
    error: f64,
}

impl Face {
    /// The side from which the far side has this `index`.
    #[must_use]
    pub fn new(index: Index) -> Self {
        let Index { n, k } = index;
        let mut face = Self {
            index,
            n_minus_1: n - 1.0,
            f0: ((n - 1.0).hypot(k) / (n + 1.0).hypot(k)).powi(2),
            error: 0.0,
        };
        // The term is fitted on the side from which both approximations are taken.
        let thinner = if face.is_denser_side() {
            face.reversed()
        } else {
            face
        };
        let at = fresnel::lazanyi_cosine::<f64>();
        let [s, p] = thinner.polarised(at, (1.0 - at) * (1.0 + at));
        face.error = fresnel::lazanyi_factor(fresnel::schlick(at, face.f0) - 0.5 * (s + p));
        face
    }

    /// The far side of a clear interface, from which this side has the reciprocal index; both approximations are those of
    /// the interface.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let Index { n, k } = self.index;
        Self {
            index: Index { n: 1.0 / n, k },
            n_minus_1: -self.n_minus_1 / n,
            ..*self
        }
    }

    /// The index of the far side over that of this side.
    #[must_use]
    pub fn index(&self) -> Index {
        self.index
    }

    /// Whether the far side is clear and has the lower index.
    fn is_denser_side(&self) -> bool {
        self.n_minus_1 < 0.0 && !self.index.is_absorbing()
    }

    /// n^2 - k^2 - s^2 by the cosine and the square of the sine: the smaller terms are summed.
    fn root_squared(&self, c: f64, s2: f64) -> f64 {
        let Index { n, k } = self.index;
        if s2 < c * c {
            (n - k) * (n + k) - s2
        } else {
            c * c + self.n_minus_1 * (n + 1.0) - k * k
        }
    }

    /// The reflectances of s and p polarised light.
    fn polarised(&self, c: f64, s2: f64) -> [f64; 2] {
        let Index { n, k } = self.index;
        let re = self.root_squared(c, s2);
        if self.n_minus_1 == 0.0 && k == 0.0 {
            return [0.0; 2];
        }
        if k == 0.0 && re <= 0.0 {
            return [1.0; 2];
        }
        let larger = (0.5 * (re.hypot(2.0 * n * k) + re.abs())).sqrt();
        let smaller = if larger > 0.0 { n * k / larger } else { 0.0 };
        let (a, b) = if re >= 0.0 {
            (larger, smaller)
        } else {
            (smaller, larger)
        };
        let b2 = b * b;
        // A^2 - c^2 in place of A - c, which cancels next to equal indices; a strong absorption needs neither.
        let difference = if k < 1.0 {
            (self.n_minus_1 * (n + 1.0) - k * k + b2) / (a + c)
        } else {
            a - c
        };
        let s = (difference * difference + b2) / ((a + c) * (a + c) + b2);
        let (a_c, b_c) = (a * c, b * c);
        let ratio = (a_c - s2).hypot(b_c) / (a_c + s2).hypot(b_c);
        [s, s * ratio * ratio].map(|share| share.clamp(0.0, 1.0))
    }

    /// The reflectances of light that arrives at `theta_deg` from the normal, 0..90 degrees.
    #[must_use]
    pub fn at(&self, theta_deg: f64) -> Reflectances {
        let (c, sine) = frame::cos_sin_deg(theta_deg);
        let s2 = sine * sine;
        let [s, p] = self.polarised(c, s2);
        if self.n_minus_1 == 0.0 && !self.index.is_absorbing() {
            return Reflectances::default();
        }
        let on_thinner_side = if self.is_denser_side() {
            let squared = self.root_squared(c, s2);
            (squared > 0.0).then(|| (squared.sqrt() / self.index.n).min(1.0))
        } else {
            Some(c)
        };
        let Some(c) = on_thinner_side else {
            return Reflectances {
                s,
                p,
                schlick: 1.0,
                lazanyi: 1.0,
            };
        };
        let schlick = fresnel::schlick(c, self.f0);
        let lazanyi = schlick - self.error * fresnel::lazanyi_term(c);
        Reflectances {
            s,
            p,
            schlick,
            lazanyi: lazanyi.clamp(0.0, 1.0),
        }
    }

    /// The angle of the light that crosses, in degrees from the normal, for light that arrives at `theta_deg`. `None` beyond
    /// the critical angle, and where the index is no real number.
    #[must_use]
    pub fn refracted_deg(&self, theta_deg: f64) -> Option<f64> {
        if self.index.is_absorbing() {
            return None;
        }
        let (c, sine) = frame::cos_sin_deg(theta_deg);
        let squared = self.root_squared(c, sine * sine);
        (squared >= 0.0).then(|| sine.atan2(squared.sqrt()).to_degrees())
    }

    /// The angles at which something happens.
    #[must_use]
    pub fn marks(&self) -> Vec<Mark> {
        let Index { n, .. } = self.index;
        let mark = |kind, theta_deg| Mark { kind, theta_deg };
        if self.index.is_absorbing() {
            let least = self.least_p_deg().map(|at| mark(MarkKind::LeastP, at));
            return least.into_iter().collect();
        }
        if self.n_minus_1 == 0.0 {
            return Vec::new();
        }
        let brewster = mark(MarkKind::Brewster, n.atan().to_degrees());
        let critical = self.is_denser_side().then(|| {
            let cosine = (-self.n_minus_1 * (1.0 + n)).sqrt();
            mark(MarkKind::Critical, n.atan2(cosine).to_degrees())
        });
        std::iter::once(brewster).chain(critical).collect()
    }

    /// Where a medium that absorbs reflects the least p polarised light, in degrees. `None` where it reflects the same, or
    /// less, straight on.
    fn least_p_deg(&self) -> Option<f64> {
        let p = |log_cosine: f64| {
            let c = log_cosine.exp();
            self.polarised(c, (1.0 - c) * (1.0 + c))[1]
        };
        // A small index has it near the normal, a large one near the horizon: degrees find the one, decades of the cosine
        // the other.
        let degrees = (0..90).map(|degree| frame::cos_sin_deg(f64::from(degree)).0.ln());
        let decades = (0..=LEAST_DECADE).map(|decade| -f64::from(decade) * 10_f64.ln());
        let mut places: Vec<f64> = degrees.chain(decades).collect();
        places.sort_by(f64::total_cmp);
        let least = places.iter().map(|at| p(*at)).enumerate();
        let (index, _) = least.min_by(|a, b| a.1.total_cmp(&b.1))?;
        let end = |index: usize| places.get(index).or(places.last()).copied();
        let (mut low, mut high) = (end(index.saturating_sub(1))?, end(index + 1)?);
        // Between its neighbours by the golden section.
        let golden = 0.5 * (5_f64.sqrt() - 1.0);
        for _ in 0..GOLDEN_STEPS {
            let reach = golden * (high - low);
            if p(high - reach) <= p(low + reach) {
                high = low + reach;
            } else {
                low = high - reach;
            }
        }
        let at = 0.5 * (low + high);
        let is_dip = p(at) < self.f0 * (1.0 - LEAST_DIP) && p(at) < 1.0 - LEAST_DIP;
        is_dip.then(|| {
            let c = at.exp();
            ((1.0 - c) * (1.0 + c)).sqrt().atan2(c).to_degrees()
        })
    }
}

/// The minimum of an index of 1e10 lies at a cosine of 1e-10.
const LEAST_DECADE: u8 = 12;

/// Each step leaves .618 of the interval: after these it is as narrow as rounding lets a minimum be found.
const GOLDEN_STEPS: usize = 50;

/// A minimum that is no deeper than rounding is none.
const LEAST_DIP: f64 = 1e-12;
