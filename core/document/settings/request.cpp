// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds of alpha, and defaults of options that the request's engine does not use.
#include "core/document/settings/request.hpp"

#include <algorithm>

#include "core/document/commands/number_input.hpp"

namespace alphascope {

void set_alpha(Request& request, const Alpha& angstrom2) {
  request.alpha_angstrom2 = std::clamp(angstrom2, Alpha(kAlphaRule.least), Alpha(kAlphaRule.most));
}

Request canonical(Request request) {
  const TupleOptions asked = request.tuples;
  request.tuples = {};
  if (!is_tuple_engine(request.engine)) return request;
  request.tuples = asked;
  if (request.engine == EngineChoice::tuples_gpu) return request;
  const TupleOptions defaults;
  request.tuples.pinned = defaults.pinned;
  request.tuples.texture = defaults.texture;
  request.tuples.streams = defaults.streams;
  return request;
}

}  // namespace alphascope
