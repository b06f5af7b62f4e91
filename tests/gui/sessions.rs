//! Sessions that older versions of the program wrote open and look as they did.

use std::fs;
use std::path::PathBuf;

use brdf_explorer::study::session::Session;
use brdf_explorer::study::views::{
    cartesian, decomposition, hemisphere, reflectance, sampling, slice, sphere, stability, tradeoff,
};

use super::Folder;
use super::render::{program, refused};

/// The stored sessions, by name: those of version 1 the program has written, but for the one by hand.
pub(super) fn stored() -> Vec<(String, Session)> {
    let files = fs::read_dir("tests/data/sessions").unwrap();
    let mut paths: Vec<PathBuf> = files.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let read = |path: PathBuf| {
        let text = fs::read_to_string(&path).unwrap();
        let read = Session::read_toml(&text, &path.display().to_string()).unwrap();
        assert!(read.left_out.is_empty(), "{:?}", read.left_out);
        let name = path.file_stem().unwrap().to_str().unwrap();
        (name.to_owned(), read.session)
    };
    paths.into_iter().map(read).collect()
}

fn session(name: &str) -> Session {
    let mut all = stored().into_iter();
    all.find(|(other, _)| other == name).unwrap().1
}

#[test]
fn stored_sessions_are_read_and_written_as_they_are() {
    let all = stored();
    assert_eq!(all.len(), 4);
    for (name, session) in all {
        let text = session.to_toml().unwrap();
        assert_eq!(Session::from_toml(&text, &name).unwrap(), session, "{text}");
    }
    // The start was another one then: its session shows what it showed.
    let mut start = session("default");
    let ids = start.views.ids();
    let kinds = ids.iter().map(|id| start.views.kind(*id).unwrap().id);
    assert_eq!(kinds.collect::<Vec<_>>(), ["polar", "lobe3d"]);
    start.views = Session::default().views;
    assert_eq!(start, Session::default());
}

/// Open or closed, the options of version 1 are those of the first view of their kind.
#[test]
fn no_option_of_a_stored_session_is_lost() {
    for name in ["every_option", "closed_views"] {
        let views = session(name).views;
        let cartesian: cartesian::Options = views.options();
        assert!(cartesian.fixed_deg == 42.5 && cartesian.scale.is_each_to_peak);
        let hemisphere: hemisphere::Options = views.options();
        assert!(!hemisphere.has_contours && !hemisphere.is_logarithmic);
        let reflectance: reflectance::Options = views.options();
        assert!(reflectance.is_furnace);
        let slice: slice::Options = views.options();
        assert!(slice.phi_d_deg == 60.0 && slice.is_square_root);
        let sphere: sphere::Options = views.options();
        assert_eq!((sphere.phi_deg, sphere.exposure), (-60.0, 1.5));
        let sampling: sampling::Options = views.options();
        assert_eq!((sampling.count_log2, sampling.seed), (10, 7));
        let decomposition: decomposition::Options = views.options();
        assert!(decomposition.is_stacked && decomposition.is_logarithmic);
        let tradeoff: tradeoff::Options = views.options();
        assert!(tradeoff.tolerance == 0.05 && tradeoff.left_out.len() == 4);
        let stability: stability::Options = views.options();
        assert_eq!((&*stability.x, &*stability.trial), ("theta_o", "gtr1"));
    }
    let by_hand: cartesian::Options = session("by_hand").views.options();
    assert!(by_hand.scale.lengths.is_logarithmic());
}

#[test]
fn the_command_line_says_what_it_leaves_out() {
    let folder = Folder::new("left_out");
    let (file, table) = (folder.file("s.toml"), folder.file("t.csv"));
    let text = "layout.row = [{ place.view = \"pola\" }, { place.view = { kind = \"cartesian\", is_normalised = true } }]\n";
    fs::write(&file, text).unwrap();
    let run = || {
        let mut command = program(&["export", "--view", "cartesian", "--session"]);
        command.arg(&file).arg("-o").arg(&table).output().unwrap()
    };
    let output = run();
    assert!(output.status.success());
    let line = String::from_utf8(output.stderr).unwrap();
    assert!(
        line.contains("s.toml: unknown view 'pola'; nearest: polar") && line.lines().count() == 1,
        "{line}"
    );
    let table = fs::read_to_string(&table).unwrap();
    assert!(table.starts_with("material,angle (degrees),f_over_peak_r,"));
    fs::write(&file, text.replace("is_normalised", "flavour")).unwrap();
    refused(&run(), "view 'cartesian': unknown field `flavour`");
}
