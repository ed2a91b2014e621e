// SPDX-License-Identifier: GPL-3.0-or-later
// Notes the messages of the window, so that they can be read after they have gone.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "ui/panels/frame/task_state.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

class MessageNotes {
 public:
  explicit MessageNotes(ViewState& state) : state_(state) {}

  void follow();  // call once a frame; notes what is new

 private:
  using Titled = std::pair<std::string, std::string>;
  void note(Message::Kind kind, std::string text);
  void note_errors();

  ViewState& state_;
  std::size_t seen_notices_ = 0;     // Notice::times() in the last frame
  std::array<std::string, 6> seen_;  // other texts of the last frame
  std::vector<Titled> seen_errors_;  // in the dialog, and those that wait for it
};

}  // namespace alphascope
