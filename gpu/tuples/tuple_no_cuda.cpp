// Replaces the CUDA tuple engine in builds without a CUDA compiler.
#include "gpu/gpu_engine.hpp"
#include "gpu/tuples/tuple_engine.hpp"

namespace alphascope {

std::unique_ptr<Engine> make_gpu_tuple_engine(std::shared_ptr<const BallSet>, TupleOptions,
                                              std::string* why_not) {
  if (why_not != nullptr) *why_not = gpu_device().why_not;
  return nullptr;
}

}  // namespace alphascope
