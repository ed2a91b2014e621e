// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of atoms outside the body that the picture shows.
#pragma once

#include <cstdint>

#include "core/molecule/element.hpp"

namespace alphascope {

enum class DropReason : std::uint8_t;

// The atoms outside the body that are drawn beside it. Nothing is computed from them.
struct AtomsBesideBody {
  bool ligands = true, ions = true, waters = false;
  bool hydrogens = false;  // of all kinds
  friend bool operator==(const AtomsBesideBody&, const AtomsBesideBody&) = default;
};

// Whether an atom is drawn that the options leave out of the body for this reason.
bool shows(const AtomsBesideBody& shown, DropReason reason, Element element);

}  // namespace alphascope
