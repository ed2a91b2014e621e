// SPDX-License-Identifier: GPL-3.0-or-later
// The time of a move: from a change of the request, as by the slider, to its first picture.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "core/document/settings/request.hpp"

namespace alphascope {

struct Answer;

class MoveClock {
 public:
  using Clock = std::chrono::steady_clock;

  // Call in the frame in which the settings ask for `request`, and as often as you like after it.
  void note_wanted(const Request& request, Clock::time_point now = Clock::now());
  // Call once a frame. `finished`: when the first picture of `shown` was drawn; nothing before it.
  void follow(const std::shared_ptr<const Answer>& shown,
              std::optional<Clock::time_point> finished);
  // Call when another file is shown, whose alpha nobody has asked for by a move.
  void forget();
  // Of the last picture with a known time. Nothing if no move asked for the picture on screen, as
  // after opening a file.
  std::optional<double> milliseconds() const { return milliseconds_; }

 private:
  struct Move {
    Request request;
    Clock::time_point at;
  };
  std::vector<Move> moves_;  // not on screen yet, the latest last
  std::shared_ptr<const Answer> shown_;
  std::optional<Move> drawn_;  // asked for shown_, until its time is known
  std::optional<double> milliseconds_;
};

}  // namespace alphascope
