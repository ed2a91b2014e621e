// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the window the LessonStage of the player. The previous molecule is kept as a session in
// memory, and is restored like any session.
#include "app/viewer/lessons/window_lessons.hpp"

#include <utility>

#include "app/options/did_you_mean.hpp"
#include "app/viewer/molecule_info.hpp"
#include "app/viewer/resources.hpp"
#include "core/document/picture/picture_preset.hpp"
#include "core/document/settings/display_fields.hpp"
#include "core/files/read_error.hpp"
#include "ui/panels/error_kind.hpp"
#include "ui/panels/whole_state.hpp"

namespace alphascope {
namespace {

// Commands that a lesson may not use, by the start of their names. A lesson may come from a
// stranger, so it writes no file and does not end the program. Scale and theme stay the reader's
// choice.
constexpr std::string_view kNotInLessons[] = {"file.",
                                              "edit.",
                                              "help.",
                                              "lesson.",
                                              "benchmark.",
                                              "view.scale",
                                              "view.presenter_size",
                                              "view.glide",
                                              "view.light_theme"};

// Throws ReadError for the first command that does not exist or is not allowed in lessons.
void check_commands(const Lesson& lesson, const Commands& known) {
  const auto check = [&](const std::vector<LessonCommand>& commands) {
    for (const LessonCommand& command : commands) {
      const std::string id = known.parse_line(command.text).id;
      for (const std::string_view area : kNotInLessons) {
        if (!id.starts_with(area)) continue;
        throw ReadError(lesson.file, command.line, "a lesson cannot run " + id,
                        "Use only commands that change the picture or its settings");
      }
      if (known.find(id) != nullptr) continue;
      std::vector<std::string> ids;
      for (const CommandSpec& spec : known.all()) ids.push_back(spec.id);
      throw ReadError(lesson.file, command.line, "there is no command \"" + id + "\"",
                      "alphascope --script-help lists them" + did_you_mean(id, ids));
    }
  };
  check(lesson.commands);
  for (const LessonStep& step : lesson.steps) {
    check(step.shown.commands);
    check(step.answer.commands);
  }
}

// Returns the settings at the start of a step, before its commands. Drawing quality, engine and
// threads stay as the user chose them. A step may change them, for that step only.
Settings lesson_settings(const Settings& now) {
  Settings s;
  s.open.read.max_bytes = now.open.read.max_bytes;
  s.request = now.request;
  s.request.alpha_angstrom2 = s.request.solvent_radius_angstrom = 0;
  s.request.tetrahedra_only = false;
  s.display = with_preset(DisplaySettings(), DisplayPreset::teaching);
  s.display.ball_paint = s.display.complex_paint = {ColourBy::element, {}, {}, {}};
  copy_group(DisplayGroup::light, now.display, s.display);
  return s;
}

}  // namespace

class WindowLessons::Stage : public LessonStage {
 public:
  explicit Stage(const Parts& parts) : p_(parts) {}

  std::shared_ptr<const void> file() const override {
    const auto& opened = p_.session.state().opened;
    return opened ? opened->deposited : nullptr;
  }
  std::filesystem::path path() const override {
    const auto& opened = p_.session.state().opened;
    return opened ? opened->deposited->source : std::filesystem::path();
  }
  bool opening() const override {
    const SessionActivity a = p_.session.activity();
    return a.opening.busy || !a.opening_path.empty() || p_.opening.opens_session();
  }
  bool at_rest() const override {
    const SessionActivity a = p_.session.activity();
    const bool shown = p_.session.state().ours == p_.state.result ||
                       !p_.state.compute_error.empty() || p_.state.playback.alpha;
    return p_.sender.all_is_sent() && shown && !a.opening.busy && !a.computing.busy &&
           !p_.scene.busy();
  }

  void keep() override {
    kept_ = Kept{p_.opening.document({}), p_.state.session_file, p_.history.settings(),
                 p_.history.editor(), file()};
    settled_.reset();
  }

