// SPDX-License-Identifier: GPL-3.0-or-later
// Lets one thread find the secondary structure, while others wait and may be cancelled.
#include "core/secondary/secondary_once.hpp"

#include <chrono>
#include <utility>

namespace alphascope {

std::shared_ptr<const SecondaryModel> SecondaryOnce::of(const Molecule& molecule,
                                                        const ModelRange& models,
                                                        const RunContext& context) {
  constexpr std::chrono::milliseconds kBetweenChecks{20};
  std::unique_lock lock(finding_, std::defer_lock);
  while (!lock.try_lock_for(kBetweenChecks)) context.cancel.throw_if_cancelled();
  if (!found_ || models_.begin != models.begin || models_.end != models.end) {
    context.cancel.throw_if_cancelled();
    found_ =
        std::make_shared<const SecondaryModel>(find_secondary_of_models(molecule, models, context));
    models_ = models;
  }
  return found_;
}

bool SecondaryOnce::known() const {
  const std::scoped_lock lock(finding_);
  return found_ != nullptr;
}

}  // namespace alphascope
