//! How long the text of a session is, without writing it in every frame.

use super::Session;
use super::entry::MaterialEntry;
use crate::files;
use bxdf::Material;
use bxdf::error::Result;

/// More than a lobe has as text besides its data: a dozen colours of three numbers.
const LOBE_ROOM: u64 = 4 << 10;

/// More than a view has as text besides the texts in its options: where it stands and a dozen numbers.
const VIEW_ROOM: u64 = 8 << 10;

/// More than stands around a text in a list.
const TEXT_ROOM: u64 = 16;

/// More than a session has as text besides its materials, its views and the names in it.
const REST_ROOM: u64 = 64 << 10;

/// The most bytes that a byte takes where TOML writes it as an escape sequence.
const ESCAPED: u64 = 6;

impl Session {
    /// Refuses a session whose text nobody would read again.
    ///
    /// # Errors
    /// [`Error::Limit`](bxdf::Error::Limit) where it is longer than [`files::MAX_TEXT`].
    pub fn require_fit(&self) -> Result<()> {
        self.require_fit_as("the session with this change")
    }

    /// [`Self::require_fit`], whose error is about `what`.
    pub(super) fn require_fit_as(&self, what: &'static str) -> Result<()> {
        // Only near the limit it is worth being written, to be told to the byte.
        if self.text_bound() <= files::MAX_TEXT {
            return Ok(());
        }
        files::require_fit(what, self.to_toml()?.len() as u64)
    }

    /// At least as many bytes as its text has.
    fn text_bound(&self) -> u64 {
        let names: u64 = self.locked.iter().map(|name| escaped(name)).sum();
        let views = self.views.iter().map(|options| {
            let texts = options.texts().into_iter();
            VIEW_ROOM + texts.map(|text| TEXT_ROOM + escaped(text)).sum::<u64>()
        });
        let materials: u64 = self.materials.iter().map(entry_bound).sum();
        REST_ROOM + names + views.sum::<u64>() + materials
    }
}

fn entry_bound(entry: &MaterialEntry) -> u64 {
    escaped(&entry.name) + material_bound(&entry.material)
}

fn material_bound(material: &Material) -> u64 {
    let lobes = LOBE_ROOM * material.components().len() as u64;
    let data = material
        .resources()
        .map(|(_, resource)| resource.text_bound());
    let said = [&material.name, &material.note, &material.source];
    let said: u64 = said.into_iter().map(|text| escaped(text)).sum();
    lobes + said + data.sum::<u64>()
}

fn escaped(text: &str) -> u64 {
    ESCAPED * text.len() as u64
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::session::{MAX_MATERIALS, Materials};
    use bxdf::Resource;
    use bxdf::material::{Component, library};
    use bxdf::models::MODELS;
    use bxdf::resource::Decoded;
    use bxdf::table::{Shape, Table};

    /// A material whose table has so many nodes along each coordinate.
    fn table(n: usize) -> Material {
        let bxdf = "phong".parse::<Material>().unwrap().build::<f64>();
        let shape = Shape::of(n, true).unwrap();
        let table = Table::bake(&*bxdf, shape, u64::MAX).unwrap();
        let mut component: Component = "table".parse().unwrap();
        let decoded = Arc::new(Decoded::table(table));
        component
            .set_resource("data", Resource::inline(decoded))
            .unwrap();
        Material::from(component)
    }

    #[test]
    fn the_bound_is_above_the_text_of_everything() {
        let models = MODELS.into_iter().map(Material::of);
        let named = library::all().iter().map(|named| named.material.clone());
        let mut odd = table(3);
        odd.note = "\u{1}\"\\\n".repeat(1000);
        let mut baked = odd.with_components(vec!["phong".parse().unwrap()]).unwrap();
        baked.name = "\u{1}".repeat(1000);
        let recipe = baked.recipe(Shape::of(40, true).unwrap()).unwrap();
        let mut component: Component = "table".parse().unwrap();
        let file = Resource::file("\u{1}".repeat(500).into());
        component.set_resource("data", file).unwrap();
        let file = Material::from(component.clone());
        let table_of = Table::even(0.1);
        component
            .set_resource("data", Resource::baked(recipe, table_of))
            .unwrap();
        let baked = Material::from(component);
        for material in models.chain(named).chain([table(16), odd, file, baked]) {
            let mut session = Session::of(material);
            session.locked.insert("\u{7f}".repeat(9000));
            let text = session.to_toml().unwrap();
            assert!(session.text_bound() >= text.len() as u64, "{text}");
        }
    }

    #[test]
    fn what_fits_is_read_again_and_what_does_not_is_refused_with_its_size() {
        // 48 x 48 x 48 nodes are the largest table of the trade-off: 1.7 MiB of text each.
        let large = table(48);
        let mut materials = Materials::of(large.clone());
        while materials.count() < 16 {
            materials.add(large.clone()).unwrap();
        }
        let mut session = Session {
            materials,
            ..Session::default()
        };
        session.require_fit().unwrap();
        let text = session.to_toml().unwrap();
        assert!(text.len() > 26 << 20);
        assert_eq!(Session::from_toml(&text, "s").unwrap(), session);
        while session.materials.count() < MAX_MATERIALS {
            session.materials.add(large.clone()).unwrap();
        }
        let line = session.require_fit().unwrap_err().to_string();
        assert!(
            line.starts_with("the session with this change is 54.")
                && line.ends_with("MiB of text; the limit is 32 MiB"),
            "{line}"
        );
    }
}
