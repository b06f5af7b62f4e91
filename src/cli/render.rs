//! `render`: the window as a picture. The one file of the command line that knows the window; its arguments are those of
//! `export` too.

use std::path::{Path, PathBuf};

use super::args::{self, Angles, Given};
use super::output;
use bxdf::Material;
use bxdf::error::{Error, Result, shown};
use bxdf_lab::analysis::Hold;
use bxdf_study::colors::Theme;
use bxdf_study::export::Format;
use bxdf_study::export::figure::{USES, Use};
use bxdf_study::lessons::Named;
use bxdf_study::session::{Materials, Session, ViewId, wrapped_deg};
use bxdf_study::views::{self, ViewKind, tradeoff};

mod lesson;
mod origin;

/// The widest and tallest picture, in pixels: what graphics adapters of the lowest class can draw into.
const MAX_PIXELS: u32 = 8192;

/// The size of the window in points, where none is given.
const WINDOW: [u32; 2] = [1280, 800];

/// The pixels per point that are accepted: text is illegible below, and no screen is finer.
const SCALE_RANGE: std::ops::RangeInclusive<f64> = 0.25..=8.0;

/// The only kind of picture written.
const EXTENSION: &str = "png";

/// The arguments of `render`: of a picture, or of a lesson.
#[derive(clap::Args, Debug)]
pub(super) struct OfWindow {
    #[command(flatten)]
    picture: Arguments,
    #[command(flatten)]
    lesson: lesson::OfLesson,
}

/// The arguments of a picture.
#[derive(clap::Args, Debug)]
pub struct Arguments {
    /// The session to start from: a file, or a link to one (...#s=...)
    #[arg(long, value_name = "FILE|LINK")]
    session: Option<PathBuf>,
    /// A material to show, may be given several times: id of a model or named material, id:name=value,name=value, a material file or a file of data
    #[arg(long = "material", value_name = "MATERIAL", value_parser = args::material())]
    materials: Vec<Given>,
    /// The direction held while the lobe is drawn over the other: wi or wo
    #[arg(long, value_parser = hold)]
    hold: Option<Hold>,
    /// The direction held, in degrees, theta from the normal
    #[arg(long, value_name = "THETA,PHI", value_parser = args::angles)]
    direction: Option<Angles>,
    /// The view to show alone
    #[arg(long, value_name = "ID", help = view_help())]
    view: Option<String>,
    /// What for: slide (1920x1080 pixels), column (88 mm wide), web (at most 640x400 points at 2 pixels each), or screen, as the window has it
    #[arg(long, value_name = "USE", value_parser = figure)]
    figure: Option<Use>,
    /// The size in points of the window, or of the view on the screen [default: 1280x800]
    #[arg(long, value_name = "WxH", value_parser = size)]
    size: Option<[u32; 2]>,
    /// Pixels per point [default: 1]
    #[arg(long, value_parser = scale)]
    scale: Option<f64>,
    /// The theme: dark or light [default: light for slide, column and web, else dark]
    #[arg(long, value_parser = theme)]
    theme: Option<Theme>,
    /// The file to write: a .png of `render`; of `export` the end of its name says what: png, svg, csv, obj, gltf, toml
    #[arg(short, value_name = "FILE")]
    output: PathBuf,
}

/// What `render` is asked for, validated. `None` leaves the choice to the session.
#[derive(Clone, Debug, PartialEq)]
pub struct RenderArgs {
    /// The session to start from, a file.
    pub session: Option<PathBuf>,
    /// The materials to show in place of the session's; none keeps those.
    pub materials: Vec<Material>,
    /// Which direction is held.
    pub hold: Option<Hold>,
    /// The direction held: theta (0 to 180) and phi in degrees.
    pub direction_deg: Option<[f64; 2]>,
    /// The id of the view to show alone, not yet looked up.
    pub view: Option<String>,
    /// What the picture is for, where that is said.
    pub figure: Option<Use>,
    /// Width and height in points, above 0; without meaning where the figure has a page of its own.
    pub size: [u32; 2],
    /// Pixels per point, above 0; as the size.
    pub scale: f64,
    /// The theme.
    pub theme: Option<Theme>,
    /// The file to write.
    pub output: PathBuf,
}

impl RenderArgs {
    /// Width and height of the picture in pixels: size times scale, rounded.
    #[must_use]
    pub fn pixels(&self) -> [u32; 2] {
        self.size
            .map(|points| (f64::from(points) * self.scale).round() as u32)
    }
}

