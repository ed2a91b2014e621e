// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the user guide on a thread of its own, when it is opened for the first time.
#pragma once

#include <filesystem>
#include <functional>
#include <utility>

#include "core/run/worker.hpp"

namespace alphascope {

struct GuideState;

class GuideReader {
 public:
  // `docs` is the folder of docs. `wake` as in Worker.
  GuideReader(std::function<void()> wake, std::filesystem::path docs)
      : docs_(std::move(docs)), worker_(std::move(wake)) {}

  // Call on the main thread before each frame. Returns whether the guide has changed.
  bool poll(GuideState& state);
  bool busy() const { return worker_.activity().unfinished(); }

 private:
  void read(GuideState& state);

  const std::filesystem::path docs_;
  Worker worker_;  // last member, so that its thread is joined first
};

}  // namespace alphascope
