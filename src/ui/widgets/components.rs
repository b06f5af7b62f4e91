//! The components of the material: what each is, its weight in a mixture, its parameters.

use egui::collapsing_header::CollapsingState;
use egui::{Align, Label, Layout, Response, RichText, Role, Ui, WidgetInfo};

use super::chevron::{self, Points};
use super::params::{self, Ties};
use super::small;
use bxdf::Catalogue;
use bxdf::material::{MAX_COMPONENTS, library};
use bxdf::param::{self, Value};
use bxdf::{Category, Component, Material, ModelSpec};
use bxdf_lab::contract::weight_that_keeps_energy;
use bxdf_study::store::Side;

/// The weight of a lobe that is added, where there is so much room: the material stays what it is.
const ADDED_WEIGHT: f64 = 0.25;

/// What is said of a material until it changes.
struct Said {
    /// What it is said of.
    of: Material,
    text: String,
    /// Whether a change was refused.
    is_refusal: bool,
}

/// What is said of the components between frames.
#[derive(Default)]
pub struct Components {
    /// What is said of the last change: why it was refused, or what was made of it.
    said: Option<Said>,
    /// Whether the last lobe was just added, and is to be scrolled to.
    is_last_new: bool,
}

impl Components {
    /// What is said of `material` and its components, one below the other; lobes can be added and removed.
    /// `side`: what is folded away of each.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        material: &mut Material,
        ties: &mut Ties<'_>,
        side: &mut Side,
    ) {
        let mut components = material.components().to_vec();
        let is_mixture = components.len() > 1;
        let is_named = !material.name.is_empty();
        let mut removed = None;
        let last = components.len().saturating_sub(1);
        for (index, component) in components.iter_mut().enumerate() {
            if index == last && std::mem::take(&mut self.is_last_new) {
                ui.scroll_to_cursor(Some(Align::TOP));
            }
            ui.push_id(index, |ui| {
                if !is_mixture {
                    show_only(ui, component, ties, side, is_named);
                } else if show_one_of_many(ui, component, index + 1, ties, side) {
                    removed = Some(index);
                }
            });
        }
        carry_index(material.components(), &mut components);
        if let Some(index) = removed {
            components.remove(index);
        }
        let mut told = None;
        if let Some(model) = ask_for_lobe(ui, components.len()) {
            let lobe = added(model, material);
            told = Some(told_of(&lobe));
            components.push(lobe);
            self.is_last_new = true;
            ui.ctx().request_repaint();
        }
        if components != material.components() {
            match material.with_components(components) {
                Ok(changed) => {
                    *material = changed;
                    self.say(material, told, false);
                }
                Err(error) => self.say(material, Some(params::reason(error)), true),
            }
        }
        // It stays until the material changes.
        if let Some(said) = self.said.as_ref().filter(|said| said.of == *material) {
            let visuals = ui.visuals();
            let color = if said.is_refusal {
                visuals.error_fg_color
            } else {
                visuals.text_color()
            };
            ui.colored_label(color, &said.text);
        }
    }
}

impl Components {
    fn say(&mut self, material: &Material, text: Option<String>, is_refusal: bool) {
        self.said = text.map(|text| Said {
            of: material.clone(),
            text,
            is_refusal,
        });
    }
}

/// The name of `material`, at the end of its line what `commands` add and the way back to how it was chosen, and what there is
/// to look at.
pub fn describe(ui: &mut Ui, material: &mut Material, commands: impl FnOnce(&mut Ui)) {
    ui.horizontal(|ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            commands(ui);
            reset(ui, material);
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                let title = RichText::new(material.title()).heading();
                let title = ui.add(Label::new(title).truncate());
                hint_source(title, &material.source);
            });
        });
    });
    if !material.note.is_empty() {
        let note = ui.label(&material.note);
        hint_source(note, &material.source);
    } else if let Some(component) = material.only() {
        let model = component.model();
        let summary = ui.label(model.summary);
        hint_source(summary, model.source);
    }
}