  void open(const std::filesystem::path& molecule) override {
    SessionDocument document;
    document.settings = next_settings();
    document.view = p_.opening.window_of_session();
    document.view.panels.alpha_slider = {};
    start({}, std::move(document), molecule);
  }

  void reset() override {
    p_.history.restart(next_settings());
    p_.scene.cameras().reset();  // as for a molecule that the step opens
  }

  Outcome run(const std::string& command) override { return p_.commands.run_line(command); }

  void settle() override {
    settled_ = p_.history.settings();
    p_.history.restart();
    p_.preferences.ignore_changes_so_far();  // the changes are the lesson's, not the user's
    p_.due.ask();
  }

  void restore_kept() override {
    if (!kept_) return;
    Kept kept = *std::exchange(kept_, std::nullopt);
    if (!kept.document || kept.file == file()) {
      p_.session.cancel_opening();
      p_.opening.forget_waiting_session();
      if (!kept.document) p_.close_file();
      return take_over(kept);
    }
    kept.document->view.light_theme = p_.state.window.theme == Theme::light;
    const std::filesystem::path molecule = kept.document->molecule.absolute;
    start(kept.session_file, *std::move(kept.document), molecule);
    p_.history.set_to_restore(std::move(kept.history));
  }

  void forget() override {
    if (kept_) take_over(*std::exchange(kept_, std::nullopt));
  }

 private:
  struct Kept {
    std::optional<SessionDocument> document;  // none: no molecule was open
    std::filesystem::path session_file;
    Settings settings;
    Editor history;
    std::shared_ptr<const void> file;
  };

  // The start settings of the next step, with the user's present choices and without those of the
  // last step.
  Settings next_settings() {
    const Settings now = lesson_settings(p_.history.settings());
    if (!settled_ || !(now == lesson_settings(*settled_))) of_user_ = now;
    return of_user_;
  }

  // Restores all settings and their history if the kept molecule is still open. Otherwise restores
  // request and display only.
  void take_over(const Kept& kept) {
    ViewState& s = p_.state;
    if (kept.document && kept.file == file()) {
      p_.history.put(kept.history);
    } else {
      s.settings.request = kept.settings.request;
      s.settings.display = kept.settings.display;
      p_.history.restart();
    }
    p_.preferences.ignore_changes_so_far();
  }

  void start(const std::filesystem::path& file, SessionDocument document,
             const std::filesystem::path& molecule) {
    FoundSession found;
    found.file = file;
    found.is_recent = false;
    found.read.session = std::move(document);
    found.molecule.state = FoundFile::State::same;
    found.molecule.path = molecule;
    p_.opening.start(std::move(found));
  }

  Parts p_;
  std::optional<Kept> kept_;
  // The settings at the end of the last step. Differences from them are changes by the user.
  std::optional<Settings> settled_;
  Settings of_user_;
};

WindowLessons::WindowLessons(const Parts& parts, std::function<void()> wake,
                             std::vector<std::filesystem::path> folders)
    : p_(parts),
      files_(std::move(wake), std::move(folders)),
      stage_(std::make_unique<Stage>(parts)),
      player_(*stage_, parts.state.lessons) {}

WindowLessons::~WindowLessons() = default;

std::vector<std::filesystem::path> WindowLessons::folders(const std::filesystem::path& of_user) {
  std::vector<std::filesystem::path> folders{lessons_folder()};
  if (!of_user.empty()) folders.push_back(of_user / "lessons");
  return folders;
}

void WindowLessons::poll() {
  LessonState& memory = p_.state.lessons;
  LessonFiles::News news = files_.poll();
  if (news.shelf) memory.shelf = news.shelf;
  if (memory.shown && !memory.shelf && !files_.busy()) files_.read_list();
  if (news.opened) {
    try {
      check_commands(*news.opened, p_.commands);
      player_.begin(news.opened);
    } catch (const ReadError& error) {
      news.error = error.what();
    }
  }
  if (!news.error.empty()) {
    p_.state.show_error("The lesson cannot be opened", news.error, ErrorKind::input);
  }
  if (news.shelf || news.opened || !news.error.empty()) p_.due.ask();
}

}  // namespace alphascope