impl Arguments {
    /// Refuses what only a picture has.
    fn refuse_looks(&self) -> Result<()> {
        let given = [
            ("--size", self.size.is_some()),
            ("--scale", self.scale.is_some()),
            ("--theme", self.theme.is_some()),
        ];
        match given.into_iter().find(|(_, is_given)| *is_given) {
            None => Ok(()),
            Some((argument, _)) => Err(Error::parse(
                argument,
                "a sheet is on A4, and light: it goes with a picture (.png) only",
            )),
        }
    }

    /// The request, with the limits that concern several arguments checked.
    ///
    /// # Errors
    /// [`Error::Limit`] where the picture would be empty or larger than 8192 pixels to a side; [`Error::Parse`] where a figure
    /// that has a size is given another one.
    pub fn request(&self) -> Result<RenderArgs> {
        let given = [
            ("--size", self.size.is_some()),
            ("--scale", self.scale.is_some()),
        ];
        let sized = self
            .figure
            .map(Use::spec)
            .filter(|spec| spec.page.is_some());
        let other = given.into_iter().find(|(_, is_given)| *is_given);
        if let (Some(spec), Some((argument, _))) = (sized, other) {
            return Err(Error::parse(
                format!("--figure {}", spec.id),
                format!("it has a size of its own: {argument} goes with --figure screen only"),
            ));
        }
        let request = RenderArgs {
            session: self.session.clone(),
            materials: self
                .materials
                .iter()
                .map(|given| given.checked().clone())
                .collect(),
            hold: self.hold,
            direction_deg: self
                .direction
                .map(|angles| [angles.theta_deg, angles.phi_deg]),
            view: self.view.clone(),
            figure: self.figure,
            size: self.size.unwrap_or(WINDOW),
            scale: self.scale.unwrap_or(1.0),
            theme: self.theme,
            output: self.output.clone(),
        };
        let [width, height] = request.pixels();
        if [width, height]
            .iter()
            .any(|side| !(1..=MAX_PIXELS).contains(side))
        {
            return Err(Error::Limit {
                what: "the picture",
                value: format!("{width}x{height} pixels"),
                limit: format!("1 to {MAX_PIXELS} to a side"),
            });
        }
        Ok(request)
    }
}

/// Renders the picture, or the sheet of a lesson.
///
/// # Errors
/// Where the session cannot be read, the view is unknown, no adapter is found, or the picture cannot be written, and in a
/// build without the window.
pub(super) fn run(arguments: &OfWindow) -> Result<()> {
    let request = &arguments.picture.request()?;
    if let Some(named) = arguments.lesson.named() {
        let bytes = if output::ends_in(&request.output, lesson::PAPER) {
            arguments.picture.refuse_looks()?;
            lesson::sheet(named)?
        } else {
            require_png(&request.output)?;
            step(named, request)?
        };
        return output::write(&request.output, &bytes);
    }
    require_png(&request.output)?;
    let (session, view) = chosen(request, None)?;
    if view.is_none()
        && let Some(spec) = request.figure.map(Use::spec)
        && spec.page.is_some()
    {
        return Err(Error::parse(
            format!("--figure {}", spec.id),
            "a figure is of one view: name it with --view",
        ));
    }
    let bytes = drawn(request, session, view, Format::Png)?;
    output::write(&request.output, &bytes)
}

/// The picture or drawing of `session`, of `view` alone where it is given.
///
/// # Errors
/// Where no adapter is found or the view has no drawing, and in a build without the window.
#[cfg(feature = "gui")]
pub(super) fn drawn(
    request: &RenderArgs,
    session: Session,
    view: Option<ViewId>,
    format: Format,
) -> Result<Vec<u8>> {
    bxdf_ui::export::bytes(picture(request, session, view), format)
}

/// The window with the panel of a lesson open, at its first step where none is named.
///
/// # Errors
/// Where no adapter is found, and in a build without the window.
#[cfg(feature = "gui")]
fn step(named: &Named, request: &RenderArgs) -> Result<Vec<u8>> {
    let picture = picture(request, Session::default(), None);
    picture.png_of_lesson(&named.lesson, named.step.unwrap_or(0))
}

/// No picture: this build has no window.
///
/// # Errors
/// Always.
#[cfg(not(feature = "gui"))]
fn step(_: &Named, _: &RenderArgs) -> Result<Vec<u8>> {
    Err(super::say::no_window())
}

