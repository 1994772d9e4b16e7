// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>

#include <vtkDepthImageProcessingPass.h>
#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkTextureObject.h>

class vtkOpenGLQuadHelper;
class vtkOpenGLState;

/// \file Eye-dome lighting: points without normals get their shape from the depth buffer.
namespace planescope::draw {

/// A render pass that draws its delegate, closes pin-holes between splats, and darkens pixels that
/// lie behind their surroundings, in the manner of eye-dome lighting (Boucheny 2009). Unlike
/// vtkEDLShading it takes neighbours in opposite pairs and compares inverse depths, which are
/// linear over a plane in perspective: a plane is not darkened however it is slanted, so walls
/// keep their colour; and it works on depth relative to the camera's distance, so that a table and
/// a hall are shaded alike. Depth is passed on, so that what is drawn later is hidden rightly.
class DepthShading final : public vtkDepthImageProcessingPass {
 public:
  static DepthShading* New();
  vtkTypeMacro(DepthShading, vtkDepthImageProcessingPass)

      void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /// [pixel of the picture that is drawn] Width of contours, and reach of the shadow in creases.
  void SetRadii(int contour, int crease) {
    radii_[0] = contour;
    radii_[1] = crease;
  }
  /// [pixel] What may hold points: only this and their contours around it are shaded.
  /// \param region left, bottom, right (beyond), top (beyond); may reach over the picture's edges.
  void SetRegion(const std::array<int, 4>& region) { region_ = region; }
  /// [1/m] Noise of the points relative to depth, for each metre of depth: not shaded.
  void SetNoise(double noise) { noise_ = noise; }

 protected:
  DepthShading();
  ~DepthShading() override;

 private:
  void prepare(vtkOpenGLRenderWindow* window, bool parallel);
  void shade(vtkRenderer* renderer, vtkOpenGLRenderWindow* window);
  void fill_around(vtkRenderer* renderer, vtkOpenGLState& gl) const;

  int radii_[2] = {2, 6};
  std::array<int, 4> region_ = {0, 0, 1 << 20, 1 << 20};
  double noise_ = 0;
  vtkNew<vtkTextureObject> color_, depth_;
  vtkNew<vtkOpenGLFramebufferObject> buffer_;
  std::unique_ptr<vtkOpenGLQuadHelper> quad_;
  bool quad_is_parallel_ = false;
};

}  // namespace planescope::draw
