// SPDX-License-Identifier: GPL-3.0-or-later
// Resets the options that belong to one file, for the next file.
#include "core/document/settings/open_options.hpp"

namespace alphascope {

OpenOptions for_another_file(const OpenOptions& options) {
  OpenOptions result = options;
  const BallOptions defaults;
  result.read = ReadOptions{.max_bytes = options.read.max_bytes};
  result.assembly.clear();
  result.balls.model = defaults.model;
  result.balls.chains = defaults.chains;
  result.balls.without_chains = defaults.without_chains;
  result.balls.selection = defaults.selection;
  result.balls.overrides = defaults.overrides;
  result.balls.treated = defaults.treated;
  result.sandbox.reset();
  return result;
}

}  // namespace alphascope
