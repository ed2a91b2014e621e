// SPDX-License-Identifier: GPL-3.0-or-later
// Makes derived results at once, for the command line, which waits for them. The store makes the
// same results in the background.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <vector>

#include "core/document/store/definition.hpp"
#include "core/document/store/key.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// A result needs more memory than is free. what() is a sentence.
struct NoRoom : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Keeps its results, so each is made once a key. Only one thread may use an evaluator.
class Evaluator {
 public:
  // The bytes that the next result may take. Called before each is made.
  using Room = std::function<std::uint64_t()>;
  explicit Evaluator(Room room) : room_(std::move(room)) {}

  // Makes the results of `made_of`, then the result itself, in the caller's task arena. Throws
  // NoRoom, Cancelled and the exceptions of `make`. Throws InternalError where the inputs do not
  // suffice.
  template <class T>
  std::shared_ptr<const T> evaluate(const Definition<T>& definition, const Inputs& inputs,
                                    const RunContext& context = {}) {
    return std::static_pointer_cast<const T>(made(definition, inputs, context));
  }

 private:
  struct Made {
    std::string_view id;
    Key key;
    std::shared_ptr<const void> result;
  };
  std::shared_ptr<const void> made(const AnyDefinition& definition, const Inputs& inputs,
                                   const RunContext& context);
  void require_room(const AnyDefinition& definition, const Inputs& inputs) const;

  Room room_;
  std::vector<Made> made_;
};

}  // namespace alphascope
