// See the header.
#include "app/viewer/script.hpp"

#include <chrono>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "app/session/system_memory.hpp"
#include "app/viewer/viewer.hpp"
#include "ui/panels/keys.hpp"

namespace alphascope {
namespace {

constexpr std::chrono::seconds kLongestWait{300};

class ScriptRunner {
 public:
  ScriptRunner(Viewer& viewer, std::ostream& out) : viewer_(viewer), out_(out) { frames(3); }

  // Returns false for `quit`.
  bool run(const std::string& line) {
    std::istringstream arguments(line);
    std::string command;
    arguments >> command;
    if (command.empty() || command.front() == '#') return true;
    if (command == "when") return when(rest(arguments));
    if (command == "end") return end();
    if (skipping_) return true;
    if (command == "quit") return false;
    const auto it = kCommands.find(command);
    if (it == kCommands.end()) throw std::runtime_error("unknown command '" + command + "'");
    (this->*it->second)(arguments);
    return !viewer_.quit_requested();
  }

  // Throws when a `when` has no `end`.
  void finish() const {
    if (inside_when_) throw std::runtime_error("the last 'when' has no 'end'");
  }

 private:
  using Command = void (ScriptRunner::*)(std::istream&);
  static const std::map<std::string, Command> kCommands;

  void frames(int count) {
    for (int i = 0; i < count; ++i) viewer_.step(&input_);
  }

  // Asks the molecule and not the widgets: one that should be there and is not stays an error.
  bool holds(const std::string& condition) const {
    const MoleculeInfo& m = viewer_.state().molecule;
    const std::map<std::string, bool> conditions{{"dropped", !m.dropped.empty()},
                                                 {"guessed", !m.radius_rows.empty()},
                                                 {"chains", m.chains.size() > 1},
                                                 {"models", m.models.size() > 1},
                                                 {"assemblies", !m.assemblies.empty()}};
    const auto found = conditions.find(condition);
    if (found == conditions.end()) {
      throw std::runtime_error("unknown condition '" + condition +
                               "'; known are dropped, guessed, chains, models, assemblies");
    }
    return found->second;
  }
  bool when(const std::string& condition) {
    if (inside_when_) throw std::runtime_error("'when' inside of 'when'");
    inside_when_ = true;
    skipping_ = !holds(condition);
    return true;
  }
  bool end() {
    if (!inside_when_) throw std::runtime_error("'end' without 'when'");
    inside_when_ = skipping_ = false;
    return true;
  }

  // "radius.*" is the first in the alphabet whose name starts with "radius.".
  WidgetRects::const_iterator find(const std::string& name) const {
    const WidgetRects& all = viewer_.widgets();
    if (name.empty() || name.back() != '*') return all.find(name);
    const std::string start = name.substr(0, name.size() - 1);
    const auto it = all.lower_bound(start);
    return it != all.end() && it->first.starts_with(start) ? it : all.end();
  }

  static std::string rest(std::istream& arguments) {
    std::string text;
    std::getline(arguments >> std::ws, text);
    if (text.empty()) throw std::runtime_error("something is missing after the command");
    return text;
  }

