// Options of alpha and of engines. See the header.
#include <stdexcept>

#include "app/cli/option_groups.hpp"

namespace alphascope::cli {
namespace {

// The switches of the tuple engines; refused with another engine, where they would do nothing.
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
          with_default(whole_number_option(
                           {"--streams", "N", "GPU: number of streams that work at the same time"},
                           tuples.streams, {1, 8}),
                       std::to_string(tuples.streams)),
          with_default(whole_number_option({"--tuples-per-batch", "N", "Tuples held at once"},
                                           tuples.tuples_per_batch, {0, 100'000'000}),
                       "0 = chosen")});
  for (Option& option : options) {
    option.group = "Options of --engine tuples-cpu and tuples-gpu (same result)";
  }
  return options;
}

}  // namespace

Option alpha(Request& request) {
  return required(number_option({"--alpha", "A", "Alpha in Å²; it may be negative"},
                                request.alpha_angstrom2, kAlphaRange));
}

Option alphas(std::vector<double>& alphas, const char* text) {
  return numbers_option({"--alpha", "A", text}, alphas, kAlphaRange);
}

void require_tuple_engine(const Request& request) {
  if (is_tuple_engine(request.engine) || request.tuples == TupleOptions{}) return;
  throw std::invalid_argument(
      "the options of the tuple engines need --engine tuples-cpu or tuples-gpu");
}

Options engine(Request& request, bool threads) {
  Option engine{.names = "--engine",
                .value = "auto|cpu|cgal|gpu|tuples-cpu|tuples-gpu",
                .text = "Engine, with the same result; auto takes the GPU when there is one",
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
