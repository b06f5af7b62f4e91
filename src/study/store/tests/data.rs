//! Sessions whose materials have data: what is saved, moved, and found missing.

use super::*;
use crate::session::pasted;
use bxdf::math::Vec3;
use bxdf::resource::{Content, Recipe};
use bxdf::table::{Shape, Table};
use bxdf::{Component, Resource};

/// A table of `text` of so many nodes, and its recipe.
fn table(text: &str, n: usize) -> (Recipe, Table) {
    let material: Material = text.parse().unwrap();
    let shape = Shape::of(n, material.is_isotropic()).unwrap();
    let table = Table::bake(&*material.build::<f64>(), shape, u64::MAX).unwrap();
    (material.recipe(shape).unwrap(), table)
}

fn of(resource: Resource) -> Material {
    let mut component: Component = "table".parse().unwrap();
    component.set_resource("data", resource).unwrap();
    component.into()
}

/// A material of each kind of data, large and small, whose files lie in `folder`.
fn each(folder: &Folder) -> Vec<Material> {
    let mut all = Vec::new();
    for (name, n) in [("small", 4), ("large", 24)] {
        let (recipe, baked) = table("phong", n);
        let (_, measured) = table("oren_nayar", n);
        let path = folder.file(&format!("{name}.table"));
        fs::write(&path, format!("{measured}\n")).unwrap();
        all.push(Material::open(&path).unwrap());
        all.push(of(Resource::baked(recipe, baked)));
        let (_, inline) = table("burley_diffuse", n);
        all.push(format!("table:data={inline}").parse().unwrap());
    }
    all
}

fn session(materials: Vec<Material>) -> Session {
    Session {
        materials: Materials::new(materials).unwrap(),
        ..Session::default()
    }
}

/// A value of each material.
fn values(session: &Session) -> Vec<[f64; 3]> {
    let materials = session
        .materials
        .iter()
        .map(|entry| entry.material.build::<f64>());
    let value = |bxdf: Box<dyn bxdf::Scatterer<f64>>| {
        bxdf.f(Vec3::new(0.0, 0.6, 0.8), Vec3::new(0.6, 0.0, 0.8))
            .to_f64()
    };
    materials.map(value).collect()
}

/// What is read at `path`, and what is said of it, with everything baked.
fn opened(folder: &Folder, path: &Path) -> (Session, Vec<String>) {
    let opened = open(&mut folder.store(), path).unwrap();
    let remarks = opened.remarks();
    let mut session = opened.into_session();
    session.fetch(&nothing);
    (session, remarks)
}

#[test]
fn a_session_moves_with_what_it_holds_and_says_what_it_lacks() {
    let (from, to) = (Folder::new("data_from"), Folder::new("data_to"));
    let session = session(each(&from));
    let path = from.file("mine.toml");
    from.store().save(&path, &session).unwrap();
    let text = fs::read_to_string(&path).unwrap();
    assert!(
        text.contains("file = \"large.table\"") && !text.contains("file = \"/"),
        "{text}"
    );
    let (found, remarks) = opened(&from, &path);
    assert!(remarks.is_empty(), "{remarks:?}");
    assert!(found == session && values(&found) == values(&session));

    // By itself, in an empty folder: only the large file is lost, and its material stays.
    let moved = to.file("moved.toml");
    fs::copy(&path, &moved).unwrap();
    let (found, remarks) = opened(&to, &moved);
    let [remark] = &remarks[..] else {
        panic!("{remarks:?}");
    };
    assert!(
        remark.starts_with("large: ") && remark.contains("large.table is missing: "),
        "{remark}"
    );
    assert_eq!(found.materials.count(), session.materials.count());
    assert_eq!(
        found.materials.shown().count(),
        session.materials.count() - 1
    );
    // Kept and opened again it is as it was: nothing else is lost, and the file may come back.
    to.store().save(&moved, &found).unwrap();
    fs::copy(from.file("large.table"), to.file("large.table")).unwrap();
    let (found, remarks) = opened(&to, &moved);
    assert!(
        remarks.is_empty() && values(&found) == values(&session),
        "{remarks:?}"
    );
}

