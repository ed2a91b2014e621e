// SPDX-License-Identifier: GPL-3.0-or-later
// Signed integers of fixed width beyond 64 bits, for exact predicates on host and device. They have
// only sums, products, signs, shifts and an approximate double. Overflow wraps. The widths are
// proven sufficient where they are chosen (exact_rho.hpp, exact_dual_edge.hpp).
#pragma once

#include <cstdint>

#include "core/geometry/host_device.hpp"
#include "core/geometry/int128.hpp"

namespace alphascope {

// Two's complement, least significant limb first.
template <int kLimbs>
struct WideInt {
  std::uint64_t limb[kLimbs];

  WideInt() = default;
  ALPHASCOPE_HOST_DEVICE constexpr WideInt(std::int64_t value) : limb{} {
    limb[0] = static_cast<std::uint64_t>(value);
    for (int i = 1; i < kLimbs; ++i) limb[i] = value < 0 ? ~std::uint64_t{0} : 0;
  }
  ALPHASCOPE_HOST_DEVICE static WideInt of(Int128 value) {
    static_assert(kLimbs >= 2, "narrowing would lose bits");
    WideInt wide(value < 0 ? -1 : 0);
    wide.limb[0] = static_cast<std::uint64_t>(value);
    wide.limb[1] = static_cast<std::uint64_t>(value >> 64);
    return wide;
  }
  template <int kOther>
  ALPHASCOPE_HOST_DEVICE explicit WideInt(const WideInt<kOther>& other) {
    static_assert(kOther <= kLimbs, "narrowing would lose bits");
    const std::uint64_t fill = other.sign() < 0 ? ~std::uint64_t{0} : 0;
    for (int i = 0; i < kLimbs; ++i) limb[i] = i < kOther ? other.limb[i] : fill;
  }

  ALPHASCOPE_HOST_DEVICE int sign() const {
    if (limb[kLimbs - 1] >> 63) return -1;
    for (int i = 0; i < kLimbs; ++i) {
      if (limb[i] != 0) return 1;
    }
    return 0;
  }

  ALPHASCOPE_HOST_DEVICE friend WideInt operator+(const WideInt& a, const WideInt& b) {
    WideInt sum;
    UInt128 carry = 0;
    for (int i = 0; i < kLimbs; ++i) {
      carry += static_cast<UInt128>(a.limb[i]) + b.limb[i];
      sum.limb[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    return sum;
  }
  ALPHASCOPE_HOST_DEVICE friend WideInt operator-(const WideInt& a, const WideInt& b) {
    WideInt difference;
    std::uint64_t borrow = 0;
    for (int i = 0; i < kLimbs; ++i) {
      const UInt128 d = static_cast<UInt128>(a.limb[i]) - b.limb[i] - borrow;
      difference.limb[i] = static_cast<std::uint64_t>(d);
      borrow = static_cast<std::uint64_t>(d >> 64) & 1;
    }
    return difference;
  }
  ALPHASCOPE_HOST_DEVICE WideInt operator-() const { return WideInt(0) - *this; }

  // Modulo 2^(64 kLimbs). The product of two's complements is then that of the signed values.
  ALPHASCOPE_DEVICE_CALL friend WideInt operator*(const WideInt& a, const WideInt& b) {
    WideInt product(0);
    for (int i = 0; i < kLimbs; ++i) {
      std::uint64_t carry = 0;
      for (int j = 0; i + j < kLimbs; ++j) {
        const UInt128 t = static_cast<UInt128>(a.limb[i]) * b.limb[j] + product.limb[i + j] + carry;
        product.limb[i + j] = static_cast<std::uint64_t>(t);
        carry = static_cast<std::uint64_t>(t >> 64);
      }
    }
    return product;
  }

  // Modulo 2^(64 kLimbs).
  ALPHASCOPE_DEVICE_CALL WideInt times(std::int64_t factor) const {
    WideInt product;
    const std::uint64_t magnitude =
        factor < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(factor) : factor;
    UInt128 carry = 0;
    for (int i = 0; i < kLimbs; ++i) {
      carry += static_cast<UInt128>(limb[i]) * magnitude;
      product.limb[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    return factor < 0 ? -product : product;
  }

  ALPHASCOPE_DEVICE_CALL WideInt shifted_left(int bits) const {
    WideInt result(0);
    const int limbs = bits / 64, rest = bits % 64;
    for (int i = kLimbs - 1; i >= limbs; --i) {
      result.limb[i] = limb[i - limbs] << rest;
      if (rest != 0 && i > limbs) result.limb[i] |= limb[i - limbs - 1] >> (64 - rest);
    }
    return result;
  }

  // A double within one part in 2^51 of the value, with the right sign.
  ALPHASCOPE_HOST_DEVICE double near_double() const {
    const bool negative = limb[kLimbs - 1] >> 63;
    const WideInt magnitude = negative ? -*this : *this;
    int top = kLimbs - 1;
    while (top > 0 && magnitude.limb[top] == 0) --top;
    double value = static_cast<double>(magnitude.limb[top]);
    double scale = negative ? -1 : 1;
    for (int i = top; i > 0; --i) scale *= 18446744073709551616.0;
    if (top > 0) value += static_cast<double>(magnitude.limb[top - 1]) / 18446744073709551616.0;
    return value * scale;
  }
};

// value², where |value| < 2^127.
ALPHASCOPE_DEVICE_CALL WideInt<4> square_of(Int128 value) {
  const UInt128 magnitude = value < 0 ? -static_cast<UInt128>(value) : static_cast<UInt128>(value);
  const UInt128 low = static_cast<std::uint64_t>(magnitude), high = magnitude >> 64;
  const UInt128 lows = low * low, mixed = 2 * low * high, highs = high * high;
  WideInt<4> square;
  square.limb[0] = static_cast<std::uint64_t>(lows);
  UInt128 sum = (lows >> 64) + static_cast<std::uint64_t>(mixed);
  square.limb[1] = static_cast<std::uint64_t>(sum);
  sum = (sum >> 64) + (mixed >> 64) + static_cast<std::uint64_t>(highs);
  square.limb[2] = static_cast<std::uint64_t>(sum);
  square.limb[3] = static_cast<std::uint64_t>((sum >> 64) + (highs >> 64));
  return square;
}

ALPHASCOPE_HOST_DEVICE inline int sign_of(Int128 value) {
  return (value > 0) - (value < 0);
}
ALPHASCOPE_HOST_DEVICE inline int sign_of(std::int64_t value) {
  return (value > 0) - (value < 0);
}
template <int kLimbs>
ALPHASCOPE_HOST_DEVICE int sign_of(const WideInt<kLimbs>& value) {
  return value.sign();
}

}  // namespace alphascope
