// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/Surface.h"

#include <string>

/// Triangles, point normals and the cell arrays Reflectance and Exitance (where there) of a .vtp
/// file. Throws std::runtime_error where it can't be read, or in a build without VTK.
PhotonTransport::Surface ReadMesh(const std::string& fileName);

/// A file of cabin_mesh.py, which says what is in it. Throws std::runtime_error if it can't be
/// read.
PhotonTransport::Surface ReadPlainMesh(const std::string& fileName);
