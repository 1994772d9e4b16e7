// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "depth_shading.hpp"

#include <GL/gl.h>

#include <algorithm>
#include <string>

#include <vtkCamera.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLQuadHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>

namespace planescope::draw {
namespace {

/// With near plane n and far plane f the depth buffer holds d = a - b / z with a = f / (f - n) and
/// b = n a: so a - d is proportional to the inverse depth 1 / z.
const char* const kFragmentShader = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec2 texCoord;
uniform sampler2D colors;
uniform sampler2D depths;
uniform ivec2 last;     // pixel of the textures
uniform ivec2 radii;    // [pixel] of the inner ring, which draws contours, and of the outer one
uniform float a, b;
uniform vec2 range;     // [m] near and far plane
uniform float noise;    // [1/m] of the depth, for each metre of it

const float kTolerance = 0.0012;  // of the depth: roughness that is always there
const float kMost = 0.016;        // of the depth: more is a contour, and a contour is not black
const float kMostOuter = 0.004;   // the same of the outer ring: a soft shadow in creases
const float kStrength = 75.0;
const float kHole = 0.012;        // of the depth: this much behind, and surrounded, is a pin-hole

const ivec2 kRing[8] = ivec2[8](ivec2(2, 0), ivec2(-2, 0), ivec2(0, 2), ivec2(0, -2),
                                ivec2(1, 1), ivec2(-1, -1), ivec2(1, -1), ivec2(-1, 1));

ivec2 place(ivec2 at, int radius, int i)
{
  // Diagonal neighbours lie at 0.7 of the radius along both axes.
  ivec2 offset = i < 4 ? kRing[i] * radius / 2 : kRing[i] * ((radius * 7 + 5) / 10);
  return clamp(at + offset, ivec2(0), last);
}

// In units of 1 / b, whatever the projection. Most of this shader's time goes into fetches, and a
// software renderer takes all of them in a branch that some pixel of a group takes.
float inverseDepth(ivec2 at)
{
  float d = texelFetch(depths, at, 0).r;
#ifdef PARALLEL
  return b / mix(range.x, range.y, d);
#else
  return a - d;
#endif
}

void main()
{
  ivec2 at = ivec2(texCoord * vec2(last + 1));
  float depth = texelFetch(depths, at, 0).r;
  float here = inverseDepth(at);
  float ring[8];
  int nearer = 0;
  float sum = 0.0, nearest = here;
  ivec2 cover = at;
  for (int i = 0; i < 8; ++i)
  {
    ivec2 beside = place(at, radii.x, i);
    ring[i] = inverseDepth(beside);
    bool before = ring[i] > here * (1.0 + kHole);
    nearer += before ? 1 : 0;
    sum += before ? ring[i] : 0.0;
    cover = ring[i] > nearest ? beside : cover;
    nearest = max(nearest, ring[i]);
  }
  bool hole = nearer >= 7;
  here = hole ? sum / float(nearer) : here;
  vec3 color = texelFetch(colors, hole ? cover : at, 0).rgb;
  float tolerance = max(kTolerance, noise * b / here);
  float shade = 0.0;
  for (int i = 0; i < 8; i += 2)
    shade += clamp((ring[i] + ring[i + 1]) / (2.0 * here) - 1.0 - tolerance, 0.0, kMost);
  if (depth < 1.0)  // the background has contours, and no creases
  {
    for (int i = 0; i < 8; i += 2)
    {
      float pair = inverseDepth(place(at, radii.y, i)) + inverseDepth(place(at, radii.y, i + 1));
      shade += clamp(pair / (2.0 * here) - 1.0 - tolerance, 0.0, kMostOuter);
    }
  }
  gl_FragData[0] = vec4(color * exp(-kStrength * shade / 5.0), 1.0);
#ifdef PARALLEL
  gl_FragDepth = (b / here - range.x) / (range.y - range.x);
#else
  gl_FragDepth = a - here;
#endif
}
)";

/// For a parallel projection, where d = (z - n) / (f - n), or for a perspective.
std::string fragment_shader(bool parallel) {
  const std::string after = "//VTK::Output::Dec\n";
  std::string shader = kFragmentShader;
  if (parallel) shader.insert(shader.find(after) + after.size(), "#define PARALLEL\n");
  return shader;
}

}  // namespace

vtkStandardNewMacro(DepthShading);

DepthShading::DepthShading() = default;
DepthShading::~DepthShading() = default;

