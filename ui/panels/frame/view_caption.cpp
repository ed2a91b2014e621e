// SPDX-License-Identifier: GPL-3.0-or-later
// The caption over the 3-D view: the complex on screen, and the pending one.
#include <string>

#include "core/document/explain/dimension_words.hpp"
#include "core/document/picture/caption_parts.hpp"
#include "core/document/store/answer.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/predicates/spanning_balls.hpp"
#include "ui/caption.hpp"
#include "ui/panels/frame/view_marks.hpp"
#include "ui/panels/frame/view_parts.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/running_job.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {

void draw_view_caption(PanelContext& ctx, ImVec2 corner, ImVec2 size) {
  if (!ctx.state.result) return;
  const ViewState& s = ctx.state;
  const std::string text = caption_text(*s.result);
  // At the right there must be room for progress.
  const float room = size.x - ctx.px(s.jobs.empty() ? 32 : 260);
  ImVec2 place{corner.x + ctx.px(16), corner.y + ctx.px(14)};
  for (const std::string& line : {text, s.pending}) {
    const std::string fitted = fitted_text(line, room);
    draw_rim(ctx, place, fitted);
    ImGui::GetWindowDrawList()->AddText(place, to_u32(ctx.palette.text_muted), fitted.c_str());
    place.y += ImGui::GetTextLineHeightWithSpacing();
  }
}

std::string caption_text(const Answer& answer) {
  CaptionParts parts = usual_caption();
  parts.set(CaptionPart::counts, false);  // counts are in the status bar
  const AlphaComplex& c = answer.complex;
  std::string text;
  for (const std::string& word : caption_words(answer, *answer.molecule, {}, parts)) {
    text += (text.empty() ? "" : kCaptionGap) + word;
  }
  if (c.tetrahedra.size() > 0 || answer.balls->size() == 0) return text;
  if (!c.tetrahedra_only && c.vertices.size() == 0) {
    return text + "   no ball is left at this alpha";
  }
  const int dimension = dimension_of_centres(*answer.balls);
  if (dimension == 3) return text + "   no tetrahedra at this alpha";
  return text + "   balls " + lie_text(dimension);  // so there are none at any alpha
}

}  // namespace alphascope
