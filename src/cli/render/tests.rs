//! What is read and what is refused.

use clap::{CommandFactory as _, FromArgMatches as _, Parser};

use super::super::with_hyphens;
use super::*;

#[derive(Parser, Debug)]
struct Line {
    #[command(flatten)]
    arguments: Arguments,
}

fn parse(line: &str) -> std::result::Result<RenderArgs, String> {
    let words = std::iter::once("render").chain(line.split_whitespace());
    let command = with_hyphens(Line::command());
    let line = command
        .try_get_matches_from(words)
        .and_then(|matches| Line::from_arg_matches(&matches))
        .map_err(|error| error.to_string())?;
    line.arguments.request().map_err(|error| error.to_string())
}

#[test]
fn everything_has_a_default_but_the_picture() {
    let request = parse("-o start.PNG").unwrap();
    let expected = RenderArgs {
        session: None,
        materials: Vec::new(),
        hold: None,
        direction_deg: None,
        view: None,
        figure: None,
        size: [1280, 800],
        scale: 1.0,
        theme: None,
        output: "start.PNG".into(),
    };
    assert_eq!(request, expected);
    assert!(parse("").unwrap_err().contains("-o"));
}

#[test]
fn every_argument_is_read() {
    let request = parse(
        "--session s.toml --material oren_nayar:sigma=30 --material rough_conductor --hold wo \
         --direction 60,-30 --view polar --size 1024x640 --scale 1.5 --theme light -o out/a.png",
    )
    .unwrap();
    assert_eq!(request.session, Some("s.toml".into()));
    let materials: Vec<String> = request.materials.iter().map(ToString::to_string).collect();
    assert_eq!(materials, ["oren_nayar:sigma=30", "rough_conductor"]);
    assert_eq!(request.hold, Some(Hold::Viewer));
    assert_eq!(request.direction_deg, Some([60.0, -30.0]));
    assert_eq!(request.view.as_deref(), Some("polar"));
    assert_eq!(request.pixels(), [1536, 960]);
    assert_eq!(request.theme, Some(Theme::Light));
    assert_eq!(request.output, PathBuf::from("out/a.png"));
}

#[test]
fn bad_arguments_are_refused() {
    for (line, expected) in [
        (
            "--size 0",
            "size '0': expected WxH in points, each 1 to 8192",
        ),
        ("--size 0x10", "expected WxH in points"),
        ("--size 10x", "expected WxH in points"),
        ("--size 9000x10", "expected WxH in points"),
        ("--size -5x10", "expected WxH in points"),
        (
            "--size 8000x10 --scale 2",
            "the picture is 16000x20 pixels; the limit is 1 to 8192 to a side",
        ),
        ("--size 1x1 --scale .25", "the picture is 0x0 pixels"),
        (
            "--scale 0",
            "scale '0': expected 0.25 to 8 pixels per point",
        ),
        ("--scale nan", "expected 0.25 to 8"),
        ("--scale -1", "expected 0.25 to 8"),
        ("--theme dusk", "unknown theme 'dusk'; nearest: dark, light"),
        ("--figure poster", "unknown figure 'poster'; nearest: "),
        (
            "--figure slide --size 10x10",
            "--figure slide: it has a size of its own: --size goes with --figure screen only",
        ),
        (
            "--figure column --scale 2",
            "--scale goes with --figure screen only",
        ),
        (
            "--hold wm",
            "unknown direction to hold 'wm'; nearest: wi, wo",
        ),
        (
            "--direction 200,0",
            "theta '200': expected 0 to 180 degrees",
        ),
        (
            "--material plastre",
            "unknown material 'plastre'; nearest: plast",
        ),
    ] {
        let message = parse(&format!("{line} -o a.png")).unwrap_err();
        assert!(message.contains(expected), "{line}: {message}");
    }
    let refused = require_png(Path::new("a.jpg")).unwrap_err().to_string();
    assert!(refused.contains("ends in .png"), "{refused}");
}
