// SPDX-License-Identifier: GPL-3.0-or-later
// The secondary structure of a molecule, found when it is first needed and then shared.
#pragma once

#include <memory>
#include <mutex>

#include "core/molecule/molecule.hpp"
#include "core/run/cancel_token.hpp"
#include "core/secondary/secondary.hpp"

namespace alphascope {

// Belongs to one molecule. Several threads may ask at once: one finds, and the others wait.
class SecondaryOnce {
 public:
  // As find_secondary_of_models(). Only a change of the models finds it again. Throws Cancelled.
  std::shared_ptr<const SecondaryModel> of(const Molecule& molecule, const ModelRange& models,
                                           const RunContext& context = {});
  bool known() const;

 private:
  mutable std::timed_mutex finding_;
  ModelRange models_;  // of found_
  std::shared_ptr<const SecondaryModel> found_;
};

}  // namespace alphascope
