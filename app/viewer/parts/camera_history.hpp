// SPDX-License-Identifier: GPL-3.0-or-later
// Earlier and later views of the picture, for going back and forward. Settings do not change.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/document/session/session_file.hpp"

namespace alphascope {

class CameraHistory {
 public:
  static constexpr std::size_t kMost = 100;

  // Call when the view has moved from `before`. Later views are forgotten.
  void note(const CameraPlace& before);
  // The view before `now`, or after it; nothing if there is none.
  std::optional<CameraPlace> back(const CameraPlace& now) { return step(earlier_, later_, now); }
  std::optional<CameraPlace> forward(const CameraPlace& now) { return step(later_, earlier_, now); }
  bool has_earlier() const { return !earlier_.empty(); }
  bool has_later() const { return !later_.empty(); }
  void clear();

 private:
  using Places = std::vector<CameraPlace>;  // the nearest last
  static std::optional<CameraPlace> step(Places& from, Places& to, const CameraPlace& now);

  Places earlier_, later_;
};

}  // namespace alphascope
