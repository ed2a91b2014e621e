// SPDX-License-Identifier: GPL-3.0-or-later
// Textures over linear memory, for cuda_runtime.h. Unlike a device's they report wrong accesses. A
// device reads zeros outside of them, and any value after they were destroyed.
#pragma once

#include <stdexcept>
#include <vector>

using cudaTextureObject_t = unsigned long long;
enum cudaChannelFormatKind { cudaChannelFormatKindSigned, cudaChannelFormatKindFloat };
// Bits of each component.
struct cudaChannelFormatDesc {
  int x, y, z, w;
  cudaChannelFormatKind f;
  friend bool operator==(const cudaChannelFormatDesc&, const cudaChannelFormatDesc&) = default;
};
enum cudaResourceType { cudaResourceTypeArray, cudaResourceTypeLinear };
struct cudaResourceDesc {
  cudaResourceType resType;
  struct {
    struct {
      void* devPtr;
      cudaChannelFormatDesc desc;
      std::size_t sizeInBytes;
    } linear;
  } res;
};
enum cudaTextureReadMode { cudaReadModeElementType, cudaReadModeNormalizedFloat };
struct cudaTextureDesc {
  cudaTextureReadMode readMode;
};
struct cudaResourceViewDesc;

template <class T>
constexpr cudaChannelFormatDesc cudaCreateChannelDesc() {
  if constexpr (std::is_same_v<T, int4>) {
    return {32, 32, 32, 32, cudaChannelFormatKindSigned};
  } else {
    static_assert(std::is_same_v<T, float>);
    return {32, 0, 0, 0, cudaChannelFormatKindFloat};
  }
}

cudaError_t cudaCreateTextureObject(cudaTextureObject_t* object, const cudaResourceDesc* resource,
                                    const cudaTextureDesc* texture, const cudaResourceViewDesc*);
cudaError_t cudaDestroyTextureObject(cudaTextureObject_t object);

namespace emulated {

struct Texture {
  const void* data;
  std::size_t count;
  cudaChannelFormatDesc element;
};
extern std::vector<Texture> textures;

}  // namespace emulated

template <class T>
T tex1Dfetch(cudaTextureObject_t object, int at) {
  const emulated::Texture& t = emulated::textures.at(object);
  if (at < 0 || static_cast<std::size_t>(at) >= t.count)
    throw std::logic_error("a texture is read out of its bounds, or after it was destroyed");
  if (t.element != cudaCreateChannelDesc<T>())
    throw std::logic_error("a texture is read as what it does not hold");
  T element;
  std::memcpy(&element, static_cast<const T*>(t.data) + at, sizeof element);
  return element;
}
