//! How the materials of a session stand in its file: a list of tables, or one material by itself.

use std::fmt;

use serde::de::value::MapAccessDeserializer;
use serde::de::{self, Deserializer, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Serialize, Serializer};

use super::entry::{EntryId, MaterialEntry, PaletteIndex, has_equal_widths};
use super::materials::{MAX_MATERIALS, Materials, limit};
use bxdf::Material;
use bxdf::error::Error;
use bxdf::material::file::MAX_DESCRIPTION;

/// A material in the file. Only the material must be given: the rest is what a new one gets.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "marks in a file, each by itself"
)]
struct Stored {
    #[serde(default, skip_serializing_if = "Option::is_none")]
    id: Option<u32>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    slot: Option<u8>,
    #[serde(default, skip_serializing_if = "String::is_empty")]
    name: String,
    #[serde(default, skip_serializing_if = "is_false")]
    selected: bool,
    #[serde(default, skip_serializing_if = "is_false")]
    hidden: bool,
    #[serde(default, skip_serializing_if = "is_false")]
    solo: bool,
    #[serde(default, skip_serializing_if = "is_false")]
    reference: bool,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    linked_widths: Option<bool>,
    material: Material,
}

#[expect(
    clippy::trivially_copy_pass_by_ref,
    reason = "serde hands over a reference"
)]
fn is_false(flag: &bool) -> bool {
    !flag
}

impl Serialize for Materials {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.iter().map(|entry| {
            Stored {
                id: Some(entry.id.0),
                slot: Some(entry.slot.0),
                name: entry.name.clone(),
                selected: entry.id == self.selected().id,
                hidden: !entry.is_visible,
                solo: self.solo == Some(entry.id),
                reference: self.reference == Some(entry.id),
                linked_widths: Some(entry.has_linked_widths)
                    .filter(|linked| *linked != has_equal_widths(&entry.material)),
                material: entry.material.clone(),
            }
        }))
    }
}

impl<'de> Deserialize<'de> for Materials {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(OneOrMany)
    }
}

/// A material as text or as the table of its file, or the list of tables.
struct OneOrMany;

