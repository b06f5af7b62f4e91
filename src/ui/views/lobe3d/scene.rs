//! The scene: the lobe, what it stands on, the dome, the axes and the directions.

use std::collections::HashMap;
use std::sync::Arc;

use egui::{Theme, Ui};
use glam::{DVec3, Vec3};

use super::super::context::ViewContext;
use super::super::kept_scale;
use super::isolines::Isoline;
use super::sizes::{ARC_RADIUS, AXIS_LENGTH, FLAT};
use super::surface::{Full, Lobes, Part, Scales, peak};
use crate::scene3d::Scene;
use crate::theme::{Palette, rgba};
use bxdf::math::frame;
use bxdf_lab::analysis::deltas::Arrows;
use bxdf_lab::analysis::lobe::Arrow;
use bxdf_lab::analysis::lobe3d::Mesh;
use bxdf_lab::analysis::{Channel, Hold};
use bxdf_study::memo::{Memo, Same};
use bxdf_study::session::OrbitCamera;
use bxdf_study::session::{EntryId, MaterialEntry, Session};
use bxdf_study::views::lobe3d::Options;

/// Brush lines to either side of the middle one.
const BRUSH_LINES: i32 = 34;
/// Their width, in points: finer than a pixel they are fainter, as scratches are.
const BRUSH_WIDTH: f32 = 0.8;
/// Polar angles of the dome's lines, in degrees; the horizon is the third.
const DOME_STEP_DEG: f32 = 30.0;
/// The grid of angles where it is shown: between rings and between spokes, in degrees.
const GRID_STEPS_DEG: [f32; 2] = [15.0, 30.0];
/// Width of the line of a delta, in points: a stem, with a head in proportion.
const STEM_WIDTH: f32 = 2.0;
/// Where heads stand on the way of the light, from the surface: some are seen whatever covers its end.
const HEADS: [f32; 3] = [0.0, 0.4, 0.8];
/// Length of the line that carries such a head, in world units.
const HEAD_SHAFT: f32 = 0.1;

/// What a drawing is made from.
#[derive(Clone, PartialEq)]
struct Key {
    requested: Vec<Requested>,
    scales: Scales,
    session: Session,
    is_dark: bool,
    has_axes: bool,
}

/// What was asked for a material.
#[derive(Clone, PartialEq)]
pub(super) struct Requested {
    material: EntryId,
    mesh: Same<Mesh>,
    arrows: Same<Vec<Arrow>>,
}

impl Requested {
    /// The material.
    pub(super) fn material(&self) -> EntryId {
        self.material
    }
}

/// What is drawn of every material that is shown.
pub(super) fn requested(cx: &mut ViewContext<'_, Options>) -> Vec<Requested> {
    let (session, answers, options) = (&*cx.session, &mut *cx.answers, &*cx.options);
    let request = |entry: &MaterialEntry| Requested {
        material: entry.id(),
        mesh: Same(answers.ask(session, entry, options.request(session))),
        arrows: Same(answers.ask(session, entry, Arrows)),
    };
    session.materials.shown().map(request).collect()
}

/// The scales on which the lobes are shown now.
pub(super) fn scales(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    requested: &[Requested],
) -> Scales {
    let scale = cx.options.scale;
    let peaks = requested.iter().map(|one| {
        let peak = peak(&one.mesh.0, cx.session);
        (one.material, peak)
    });
    let peaks: Vec<_> = peaks.collect();
    let mut full = |of, peak| kept_scale::full(ui, cx, scale, of, peak);
    let full = if scale.is_each_to_peak {
        let each = peaks.into_iter().map(|(of, peak)| full(Some(of), peak));
        Full::Each(each.collect())
    } else {
        let peaks = peaks.into_iter().map(|(_, peak)| peak);
        Full::Shared(full(None, peaks.fold(0.0, f64::max)))
    };
    Scales {
        lengths: scale.lengths,
        full,
    }
}

/// What is on the screen, less what is painted over it.
pub(super) struct Drawing {
    pub(super) scene: Arc<Scene>,
    /// What tells the scene from all others of any view.
    pub(super) version: u64,
    pub(super) lobes: Lobes,
    /// The lines of equal value, by value.
    pub(super) isolines: Vec<Isoline>,
}

