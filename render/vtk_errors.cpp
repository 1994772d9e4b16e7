// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_errors.hpp"

#include <algorithm>
#include <mutex>

#include <vtkCommand.h>
#include <vtkObjectFactory.h>

namespace planescope::draw {
namespace {

/// An error of VTK on one line; never empty.
std::string one_line(const char* text) {
  std::string line = text != nullptr ? text : "";
  std::replace(line.begin(), line.end(), '\n', ' ');
  line.erase(line.find_last_not_of(' ') + 1);
  return line.empty() ? "unnamed error of VTK" : line;
}

/// Keeps the first error, and says nothing.
class Keeper final : public vtkOutputWindow {
 public:
  static Keeper* New();
  vtkTypeMacro(Keeper, vtkOutputWindow)

      void DisplayText(const char* /*text*/) override {}
  void DisplayErrorText(const char* text) override {
    const std::lock_guard lock(mutex_);
    if (first.empty()) first = one_line(text);
  }
  void DisplayWarningText(const char* /*text*/) override {}
  void DisplayGenericWarningText(const char* /*text*/) override {}
  void DisplayDebugText(const char* /*text*/) override {}

  std::string first;

 private:
  std::mutex mutex_;  // filters report from their own threads
};

vtkStandardNewMacro(Keeper);

}  // namespace

VtkSilence::VtkSilence()
    : ours_(vtkSmartPointer<Keeper>::New()),
      before_(vtkOutputWindow::GetInstance()),
      verbosity_(vtkLogger::GetCurrentVerbosityCutoff()) {
  vtkOutputWindow::SetInstance(ours_);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

VtkSilence::~VtkSilence() {
  vtkOutputWindow::SetInstance(before_);
  vtkLogger::SetStderrVerbosity(verbosity_);
}

const std::string& VtkSilence::first() const noexcept {
  return static_cast<const Keeper*>(ours_.Get())->first;
}

VtkErrors::VtkErrors(vtkObject* object) : object_(object) {
  error_ = object_->AddObserver(vtkCommand::ErrorEvent, this, &VtkErrors::listen);
  warning_ = object_->AddObserver(vtkCommand::WarningEvent, this, &VtkErrors::listen);
}

VtkErrors::~VtkErrors() {
  object_->RemoveObserver(error_);
  object_->RemoveObserver(warning_);
}

void VtkErrors::listen(vtkObject* /*caller*/, unsigned long event, void* text) {
  if (event != vtkCommand::ErrorEvent || any()) return;
  first_ = one_line(static_cast<const char*>(text));
}

}  // namespace planescope::draw
