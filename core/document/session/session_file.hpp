// SPDX-License-Identifier: GPL-3.0-or-later
// A session is a JSON file (docs/output-files.md). It has all settings, the state of the window,
// and path and hash of the open molecule. It contains neither the molecule nor any result.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/document/alpha/alpha_slider.hpp"
#include "core/document/picture/picture_options.hpp"
#include "core/document/session/file_reference.hpp"
#include "core/document/session/session_name.hpp"
#include "core/document/settings/settings.hpp"

namespace alphascope {

// Position of the camera, relative to an origin in the coordinates of the molecule's file. With the
// same balls the camera is the same in every bit, and with other balls it looks at the same place.
struct CameraPlace {
  std::array<double, 3> origin{};              // Å
  std::array<double, 3> position{}, target{};  // Å, relative to `origin`
  std::array<double, 3> up{0, 1, 0};
  double least_aspect = 0;                         // Viewpoint::least_aspect
  bool any() const { return position != target; }  // false: there is no camera
  friend bool operator==(const CameraPlace&, const CameraPlace&) = default;
};

struct PanelLayout {
  std::string page;                          // page below the view; empty: the first
  double page_height = 0;                    // pixels at scale 1; 0: the default
  std::vector<std::string> closed_sections;  // at the left side
  AlphaSlider alpha_slider;
  friend bool operator==(const PanelLayout&, const PanelLayout&) = default;
};

// State of the window that undo does not change.
struct SessionView {
  bool light_theme = false;  // also gives the background of pictures
  CameraPlace camera;
  PanelLayout panels;
  PictureOptions picture;  // for the dialogs that save pictures and recordings
  RecordSettings recording;
  friend bool operator==(const SessionView&, const SessionView&) = default;
};

struct SessionDocument {
  FileReference molecule;
  FileReference radii_table;  // empty: settings.open.radii_table is empty
  Settings settings;
  SessionView view;
  std::string written_by;  // "alphascope 0.2.0 (0123456789ab)"
};

// The text of the file; it ends with a newline.
std::string session_text(const SessionDocument& session);
// The file appears whole or not at all. Throws WriteError.
void write_session(const SessionDocument& session, const std::filesystem::path& path);

struct ReadSession {
  SessionDocument session;
  // Sentences on members of the file that this program does not know.
  std::vector<std::string> notes;
};
// Values that the file omits are those of a new window. Throws ReadError with the line if the file
// is no session, has an invalid value or a newer version. Throws Cancelled.
ReadSession read_session(const std::filesystem::path& path, const RunContext& context = {});
// The same for text in memory; `path` is used in messages.
ReadSession parse_session(const std::filesystem::path& path, std::string_view text);

}  // namespace alphascope
