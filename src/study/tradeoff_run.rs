//! Trade-offs measured in the background: by a thread of its own, which tells how far it is and can be called off.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use glam::DVec3;

use super::platform;
use super::session::Session;
use bxdf::Material;
use bxdf_lab::timing::{Stopwatch, WallClock};
use bxdf_lab::tradeoff::{self, FAMILIES, Family, Report, Study};

/// The trade-off of the material last measured.
pub struct Measured {
    run: Option<Run>,
    stopwatch: &'static dyn Stopwatch,
    /// Whether there are threads to measure in; else it is done at once.
    is_threaded: bool,
}

impl Measured {
    /// Nothing yet.
    #[must_use]
    pub fn new(is_threaded: bool) -> Self {
        Self {
            run: None,
            stopwatch: &WallClock,
            is_threaded,
        }
    }

    /// Measures time with another clock from now on.
    pub fn use_stopwatch(&mut self, stopwatch: &'static dyn Stopwatch) {
        self.stopwatch = stopwatch;
    }

    /// The measurement, under way or done.
    #[must_use]
    pub fn run(&self) -> Option<&Run> {
        self.run.as_ref()
    }

    /// What is known of the material last measured.
    #[must_use]
    pub fn report(&self) -> Option<Arc<Report>> {
        self.run.as_ref().and_then(|run| run.state().report)
    }

    /// Begins to measure these `families` for what `session` has selected and holds; `wake` is called when there is news.
    pub fn start(
        &mut self,
        session: &Session,
        families: Vec<&'static str>,
        wake: impl Fn() + Send + 'static,
    ) {
        let order = Order::of(session, families);
        let is_threaded = self.is_threaded;
        self.run = Some(Run::start(order, self.stopwatch, is_threaded, wake));
    }

    /// Calls it off.
    pub fn cancel(&mut self) {
        if let Some(run) = &self.run {
            run.is_wanted.store(false, Ordering::Relaxed);
        }
    }

    /// Whether the measurement, if there is one, is of these `families` and of what `session` has selected and holds.
    #[must_use]
    pub fn is_of(&self, session: &Session, families: &[&'static str]) -> bool {
        self.run
            .as_ref()
            .is_some_and(|run| run.order == Order::of(session, families.to_vec()))
    }
}

/// What is measured, and of what.
#[derive(Clone, Debug, PartialEq)]
pub struct Order {
    /// The material.
    pub material: Material,
    /// The direction of view of the estimates.
    pub held: DVec3,
    /// The ids of the families.
    pub families: Vec<&'static str>,
}

/// How far a measurement is.
#[derive(Clone, Debug, Default)]
pub struct State {
    /// What is known so far.
    pub report: Option<Arc<Report>>,
    /// The share of the work done, 0..1.
    pub share: f64,
    /// Whether there is nothing left to do.
    pub is_done: bool,
}

/// A measurement, under way or done. Dropped, it is called off.
pub struct Run {
    /// What is measured.
    pub order: Order,
    state: Arc<Mutex<State>>,
    is_wanted: Arc<AtomicBool>,
    begin: f64,
}

impl Order {
    fn of(session: &Session, families: Vec<&'static str>) -> Self {
        Self {
            material: session.material().clone(),
            held: session.on_surface(session.held()),
            families,
        }
    }
}

impl Run {
    /// Begins to measure in a thread of its own, where `is_threaded`; `wake` is called when there is news. Else measures
    /// here and now.
    fn start(
        order: Order,
        stopwatch: &'static dyn Stopwatch,
        is_threaded: bool,
        wake: impl Fn() + Send + 'static,
    ) -> Self {
        let run = Self {
            state: Arc::default(),
            is_wanted: Arc::new(AtomicBool::new(true)),
            begin: platform::seconds(),
            order,
        };
        let (order, state) = (run.order.clone(), Arc::clone(&run.state));
        let is_wanted = Arc::clone(&run.is_wanted);
        let work = move || {
            measure(&order, stopwatch, &state, &is_wanted, &wake);
            wake();
        };
        // Without threads, as in a browser, it is done at once.
        if is_threaded && platform::has_threads() {
            platform::compute(work);
        } else {
            work();
        }
        run
    }

    /// How far it is.
    #[must_use]
    pub fn state(&self) -> State {
        lock(&self.state).clone()
    }

    /// About how many seconds are left, once that can be said.
    #[must_use]
    pub fn seconds_left(&self) -> Option<f64> {
        let share = lock(&self.state).share;
        (share > 0.02).then(|| (platform::seconds() - self.begin) * (1.0 / share - 1.0))
    }
}

impl Drop for Run {
    fn drop(&mut self) {
        self.is_wanted.store(false, Ordering::Relaxed);
    }
}

fn lock(state: &Mutex<State>) -> std::sync::MutexGuard<'_, State> {
    state.lock().unwrap_or_else(PoisonError::into_inner)
}

fn measure(
    order: &Order,
    stopwatch: &dyn Stopwatch,
    state: &Mutex<State>,
    is_wanted: &AtomicBool,
    wake: &dyn Fn(),
) {
    let study = Study::new(&order.material, Some(order.held));
    let families: Vec<&dyn Family> = FAMILIES
        .into_iter()
        .filter(|family| order.families.contains(&family.id()))
        .collect();
    let mut tell = |report: &Report, share: f64| {
        let mut state = lock(state);
        (state.report, state.share) = (Some(Arc::new(report.clone())), share);
        drop(state);
        wake();
    };
    let is_wanted = || is_wanted.load(Ordering::Relaxed);
    let report = tradeoff::measure(&study, &families, stopwatch, &is_wanted, &mut tell);
    let mut state = lock(state);
    if let Some(report) = report {
        (state.report, state.share) = (Some(Arc::new(report)), 1.0);
    }
    state.is_done = true;
}
