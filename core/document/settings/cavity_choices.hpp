// How the cavities of the open file are listed: a part of its settings.
#pragma once

namespace alphascope {

struct CavityChoices {
  bool split_networks = false;  // networks as their parts (core/cavity/split_networks.hpp)
  friend bool operator==(const CavityChoices&, const CavityChoices&) = default;
};

}  // namespace alphascope
