// SPDX-License-Identifier: GPL-3.0-or-later
// Commands of the page that shows an engine's steps for one ball.
#include "app/viewer/commands/command_parts.hpp"
#include "core/document/explain/steps_results.hpp"
#include "core/document/reference/atom_set.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/answer.hpp"
#include "ui/panels/explain/steps_state.hpp"
#include "ui/panels/window_settings.hpp"

namespace alphascope {
namespace {

using Kind = Parameter::Kind;

std::function<std::string()> without_page(const ViewState& s) {
  return [&s] { return s.window.page == kStepsPage ? "" : "Open the page Steps first."; };
}
std::function<std::string()> without_ball(const ViewState& s) {
  return [&s, without = without_picture(s)]() -> std::string {
    if (std::string why = without(); !why.empty()) return why;
    if (!s.result) return kNoComplexYet;
    return s.result->balls->size() > 0 ? "" : "There are no balls.";
  };
}

CommandSpec open_command(ViewState& s) {
  return {.id = "steps.open",
          .title = "Steps of the algorithm",
          .help = "Shows step by step how an engine finds the simplices of the selected atom",
          .shortcuts = {{"S"}},
          .menu = "Tools",
          .why_not = without_molecule(s),
          .run = [&s](const Arguments&) {
            s.window.page = kStepsPage;
            return Outcome();
          }};
}

// A command that goes to another step. Before the steps are known, next and back change the step
// that will be shown first.
struct Move {
  const char *id, *title, *help, *key;
  void (*go)(StepsState& memory);
};
constexpr Move kMoves[] = {
    {"steps.next", "Next step of the algorithm", "Shows the next step of the ball", "N",
     [](StepsState& m) { m.show(m.count() == 0 ? m.step + 1 : std::min(m.at() + 1, m.last())); }},
    {"steps.back", "Step back in the algorithm", "Shows the previous step", "Shift+N",
     [](StepsState& m) { m.show(std::max<std::size_t>(m.at(), 1) - 1); }},
    {"steps.first", "First step of the algorithm", "Shows the first step of the ball", "Home",
     [](StepsState& m) { m.show(0); }},
    {"steps.last", "Last step of the algorithm", "Shows the last step, the result", "End",
     [](StepsState& m) { m.show(m.count() == 0 ? StepsState::kLast : m.last()); }}};

void add_moves(Commands& commands, ViewState& s) {
  for (const Move& move : kMoves) {
    commands.add({.id = move.id,
                  .title = move.title,
                  .help = move.help,
                  .shortcuts = {{move.key}},
                  .why_not = without_page(s),
                  .run = [&s, go = move.go](const Arguments&) {
                    s.steps.playing = false;
                    go(s.steps);
                    return Outcome();
                  }});
  }
}

Outcome show(const Arguments& arguments, ViewState& s) {
  s.window.page = kStepsPage;
  s.steps.playing = false;
  s.steps.go_to = arguments.text("step");
  return {};
}

// Playback at the last step starts again at the first.
Outcome play(ViewState& s) {
  StepsState& m = s.steps;
  m.playing = !m.playing;
  if (m.playing && m.count() > 0 && m.at() == m.last()) m.show(0);
  return {};
}

Outcome take_middle(ViewState& s) {
  const auto ball = middle_ball(*s.result->balls);
  s.settings.selection.clear();
  s.settings.selection.items = RefSet({Ref{s.references->atom(*ball)}});
  s.window.page = kStepsPage;
  return {};
}

void add_engine_command(Commands& commands, ViewState& s) {
  Parameter engine{.name = "engine", .kind = Kind::choice, .help = "Which engine"};
  engine.choices = [&s] {
    std::vector<Choice> choices;
    for (const StepsEngineSpec& spec : steps_engines()) {
      choices.push_back(
          {steps_engine_id(spec.engine), spec.title, "", s.steps.engine == spec.engine});
    }
    return choices;
  };
  commands.add(
      {.id = "steps.engine",
       .title = "Choose the engine whose steps are shown…",
       .help = "Chooses the engine whose steps the page Steps shows; the complex does not change",
       .parameters = {engine},
       .run = [&s](const Arguments& arguments) {
         for (const StepsEngineSpec& spec : steps_engines()) {
           if (arguments.text("engine") != steps_engine_id(spec.engine)) continue;
           if (s.steps.engine != spec.engine) s.steps.show(0);
           s.steps.engine = spec.engine;
         }
         return Outcome();
       }});
}

void add_switches(Commands& commands, ViewState& s) {
  StepsState& m = s.steps;
  commands.add(with_switch({.id = "steps.edge_optimisation",
                            .title = "Edge optimisation of the steps",
                            .help = "Keeps only tuples whose balls all meet, in the steps "
                                    "alone; the engine's own setting does not change"},
                           m.edge_optimisation));
  commands.add(with_switch({.id = "steps.alpha_optimisation",
                            .title = "Alpha optimisation of the steps",
                            .help = "Drops 4-tuples with ρ > α before kernel II, in the steps "
                                    "alone; the engine's own setting does not change"},
                           m.alpha_optimisation));
  commands.add(with_switch({.id = "steps.marks",
                            .title = "Draw the step",
                            .help = "Draws the balls, boxes and simplices of the step that the "
                                    "page Steps shows"},
                           m.marks));
}

}  // namespace

void add_steps_commands(Commands& commands, ViewState& s) {
  commands.add(open_command(s));
  add_moves(commands, s);
  commands.add({.id = "steps.show",
                .title = "Show a step of the algorithm…",
                .help = "Shows one step of the selected ball by its number or name",
                .parameters = {{.name = "step",
                                .help = "Its number in the list, or its name, such as grid, cube, "
                                        "tuples, alpha, filter, exact or result",
                                .example = "filter"}},
                .why_not = without_molecule(s),
                .run = [&s](const Arguments& arguments) { return show(arguments, s); }});
  commands.add({.id = "steps.play",
                .title = "Play the steps",
                .help = "Shows one step after the other, or pauses",
                .shortcuts = {{"Shift+S"}},
                .why_not = without_page(s),
                .checked = [&s] { return s.steps.playing; },
                .run = [&s](const Arguments&) { return play(s); }});
  commands.add({.id = "steps.middle",
                .title = "Steps of a ball in the middle",
                .help = "Selects the atom nearest to the middle of the molecule, and shows its "
                        "steps",
                .why_not = without_ball(s),
                .run = [&s](const Arguments&) { return take_middle(s); }});
  commands.add({.id = "steps.look",
                .title = "Look at the ball of the steps",
                .help = "Moves the ball and its neighbours to the middle of the view",
                .why_not = without_page(s),
                .run = [&s](const Arguments&) {
                  s.steps.look = true;
                  return Outcome();
                }});
  add_switches(commands, s);
  if (steps_engines().size() > 1) add_engine_command(commands, s);
}

}  // namespace alphascope
