// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

#include "vtkAlgorithm.h"
#include "vtkLogger.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(MessageCounter);

void MessageCounter::DisplayErrorText(const char* text)
{
  ++this->Errors;
  this->Text += text;
}

void MessageCounter::DisplayWarningText(const char* text)
{
  ++this->Warnings;
  this->Text += text;
}

void MessageCounter::DisplayGenericWarningText(const char* text)
{
  this->DisplayWarningText(text);
}

void MessageCounter::Clear()
{
  this->Errors = 0;
  this->Warnings = 0;
  this->Text.clear();
}

CaughtMessages::CaughtMessages()
  : Before(vtkOutputWindow::GetInstance())
{
  vtkOutputWindow::SetInstance(this->Counter);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // what is expected is not worth a line
}

CaughtMessages::~CaughtMessages()
{
  vtkOutputWindow::SetInstance(this->Before);
}

std::string ErrorOf(vtkAlgorithm* algorithm)
{
  const CaughtMessages messages;
  algorithm->Update();
  EXPECT_LE(messages->Errors, 1) << messages->Text;
  return messages->Errors > 0 ? messages->Text : "";
}

::testing::AssertionResult Holds(const std::string& text, const std::string& words)
{
  const bool holds = text.find(words) != std::string::npos;
  return ::testing::AssertionResult(holds) << "'" << words << "' in '" << text << "'";
}
