// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the texts that the window shows with those of the last frame.
#include "app/viewer/parts/message_notes.hpp"

#include <algorithm>
#include <cstddef>
#include <ctime>

#include "ui/panels/viewport_info.hpp"
#include "ui/panels/work_info.hpp"

namespace alphascope {
namespace {

std::string time_of_day() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  char text[16];
  if (::localtime_r(&now, &local) == nullptr ||
      std::strftime(text, sizeof text, "%H:%M:%S", &local) == 0) {
    return {};
  }
  return text;
}

// The badge's text if CGAL failed or has another complex.
std::string disagreement(const BadgeInfo& badge) {
  const bool bad =
      badge.state == BadgeInfo::State::different || badge.state == BadgeInfo::State::failed;
  return bad ? badge.text : std::string();
}

}  // namespace

void MessageNotes::note(Message::Kind kind, std::string text) {
  TaskState& tasks = state_.tasks;
  tasks.messages.push_front({kind, time_of_day(), std::move(text)});
  if (tasks.messages.size() > TaskState::kMostMessages) tasks.messages.pop_back();
  ++tasks.noted;
}

void MessageNotes::note_errors() {
  std::vector<Titled> present;
  if (!state_.error.empty()) present.emplace_back(state_.error_title, state_.error);
  for (const ViewState::LaterError& later : state_.more_errors) {
    present.emplace_back(later.title, later.text);
  }
  for (const Titled& error : present) {
    if (std::find(seen_errors_.begin(), seen_errors_.end(), error) != seen_errors_.end()) continue;
    note(Message::Kind::error, error.first + (error.first.empty() ? "" : ": ") + error.second);
  }
  seen_errors_ = std::move(present);
}

void MessageNotes::follow() {
  using Kind = Message::Kind;
  const Notice& notice = state_.notice;
  if (notice.times() != seen_notices_ && !notice.empty()) note(Kind::notice, notice.text());
  seen_notices_ = notice.times();
  const std::array<std::pair<Kind, std::string>, 6> shown{{
      {Kind::notice, state_.drop_note},
      {Kind::notice, state_.engine_note},
      {Kind::notice, state_.computing_cancelled},
      {Kind::warning, state_.viewport.not_drawn},
      {Kind::error, state_.compute_error},
      {Kind::error, disagreement(state_.badge)},
  }};
  for (std::size_t n = 0; n < shown.size(); ++n) {
    const auto& [kind, text] = shown[n];
    if (text != seen_[n] && !text.empty()) note(kind, text);
    seen_[n] = text;
  }
  note_errors();
}

}  // namespace alphascope
