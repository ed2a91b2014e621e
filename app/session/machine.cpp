#include "app/session/machine.hpp"

#include <algorithm>
#include <fstream>
#include <thread>

#ifdef ALPHASCOPE_HAS_GPU
#include "gpu/gpu_engine.hpp"
#endif

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

void look_for_gpu(MachineInfo& machine) {
#ifdef ALPHASCOPE_HAS_GPU
  const GpuDevice& device = gpu_device();
  machine.gpu_usable = device.usable;
  machine.gpu = device.name;
  machine.driver = device.driver;
  machine.gpu_memory_bytes = device.memory_bytes;
  machine.gpu_why_not = device.usable ? "" : device.why_not;
  if (device.compute_capability > 0) {
    machine.gpu_capability = std::to_string(device.compute_capability / 10) + "." +
                             std::to_string(device.compute_capability % 10);
  }
#else
  machine.gpu_why_not = "This build has no GPU engine. The CPU engine gives the same results.";
#endif
}

}  // namespace

const MachineInfo& machine_info() {
  static const MachineInfo machine = [] {
    MachineInfo m;
    m.cpu = cpu_model();
    m.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    look_for_gpu(m);
    return m;
  }();
  return machine;
}

std::string machine_text(const MachineInfo& machine) {
  std::string text = machine.cpu + ", " + std::to_string(machine.threads) +
                     (machine.threads == 1 ? " thread" : " threads");
  if (machine.gpu_usable) text += "; " + machine.gpu + ", " + machine.driver;
  return text;
}

}  // namespace alphascope
