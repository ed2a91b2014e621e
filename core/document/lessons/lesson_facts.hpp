// What a lesson may say of the complex on screen without writing a number down: {tetrahedra},
// {n edges}, {alpha}. The facts are the program's own, so a text cannot be wrong about them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "core/cavity/cavity_table.hpp"
#include "core/document/measures/measure_results.hpp"
#include "core/document/store/answer.hpp"
#include "core/triangulation/filtration.hpp"

namespace alphascope {

// All of the complex on screen. What takes work is asked for only when a text mentions it; the
// functions may be empty, and give null for what is not there yet.
struct LessonFacts {
  std::shared_ptr<const Answer> shown;  // null: none
  std::function<std::shared_ptr<const Filtration>()> all;
  std::function<std::shared_ptr<const MeasuredComplex>()> measured;
  std::function<std::shared_ptr<const CavityTable>()> cavities;
};

// "tetrahedra", "n tetrahedra", "grown #1", "value #1 #2".
bool is_lesson_fact(std::string_view name);
std::string lesson_fact_names();  // for people: "alpha, solvent, …"

// The text with each {fact} replaced; "…" stands for what is not known yet. A dimension that a flat
// set does not have counts as none.
std::string with_facts(std::string_view text, const LessonFacts& facts);
// Whether there would be no "…".
bool has_all_facts(std::string_view text, const LessonFacts& facts);

}  // namespace alphascope
