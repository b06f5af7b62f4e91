//! Where the window stands on the screens, from one run to the next.

use egui::Context;
#[cfg(not(target_arch = "wasm32"))]
use egui::{Pos2, Rect, Vec2, ViewportBuilder, pos2, vec2};

use bxdf_study::store::WindowPlace;

/// The window where it stood last.
#[cfg(not(target_arch = "wasm32"))]
pub fn placed(window: ViewportBuilder, place: Option<WindowPlace>) -> ViewportBuilder {
    let Some(place) = place else { return window };
    let window = window
        .with_inner_size(place.size)
        .with_maximized(place.is_maximized);
    match place.position {
        Some(position) => window.with_position(position),
        None => window,
    }
}

/// Moves the window to where a screen shows all of it, before it is seen: the one on which it stood may be gone.
#[cfg(not(target_arch = "wasm32"))]
pub fn keep_on_screen(cc: &eframe::CreationContext<'_>) {
    let Some(window) = cc.winit_window() else {
        return;
    };
    // Where the system places windows by itself it does not say where.
    let Ok(mut at) = window.outer_position() else {
        return;
    };
    let size = window.outer_size();
    let rect = Rect::from_min_size(
        pos2(at.x as f32, at.y as f32),
        vec2(size.width as f32, size.height as f32),
    );
    let screens = window.available_monitors().map(|screen| {
        let (at, size) = (screen.position(), screen.size());
        Rect::from_min_size(
            pos2(at.x as f32, at.y as f32),
            vec2(size.width as f32, size.height as f32),
        )
    });
    let screens: Vec<Rect> = screens.collect();
    if let Some(place) = moved(rect, &screens) {
        (at.x, at.y) = (place.x as i32, place.y as i32);
        window.set_outer_position(at);
    }
}

/// Where a window goes that no screen shows as a whole: to the screen that shows most of it, else to the first.
#[cfg(not(target_arch = "wasm32"))]
fn moved(window: Rect, screens: &[Rect]) -> Option<Pos2> {
    let shown = |screen: &Rect| screen.intersect(window).area().max(0.0);
    let is_seen = |screen: &&Rect| screen.intersects(window);
    let most = screens
        .iter()
        .filter(is_seen)
        .max_by(|a, b| shown(a).total_cmp(&shown(b)));
    let screen = most.or(screens.first())?;
    let room = (screen.size() - window.size()).max(Vec2::ZERO);
    let place = window.min.clamp(screen.min, screen.min + room);
    (place != window.min).then_some(place)
}

/// Where the window stands now, as far as it fills no screen; `before`: where it stood.
pub fn place(ctx: &Context, before: Option<WindowPlace>) -> Option<WindowPlace> {
    let zoom = ctx.zoom_factor();
    ctx.input(|input| {
        let window = input.viewport();
        let is = |flag: Option<bool>| flag == Some(true);
        if is(window.fullscreen) || is(window.minimized) {
            return None;
        }
        let is_maximized = is(window.maximized);
        if is_maximized {
            let before = before?;
            return Some(WindowPlace {
                is_maximized,
                ..before
            });
        }
        Some(WindowPlace {
            position: window.outer_rect.map(|rect| (zoom * rect.min).into()),
            size: (zoom * window.inner_rect?.size()).into(),
            is_maximized,
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_window_is_moved_to_where_it_is_seen() {
        let [left, right] =
            [0.0, 1920.0].map(|x| Rect::from_min_size(pos2(x, 0.0), vec2(1920.0, 1080.0)));
        let at = |x, y| Rect::from_min_size(pos2(x, y), vec2(1000.0, 700.0));
        let both = [left, right];
        assert_eq!(moved(at(2100.0, 50.0), &both), None);
        assert_eq!(moved(at(2100.0, 50.0), &both[..1]), Some(pos2(920.0, 50.0)));
        assert_eq!(moved(at(5000.0, -3000.0), &both), Some(pos2(920.0, 0.0)));
        // Of two that show it, the one that shows more.
        assert_eq!(moved(at(1000.0, 500.0), &both), Some(pos2(920.0, 380.0)));
        // One that is larger than the screen begins where that does.
        let small = Rect::from_min_size(pos2(0.0, 0.0), vec2(800.0, 600.0));
        assert_eq!(moved(at(30.0, 20.0), &[small]), Some(Pos2::ZERO));
        assert_eq!(moved(at(30.0, 20.0), &[]), None);
    }
}
