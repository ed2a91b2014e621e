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

Parameter saved_clip(const ViewState& s) {
  return {.name = "name", .kind = Kind::choice, .help = "Which clip", .choices = [&s] {
            std::vector<Choice> choices;
            for (const NamedClip& saved : s.settings.clips) {
              choices.push_back(
                  {saved.name, saved.name, clip_text(saved.clip), saved.clip == s.settings.clip});
            }
            return choices;
          }};
}

Outcome rename_clip(const Arguments& arguments, ViewState& s) {
  const std::string name = arguments.text("name"), wanted = arguments.text("new_name");
  if (name != wanted && find_clip(s.settings.clips, wanted) != nullptr) {
    return Outcome::refused("There is another clip with the name " + wanted + ".");
  }
  for (NamedClip& saved : s.settings.clips) {
    if (saved.name == name) saved.name = wanted;
  }
  return {};
}

void add_saved_clip_commands(Commands& commands, ViewState& s) {
  const auto without_saved = [&s] { return s.settings.clips.empty() ? "No clip is saved." : ""; };
  commands.add({.id = "view.save_clip",
                .title = "Save clip…",
                .help = "Saves the present clip under a name",
                .menu = "View",
                .parameters = {{.name = "name",
                                .kind = Kind::text,
                                .help = "Its name; an older clip of that name is replaced",
                                .example = "active site"}},
                .why_not = [&s] { return s.settings.clip.on() ? "" : "The picture is not cut."; },
                .run =
                    [&s](const Arguments& arguments) {
                      save_clip(s.settings.clips, {arguments.text("name"), s.settings.clip});
                      s.notice = "Saved clip: " + arguments.text("name");
                      return Outcome();
                    }});
  commands.add({.id = "view.saved_clip",
                .title = "Cut by a saved clip…",
                .help = "Cuts the picture as a saved clip does",
                .menu = "View",
                .parameters = {saved_clip(s)},
                .why_not = without_saved,
                .run = [&s](const Arguments& arguments) {
                  const NamedClip* const found =
                      find_clip(s.settings.clips, arguments.text("name"));
                  if (found != nullptr) s.settings.clip = found->clip;
                  return Outcome();
                }});
  commands.add({.id = "view.rename_clip",
                .title = "Rename a saved clip…",
                .help = "Gives a saved clip another name",
                .parameters = {saved_clip(s),
                               {.name = "new_name",
                                .kind = Kind::text,
                                .help = "The new name",
                                .example = "entrance"}},
                .why_not = without_saved,
                .run = [&s](const Arguments& arguments) { return rename_clip(arguments, s); }});
  commands.add({.id = "view.forget_clip",
                .title = "Forget a saved clip…",
                .help = "Removes a saved clip; the picture stays cut",
                .parameters = {saved_clip(s)},
                .why_not = without_saved,
                .run = [&s](const Arguments& arguments) {
                  std::erase_if(s.settings.clips, [&](const NamedClip& saved) {
                    return saved.name == arguments.text("name");
                  });
                  return Outcome();
                }});
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
  add_saved_clip_commands(commands, s);
}

}  // namespace alphascope
