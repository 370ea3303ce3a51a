// SPDX-License-Identifier: Apache-2.0
#include "bind.h"
namespace avo_python { void bind_reports(py::module_&) {} }
