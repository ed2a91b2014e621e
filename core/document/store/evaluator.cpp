// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a result after those that its definition is made of, each once a key.
#include "core/document/store/evaluator.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/run/cancel_token.hpp"
#include "core/run/internal_error.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {

std::shared_ptr<const void> Evaluator::made(const AnyDefinition& definition, const Inputs& inputs,
                                            const RunContext& context) {
  const Key key = key_of(definition, inputs);
  if (!key) {
    throw InternalError("The inputs of \"" + std::string(definition.title) + "\" are missing.");
  }
  const auto known = std::find_if(made_.begin(), made_.end(), [&](const Made& m) {
    return m.id == definition.id && m.key == key;
  });
  if (known != made_.end()) return known->result;
  Inputs all = inputs;
  all.made.clear();
  for (const AnyDefinition* source : definition.made_of) {
    all.made.emplace_back(source->id, made(*source, inputs, context));
  }
  require_room(definition, all);
  context.cancel.throw_if_cancelled();
  std::shared_ptr<const void> result = definition.make(all, context);
  if (!result) throw InternalError("\"" + std::string(definition.title) + "\" was not made.");
  made_.push_back({definition.id, key, result});
  return result;
}

void Evaluator::require_room(const AnyDefinition& definition, const Inputs& inputs) const {
  const MemoryNeed need = definition.memory(inputs);
  const std::uint64_t bytes = std::max(need.peak, need.held), room = room_();
  if (bytes > room) throw NoRoom(std::string(definition.title) + ": " + no_room_text(bytes, room));
}

}  // namespace alphascope
