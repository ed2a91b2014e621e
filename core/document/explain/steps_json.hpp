// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of one ball as JSON (docs/output-files.md).
#pragma once

#include <nlohmann/json.hpp>

#include "core/document/explain/steps_text.hpp"

namespace alphascope {

nlohmann::ordered_json steps_json(const BallSteps& steps, const BallName& name);

}  // namespace alphascope
