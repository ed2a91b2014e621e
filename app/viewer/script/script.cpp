// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the lines of a script: commands of the menus, and verbs for mouse, keys, waiting and
// pictures.
#include "app/viewer/script/script.hpp"

#include <chrono>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "app/options/did_you_mean.hpp"
#include "app/session/system_memory.hpp"
#include "app/viewer/commands/commands.hpp"
#include "app/viewer/resources.hpp"
#include "app/viewer/script/timed_moves.hpp"
#include "app/viewer/viewer.hpp"
#include "core/document/store/inputs.hpp"
#include "core/files/output_ending.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/radii/radii_set.hpp"
#include "core/run/freed_on_other_thread.hpp"
#include "core/text/text_parts.hpp"
#include "ui/no_calls.hpp"
#include "ui/panels/failure_kind.hpp"
#include "ui/panels/whole_state.hpp"
#include "ui/widgets/keys.hpp"

namespace alphascope {
namespace {

struct NotDone : std::runtime_error {
  explicit NotDone(const Outcome& outcome)
      : std::runtime_error(outcome.why), kind(kind_of(outcome.cause, ErrorKind::input)) {}
  ErrorKind kind;
};

using Kind = Parameter::Kind;
constexpr std::chrono::seconds kLongestWait{300};
constexpr double kBusyFrame = 0.05;  // seconds between frames while nothing wakes the window

class ScriptRunner {
 public:
  // An action that only scripts have: mouse, keys, waiting, pictures of the window.
  struct Verb {
    CommandSpec spec;  // without run
    void (ScriptRunner::*act)(const Arguments& arguments);
  };
  static std::vector<Verb> all_verbs();

  ScriptRunner(Viewer& viewer, std::ostream& out) : viewer_(viewer), out_(out) {
    for (Verb& verb : all_verbs()) {
      verb.spec.run = [this, act = verb.act](const Arguments& arguments) {
        (this->*act)(arguments);
        return Outcome();
      };
      verbs_.add(std::move(verb.spec));
    }
    frames(3);
  }

  // Returns false for `quit`.
  bool run(const std::string& line) {
    const std::string id = first_word(line);
    if (id.empty() || id.front() == '#') return true;
    if (skipping_ && id != "when" && id != "end") return true;
    const bool verb = verbs_.find(id) != nullptr;
    const Commands& list = verb ? verbs_ : viewer_.commands();
    if (list.find(id) == nullptr) throw std::runtime_error(unknown(id));
    const Outcome outcome = list.run_line(line);
    if (!outcome.done()) throw NotDone(outcome);
    if (!verb) frames(1);
    return !quit_ && !viewer_.quit_requested();
  }

  // Throws std::runtime_error for a `when` without `end`.
  void finish() const {
    if (inside_when_) throw std::runtime_error("the last 'when' has no 'end'");
  }

 private:
  static std::string first_word(const std::string& line) {
    std::vector<std::string> words = words_of(line);
    return words.empty() ? std::string() : std::move(words.front());
  }
  std::string unknown(const std::string& id) const {
    std::vector<std::string> known;
    for (const Commands* list : {&verbs_, &viewer_.commands()}) {
      for (const CommandSpec& spec : list->all()) known.push_back(spec.id);
    }
    return "unknown command '" + id + "'." + did_you_mean(id, known);
  }

  void frames(int count) {
    for (int i = 0; i < count; ++i) viewer_.step(&input_);
  }

  // Conditions ask for facts about the molecule, not for widgets. So a missing widget is still an
  // error.
  bool holds(const std::string& condition) const {
    const MoleculeInfo& m = viewer_.state().molecule;
    return (condition == "dropped" && !m.dropped.empty()) ||
           (condition == "guessed" && !m.radius_rows.empty()) ||
           (condition == "chains" && m.contents.chains.size() > 1) ||
           (condition == "models" && m.models.size() > 1) ||
           (condition == "assemblies" && !m.assemblies.empty());
  }
  void when(const Arguments& arguments) {
    if (inside_when_) throw std::runtime_error("'when' inside of 'when'");
    inside_when_ = true;
    skipping_ = !holds(arguments.text("condition"));
  }
  void end(const Arguments&) {
    if (!inside_when_) throw std::runtime_error("'end' without 'when'");
    inside_when_ = skipping_ = false;
  }
  void quit(const Arguments&) { quit_ = true; }

