// Which atoms of a file become balls, and how large: all that lies between a file and a BallSet.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/molecule/sandbox.hpp"
#include "core/read/read_molecule.hpp"
#include "core/selection/ball_options.hpp"

namespace alphascope {

struct OpenOptions {
  ReadOptions read;
  std::string assembly;  // id of the biological assembly to expand; empty = as deposited
  BallOptions balls;
  // Read when the radii of a user's table are asked for and `balls` holds none.
  std::filesystem::path radii_table;
  // Balls set by hand, in place of the file's atoms and of what else is chosen here.
  std::optional<Sandbox> sandbox;
  friend bool operator==(const OpenOptions& a, const OpenOptions& b) {
    return a.read == b.read && a.assembly == b.assembly && a.balls == b.balls &&
           a.radii_table == b.radii_table && a.sandbox == b.sandbox;
  }
};

// Without what was chosen for one file: assembly, model, chains, expression, radii and balls set by
// hand.
OpenOptions for_another_file(const OpenOptions& options);

}  // namespace alphascope
