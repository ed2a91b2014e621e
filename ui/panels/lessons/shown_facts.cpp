// SPDX-License-Identifier: GPL-3.0-or-later
// Asks the store for facts about the complex on screen, and fills them into the text of a lesson.
#include "ui/panels/lessons/shown_facts.hpp"

#include <functional>
#include <memory>
#include <vector>

#include "core/document/cavities/cavity_results.hpp"
#include "core/document/lessons/lesson_facts.hpp"
#include "core/document/measures/measure_results.hpp"
#include "core/document/store/derived.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "ui/panels/lessons/lesson_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

// Returns a function that asks the store for a result. It returns null if the result is not ready,
// or belongs to other balls than the picture.
template <class T>
std::function<std::shared_ptr<const T>()> wanted(PanelContext& ctx, const Definition<T>& what) {
  return [&ctx, &what]() -> std::shared_ptr<const T> {
    const auto found = ctx.store.want(what, ctx.inputs);
    const bool of_picture = ctx.inputs.balls == ctx.state.shown_balls();
    return found.ready() && of_picture ? found.value : nullptr;
  };
}

}  // namespace

LessonFacts facts_on_screen(PanelContext& ctx) {
  if (!ctx.state.lessons.ready || !ctx.state.result) return {};
  return {ctx.state.result, wanted(ctx, whole_filtration()), wanted(ctx, union_measures()),
          wanted(ctx, cavity_table())};
}

std::vector<LessonParagraph> with_facts_in(PanelContext& ctx, const LessonPart& part,
                                           const LessonFacts& facts) {
  LessonState& m = ctx.state.lessons;
  std::vector<LessonParagraph> text = part.text;
  for (LessonParagraph& p : text) {
    m.whole = m.whole && has_all_facts(p.text, facts);
    p.text = with_facts(p.text, facts);
    m.said += p.text + "\n";
  }
  m.paragraphs.insert(m.paragraphs.end(), text.begin(), text.end());
  return text;
}

}  // namespace alphascope
