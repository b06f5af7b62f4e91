//! The scene: the lobe, the dome, the axes and the directions.

use std::sync::Arc;

use egui::{Theme, Ui};
use glam::{DVec3, Vec3};

use super::super::context::ViewContext;
use super::super::kept_scale;
use super::sizes::{ARC_RADIUS, AXIS_LENGTH, FLAT};
use super::surface::{Full, Lobes, Part, Scales, peak};
use crate::scene3d::Scene;
use crate::theme::{Palette, rgba};
use bxdf::math::frame;
use bxdf_lab::analysis::Channel;
use bxdf_lab::analysis::deltas::Arrows;
use bxdf_lab::analysis::lobe::Arrow;
use bxdf_lab::analysis::lobe3d::Mesh;
use bxdf_study::memo::{Memo, Same};
use bxdf_study::session::OrbitCamera;
use bxdf_study::session::{EntryId, MaterialEntry, Session};
use bxdf_study::views::lobe3d::Options;

/// Brush lines to either side of the middle one.
const BRUSH_LINES: i32 = 6;
/// Their alpha, 0..255: a hint, not a grid.
const BRUSH_ALPHA: u8 = 50;

/// What a drawing is made from.
#[derive(Clone, PartialEq)]
struct Key {
    requested: Vec<Requested>,
    scales: Scales,
    session: Session,
    is_dark: bool,
}

/// What was asked for a material.
#[derive(Clone, PartialEq)]
pub(super) struct Requested {
    material: EntryId,
    mesh: Same<Mesh>,
    arrows: Same<Vec<Arrow>>,
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
}

/// The drawing last shown.
type DrawingMemo = Memo<Key, Drawing>;

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
    };
    let (session, palette) = (&*cx.session, cx.palette);
    let version = cx.state.unused_number();
    let memo: &mut DrawingMemo = cx.state.own(cx.view);
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
        lobes.add_to(&mut scene, session);
        add_brush_lines(&mut scene, session, palette);
        add_frame(&mut scene, palette, has_lower);
        add_directions(&mut scene, session, &lobes, palette);
        if session.show_geometry {
            add_geometry(&mut scene, session, palette);
        }
        Drawing {
            scene: Arc::new(scene),
            version,
            lobes,
        }
    })
}

fn add_frame(scene: &mut Scene, palette: &Palette, has_lower: bool) {
    let (axis, grid) = (rgba(palette.axis, 255), rgba(palette.axis, 60));
    scene.add_hemisphere(true, palette.dome);
    scene.add_degree_grid(true, 15.0, 30.0, grid, 1.0);
    if has_lower {
        scene.add_hemisphere(false, palette.dome);
        scene.add_degree_grid(false, 15.0, 30.0, grid, 1.0);
    }
    scene.add_ground_disc(palette.ground);
    for direction in [Vec3::X, Vec3::Y] {
        scene.add_arrow(Vec3::ZERO, direction * AXIS_LENGTH, axis, 1.5);
    }
    scene.add_arrow(
        Vec3::ZERO,
        Vec3::Z * AXIS_LENGTH,
        rgba(palette.ink, 255),
        1.5,
    );
}

fn add_directions(scene: &mut Scene, session: &Session, lobes: &Lobes, palette: &Palette) {
    let held = session.held();
    let mirror = DVec3::new(-held.x, -held.y, held.z);
    scene.add_arrow(
        Vec3::ZERO,
        held.as_vec3(),
        rgba(palette.held(session.hold), 255),
        3.0,
    );
    let (mirror, color) = (mirror.as_vec3(), rgba(palette.mirror, 255));
    scene.add_dashed(Vec3::ZERO, mirror * 0.9, color, 2.0);
    scene.add_arrow(mirror * 0.9, mirror, color, 2.0);
    for (color, arrow) in lobes.arrows() {
        let length = Channel::Luminance.of(arrow.flux);
        scene.add_arrow(
            Vec3::ZERO,
            (arrow.direction * length).as_vec3(),
            rgba(color, 255),
            5.0,
        );
    }
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

/// Lines on the surface along its own s axis: they turn with it, and an anisotropic lobe with them.
fn add_brush_lines(scene: &mut Scene, session: &Session, palette: &Palette) {
    let (cos, sin) = frame::cos_sin_deg(session.rotation_deg);
    let along = Vec3::new(cos as f32, sin as f32, 0.0);
    let across = Vec3::new(-along.y, along.x, 0.0);
    for line in -BRUSH_LINES..=BRUSH_LINES {
        let offset = line as f32 / (BRUSH_LINES + 1) as f32;
        let half = (1.0 - offset * offset).sqrt();
        let (from, to) = (
            across * offset - along * half,
            across * offset + along * half,
        );
        scene.add_line(from, to, rgba(palette.axis, BRUSH_ALPHA), 1.0);
    }
}
