// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a ViewState, and errors that follow one another.
#include "ui/panels/view_state.hpp"

#include <tuple>

#include "core/document/store/answer.hpp"
#include "ui/panels/error_kind.hpp"
#include "ui/panels/whole_state.hpp"

namespace alphascope {

SettingsParts::SettingsParts(Settings& s)
    : all(s),
      open(s.open),
      request(s.request),
      display(s.display),
      objects(s.objects),
      selection(s.selection),
      clip(s.clip),
      clips(s.clips),
      views(s.views),
      appearance(s.appearance),
      annotations(s.annotations),
      cavity_settings(s.cavity_settings) {}

ViewState::ViewState(const ViewValues& values, ViewParts& parts)
    : ViewValues(values),
      settings(parts.settings),
      window(parts.window),
      playback(parts.playback),
      lessons(parts.lessons),
      guide(parts.guide),
      steps(parts.steps),
      cavities(parts.cavities),
      channels(parts.channels),
      sandbox(parts.sandbox),
      molecule(parts.molecule),
      ours(parts.ours),
      cgal(parts.cgal),
      cgal_parallel(parts.cgal_parallel),
      badge(parts.badge),
      benchmark_settings(parts.benchmark_settings),
      benchmark(parts.benchmark),
      jobs(parts.jobs),
      background(parts.background),
      viewport(parts.viewport),
      gpu(parts.gpu),
      program(parts.program),
      expression(parts.expression),
      expression_error(parts.expression_error),
      session_problem(parts.session_problem),
      palette(parts.palette),
      context(parts.context),
      dialogs(parts.dialogs),
      browser(parts.browser),
      fetch(parts.fetch),
      start(parts.start),
      tasks(parts.tasks),
      saving(parts.saving),
      record(parts.record),
      save_table(parts.save_table),
      number(parts.number),
      keys(parts.keys),
      mouse(parts.mouse),
      scroll(parts.scroll) {}

bool ViewState::has_molecule() const {
  return molecule.loaded;
}

const std::string& ViewState::file_name() const {
  return molecule.name;
}

const std::string& ViewState::file_hash() const {
  return molecule.sha256;
}

Theme ViewState::theme() const {
  return window.theme;
}

double ViewState::alpha_angstrom2() const {
  return settings.request.alpha_angstrom2;
}

double ViewState::solvent_radius_angstrom() const {
  return settings.request.solvent_radius_angstrom;
}

const Request* ViewState::shown_request() const {
  return result ? &result->request : nullptr;
}

const std::shared_ptr<const BallSet>& ViewState::shown_balls() const {
  static const std::shared_ptr<const BallSet> none;
  return result ? result->balls : none;
}

const PreparedBalls* ViewState::shown_selection() const {
  return result ? result->prepared.get() : nullptr;
}

bool ViewState::shows_tetrahedra_only() const {
  return result && result->complex.tetrahedra_only;
}

void ViewState::go_to_alpha(double angstrom2) {
  set_alpha(settings.request, angstrom2);
  playback.alpha = false;
}

void ViewState::show_page(const std::string& id) {
  window.page = id;
}

std::string ViewState::page() const {
  if (!window.page.empty()) return window.page;
  const bool polymer =
      molecule.loaded && of_kind(molecule.contents.kinds, ResidueKind::polymer) > 0;
  return polymer ? "cavities" : "";
}

void ViewState::show_error(const std::string& title, const std::string& text, ErrorKind kind) {
  const LaterError news{title, text, kind};
  if (error.empty()) {
    std::tie(error_title, error, error_kind) = std::tie(title, text, kind);
  } else if (error != text && (more_errors.empty() || more_errors.back() != news)) {
    more_errors.push_back(news);
  }
}

void ViewState::show_compute_error(const std::string& text) {
  compute_error = text;
  if (first_compute_error.empty()) first_compute_error = text;
}

void ViewState::close_errors(std::string_view title) {
  if (error_title == title) {
    note_withdrawn(error, error_kind);
    close_error();
  }
  std::erase_if(more_errors, [&](const auto& later) {
    const bool closes = later.title == title;
    if (closes) note_withdrawn(later.text, later.kind);
    return closes;
  });
}

void ViewState::note_withdrawn(const std::string& text, ErrorKind kind) {
  if (!withdrawn_error.empty()) return;
  withdrawn_error = text;
  withdrawn_kind = kind;
}

void ViewState::refuse_late(const std::string& text) {
  notice = text;
  note_withdrawn(text, ErrorKind::input);
}

void ViewState::close_error() {
  error_title.clear();
  error.clear();
  if (more_errors.empty()) return;
  LaterError& next = more_errors.front();
  error_title = std::move(next.title);
  error = std::move(next.text);
  error_kind = next.kind;
  more_errors.pop_front();
}

bool has_gpu(const ViewState& state) {
  return state.gpu && state.gpu->usable;
}

}  // namespace alphascope
