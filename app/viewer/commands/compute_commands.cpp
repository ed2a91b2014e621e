// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that change the complex, and those that measure and compare it.
#include <cmath>

#include "app/viewer/commands/command_parts.hpp"
#include "core/document/session/setting_ids.hpp"
#include "core/document/settings/request.hpp"
#include "core/engine/gpu_device.hpp"
#include "core/molecule/molecule.hpp"
#include "ui/panels/dialogs/dialog_state.hpp"
#include "ui/panels/explain/steps_state.hpp"
#include "ui/panels/playback.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/window_settings.hpp"

namespace alphascope {
namespace {

using Kind = Parameter::Kind;

// --- Alpha and solvent

// Rounds to 0.001 Å², so that repeated steps do not lead to 0.30000000000000004.
double rounded(double angstrom2) {
  return std::round(angstrom2 * 1000) / 1000;
}

// Starts or stops playback. If alpha is at the end, playback starts at the other end. The command
// of the other direction reverses a running playback.
void toggle_playing(ViewState& s, bool backwards) {
  Playback& p = s.playback;
  const bool stops = p.alpha && p.backwards == backwards;
  p.alpha = !stops;
  p.backwards = backwards;
  AlphaSlider around = s.window.alpha_slider;
  around.loop = true;
  const bool at_end =
      next_alpha(s.window.alpha_slider, s.settings.request.alpha_angstrom2, backwards).ended;
  if (!stops && at_end) {
    set_alpha(s.settings.request,
              next_alpha(around, s.settings.request.alpha_angstrom2, backwards).alpha);
  }
}

CommandSpec play_command(ViewState& s, bool backwards) {
  return {
      .id = backwards ? "alpha.play_back" : "alpha.play",
      .title = backwards ? "Play alpha back" : "Play alpha",
      .help = backwards ? "Lowers alpha step by step to the slider's low end, or stops"
                        : "Raises alpha step by step to the slider's high end, or stops",
      .menu = "Tools",
      .why_not = without_result(s),
      .checked = [&s, backwards] { return s.playback.alpha && s.playback.backwards == backwards; },
      .run =
          [&s, backwards](const Arguments&) {
            toggle_playing(s, backwards);
            return Outcome();
          }};
}

std::vector<Choice> scalings(const ViewState& s) {
  const AlphaScaling now = s.window.alpha_slider.scaling;
  return {{"linear", "Linear", "", now == AlphaScaling::linear},
          {"root", "Signed square root", "", now == AlphaScaling::root},
          {"logarithm", "Logarithmic", "", now == AlphaScaling::logarithm}};
}

Outcome set_scaling(const Arguments& arguments, ViewState& s) {
  for (const auto& [scaling, id] : setting_ids(AlphaScaling::linear)) {
    if (id == arguments.text("scale")) s.window.alpha_slider.scaling = scaling;
  }
  return {};
}

Outcome set_range(const Arguments& arguments, ViewState& s) {
  const double low = arguments.number("low"), high = arguments.number("high");
  if (!(low < high)) return Outcome::refused("The low end must be below the high end.");
  s.window.alpha_slider.low = low;
  s.window.alpha_slider.high = high;
  return {};
}

// Commands for the range of the slider and its playback. Alpha stays as it is.
void add_slider_commands(Commands& commands, ViewState& s) {
  commands.add(play_command(s, false));
  commands.add(play_command(s, true));
  commands.add(with_switch({.id = "alpha.loop",
                            .title = "Play alpha in a loop",
                            .help = "Continues at the other end of the slider instead of stopping"},
                           s.window.alpha_slider.loop));
  commands.add({.id = "alpha.speed",
                .title = "Set speed of playing…",
                .help = "Sets the speed; 1 crosses the slider in 260 pictures",
                .parameters = {{.name = "speed",
                                .kind = Kind::number,
                                .help = "Speed",
                                .example = "2",
                                .rule = kPlaySpeedRule}},
                .run = [&s](const Arguments& arguments) {
                  s.window.alpha_slider.speed = arguments.number("speed");
                  return Outcome();
                }});
  commands.add(
      {.id = "alpha.scale",
       .title = "Scale of the alpha slider",
       .help = "Gives small alphas more room on the slider, or the same room as all others",
       .menu = "Tools",
       .parameters = {{.name = "scale",
                       .kind = Kind::choice,
                       .help = "How alpha grows along the slider",
                       .choices = [&s] { return scalings(s); }}},
       .run = [&s](const Arguments& arguments) { return set_scaling(arguments, s); }});
  commands.add({.id = "alpha.range",
                .title = "Set range of the alpha slider…",
                .help = "Its two ends; alpha itself may be set beyond them",
                .parameters = {{.name = "low",
                                .kind = Kind::number,
                                .help = "The low end",
                                .example = "-3",
                                .rule = kAlphaRule},
                               {.name = "high",
                                .kind = Kind::number,
                                .help = "The high end",
                                .example = "10",
                                .rule = kAlphaRule}},
                .run = [&s](const Arguments& arguments) { return set_range(arguments, s); }});
}

void add_alpha_commands(Commands& commands, ViewState& s) {
  commands.add({.id = "alpha.set",
                .title = "Set alpha…",
                .help = "Every radius r becomes sqrt(r² + alpha)",
                .menu = "Tools",
                .parameters = {{.name = "alpha",
                                .kind = Kind::number,
                                .help = "Alpha",
                                .example = "1.4",
                                .rule = kAlphaRule}},
                .run = [&s](const Arguments& arguments) {
                  const AlphaInput alpha = read_alpha(arguments.text("alpha"));
                  if (!alpha.value) return Outcome::refused(alpha.error);
                  set_alpha(s.settings.request, *alpha.value);
                  s.playback.alpha = false;
                  return Outcome();
                }});
  commands.add({.id = "alpha.step",
                .title = "Change alpha by",
                .help = "Adds to alpha; a negative number subtracts",
                .shortcuts = {{"Right", "0.1"},
                              {"Left", "−0.1"},
                              {"Shift+Right", "1"},
                              {"Shift+Left", "−1"}},
                .parameters = {{.name = "step",
                                .kind = Kind::number,
                                .help = "The number to add to alpha",
                                .example = "0.1",
                                .rule = kAlphaRule}},
                .run = [&s](const Arguments& arguments) {
                  set_alpha(s.settings.request,
                            rounded(s.settings.request.alpha_angstrom2 + arguments.number("step")));
                  return Outcome();
                }});
  add_slider_commands(commands, s);
  commands.add(
      {.id = "solvent.set",
       .title = "Set solvent radius…",
       .help = "Adds this length to every radius, before alpha is applied; 1.4 Å for water",
       .synonyms = {{"probe water"}},
       .menu = "Tools",
       .parameters = {{.name = "radius",
                       .kind = Kind::number,
                       .help = "Solvent radius",
                       .example = "1.4",
                       .rule = kSolventRule}},
       .run = [&s](const Arguments& arguments) {
         s.settings.request.solvent_radius_angstrom = arguments.number("radius");
         return Outcome();
       }});
}

// --- Molecule

void add_molecule_commands(Commands& commands, ViewState& s) {
  BallOptions& c = s.settings.open.balls;
  const auto part = [&](const char* id, const char* title, bool& value) {
    commands.add(with_switch({.id = id,
                              .title = title,
                              .help = "Uses these atoms as balls, or leaves them out",
                              .why_not = without_molecule(s)},
                             value));
  };
  part("molecule.polymers", "Use polymers", c.polymers);
  part("molecule.ligands", "Use ligands", c.ligands);
  part("molecule.ions", "Use ions", c.ions);
  part("molecule.waters", "Use waters", c.waters);
  commands.add({.id = "models.play",
                .title = "Play models",
                .help = "Shows the models of the file one after the other, or stops that",
                .why_not =
                    [&s] {
                      return s.molecule.models.size() > 1
                                 ? ""
                                 : "No molecule with several models is open.";
                    },
                .checked = [&s] { return s.playback.models; },
                .run =
                    [&s](const Arguments&) {
                      s.playback.models = !s.playback.models;
                      return Outcome();
                    }});
}

// --- Engine, comparison, benchmark

std::vector<Choice> engines() {
  std::vector<Choice> choices;
  for (const EngineEntry& engine : engine_table()) {
    choices.push_back({std::string(engine.id), std::string(engine.title)});
  }
  return choices;
}

Outcome set_engine(const Arguments& arguments, ViewState& s) {
  const auto engine = engine_from_id(arguments.text("engine"));
  if (!engine) return Outcome::refused("There is no such engine.");
  if (needs_gpu(*engine) && !has_gpu(s)) {
    return Outcome::refused(
        s.gpu ? s.gpu->why_not : "Still looking for a graphics processor. Try again in a moment.");
  }
  s.settings.request.engine = *engine;
  return {};
}

// Stops playback, if something plays, and nothing else. The running step still finishes, so that
// the picture gets its complex. Otherwise cancels a job, or clears the selection.
Outcome stop(ViewState& s, const Calls& ask) {
  const bool playing = s.playback.alpha || s.playback.models || s.steps.playing;
  s.playback.alpha = s.playback.models = s.steps.playing = false;
  if (playing) return {};
  const RunningJob* job = awaited_job(s.jobs);
  if (job == nullptr) job = file_job(s.jobs);
  if (job != nullptr) {
    ask.jobs.cancel(job->id);
  } else {
    s.settings.selection.clear();
  }
  return {};
}

std::string nothing_to_stop(const ViewState& s) {
  const bool something = s.playback.alpha || s.playback.models || s.steps.playing ||
                         awaited_job(s.jobs) != nullptr || file_job(s.jobs) != nullptr ||
                         !s.settings.selection.empty();
  return something
             ? ""
             : "There is nothing to stop: nothing is playing, being fetched, read, computed, saved "
               "or selected.";
}

void add_engine_commands(Commands& commands, ViewState& s, const Calls& ask) {
  commands.add(
      {.id = "engine.set",
       .title = "Choose engine",
       .help = "Chooses the engine that computes the complex",
       .parameters =
           {{.name = "engine", .kind = Kind::choice, .help = "The engine", .choices = engines}},
       .run = [&s](const Arguments& arguments) { return set_engine(arguments, s); }});
  commands.add(with_switch({.id = "engine.tetrahedra_only",
                            .title = "Tetrahedra only",
                            .help = "Computes no triangles, edges and vertices, which is faster"},
                           s.settings.request.tetrahedra_only));
  commands.add(with_switch(
      {.id = "engine.auto_compare",
       .title = "Compare with CGAL every time",
       .help = "After each change CGAL computes the same complex, and the program compares both",
       .why_not =
           [&s] {
             const bool possible = s.molecule.balls <= kMostBallsToCompareUnasked;
             return possible ? "" : "The molecule is too large for CGAL to follow each change.";
           }},
      s.window.auto_compare));
  commands.add({.id = "compute.compare",
                .title = "Compare with CGAL",
                .help = "Computes the same complex with CGAL and compares simplex by simplex",
                .shortcuts = {{"C"}},
                .menu = "Tools",
                .line_above = true,
                .why_not = without_result(s),
                .run = [ask](const Arguments&) {
                  ask.jobs.compare();
                  return Outcome();
                }});
  commands.add({.id = "compute.anew",
                .title = "Measure cold times",
                .help = "Computes the same complex again, including the engine's set-up",
                .menu = "Tools",
                .why_not = without_result(s),
                .run = [ask](const Arguments&) {
                  ask.jobs.compute_anew();
                  return Outcome();
                }});
  commands.add({.id = "compute.stop",
                .title = "Stop or cancel",
                .help = "Stops playing, else cancels reading, computing, fetching or saving, else "
                        "clears the selection",
                .shortcuts = {{"Esc"}},
                .menu = "Tools",
                .why_not = [&s] { return nothing_to_stop(s); },
                .run = [&s, ask](const Arguments&) { return stop(s, ask); }});
  commands.add({.id = "benchmark.open",
                .title = "Benchmark…",
                .help = "Measures the engines with the open molecule",
                .menu = "Tools",
                .line_above = true,
                .why_not = without_molecule(s),
                .run = [&s](const Arguments&) {
                  s.playback.alpha = s.playback.models = false;
                  s.dialogs.show_benchmark = true;
                  return Outcome();
                }});
}

}  // namespace

void add_compute_commands(Commands& commands, ViewState& s, const Calls& ask) {
  add_alpha_commands(commands, s);
  add_molecule_commands(commands, s);
  add_engine_commands(commands, s, ask);
}

}  // namespace alphascope
