// SPDX-License-Identifier: GPL-3.0-or-later
// The options between a file and a BallSet: which atoms become balls, and their radii.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/files/read_options.hpp"
#include "core/molecule/sandbox.hpp"
#include "core/selection/ball_options.hpp"

namespace alphascope {

struct OpenOptions {
  ReadOptions read;
  std::string assembly;  // id of the assembly to expand; empty: as deposited
  BallOptions balls;
  // Read if `balls` asks for a user's table but holds none.
  std::filesystem::path radii_table;
  // Balls set by hand, instead of the file's atoms and all other options here.
  std::optional<Sandbox> sandbox;
  friend bool operator==(const OpenOptions& a, const OpenOptions& b) {
    return a.read == b.read && a.assembly == b.assembly && a.balls == b.balls &&
           a.radii_table == b.radii_table && a.sandbox == b.sandbox;
  }
};

// Resets the options that belong to one file: assembly, model, chains, expression, radii and balls
// set by hand.
OpenOptions for_another_file(const OpenOptions& options);

}  // namespace alphascope
