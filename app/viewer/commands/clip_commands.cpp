// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that cut the picture open.
#include "app/viewer/commands/command_parts.hpp"
#include "core/document/settings/clip.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/real_point.hpp"
#include "ui/panels/complex/clip_panel.hpp"
#include "ui/panels/viewport_info.hpp"

namespace alphascope {
namespace {

using Kind = Parameter::Kind;

Outcome set_clip(const Arguments& arguments, ViewState& s) {
  if (!arguments.has("clip")) {
    set_clip_kind(s, s.settings.clip.on() ? Clip::Kind::off : Clip::Kind::plane);
    return {};
  }
  const ClipWords words = read_clip(arguments.text("clip"));
  if (!words.error.empty()) return Outcome::refused(words.error);
  const RealPoint& into = s.viewport.into_view;
  s.settings.clip = words.clip.on()
                        ? words.resolved({-into.x, -into.y, -into.z}, s.viewport.box_middle)
                        : Clip{Clip::Kind::off, s.settings.clip.normal, s.settings.clip.position,
                               s.settings.clip.thickness};
  return {};
}

}  // namespace

void add_clip_commands(Commands& commands, ViewState& s, const Calls& ask) {
  const auto without_clip = [&s] { return s.settings.clip.on() ? "" : "The picture is not cut."; };
  CommandSpec clip{
      .id = "view.clip",
      .title = "Clip plane",
      .help = "Cuts the picture open at a plane, or by a slab between two",
      .synonyms = {{"cut slice section"}},
      .shortcuts = {{"K"}},
      .menu = "View",
      .line_above = true,
      .parameters = {{.name = "clip",
                      .kind = Kind::text,
                      .help = "Position of the cut; if left out, the cut is switched on or off",
                      .example = "x=12.5",
                      .optional = true}},
      .why_not = without_molecule(s),
      .run = [&s](const Arguments& arguments) { return set_clip(arguments, s); }};
  commands.add(std::move(clip));
  commands.add({.id = "view.clip_slab",
                .title = "Clip to a slab",
                .help = "Cuts away everything outside two planes, or switches the slab off",
                .menu = "View",
                .why_not = without_molecule(s),
                .run = [&s](const Arguments&) {
                  const bool slab = s.settings.clip.kind == Clip::Kind::slab;
                  set_clip_kind(s, slab ? Clip::Kind::off : Clip::Kind::slab);
                  return Outcome();
                }});
  commands.add({.id = "view.clip_flip",
                .title = "Flip the clip plane",
                .help = "Keeps the other side of the plane",
                .shortcuts = {{"Shift+K"}},
                .why_not =
                    [&s] {
                      return s.settings.clip.kind == Clip::Kind::plane
                                 ? ""
                                 : "There is no clip plane to flip.";
                    },
                .run =
                    [&s](const Arguments&) {
                      s.settings.clip.flipped = !s.settings.clip.flipped;
                      return Outcome();
                    }});
  commands.add({.id = "view.clip_move",
                .title = "Move the clip by",
                .help = "Moves plane or slab along its normal",
                .shortcuts = {{"PageUp", "1"}, {"PageDown", "-1"}},
                .parameters = {{.name = "distance",
                                .kind = Kind::number,
                                .help = "Distance; negative: towards the other side",
                                .example = "2.5",
                                .rule = kClipPositionRule}},
                .why_not = without_clip,
                .run = [&s](const Arguments& arguments) {
                  s.settings.clip.position += arguments.number("distance");
                  return Outcome();
                }});
  commands.add({.id = "view.clip_face",
                .title = "Look at the cut",
                .help = "Turns the view to face the cut",
                .why_not = without_clip,
                .run = [&s, ask](const Arguments&) {
                  // The view comes from the side that is cut away.
                  const bool behind =
                      s.settings.clip.kind == Clip::Kind::plane && s.settings.clip.flipped;
                  std::array<double, 3> towards = s.settings.clip.normal;
                  for (double& x : towards) x = behind ? -x : x;
                  ask.view.look_from(towards);
                  return Outcome();
                }});
}

}  // namespace alphascope
