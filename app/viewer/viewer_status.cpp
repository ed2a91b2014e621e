// SPDX-License-Identifier: GPL-3.0-or-later
// Shows failures. If a single request of the user fails, a dialog opens. A slider may ask in each
// frame for computing or changing the model. If that fails, a line in the window says so.
#include <cmath>
#include <new>
#include <string>
#include <utility>

#include "app/viewer/session_text.hpp"
#include "app/viewer/viewer.hpp"
#include "core/document/store/derived.hpp"
#include "core/text/printable.hpp"
#include "ui/panels/failure_kind.hpp"

namespace alphascope {
namespace {

// A paragraph that says what remains after a failure; empty if no molecule is open.
std::string still(const ViewState& state, const char* what) {
  return state.molecule.loaded ? std::string("\n\n") + what : "";
}

}  // namespace

void Viewer::guarded(const std::function<void()>& what) {
  try {
    what();
    return;
  } catch (const std::bad_alloc&) {
    state_.show_error("There is not enough memory",
                      "The last action failed. Use a smaller alpha, compute tetrahedra only, keep "
                      "fewer atoms, or close other programs.",
                      ErrorKind::computing);
  } catch (const std::exception& error) {
    state_.show_error("The last action failed", error.what(), kind_of(error, ErrorKind::computing));
  }
  pace_.due().ask();
}

void Viewer::take_error(bool only_the_model_changed) {
  using Source = SessionState::Source;
  const SessionState& s = session_.state();
  state_.show_compute_error(s.error_source == Source::computing ? s.last_error : "");
  if (s.last_error.empty()) return;
  state_.playback.alpha = state_.playback.models = false;
  switch (s.error_source) {
    case Source::opening:
      file_.opening().forget_failed();
      state_.show_error(kNotOpened,
                        s.last_error + file_.opening().not_opened_either() +
                            still(state_, "The previous molecule is still open."),
                        ErrorKind::input);
      break;
    case Source::changing:
      if (only_the_model_changed) {
        state_.refuse_late(s.last_error);
      } else {
        state_.show_error(kNotChanged,
                          s.last_error + still(state_, "The previous selection is still in use."),
                          ErrorKind::input);
      }
      break;
    case Source::none:
    case Source::computing:
    case Source::comparing:  // the badge shows the failure
      break;
  }
}

}  // namespace alphascope