void DepthShading::prepare(vtkOpenGLRenderWindow* window, bool parallel) {
  color_->SetContext(window);
  depth_->SetContext(window);
  buffer_->SetContext(window);
  const auto width = static_cast<unsigned>(W), height = static_cast<unsigned>(H);
  if (color_->GetWidth() != width || color_->GetHeight() != height) {
    color_->Create2D(width, height, 4, VTK_UNSIGNED_CHAR, false);
    depth_->AllocateDepth(width, height, vtkTextureObject::Float32);
  }
  if (quad_ && parallel == quad_is_parallel_) return;
  quad_ = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, fragment_shader(parallel).c_str(),
                                                nullptr);
  quad_is_parallel_ = parallel;
}

void DepthShading::Render(const vtkRenderState* state) {
  vtkRenderer* renderer = state->GetRenderer();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  ReadWindowSize(state);
  ExtraPixels = 0;
  W = Width;
  H = Height;
  prepare(window, renderer->GetActiveCamera()->GetParallelProjection() != 0);
  window->GetState()->PushFramebufferBindings();
  RenderDelegate(state, Width, Height, W, H, buffer_, color_, depth_);
  window->GetState()->PopFramebufferBindings();
  shade(renderer, window);
}

void DepthShading::shade(vtkRenderer* renderer, vtkOpenGLRenderWindow* window) {
  window->GetShaderCache()->ReadyShaderProgram(quad_->Program);
  color_->Activate();
  depth_->Activate();
  vtkShaderProgram& program = *quad_->Program;
  program.SetUniformi("colors", color_->GetTextureUnit());
  program.SetUniformi("depths", depth_->GetTextureUnit());
  const int last[2] = {W - 1, H - 1};
  program.SetUniform2i("last", last);
  program.SetUniform2i("radii", radii_);
  const double* range = renderer->GetActiveCamera()->GetClippingRange();
  const double a = range[1] / (range[1] - range[0]);
  program.SetUniformf("a", static_cast<float>(a));
  program.SetUniformf("b", static_cast<float>(a * range[0]));
  const float near_and_far[2] = {static_cast<float>(range[0]), static_cast<float>(range[1])};
  program.SetUniform2f("range", near_and_far);
  program.SetUniformf("noise", static_cast<float>(noise_));

  vtkOpenGLState& gl = *window->GetState();
  gl.vtkglDisable(GL_BLEND);
  fill_around(renderer, gl);
  gl.vtkglEnable(GL_DEPTH_TEST);
  gl.vtkglDepthMask(GL_TRUE);
  gl.vtkglDepthFunc(GL_ALWAYS);
  gl.vtkglViewport(Origin[0], Origin[1], W, H);
  quad_->Render();
  gl.vtkglDisable(GL_SCISSOR_TEST);
  gl.vtkglDepthFunc(GL_LEQUAL);
  gl.vtkglEnable(GL_BLEND);
  depth_->Deactivate();
  color_->Deactivate();
}

/// Background everywhere, and from now on drawing in the region only.
void DepthShading::fill_around(vtkRenderer* renderer, vtkOpenGLState& gl) const {
  const int margin = radii_[1] + 1;
  const auto within = [&](int at, int size, int origin) {
    return origin + std::clamp(at, 0, size);
  };
  const int left = within(region_[0] - margin, W, Origin[0]),
            bottom = within(region_[1] - margin, H, Origin[1]);
  const int width = within(region_[2] + margin, W, Origin[0]) - left,
            height = within(region_[3] + margin, H, Origin[1]) - bottom;
  const double* ground = renderer->GetBackground();
  gl.vtkglDisable(GL_SCISSOR_TEST);
  gl.vtkglDepthMask(GL_TRUE);
  gl.vtkglClearColor(static_cast<float>(ground[0]), static_cast<float>(ground[1]),
                     static_cast<float>(ground[2]), 1.0F);
  gl.vtkglClearDepth(1.0);
  gl.vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.vtkglEnable(GL_SCISSOR_TEST);
  gl.vtkglScissor(left, bottom, width, height);
}

void DepthShading::ReleaseGraphicsResources(vtkWindow* window) {
  quad_.reset();
  color_->ReleaseGraphicsResources(window);
  depth_->ReleaseGraphicsResources(window);
  buffer_->ReleaseGraphicsResources(window);
  Superclass::ReleaseGraphicsResources(window);
}

}  // namespace planescope::draw
