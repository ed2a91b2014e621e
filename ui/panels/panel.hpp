// SPDX-License-Identifier: GPL-3.0-or-later
// The interface of a panel: a section, a page or a column of the window. A panel owns what it
// remembers between frames.
#pragma once

#include <memory>
#include <utility>

namespace alphascope {

class Commands;
struct PanelContext;
struct ViewState;

class Panel {
 public:
  virtual ~Panel() = default;
  virtual void draw(PanelContext& ctx) = 0;
  // Adds the panel's own commands. They act on the state and on the panel's own memory.
  virtual void add_commands(Commands&, ViewState&) {}
};

// A panel that is one function and owns a Memory.
template <class Memory>
class RememberingPanel final : public Panel {
 public:
  using Draw = void (*)(PanelContext&, Memory&);
  using AddCommands = void (*)(Commands&, ViewState&, Memory&);
  explicit RememberingPanel(Draw function, AddCommands adding)
      : draw_(function), add_commands_(adding) {}
  void draw(PanelContext& ctx) override { draw_(ctx, memory_); }
  void add_commands(Commands& commands, ViewState& state) override {
    if (add_commands_ != nullptr) add_commands_(commands, state, memory_);
  }
  Memory& memory() { return memory_; }

 private:
  Draw draw_;
  AddCommands add_commands_;
  Memory memory_;
};

// `add_commands` adds the panel's own commands; null: it has none.
template <class Memory>
std::unique_ptr<Panel> panel_of(void (*draw)(PanelContext&, Memory&),
                                void (*add_commands)(Commands&, ViewState&, Memory&) = nullptr) {
  return std::make_unique<RememberingPanel<Memory>>(draw, add_commands);
}

// A panel that is one function and remembers nothing.
class PlainPanel final : public Panel {
 public:
  using Draw = void (*)(PanelContext&);
  explicit PlainPanel(Draw function) : draw_(function) {}
  void draw(PanelContext& ctx) override { draw_(ctx); }

 private:
  Draw draw_;
};

inline std::unique_ptr<Panel> panel_of(PlainPanel::Draw draw) {
  return std::make_unique<PlainPanel>(draw);
}

}  // namespace alphascope
