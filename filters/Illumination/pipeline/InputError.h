// SPDX-License-Identifier: BSD-3-Clause
#ifndef InputError_h
#define InputError_h

#include <stdexcept>

namespace Illumination
{

/// Thrown for input that can't be used; what() is the whole message for the user.
class InputError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace Illumination

#endif
