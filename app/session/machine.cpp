// SPDX-License-Identifier: GPL-3.0-or-later
// Asks the system for its processor and GPU.
#include "app/session/machine.hpp"

#include <algorithm>
#include <fstream>
#include <thread>

#include "app/session/gpu_engines.hpp"

namespace alphascope {
namespace {

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(':');
    if (!line.starts_with("model name") || colon == std::string::npos) continue;
    const std::size_t start = line.find_first_not_of(" \t", colon + 1);
    if (start != std::string::npos) return line.substr(start);
  }
  return "unknown CPU";
}

}  // namespace

const MachineInfo& machine_info() {
  static const MachineInfo machine = [] {
    MachineInfo m;
    m.cpu = cpu_model();
    m.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    m.gpu = GpuEngines::of_program().device();
    return m;
  }();
  return machine;
}

std::string machine_text(const MachineInfo& machine) {
  std::string text = machine.cpu + ", " + std::to_string(machine.threads) +
                     (machine.threads == 1 ? " thread" : " threads");
  if (machine.gpu.usable) text += "; " + machine.gpu.name + ", " + machine.gpu.driver;
  return text;
}

}  // namespace alphascope
