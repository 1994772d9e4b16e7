// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "caption.hpp"

#include <array>
#include <cmath>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include "planescope/error.hpp"

namespace planescope::draw {

Image draw_text(const std::string& text, double points, double dpi, const Pixel& ink,
                const Pixel& ground) {
  vtkNew<vtkTextProperty> style;
  style->SetFontFamilyToArial();
  style->SetFontSize(std::max(1, static_cast<int>(std::lround(points * dpi / 72))));
  style->SetColor(1, 1, 1);
  vtkNew<vtkImageData> data;
  std::array<int, 2> size{};
  constexpr int kPixelsAreFontUnits = 72;  // at this dpi a point is a pixel
  vtkTextRenderer* engine = vtkTextRenderer::GetInstance();
  if (engine == nullptr ||
      !engine->RenderString(style, vtkStdString(text), data, size.data(), kPixelsAreFontUnits))
    throw Error(Error::Kind::Rendering, "the caption `" + text + "` cannot be drawn");
  const int* extent = data->GetExtent();  // the picture may be larger than the words in it
  Image image = filled(size[0], size[1], ground);
  for (int y = 0; y < size[1]; ++y) {
    for (int x = 0; x < size[0]; ++x) {
      const auto* rgba = static_cast<const unsigned char*>(
          data->GetScalarPointer(extent[0] + x, extent[2] + size[1] - 1 - y, 0));
      const double cover = rgba[3] / 255.0;
      for (std::size_t c = 0; c < 3; ++c) {
        auto& out = image.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size[0]) +
                                   static_cast<std::size_t>(x)) +
                              c];
        out = static_cast<std::uint8_t>(std::lround(out + cover * (ink[c] - out)));
      }
    }
  }
  return image;
}

}  // namespace planescope::draw
