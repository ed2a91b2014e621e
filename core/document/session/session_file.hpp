// A session: the open molecule by name and content, all settings, and how the window showed them,
// as one JSON file (docs/output-files.md). No molecule and no result is in it.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/document/alpha/alpha_slider.hpp"
#include "core/document/picture/picture_options.hpp"
#include "core/document/session/file_reference.hpp"
#include "core/document/settings/settings.hpp"

namespace alphascope {

// Where the eye is. Kept from an origin, in the coordinates of the molecule's file, so that not one
// bit changes between the same balls, and the place is right for others.
struct CameraPlace {
  std::array<double, 3> origin{};              // Å
  std::array<double, 3> position{}, target{};  // Å, from the origin
  std::array<double, 3> up{0, 1, 0};
  double least_aspect = 0;                         // Viewpoint::least_aspect
  bool any() const { return position != target; }  // else there is none
  friend bool operator==(const CameraPlace&, const CameraPlace&) = default;
};

struct PanelsShown {
  std::string page;                          // below the view; empty: the first
  double page_height = 0;                    // pixels at scale 1; 0: as usual
  std::vector<std::string> closed_sections;  // of the left side
  AlphaSlider alpha_slider;
  friend bool operator==(const PanelsShown&, const PanelsShown&) = default;
};

// What undo leaves alone.
struct SessionView {
  bool light_theme = false;  // a picture's background is
  CameraPlace camera;
  PanelsShown panels;
  PictureOptions picture;  // of the dialogs that save pictures and recordings
  RecordChoices recording;
  friend bool operator==(const SessionView&, const SessionView&) = default;
};

struct SessionDocument {
  FileReference molecule;
  FileReference radii_table;  // empty: settings.open.radii_table is
  Settings settings;
  SessionView view;
  std::string written_by;  // "alphascope 0.1.0 (0123456789ab)"
};

// As it is written; ends with a line end.
std::string session_text(const SessionDocument& session);
// The file appears whole or not at all. Throws WriteError.
void write_session(const SessionDocument& session, const std::filesystem::path& path);

struct ReadSession {
  SessionDocument session;
  // Sentences: what the file says and this program does not know.
  std::vector<std::string> notes;
};
// What the file leaves out is as in a new window. Throws ReadError, with the line, for what is no
// session, for a value that cannot be, and for a file of a newer version; Cancelled.
ReadSession read_session(const std::filesystem::path& path, const RunContext& context = {});
// The same of text in memory; the path is for messages.
ReadSession parse_session(const std::filesystem::path& path, std::string_view text);

// By its name: what else ends in .json is no molecule either, and then gets a message as a session.
bool looks_like_session(const std::filesystem::path& path);

}  // namespace alphascope
