// SPDX-License-Identifier: GPL-3.0-or-later
// The state of fetching by id. Plain data.
#pragma once

#include <string>

#include "core/document/fetch/fetch.hpp"
#include "ui/panels/dialogs/fields/typed_id.hpp"

namespace alphascope {

struct FetchState {
  bool show = false;  // the dialog
  IdField field;
  bool again = false;
  FetchOptions options;  // of the program
  std::string problem;   // a sentence: why nothing can be fetched; empty: it can
};

}  // namespace alphascope