/// The picture of `session`, of `view` alone where it is given, before it is drawn.
#[cfg(feature = "gui")]
fn picture(
    request: &RenderArgs,
    session: Session,
    view: Option<ViewId>,
) -> bxdf_ui::headless::Picture {
    use bxdf_ui::headless::{OnScreen, Picture, Title};

    let purpose = request.figure.unwrap_or(Use::Screen);
    let theme = request.theme.unwrap_or(purpose.theme());
    let (size, scale) = (request.size, request.scale as f32);
    match view.filter(|_| purpose != Use::Screen) {
        Some(view) => {
            let screen = OnScreen { size, scale };
            Picture::of_figure(session, view, (purpose, Title::Automatic, theme), screen)
        }
        None => Picture {
            session,
            only: view,
            size,
            scale,
            theme: bxdf_ui::theme::as_drawn(theme),
            figure: None,
        },
    }
}

/// No picture: this build has no window.
///
/// # Errors
/// Always.
#[cfg(not(feature = "gui"))]
pub(super) fn drawn(_: &RenderArgs, _: Session, _: Option<ViewId>, _: Format) -> Result<Vec<u8>> {
    Err(super::say::no_window())
}

/// The session to draw, and the view to draw alone: the first of the kind that is asked for by name, or of the `usual` one
/// where none is.
///
/// # Errors
/// Where there is no kind of this name, and those of [`session`].
pub(super) fn chosen(
    request: &RenderArgs,
    usual: Option<&'static ViewKind>,
) -> Result<(Session, Option<ViewId>)> {
    let mut session = session(request)?;
    let named = request.view.as_deref().map(views::find).transpose()?;
    let view = named.or(usual).map(|kind| session.views.show_alone(kind));
    Ok((session, view))
}

/// The session to draw, before a view of it is chosen: the file's, the link's or the start, changed by what else was asked for.
///
/// # Errors
/// Where it cannot be read, and where the materials are too many.
fn session(request: &RenderArgs) -> Result<Session> {
    let mut session = match &request.session {
        None => Session::default(),
        Some(path) => origin::read(path)?,
    };
    if !request.materials.is_empty() {
        session.materials = Materials::new(request.materials.clone())?;
    }
    if let Some(hold) = request.hold {
        session.hold = hold;
    }
    if let Some([theta_deg, phi_deg]) = request.direction_deg {
        session.theta_deg = theta_deg;
        session.phi_deg = wrapped_deg(phi_deg);
    }
    // Nobody is there to press the button.
    let views = &mut session.views;
    views.each(|tradeoff: &mut tradeoff::Options| tradeoff.is_immediate = true);
    Ok(session)
}

/// What `--view` is, with the id of every kind there is.
fn view_help() -> String {
    let ids: Vec<&str> = views::VIEWS.iter().map(|kind| kind.id).collect();
    format!("The view to show alone: {}", ids.join(", "))
}

fn hold(text: &str) -> Result<Hold> {
    args::choice(
        "direction to hold",
        text,
        &[("wi", Hold::Light), ("wo", Hold::Viewer)],
    )
}

fn theme(text: &str) -> Result<Theme> {
    args::choice(
        "theme",
        text,
        &[("dark", Theme::Dark), ("light", Theme::Light)],
    )
}

fn figure(text: &str) -> Result<Use> {
    let all = USES.each_ref().map(|spec| (spec.id, spec.purpose));
    args::choice("figure", text, &all)
}

fn size(text: &str) -> Result<[u32; 2]> {
    let problem = || {
        Error::parse(
            format!("size '{}'", shown(text)),
            format!("expected WxH in points, each 1 to {MAX_PIXELS}"),
        )
    };
    let is_allowed = |side: &u32| (1..=MAX_PIXELS).contains(side);
    let side = |text: &str| text.parse().ok().filter(is_allowed).ok_or_else(problem);
    let (width, height) = text.split_once('x').ok_or_else(problem)?;
    Ok([side(width)?, side(height)?])
}

fn scale(text: &str) -> Result<f64> {
    let scale = args::finite(text).filter(|scale| SCALE_RANGE.contains(scale));
    scale.ok_or_else(|| {
        let (min, max) = (SCALE_RANGE.start(), SCALE_RANGE.end());
        Error::parse(
            format!("scale '{}'", shown(text)),
            format!("expected {min} to {max} pixels per point"),
        )
    })
}

/// Refuses a name that is not a picture's.
fn require_png(path: &Path) -> Result<()> {
    if output::ends_in(path, EXTENSION) {
        return Ok(());
    }
    Err(Error::parse(
        format!("picture '{}'", path.display()),
        "expected a name that ends in .png, or with --lesson in .pdf",
    ))
}

#[cfg(test)]
mod tests;