  void move(std::istream& arguments) {
    std::string name;
    float fx = 0.5f, fy = 0.5f;
    if (!(arguments >> name)) throw std::runtime_error("name a widget to move to");
    arguments >> fx >> fy;
    auto it = find(name);
    if (it != viewer_.widgets().end() && !it->second.visible) {
      viewer_.state().memory.reveal = it->first;
      frames(2);
      it = find(name);
    }
    if (it == viewer_.widgets().end()) {
      throw std::runtime_error("there is no widget '" + name + "' on screen");
    }
    input_.x = it->second.x0 + fx * (it->second.x1 - it->second.x0);
    input_.y = it->second.y0 + fy * (it->second.y1 - it->second.y0);
    frames(2);  // hovering must be settled before a press
  }
  void down(std::istream&) {
    input_.down[0] = true;
    frames(2);
  }
  void up(std::istream&) {
    input_.down[0] = false;
    frames(2);
  }
  void click(std::istream& arguments) {
    move(arguments);
    down(arguments);
    up(arguments);
  }
  void double_click(std::istream& arguments) {
    click(arguments);
    down(arguments);
    up(arguments);
  }
  void wheel(std::istream& arguments) {
    if (!(arguments >> input_.wheel)) throw std::runtime_error("wheel needs a number of steps");
    frames(2);
  }
  void type(std::istream& arguments) {
    input_.text = rest(arguments);
    frames(2);
  }
  void key(std::istream& arguments) {
    std::string name = rest(arguments);
    input_.control = name.starts_with("ctrl+");
    if (input_.control) name.erase(0, 5);
    const int code = key_code(name);
    input_.keys[code] = true;
    frames(2);
    input_.keys[code] = false;
    input_.control = false;
    frames(2);
  }
  static int key_code(const std::string& name) {
    static const std::map<std::string, int> kKeys{
        {"enter", key::kEnter}, {"escape", key::kEscape}, {"backspace", key::kBackspace},
        {"f1", key::kF1},       {"left", key::kLeft},     {"right", key::kRight},
        {"tab", key::kTab},     {"delete", key::kDelete}};
    if (const auto it = kKeys.find(name); it != kKeys.end()) return it->second;
    if (name.size() == 1 && name[0] >= 'a' && name[0] <= 'z') return name[0] - 'a' + key::kA;
    throw std::runtime_error("unknown key '" + name + "'");
  }
  void wait_idle(std::istream&) {
    const auto deadline = std::chrono::steady_clock::now() + kLongestWait;
    // One job's result can start the next when it is taken in, so a quiet moment is not yet the
    // end.
    for (int quiet = 0; quiet < 4; quiet = viewer_.busy() ? 0 : quiet + 1) {
      if (std::chrono::steady_clock::now() > deadline) {
        throw std::runtime_error("still busy after five minutes");
      }
      if (viewer_.busy()) viewer_.host().wait_events(0.005);
      frames(1);
    }
  }
  void pass_frames(std::istream& arguments) {
    int count = 1;
    arguments >> count;
    frames(count);
  }
  void open(std::istream& arguments) {
    viewer_.open(rest(arguments));
    frames(1);
  }
  void size(std::istream& arguments) {
    int width = 0, height = 0;
    if (!(arguments >> width >> height) || width < 64 || height < 64) {
      throw std::runtime_error("size needs a width and a height in pixels");
    }
    viewer_.host().resize(width, height);
    frames(3);
  }
  void shot(std::istream& arguments) { viewer_.shoot(rest(arguments), &input_); }
  void print(std::istream&) {
    const ResultInfo& r = viewer_.state().result;
    out_ << "alpha " << r.alpha << " solvent " << r.solvent << " vertices " << r.vertices
         << " edges " << r.edges << " triangles " << r.triangles << " tetrahedra " << r.tetrahedra
         << " hash " << r.hash << " badge " << viewer_.state().badge.text << '\n';
  }

  void time(std::istream& arguments) {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double, std::milli> since = now - last_time_;
    last_time_ = now;
    out_ << rest(arguments) << ": " << since.count() << " ms\n";
  }

  void memory(std::istream& arguments) {
    const auto megabytes = [](std::uint64_t bytes) { return static_cast<double>(bytes) / 1e6; };
    const std::string text = rest(arguments);
    out_ << text << ": " << megabytes(resident_bytes()) << " MB resident, "
         << megabytes(allocated_bytes()) << " MB in use" << std::endl;
  }

  Viewer& viewer_;
  std::ostream& out_;
  std::chrono::steady_clock::time_point last_time_ = std::chrono::steady_clock::now();
  ScriptedInput input_;
  bool inside_when_ = false, skipping_ = false;
};

const std::map<std::string, ScriptRunner::Command> ScriptRunner::kCommands{
    {"move", &ScriptRunner::move},
    {"down", &ScriptRunner::down},
    {"up", &ScriptRunner::up},
    {"click", &ScriptRunner::click},
    {"double-click", &ScriptRunner::double_click},
    {"wheel", &ScriptRunner::wheel},
    {"type", &ScriptRunner::type},
    {"key", &ScriptRunner::key},
    {"wait-idle", &ScriptRunner::wait_idle},
    {"frames", &ScriptRunner::pass_frames},
    {"open", &ScriptRunner::open},
    {"size", &ScriptRunner::size},
    {"shot", &ScriptRunner::shot},
    {"print", &ScriptRunner::print},
    {"time", &ScriptRunner::time},
    {"memory", &ScriptRunner::memory}};

}  // namespace

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
    throw std::runtime_error(name + ", line " + std::to_string(number) + ": " + error.what());
  }
}

}  // namespace alphascope
