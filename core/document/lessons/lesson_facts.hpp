// SPDX-License-Identifier: GPL-3.0-or-later
// Facts about the complex on screen that a lesson's text names instead of giving numbers:
// {tetrahedra}, {n edges}, {alpha}. The program computes them, so the text is always right about
// them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace alphascope {

class Filtration;
struct Answer;
struct CavityTable;
struct MeasuredComplex;

// Sources of facts on the complex on screen. The functions are called only if a text mentions their
// facts. They may be empty, and return null until the result is ready.
struct LessonFacts {
  std::shared_ptr<const Answer> shown;  // null: none
  std::function<std::shared_ptr<const Filtration>()> all;
  std::function<std::shared_ptr<const MeasuredComplex>()> measured;
  std::function<std::shared_ptr<const CavityTable>()> cavities;
};

// Whether this is the name of a fact: "tetrahedra", "n tetrahedra", "grown #1", "value #1 #2".
bool is_lesson_fact(std::string_view name);
std::string lesson_fact_names();  // all names, for users: "alpha, solvent, …"

// The text with each {fact} replaced by its value; "…" if the value is not known yet. Simplices of
// a dimension that a flat set does not have are counted as none.
std::string with_facts(std::string_view text, const LessonFacts& facts);
// Whether with_facts() would return a text without "…".
bool has_all_facts(std::string_view text, const LessonFacts& facts);

}  // namespace alphascope
