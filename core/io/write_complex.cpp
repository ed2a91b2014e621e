#include "core/io/write_complex.hpp"

#include <algorithm>
#include <charconv>

namespace alphascope {
namespace {

constexpr std::size_t kFlushBytes = std::size_t{1} << 20;

// Collects text and hands it on in large pieces.
class Text {
 public:
  explicit Text(AtomicFile& file) : file_(file) {}

  Text& operator<<(std::string_view text) {
    text_ += text;
    return *this;
  }
  Text& operator<<(std::size_t number) {
    char buffer[24];
    text_.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr);
    return *this;
  }
  // Nine digits: alpha values are floats, which nine digits tell apart.
  Text& operator<<(double number) {
    char buffer[32];
    const auto end =
        std::to_chars(buffer, buffer + sizeof buffer, number, std::chars_format::general, 9);
    text_.append(buffer, end.ptr);
    return *this;
  }
  // A lattice number in Å, all its digits: no rounding.
  Text& lattice(std::int32_t units, int digits) {
    char buffer[32];
    const double unit = Lattice{digits}.units_per_angstrom();
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, units / unit,
                                   std::chars_format::fixed, std::max(digits, 0));
    text_.append(buffer, end.ptr);
    return *this;
  }
  void end_line() {
    text_ += '\n';
    if (text_.size() >= kFlushBytes) flush();
  }
  void flush() {
    file_.write(text_);
    text_.clear();
  }

 private:
  AtomicFile& file_;
  std::string text_;
};

const char* class_letter(SimplexClass c) {
  switch (c) {
    case SimplexClass::singular:
      return "s";
    case SimplexClass::regular:
      return "r";
    case SimplexClass::interior:
      return "i";
  }
  return "?";
}

template <int N>
void write_list(const char* name, const SimplexList<N>& list, const AlphaComplex& complex,
                Text& text) {
  text << name << " " << list.size();
  text.end_line();
  for (std::size_t s = 0; s < list.size(); ++s) {
    for (const BallIndex vertex : list.simplices[s]) text << std::size_t{vertex} << " ";
    text << complex.lattice.square_angstrom(list.alpha_values[s]);
    if (!complex.tetrahedra_only) text << " " << class_letter(list.classes[s]);
    text.end_line();
  }
}

}  // namespace

void write_complex_text(const BallSet& balls, const AlphaComplex& complex,
                        const ComplexHeader& header, AtomicFile& file, const RunContext& context) {
  Text text(file);
  text << "alphascope-complex 1";
  text.end_line();
  for (const auto& [key, value] : header) {
    text << key << " ";
    for (const char c : value) text << (c == '\n' || c == '\r' ? " " : std::string_view(&c, 1));
    text.end_line();
  }
  text << "balls " << balls.size();
  text.end_line();
  const int digits = balls.lattice.digits;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const LatticePoint& p = balls.centres[i];
    text.lattice(p.x, digits) << " ";
    text.lattice(p.y, digits) << " ";
    text.lattice(p.z, digits) << " ";
    text.lattice(balls.radii[i], digits);
    text.end_line();
  }
  const auto section = [&](const char* name, const auto& list, double share) {
    context.cancel.throw_if_cancelled();
    context.report("writing", share);
    write_list(name, list, complex, text);
  };
  section("vertices", complex.vertices, 0.1);
  section("edges", complex.edges, 0.2);
  section("triangles", complex.triangles, 0.4);
  section("tetrahedra", complex.tetrahedra, 0.8);
  text << "end";
  text.end_line();
  text.flush();
}

}  // namespace alphascope