  // A name such as "radius.*" finds the first widget, in alphabetical order, that starts with
  // "radius.".
  WidgetRects::const_iterator find(const std::string& name) const {
    const WidgetRects& all = viewer_.widgets();
    if (name.empty() || name.back() != '*') return all.find(name);
    const std::string start = name.substr(0, name.size() - 1);
    const auto it = all.lower_bound(start);
    return it != all.end() && it->first.starts_with(start) ? it : all.end();
  }

  void move(const Arguments& arguments) {
    const auto fx = static_cast<float>(arguments.number("x", 0.5));
    const auto fy = static_cast<float>(arguments.number("y", 0.5));
    const WidgetRect widget = place(arguments.text("name"));
    input_.x = widget.x0 + fx * (widget.x1 - widget.x0);
    input_.y = widget.y0 + fy * (widget.y1 - widget.y0);
    frames(2);  // hovering must settle before a press
  }
  // The rectangle of a widget, after scrolling it into view.
  WidgetRect place(const std::string& name) {
    auto it = find(name);
    if (it != viewer_.widgets().end() && !it->second.visible) {
      viewer_.state().scroll.widget = it->first;
      frames(2);
      it = find(name);
    }
    if (it == viewer_.widgets().end()) {
      throw std::runtime_error("there is no widget '" + name + "' on screen");
    }
    return it->second;
  }
  void down(const Arguments&) {
    input_.down[0] = true;
    frames(2);
  }
  void up(const Arguments&) {
    input_.down[0] = false;
    frames(2);
  }
  // Drags to and fro in real time, with frames at the times of run().
  void drag(const Arguments& arguments) {
    using Clock = std::chrono::steady_clock;
    using Seconds = std::chrono::duration<double>;
    const std::string name = arguments.text("name");
    const double from = arguments.number("from"), to = arguments.number("to");
    const Seconds seconds(arguments.number("seconds"));
    const WidgetRect widget = place(name);
    input_.y = 0.5f * (widget.y0 + widget.y1);
    const auto at = [&](double place) {
      input_.x = widget.x0 + static_cast<float>(place) * (widget.x1 - widget.x0);
      frames(1);
    };
    at(from);
    down({});
    const auto tables = [&] { return viewer_.times_made("cavities.lines"); };
    const std::uint64_t tables_before = tables();
    const Clock::time_point start = Clock::now();
    const Answer* shown = viewer_.state().result.get();
    std::uint64_t drawn = 0, pictures = 0;
    Seconds longest{0};
    for (Clock::time_point now = start; now - start < seconds; now = Clock::now()) {
      const double along = std::fmod(Seconds(now - start).count(), 2);  // one second each way
      at(from + (to - from) * (along < 1 ? along : 2 - along));
      const Seconds took = Clock::now() - now;
      longest = std::max(longest, took);
      ++drawn;
      pictures +=
          std::exchange(shown, viewer_.state().result.get()) != viewer_.state().result.get();
      viewer_.wait_for_frame();
    }
    const double whole = Seconds(Clock::now() - start).count();
    out_ << "drag " << name << ": " << whole << " s, " << drawn << " frames, the longest "
         << 1e3 * longest.count() << " ms, " << pictures << " pictures, "
         << tables() - tables_before << " tables of cavities\n";
    up({});
  }
  void click(const Arguments& arguments) {
    move(arguments);
    down(arguments);
    up(arguments);
  }
  void right_click(const Arguments& arguments) {
    move(arguments);
    for (const bool down : {true, false}) {
      input_.down[1] = down;
      frames(2);
    }
    frames(2);  // until the menu is open
  }
  void double_click(const Arguments& arguments) {
    click(arguments);
    down(arguments);
    up(arguments);
  }
  void wheel(const Arguments& arguments) {
    input_.wheel = static_cast<float>(arguments.number("steps"));
    frames(2);
  }
  void type(const Arguments& arguments) {
    input_.text = arguments.text("text");
    frames(2);
  }
  void key(const Arguments& arguments) {
    const std::string name = arguments.text("keys");
    const auto chord = key::read_chord(name);
    if (!chord) throw std::runtime_error("unknown key '" + name + "'");
    input_.control = chord->control;
    input_.shift = chord->shift;
    input_.keys[chord->code] = true;
    frames(2);
    input_.keys[chord->code] = false;
    input_.control = input_.shift = false;
    frames(2);
  }
  void wait_idle(const Arguments&) {
    const auto deadline = std::chrono::steady_clock::now() + kLongestWait;
    // A result may start the next job, so the end is four frames without work.
    for (int quiet = 0; quiet < 4; quiet = viewer_.busy() ? 0 : quiet + 1) {
      if (std::chrono::steady_clock::now() > deadline) {
        throw std::runtime_error("still busy after five minutes");
      }
      if (viewer_.busy()) viewer_.host().wait_events(kBusyFrame);
      frames(1);
    }
  }
  void pass_frames(const Arguments& arguments) {
    frames(static_cast<int>(arguments.number("count", 1)));
  }
  void open(const Arguments& arguments) {
    viewer_.open(arguments.text("path"));
    frames(1);
  }
  void size(const Arguments& arguments) {
    viewer_.host().resize(static_cast<int>(arguments.number("width")),
                          static_cast<int>(arguments.number("height")));
    frames(3);
  }
  void shots_only(const Arguments&) { viewer_.draw_shots_only(); }
  void shot(const Arguments& arguments) {
    const std::string path = arguments.text("path");
    const std::string fault = fault_of_ending(path, {".png"});
    if (!fault.empty()) throw std::runtime_error(path + ": " + fault + ".");
    viewer_.shoot(path, &input_);
  }
  void where(const Arguments& arguments) {
    move(arguments);
    out_ << arguments.text("name") << ' ' << std::lround(input_.x) << ' ' << std::lround(input_.y)
         << '\n';
  }
  void print(const Arguments&) {
    const Answer none;
    const Answer& r = viewer_.state().result ? *viewer_.state().result : none;
    out_ << "alpha " << r.request.alpha_angstrom2 << " solvent "
         << r.request.solvent_radius_angstrom << " vertices " << r.complex.vertices.size()
         << " edges " << r.complex.edges.size() << " triangles " << r.complex.triangles.size()
         << " tetrahedra " << r.complex.tetrahedra.size() << " hash " << hash_text(r.complex.hash)
         << " badge " << viewer_.state().badge.text << '\n';
  }

