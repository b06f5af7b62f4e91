//! What a test of the page looks for: the names of what is on the screen, and where it is.
//!
//! In a browser egui draws all of it on one canvas, and its tree for screen readers reaches nobody: with `?test` the page puts
//! what stands in that tree into `window.explorer_test`.

use egui::{Context, FullOutput};
use js_sys::{Array, Object, Reflect};
use wasm_bindgen::JsValue;

/// The property of the window.
const PROPERTY: &str = "explorer_test";

/// Tells after each frame.
pub struct Probe;

impl Probe {
    /// Tells from now on.
    pub fn begin(ctx: &Context) {
        ctx.enable_accesskit();
        ctx.add_plugin(Self);
    }
}

impl egui::Plugin for Probe {
    fn debug_name(&self) -> &'static str {
        "probe"
    }

    fn output_hook(&mut self, _: &Context, output: &mut FullOutput) {
        let Some(update) = output.platform_output.accesskit_update.take() else {
            return;
        };
        let nodes = Array::new();
        for (_, node) in &update.nodes {
            let Some(bounds) = node.bounds() else {
                continue;
            };
            let text = |text: Option<&str>| text.map_or(JsValue::NULL, JsValue::from_str);
            let told = Object::new();
            let values = [
                ("role", JsValue::from_str(&format!("{:?}", node.role()))),
                ("name", text(node.label())),
                ("value", text(node.value())),
                (
                    "number",
                    node.numeric_value()
                        .map_or(JsValue::NULL, JsValue::from_f64),
                ),
                ("x", bounds.x0.into()),
                ("y", bounds.y0.into()),
                ("width", bounds.width().into()),
                ("height", bounds.height().into()),
            ];
            for (key, value) in values {
                // An object of our own takes any property.
                let _ = Reflect::set(&told, &key.into(), &value);
            }
            nodes.push(&told);
        }
        if let Some(window) = web_sys::window() {
            let _ = Reflect::set(&window, &PROPERTY.into(), &nodes);
        }
    }
}
