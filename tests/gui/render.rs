//! The `render` verb and the refusals of the window.

use std::process::{Command, Output};

use super::Folder;

pub(super) fn program(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_brdf-explorer"));
    command.args(arguments);
    command
}

pub(super) fn refused(output: &Output, expected: &str) {
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains(expected), "{message}");
}

#[test]
fn two_runs_give_the_same_bytes_in_the_size_asked_for() {
    let folder = Folder::new("render");
    let bytes = ["a.png", "b.png"].map(|name| {
        let file = folder.file(name);
        let output = program(&[
            "render",
            "--material",
            "oren_nayar:sigma=30",
            "--direction",
            "35,120",
            "--hold",
            "wo",
        ])
        .args([
            "--size", "700x500", "--scale", "1.5", "--theme", "light", "-o",
        ])
        .arg(&file)
        .output()
        .unwrap();
        assert!(
            output.status.success(),
            "{}",
            String::from_utf8_lossy(&output.stderr)
        );
        std::fs::read(file).unwrap()
    });
    assert!(bytes[0] == bytes[1], "the two pictures differ");
    let image = image::load_from_memory(&bytes[0]).unwrap();
    assert_eq!((image.width(), image.height()), (1050, 750));
}

#[test]
fn a_direction_is_drawn_as_given() {
    let folder = Folder::new("direction");
    let bytes = ["89.97,180", "90,180"].map(|direction| {
        let file = folder.file("d.png");
        let output = program(&[
            "render",
            "--size",
            "900x600",
            "--direction",
            direction,
            "-o",
        ])
        .arg(&file)
        .output()
        .unwrap();
        assert!(output.status.success());
        std::fs::read(file).unwrap()
    });
    assert!(bytes[0] != bytes[1], "no widget may round the session");
}

#[test]
fn a_session_file_is_drawn() {
    let folder = Folder::new("session");
    let (session, picture) = (folder.file("s.toml"), folder.file("s.png"));
    std::fs::write(
        &session,
        "material = \"retro_reflector\"\ntheta_deg = 30.0\nshow_geometry = true\n",
    )
    .unwrap();
    let draw = |arguments: &[&str]| {
        let output = program(&["render", "--size", "400x300"])
            .args(arguments)
            .arg("--session")
            .arg(&session)
            .arg("-o")
            .arg(&picture)
            .output()
            .unwrap();
        (output, std::fs::read(&picture).unwrap_or_default())
    };
    let (output, whole) = draw(&[]);
    assert!(output.status.success() && !whole.is_empty());
    let (_, one_view) = draw(&["--view", "polar"]);
    assert!(one_view != whole);
    std::fs::write(
        &session,
        "material = \"retro_reflector\"\ntheta_deg = \"low\"\n",
    )
    .unwrap();
    std::fs::remove_file(&picture).unwrap();
    let (output, left) = draw(&[]);
    refused(&output, "line 2");
    assert!(left.is_empty(), "no picture is left behind");
}

#[test]
fn no_window_is_too_small_or_too_flat() {
    let folder = Folder::new("small");
    for size in ["1x1", "64x64", "300x200", "420x260", "760x480", "3000x100"] {
        for view in [&[][..], &["--view", "polar"], &["--view", "lobe3d"]] {
            let output = program(&["render", "--size", size, "-o"])
                .arg(folder.file("x.png"))
                .args(view)
                .output()
                .unwrap();
            assert!(
                output.status.success(),
                "{size} {view:?}: {}",
                String::from_utf8_lossy(&output.stderr)
            );
        }
    }
}

#[test]
fn bad_requests_are_one_line_each() {
    let folder = Folder::new("refused");
    let file = folder.file("x.png");
    let run = |arguments: &[&str]| {
        let output = program(&["render"])
            .args(arguments)
            .arg("-o")
            .arg(&file)
            .output()
            .unwrap();
        assert!(!file.exists());
        output
    };
    refused(
        &run(&["--view", "pola"]),
        "unknown view 'pola'; nearest: polar",
    );
    refused(&run(&["--size", "0x100"]), "each 1 to 8192");
    refused(
        &run(&["--size", "5000x100", "--scale", "2"]),
        "the limit is 1 to 8192 to a side",
    );
    refused(
        &run(&["--material", "oren_nayar"].repeat(33)),
        "the limit is 1 to 32",
    );
    refused(&run(&["--session", "nowhere.toml"]), "nowhere.toml");
    let unwritable = program(&["render", "--size", "64x64", "-o", "/nonexistent/x.png"])
        .output()
        .unwrap();
    refused(&unwritable, "/nonexistent/x.png");
}

#[test]
#[cfg(target_os = "linux")]
fn a_missing_display_or_adapter_names_the_remedy() {
    let mut window = program(&[]);
    for name in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"] {
        window.env_remove(name);
    }
    refused(&window.output().unwrap(), "no display is found");
    let mut blind = program(&["render", "-o", "/tmp/never.png"]);
    // The loaders of Vulkan and EGL are told of drivers that do not exist.
    for name in [
        "VK_DRIVER_FILES",
        "VK_ICD_FILENAMES",
        "__EGL_VENDOR_LIBRARY_FILENAMES",
        "LIBGL_DRIVERS_PATH",
    ] {
        blind.env(name, "/nonexistent");
    }
    refused(&blind.output().unwrap(), "install a Vulkan driver");
}
