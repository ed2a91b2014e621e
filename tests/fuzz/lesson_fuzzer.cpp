// SPDX-License-Identifier: GPL-3.0-or-later
// Takes any bytes as a lesson. The result has at least one step and only known facts, or is a
// ReadError.
#include <cstdlib>

#include "core/document/lessons/lesson.hpp"
#include "core/document/lessons/lesson_facts.hpp"
#include "core/files/read_error.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/run/work_threads.hpp"

namespace {

void look_at(const alphascope::LessonPart& part) {
  for (const alphascope::LessonParagraph& paragraph : part.text) {
    const std::string said = alphascope::with_facts(paragraph.text, {});
    if (said.find('{') != std::string::npos) std::abort();
    alphascope::lesson_spans(said);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const alphascope::Lesson lesson = alphascope::read_lesson(text, "lesson.md");
    if (lesson.steps.empty()) std::abort();
    for (const alphascope::LessonStep& step : lesson.steps) {
      look_at(step.shown);
      look_at(step.answer);
      if (step.shown.text.empty() || lesson.molecule_of(step).empty()) std::abort();
    }
  } catch (const alphascope::ReadError&) {
  }
  return 0;
}
