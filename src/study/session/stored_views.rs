//! How the views of a session stand in its file. A view is a table with its kind and its options, or, as older programs and
//! hands write it, the id of its kind alone: then its options stand under the key `views`, or are those it has at first.

use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;
use toml::{Spanned, Table, Value};

use super::instances::{Views, require_room};
use super::layout::Place;
use super::ready::READY_LAYOUTS;
use crate::views::{Options, ViewKind, find};

/// The key of the kind in the table of a view.
const KIND: &str = "kind";

/// The views of a session, as its file has them.
#[derive(Serialize)]
pub(super) struct Written<'a> {
    layout: Option<Place<&'a Options>>,
    /// The options of views that are closed, by the ids of their kinds.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    views: BTreeMap<&'static str, Table>,
}

impl<'a> Written<'a> {
    /// # Errors
    /// If options cannot be written, which is not so.
    pub(super) fn of(views: &'a Views) -> Result<Self, toml::ser::Error> {
        let closed = views.closed().iter().map(|(kind, options)| {
            let mut table = Table::try_from(options)?;
            table.remove(KIND);
            Ok((*kind, table))
        });
        Ok(Self {
            layout: views.places(),
            views: closed.collect::<Result<_, toml::ser::Error>>()?,
        })
    }
}

/// A problem with the text from this place on.
pub(super) type Problem = (usize, String);

/// The views of a file, and in a line each what is left out of them: what this program knows nothing of.
///
/// # Errors
/// Where the places are broken, a view has unknown options, or the views are too many.
pub(super) fn read(
    layout: Option<Place<Spanned<Value>>>,
    stored: BTreeMap<String, Spanned<Table>>,
) -> Result<(Views, Vec<String>), Problem> {
    let (mut left_out, mut closed) = (Vec::new(), Closed::new());
    for (id, table) in stored {
        match find(&id) {
            Ok(kind) => {
                let options = options(kind.id, table.get_ref().clone());
                let options = options.map_err(|problem| (table.span().start, problem))?;
                closed.insert(kind.id, options);
            }
            Err(error) => left_out.push(format!("{error}: its options are left out")),
        }
    }
    let mut used = BTreeSet::new();
    let places = match layout {
        Some(layout) => placed(&layout, &closed, &mut used, &mut left_out)?,
        None => None,
    };
    // Where no view is left, those of the start are shown.
    let places = places.or_else(|| {
        let [start, ..] = &READY_LAYOUTS;
        (start.layout)().filter_map(&mut |id| {
            let kind = find(id).ok()?;
            used.insert(kind.id);
            Some(bare(kind, &closed))
        })
    });
    let mut views = places.map_or_else(Views::default, Views::from);
    for (kind, options) in closed {
        if !used.contains(kind) {
            views.put_away(options);
        }
    }
    Ok((views, at_most(MOST_SAID, left_out)))
}

/// The most lines that are said of what is left out.
const MOST_SAID: usize = 8;

/// The first of these lines, and how many there are more.
fn at_most(most: usize, mut lines: Vec<String>) -> Vec<String> {
    let more = lines.len().saturating_sub(most);
    if more > 0 {
        lines.truncate(most);
        lines.push(format!("{more} more of the kind"));
    }
    lines
}

/// The views of a layout, without those of kinds that there are not. `used`: the kinds of those that stand by their ids alone.
fn placed(
    layout: &Place<Spanned<Value>>,
    closed: &Closed,
    used: &mut BTreeSet<&'static str>,
    left_out: &mut Vec<String>,
) -> Result<Option<Place<Options>>, Problem> {
    let start = layout.views().first().map_or(0, |view| view.span().start);
    layout.validate().map_err(|problem| (start, problem))?;
    require_room(layout.views().len()).map_err(|error| (start, error.to_string()))?;
    let mut problem = None;
    let places = layout.filter_map(&mut |view| match known(view.get_ref(), closed) {
        Ok(options) => {
            if view.get_ref().is_str() {
                used.insert(options.kind().id);
            }
            Some(options)
        }
        Err(Refused::Unknown(line)) => {
            left_out.push(line);
            None
        }
        Err(Refused::Broken(line)) => {
            problem.get_or_insert((view.span().start, line));
            None
        }
    });
    problem.map_or(Ok(places), Err)
}

