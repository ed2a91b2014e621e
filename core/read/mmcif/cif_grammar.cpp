// SPDX-License-Identifier: GPL-3.0-or-later
// Runs gemmi's grammar with our own actions, so no document with a string per value is built.
#include "core/read/mmcif/cif_grammar.hpp"

#include <gemmi/cif.hpp>

namespace alphascope {
namespace {

namespace rules = gemmi::cif::rules;
namespace pegtl = tao::pegtl;

template <typename Input>
std::string_view matched(const Input& in) {
  return {in.begin(), in.size()};
}

template <typename Rule>
struct Action : pegtl::nothing<Rule> {};

template <>
struct Action<rules::datablockname> {
  template <typename Input>
  static void apply(const Input&, CifHandler& handler) {
    handler.begin_block();
  }
};
template <>
struct Action<rules::str_loop> {
  template <typename Input>
  static void apply(const Input&, CifHandler& handler) {
    handler.begin_loop();
  }
};
template <>
struct Action<rules::loop_tag> {
  template <typename Input>
  static void apply(const Input& in, CifHandler& handler) {
    handler.loop_tag(matched(in));
  }
};
template <>
struct Action<rules::loop_value> {
  template <typename Input>
  static void apply(const Input& in, CifHandler& handler) {
    handler.loop_value(matched(in), in.iterator().line);
  }
};
template <>
struct Action<rules::loop> {
  template <typename Input>
  static void apply(const Input&, CifHandler& handler) {
    handler.end_loop();
  }
};
template <>
struct Action<rules::item_tag> {
  template <typename Input>
  static void apply(const Input& in, CifHandler& handler) {
    handler.item_tag(matched(in));
  }
};
template <>
struct Action<rules::item_value> {
  template <typename Input>
  static void apply(const Input& in, CifHandler& handler) {
    handler.item_value(matched(in), in.iterator().line);
  }
};

}  // namespace

void parse_cif(std::string_view text, CifHandler& handler) {
  pegtl::memory_input<> in(text.data(), text.size(), "");
  try {
    pegtl::parse<rules::file, Action, gemmi::cif::Errors>(in, handler);
  } catch (const pegtl::parse_error& error) {
    throw CifSyntaxError(error.positions().front().line, std::string(error.message()));
  }
}

}  // namespace alphascope
