// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_errors.hpp"

#include <algorithm>

#include <vtkCommand.h>

namespace planescope::draw {

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
  first_ = text != nullptr ? static_cast<const char*>(text) : "";
  std::replace(first_.begin(), first_.end(), '\n', ' ');
  if (first_.empty()) first_ = "unnamed error of VTK";
}

}  // namespace planescope::draw
