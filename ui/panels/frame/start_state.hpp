// SPDX-License-Identifier: GPL-3.0-or-later
// The start page, in the place of the picture while no molecule is open. Plain data.
#pragma once

#include <filesystem>
#include <optional>

#include "ui/panels/dialogs/fields/typed_id.hpp"

namespace alphascope {

struct StartState {
  IdField field;
  float height = 0;  // of its contents in the last frame, pixels; 0: not drawn yet
  // The dialog that saves a picture opens together with this molecule. An empty path stands for any
  // molecule. None: the dialog stays closed.
  std::optional<std::filesystem::path> picture_of;
};

}  // namespace alphascope
