// SPDX-License-Identifier: GPL-3.0-or-later
// Writes scripts that show a complex in other programs.
#include "core/write/complex_script.hpp"

#include <algorithm>
#include <cctype>

#include "core/write/script_words.hpp"

namespace alphascope {
namespace {

std::string scale_text() {
  std::string text = std::to_string(kScriptBallScale);
  while (text.back() == '0') text.pop_back();
  return text;
}

// Returns whether the text is a name without quotes in all of these languages.
bool is_word(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0;
  });
}

}  // namespace

std::string chimerax_complex_script(const ComplexScript& script) {
  std::string text = script_comments(script.header) + "open " + chimerax_name(script.balls) +
                     " format pqr id 1\nhide #1 cartoons\nshow #1 atoms\nstyle #1 ball\nsize #1 "
                     "ballScale " +
                     scale_text() + "\n";
  for (const auto& [name, colour] : script.groups) {
    if (!is_word(name)) continue;
    text += "color #1" + (script.by_chain ? "/" + name : " & " + name) + " " +
            hex_colour(colour, "#") + "\n";
  }
  return text + "open " + chimerax_name(script.boundary) + " id 2\nview\n";
}

std::string pymol_complex_script(const ComplexScript& script) {
  // Inside "python" a comment reaches to the end of its line, even with a semicolon in it.
  std::string text = "python\n" + script_comments(script.header) +
                     "import os\nfrom pymol import cgo, cmd\n" + pymol_load(script.balls, "balls") +
                     // PyMOL reads the radii of a PQR file as electrostatic radii.
                     "cmd.alter('balls', 'vdw=elec_radius')\ncmd.rebuild()\n"
                     "cmd.hide('everything', 'balls')\ncmd.show('spheres', 'balls')\n"
                     "cmd.set('sphere_scale', " +
                     scale_text() + ", 'balls')\n";
  for (const auto& [name, colour] : script.groups) {
    if (!is_word(name)) continue;
    text += "cmd.color('" + hex_colour(colour, "0x") + "', 'balls and " +
            (script.by_chain ? "chain " : "elem ") + name + "')\n";
  }
  return text + "points, colours, mesh = [], [], [cgo.BEGIN, cgo.TRIANGLES]\nwith open(" +
         python_name(script.boundary) +
         ", encoding='utf-8') as lines:\n"
         "    for line in lines:\n"
         "        words = line.split()\n"
         "        if words[:1] == ['v']:\n"
         "            points.append([float(w) for w in words[1:4]])\n"
         "            colours.append([float(w) for w in words[4:7]])\n"
         "        elif words[:1] == ['f']:\n"
         "            corners = [int(w) - 1 for w in words[1:4]]\n"
         "            a, b, c = (points[n] for n in corners)\n"
         "            u = [b[k] - a[k] for k in range(3)]\n"
         "            v = [c[k] - a[k] for k in range(3)]\n"
         "            n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],\n"
         "                 u[0] * v[1] - u[1] * v[0]]\n"
         "            size = sum(x * x for x in n) ** 0.5 or 1.0\n"
         "            mesh += [cgo.NORMAL] + [x / size for x in n]\n"
         "            for n in corners:\n"
         "                mesh += [cgo.COLOR] + colours[n] + [cgo.VERTEX] + points[n]\n"
         "cmd.load_cgo(mesh + [cgo.END], 'boundary')\n"
         "cmd.zoom('balls')\npython end\n";
}

std::string vmd_complex_script(const ComplexScript& script) {
  return script_comments(script.header) + "mol new " + tcl_name(script.balls) +
         " type pqr waitfor all\nmol modstyle 0 top VDW " + scale_text() +
         " 12\nmol modcolor 0 top " + (script.by_chain ? "Chain" : "Element") +
         "\nset points [list]\nset file [open " + tcl_name(script.boundary) +
         " r]\n"
         "draw color silver\n"
         "draw material Opaque\n"
         "while {[gets $file line] >= 0} {\n"
         "  set words [split $line]\n"
         "  switch -- [lindex $words 0] {\n"
         "    v {lappend points [lrange $words 1 3]}\n"
         "    f {\n"
         "      draw triangle [lindex $points [expr {[lindex $words 1] - 1}]] \\\n"
         "        [lindex $points [expr {[lindex $words 2] - 1}]] \\\n"
         "        [lindex $points [expr {[lindex $words 3] - 1}]]\n"
         "    }\n"
         "  }\n"
         "}\n"
         "close $file\ndisplay resetview\n";
}

}  // namespace alphascope
