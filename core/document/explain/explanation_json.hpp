// SPDX-License-Identifier: GPL-3.0-or-later
// An explanation as JSON (docs/output-files.md).
#pragma once

#include <nlohmann/json.hpp>

#include "core/document/explain/explanation_text.hpp"

namespace alphascope {

nlohmann::ordered_json explanation_json(const Explanation& e, const BallName& name);

}  // namespace alphascope