/// The options of closed views, by the ids of their kinds.
type Closed = BTreeMap<&'static str, Options>;

/// The options of a view that stands by the id of its kind alone.
fn bare(kind: &ViewKind, closed: &Closed) -> Options {
    let stored = closed.get(kind.id).cloned();
    stored.unwrap_or_else(|| Options::of(kind))
}

enum Refused {
    /// A kind that there is not.
    Unknown(String),
    /// What is no view.
    Broken(String),
}

fn known(view: &Value, closed: &Closed) -> Result<Options, Refused> {
    let unknown = |error: bxdf::Error| Refused::Unknown(format!("{error}: left out"));
    match view {
        Value::String(id) => {
            let kind = find(id).map_err(unknown)?;
            Ok(bare(kind, closed))
        }
        Value::Table(table) => {
            let Some(Value::String(id)) = table.get(KIND) else {
                return Err(Refused::Broken(format!(
                    "a view has no `{KIND}`: the id of a kind of view"
                )));
            };
            let kind = find(id).map_err(unknown)?;
            options(kind.id, table.clone()).map_err(Refused::Broken)
        }
        _ => Err(Refused::Broken(format!(
            "expected a view: the id of its kind, or a table with `{KIND}` and its options"
        ))),
    }
}

/// The options of a kind.
fn options(kind: &str, mut table: Table) -> Result<Options, String> {
    table.insert(KIND.to_owned(), Value::String(kind.to_owned()));
    table
        .try_into()
        .map_err(|error: toml::de::Error| format!("view '{kind}': {}", error.message()))
}

#[cfg(test)]
mod tests {
    use crate::session::{Place, Read, Session, Views};
    use crate::views::{Options, OwnSection, cartesian, polar, tradeoff};

    fn read(text: &str) -> Read {
        Session::read_toml(text, "s.toml").unwrap()
    }

    fn refused(text: &str) -> String {
        let error = Session::read_toml(text, "s.toml").unwrap_err();
        error.to_string()
    }

