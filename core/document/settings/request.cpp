// SPDX-License-Identifier: GPL-3.0-or-later
// Sets options that the request's engine does not use to their defaults.
#include "core/document/settings/request.hpp"

namespace alphascope {

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
