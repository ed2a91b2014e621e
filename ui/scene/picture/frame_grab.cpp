// SPDX-License-Identifier: GPL-3.0-or-later
// Reads framebuffers, and writes PNG files through VTK's writer.
#include "ui/scene/picture/frame_grab.hpp"

#include <GL/gl.h>
#include <GL/glext.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include "core/files/atomic_file.hpp"
#include "core/files/png_text.hpp"

namespace alphascope {

Image read_framebuffer(unsigned framebuffer, int width, int height) {
  Image image{width, height, std::vector<std::uint8_t>(std::size_t(width) * height * 4)};
  GLint previous = 0;
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &previous);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  glReadBuffer(framebuffer == 0 ? GL_BACK : GL_COLOR_ATTACHMENT0);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(previous));
  const std::size_t row = std::size_t(width) * 4;
  for (int y = 0; y < height / 2; ++y) {
    std::swap_ranges(image.rgba.begin() + y * row, image.rgba.begin() + (y + 1) * row,
                     image.rgba.begin() + (height - 1 - y) * row);
  }
  return image;
}

void divide_by_alpha(Image& image) {
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const unsigned alpha = image.rgba[i + 3];
    for (std::size_t c = i; c < i + 3; ++c) {
      const unsigned divided = alpha == 0 ? 0 : (255u * image.rgba[c] + alpha / 2) / alpha;
      image.rgba[c] = static_cast<std::uint8_t>(std::min(255u, divided));
    }
  }
}

std::string png_bytes(const Image& image, const PictureTexts& texts, int dpi) {
  if (image.width <= 0 || image.height <= 0) throw std::invalid_argument("empty image");
  bool opaque = true;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) opaque = opaque && image.rgba[i] == 255;
  const int channels = opaque ? 3 : 4;
  vtkNew<vtkImageData> data;
  data->SetDimensions(image.width, image.height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, channels);
  auto* target = static_cast<unsigned char*>(data->GetScalarPointer());
  for (int y = image.height - 1; y >= 0; --y) {  // VTK's first row is the bottom
    const std::uint8_t* source = &image.rgba[std::size_t(y) * image.width * 4];
    for (int x = 0; x < image.width; ++x, source += 4, target += channels) {
      std::memcpy(target, source, static_cast<std::size_t>(channels));
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(data);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  if (bytes == nullptr) throw std::runtime_error("the picture could not be made into a PNG file");
  const std::string_view png(reinterpret_cast<const char*>(bytes->GetPointer(0)),
                             static_cast<std::size_t>(bytes->GetNumberOfValues()));
  return with_png_text(dpi > 0 ? with_png_resolution(png, dpi) : std::string(png), texts);
}

void write_png(const Image& image, const std::filesystem::path& path, const PictureTexts& texts,
               const CancelToken& cancel, int dpi) {
  const std::string png = png_bytes(image, texts, dpi);
  cancel.throw_if_cancelled();
  AtomicFile file(path);
  file.write(png);
  cancel.throw_if_cancelled();
  file.commit();
}

}  // namespace alphascope