impl<'de> Visitor<'de> for OneOrMany {
    type Value = Materials;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a material or a list of materials")
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Materials, E> {
        text.parse().map(Materials::of).map_err(E::custom)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Materials, A::Error> {
        Material::deserialize(MapAccessDeserializer::new(map)).map(Materials::of)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Materials, A::Error> {
        let mut all = Vec::new();
        while let Some(stored) = seq.next_element::<Stored>()? {
            if all.len() == MAX_MATERIALS {
                return Err(de::Error::custom(limit(MAX_MATERIALS + 1)));
            }
            all.push(stored);
        }
        restored(all).map_err(de::Error::custom)
    }
}

/// The materials of a file. Whatever two of them both claim, the first one keeps.
fn restored(all: Vec<Stored>) -> bxdf::error::Result<Materials> {
    let Some(first) = all.first() else {
        return Err(limit(0));
    };
    if let Some(long) = all
        .iter()
        .find(|stored| stored.name.len() > MAX_DESCRIPTION)
    {
        return Err(Error::Limit {
            what: "the name of a material",
            value: format!("{} bytes long", long.name.len()),
            limit: format!("{MAX_DESCRIPTION} bytes"),
        });
    }
    let mut materials = Materials::of(first.material.clone());
    materials.entries.clear();
    let selected = all.iter().position(|stored| stored.selected).unwrap_or(0);
    let solo = all.iter().position(|stored| stored.solo);
    let reference = all.iter().position(|stored| stored.reference);
    // Those who say nothing get what the others leave.
    let claimed_ids: Vec<u32> = all.iter().filter_map(|stored| stored.id).collect();
    let claimed_slots: Vec<u8> = all.iter().filter_map(|stored| stored.slot).collect();
    for stored in all {
        let is_free_id = |id: &u32| materials.get(EntryId(*id)).is_none();
        let is_free_slot = |slot: &u8| materials.iter().all(|entry| entry.slot.0 != *slot);
        let unclaimed_id = (1..=u32::MAX).find(|id| is_free_id(id) && !claimed_ids.contains(id));
        let unclaimed_slot =
            (0..=u8::MAX).find(|slot| is_free_slot(slot) && !claimed_slots.contains(slot));
        let id = stored.id.filter(is_free_id).or(unclaimed_id).unwrap_or(0);
        let slot = stored.slot.filter(is_free_slot).or(unclaimed_slot);
        let mut entry = MaterialEntry::new(
            EntryId(id),
            PaletteIndex(slot.unwrap_or(u8::MAX)),
            stored.material,
        );
        entry.name = stored.name;
        entry.is_visible = !stored.hidden;
        entry.has_linked_widths = stored.linked_widths.unwrap_or(entry.has_linked_widths);
        materials.entries.push(entry);
    }
    let id_at = |index: usize| materials.entries.get(index).map(|entry| entry.id);
    let (selected, solo) = (id_at(selected), solo.and_then(id_at));
    materials.reference = reference.and_then(id_at);
    materials.selected = selected.unwrap_or(materials.selected);
    materials.solo = solo;
    Ok(materials)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::session::Session;

    fn read(text: &str) -> Materials {
        Session::from_toml(text, "s.toml").unwrap().materials
    }

    #[test]
    fn one_material_may_stand_by_itself() {
        for text in [
            "material = \"phong\"",
            "[material]\nlobes = [{ model = \"phong\" }]",
            "[[materials]]\nmaterial = \"phong\"",
        ] {
            assert_eq!(
                read(text),
                Materials::of("phong".parse().unwrap()),
                "{text}"
            );
        }
    }

    #[test]
    fn several_materials_come_back_as_they_were() {
        let text = "
            [[materials]]
            material = \"phong\"
            [[materials]]
            name = \"Wall\"
            hidden = true
            selected = true
            slot = 7
            id = 1
            material = \"oren_nayar\"
            [[materials]]
            solo = true
            reference = true
            linked_widths = false
            material = \"rough_conductor\"";
        let materials = read(text);
        let ids: Vec<u32> = materials.iter().map(|entry| entry.id().0).collect();
        assert_eq!(ids, [2, 1, 3], "no two have the same id");
        assert_eq!(materials.selected().title(), "Wall");
        assert_eq!(materials.selected().slot(), PaletteIndex(7));
        assert!(materials.shown().map(MaterialEntry::id).eq([EntryId(3)]));
        assert!(!materials.get(EntryId(3)).unwrap().has_linked_widths);
        assert_eq!(materials.reference().id(), EntryId(3));
        let session = Session {
            materials,
            ..Session::default()
        };
        let text = session.to_toml().unwrap();
        assert_eq!(Session::from_toml(&text, "again").unwrap(), session);
    }

    #[test]
    fn broken_lists_say_why() {
        for (text, expected) in [
            (
                "[[materials]]\nid = 4\nmaterial = \"phong\"\n[[materials]]\nmaterial = \"phong\"\nid = 4",
                "s.toml: line 6: id = 4: a material before it has the same",
            ),
            (
                "materials = [{ slot = 2, material = \"phong\" },\n{ slot = 2, material = \"ward\" }]",
                "s.toml: line 2: slot = 2: a material before it has the same",
            ),
            ("materials = []", "the number of materials"),
            ("materials = 3", "expected a material or a list"),
            (
                "[[materials]]\nmaterial = \"gold\"",
                "line 2: unknown model 'gold'",
            ),
            ("[[materials]]\nname = \"x\"", "missing field `material`"),
            (
                &format!(
                    "[[materials]]\nmaterial = \"phong\"\nname = \"{}\"",
                    "x".repeat(1 << 15)
                ),
                "the name of a material is 32768 bytes long; the limit is 16384 bytes",
            ),
            (
                "[[materials]]\nmaterial = \"phong\"\ncolour = 2",
                "line 3: unknown field `colour`",
            ),
            (
                &"[[materials]]\nmaterial = \"phong\"\n".repeat(33),
                "the number of materials",
            ),
            (
                "material = \"phong\"\nmaterials = []",
                "duplicate field `materials`",
            ),
        ] {
            let line = Session::from_toml(text, "s.toml").unwrap_err().to_string();
            assert!(line.contains(expected) && !line.contains('\n'), "{line}");
        }
    }
}
