// SPDX-License-Identifier: GPL-3.0-or-later
// The options of alpha and of engines.
#include <stdexcept>
#include <string>
#include <utility>

#include "app/cli/option_groups.hpp"
#include "core/geometry/lattice_alpha.hpp"

namespace alphascope::cli {
namespace {

// The switches of the tuple engines. They are refused with another engine, where they would have no
// effect.
Options tuples(Request& request) {
  TupleOptions& tuples = request.tuples;
  const auto off = [](const char* name, const char* text, bool& value) {
    return flag_option(name, text, value, false);
  };
  Options options = tuple_work(tuples);
  append(options,
         {off("--pageable", "GPU: pageable host memory instead of pinned", tuples.pinned),
          off("--no-texture", "GPU: read balls from plain memory, not through textures",
              tuples.texture),
          with_default(whole_number_option({"--streams", "N", "GPU: number of CUDA streams"},
                                           tuples.streams, {1, 8}),
                       std::to_string(tuples.streams)),
          with_default(whole_number_option({"--tuples-per-batch", "N",
                                            "Largest number of tuples in memory at a time"},
                                           tuples.tuples_per_batch, {0, 100'000'000}),
                       "0 = chosen")});
  for (Option& option : options) {
    option.group =
        "Options of --engine " + engine_ids(EngineGroup::tuples, " and ") + " (same result)";
  }
  return options;
}

}  // namespace

Option alpha(Request& request) {
  return required(alpha_option("Alpha in Å²; it may be negative", request.alpha_angstrom2));
}

Alpha alpha_in(const std::string& value) {
  number_in(value, kAlphaRange);  // refuses text that is not a number
  Alpha alpha;
  const Alpha::Reading reading = Alpha::read(value, alpha);
  if (reading == Alpha::Reading::too_fine) {
    throw std::invalid_argument("\"" + value + "\" has more than " +
                                std::to_string(Alpha::kMostDigits) +
                                " digits behind the point; alpha is used exactly as it is written, "
                                "with at most that many");
  }
  if (reading != Alpha::Reading::ok) {
    throw std::invalid_argument("\"" + value + "\" is not a number from -1e+24 to 1e+24 Å²");
  }
  return alpha;
}

Option alpha_option(const char* text, Alpha& target) {
  Option option{.names = "--alpha", .value = "A", .text = text};
  option.set = [&target](const std::string& value) { target = alpha_in(value); };
  return option;
}

Option alphas(std::vector<Alpha>& alphas, const char* text) {
  Option option{.names = "--alpha", .value = "A", .text = text, .list = true};
  // The first given value replaces the default.
  option.set = [&alphas, fresh = true](const std::string& value) mutable {
    const Alpha alpha = alpha_in(value);
    if (std::exchange(fresh, false)) alphas.clear();
    alphas.push_back(alpha);
  };
  return option;
}

void require_tuple_engine(const Request& request) {
  if (is_tuple_engine(request.engine) || request.tuples == TupleOptions{}) return;
  throw std::invalid_argument("the options of the tuple engines need --engine " +
                              engine_ids(EngineGroup::tuples, " or "));
}

Options engine(Request& request, bool threads) {
  Option engine{.names = "--engine",
                .value = engine_ids(EngineGroup::all, "|"),
                .text = "Engine; all give the same result; auto uses the GPU when there is one",
                .fallback = "auto"};
  engine.set = [&request, choices = engine.choices()](const std::string& id) {
    require_choice(id, choices);
    request.engine = *engine_from_id(id);
  };
  Options options{number_option({"--solvent", "S", "Solvent radius in Å, added to every radius"},
                                request.solvent_radius_angstrom, kSolventRange),
                  engine};
  if (threads) {
    options.push_back(with_default(
        whole_number_option({"--threads", "N", "CPU threads"}, request.threads, kThreadRange),
        "0 = all"));
  }
  options.push_back(
      flag_option("--tetrahedra-only",
                  "Compute only tetrahedra, without vertices, edges, triangles and classes",
                  request.tetrahedra_only));
  append(options, tuples(request));
  return options;
}

}  // namespace alphascope::cli
