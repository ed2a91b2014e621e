// SPDX-License-Identifier: GPL-3.0-or-later
// A session whose files have changed since it was saved. Plain data.
#pragma once

#include <string>

namespace alphascope {

struct SessionProblem {
  std::string session, text;  // its path; the message to the user
  bool molecule = false;      // the user may choose another molecule
  bool can_open = false;      // the session can be opened with the files as they are
  std::string id;             // the molecule can be fetched by this id; empty: it cannot
};

}  // namespace alphascope