/// The button that resets a named material to how it stands in the library, and one of a single model to its defaults.
fn reset(ui: &mut Ui, material: &mut Material) {
    if let Some(named) = library::origin(material) {
        let is_edited = named.material != *material;
        let hint = "Reset to the material of the list";
        if reset_all(ui, &material.name, is_edited, hint) {
            material.clone_from(&named.material);
        }
    } else if let [component] = material.components() {
        let mut component = component.clone();
        reset_component(ui, &mut component, None);
        if material.components() != [component.clone()]
            && let Ok(changed) = material.with_components(vec![component])
        {
            *material = changed;
        }
    }
}

/// The button at the end of a row that resets all parameters of `what`. Returns whether it is clicked.
fn reset_all(ui: &mut Ui, what: &str, is_edited: bool, hint: &str) -> bool {
    let reset = ui
        .add_enabled(is_edited, small::button(ui, "↺").frame(false))
        .on_hover_text(hint);
    let name = format!("Reset {what}");
    reset.widget_info(|| WidgetInfo::labeled(Role::Button, is_edited, &name));
    reset.clicked()
}

/// The button that resets all parameters of `component`; `ordinal` where there are several.
fn reset_component(ui: &mut Ui, component: &mut Component, ordinal: Option<usize>) {
    let model = component.model();
    let what = ordinal.map_or_else(
        || format!("all of {}", model.title),
        |ordinal| format!("all of lobe {ordinal}, {}", model.title),
    );
    let defaults = Component::of(model);
    let is_edited = component.params() != defaults.params();
    if reset_all(ui, &what, is_edited, "Reset all parameters of this model") {
        // A model takes its own defaults.
        let _ = component.set_all(defaults.params());
    }
}

/// Where the numbers come from, at what is said of them.
fn hint_source(said: Response, source: &str) {
    if !source.is_empty() {
        said.on_hover_text(source);
    }
}

/// The only component: its weight goes without saying, unless a file gave it one, and its title where it is the material's.
fn show_only(
    ui: &mut Ui,
    component: &mut Component,
    ties: &mut Ties<'_>,
    side: &mut Side,
    is_named: bool,
) {
    let model = component.model();
    if is_named {
        ui.label(RichText::new(model.title).strong())
            .on_hover_text(format!("{}\n\n{}", model.summary, model.source));
    }
    if component.weight() != 1.0 {
        params::show_weight(ui, component, None);
    }
    params::show(ui, component, None, ties, side);
}

/// A component of several, under a header. `ordinal`: its number, from 1. Returns whether it is to be removed.
fn show_one_of_many(
    ui: &mut Ui,
    component: &mut Component,
    ordinal: usize,
    ties: &mut Ties<'_>,
    side: &mut Side,
) -> bool {
    let model = component.model();
    let id = ui.make_persistent_id("parameters");
    let mut state = CollapsingState::load_with_default_open(ui.ctx(), id, true);
    let mut is_removed = false;
    ui.horizontal(|ui| {
        let name = format!("Parameters of lobe {ordinal}, {}", model.title);
        let is_open = state.is_open();
        let points = Points::of_heading(is_open);
        let hint = "Show or hide the parameters of this lobe";
        if chevron::button(ui, points, is_open, &name, hint).clicked() {
            state.set_open(!is_open);
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let remove = ui
                .add(small::button(ui, "✖").frame(false))
                .on_hover_text("Remove this lobe");
            let name = format!("Remove lobe {ordinal}, {}", model.title);
            remove.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
            is_removed = remove.clicked();
            reset_component(ui, component, Some(ordinal));
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                let title = RichText::new(model.title).strong();
                ui.add(Label::new(title).truncate())
                    .on_hover_text(format!("{}\n\n{}", model.summary, model.source));
            });
        });
    });
    params::show_weight(ui, component, Some(ordinal));
    state.show_body_unindented(ui, |ui| {
        params::show(ui, component, Some(ordinal), ties, side);
    });
    ui.separator();
    is_removed
}

