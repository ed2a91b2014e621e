// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of one ball as JSON (docs/output-files.md).
#pragma once

#include <nlohmann/json.hpp>

#include "core/document/explain/steps_text.hpp"
#include "core/explain/ball_saturation.hpp"

namespace alphascope {

nlohmann::ordered_json steps_json(const BallSteps& steps, const BallName& name);
nlohmann::ordered_json saturation_json(const BallSaturation& saturation);

}  // namespace alphascope