#[test]
fn a_session_saved_with_its_data_or_copied_needs_no_file() {
    let (from, to) = (Folder::new("whole_from"), Folder::new("whole_to"));
    let session = session(each(&from));
    let path = from.file("whole.toml");
    from.store().save_with_data(&path, &session).unwrap();
    let moved = to.file("moved.toml");
    fs::copy(&path, &moved).unwrap();
    let (found, remarks) = opened(&to, &moved);
    assert!(remarks.is_empty(), "{remarks:?}");
    assert!(found.materials.shown().count() == session.materials.count());
    assert_eq!(values(&found), values(&session));
    // What came so is saved so: there is no file to name.
    to.store().save(&moved, &found).unwrap();
    let (again, remarks) = opened(&to, &moved);
    assert!(
        remarks.is_empty() && values(&again) == values(&session),
        "{remarks:?}"
    );

    let text = session.with_data().unwrap().to_toml().unwrap();
    let pasted = pasted(&text).unwrap();
    assert!(pasted.remarks().is_empty());
    let pasted = pasted.into_session();
    assert!(pasted.awaited().is_empty() && values(&pasted) == values(&session));
    assert!(text.len() > session.to_toml().unwrap().len());
}

#[test]
fn a_file_changed_meanwhile_is_shown_as_it_is_and_said() {
    let folder = Folder::new("data_changed");
    let session = session(each(&folder));
    let path = folder.file("mine.toml");
    folder.store().save(&path, &session).unwrap();
    let (_, other) = table("lambertian_reflection", 24);
    fs::write(folder.file("large.table"), other.to_string()).unwrap();
    let (found, remarks) = opened(&folder, &path);
    let [remark] = &remarks[..] else {
        panic!("{remarks:?}");
    };
    assert!(
        remark.ends_with("large.table has changed since this was saved"),
        "{remark}"
    );
    assert_ne!(values(&found), values(&session));
    // Saved as it is now, it is no change any more.
    folder.store().save(&path, &found).unwrap();
    let (_, remarks) = opened(&folder, &path);
    assert!(remarks.is_empty(), "{remarks:?}");
}

/// Nobody waits for a pipe, and a device has no end.
#[cfg(unix)]
#[test]
fn what_is_no_file_is_not_read() {
    let folder = Folder::new("data_no_file");
    let path = folder.file("mine.toml");
    for (name, expected) in [("/dev/zero", "a device or a pipe"), (".", "is a directory")] {
        fs::write(&path, format!("material = \"table:data={name}\"\n")).unwrap();
        let (found, remarks) = opened(&folder, &path);
        let [remark] = &remarks[..] else {
            panic!("{remarks:?}");
        };
        assert!(remark.contains(expected), "{remark}");
        assert!(found.materials.shown().next().is_none());
    }
}

#[test]
fn what_is_baked_otherwise_is_said() {
    let folder = Folder::new("data_baked");
    let (recipe, _) = table("phong", 24);
    let (_, other) = table("oren_nayar", 24);
    let path = folder.file("mine.toml");
    let session = session(vec![of(Resource::baked(recipe, other))]);
    folder.store().save(&path, &session).unwrap();
    let opened = open(&mut folder.store(), &path).unwrap();
    assert!(opened.remarks().is_empty());
    let mut found = opened.into_session();
    let awaited = found.awaited();
    assert!(awaited.len() == 1 && found.materials.shown().next().is_none());
    let failed = Content::Missing("no memory".into());
    found.take_data(&awaited[0].1, &failed);
    assert!(
        found
            .problems()
            .next()
            .unwrap()
            .ends_with("is missing: no memory")
    );
    let mut found = open(&mut folder.store(), &path).unwrap().into_session();
    found.fetch(&nothing);
    let problems: Vec<String> = found.problems().collect();
    assert!(
        problems.len() == 1 && problems[0].contains("bakes it otherwise"),
        "{problems:?}"
    );
    assert!(found.materials.shown().next().is_some());
}

#[test]
fn too_much_data_for_one_text_is_refused_with_its_sizes() {
    let folder = Folder::new("data_limit");
    let (_, large) = table("phong", 96);
    let materials = (0..3).map(|n| {
        let path = folder.file(&format!("{n}.table"));
        fs::write(&path, large.to_string()).unwrap();
        Material::open(path).unwrap()
    });
    let session = session(materials.collect());
    session.require_fit().unwrap();
    let path = folder.file("mine.toml");
    folder.store().save(&path, &session).unwrap();
    let before = fs::read(&path).unwrap();
    let mut store = folder.store();
    let line = store
        .save_with_data(&path, &session)
        .unwrap_err()
        .to_string();
    for expected in [
        "the session with its data is 40.",
        "the limit is 32 MiB (",
        "0.table: 13.6 MiB",
        "2.table: 13.6 MiB",
    ] {
        assert!(line.contains(expected) && !line.contains('\n'), "{line}");
    }
    assert_eq!(fs::read(&path).unwrap(), before);
}
