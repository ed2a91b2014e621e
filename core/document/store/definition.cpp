// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that store and evaluator use of every definition: its key, and the text when memory is
// short.
#include "core/document/store/definition.hpp"

#include <cstdio>

#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/name_table.hpp"

namespace alphascope {
namespace {

std::string gigabytes(std::uint64_t bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f GB", static_cast<double>(bytes) / 1e9);
  return text;
}

}  // namespace

Key key_of(const AnyDefinition& definition, const Inputs& inputs) {
  Key key = definition.key(inputs);
  for (const AnyDefinition* source : definition.made_of) {
    key = joined(key, key_of(*source, inputs));
  }
  return key;
}

std::string no_room_text(std::uint64_t needed, std::uint64_t available) {
  return "This result needs about " + gigabytes(needed) + " of memory, and " +
         gigabytes(available) + " is available.";
}

}  // namespace alphascope
