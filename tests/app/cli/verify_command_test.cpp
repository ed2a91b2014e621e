// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the exit code of `verify`, on which calling programs rely, with engines that are wrong on
// purpose.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include "app/cli/commands/verify.hpp"
#include "core/engine/engine.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope::cli {
namespace {

using Damage = std::function<void(AlphaComplex&)>;

// An engine that damages the answer of CGAL's engine.
class DamagedEngine : public Engine {
 public:
  DamagedEngine(std::shared_ptr<const BallSet> balls, Damage damage)
      : engine_(make_cgal_engine(std::move(balls), {1})), damage_(std::move(damage)) {}
  AlphaComplex compute(const AlphaRequest& request, KnownResults& known,
                       const RunContext& context) override {
    AlphaComplex complex = engine_->compute(request, known, context);
    complex.engine.rests_on_cgal = false;
    damage_(complex);
    return complex;
  }

 private:
  std::unique_ptr<Engine> engine_;
  Damage damage_;
};

class VerifyCommand : public ::testing::Test {
 protected:
  VerifyCommand() {
    file_ = std::filesystem::temp_directory_path() /
            (std::string("alphascope_verify_") +
             ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".xyzr");
    std::ofstream(file_) << "0 0 0 1\n1 0 0 1\n0 1 0 1\n0 0 1 1\n9 9 9 1\n";
  }
  ~VerifyCommand() override { std::filesystem::remove(file_); }

  // `of_both`: CGAL's answer is damaged in the same way.
  ExitCode code(const Damage& damage, bool of_both, bool definition) const {
    VerifyOptions options;
    options.input.file = file_.string();
    options.request.engine = EngineChoice::cpu;
    options.alphas = {0.5};
    options.definition = definition;
    return run_verify(options, [&](EngineChoice choice, std::shared_ptr<const BallSet> balls,
                                   const EngineSettings&) {
      const bool damaged = of_both || choice != EngineChoice::cgal;
      return MadeEngine{std::make_unique<DamagedEngine>(
                            std::move(balls), damaged ? damage : Damage([](AlphaComplex&) {})),
                        ""};
    });
  }

  std::filesystem::path file_;
};

void with_a_wrong_class(AlphaComplex& complex) {
  complex.edges.classes[0] = SimplexClass::singular;
}

TEST_F(VerifyCommand, IsOkWhereNothingIsWrong) {
  const auto nothing = [](AlphaComplex&) {};
  EXPECT_EQ(code(nothing, false, false), ExitCode::ok);
  EXPECT_EQ(code(nothing, false, true), ExitCode::ok);
}

TEST_F(VerifyCommand, DiffersWhereTheEnginesDo) {
  EXPECT_EQ(code(with_a_wrong_class, false, false), ExitCode::differs);
}

// Both engines agree, and only the definition shows the fault.
TEST_F(VerifyCommand, DiffersWhereOnlyTheDefinitionFails) {
  EXPECT_EQ(code(with_a_wrong_class, true, false), ExitCode::ok);
  EXPECT_EQ(code(with_a_wrong_class, true, true), ExitCode::differs);
}

// Where both engines rest on CGAL's triangulation, the definition is checked by default.
TEST_F(VerifyCommand, AsksTheDefinitionWhereBothRestOnCgal) {
  const auto wrong_both = [](AlphaComplex& complex) {
    with_a_wrong_class(complex);
    complex.engine.rests_on_cgal = true;
  };
  EXPECT_EQ(code(wrong_both, true, false), ExitCode::differs);
}

}  // namespace
}  // namespace alphascope::cli
