// SPDX-License-Identifier: GPL-3.0-or-later
// The window Tasks: whether it is open, and the last messages. The notice in the status bar. Plain
// data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>

namespace alphascope {

struct Message {
  enum class Kind : std::uint8_t { notice, warning, error };
  Kind kind = Kind::notice;
  std::string time;  // of the day: "14:03:12"
  std::string text;
};

// The notice in the status bar, and since when it is there.
struct ShownNotice {
  std::string text;
  std::size_t times = 0;  // Notice::times()
  double since_seconds = 0;
};

struct TaskState {
  static constexpr std::size_t kMostMessages = 100;

  bool shown = false;
  bool to_front = false;         // the window was asked for since the last frame
  std::deque<Message> messages;  // the latest first
  std::size_t noted = 0;         // all messages of this run
  ShownNotice shown_notice;
};

}  // namespace alphascope
