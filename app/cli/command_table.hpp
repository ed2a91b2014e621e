// The options of every command, and the variables that they set.
#pragma once

#include "app/cli/commands.hpp"
#include "app/cli/commands/steps.hpp"
#include "app/options/option_table.hpp"

namespace alphascope::cli {

struct CommandOptions {
  Verbosity verbosity = Verbosity::normal;
  bool times = true;  // false: --no-times
  InfoOptions info;
  ComputeOptions compute;
  CavitiesOptions cavities;
  ChannelOptions channel;
  MeasureCommandOptions measure;
  ExportOptions export_complex;
  ExplainOptions explain;
  StepsOptions steps;
  VerifyOptions verify;
  BenchOptions bench;
  ScreenshotCommandOptions screenshot;
  FramesCommandOptions frames;
};

// The table sets `options`, which must outlive it.
OptionProgram command_table(CommandOptions& options);

}  // namespace alphascope::cli