  void time(const Arguments& arguments) {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double, std::milli> since = now - last_time_;
    last_time_ = now;
    out_ << arguments.text("text") << ": " << since.count() << " ms\n";
  }

  void alpha_moves(const Arguments& arguments) {
    out_ << time_alpha_moves(viewer_, input_, arguments.number("alpha"),
                             static_cast<int>(arguments.number("moves", 20)))
         << std::endl;
  }

  void ball_moves(const Arguments& arguments) {
    const int moves = static_cast<int>(arguments.number("moves", 20));
    out_ << time_ball_moves(viewer_, input_, moves) << std::endl;
  }

  void memory(const Arguments& arguments) {
    const auto megabytes = [](std::uint64_t bytes) { return static_cast<double>(bytes) / 1e6; };
    const std::string text = arguments.text("text");
    wait_until_freed();
    out_ << text << ": " << megabytes(resident_bytes()) << " MB resident, "
         << megabytes(allocated_bytes()) << " MB in use" << std::endl;
  }

  Viewer& viewer_;
  std::ostream& out_;
  Commands verbs_;
  std::chrono::steady_clock::time_point last_time_ = std::chrono::steady_clock::now();
  ScriptedInput input_;
  bool inside_when_ = false, skipping_ = false, quit_ = false;
};

constexpr NumberRule kPlaceRule{"A place in a widget", -100, 100};
constexpr NumberRule kSecondsRule{"The time", 0, 600, "s"};
constexpr NumberRule kWheelRule{"The number of steps", -1000, 1000};
constexpr NumberRule kMovedAlphaRule{"Alpha", -1e6, 1e6, "Å²"};
constexpr NumberRule kMovesRule{"The number of moves", 1, 1e4, "", true};
constexpr NumberRule kFramesRule{"The number of frames", 0, 1e6, "", true};
constexpr NumberRule kWindowRule{"Width and height of the window", 64, 16384, "pixels", true};

Parameter number(const char* name, const NumberRule& rule, bool optional = false) {
  return {.name = name, .kind = Kind::number, .optional = optional, .rule = rule};
}

std::vector<Parameter> widget() {
  return {{.name = "name", .example = "alpha.slider"},
          number("x", kPlaceRule, true),
          number("y", kPlaceRule, true)};
}

std::vector<Parameter> one(Parameter parameter) {
  return {std::move(parameter)};
}

std::vector<Choice> conditions() {
  return {{"dropped", "Atoms were left out"},
          {"guessed", "Radii were guessed, or set by hand"},
          {"chains", "More than one chain"},
          {"models", "More than one model"},
          {"assemblies", "There are assemblies"}};
}

CommandSpec verb(const char* id, const char* help, std::vector<Parameter> parameters = {}) {
  return {.id = id, .title = id, .help = help, .parameters = std::move(parameters)};
}

std::vector<ScriptRunner::Verb> ScriptRunner::all_verbs() {
  using S = ScriptRunner;
  const Parameter text{.name = "text", .example = "opened"};
  const Parameter picture{.name = "path", .kind = Kind::path, .example = "window.png"};
  const Parameter file{.name = "path", .kind = Kind::path, .example = "1crn.pdb"};
  const Parameter keys{.name = "keys", .example = "ctrl+o"};
  Parameter condition{.name = "condition", .kind = Kind::choice};
  condition.choices = conditions;
  return {
      {verb("move",
            "Moves the mouse to a widget, scrolled into sight; x and y from 0 to 1 inside it, else "
            "its middle. A name with * at its end stands for the first widget that begins so",
            widget()),
       &S::move},
      {verb("down", "Presses the left mouse button"), &S::down},
      {verb("up", "Releases the left mouse button"), &S::up},
      {verb("click", "As move, down and up", widget()), &S::click},
      {verb("drag",
            "Drags to and fro in a widget, a second each way; then writes the numbers of "
            "frames, pictures and tables of cavities",
            {{.name = "name", .example = "alpha.slider"},
             number("from", kPlaceRule),
             number("to", kPlaceRule),
             number("seconds", kSecondsRule)}),
       &S::drag},
      {verb("right-click", "As click, with the right button", widget()), &S::right_click},
      {verb("double-click", "As click, twice", widget()), &S::double_click},
      {verb("wheel", "Turns the wheel at the mouse's position", one(number("steps", kWheelRule))),
       &S::wheel},
      {verb("type", "Types into the field that has the keyboard", one(text)), &S::type},
      {verb("key", "Presses a key: enter, esc, up, f1, ctrl+o, ctrl+shift+z, …", one(keys)),
       &S::key},
      {verb("wait-idle", "Waits until nothing is being read, computed, compared or drawn"),
       &S::wait_idle},
      {verb("frames", "Waits for a number of frames", one(number("count", kFramesRule, true))),
       &S::pass_frames},
      {verb("open", "Opens a file as if it had been dropped on the window", one(file)), &S::open},
      {verb("size", "Changes the size of the window, in pixels",
            {number("width", kWindowRule), number("height", kWindowRule)}),
       &S::size},
      {verb("shots-only",
            "Draws the panels only in frames that are saved as pictures, from now on"),
       &S::shots_only},
      {verb("shot", "Writes a picture of the whole window as a PNG file", one(picture)), &S::shot},
      {verb("where",
            "Moves the mouse as move does; then writes the widget's name and the mouse's "
            "position in pixels from the top left",
            widget()),
       &S::where},
      {verb("print", "Writes counts and hash of the result to standard output"), &S::print},
      {verb("time", "Writes the text, then the milliseconds since the last such command",
            one(text)),
       &S::time},
      {verb("alpha-moves",
            "Moves alpha to this value again and again; writes the median and, in brackets, "
            "the longest time to the end of the first frame that shows it, and of each part, "
            "in milliseconds. Two more moves come first and are not counted",
            {number("alpha", kMovedAlphaRule), number("moves", kMovesRule, true)}),
       &S::alpha_moves},
      {verb("ball-moves",
            "Moves balls set by hand, one after another; writes the milliseconds as alpha-moves",
            one(number("moves", kMovesRule, true))),
       &S::ball_moves},
      {verb("memory",
            "Writes the text, then the megabytes (10^6 bytes) that are resident and those of the "
            "heap in use",
            one(text)),
       &S::memory},
      {verb("when",
            "Skips the lines up to end, unless the molecule has any of these: atoms left out, "
            "radii guessed or set by hand, more than one chain or model, assemblies",
            one(std::move(condition))),
       &S::when},
      {verb("end", "Ends a when"), &S::end},
      {verb("quit", "Ends the script"), &S::quit}};
}

constexpr std::size_t kHelpWidth = 100, kHelpIndent = 6;

// Prints the text indented, with lines broken at blanks.
void print_wrapped(std::ostream& out, const std::string& text) {
  std::size_t column = 0;
  for (const std::string& word : words_of(text)) {
    if (column == 0 || column + 1 + word.size() > kHelpWidth) {
      out << (column == 0 ? "" : "\n") << std::string(kHelpIndent, ' ') << word;
      column = kHelpIndent + word.size();
    } else {
      out << ' ' << word;
      column += 1 + word.size();
    }
  }
  out << '\n';
}

void print_help(std::ostream& out, const CommandSpec& spec) {
  const std::string keys = spec.shortcuts_text();
  out << "  " << spec.usage() << (keys.empty() ? "" : "   (" + keys + ")") << '\n';
  print_wrapped(out, spec.help + ".");
  for (const Parameter& p : spec.parameters) {
    const std::string unit = p.unit();
    if (p.help.empty() || spec.is_switch()) continue;
    print_wrapped(out, p.name + ": " + p.help + (unit.empty() ? "." : ", in " + unit + "."));
  }
}

}  // namespace

std::string script_help() {
  std::ostringstream out;
  out << "Scripts for alphascope --script FILE: one command a line. Empty lines and lines that "
         "start\nwith # are skipped. Quote a path that contains blanks, unless it ends the line.\n"
         "\nCommands of the window, which are also in its menus and in the list of Ctrl+P:\n";
  WholeState state;
  for (const SampleMolecule& sample : sample_files())
    state.samples.push_back({sample.name, "", {}});
  Commands commands;
  NoCalls nobody;
  PanelSet panels;
  add_program_commands(commands, state, nobody.calls(), panels);
  for (const CommandSpec& spec : commands.all()) print_help(out, spec);
  out << "\nMouse, keys, waiting and pictures of the window:\n";
  for (const ScriptRunner::Verb& verb : ScriptRunner::all_verbs()) print_help(out, verb.spec);
  return out.str();
}

void run_script(Viewer& viewer, std::istream& script, const std::string& name, std::ostream& out) {
  ScriptRunner runner(viewer, out);
  std::string line;
  int number = 1;
  try {
    for (; std::getline(script, line); ++number) {
      if (!runner.run(line)) return;
    }
    runner.finish();
  } catch (const std::exception& error) {
    const auto* const not_done = dynamic_cast<const NotDone*>(&error);
    throw ScriptError(name + ", line " + std::to_string(number) + ": " + error.what(),
                      not_done != nullptr ? not_done->kind : ErrorKind::input);
  }
}

}  // namespace alphascope
