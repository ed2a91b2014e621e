// SPDX-License-Identifier: GPL-3.0-or-later
// The sieve, compiled once for each kind of processor (Highway).
#include "core/dual_edge/cut_sieve.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/dual_edge/cut_sieve.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace alphascope::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<double, LiftedColumns::kRoom> kReals;
using Reals = hn::Vec<decltype(kReals)>;

// The edge in each lane of vectors.
struct EdgeVectors {
  HWY_ATTR explicit EdgeVectors(const SievedEdge& edge)
      : nx(hn::Set(kReals, edge.direction.x)),
        ny(hn::Set(kReals, edge.direction.y)),
        nz(hn::Set(kReals, edge.direction.z)),
        fx(hn::Set(kReals, edge.foot.x)),
        fy(hn::Set(kReals, edge.foot.y)),
        fz(hn::Set(kReals, edge.foot.z)),
        slope_error(hn::Set(kReals, edge.slope_error)),
        offset_error(hn::Set(kReals, edge.offset_error)),
        reach(hn::Set(kReals, edge.reach)) {}
  Reals nx, ny, nz, fx, fy, fz, slope_error, offset_error, reach;
};

// As PowerLine<double>::Cut, with the same bits.
struct CutVectors {
  Reals slope, offset, slope_error, offset_error;
};

HWY_INLINE HWY_ATTR CutVectors cuts_by(const EdgeVectors& e, const LiftedColumns& balls,
                                       std::size_t at) {
  constexpr double kU = Rounding<double>::u;
  const Reals x = hn::LoadU(kReals, balls.x.data() + at),
              y = hn::LoadU(kReals, balls.y.data() + at),
              z = hn::LoadU(kReals, balls.z.data() + at),
              c = hn::LoadU(kReals, balls.c.data() + at);
  const Reals length = hn::Add(hn::Add(hn::Abs(x), hn::Abs(y)), hn::Abs(z));
  const Reals half = hn::Mul(hn::Set(kReals, 0.5), c);
  return {hn::Add(hn::Mul(x, e.nx), hn::Add(hn::Mul(y, e.ny), hn::Mul(z, e.nz))),
          hn::Sub(hn::Sub(hn::Sub(half, hn::Mul(z, e.fz)), hn::Mul(y, e.fy)), hn::Mul(x, e.fx)),
          hn::Mul(length, e.slope_error),
          hn::Add(hn::Mul(hn::Set(kReals, 2.6 * kU), hn::Abs(c)), hn::Mul(length, e.offset_error))};
}

template <class Mask>
HWY_INLINE HWY_ATTR std::uint32_t bits_of(Mask mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(kReals, mask, bits);
  return bits[0];
}

HWY_ATTR bool sieve(const SievedEdge& edge, const LiftedColumns& balls, std::uint32_t* bits,
                    int words) {
  constexpr std::size_t kBits = 32;
  const std::size_t lanes = hn::Lanes(kReals), all = kBits * static_cast<std::size_t>(words);
  const std::uint32_t every_lane = (std::uint32_t{1} << lanes) - 1;
  const EdgeVectors e(edge);
  for (std::size_t at = 0; at < all; at += lanes) {
    std::uint32_t& word = bits[at / kBits];
    const std::size_t bit = at % kBits;
    const std::uint32_t asked = word >> bit & every_lane;
    if (asked == 0) continue;
    const CutVectors cut = cuts_by(e, balls, at);
    // The operations and their order are those of DualEdge<double>::takes().
    const Reals farthest =
        hn::Add(hn::Mul(hn::Add(hn::Abs(cut.slope), cut.slope_error), e.reach), cut.offset_error);
    if ((bits_of(hn::Lt(cut.offset, hn::Neg(farthest))) & asked) != 0) return true;
    word &= ~((bits_of(hn::Gt(cut.offset, farthest)) & asked) << bit);
  }
  return false;
}

}  // namespace
}  // namespace alphascope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace alphascope {

HWY_EXPORT(sieve);

bool sieve_cuts(const SievedEdge& edge, const LiftedColumns& balls, std::uint32_t* bits,
                int words) {
  return HWY_DYNAMIC_DISPATCH(sieve)(edge, balls, bits, words);
}

}  // namespace alphascope
#endif