/// The button for one more lobe, beside the `n` there are. Returns the model chosen.
fn ask_for_lobe(ui: &mut Ui, n: usize) -> Option<&'static ModelSpec> {
    let mut chosen = None;
    ui.add_space(4.0);
    let menu = |ui: &mut Ui| {
        let button = ui.menu_button("Add a lobe…", |ui| {
            for category in Category::ALL {
                let models = Catalogue::current().models().iter().copied();
                let models = models.filter(|m| m.category() == category);
                let button = ui.menu_button(category.title(), |ui| {
                    for model in models {
                        if ui
                            .button(model.title)
                            .on_hover_text(model.summary)
                            .clicked()
                        {
                            chosen = Some(model);
                        }
                    }
                });
                button.response.on_hover_text(category.meaning());
            }
        });
        let hint = "Add another model, scaled by a weight";
        let limit = format!("A material has at most {MAX_COMPONENTS} lobes");
        button
            .response
            .on_hover_text(hint)
            .on_disabled_hover_text(limit);
    };
    ui.add_enabled_ui(n < MAX_COMPONENTS, menu);
    chosen
}

/// A faint lobe of `model`, whose weight leaves no more light than arrives; where light crosses both, with the index of
/// refraction that `material` has.
fn added(model: &'static ModelSpec, material: &Material) -> Component {
    let mut component = Component::of(model);
    let is_crossed = |component: &Component| component.model().transmits();
    if is_crossed(&component) && material.components().iter().any(is_crossed) {
        // A model without such a parameter, or another index by it, is refused with the reason when it is added.
        set_index(&mut component, material.relative_index());
    }
    // It is within the range.
    let _ = component.set_weight(weight_that_keeps_energy(material, &component, ADDED_WEIGHT));
    component
}

/// Gives `component` this index of refraction. A model without such a parameter, or whose range ends before, stays as it is.
fn set_index(component: &mut Component, index: f64) {
    if let Some((spec, _)) = component.params().of_role(param::Role::Index) {
        let _ = component.set(spec.name, Value::Number(index));
    }
}

/// What is said of a lobe that was added.
fn told_of(added: &Component) -> String {
    let (title, weight) = (added.model().title, added.weight());
    if weight == 0.0 {
        return format!("{title} starts with weight 0: the other lobes give back all the light");
    }
    let room = if weight < ADDED_WEIGHT {
        ": with more, more light would leave than arrives"
    } else {
        ""
    };
    format!("{title} starts with weight {weight}{room}")
}

/// The index of refraction below the surface is one: where a lobe that light crosses got another than it had `before`,
/// the other such lobes of `components` take it over.
fn carry_index(before: &[Component], components: &mut [Component]) {
    let is_crossed = |component: &Component| component.model().transmits();
    let mut pairs = components.iter().zip(before);
    let changed = pairs
        .find(|(now, then)| is_crossed(now) && now.relative_index() != then.relative_index())
        .map(|(now, _)| now.relative_index());
    let Some(index) = changed else { return };
    let others =
        |component: &&mut Component| is_crossed(component) && component.relative_index() != index;
    for component in components.iter_mut().filter(others) {
        // A model without such a parameter, or whose range ends before, is refused with the reason.
        set_index(component, index);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lobe_that_is_added_takes_over_the_index() {
        let water: Material = "fresnel_specular:eta=1.33".parse().unwrap();
        let rough = added(
            Catalogue::current().find("rough_dielectric").unwrap(),
            &water,
        );
        // Clear water gives back all the light.
        assert_eq!((rough.relative_index(), rough.weight()), (1.33, 0.0));
        assert!(told_of(&rough).contains("weight 0: the other lobes"));
        let mut both = water.components().to_vec();
        both.push(rough);
        assert!(water.with_components(both.clone()).is_ok());
        let mut edited = both.clone();
        edited[1].set("eta", Value::Number(1.6)).unwrap();
        carry_index(&both, &mut edited);
        let indices = edited.iter().map(Component::relative_index);
        assert_eq!(indices.collect::<Vec<_>>(), [1.6, 1.6]);
        let grey: Material = "lambertian_reflection:reflectance=.5".parse().unwrap();
        let plain = added(Catalogue::current().find("phong").unwrap(), &grey);
        assert_eq!(plain.to_string(), "phong");
        assert_eq!(told_of(&plain), "Phong starts with weight 0.25");
    }
}
