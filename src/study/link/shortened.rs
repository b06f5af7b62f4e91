//! The table of a session as links hold it: materials of the library by their ids, with what was changed of them.

use toml::{Table, Value};

use bxdf::error::{Error, Result};
use bxdf::material::library;

/// The key of the id in the table of a material.
const NAMED: &str = "named";

/// The materials of the table of a session, each as its own table.
fn materials(session: &mut Table) -> impl Iterator<Item = &mut Value> {
    let all = session.get_mut("materials").and_then(Value::as_array_mut);
    let all = all.into_iter().flatten();
    all.filter_map(|entry| entry.as_table_mut()?.get_mut("material"))
}

/// The table of a material of the library, as sessions have it.
fn table_of(named: &library::Named) -> Option<Table> {
    match Value::try_from(&named.material) {
        Ok(Value::Table(table)) => Some(table),
        _ => None,
    }
}

/// `session` with materials of the library by their ids.
pub(super) fn short(mut session: Table) -> Table {
    for material in materials(&mut session) {
        let Some(table) = material.as_table_mut() else {
            continue;
        };
        let name = table.get("name").and_then(Value::as_str);
        let named = library::all()
            .iter()
            .find(|named| Some(&*named.material.name) == name);
        if let Some((named, own)) = named.and_then(|named| Some((named, table_of(named)?))) {
            // Whatever it has not any more would come back.
            if own.keys().all(|key| table.contains_key(key)) {
                table.retain(|key, value| own.get(key) != Some(value));
                table.insert(NAMED.to_owned(), Value::String(named.id.to_owned()));
            }
        }
    }
    session
}

/// What [`short`] has made shorter, whole.
///
/// # Errors
/// [`Error::UnknownId`] for a material that the library has not.
pub(super) fn whole(mut session: Table) -> Result<Table> {
    for material in materials(&mut session) {
        let Some(table) = material.as_table_mut() else {
            continue;
        };
        let Some(Value::String(id)) = table.remove(NAMED) else {
            continue;
        };
        let named = library::find(&id)?;
        let own = table_of(named).ok_or_else(|| Error::parse("link", "a material is none"))?;
        for (key, value) in own {
            table.entry(key).or_insert(value);
        }
    }
    Ok(session)
}
