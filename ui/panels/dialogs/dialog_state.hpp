// SPDX-License-Identifier: GPL-3.0-or-later
// The dialogs that are open, and the texts typed into those without a state of their own. Plain
// data.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/document/export/export_request.hpp"

namespace alphascope {

struct DialogState {
  bool show_cheat_sheet = false, show_about = false, show_save = false;
  bool show_benchmark = false, show_export = false, show_save_session = false;
  // Open dialogs, as indices into the list of dialog_stack.cpp. The last is on top.
  std::vector<std::size_t> open;
  std::string save_path;  // path to save a picture to
  std::string export_path;
  ExportColours export_colours = ExportColours::element;
  std::string session_path;      // path to save the session to
  std::string confirm_assembly;  // id of the assembly that the dialog asks about; empty: none
};

}  // namespace alphascope
