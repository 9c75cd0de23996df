// SPDX-License-Identifier: BSD-3-Clause
// Photometric files in the folder of test data, and such as tests write.
#pragma once

#include "PhotonTransport/photometry/PhotometricFile.h"

#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

inline std::string DataFile(const std::string& name)
{
  return std::string(ILLUMINATION_TEST_DATA) + "/photometry/" + name;
}

inline std::vector<double> Steps(double first, double last, double step)
{
  std::vector<double> steps;
  for (int i = 0; first + i * step <= last; ++i)
  {
    steps.push_back(first + i * step);
  }
  return steps;
}

/// Writes all digits.
inline std::ostringstream NumberStream()
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  return text;
}

/// @param type 1 C, 2 B, 3 A. @param intensity Of (vertical, horizontal).
template <typename Function>
std::string IesText(int type, const std::vector<double>& vertical,
  const std::vector<double>& horizontal, Function intensity)
{
  std::ostringstream text = NumberStream();
  text << "IESNA:LM-63-2002\n[TEST] none\nTILT=NONE\n1 -1 1 " << vertical.size() << ' '
       << horizontal.size() << ' ' << type << " 2 0 0 0\n1 1 0\n";
  for (const auto* angles : { &vertical, &horizontal })
  {
    for (const double angle : *angles)
    {
      text << angle << '\n';
    }
  }
  for (const double h : horizontal)
  {
    for (const double v : vertical)
    {
      text << intensity(v, h) << ' ';
    }
    text << '\n';
  }
  return text.str();
}

/// All planes of the circle are given; those that the symmetry leaves out are not written.
template <typename Function>
std::string EulumdatText(int symmetry, const std::vector<double>& planes,
  const std::vector<double>& angles, Function intensity)
{
  std::ostringstream text = NumberStream();
  text << "maker\n1\n" << symmetry << '\n' << planes.size() << "\n0\n" << angles.size() << "\n0\n";
  text << "report\nname\nnumber\nfile\ndate\n0\n0\n0\n0\n0\n0\n0\n0\n0\n100\n100\n1\n0\n";
  text << "1\n1\nlamp\n1000\n3000\n80\n10\n"
       << "0\n0\n0\n0\n0\n0\n0\n0\n0\n0\n";
  for (const auto* list : { &planes, &angles })
  {
    for (const double angle : *list)
    {
      text << angle << '\n';
    }
  }
  const auto write = [&](double first, double last)
  {
    for (const double plane : planes)
    {
      for (const double angle : angles)
      {
        if (plane >= first && plane <= last)
        {
          text << intensity(angle, plane) << '\n';
        }
      }
    }
  };
  // EULUMDAT: Mc1 = 3 Mc / 4 + 1, Mc2 = Mc1 + Mc / 2 for symmetry 3.
  if (symmetry == 3)
  {
    write(270.0, 360.0);
  }
  write(0.0, symmetry == 0 ? 360.0 : symmetry == 2 ? 180.0 : 90.0);
  return text.str();
}

inline PhotonTransport::PhotometricSolid ReadIesText(const std::string& text)
{
  std::istringstream file(text);
  return PhotonTransport::ReadIes(file, DataFile(""));
}

inline PhotonTransport::PhotometricSolid ReadEulumdatText(const std::string& text)
{
  std::istringstream file(text);
  return PhotonTransport::ReadEulumdat(file);
}
