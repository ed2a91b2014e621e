// SPDX-License-Identifier: GPL-3.0-or-later
// Commands for labels of atoms, distances and angles between atoms, and marks at places in space.
#include <algorithm>
#include <stdexcept>

#include "app/viewer/commands/command_parts.hpp"
#include "core/document/reference/atom_labels.hpp"
#include "core/document/reference/measurement_columns.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/session/settings_fields.hpp"
#include "core/explain/power_diagram.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/radii/radii_set.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/selection/selection_error.hpp"
#include "ui/annotation_layer.hpp"
#include "ui/panels/explain/steps_state.hpp"
#include "ui/panels/window_settings.hpp"
#include "ui/widgets/format.hpp"

namespace alphascope {
namespace {

using Kind = Parameter::Kind;

std::string count(std::size_t n) {
  return with_separators(static_cast<long long>(n));
}

// --- labels

LabelText label_named(std::string_view id) {
  for (const auto& [text, known] : label_text_ids()) {
    if (known == id) return text;
  }
  return LabelText::address;
}

// Each has the text of the first selected atom or simplex beside it, or else an example.
std::vector<Choice> label_texts(const ViewState& s) {
  std::vector<Choice> all{{"address", "Chain, residue and atom", "A:HIS 87:NE2"},
                          {"residue", "Residue", "HIS 87"},
                          {"name", "Name of the atom", "NE2"},
                          {"element", "Element", "N"},
                          {"radius", "Radius", "1.64 Å"},
                          {"b_factor", "B factor", "24.1 Å²"}};
  const std::vector<Ref>& selected = s.settings.selection.items.items();
  for (Choice& choice : all) {
    if (selected.empty() || s.references == nullptr) {
      choice.detail = "such as " + choice.detail;
      continue;
    }
    choice.detail = label_text(*s.references, selected.front(), label_named(choice.id));
    if (selected.size() > 1)
      choice.detail += (choice.detail.empty() ? "" : ", ") + std::string("…");
  }
  return all;
}

Outcome label_atoms(ViewState& s, const Arguments& arguments) {
  const NamedOrSelectedAtoms asked = named_or_selected_atoms(s, arguments.text("atoms"));
  if (!asked.fault.empty()) return Outcome::refused(asked.fault);
  const LabelText text = label_named(arguments.text("text"));
  LabelGroups labels = s.settings.annotations.labels;
  set_labels(labels, asked.atoms, text);
  if (label_count(s.references->molecule(), labels) > kMostLabels) {
    return Outcome::refused("A picture has at most " + count(kMostLabels) +
                            " labels. Name fewer atoms, or label their residues.");
  }
  s.settings.annotations.labels = std::move(labels);
  return {};
}

void add_label_commands(Commands& commands, ViewState& s) {
  CommandSpec label{
      .id = "label.atoms",
      .title = "Label atoms",
      .help = "Writes names or values of atoms beside them, in the picture",
      .shortcuts = {{"L", "address"}},
      .menu = "Edit",
      .line_above = true,
      .parameters = {{.name = "text",
                      .kind = Kind::choice,
                      .help = "Text of the labels; residue: one label for each residue",
                      .choices = [&s] { return label_texts(s); }},
                     which_atoms()}};
  label.why_not = without_picture(s);
  label.run = [&s](const Arguments& arguments) { return label_atoms(s, arguments); };
  commands.add(std::move(label));
  const auto none = [&s] {
    return s.settings.annotations.labels.empty() ? "There is no label." : "";
  };
  commands.add({.id = "label.remove",
                .title = "Remove labels",
                .help = "Removes the labels of atoms",
                .shortcuts = {{"Shift+L"}},
                .menu = "Edit",
                .parameters = {which_atoms()},
                .why_not =
                    [&s, none] {
                      const std::string reason = none();
                      return reason.empty() ? without_picture(s)() : reason;
                    },
                .run =
                    [&s](const Arguments& arguments) {
                      const NamedOrSelectedAtoms asked =
                          named_or_selected_atoms(s, arguments.text("atoms"));
                      if (!asked.fault.empty()) return Outcome::refused(asked.fault);
                      set_labels(s.settings.annotations.labels, asked.atoms, std::nullopt);
                      return Outcome();
                    }});
  commands.add({.id = "label.remove_all",
                .title = "Remove all labels",
                .help = "Removes all labels of atoms",
                .menu = "Edit",
                .why_not = none,
                .run = [&s](const Arguments&) {
                  s.settings.annotations.labels.clear();
                  return Outcome();
                }});
}

// --- distances and angles

Outcome measure_atoms(ViewState& s, const Arguments& arguments) {
  const std::string text = arguments.text("atoms");
  if (text.empty()) {
    const SelectedMeasurement asked = selected_measurement(s.settings.selection);
    return asked.measurement ? add_measurement(s, *asked.measurement)
                             : Outcome::refused(asked.why_not);
  }
  try {
    return add_measurement(s, read_measurement(*s.references, text));
  } catch (const SelectionError& error) {
    return Outcome::refused(std::string("Cannot understand the atoms: ") + error.what() + ".");
  } catch (const std::invalid_argument& error) {
    return Outcome::refused(error.what());
  }
}

Outcome remove_measurement(ViewState& s, const Arguments& arguments) {
  Measurements& all = s.settings.annotations.measurements;
  const auto number = static_cast<std::size_t>(arguments.number("number"));
  if (number > all.size()) {
    return Outcome::refused("There is no number " + count(number) + "; the last is " +
                            count(all.size()) + ".");
  }
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(number) - 1);
  return {};
}

void add_measurement_commands(Commands& commands, ViewState& s, const Calls& ask) {
  static constexpr NumberRule kNumberRule{"The number", 1, double(kMostMeasurements), "", true};
  const auto none = [&s] {
    return s.settings.annotations.measurements.empty() ? "Nothing is measured." : "";
  };
  commands.add({.id = "measure.atoms",
                .title = "Measure distance or angle",
                .help = "Measures the distance of two selected atoms, the angle of three at "
                        "the second, or the dihedral angle of four, in the order of selection",
                .shortcuts = {{"D"}},
                .menu = "Tools",
                .line_above = true,
                .parameters = {{.name = "atoms",
                                .help = "Addresses of two to four atoms, with semicolons "
                                        "between them; if left out, the selection",
                                .example = "A:HIS 87:NE2; A:HEM 142:FE",
                                .optional = true}},
                .why_not = without_picture(s),
                .run = [&s](const Arguments& arguments) { return measure_atoms(s, arguments); }});
  commands.add(
      {.id = "measure.remove",
       .title = "Remove distance or angle…",
       .help = "Removes one measured distance or angle",
       .parameters = {{.name = "number",
                       .kind = Kind::number,
                       .help = "Its number in the list of the page Details",
                       .rule = kNumberRule}},
       .why_not = none,
       .run = [&s](const Arguments& arguments) { return remove_measurement(s, arguments); }});
  commands.add({.id = "measure.remove_all",
                .title = "Remove all distances and angles",
                .help = "Removes all measured distances and angles",
                .menu = "Tools",
                .why_not = none,
                .run = [&s](const Arguments&) {
                  s.settings.annotations.measurements.clear();
                  return Outcome();
                }});
  commands.add({.id = "measure.copy",
                .title = "Copy distances and angles",
                .help = "Copies the measured distances and angles as CSV, with all digits",
                .menu = "Tools",
                .why_not =
                    [&s, none] {
                      const std::string reason = none();
                      return reason.empty() ? without_picture(s)() : reason;
                    },
                .run =
                    [&s, ask](const Arguments&) {
                      ask.files.copy(measurements_csv(s.references->molecule(),
                                                      s.settings.annotations.measurements));
                      s.notice = "Copied " + count(s.settings.annotations.measurements.size()) +
                                 " distances and angles";
                      return Outcome();
                    }});
}

// --- marks at places

Parameter coordinate(const char* name, const char* help, const char* example) {
  return {.name = name, .kind = Kind::number, .help = help, .example = example, .rule = kPlaceRule};
}

std::array<double, 3> place(const Arguments& arguments, const char* x, const char* y,
                            const char* z) {
  return {arguments.number(x), arguments.number(y), arguments.number(z)};
}

Outcome add_mark(ViewState& s, PlacedMark mark) {
  PlacedMarks& all = s.settings.annotations.marks;
  if (mark.text.size() > kLongestMarkText) {
    return Outcome::refused("The words are longer than " + count(kLongestMarkText) + " bytes.");
  }
  if (all.size() == kMostMarks) {
    return Outcome::refused("At most " + count(kMostMarks) + " marks are kept. Remove some first.");
  }
  all.push_back(std::move(mark));
  return {};
}

std::string why_no_diagram(const ViewState& s) {
  if (std::string why = without_picture(s)(); !why.empty()) return why;
  const std::size_t balls = s.references->prepared().balls->size();
  if (balls <= kMostBallsOfDiagram) return {};
  return "The power diagram is drawn for up to " + count(kMostBallsOfDiagram) +
         " balls; here are " + count(balls) + ".";
}

void add_mark_commands(Commands& commands, ViewState& s) {
  const Parameter x = coordinate("x", "The x of the point", "3"),
                  y = coordinate("y", "The y of the point", "0"),
                  z = coordinate("z", "The z of the point", "0");
  const Parameter words{
      .name = "words", .help = "Text beside it", .example = "5 Å²", .optional = true};
  const std::vector<Parameter> ends{x,
                                    y,
                                    z,
                                    coordinate("to_x", "The x of the other end", "1.5"),
                                    coordinate("to_y", "The y of the other end", "2"),
                                    coordinate("to_z", "The z of the other end", "0")};
  std::vector<Parameter> point{x, y, z, words}, line = ends;
  line.push_back(words);
  commands.add({.id = "mark.point",
                .title = "Mark a point…",
                .help = "Draws a small cross at a place in Å, over everything else",
                .menu = "Edit",
                .line_above = true,
                .parameters = point,
                .why_not = without_picture(s),
                .run = [&s](const Arguments& a) {
                  const auto at = place(a, "x", "y", "z");
                  return add_mark(s, {at, at, a.text("words")});
                }});
  commands.add({.id = "mark.line",
                .title = "Mark a line…",
                .help = "Draws a line from a place to another, in Å, over everything else",
                .menu = "Edit",
                .parameters = line,
                .why_not = without_picture(s),
                .run = [&s](const Arguments& a) {
                  return add_mark(s, {place(a, "x", "y", "z"), place(a, "to_x", "to_y", "to_z"),
                                      a.text("words")});
                }});
  commands.add(
      {.id = "mark.remove_all",
       .title = "Remove all marks",
       .help = "Removes all marked points and lines",
       .menu = "Edit",
       .why_not = [&s] { return s.settings.annotations.marks.empty() ? "There is no mark." : ""; },
       .run =
           [&s](const Arguments&) {
             s.settings.annotations.marks.clear();
             return Outcome();
           }});
  CommandSpec diagram = with_switch(
      {.id = "view.power_diagram",
       .title = "Power diagram",
       .help = "Draws the borders between the cells of the balls, cut at a box around them"},
      s.settings.annotations.power_diagram);
  diagram.menu = "View";
  diagram.why_not = [&s] { return why_no_diagram(s); };
  commands.add(std::move(diagram));
}

void add_details_command(Commands& commands, ViewState& s) {
  commands.add({.id = "details.show",
                .title = "Details of the selection",
                .help = "Shows facts on the selected atom or simplex, and the measured "
                        "distances and angles",
                .shortcuts = {{"Shift+D"}},
                .menu = "Tools",
                .why_not = without_molecule(s),
                .run = [&s](const Arguments&) {
                  s.window.page = "details";
                  return Outcome();
                }});
}

}  // namespace

Outcome add_measurement(ViewState& s, const Measurement& m) {
  Measurements& all = s.settings.annotations.measurements;
  const auto same = std::find(all.begin(), all.end(), m);
  if (same != all.end()) {
    return Outcome::refused("This is measured already, as number " +
                            count(static_cast<std::size_t>(same - all.begin()) + 1) + ".");
  }
  if (all.size() == kMostMeasurements) {
    return Outcome::refused("At most " + count(kMostMeasurements) +
                            " distances and angles are kept. Remove some first.");
  }
  all.push_back(m);
  s.notice = measurement_text(s.references->molecule(), m);
  return {};
}

void add_annotation_commands(Commands& commands, ViewState& s, const Calls& ask) {
  add_label_commands(commands, s);
  add_measurement_commands(commands, s, ask);
  add_mark_commands(commands, s);
  add_details_command(commands, s);
}

}  // namespace alphascope
