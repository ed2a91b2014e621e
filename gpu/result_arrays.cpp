#include "gpu/result_arrays.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace alphascope::gpu {
namespace {

// Bytes to be written: copied, or all the same where there is nothing to copy from.
struct Piece {
  unsigned char* to;
  const void* from;
  int value;
  std::size_t bytes;
};

// Small enough that all threads are busy to the end.
constexpr std::size_t kPieceBytes = std::size_t{1} << 18;

class Pieces {
 public:
  template <class T>
  void copy(std::span<const T> from, ResultArray<T>& to) {
    to.resize(from.size());
    add(to.data(), from.data(), 0, from.size() * sizeof(T));
  }
  void fill(SimplexClass with, std::size_t count, ResultArray<SimplexClass>& to) {
    to.resize(count);
    add(to.data(), nullptr, static_cast<int>(with), count);
  }
  void write() const {
    tbb::parallel_for(std::size_t{0}, pieces_.size(), [&](std::size_t n) {
      const Piece& p = pieces_[n];
      p.from != nullptr ? std::memcpy(p.to, p.from, p.bytes) : std::memset(p.to, p.value, p.bytes);
    });
  }

 private:
  void add(void* to, const void* from, int value, std::size_t bytes) {
    for (std::size_t at = 0; at < bytes; at += kPieceBytes) {
      pieces_.push_back({static_cast<unsigned char*>(to) + at,
                         from != nullptr ? static_cast<const unsigned char*>(from) + at : nullptr,
                         value, std::min(kPieceBytes, bytes - at)});
    }
  }
  std::vector<Piece> pieces_;
};

template <int N>
void add(const HostSimplices<N>& from, SimplexList<N>& to, Pieces& pieces) {
  pieces.copy(from.simplices, to.simplices);
  pieces.copy(from.values, to.alpha_values);
  if (N == 4) {  // no coface: all of K_alpha's are interior
    pieces.fill(SimplexClass::interior, from.values.size(), to.classes);
  } else {
    pieces.copy(from.classes, to.classes);
  }
}

}  // namespace

void copy_result(const PipelineResult& from, AlphaComplex& to) {
  Pieces pieces;
  add(from.vertices, to.vertices, pieces);
  add(from.edges, to.edges, pieces);
  add(from.triangles, to.triangles, pieces);
  add(from.tetrahedra, to.tetrahedra, pieces);
  pieces.write();
}

}  // namespace alphascope::gpu
