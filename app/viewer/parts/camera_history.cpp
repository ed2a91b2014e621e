// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps two stacks of views.
#include "app/viewer/parts/camera_history.hpp"

namespace alphascope {

void CameraHistory::note(const CameraPlace& before) {
  if (earlier_.size() == kMost) earlier_.erase(earlier_.begin());
  earlier_.push_back(before);
  later_.clear();
}

void CameraHistory::clear() {
  earlier_.clear();
  later_.clear();
}

std::optional<CameraPlace> CameraHistory::step(Places& from, Places& to, const CameraPlace& now) {
  if (from.empty()) return std::nullopt;
  const CameraPlace found = from.back();
  from.pop_back();
  to.push_back(now);
  return found;
}

}  // namespace alphascope
