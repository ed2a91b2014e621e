// SPDX-License-Identifier: GPL-3.0-or-later
// Writes settings as JSON: FieldWriter of json_fields.hpp.
#include <charconv>

#include "core/document/session/json_fields.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/text/printable.hpp"

namespace alphascope {
namespace {

std::string hexadecimal(const std::string& bytes) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    text += {kDigits[byte >> 4], kDigits[byte & 15]};
  }
  return text;
}

WrittenJson atom_json(const AtomRef& atom) {
  if (atom.copy == 0) return atom.atom;
  return {atom.atom, atom.copy};
}

}  // namespace

void FieldWriter::operator()(const char* name, float value, const NumberRule&) {
  char text[32];  // the shortest decimal of this float: 0.3, not 0.30000001192092896
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  double shortest = value;
  std::from_chars(text, end, shortest);
  to_[name] = shortest;
}

void FieldWriter::operator()(const char* name, const std::string& value) {
  to_[name] = text_json(value);
}

void FieldWriter::operator()(const char* name, const std::vector<std::string>& value) {
  WrittenJson& list = to_[name] = WrittenJson::array();
  for (const std::string& text : value) list.push_back(text_json(text));
}

void FieldWriter::operator()(const char* name, const std::filesystem::path& value) {
  to_[name] = text_json(value.string());
}

void FieldWriter::operator()(const char* name, const std::vector<std::filesystem::path>& value) {
  WrittenJson& list = to_[name] = WrittenJson::array();
  for (const std::filesystem::path& path : value) list.push_back(text_json(path.string()));
}

void FieldWriter::operator()(const char* name, const std::vector<RadiusOverride>& value) {
  WrittenJson& list = to_[name] = WrittenJson::array();
  for (const RadiusOverride& edit : value) {
    list.push_back({{"residue", text_json(edit.atoms.residue)},
                    {"atom", text_json(edit.atoms.atom)},
                    {"element", element_symbol(edit.atoms.element)},
                    {"radius_angstrom", edit.microangstrom / 1e6}});
  }
}

// An atom is its index in the file (from 0), or a pair of index and copy. A simplex is a list of
// its corners.
void FieldWriter::operator()(const char* name, const RefSet& value) {
  WrittenJson& list = to_[name] = WrittenJson::array();
  for (const Ref& ref : value.items()) {
    WrittenJson item = WrittenJson::array();
    if (const AtomRef* atom = std::get_if<AtomRef>(&ref)) {
      item.push_back(atom_json(*atom));
    } else {
      for (const AtomRef& corner : std::get<SimplexRef>(ref)) item.push_back(atom_json(corner));
    }
    list.push_back(std::move(item));
  }
}

// Runs of atoms: [first, last]; in an assembly [first, last, copy].
void FieldWriter::operator()(const char* name, const AtomSet& value) {
  WrittenJson& list = to_[name] = WrittenJson::array();
  for (const AtomSet::Run& run : value.runs()) {
    WrittenJson item{run.first, run.last};
    if (run.copy != 0) item.push_back(run.copy);
    list.push_back(std::move(item));
  }
}

void FieldWriter::operator()(const char* name, const std::vector<AtomRef>& value) {
  WrittenJson& list = to_[name] = WrittenJson::array();
  for (const AtomRef& atom : value) list.push_back(atom_json(atom));
}

void FieldWriter::operator()(const char* name, const Rgb8& value) {
  to_[name] = colour_text(value);
}

void FieldWriter::operator()(const char* name, const PictureBackground& value) {
  to_[name] = background_text(value);
}

void FieldWriter::operator()(const char* name, const FileReference& value) {
  if (value.empty()) return;
  WrittenJson& to = to_[name] = WrittenJson::object();
  if (!value.relative.empty()) to["path"] = text_json(value.relative.string());
  to["absolute_path"] = text_json(value.absolute.string());
  to["sha256"] = value.sha256;
}

void FieldWriter::operator()(const char* name, const Clip& value) {
  to_[name] = clip_text(value);
}

void FieldWriter::operator()(const char* name, const Paint& value, PaintTarget) {
  to_[name] = paint_text(value);
}

void FieldWriter::model(const char* name, int index) {
  to_[name] = index == kAllModels ? WrittenJson("joined") : WrittenJson(index + 1);
}

WrittenJson text_json(const std::string& text) {
  WrittenJson json(text);
  try {
    static_cast<void>(json.dump());
  } catch (const WrittenJson::type_error&) {  // names of files and chains may be any bytes
    return {{"bytes", hexadecimal(text)}};
  }
  return json;
}

std::string json_file_text(const WrittenJson& json) {
  return printable_json(json.dump(2)) + "\n";
}

}  // namespace alphascope