/// The drawings last shown: that of all lobes, and that of each by itself.
#[derive(Default)]
struct Drawings(HashMap<Option<EntryId>, Memo<Key, Drawing>>);

/// The drawing of the session, made anew only where something other than the camera has changed.
pub(super) fn drawing(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    (requested, scales): (Vec<Requested>, Scales),
    has_lower: bool,
) -> Arc<Drawing> {
    let key = Key {
        requested: requested.clone(),
        scales: scales.clone(),
        session: Session {
            camera: OrbitCamera::default(),
            ..cx.session.clone()
        },
        is_dark: ui.ctx().theme() == Theme::Dark,
        has_axes: !cx.state.is_drawing,
    };
    let has_axes = key.has_axes;
    let (session, palette) = (&*cx.session, cx.palette);
    let version = cx.state.unused_number();
    let whose = match &*requested {
        [one] => Some(one.material),
        _ => None,
    };
    let drawings: &mut Drawings = cx.state.own(cx.view);
    drawings
        .0
        .retain(|whose, _| whose.is_none_or(|of| session.materials.get(of).is_some()));
    let memo = drawings.0.entry(whose).or_default();
    memo.get(key, || {
        let parts = requested.into_iter().filter_map(|one| {
            let entry = session.materials.get(one.material)?;
            Some(Part {
                material: one.material,
                title: session.materials.title(entry),
                color: palette.material(entry.slot()),
                mesh: one.mesh.0,
                arrows: one.arrows.0,
            })
        });
        let lobes = Lobes::of(parts.collect(), session, &scales);
        let mut scene = Scene::default();
        // Before the edges of a mesh, in which it lies.
        lobes.add_cut(&mut scene, session, palette);
        lobes.add_to(&mut scene, session);
        let isolines = lobes.add_isolines(&mut scene, session, palette);
        scene.add_ground_disc(palette.ground);
        if !has_lower {
            let shadow = lobes.shadow(session);
            scene.add_table(palette.table, |place| shadow.at(place));
        }
        add_brush_lines(&mut scene, session, palette);
        add_dome(&mut scene, session, palette, has_lower);
        if has_axes {
            add_axes(&mut scene, palette);
        }
        add_directions(&mut scene, session, &lobes, palette);
        if session.show_geometry {
            add_geometry(&mut scene, session, palette);
        }
        Drawing {
            scene: Arc::new(scene),
            version,
            lobes,
            isolines,
        }
    })
}

/// The dome as lines of equal polar angle, with the plane of the section as a fan in it.
fn add_dome(scene: &mut Scene, session: &Session, palette: &Palette, has_lower: bool) {
    let phi = session.section().phi() as f32;
    scene.add_fan(phi, !has_lower, palette.fan);
    let (sin, cos) = phi.sin_cos();
    let along = Vec3::new(cos, sin, 0.0);
    let poles = [Vec3::Z, Vec3::NEG_Z].into_iter();
    for pole in poles.take(if has_lower { 2 } else { 1 }) {
        for end in [along, -along] {
            scene.add_arc(Vec3::ZERO, pole, end, 1.0, palette.dome_line, 1.0);
        }
    }
    let [ring, spoke] = if session.show_geometry {
        GRID_STEPS_DEG
    } else {
        [DOME_STEP_DEG, 0.0]
    };
    let halves = [true, false]
        .into_iter()
        .take(if has_lower { 2 } else { 1 });
    for is_upper in halves {
        scene.add_hemisphere(is_upper, palette.dome);
        scene.add_degree_grid(is_upper, ring, spoke, palette.dome_line, 1.0);
    }
}

fn add_axes(scene: &mut Scene, palette: &Palette) {
    let [axis, normal] = [palette.axis, palette.ink].map(|color| rgba(color, 255));
    for (direction, color) in [(Vec3::X, axis), (Vec3::Y, axis), (Vec3::Z, normal)] {
        scene.add_arrow(Vec3::ZERO, direction * AXIS_LENGTH, color, 1.5);
    }
}

