// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of complexes of the same balls under the same settings: single ones of the command line,
// and the frames of sweeps. Also draws a picture into a file without a window or a display.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/document/session/session_file.hpp"
#include "core/document/settings/drawn_object.hpp"
#include "ui/scene/picture/drawn_parts.hpp"

namespace alphascope {

struct PictureSettings {
  DisplaySettings display;
  Theme theme = Theme::dark;
  float line_scale = 1;  // as in SceneStyle
  Appearance appearance;
  DrawnObjects objects;
  ClipWords clip;
  std::optional<CameraPlace> camera;  // none: the default view
  PictureOptions options;             // width and height from 16 to 16384
  Layers layers;                      // drawn beside balls and complex
  // Free memory in bytes, if known; empty: unknown.
  std::function<std::optional<std::uint64_t>()> free_memory;
};

class PictureMaker {
 public:
  // If `molecule` has no geometry yet, the first picture makes it.
  PictureMaker(PicturedMolecule molecule, PictureSettings settings,
               MeshMaker make_mesh = &build_mesh);
  const PictureSettings& settings() const { return settings_; }

  // `texts` are those on the source of the complex. Throws std::invalid_argument for a size out of
  // range, std::runtime_error if memory is too small for any picture, and as make_parts() does.
  Picture make(const std::shared_ptr<const EngineAnswer>& answer, PictureTexts texts,
               const RunContext& context);
  // Sentences on colours of the last picture that have no values.
  const std::vector<std::string>& missing_colours() const { return missing_colours_; }

 private:
  void make_molecule(const RunContext& context);

  std::shared_ptr<const PicturedMolecule> molecule_;
  PictureSettings settings_;
  MeshMaker make_mesh_;
  // Made with the first picture.
  bool begun_ = false;
  std::shared_ptr<const BallAppearance> looks_;
  std::shared_ptr<const LayerMesh> beside_body_;
  PicturedObjects objects_;
  Paintings paintings_;  // of the last picture
  std::vector<std::string> missing_colours_;
};

// Draws a picture into a file. It needs no display, since it makes an OpenGL context on this
// thread. Returns sentences on parts and marks that are missing for lack of memory or room, with a
// remedy; empty: none. The file holds those on memory too. Throws std::runtime_error if OpenGL is
// missing or the file cannot be written. Throws Cancelled between its steps, and then writes
// nothing.
std::string render_picture(const Picture& picture, const std::filesystem::path& path,
                           const RunContext& context = {});

}  // namespace alphascope
