// What went wrong, and where the window says so: what the user asked for once gets a dialog; what
// follows a slider or goes on in the background gets a line where one looks.
#include <new>

#include "app/viewer/viewer.hpp"

namespace alphascope {
namespace {

constexpr int kFramesForNews = 3;  // until a dialog stands

}  // namespace

void Viewer::guarded(const std::function<void()>& what) {
  try {
    what();
    return;
  } catch (const std::bad_alloc&) {
    state_.tell(
        "There is not enough memory",
        "The last step could not be done. Use a smaller alpha, compute tetrahedra only, keep "
        "fewer atoms, or close other programs.");
  } catch (const std::exception& error) {
    state_.tell("The last step could not be done", error.what());
  }
  frames_due_ = kFramesForNews;
}

void Viewer::take_error(bool only_the_model_changed) {
  using Source = SessionState::Source;
  const SessionState& s = session_.state();
  state_.compute_error = s.error_source == Source::computing ? s.last_error : "";
  if (s.last_error.empty()) return;
  state_.memory.playing = state_.memory.playing_models = false;
  switch (s.error_source) {
    case Source::opening:
      state_.tell("The file cannot be opened", s.last_error);
      break;
    case Source::changing:
      if (only_the_model_changed) {
        state_.notice = s.last_error;
      } else {
        state_.tell("The selection cannot be changed", s.last_error);
      }
      break;
    case Source::none:
    case Source::computing:
    case Source::comparing:  // the badge says so
      break;
  }
}

}  // namespace alphascope