    fn kinds(views: &Views) -> Vec<&'static str> {
        let ids = views.ids().into_iter();
        ids.map(|id| views.kind(id).unwrap().id).collect()
    }

    #[test]
    fn instances_come_back_as_they_were() {
        let own = |azimuth| polar::Options {
            own_section_deg: OwnSection(azimuth),
            ..polar::Options::default()
        };
        let half = cartesian::Options {
            is_residual: true,
            ..cartesian::Options::default()
        };
        let options: [Options; 4] = [
            own(None).into(),
            half.into(),
            own(Some(30.0)).into(),
            cartesian::Options::default().into(),
        ];
        let [a, b, c, d] = options;
        let tabs = Place::Tabs {
            views: vec![b, c],
            active: 1,
        };
        let row = Place::row(vec![Place::View(a), tabs]);
        let mut session = Session {
            views: Place::column(vec![row, Place::View(d)]).into(),
            ..Session::default()
        };
        let set = |tradeoff: &mut tradeoff::Options| tradeoff.left_out.push("tables".to_owned());
        session.views.each(set);
        let text = session.to_toml().unwrap();
        assert_eq!(text.matches("kind = ").count(), 4, "{text}");
        assert!(text.contains("[views.tradeoff]"), "{text}");
        assert_eq!(read(&text).session, session, "{text}");
        assert!(read(&text).left_out.is_empty());
        // An older program says that it needs a newer one, whatever it makes of the rest.
        assert!(text.contains("\nversion = 3\n"));
    }

    #[test]
    fn ids_alone_have_the_options_of_their_key() {
        let text = "
            layout.row = [{ place.view = \"cartesian\" }, { place.view = \"cartesian\" }, { place.view = \"polar\" }]
            [views.cartesian]
            fixed_deg = 12
            [views.slice]
            phi_d_deg = 30.0
            [views.sphere]
            is_shared = true
            curve = \"soft\"";
        for version in ["", "version = 1\n", "version = 2\n", "version = 3\n"] {
            let views = read(&format!("{version}{text}")).session.views;
            assert_eq!(kinds(&views), ["cartesian", "cartesian", "polar"]);
            let plots = views.all::<cartesian::Options>();
            assert!(plots.len() == 2 && plots.iter().all(|plot| plot.fixed_deg == 12.0));
            // What is open is kept once, and what is as at first not at all.
            let closed: Vec<&str> = views.closed().keys().copied().collect();
            assert_eq!(closed, ["slice"]);
        }
        // The views of the start, where no layout is given.
        let views = read("[views.polar]\nown_section_deg = 20.0").session.views;
        let own = views.options::<polar::Options>().own_section_deg;
        assert_eq!((own, views.closed().len()), (OwnSection(Some(20.0)), 0));
    }

    #[test]
    fn what_is_unknown_is_left_out_in_a_line() {
        let text = "
            layout.row = [{ place.view = \"pola\" }, { place.tabs.views = [{ kind = \"flavour\" }, \"slice\"] }]
            [views.lobe]
            x = 1";
        let Read { session, left_out } = read(text);
        assert_eq!(kinds(&session.views), ["slice"]);
        let expected = [
            "s.toml: unknown view 'lobe'; nearest: lobe3d",
            "s.toml: unknown view 'pola'; nearest: polar",
            "s.toml: unknown view 'flavour'",
        ];
        assert_eq!(left_out.len(), expected.len(), "{left_out:?}");
        for (line, expected) in left_out.iter().zip(expected) {
            assert!(
                line.starts_with(expected) && line.ends_with("left out"),
                "{line}"
            );
        }
        // However many there are, few lines are said.
        let many: Vec<String> = (0..1000).map(|n| format!("[views.x{n}]")).collect();
        let left_out = read(&many.join("\n")).left_out;
        assert_eq!(left_out.len(), 9);
        assert_eq!(left_out[8], "s.toml: 992 more of the kind");
        // Where nothing is left, the start is shown.
        let read = read("layout.view = \"pola\"\n[views.polar]\nown_section_deg = 20.0");
        assert_eq!(kinds(&read.session.views), ["lobe3d", "polar"]);
        let own = read
            .session
            .views
            .options::<polar::Options>()
            .own_section_deg;
        assert_eq!((own, read.left_out.len()), (OwnSection(Some(20.0)), 1));
    }

    #[test]
    fn what_is_broken_is_refused_with_its_line() {
        let many = |count| format!("layout.tabs.views = [{}]", "\"polar\", ".repeat(count));
        assert_eq!(read(&many(32)).session.views.ids().len(), 32);
        for (text, expected) in [
            (
                "layout.view = { kind = \"polar\", flavour = 1 }",
                "line 1: view 'polar': unknown field `flavour`",
            ),
            (
                "\nlayout.view = { fixed_deg = 1 }",
                "line 2: a view has no `kind`",
            ),
            ("layout.view = 3", "line 1: expected a view"),
            ("layout.row = []", "a layout needs a view"),
            (
                "layout.tabs = { views = [\"polar\"], active = 1 }",
                "no tab 1",
            ),
            (
                "[views.cartesian]\nflavour = 1",
                "view 'cartesian': unknown field `flavour`",
            ),
            (
                "[views.cartesian]\nfixed_deg = 100",
                "cartesian.fixed_deg = 100: allowed is 0 to 90 degrees",
            ),
            (
                "layout.view = { kind = \"polar\", own_section_deg = nan }",
                "own_section_deg = NaN: allowed is -360 to 360",
            ),
            ("layout = 3", "line 1: "),
            ("layout.heap = 3", "unknown variant `heap`"),
            (
                &many(33),
                "line 1: the number of views is 33; the limit is 1 to 32",
            ),
        ] {
            let line = refused(text);
            assert!(
                line.contains(expected) && !line.contains('\n'),
                "{text}: {line}"
            );
            assert!(line.starts_with("s.toml"), "{line}");
        }
    }
}
