// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `verify`, and the comparison itself. Tests pass engines with deliberate errors.
#pragma once

#include <string>
#include <vector>

#include "app/cli/input_options.hpp"
#include "app/options/exit_code.hpp"
#include "app/session/engine_cache.hpp"
#include "core/document/settings/request.hpp"

namespace alphascope::cli {

struct VerifyOptions {
  InputOptions input;
  Request request;
  std::vector<Alpha> alphas;  // Å²
  int cgal_threads = 1;
  bool definition = false;  // also checks the definition of the complex, without CGAL
  int shown = 10;           // number of printed differences for each kind of simplex
  std::string json;
};

ExitCode run_verify(const VerifyOptions& options, const EngineFactory& factory = &make_engine);

}  // namespace alphascope::cli
