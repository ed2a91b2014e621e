// The interface of a panel: a section, a page or a column of the window. A panel owns what it
// remembers between frames.
#pragma once

#include <memory>
#include <utility>

namespace alphascope {

struct PanelContext;

class Panel {
 public:
  virtual ~Panel() = default;
  virtual void draw(PanelContext& ctx) = 0;
};

// A panel that is one function and owns a Memory.
template <class Memory>
class RememberingPanel final : public Panel {
 public:
  using Draw = void (*)(PanelContext&, Memory&);
  explicit RememberingPanel(Draw draw) : draw_(draw) {}
  void draw(PanelContext& ctx) override { draw_(ctx, memory_); }
  Memory& memory() { return memory_; }

 private:
  Draw draw_;
  Memory memory_;
};

template <class Memory>
std::unique_ptr<Panel> panel_of(void (*draw)(PanelContext&, Memory&)) {
  return std::make_unique<RememberingPanel<Memory>>(draw);
}

// A panel that is one function and remembers nothing.
class PlainPanel final : public Panel {
 public:
  using Draw = void (*)(PanelContext&);
  explicit PlainPanel(Draw draw) : draw_(draw) {}
  void draw(PanelContext& ctx) override { draw_(ctx); }

 private:
  Draw draw_;
};

inline std::unique_ptr<Panel> panel_of(PlainPanel::Draw draw) {
  return std::make_unique<PlainPanel>(draw);
}

}  // namespace alphascope
