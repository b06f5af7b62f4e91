use super::*;
use crate::session::{Materials, READY_LAYOUTS};
use bxdf::material::library;

fn eight() -> Session {
    let named = [
        "chalk",
        "brass",
        "gold",
        "plastic",
        "velvet",
        "copper",
        "water",
        "brushed_steel",
    ];
    let all = library::all().iter();
    let mut known: Vec<_> = all.filter(|one| named.contains(&one.id)).collect();
    known.extend(library::all().iter().filter(|one| !named.contains(&one.id)));
    let materials = known.iter().take(8).map(|one| one.material.clone());
    let mut session = Session {
        materials: Materials::new(materials.collect()).unwrap(),
        ..Session::default()
    };
    session.set_theta_deg(52.5);
    let compare = READY_LAYOUTS.iter().last().unwrap();
    session.views.show_ready(compare, [1280.0, 800.0]);
    session
}

fn session_of(fragment: &str) -> Session {
    match read(fragment).unwrap() {
        Linked::Session(opened) => opened.into_session(),
        Linked::Step(step) => panic!("{step} is a step"),
    }
}

/// The link to a text, whatever it says.
fn link_to(text: &str) -> String {
    format!("{SESSION}{}", packed(text).unwrap())
}

#[test]
fn a_session_comes_back_and_eight_named_materials_fit_an_address() {
    for session in [Session::default(), eight()] {
        let made = to_session(&session).unwrap();
        assert_eq!(session_of(&made.fragment), session);
        assert!(made.left_behind.is_empty());
        assert!(made.fragment.len() < 2000, "{}", made.fragment.len());
    }
}

#[test]
fn what_was_changed_of_a_named_material_travels() {
    let mut session = eight();
    let material = &mut session.materials.selected_mut().material;
    material.note = "mine".to_owned();
    assert_eq!(session_of(&to_session(&session).unwrap().fragment), session);
    session.materials.selected_mut().material.note = String::new();
    assert_eq!(session_of(&to_session(&session).unwrap().fragment), session);
}

#[test]
fn links_are_told_from_other_texts() {
    let made = to_session(&Session::default()).unwrap().fragment;
    for text in [
        made.clone(),
        format!(" https://a.example/b/{made}\n"),
        format!("http://a/?theme=dark{made}"),
    ] {
        assert_eq!(fragment_of(&text), Some(&*made));
    }
    for text in [
        "",
        "#",
        "#t=3",
        "phong",
        "# BRDF Explorer session",
        "see https://a.b/#s=3",
        "x#s=3",
    ] {
        assert_eq!(fragment_of(text), None, "{text}");
    }
    assert_eq!(
        fragment_of(&to_step("06-lambert.2")),
        Some("#lesson=06-lambert.2")
    );
    assert_eq!(
        read("#lesson=06-lambert.2").unwrap(),
        Linked::Step("06-lambert.2".to_owned())
    );
}

#[test]
fn what_is_cut_off_damaged_or_newer_is_refused_in_one_line() {
    let made = to_session(&eight()).unwrap().fragment;
    let cut = &made[..made.len() - 7];
    let mut damaged = made.clone().into_bytes();
    damaged[made.len() / 2] ^= 1;
    let damaged = String::from_utf8(damaged).unwrap();
    let refused = [
        (cut.to_owned(), "cut off or damaged"),
        (damaged, "cut off or damaged"),
        ("#s=".to_owned(), "cut off or damaged"),
        ("#s=ä".to_owned(), "cut off or damaged"),
        ("#x=1".to_owned(), "'#x=1' is none"),
        (link_to("version = 99"), "newer"),
        (link_to("material = \"phong:exponent=NaN\""), "exponent"),
        (
            link_to("[[materials]]\nmaterial = { named = \"gould\" }"),
            "gold",
        ),
        (link_to("= 3"), "link"),
        (link_to(&"#".repeat(2 << 20)), "1 MiB"),
        (
            link_to(&format!("x = {}1{}", "[".repeat(40), "]".repeat(40))),
            "nesting",
        ),
        (
            link_to(&"[[materials]]\nmaterial = \"phong\"\n".repeat(17)),
            "number of materials",
        ),
    ];
    for (link, expected) in refused {
        let line = read(&link).unwrap_err().to_string();
        assert!(line.contains(expected) && !line.contains('\n'), "{line}");
    }
    let many = Materials::new(vec!["phong".parse().unwrap(); 17]).unwrap();
    let many = Session {
        materials: many,
        ..Session::default()
    };
    assert!(to_session(&many).is_err());
}

#[test]
fn no_path_travels_and_none_is_looked_for() {
    let file = "[[materials]]\n[materials.material]\n[[materials.material.lobes]]\nmodel = \"table\"\ndata = { file = \"/home/me/secret/brass.binary\" }";
    let session = Session::from_toml(file, "s").unwrap();
    let made = to_session(&session).unwrap();
    assert_eq!(made.left_behind, ["brass.binary"]);
    let text = unpacked(made.fragment.strip_prefix(SESSION).unwrap()).unwrap();
    assert!(
        text.contains("brass.binary") && !text.contains("secret"),
        "{text}"
    );
    // A link made by somebody else may name a path: it is none here.
    for link in [
        made.fragment,
        link_to(file),
        link_to(&file.replace("/home/me/secret/", "..\\\\")),
    ] {
        let Linked::Session(opened) = read(&link).unwrap() else {
            panic!("a session is no step");
        };
        let remarks = opened.remarks();
        let [remark] = &remarks[..] else {
            panic!("{remarks:?}");
        };
        assert!(
            remark.contains("brass.binary is missing: it does not travel"),
            "{remark}"
        );
        assert!(opened.into_session().awaited().is_empty());
    }
}
