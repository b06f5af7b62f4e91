//! The bar at the top: the menus, the arrangements, and what is of the whole window.

use std::path::PathBuf;

use egui::{Align, Button, Id, Layout, RichText, Ui};

use crate::app::App;
use crate::commands::{self, COMMANDS, Command, Group, OPEN};
use crate::theme;
use crate::widgets::{at_right, layouts, menus, options};

/// The commands at the right end that have a sign.
const SIGNS: [(&Command, &str); 4] = [
    (&commands::UNDO, "⟲"),
    (&commands::REDO, "⟳"),
    (&commands::HELP, "?"),
    (&commands::PRESENT, "🖵"),
];

impl App {
    /// The bar.
    pub(super) fn show_top(&mut self, ui: &mut Ui) {
        let height = ui.spacing().interact_size.y.max(theme::TOP_BAR_HEIGHT);
        let room = egui::vec2(ui.available_width(), height);
        let layout = Layout::left_to_right(Align::Center);
        let is_small = self.is_small();
        let top = ui.allocate_ui_with_layout(room, layout, |ui| {
            if is_small {
                self.show_small(ui)
            } else {
                self.show_wide(ui)
            }
        });
        self.run(top.inner, ui.ctx());
    }

    /// All in one line. Returns the command chosen.
    fn show_wide(&mut self, ui: &mut Ui) -> Option<&'static Command> {
        let has_words = ui.available_width() >= theme::WORDS_WIDTH;
        ui.label(RichText::new("BRDF Explorer").heading());
        let mut wished = self.file_menu(ui);
        wished = self.edit_menu(ui).or(wished);
        ui.separator();
        wished = self.arrangements(ui, has_words).or(wished);
        let icons = Id::unique("icons of the top bar");
        let gap = ui.spacing().item_spacing.x;
        let free = (ui.available_width() - at_right::width(ui, icons) - 2.0 * gap).max(0.0);
        let field = free.min(theme::SEARCH_FIELD_WIDTH);
        ui.add_space(free - field);
        if commands::SEARCH.field_button(ui, self, field) {
            wished = Some(&commands::SEARCH);
        }
        at_right::show(ui, icons, |ui| {
            for (command, sign) in SIGNS {
                if command.icon(ui, self, sign) {
                    wished = Some(command);
                }
            }
            options::display_menu(ui, "🌙", &mut self.labels);
        });
        wished
    }

    /// All menus in one, and beside it what is asked for most. Returns the command chosen.
    fn show_small(&mut self, ui: &mut Ui) -> Option<&'static Command> {
        let mut wished = None;
        let menu = ui.menu_button("☰", |ui| {
            wished = menus::entries(ui, |ui| self.all_menus(ui));
        });
        ui.ctx()
            .accesskit_node_builder(menu.response.id, |node| node.set_label("Menu"));
        let is_open = !self.is_side_folded(ui.ctx());
        let drawer = ui.add(Button::new("Materials").selected(is_open));
        if drawer
            .on_hover_text(commands::FOLD.hint(ui.ctx()))
            .clicked()
        {
            wished = Some(&commands::FOLD);
        }
        at_right::show(ui, Id::unique("icons of the small top bar"), |ui| {
            let of_edits = SIGNS
                .into_iter()
                .filter(|(command, _)| command.group == Group::Edit);
            for (command, sign) in of_edits.chain([(&commands::SEARCH, "🔍")]) {
                if command.icon(ui, self, sign) {
                    wished = Some(command);
                }
            }
        });
        wished
    }

    /// What is in that one menu. Returns the command chosen.
    fn all_menus(&mut self, ui: &mut Ui) -> Option<&'static Command> {
        let mut wished = self.file_menu(ui);
        wished = self.edit_menu(ui).or(wished);
        ui.separator();
        wished = self.arrangements(ui, true).or(wished);
        ui.separator();
        for (command, _) in SIGNS {
            if command.group != Group::Edit && command.menu_item(ui, self) {
                wished = Some(command);
            }
        }
        options::display_menu(ui, "Theme", &mut self.labels);
        wished
    }

    /// The arrangements and the menu of views, one after the other. Returns the command chosen.
    fn arrangements(&mut self, ui: &mut Ui, has_words: bool) -> Option<&'static Command> {
        let mut wished = None;
        let room = self.room_of_views();
        layouts::arrangements(ui, &mut self.session.views, room, has_words);
        let hint = commands::LEARN.hint(ui.ctx());
        if layouts::learn(ui, self.is_learning(), has_words, &hint) {
            wished = Some(&commands::LEARN);
        }
        if commands::FOUR_KINDS.button(ui, self) {
            wished = Some(&commands::FOUR_KINDS);
        }
        let opened = layouts::menu(ui, &mut self.session.views, room);
        self.notice.report(opened);
        wished
    }

    /// The menu of edits. Returns the command chosen.
    fn edit_menu(&self, ui: &mut Ui) -> Option<&'static Command> {
        let mut wished = None;
        ui.menu_button("Edit", |ui| {
            let of_edits = |command: &&&Command| command.group == Group::Edit;
            for command in COMMANDS.iter().filter(of_edits) {
                if command.menu_item(ui, self) {
                    wished = Some(*command);
                }
            }
        });
        wished
    }

    /// The menu of files. Returns the command chosen.
    fn file_menu(&mut self, ui: &mut Ui) -> Option<&'static Command> {
        let (mut wished, mut recent) = (None, None);
        ui.menu_button("File", |ui| {
            menus::entries(ui, |ui| {
                let of_files = |command: &&&Command| command.group == Group::File;
                for command in COMMANDS.iter().filter(of_files) {
                    if command.menu_item(ui, self) {
                        wished = Some(*command);
                    }
                    if command.id == OPEN.id {
                        recent = self.recent_menu(ui);
                    }
                }
            });
        });
        if let Some(path) = recent {
            self.open(&path, ui.ctx());
        }
        wished
    }

    /// The files opened or saved last. Returns the one chosen.
    fn recent_menu(&self, ui: &mut Ui) -> Option<PathBuf> {
        let recent = self.recent_files();
        let mut chosen = None;
        ui.add_enabled_ui(!recent.is_empty(), |ui| {
            ui.menu_button("Open recent", |ui| {
                for path in recent {
                    let name = path.file_name().unwrap_or(path.as_os_str());
                    let item = ui.button(name.to_string_lossy());
                    if item.on_hover_text(path.display().to_string()).clicked() {
                        chosen = Some(path.clone());
                        ui.close();
                    }
                }
            });
        });
        chosen
    }
}
