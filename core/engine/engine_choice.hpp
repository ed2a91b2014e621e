// The engines by name, as every program offers them. Making one is the session's business.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace alphascope {

// automatic: the dual-edge engine, on the GPU when it can be used, else on the CPU. The tuple
// engines are the thesis' pipeline.
enum class EngineChoice : std::uint8_t { automatic, gpu, cpu, tuples_gpu, tuples_cpu, cgal };

inline constexpr std::array<EngineChoice, 6> kEngineChoices{
    EngineChoice::automatic,  EngineChoice::gpu,        EngineChoice::cpu,
    EngineChoice::tuples_gpu, EngineChoice::tuples_cpu, EngineChoice::cgal};

// "auto", "gpu", "cpu", "tuples-gpu", "tuples-cpu", "cgal": in commands and files.
std::string_view engine_id(EngineChoice choice);
std::optional<EngineChoice> engine_from_id(std::string_view id);

// "Automatic", "Dual-edge engine, GPU", …: for people.
std::string_view engine_title(EngineChoice choice);

inline bool is_tuple_engine(EngineChoice choice) {
  return choice == EngineChoice::tuples_cpu || choice == EngineChoice::tuples_gpu;
}

inline bool needs_gpu(EngineChoice choice) {
  return choice == EngineChoice::gpu || choice == EngineChoice::tuples_gpu;
}

}  // namespace alphascope