/// The cosine between a ray and a delta that cover each other: that of two degrees.
const ALONG: f64 = 0.999_4;

/// How much of a ray a delta covers at most: its head is always seen.
const LONGEST_COVERED: f64 = 0.9;

fn add_directions(scene: &mut Scene, session: &Session, lobes: &Lobes, palette: &Palette) {
    let held = session.held();
    let mirror = DVec3::new(-held.x, -held.y, held.z);
    let (light, viewer) = match session.hold {
        Hold::Light => (held, session.other()),
        Hold::Viewer => (session.other(), held),
    };
    let (light, color) = (light.as_vec3(), rgba(palette.light, 255));
    scene.add_dashed(light, Vec3::ZERO, color, 2.0);
    for head in HEADS {
        scene.add_arrow(light * (head + HEAD_SHAFT), light * head, color, 2.0);
    }
    let color = rgba(palette.viewer, 255);
    let foot = viewer * covered(viewer, lobes);
    scene.add_arrow(foot.as_vec3(), viewer.as_vec3(), color, 2.0);
    let foot = covered(mirror, lobes);
    let (mirror, color) = (mirror.as_vec3(), rgba(palette.mirror, 255));
    if foot < LONGEST_COVERED {
        scene.add_dashed(mirror * foot as f32, mirror * 0.9, color, 1.5);
    }
    scene.add_arrow(mirror * 0.9, mirror, color, 1.5);
    for (color, arrow) in lobes.arrows() {
        let tip = (arrow.direction * Channel::Luminance.of(arrow.flux)).as_vec3();
        scene.add_arrow(Vec3::ZERO, tip, rgba(color, 255), STEM_WIDTH);
    }
}

/// Up to which radius deltas cover a ray along `w`: it begins beyond them, or it would hide the longest.
fn covered(w: DVec3, lobes: &Lobes) -> f64 {
    let along = lobes
        .arrows()
        .filter(|(_, arrow)| arrow.direction.dot(w) > ALONG);
    let lengths = along.map(|(_, arrow)| Channel::Luminance.of(arrow.flux));
    lengths.fold(0.0, f64::max).min(LONGEST_COVERED)
}

/// Theta, phi and the projection onto the s-t plane.
fn add_geometry(scene: &mut Scene, session: &Session, palette: &Palette) {
    let color = rgba(palette.geometry, 255);
    let held = session.held().as_vec3();
    let flat = Vec3::new(held.x, held.y, 0.0);
    scene.add_arc(Vec3::ZERO, Vec3::Z, held, ARC_RADIUS, color, 2.0);
    if flat.length() > FLAT {
        scene.add_arc(Vec3::ZERO, Vec3::X, flat, ARC_RADIUS, color, 2.0);
        scene.add_arrow(Vec3::ZERO, flat, color, 2.0);
        scene.add_dashed(held, flat, color, 1.5);
    }
}

/// Scratches on the surface along its own s axis, where a material is brushed: they turn with it, and its lobe with them.
fn add_brush_lines(scene: &mut Scene, session: &Session, palette: &Palette) {
    let mut shown = session.materials.shown();
    if shown.all(|entry| entry.material.is_isotropic()) {
        return;
    }
    let (cos, sin) = frame::cos_sin_deg(session.rotation_deg);
    let along = Vec3::new(cos as f32, sin as f32, 0.0);
    let across = Vec3::new(-along.y, along.x, 0.0);
    for line in -BRUSH_LINES..=BRUSH_LINES {
        let offset = line as f32 / (BRUSH_LINES + 1) as f32;
        let half = (1.0 - offset * offset).sqrt();
        // Scratches end where they happen to: by parts of the golden ratio, which never repeat.
        let part = |n: i32| (0.618_034 * n as f32).rem_euclid(1.0);
        let [from, to] = [-1.0 + 0.7 * part(7 * line), 1.0 - 0.7 * part(3 * line + 1)];
        let [from, to] = [from, to].map(|end| across * offset + along * half * end);
        scene.add_line(from, to, palette.brush, BRUSH_WIDTH);
    }
}
