// SPDX-License-Identifier: GPL-3.0-or-later
// Choices for the table of cavities of the open file, as a part of its settings.
#pragma once

namespace alphascope {

struct CavitySettings {
  bool split_networks = false;  // lists networks as their parts (core/cavity/split_networks.hpp)
  friend bool operator==(const CavitySettings&, const CavitySettings&) = default;
};

}  // namespace alphascope
