// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <string>

class vtkAlgorithm;

/// Counts what VTK would print, whoever says it: filter, executive or a filter inside.
class MessageCounter : public vtkOutputWindow
{
public:
  static MessageCounter* New();
  vtkTypeMacro(MessageCounter, vtkOutputWindow);

  void DisplayErrorText(const char* text) override;
  void DisplayWarningText(const char* text) override;
  void DisplayGenericWarningText(const char* text) override;
  void DisplayText(const char*) override {}
  void Clear();

  int Errors = 0;
  int Warnings = 0;
  std::string Text;
};

/// Catches all that VTK says during its life, in place of the window that was there before.
class CaughtMessages
{
public:
  CaughtMessages();
  ~CaughtMessages();
  CaughtMessages(const CaughtMessages&) = delete;
  CaughtMessages& operator=(const CaughtMessages&) = delete;

  MessageCounter* operator->() const { return this->Counter; }

private:
  vtkSmartPointer<vtkOutputWindow> Before;
  vtkNew<MessageCounter> Counter;
};

/// The one error that an update gives; empty if it gives none.
std::string ErrorOf(vtkAlgorithm* algorithm);

/// Whether a text holds these words; a failed EXPECT_TRUE shows both.
::testing::AssertionResult Holds(const std::string& text, const std::string& words);
